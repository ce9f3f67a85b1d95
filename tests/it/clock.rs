//! The emitted clock, executed in single precision, against the exact law in double precision.
//!
//! The law is written out here anew; nothing of the emitter but its output is used.

use crate::emit::toy;

use rapid_compensation::compensate::FormChoice;
use rapid_compensation::emit::{Clock, DriftGrowth, EmitOptions, Provenance, emit};
use rapid_compensation::schedule::{Bucket, Schedule};
use robot_model::deform::GrowthLaw;
use virtual_controller::{Controller, Value};

const BUCKETS: usize = 19;

/// How the warm-up minute grows while the program runs.
#[derive(Clone, Copy, PartialEq)]
enum Stages {
    One,
    Two,
}

/// The exact law: `x1' = (u - x1)/tau`, `x2' = (x1 - x2)/tau`, `u` 1 running and 0 standing; for one lag the
/// second is left out. Held as what is missing to 1, so that nothing is lost when warm.
#[derive(Clone, Copy)]
struct Exact {
    stages: Stages,
    tau: f64,
    tau_cool: f64,
    missing: [f64; 2],
}

impl Exact {
    fn cold(stages: Stages, tau: f64, tau_cool: f64) -> Self {
        Self { stages, tau, tau_cool, missing: [1.0, 1.0] }
    }

    fn run(&mut self, minutes: f64) {
        let s = minutes / self.tau;
        let [m1, m2] = self.missing;
        self.missing = [m1 * (-s).exp(), (m2 + m1 * s) * (-s).exp()];
    }

    fn stand(&mut self, minutes: f64) {
        let s = minutes / self.tau_cool;
        let [x1, x2] = self.missing.map(|m| 1.0 - m);
        self.missing = [1.0 - x1 * (-s).exp(), 1.0 - (x2 + x1 * s) * (-s).exp()];
    }

    /// The minute after a cold start at which as much is missing.
    fn minute(&self) -> f64 {
        match self.stages {
            Stages::One => -self.tau * self.missing[0].ln(),
            Stages::Two => {
                let (mut low, mut high) = (0.0, 1000.0);
                for _ in 0..200 {
                    let s = 0.5 * (low + high);
                    if (1.0 + s) * f64::exp(-s) > self.missing[1] { low = s } else { high = s }
                }
                self.tau * 0.5 * (low + high)
            }
        }
    }
}

/// A controller with an emitted module, and the robot's true warmth.
struct Cell {
    controller: Controller,
    exact: Exact,
    worst: f64,
}

fn warmth(growth: Option<GrowthLaw>, tau_cool_min: Option<f64>) -> Clock {
    let growth = growth.map_or(DriftGrowth::Table(None), DriftGrowth::Law);
    Clock::Warmth { growth, tau_cool_min, gap_min: 5.0 }
}

fn two_stage() -> Clock {
    warmth(Some(GrowthLaw::TwoStage { tau_min: 46.0 }), None)
}

fn controller(clock: Clock) -> Controller {
    controller_with(clock, &toy::schedule(BUCKETS))
}

fn controller_with(clock: Clock, schedule: &Schedule) -> Controller {
    let source = b"MODULE M\n  PROC main()\n    MoveL [[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;\n  ENDPROC\nENDMODULE\n";
    let program = toy::program(&[("m.mod", source)]);
    let mut plan = toy::plan(&program, schedule.buckets.len(), &[], |_| 0.0);
    plan.schedule = schedule.clone();
    let options = EmitOptions {
        form: FormChoice::Schedule,
        growth: Some(GrowthLaw::TwoStage { tau_min: 46.0 }),
        clock,
        core: None,
        robot: Provenance::default(),
        deformation: Some(Provenance::default()),
        model: None,
        settings: Vec::new(),
        absolute_accuracy: false,
        self_test: false,
        touch: None,
    };
    let file = emit(&program, &plan, &options).unwrap().remove(0);
    let mut controller = Controller::new();
    controller.load("m_tc.mod", &file.bytes).unwrap();
    controller
}

