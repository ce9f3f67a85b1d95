//! A program of several files: what is in force goes with the calls from one to the other.

use super::{at, codes, program, tool, tools_mm};
use rapid_program::motion::MotionId;

#[test]
fn what_is_in_force_goes_from_file_to_file() {
    let moves = |y: i32, n: i32| {
        let line = |x| format!("MoveL {},v100,z1,t;\n", at(400 + x, y, 300));
        (0..n).map(line).collect::<String>()
    };
    let main = format!(
        "MODULE Main\nPERS tooldata t:={};\nPROC main()\nMoveAbsJ [[0,0,0,0,90,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t;\n\
         one;\nt.tframe.trans.x:=55;\ntwo;\nENDPROC\nENDMODULE\n",
        tool(10)
    );
    let one = format!("MODULE One\nPROC one()\n{}ENDPROC\nENDMODULE\n", moves(1, 3));
    let two = format!(
        "MODULE Two\nPROC two()\n{}PDispOn [[1,0,0],[1,0,0,0]],t;\n{}PDispOff;\n{}ENDPROC\nENDMODULE\n",
        moves(2, 2),
        moves(3, 2),
        moves(4, 1)
    );
    let read = program(&[("Main.mod", &main), ("One.mod", &one), ("Two.mod", &two)]);
    let [ten, late] = [Some(10), Some(55)];
    assert_eq!(tools_mm(&read), [ten, ten, ten, ten, late, late, late, late, late]);
    let displaced = "keep::displacement";
    assert_eq!(codes(&read), ["-", "-", "-", "-", "-", "-", displaced, displaced, "-"]);
    let previous: Vec<_> = read.motions.iter().map(|m| m.previous.map(MotionId::index)).collect();
    assert_eq!(previous, [None, Some(0), Some(1), Some(2), Some(3), Some(4), Some(5), Some(6), Some(7)]);
}
