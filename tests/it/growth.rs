//! Work that grows with the size of what is given, not with its square.

use driftpost::{Compensation, Deformation, ProgramFiles, Robot};
use rapid_compensation::compensate::FormChoice;
use robot_model::robot::SerialArm;
use std::time::{Duration, Instant};

/// Four times as much takes four times as long where time grows with the size, sixteen times where it grows with its square.
const MOST_RATIO: f64 = 8.0;
/// What else the machine does makes a run longer, never shorter: the shortest of several counts, and a busy while is waited for.
const RUNS: usize = 4;
const ATTEMPTS: usize = 4;

fn grows_with_size(what: &str, n: usize, run: impl Fn(usize) -> Duration) {
    let shortest = |n: usize| (0..RUNS).map(|_| run(n)).min().unwrap().as_secs_f64();
    let ratios: Vec<f64> = (0..ATTEMPTS)
        .map(|_| shortest(4 * n) / shortest(n))
        .inspect(|ratio| println!("{what}: four times as many take {ratio:.1} times as long"))
        .scan(false, |done, ratio| (!std::mem::replace(done, ratio < MOST_RATIO)).then_some(ratio))
        .collect();
    assert!(
        ratios.iter().any(|ratio| *ratio < MOST_RATIO),
        "{what}: {ratios:.1?} times as long for four times as many"
    );
}

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    #[test]
    #[ignore = "long"]
    fn moves_on_one_line_take_time_in_proportion() {
        let robot = Robot::built_in("irb140").unwrap();
        for form in [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Live] {
            grows_with_size(&format!("moves on one line, {form:?}"), 3000, |n| {
                let target = |k: usize| {
                    format!(
                        "[[{},{},300],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]",
                        400 + k % 100,
                        k / 100
                    )
                };
                let moves: String =
                    (0..n).map(|k| format!("MoveL {},v100,fine,tool0; ", target(k))).collect();
                let text = format!("MODULE M\n  PROC main()\n    {moves}\n  ENDPROC\nENDMODULE\n");
                let files = ProgramFiles::one("M.mod", text.as_bytes());
                let job = Compensation::new(robot.clone(), Deformation::paper()).in_form(form);
                let start = Instant::now();
                let made = job.run(&files).unwrap();
                let took = start.elapsed();
                assert!(made.text().is_some());
                took
            });
        }
    }

    #[test]
    #[ignore = "long"]
    fn links_of_a_description_take_time_in_proportion() {
        let arm = include_str!("../../fixtures/robots/irb120.urdf");
        for is_star in [true, false] {
            grows_with_size(&format!("links, all on one link: {is_star}"), 4000, |n| {
                let parent =
                    |k: usize| if is_star || k == 0 { "link_3".to_owned() } else { format!("x{}", k - 1) };
                let one = |k: usize| {
                    format!(
                        "<link name=\"x{k}\"><inertial><mass value=\"0.001\"/></inertial></link><joint name=\"j{k}\" type=\"fixed\"><parent link=\"{}\"/><child link=\"x{k}\"/></joint>",
                        parent(k)
                    )
                };
                let text =
                    arm.replace("</robot>", &format!("{}</robot>", (0..n).map(one).collect::<String>()));
                let start = Instant::now();
                let read = SerialArm::from_urdf(&text, None).unwrap();
                let took = start.elapsed();
                assert_eq!(read.joints.len(), 6);
                let mass_kg = read.links.unwrap()[2].mass_kg;
                assert!(
                    mass_kg > 0.001 * n as f64,
                    "what is fixed to link 3 counts into its mass: {mass_kg}"
                );
                took
            });
        }
    }
}
