//! Input that means harm: read in linear time on a small stack, every byte kept.

use rapid_syntax::{parse, walk};
use std::time::{Duration, Instant};

/// Parses `unit` repeated to so many bytes, after each of several beginnings, on a stack of 2 MB.
fn survives(unit: &str, bytes: usize) {
    let beginnings =
        ["", "MODULE m\n", "MODULE m\nPROC p()\n", "MODULE m\nPROC p()\nx:=", "MODULE m\nPROC p()\nMoveL "];
    for beginning in beginnings {
        let mut source = beginning.as_bytes().to_vec();
        let times = bytes / unit.len();
        source.extend(unit.bytes().cycle().take(times * unit.len()));
        on_small_stack(format!("{beginning:?} and {unit:?} on and on"), source);
    }
}

/// What this thread has computed, where the system says it: on a machine with other work a thread waits.
fn processor_time() -> Option<Duration> {
    let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    text.split_whitespace().next()?.parse().ok().map(Duration::from_nanos)
}

fn on_small_stack(what: String, source: Vec<u8>) {
    let run = move || {
        let (start, computed) = (Instant::now(), processor_time());
        let (tree, warnings) = parse(&source);
        let took = match computed.zip(processor_time()) {
            Some((before, after)) => after - before,
            None => start.elapsed(),
        };
        let mut at = 0;
        for leaf in walk::leaves(&tree) {
            assert!(leaf.range.start >= at && leaf.range.end as usize <= source.len(), "{what}: {leaf:?}");
            at = leaf.range.end;
        }
        assert!(warnings.len() <= 1001, "{what}: {} warnings", warnings.len());
        assert!(took < Duration::from_secs(5), "{what} took {took:?}");
    };
    std::thread::Builder::new().stack_size(2 << 20).spawn(run).unwrap().join().unwrap();
}

macro_rules! survive {
    ($($name:ident $bytes:literal: $($unit:literal),+;)+) => {
        $(#[test]
        fn $name() {
            $(survives($unit, $bytes / 10);)+
        })+

        /// The same at ten times the size, which takes seconds: `cargo test --test it -- --ignored long::`.
        mod long {
            $(#[test]
            #[ignore = "long"]
            fn $name() {
                $(super::survives($unit, $bytes);)+
            })+
        }
    };
}

survive! {
    open_parentheses 10_000_000: "(";
    open_square_brackets 10_000_000: "[";
    open_blocks 10_000_000: "IF x THEN\n";
    backslashes_and_quotes 10_000_000: "\\\"";
    minus_signs 10_000_000: "-";
    open_modules 10_000_000: "MODULE a\n";
    header_marks 10_000_000: "%%%";
    brackets 1_000_000: "{", "[[1,2],", "f(", "f(\n", "a{", ")", "]]];", "};\n";
    blocks 1_000_000: "FOR i FROM 1 TO 2 DO\n", "WHILE a DO ", "TEST a\nCASE 1:\n", "IF a ", "IF (;";
    block_middles 1_000_000: "ELSE\n", "ELSEIF a THEN\n", "CASE 1:\n", "ENDIF\n", "IF x THEN\nELSE\n";
    quotes 1_000_000: "\"", "\"\n", "\"\"", "%\"a\"";
    operators 1_000_000: "- ", "NOT ", "a+", "a+\n", "a.", "+(", "-[", "a.b{1}";
    options 1_000_000: "\\", "\\a", "\\a:=", "a\\b,\n", "a,\n";
    heads 1_000_000: "MODULE a(", "PROC p()\n", "PROC ", "RECORD a\n", "ENDMODULE\n", "RECORD a b c;\n";
    statements 1_000_000: "a\n", "a b\n", "a;", "a:\n", "x:=\n", "x:=f(1,\n", "GOTO\n", "RETURN\n", "VAR a b(\n";
    calls 1_000_000: "f(_,\n", "f(_(", "%", "%%%\n";
    blanks 1_000_000: "!", "!\n", "a !b\n", " ", "\n", "\r";
    handlers 1_000_000: "ERROR\n", "UNDO ", "ERROR(";
}

#[test]
fn random_bytes() {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut next = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    let bytes: Vec<u8> = (0..10_000_000).map(|_| (next() >> 32) as u8).collect();
    let mut inside = b"MODULE m\nPROC p()\n".to_vec();
    inside.extend_from_slice(&bytes);
    on_small_stack("random bytes".to_owned(), bytes);
    on_small_stack("random bytes in a routine".to_owned(), inside);
}

#[test]
fn random_marks() {
    let marks = b"()[]{}\\:=,;\"!%<>-+ab1. \n|?_";
    let mut state = 1_u64;
    let mut next = move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize
    };
    let mut source = b"MODULE m\nPROC p()\n".to_vec();
    source.extend((0..10_000_000).map(|_| marks[next() % marks.len()]));
    on_small_stack("random marks".to_owned(), source);
}