impl Cell {
    fn new(clock: Clock, exact: Exact) -> Self {
        Self { controller: controller(clock), exact, worst: 0.0 }
    }

    fn two_stage() -> Self {
        Self::new(two_stage(), Exact::cold(Stages::Two, 46.0, 46.0))
    }

    fn at(mut self, date: (i64, u32, u32), time: (u32, u32, f64)) -> Self {
        self.controller.calendar_mut().set(date, time);
        self
    }

    fn call(&mut self, routine: &str) {
        let outcome = self.controller.call(routine, 1).unwrap();
        assert!(outcome.is_good(), "{routine}: {outcome:?}");
        assert_eq!(self.controller.unknown_instructions(), Vec::<String>::new());
    }

    fn number(&mut self, name: &str) -> f64 {
        self.controller.number(name).unwrap()
    }

    fn cold(mut self) -> Self {
        self.call("tcColdStart");
        self
    }

    /// A tick, and what it says against the exact law.
    fn tick(&mut self) {
        self.call("tcUpdate");
        let (minute, exact) = (self.number("tcMinute"), self.exact.minute());
        self.worst = self.worst.max((minute - exact).abs());
        assert!((minute - exact).abs() <= 0.5, "minute {minute}, exact {exact}");
        let bucket = self.number("tcBucket");
        assert_eq!(bucket, (minute / 10.0).floor().min(BUCKETS as f64 - 1.0), "minute {minute}");
        assert_eq!(self.number("tcI"), bucket + 2.0);
    }

    fn run(&mut self, minutes: f64) {
        let step = 0.25;
        self.tick();
        for _ in 0..(minutes / step) as usize {
            self.controller.calendar_mut().advance_min(step);
            self.exact.run(step);
            self.tick();
        }
    }

    fn stand(&mut self, minutes: f64) {
        self.controller.calendar_mut().advance_min(minutes);
        self.exact.stand(minutes);
    }

    /// Originals, and `messages` of them shown.
    fn originals(&mut self, messages: usize, what: &str) {
        for _ in 0..3 {
            self.call("tcUpdate");
            self.controller.calendar_mut().advance_min(0.5);
        }
        assert_eq!((self.number("tcI"), self.number("tcBucket")), (1.0, -1.0), "{what}");
        let shown = self.controller.take_messages();
        assert_eq!(shown.len(), messages, "{what}: {shown:?}");
        assert!(shown.iter().all(|m| m.text.len() <= 80 && m.text.contains("original")), "{what}: {shown:?}");
    }
}

/// Shift, lunch, shift, night, shift, weekend, shift.
fn a_week(mut cell: Cell) -> f64 {
    cell.run(60.0);
    cell.stand(45.0);
    cell.run(30.0);
    cell.stand(14.0 * 60.0);
    cell.run(20.0);
    cell.stand(62.0 * 60.0);
    cell.run(20.0);
    cell.worst
}

#[test]
fn lunch_night_and_weekend_over_ends_of_months_and_years() {
    for (date, time) in [
        ((2026, 6, 15), (7, 30, 0.0)),
        ((2024, 2, 28), (22, 30, 0.0)),
        ((2025, 2, 28), (23, 10, 0.0)),
        ((2026, 12, 30), (22, 59, 59.0)),
        ((2027, 12, 31), (23, 0, 0.0)),
        ((2000, 2, 28), (12, 0, 0.0)),
        ((2099, 12, 31), (12, 0, 0.0)),
        ((2100, 2, 28), (12, 0, 0.0)),
    ] {
        let worst = a_week(Cell::two_stage().at(date, time).cold());
        println!("{date:?} {time:?}: worst {worst:.4} min");
        assert!(worst <= 0.1, "{date:?}: {worst}");
    }
}

