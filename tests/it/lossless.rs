//! Every byte of a file stands in exactly one leaf of its tree or between two leaves.

use crate::tree_check::check;
use proptest::prelude::*;
use rapid_syntax::parse;
use rapid_syntax::walk::nodes;

const LANGUAGE: &[u8] = include_bytes!("../../fixtures/rapid/language.mod");

#[test]
fn the_whole_language_is_read_without_a_warning() {
    let (tree, warnings) = parse(LANGUAGE);
    assert_eq!(warnings, []);
    assert!(nodes(&tree).iter().all(|n| n.what != "opaque"));
    check(LANGUAGE).unwrap();
}

#[test]
fn line_ends_and_encodings_change_nothing_but_places() {
    let kinds = |source: &[u8]| {
        check(source).unwrap();
        let (tree, warnings) = parse(source);
        assert_eq!(warnings, [], "{}", String::from_utf8_lossy(source));
        nodes(&tree).iter().map(|n| (n.what, n.depth, n.range.of(source).len())).collect::<Vec<_>>()
    };
    let shape =
        |source: &[u8]| kinds(source).into_iter().map(|(what, depth, _)| (what, depth)).collect::<Vec<_>>();
    let text = LANGUAGE;
    let replaced = |from: &[u8], to: &[u8]| {
        let mut out = Vec::new();
        let mut rest = text;
        while let Some(n) = rest.windows(from.len()).position(|w| w == from) {
            out.extend_from_slice(&rest[..n]);
            out.extend_from_slice(to);
            rest = &rest[n + from.len()..];
        }
        out.extend_from_slice(rest);
        out
    };
    let plain = shape(text);
    for ends in [&b"\r\n"[..], b"\r", b"\r\r\n"] {
        assert_eq!(shape(&replaced(b"\n", ends)), plain, "line ends {ends:?}");
    }
    assert_eq!(shape(&[b"\xEF\xBB\xBF", text].concat()), plain, "a mark of byte order");
    assert_eq!(shape(&replaced(b"component", b"\xB2\xE2\x5C\xB6\x7C")), plain, "GBK in comments");
    assert_eq!(shape(&replaced(b"quoted", b"\x81\x5C\xA0\xFC")), plain, "GBK in a string");
    assert_eq!(kinds(&replaced(b"Second", b"Zw\xF6lf\xDF")), kinds(text), "Latin-1 names");
    assert_eq!(shape(&replaced(b"Second", "Zwölf".as_bytes())), plain, "UTF-8 names");
    assert_eq!(shape(text.trim_ascii_end()), plain, "no line end at the end");
}

#[test]
fn cut_anywhere_the_language_stays_lossless() {
    for cut in 0..LANGUAGE.len() {
        check(&LANGUAGE[..cut]).unwrap_or_else(|e| panic!("cut at {cut}: {e}"));
    }
}

fn token() -> impl Strategy<Value = &'static [u8]> {
    prop::sample::select(vec![
        &b"MODULE "[..],
        b"ENDMODULE\n",
        b"PROC ",
        b"ENDPROC\n",
        b"FUNC num ",
        b"ENDFUNC ",
        b"TRAP ",
        b"ENDTRAP\n",
        b"IF ",
        b" THEN\n",
        b"ELSE\n",
        b"ELSEIF ",
        b"ENDIF\n",
        b"FOR i FROM ",
        b" TO ",
        b" DO\n",
        b"ENDFOR\n",
        b"WHILE ",
        b"ENDWHILE ",
        b"TEST ",
        b"CASE ",
        b"DEFAULT:",
        b"ENDTEST\n",
        b"VAR num ",
        b"LOCAL ",
        b"TASK ",
        b"PERS ",
        b"RECORD ",
        b"ENDRECORD\n",
        b"ALIAS ",
        b"ERROR\n",
        b"UNDO\n",
        b"RETURN ",
        b"GOTO ",
        b"CONNECT ",
        b" WITH ",
        b"RAISE ",
        b"EXIT",
        b"RETRY",
        b"NOT ",
        b" AND ",
        b" DIV ",
        b"TRUE",
        b"MoveL ",
        b"p10",
        b"a",
        b"Prog1()\n",
        b"9E9",
        b"1.",
        b"0x1F",
        b"\"s\"",
        b"\"",
        b"_",
        b"%",
        b"%%%",
        b"<SMT>",
        b"<",
        b">",
        b"=",
        b":=",
        b":",
        b";",
        b";\n",
        b",",
        b",\\",
        b"?",
        b"|",
        b"(",
        b")",
        b"[",
        b"]",
        b"{",
        b"}",
        b"*",
        b"+",
        b"-",
        b".",
        b"!c\n",
        b"!",
        b"\n",
        b"\r\n",
        b"\r",
        b" ",
        b"\t",
        b"\xA0",
        b"\xE9",
        b"\x00",
        b"\xC3\xA9",
    ])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes_come_back(source in prop::collection::vec(any::<u8>(), 0..600)) {
        check(&source).map_err(TestCaseError::fail)?;
    }

    #[test]
    fn any_words_come_back(head in 0..3usize, words in prop::collection::vec(token(), 0..80)) {
        let heads = [&b""[..], b"MODULE m\n", b"MODULE m\nPROC p()\n"];
        check(&[heads[head], &words.concat()].concat()).map_err(TestCaseError::fail)?;
    }
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn one_byte_changed_anywhere_the_language_stays_lossless() {
        for at in 0..LANGUAGE.len() {
            for byte in *b"\";\n(]!%x\xFF" {
                let mut source = LANGUAGE.to_vec();
                source[at] = byte;
                check(&source).unwrap_or_else(|e| panic!("{byte:#x} at {at}: {e}"));
            }
        }
    }
}
