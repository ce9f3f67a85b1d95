//! Searches find what stands in the cell where the true arm touches it.

use super::{controller, ran};
use robot_model::deform::DeformedArm;
use robot_model::kinematics::FrameOffsets;
use robot_model::robot::Robot;
use virtual_controller::{Controller, Outcome, Sphere};

const SEARCH: &str = "  PERS num r{6}:=[0,0,0,0,0,0];
  PROC main()
    VAR robtarget found;
    MoveAbsJ jHome,v500,fine,tool0;
    MoveJ p{2},v500,fine,tool0;
    SearchL\\Stop,diTouch,found,Offs(p{2},0,0,-60),v10,tool0;
    r{1}:=found.trans.x;
    r{2}:=found.trans.z;
    found:=CRobT(\\Tool:=tool0\\WObj:=wobj0);
    r{3}:=found.trans.z;
    MoveL p{2},v500,fine,tool0;
    MoveL Offs(p{2},20,0,0),v500,fine,tool0;
    SearchL\\Stop,diTouch,found,Offs(p{2},20,0,-60),v10,tool0;
  ERROR
    IF ERRNO=ERR_WHLSEARCH r{4}:=1;
    IF ERRNO=ERR_SIGSUPSEARCH r{5}:=1;
    TRYNEXT;
  ENDPROC
  PROC inside()
    VAR robtarget found;
    MoveJ Offs(p{2},0,0,-45),v500,fine,tool0;
    SearchL\\Stop,diTouch,found,Offs(p{2},0,0,-60),v10,tool0;
  ENDPROC";

fn cell(rise_m: f64, sphere: Sphere) -> Controller {
    let mut c = controller(SEARCH);
    let mut offsets = FrameOffsets::default();
    offsets.0[0][2] = rise_m;
    c.set_true_arm(DeformedArm::of_table(&Robot::built_in("irb140").unwrap(), &offsets));
    c.put_sphere(sphere);
    c
}

fn sphere() -> Sphere {
    Sphere {
        signal: "diTouch".into(),
        centre_mm: [430.0, -40.0, 200.0],
        radius_mm: 12.0,
        noise_mm: 0.0,
        false_share: 0.0,
        false_mm: [0.0, 0.0],
        seed: 1,
    }
}

#[test]
fn a_search_ends_where_the_true_arm_touches_and_says_where_the_controller_takes_it_to_be() {
    // The base has grown by 0.1 mm upward: the tip, 12 mm above the centre at 200, is taken to be at 211.9.
    let mut c = cell(1e-4, sphere());
    ran(&mut c, "main");
    let r = c.value("r").unwrap().numbers();
    assert!((r[0] - 430.0).abs() < 1e-3 && (r[1] - 211.9).abs() < 1e-4, "{r:?}");
    assert!((r[2] - r[1]).abs() < 1e-3, "it stops there: {r:?}");
    assert_eq!(r[3..5], [1.0, 0.0], "20 mm beside the sphere nothing is found");
    let Outcome::Failed { error, .. } = c.call("inside", 1).unwrap() else { panic!("it began inside") };
    assert_eq!(error, Some("err_sigsupsearch"));
}

#[test]
fn noise_and_what_lies_on_a_sphere_are_drawn_by_its_seed() {
    let found = |sphere: Sphere| {
        let mut c = cell(0.0, sphere);
        (0..40)
            .map(|_| {
                ran(&mut c, "main");
                c.value("r").unwrap().numbers()[1] - 212.0
            })
            .collect::<Vec<f64>>()
    };
    let noisy = found(Sphere { noise_mm: 0.02, ..sphere() });
    assert_eq!(noisy, found(Sphere { noise_mm: 0.02, ..sphere() }));
    let rms = (noisy.iter().map(|x| x * x).sum::<f64>() / 40.0).sqrt();
    assert!((0.012..0.028).contains(&rms), "{rms}");
    let dirty = found(Sphere { false_share: 0.5, false_mm: [0.2, 0.4], ..sphere() });
    let thick = dirty.iter().filter(|x| (0.2 - 1e-4..0.4 + 1e-4).contains(*x)).count();
    let clean = dirty.iter().filter(|x| x.abs() < 1e-4).count();
    assert!(thick + clean == 40 && (8..32).contains(&thick), "{dirty:?}");
}
