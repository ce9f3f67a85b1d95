//! The scan is held to the productions of the grammar, over the fixtures, mutated ones, and lines of pieces.

use super::*;
use crate::input::ParseState;
use crate::test_programs::{Chance, programs};
use crate::{parse, parse_by_productions};

#[track_caller]
fn agrees(text: &[u8]) {
    let (scanned, read) = (parse(text), parse_by_productions(text));
    if scanned != read {
        panic!("{}\n{scanned:#?}\n{read:#?}", String::from_utf8_lossy(text));
    }
}

/// What lines are made of, and what makes them unusual.
const PIECES: [&[u8]; 52] = [
    b",",
    b";",
    b":",
    b"=",
    b":=",
    b"\\",
    b"\\On",
    b"\\WObj:=",
    b"?",
    b"(",
    b")",
    b"[",
    b"]",
    b"{1}",
    b".x",
    b"%",
    b"<ARG>",
    b" ",
    b"\n",
    b"\r\n",
    b"\t",
    b"\xA0",
    b"! c\n",
    b"!",
    b"\"",
    b"\"a;\"",
    b"0x1F",
    b"1.5e-3",
    b"1.",
    b".5",
    b"-",
    b"+",
    b"*",
    b"TASK ",
    b"LOCAL ",
    b"CONST ",
    b"num ",
    b"TRUE",
    b"Not ",
    b" MOD ",
    b"IF a ",
    b"ENDPROC\n",
    b"tool0",
    b"a:",
    b"\xE9",
    b"_",
    b"[9E9,9E9,9E9,9E9,9E9,9E9]",
    b"[1,[2,-3]]",
    b"Offs(p1,0,0,-50)",
    b"f(",
    b"a.b",
    b".trans.x",
];

#[test]
fn what_is_scanned_is_what_the_productions_read_in_every_fixture_and_in_mutated_ones() {
    let mut chance = Chance::new();
    for mut text in programs() {
        agrees(&text);
        text.truncate(6000);
        for _ in 0..if text.is_empty() { 0 } else { 60 } {
            let mut text = text.clone();
            for _ in 0..8 {
                let at = chance.below(text.len());
                let piece = PIECES[chance.below(PIECES.len())].iter().copied();
                let gone = [0, 0, 1, 1, 2, 5][chance.below(6)].min(text.len() - at);
                match chance.below(3) {
                    0 => drop(text.drain(at..at + gone)),
                    1 => drop(text.splice(at..at, piece)),
                    _ => drop(text.splice(at..at + gone, piece)),
                }
            }
            agrees(&text);
        }
    }
}

#[test]
fn lines_of_pieces_in_any_order_are_read_as_the_productions_read_them() {
    let mut chance = Chance::new();
    for _ in 0..400 {
        let mut text = b"MODULE m\nVAR num n:=1;\nPROC p()\n".to_vec();
        for _ in 0..12 {
            let starts: [&[u8]; 8] = [
                b"MoveL p1",
                b"n:=2",
                b"w.uframe:=x",
                b"n:=f(2)",
                b"VAR num k",
                b"Stop",
                b"SetDO do1,1",
                b"TASK PERS num k",
            ];
            text.extend_from_slice(starts[chance.below(starts.len())]);
            for _ in 0..chance.below(5) {
                text.extend_from_slice(PIECES[chance.below(PIECES.len())]);
            }
            text.extend_from_slice([&b";\n"[..], b"\n", b" ; ! c\n", b";"][chance.below(4)]);
        }
        text.extend_from_slice(b"ENDPROC\nENDMODULE\n");
        agrees(&text);
    }
}

/// Whether a statement, and whether a declaration, is scanned to the end of `text`.
fn scanned(text: &[u8]) -> [bool; 2] {
    let state = ParseState::new(text);
    let i = Text::new(text, &state);
    let to_the_end = |rest: Text<'_>| rest.is_empty();
    [
        plain_statement(i).is_some_and(|(rest, _)| to_the_end(rest)),
        plain_declaration(i).is_some_and(|(rest, _)| to_the_end(rest)),
    ]
}

#[test]
fn the_common_forms_are_scanned_and_no_others() {
    for line in [
        &b"MoveL p10,v100,z5,tGrip\\WObj:=wTable;"[..],
        b"MoveL [[1,2,-3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v1,fine,t,\\WObj:=w ;",
        b"ConfJ \\On;",
        b"Stop;",
        b"TPWrite \"a;b\"\\Num:=n;",
        b"WaitTime 0.5;",
        b"n := 5;",
        b"x:=-5.5;",
        b"a .b:=f( );",
        b"MoveL Offs(p10,0,0,-50),v100,z5,t;",
        b"p:=CRobT(\\Tool:=t\\WObj:=w);",
        b"n:=f(g(h(i())));",
        b"rdkWObj.uframe.trans.x:=Round(a.b\\Dec:=1);",
        b"done:=TRUE;",
    ] {
        assert_eq!(scanned(line), [true, false], "{}", String::from_utf8_lossy(line));
    }
    for line in [&b"CONST num n:=5;"[..], b"local pers robtarget p:=[[1,2,3],[1,0,0,0]];", b"VAR num n;"] {
        assert_eq!(scanned(line), [false, true], "{}", String::from_utf8_lossy(line));
    }
    for line in [
        &b"MoveL p10,v100,z5,tGrip"[..],
        b"n:=- 1;",
        b"n:=+1;",
        b"n:=a+1;",
        b"a.b.c.d.e.f:=1;",
        b"n:=a .b;",
        b"n:=f(1).x;",
        b"n:=f(1){2};",
        b"n:=f(g(h(i(j(1)))));",
        b"n:=f(1;",
        b"n:=f);",
        b"p a);",
        b"a{1}:=1;",
        b"%\"p\"%;",
        b"p a,;",
        b"p,\\On;",
        b"p \\On?on;",
        b"p 1,2,3,4,5,6,7,8,9;",
        b"p a ! c\n;",
        b"lab:",
        b"TASK PERS num n;",
        b"RETURN;",
        b"VAR num n{3};",
        b"VAR <TDN> n;",
        b"VAR num n:=a+1;",
    ] {
        assert_eq!(scanned(line), [false, false], "{}", String::from_utf8_lossy(line));
    }
}
