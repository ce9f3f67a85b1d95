//! The emitted filter against the one in double precision, of one lag and of two, in a module of its own and not.

use super::refusals::{as_the_table, settled_mm};
use super::shift::{median, program, shift};
use super::{Cell, TABLE_TAU_MIN, Truth, files, search};
use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::{Core, TouchBy};
use robot_model::deform::GrowthLaw;
use robot_model::deform::thermal_filter::{ThermalFilter, TouchOutcome};

const ONE_LAG: GrowthLaw = GrowthLaw::Exp { tau_min: TABLE_TAU_MIN };
const TWO_LAGS: GrowthLaw = GrowthLaw::TwoStage { tau_min: TABLE_TAU_MIN };
/// The motions of work, minutes apart: under the longest pause that counts as work.
const WORK_MIN: f64 = 4.0;

#[test]
fn it_learns_what_the_filter_in_double_precision_learns() {
    let settled_mm = settled_mm();
    let square: f64 = settled_mm.iter().map(|x| x * x).sum();
    for (law, core) in [
        (ONE_LAG, Core::Embedded),
        (ONE_LAG, Core::Separate),
        (TWO_LAGS, Core::Embedded),
        (TWO_LAGS, Core::Separate),
    ] {
        let text = files(FormChoice::Ramp, law, Some((TouchBy::Routine("probe".into()), 0.02)), core);
        assert_eq!(text.len(), if core == Core::Separate { 2 } else { 1 });
        let mut cell = Cell::of(&text, &as_the_table());
        let mut filter = ThermalFilter::new(law, TABLE_TAU_MIN, [0.0; 2]).unwrap();
        cell.call("tcColdStart");
        // From one touch to the next the arm works or stands, and the touch sees a share of the drift.
        let touches = [(28.0, true, 0.3), (30.0, false, 0.2), (60.0, true, 0.7), (90.0, false, 0.25)];
        for (minutes, working, share) in touches {
            let step_min = if working { WORK_MIN } else { minutes };
            for _ in 0..(minutes / step_min) as usize {
                cell.pass_min(step_min, working);
                cell.call("tcUpdate");
            }
            filter.advance(minutes, working);
            assert_eq!(filter.touch(share, 0.02 * 0.02 / square), TouchOutcome::Taken);
            cell.seen(settled_mm.map(|x| x * share));
            assert!(
                cell.touch_message().contains("Touch taken"),
                "{law} {minutes}: {}",
                cell.touch_message()
            );
            let known = cell.controller.value("tcKnown").unwrap().numbers();
            let learnt = [("tcHas", filter.seen()), ("tcAmount", 2), ("tcTau", 3), ("tcTauCool", 4)];
            for (name, i) in learnt {
                let value = cell.number(name);
                let value = if i > 2 { value.ln() } else { value };
                let sigma = filter.covariance[(i, i)].sqrt();
                // Single precision on the one side, double on the other: next to what is known, nothing.
                let off = (value - filter.state[i]) / sigma;
                assert!(off.abs() < 0.005, "{law} {minutes} {name}: {value} {} {off}", filter.state[i]);
                let of_program = known[6 * i].sqrt();
                assert!(
                    (of_program / sigma - 1.0).abs() < 1e-2,
                    "{law} {minutes} {name}: {of_program} {sigma}"
                );
            }
        }
    }
}

#[test]
fn a_wrong_first_state_is_right_after_two_touches_of_one_lag_and_of_a_core_apart() {
    for (law, core) in [(ONE_LAG, Core::Embedded), (ONE_LAG, Core::Separate), (TWO_LAGS, Core::Separate)] {
        for form in [FormChoice::Ramp, FormChoice::Schedule, FormChoice::Live] {
            let text = files(form, law, Some((search(), 0.02)), core);
            let mut cell = Cell::of(&text, &Truth { law, worked_min: 600.0, amount: 1.3, ..as_the_table() });
            cell.call("tcColdStart");
            assert!(cell.work().into_iter().fold(0.0, f64::max) > 0.1, "cold targets on a warm arm");
            for _ in 0..2 {
                cell.call("tcTouch");
                cell.pass_min(1.0, true);
            }
            let worst = cell.work().into_iter().fold(0.0, f64::max);
            assert!(worst < 0.02, "{law} {core:?} {form:?} {worst} {}", cell.touch_message());
        }
    }
}

#[test]
fn a_few_shifts_of_a_robot_with_one_lag_are_better_with_touches_than_without() {
    let rms = |every_min: Option<u32>| {
        let text = program(FormChoice::Ramp, ONE_LAG, every_min.map(|_| 0.02));
        let truth = |seed: u64| {
            let drawn = Truth::drawn(seed, 0.02);
            Truth { law: GrowthLaw::Exp { tau_min: drawn.law.tau_min().unwrap() }, ..drawn }
        };
        median((0..4).map(|seed| shift(&text, &truth(seed), every_min).rms).collect())
    };
    let [with, without] = [rms(Some(30)), rms(None)];
    println!("one lag: rms {with} mm with touches, {without} without");
    assert!(with < 0.018 && without > 1.5 * with, "{with} {without}");
}
