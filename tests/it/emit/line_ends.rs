//! Files whose lines end in more than one way: what is put in becomes one with no neighbour's line end.

use super::lone;
use rand::seq::IndexedRandom;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rapid_compensation::emit::restore;

/// A module whose line ends, empty lines and comments are drawn: `ends` are those of its lines.
fn drawn(rng: &mut ChaCha8Rng, ends: &[&str]) -> String {
    const LINES: [&str; 7] = [
        "MODULE Mixed",
        "  CONST robtarget p1:=[[400,0,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];",
        "  PROC main()",
        "    MoveL p1,v100,fine,tool0;",
        "    MoveL [[450,0,300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;",
        "  ENDPROC",
        "ENDMODULE",
    ];
    let mut text = String::new();
    for line in LINES {
        text.push_str(line);
        text.push_str(ends.choose(rng).unwrap());
        for _ in 0..rng.random_range(0..3) {
            text.push_str(["", "  ! a remark"].choose(rng).unwrap());
            text.push_str(ends.choose(rng).unwrap());
        }
    }
    text
}

#[test]
fn a_file_with_mixed_line_ends_is_corrected_and_comes_back_to_the_byte() {
    let mut rng = ChaCha8Rng::seed_from_u64(4);
    let mixtures: [&[&str]; 6] = [
        &["\n", "\r\n", "\r"],
        &["\n", "\r"],
        &["\r", "\r\n"],
        &["\n", "\r\n"],
        &["\r", "\r", "\r", "\n"],
        &["\n", "\n", "\n", "\r"],
    ];
    for k in 0..240 {
        let source = drawn(&mut rng, mixtures[k % mixtures.len()]);
        // What cannot be got back is refused there.
        let emitted = lone(source.as_bytes());
        let restored = restore(&emitted).unwrap();
        assert!(restored.exact && restored.bytes == source.as_bytes(), "{source:?}");
    }
}