#[test]
fn one_lag_and_another_rate_of_cooling() {
    let exp = Some(GrowthLaw::Exp { tau_min: 46.0 });
    let two = Some(GrowthLaw::TwoStage { tau_min: 30.0 });
    for (clock, exact) in [
        (warmth(exp, None), Exact::cold(Stages::One, 46.0, 46.0)),
        (warmth(exp, Some(80.0)), Exact::cold(Stages::One, 46.0, 80.0)),
        (warmth(None, Some(60.0)), Exact::cold(Stages::One, 60.0, 60.0)),
        (warmth(two, Some(55.5)), Exact::cold(Stages::Two, 30.0, 55.5)),
    ] {
        let worst = a_week(Cell::new(clock, exact).cold());
        assert!(worst <= 0.1, "{worst}");
    }
}

#[test]
fn four_hours_after_the_end_and_on() {
    let mut cell = Cell::two_stage().cold();
    cell.run(600.0);
    assert_eq!(cell.number("tcBucket"), BUCKETS as f64 - 1.0);
    cell.stand(45.0);
    cell.run(300.0);
}

#[test]
fn a_short_pause_counts_as_running_and_a_longer_one_does_not() {
    let mut cell = Cell::two_stage().cold();
    cell.run(40.0);
    cell.controller.calendar_mut().advance_min(4.9);
    cell.exact.run(4.9);
    cell.run(10.0);
    cell.stand(5.5);
    cell.run(10.0);
}

#[test]
fn program_pointer_to_main_starts_with_the_original_and_goes_on_where_it_was() {
    let mut cell = Cell::two_stage().cold();
    cell.run(73.0);
    assert_eq!(cell.number("tcBucket"), 7.0);
    cell.controller.pp_to_main();
    assert_eq!(cell.number("tcI"), 1.0);
    cell.tick();
    assert_eq!(cell.number("tcBucket"), 7.0);
    cell.run(20.0);
}

#[test]
fn a_clock_set_back_counts_as_no_time() {
    let mut cell = Cell::two_stage().cold();
    cell.run(50.0);
    cell.controller.calendar_mut().shift_min(-60.0);
    cell.run(50.0);
    // over midnight, back into the day before
    let mut cell = Cell::two_stage().at((2027, 1, 1), (0, 10, 0.0)).cold();
    cell.run(20.0);
    cell.controller.calendar_mut().shift_min(-60.0);
    cell.run(90.0);
    // in the lunch break: the break is not seen
    let mut cell = Cell::two_stage().cold();
    cell.run(50.0);
    cell.controller.calendar_mut().advance_min(45.0);
    cell.controller.calendar_mut().shift_min(-60.0);
    cell.run(20.0);
}

#[test]
fn midnight_between_date_and_time() {
    // each operation takes 0.11 s, so that over some ticks midnight falls between any two of them
    for start in 0..40 {
        let mut cell = Cell::two_stage().at((2026, 12, 31), (23, 0, 0.0)).cold();
        cell.run(59.0);
        let before = cell.number("tcMinute");
        cell.controller.calendar_mut().set((2026, 12, 31), (23, 59, 55.0 + 0.12 * f64::from(start)));
        cell.controller.calendar_mut().step_s = 0.11;
        cell.call("tcUpdate");
        cell.controller.calendar_mut().step_s = 0.0;
        cell.controller.calendar_mut().set((2027, 1, 1), (0, 1, 0.0));
        cell.call("tcUpdate");
        let after = cell.number("tcMinute");
        assert!((before + 1.5..before + 2.5).contains(&after), "start {start}: {before} to {after}");
    }
}

#[test]
fn never_started_is_the_original_and_one_message() {
    for clock in [two_stage(), warmth(Some(GrowthLaw::Exp { tau_min: 9.0 }), None), Clock::Elapsed] {
        let mut cell = Cell::new(clock, Exact::cold(Stages::Two, 46.0, 46.0));
        cell.originals(1, "never started");
        cell.call("tcColdStart");
        assert_eq!((cell.number("tcI"), cell.number("tcBucket")), (2.0, 0.0));
    }
}

