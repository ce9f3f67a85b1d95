//! Blocks whose head or end is no RAPID: what stands between may run or not.

use super::state::{MOVE, data};
use super::{codes, main_of};

/// Of `lines` with two motions behind them what becomes of the second: the first stands beside what was not understood.
fn second_behind(lines: &str) -> String {
    let body = format!("{MOVE}{lines}\n{MOVE}{MOVE}");
    codes(&main_of(&data(), &body)).last().unwrap().to_string()
}

/// A number and a word want white space between them; `3THEN` is neither.
#[test]
fn what_an_unread_block_sets_is_not_known_behind_it() {
    for (unread, expected) in [
        ("IF n=3THEN\nt.tframe:=[[9,0,0],[1,0,0,0]];\nENDIF", "keep::tool-unknown"),
        ("IF n=3THEN\nw.uframe:=[[9,0,0],[1,0,0,0]];\nENDIF", "keep::wobj-unknown"),
        ("IF n=3THEN\nPDispSet [[0,0,1],[1,0,0,0]];\nENDIF", "keep::displacement"),
        // Whichever arm runs it is set, but not to what.
        (
            "IF n=3THEN\nt.tframe:=[[9,0,0],[1,0,0,0]];\nELSE\nt.tframe:=[[8,0,0],[1,0,0,0]];\nENDIF",
            "keep::tool-unknown",
        ),
        ("WHILE n<3DO\nt.tframe:=[[9,0,0],[1,0,0,0]];\nENDWHILE", "keep::tool-unknown"),
        // Its ENDIF ends the block about it, whose own ends none.
        (
            "IF n=1 THEN\nIF n=3THEN\nn:=4;\nENDIF\nt.tframe:=[[9,0,0],[1,0,0,0]];\nENDIF",
            "keep::tool-unknown",
        ),
        // What it sets is what it was, and what it does not set stays known.
        ("IF n=3THEN\nn:=4;\nENDIF", "-"),
        ("PDispSet [[0,0,1],[1,0,0,0]];\nIF n=3THEN\nPDispOff;\nENDIF", "keep::displacement"),
        // Text without a word of blocks in it begins and ends none.
        ("n ?? 3;\nt.tframe:=[[9,0,0],[1,0,0,0]];", "-"),
    ] {
        let declared = format!("VAR num n;\n{unread}");
        assert_eq!(second_behind(&declared), expected, "{unread}");
    }
}
