//! The virtual controller at work: what motions ask for in their arguments, stops and steps back, pauses.

mod arguments;
mod memory;
mod outputs;
mod pure;
mod searching;
mod slowing;
mod stepping;
mod warming;

use robot_model::robot::Robot;
use virtual_controller::Controller;

/// Targets that the IRB 140 reaches with one configuration, and joints to begin with.
const TARGETS: &str = "  CONST jointtarget jHome:=[[0,10,20,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget p{3}:=[
    [[400,-40,250],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[430,-40,250],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]],
    [[430,-40,270],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];
";

fn module(body: &str) -> String {
    format!("MODULE Cell\n{TARGETS}{body}\nENDMODULE\n")
}

/// A controller of an IRB 140 with these routines and data beside [`TARGETS`].
fn controller(body: &str) -> Controller {
    let mut c = Controller::with_robot(&Robot::built_in("irb140").unwrap()).unwrap();
    c.load("cell.mod", module(body).as_bytes()).unwrap();
    c
}

fn ran(c: &mut Controller, routine: &str) {
    let outcome = c.call(routine, 1).unwrap();
    assert!(outcome.is_good(), "{routine}: {outcome:?}");
}
