//! `tcTouch` executed: the emitted filter in single precision, on a robot that is not as its table says.
//!
//! The robot of these tests settles by 30 per cent more or less than the table, with a time constant 40 per cent longer or
//! shorter, cools as nobody knows, and has worked for a while that is not what the start routine is told. It moves by
//! `robot_model::deform::Warmth`, nothing of the filter; the touches are searches of the virtual controller.

mod laws;
mod log;
mod model;
mod refusals;
mod s4c;
mod shift;
mod state;

use driftpost::application::TouchRequest;
use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::{Core, TouchBy};
use robot_model::deform::{DeformedArm, GrowthLaw, Warmth};
use robot_model::kinematics::{Chain, ClosedForm};
use virtual_controller::compare::MoveComparator;
use virtual_controller::{Controller, Move, Sphere, TrueRobot};

/// The sphere's centre in the base, mm, and the distance of a touch.
const CENTRE_MM: [f64; 3] = [400.0, 330.0, 200.0];
const RADIUS_MM: f64 = 15.0;
const TABLE_TAU_MIN: f64 = 46.0;

/// Targets of the paper's cube, and a sphere beside it.
const SOURCE: &str = "MODULE Cell
  CONST robtarget pSphere:=[[400,330,200],[0.70710678,0,0.70710678,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget p{8}:=[
    [[400,300,250],[0.70710678,0,0.70710678,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[400,-300,250],[0.70710678,0,0.70710678,0],[-1,-1,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[400,300,550],[0.70710678,0,0.70710678,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[400,-300,550],[0.70710678,0,0.70710678,0],[-1,-1,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[550,150,400],[0.70710678,0,0.70710678,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[550,-150,400],[0.70710678,0,0.70710678,0],[-1,-1,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[700,150,400],[0.70710678,0,0.70710678,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[700,-150,550],[0.70710678,0,0.70710678,0],[-1,-1,0,1],[9E9,9E9,9E9,9E9,9E9,9E9]]];
  PROC main()
    MoveJ p{1},v500,fine,tool0;
    MoveJ p{2},v500,fine,tool0;
    MoveJ p{3},v500,fine,tool0;
    MoveJ p{4},v500,fine,tool0;
    MoveJ p{5},v500,fine,tool0;
    MoveJ p{6},v500,fine,tool0;
    MoveJ p{7},v500,fine,tool0;
    MoveJ p{8},v500,fine,tool0;
  ENDPROC
  PROC probe(robtarget expected,INOUT robtarget found)
    found:=expected;
    found.trans.x:=pSeen.x;
    found.trans.y:=pSeen.y;
    found.trans.z:=pSeen.z;
  ENDPROC
  PERS pos pSeen:=[400,330,200];
ENDMODULE
";

fn search() -> TouchBy {
    TouchBy::Search { signal: "diTouch".into(), radius_m: RADIUS_MM / 1e3, margin_m: 5e-3 }
}

/// The cell's program with `tcTouch`, or without.
fn emitted(form: FormChoice, growth: GrowthLaw, touch: Option<(TouchBy, f64)>) -> Vec<u8> {
    files(form, growth, touch, Core::Embedded).remove(0)
}

/// The files of the cell's program, the core's behind it where it is a module of its own.
fn files(form: FormChoice, growth: GrowthLaw, touch: Option<(TouchBy, f64)>, core: Core) -> Vec<Vec<u8>> {
    let mut job = job(form, growth, touch);
    job.emit.core = Some(core);
    run(&job)
}

fn run(job: &Compensation) -> Vec<Vec<u8>> {
    let program = ProgramFiles::one("Cell.mod", SOURCE.as_bytes().to_vec());
    let made = job.run(&program).unwrap_or_else(|refusal| panic!("{:?}", refusal.messages));
    made.files.into_iter().map(|file| file.bytes).collect()
}

fn job(form: FormChoice, growth: GrowthLaw, touch: Option<(TouchBy, f64)>) -> Compensation {
    let robot = Robot::built_in("irb140").unwrap();
    let deformation = Deformation::from_static(Deformation::paper().settled(), growth);
    let mut job = Compensation::new(robot, deformation).in_form(form);
    job.touch = touch.map(|(by, sigma_mm)| TouchRequest {
        name: "S1".into(),
        point: ["pSphere", "tool0", "wobj0"].map(str::to_owned),
        by,
        sigma_m: sigma_mm / 1e3,
        log: false,
    });
    job
}

/// A robot of its own, and what measures it.
#[derive(Clone, Copy)]
struct Truth {
    amount: f64,
    law: GrowthLaw,
    tau_cool_min: f64,
    /// So long it had worked, minutes.
    worked_min: f64,
    noise_mm: f64,
    false_share: f64,
    seed: u64,
}

impl Truth {
    /// The robot of the proof, by a seed.
    fn drawn(seed: u64, noise_mm: f64) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut either = |a: f64, b: f64| if rng.random::<bool>() { a } else { b };
        let (amount, tau) = (either(0.7, 1.3), either(0.6, 1.4));
        let cool: f64 = rng.random_range(25.0_f64.ln()..100.0_f64.ln());
        Self {
            amount,
            law: GrowthLaw::TwoStage { tau_min: tau * TABLE_TAU_MIN },
            tau_cool_min: cool.exp(),
            worked_min: rng.random_range(20.0..60.0),
            noise_mm,
            // One touch in twenty, of three searches each.
            false_share: 1.0 - 0.95_f64.cbrt(),
            seed,
        }
    }
}

/// A cell in which a program runs on a true robot.
struct Cell {
    controller: Controller,
    robot: TrueRobot,
    warmth: Warmth,
    intended: Vec<Move>,
    closed: ClosedForm,
    nominal: Chain,
}

impl Cell {
    fn new(program: &[u8], truth: &Truth) -> Self {
        Self::of(&[program.to_vec()], truth)
    }

    fn of(files: &[Vec<u8>], truth: &Truth) -> Self {
        let arm = Robot::built_in("irb140").unwrap();
        let mut original = Controller::with_robot(&arm).unwrap();
        original.load("Cell.mod", SOURCE.as_bytes()).unwrap();
        assert!(original.call("main", 1).unwrap().is_good());
        let intended = original.arm_mut().unwrap().take_moves();
        let mut controller = Controller::with_robot(&arm).unwrap();
        for file in files {
            controller.load("Cell.mod", file).unwrap();
        }
        controller.calendar_mut().held = true;
        controller.put_sphere(Sphere {
            signal: "diTouch".into(),
            centre_mm: CENTRE_MM,
            radius_mm: RADIUS_MM,
            noise_mm: truth.noise_mm,
            false_share: truth.false_share,
            false_mm: [0.1, 1.0],
            seed: truth.seed,
        });
        let mut warmth = Warmth::cold(truth.law, truth.tau_cool_min);
        warmth.advance(truth.worked_min, true);
        let settled =
            Deformation::from_static(Deformation::paper().settled(), truth.law).scaled(truth.amount);
        let (closed, nominal) = (ClosedForm::new(&arm).unwrap(), Chain::nominal(&arm));
        Self { controller, robot: TrueRobot::new(arm, settled), warmth, intended, closed, nominal }
    }

    fn arm(&self) -> DeformedArm {
        self.robot.arm(&self.warmth)
    }

    fn call(&mut self, name: &str) {
        self.controller.set_true_arm(self.arm());
        let outcome = self.controller.call(name, 1).unwrap();
        assert!(outcome.is_good(), "{name}: {outcome:?}");
    }

    /// Time goes on, working or standing.
    fn pass_min(&mut self, minutes: f64, working: bool) {
        self.controller.calendar_mut().advance_min(minutes);
        self.warmth.advance(minutes, working);
    }

    /// One pass of the work: how far the TCP is from where it is meant to be, mm.
    fn work(&mut self) -> Vec<f64> {
        self.controller.arm_mut().unwrap().take_moves();
        self.call("main");
        let moves = self.controller.arm_mut().unwrap().take_moves();
        assert_eq!(moves.len(), self.intended.len());
        let evaluator = MoveComparator { closed: &self.closed, nominal: &self.nominal };
        let arm = self.arm();
        let error = |(a, b)| evaluator.pose_error(&arm, a, b).unwrap().position_m * 1e3;
        self.intended.iter().zip(&moves).map(error).collect()
    }

    fn number(&mut self, name: &str) -> f64 {
        self.controller.number(name).unwrap()
    }

    fn touch_message(&mut self) -> String {
        let value = self.controller.value("tcTouchSaid").unwrap();
        virtual_controller::value_text(&value)
    }
}
