//! Where the clock is brought up to date. The cube's narrowest bucket is about 6.5 minutes, so about 3.25
//! minutes may pass between two ticks: 195 s.

use super::*;
use plan::Tick;

fn ticks(program: &Program) -> Vec<Tick> {
    plan(program, &irb140(), &Deformation::paper(), &Options::default()).unwrap().ticks
}

fn in_loop(mut program: Program, unconditional: bool, passes: Option<u64>) -> Program {
    program.loops.push(Loop { file: FileId(0), routine: 0, unconditional, passes, first_statement: 0 });
    program.motions.iter_mut().for_each(|motion| motion.loops = vec![0]);
    program
}

#[test]
fn a_short_routine_has_one() {
    assert_eq!(ticks(&cube45(true)), [Tick::Routine(0)]);
}

#[test]
fn loops_tick_when_they_may_last() {
    let short = || {
        let mut program = cube45(true);
        program.motions.truncate(3);
        program
    };
    let both = [Tick::Routine(0), Tick::Loop(0)];
    assert_eq!(ticks(&in_loop(short(), true, None)), both);
    assert_eq!(ticks(&in_loop(short(), false, None)), both);
    assert_eq!(ticks(&in_loop(short(), false, Some(2))), [Tick::Routine(0)]);
    assert_eq!(ticks(&in_loop(short(), false, Some(1000))), both);
}

#[test]
fn a_wait_of_unknown_length_asks_for_one_before_the_next_corrected_motion() {
    let mut program = cube45(true);
    program.motions[7].wait_before = Wait::Unbounded;
    program.motions[7].targets[0].value = None;
    assert_eq!(ticks(&program), [Tick::Routine(0), Tick::Motion(8)]);
}

#[test]
fn slow_moves_are_counted_up_to_half_a_bucket() {
    // 150 mm at 5 mm/s are 30 s, estimated at 45: the clock is asked at least every fourth move.
    let mut program = cube45(true);
    for motion in &mut program.motions {
        motion.speed = Some(SpeedData { v_tcp_m_s: 0.005, v_ori_rad_s: 1.0 });
    }
    let found = ticks(&program);
    let before: Vec<usize> =
        found.iter().filter_map(|tick| if let Tick::Motion(i) = tick { Some(*i) } else { None }).collect();
    assert!(before.len() >= 11, "{before:?}");
    assert!(before.windows(2).all(|pair| pair[1] - pair[0] <= 4), "{before:?}");
    // Waits count too: 200 s is more than half a bucket.
    let mut waiting = cube45(true);
    waiting.motions[20].wait_before = Wait::Seconds(200.0);
    assert_eq!(ticks(&waiting), [Tick::Routine(0), Tick::Motion(20)]);
}