#[test]
fn a_state_that_cannot_be_is_the_original_and_one_message() {
    let day = 9662.0; // 2026-06-15, the simulated controller's first day, counted from 2000-01-01 as day 1
    for state in [
        [1.5, 0.5, day, 0.0, day, 60.0],
        [0.5, -0.1, day, 0.0, day, 60.0],
        [f32::NAN, 0.5, day, 0.0, day, 60.0],
        [0.5, 0.5, day, 60.0, day, 0.0],
        [0.5, 0.5, -3.0, 0.0, day, 0.0],
        [0.5, 0.5, day + 300.0, 0.0, day + 300.0, 0.0],
    ] {
        let mut cell = Cell::two_stage().cold();
        cell.run(10.0);
        cell.controller.set("tcState", Value::Array(state.map(Value::Num).to_vec())).unwrap();
        cell.controller.calendar_mut().advance_min(1.0);
        cell.originals(1, &format!("{state:?}"));
    }
    // the same day is fine
    let mut cell = Cell::two_stage().cold();
    let state = [0.5, 0.25, day, 0.0, day, 8.0 * 3600.0];
    cell.controller.set("tcState", Value::Array(state.map(Value::Num).to_vec())).unwrap();
    cell.controller.calendar_mut().advance_min(1.0);
    cell.call("tcUpdate");
    assert!(cell.number("tcI") > 1.0);
    // a controller whose clock has lost its date
    let mut cell = Cell::two_stage().cold();
    cell.run(10.0);
    cell.controller.calendar_mut().set((1980, 1, 1), (0, 0, 0.0));
    cell.originals(1, "1980");
}

#[test]
fn the_mode_is_obeyed() {
    let mut cell = Cell::two_stage().cold();
    cell.run(30.0);
    for (mode, bucket, messages) in [
        (0.0, 0.0, 1),
        (5.0, 5.0, 0), // a bucket is held: that was said
        (BUCKETS as f32 - 1.0, BUCKETS as f64 - 1.0, 0),
        (-2.0, -1.0, 1),
        (BUCKETS as f32, -1.0, 1),
        (0.5, -1.0, 0), // nonsense again: it was said once
        (7.0, 7.0, 1),
        (-3.0, -1.0, 1),
    ] {
        cell.controller.set("tcMode", Value::Num(mode)).unwrap();
        for _ in 0..3 {
            cell.call("tcUpdate");
            assert_eq!(cell.number("tcBucket"), bucket, "mode {mode}");
            assert_eq!(cell.number("tcI"), bucket + 2.0, "mode {mode}");
            cell.controller.calendar_mut().advance_min(0.5);
            cell.exact.run(0.5);
        }
        assert_eq!(cell.controller.take_messages().len(), messages, "mode {mode}");
    }
    // the clock went on meanwhile
    cell.controller.set("tcMode", Value::Num(-1.0)).unwrap();
    cell.run(10.0);
    // forced without a start: the bucket, and that it is forced
    let mut cell = Cell::two_stage();
    cell.controller.set("tcMode", Value::Num(3.0)).unwrap();
    cell.call("tcUpdate");
    assert_eq!((cell.number("tcI"), cell.controller.take_messages().len()), (5.0, 1));
}

#[test]
fn a_state_from_an_old_backup_has_cooled() {
    let mut cell = Cell::two_stage().cold();
    cell.run(120.0);
    let backup = cell.controller.backup();
    let exact = cell.exact;
    cell.run(60.0);
    cell.controller.calendar_mut().advance_min(3.0 * 1440.0);
    cell.controller.restore(&backup);
    cell.exact = exact;
    cell.exact.stand(60.0 + 3.0 * 1440.0);
    cell.run(30.0);
}

