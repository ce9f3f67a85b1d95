//! VelSet and SpeedRefresh: a move takes as long as its slowed speed or its `\T` says.

use super::{controller, ran};

#[test]
fn a_move_takes_as_long_as_the_speed_that_is_left_says() {
    let body = "  VAR clock k;\n  VAR num s{7};\n\
        PROC timed(num i)\n    ClkReset k;\n    ClkStart k;\n    MoveL p{1+i MOD 2},v10,fine,tool0;\n    ClkStop k;\n    s{i}:=ClkRead(k);\n  ENDPROC\n\
        PROC main()\n    MoveAbsJ jHome,v500,fine,tool0;\n    MoveL p{1},v500,fine,tool0;\n    timed 1;\n    VelSet 50,5000;\n    timed 2;\n    \
        VelSet 100,5;\n    timed 3;\n    VelSet 50,5000;\n    SpeedRefresh 25;\n    timed 4;\n    SpeedRefresh 100;\n    \
        ClkReset k;\n    ClkStart k;\n    MoveL p{2},v10\\T:=4,fine,tool0;\n    ClkStop k;\n    s{5}:=ClkRead(k);\n  ENDPROC\n\
        PROC again()\n    MoveL p{1},v500,fine,tool0;\n    timed 7;\n  ENDPROC";
    let mut c = controller(body);
    ran(&mut c, "main");
    // From p{1} to p{2} it is 30 mm: 3 s at 10 mm/s, 6 s at half of it or at 5 mm/s at most, 24 s at a quarter of half of it, and
    // twice the 4 s that \T says.
    let seconds = c.value("s").unwrap().numbers();
    for (found, expected) in seconds.iter().zip([3.0, 6.0, 6.0, 24.0, 8.0]) {
        assert!((found - expected).abs() < 0.05, "{seconds:?}");
    }
    c.pp_to_main();
    ran(&mut c, "again");
    assert!((c.value("s").unwrap().numbers()[6] - 3.0).abs() < 0.05, "what VelSet said is forgotten");
}
