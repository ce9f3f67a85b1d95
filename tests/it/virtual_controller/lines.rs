//! The joints that straight lines lead through.

use robot_model::robot::Robot;
use virtual_controller::{Controller, Outcome};

/// A straight line that passes 0.54 deg beside the wrist singularity stays on its branch, where axis 4 swings round to -153.6 deg (followed
/// by hand in fine steps); 20 mm further on the solution with the wrist flipped is nearer.
#[test]
fn a_line_beside_the_wrist_singularity_stays_on_its_branch() {
    let program = "MODULE G
  PERS tooldata t:=[TRUE,[[41.89624,-34.98723,61.97142],[0.972516660,-0.069337968,0.063689648,0.212948871]],[1,[0,0,50],[1,0,0,0],0,0,0]];
  PERS wobjdata w:=[FALSE,TRUE,\"\",[[-72.58885,-63.62370,-174.51810],[0.991994642,-0.066581123,0.028932660,-0.103327079]],[[0,0,0],[1,0,0,0]]];
  VAR jointtarget j;
  PROC main()
    ConfL\\Off;
    MoveAbsJ [[0,5,5,5,40,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t\\WObj:=w;
    MoveL [[1201.75064,188.44753,1279.73770],[0.393859779,0.382127704,0.667615487,0.503132640],[0,0,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,t\\WObj:=w;
    j:=CJointT();
  ENDPROC
ENDMODULE
";
    let robot = Robot::built_in("irb4600").unwrap();
    let mut controller = Controller::with_robot(&robot).unwrap();
    controller.load("G.mod", program.as_bytes()).unwrap();
    assert_eq!(controller.call("main", 1).unwrap(), Outcome::Finished);
    let joints_deg = controller.value("j").unwrap().numbers();
    assert!(joints_deg[4] > 0.0 && (joints_deg[3] + 153.6).abs() < 0.1, "{joints_deg:?}");
}