#[test]
fn warm_start_is_fully_warm_and_cools_like_the_rest() {
    for clock in [two_stage(), Clock::Elapsed] {
        let mut cell = Cell::new(clock, Exact::cold(Stages::Two, 46.0, 46.0));
        cell.call("tcWarmStart");
        assert_eq!(cell.number("tcBucket"), BUCKETS as f64 - 1.0);
    }
    let mut cell = Cell::two_stage();
    cell.call("tcWarmStart");
    cell.exact.missing = [0.0, 0.0];
    cell.controller.calendar_mut().advance_min(2.0);
    cell.call("tcUpdate");
    cell.stand(45.0);
    cell.run(30.0);
}

#[test]
fn elapsed_counts_minutes_whatever_happens() {
    let mut cell = Cell::new(Clock::Elapsed, Exact::cold(Stages::Two, 46.0, 46.0))
        .at((2027, 12, 31), (20, 0, 0.0))
        .cold();
    let mut expected = 0.0;
    for minutes in [0.25, 30.0, 45.0, 840.0, 4000.0, 12.5] {
        cell.controller.calendar_mut().advance_min(minutes);
        expected += minutes;
        cell.controller.pp_to_main();
        cell.call("tcUpdate");
        assert!((cell.number("tcMinute") - expected).abs() <= 0.02, "{expected}");
        let bucket = (expected / 10.0_f64).floor().min(BUCKETS as f64 - 1.0);
        assert_eq!(cell.number("tcBucket"), bucket);
    }
    cell.controller.calendar_mut().shift_min(-60.0);
    cell.call("tcUpdate");
    assert!((cell.number("tcMinute") - expected).abs() <= 0.02);
}

#[test]
fn without_growth_any_minute_is_the_one_bucket_once_started() {
    let mut cell = Cell::new(warmth(Some(GrowthLaw::None), None), Exact::cold(Stages::Two, 46.0, 46.0));
    cell.originals(1, "not started");
    cell.call("tcWarmStart");
    assert_eq!(cell.number("tcBucket"), BUCKETS as f64 - 1.0);
}

#[test]
fn tenths_of_a_minute_choose_the_bucket_too() {
    let edges = [0.0, 0.4, 1.3, 2.0, 2.9, 30.5];
    let bucket =
        |i: usize| Bucket { from_min: edges[i], to_min: edges.get(i + 1).copied(), at_min: edges[i] };
    let schedule = Schedule { buckets: (0..edges.len()).map(bucket).collect(), parts_per_min: 10 };
    let exact = Exact::cold(Stages::Two, 46.0, 46.0);
    let mut cell = Cell { controller: controller_with(two_stage(), &schedule), exact, worst: 0.0 };
    cell.call("tcColdStart");
    for second in (0..2400).step_by(3) {
        cell.call("tcUpdate");
        let minute = f64::from(second) / 60.0;
        // the minute is 0.03 off at most when cold: leave out what stands on an edge
        if edges.iter().all(|edge| *edge == 0.0 || (edge - minute).abs() > 0.06) {
            let expected = edges.iter().filter(|edge| **edge <= minute).count() as f64 - 1.0;
            assert_eq!(cell.number("tcBucket"), expected, "second {second}");
        }
        cell.controller.calendar_mut().advance_s(3.0);
    }
}

#[test]
fn a_cold_start_of_a_warm_clock_says_the_minute_it_stood_at() {
    for (clock, stages) in
        [(two_stage(), Stages::Two), (warmth(Some(GrowthLaw::Exp { tau_min: 46.0 }), None), Stages::One)]
    {
        let mut cell = Cell::new(clock, Exact::cold(stages, 46.0, 46.0)).cold();
        assert!(cell.controller.take_messages().is_empty(), "nothing is lost at the first start");
        cell.run(60.0);
        cell.controller.take_messages();
        cell.call("tcColdStart");
        let shown = cell.controller.take_messages();
        assert_eq!(shown.len(), 1, "{shown:?}");
        assert_eq!(shown[0].text, "Warm-up clock set to 0, it stood at minute 60");
        assert_eq!(cell.number("tcMinute"), 0.0);
        cell.call("tcColdStart");
        cell.call("tcWarmStart");
        assert!(cell.controller.take_messages().is_empty());
    }
}
