//! The clock's text: cases of the schedule, marks that are filled, laws that are refused.

use super::*;
use crate::schedule::{Bucket, Course, Moment, TimeFunctions};

fn schedule(edges: &[f64], parts_per_min: u32) -> Schedule {
    let bucket =
        |i: usize| Bucket { from_min: edges[i], to_min: edges.get(i + 1).copied(), at_min: edges[i] };
    Schedule { buckets: (0..edges.len()).map(bucket).collect(), parts_per_min }
}

fn warmth(growth: Option<GrowthLaw>, tau_cool_min: Option<f64>) -> Clock {
    let growth = growth.map_or(DriftGrowth::Table(None), DriftGrowth::Law);
    Clock::Warmth { growth, tau_cool_min, gap_min: 5.0 }
}

#[test]
fn every_part_has_its_case_and_the_last_bucket_is_the_default() {
    let lines = cases(&schedule(&[0.0, 2.5, 30.0, 180.0], 10));
    let mut numbers = Vec::new();
    let mut bucket_of = Vec::new();
    for line in lines.iter().map(|l| l.trim()) {
        if let Some(k) = line.strip_prefix("tcNew:=") {
            bucket_of.resize(numbers.len(), k.trim_end_matches(';').parse::<usize>().unwrap());
        } else if line != "DEFAULT:" {
            let list = line.trim_start_matches("CASE ").trim_end_matches([',', ':']);
            numbers.extend(list.split(',').map(|n| n.parse::<u32>().unwrap()));
        }
    }
    assert_eq!(numbers, (0..1800).collect::<Vec<u32>>());
    assert_eq!((bucket_of[24], bucket_of[25], bucket_of[299], bucket_of[300]), (0, 1, 1, 2));
    assert_eq!(lines[lines.len() - 2..], ["      DEFAULT:", "        tcNew:=3;"]);
    assert!(lines.iter().all(|l| l.len() < 140));
}

#[test]
fn one_bucket_is_a_test_too() {
    let lines = cases(&schedule(&[0.0], 1));
    let text: Vec<&str> = lines.iter().map(|l| l.trim()).collect();
    assert_eq!(text, ["CASE 0:", "tcNew:=0;", "DEFAULT:", "tcNew:=0;"]);
}

#[test]
fn no_mark_is_left_and_names_begin_with_tc() {
    let two = Some(GrowthLaw::TwoStage { tau_min: 46.0 });
    let sensor = Clock::Sensor { source: Sensor::Signal("aiJoint2".into()), hold_min: 10.0, stale_min: 60.0 };
    let schedule = schedule(&[0.0, 10.0, 60.0], 1);
    let knots = TimeFunctions {
        nodes: vec![Moment::Minute(30.0), Moment::Settled],
        course: Course::Knots {
            at_min: (0..90).map(|k| f64::from(k) * 7.5).collect(),
            values: (0..90).map(|k| vec![f64::from(k) / 89.0, 0.123_456_78]).collect(),
        },
    };
    let functions = [TimeFunctions::share(), TimeFunctions::share_squared(77.0), knots];
    for clock in [warmth(two, None), warmth(None, Some(30.0)), Clock::Elapsed, sensor] {
        let names = Names::default();
        let range_c = matches!(clock, Clock::Sensor { .. }).then_some([15.0, 40.0]);
        let law = Law::of(&clock, range_c).unwrap();
        let scaled = functions.iter().map(|functions| {
            let live = None;
            Choice::Scale(Box::new(Scaled {
                functions,
                poses: true,
                one_of: true,
                joints: true,
                normalise: true,
                live,
            }))
        });
        for choice in scaled.chain([Choice::Bucket(&schedule)]) {
            let core = CoreText { law: &law, growth: two, choice, task_data: true, touch: None };
            let (lines, data) = (core.routines(&names), core.data(&names));
            let text = lines.join("\n");
            assert!(!text.contains('@') && text.is_ascii(), "{text}");
            assert!(lines.iter().chain(&data).all(|l| l.len() <= 200), "{text}");
            for line in lines.iter().chain(&data) {
                let words: Vec<&str> =
                    line.split([' ', '(', '{', ':', ',', ')']).filter(|w| !w.is_empty()).collect();
                for at in 0..words.len().saturating_sub(1) {
                    if ["PROC", "num", "string", "bool", "pose", "robtarget"].contains(&words[at]) {
                        assert!(words[at + 1].starts_with("tc"), "{line}");
                    }
                }
            }
            for string in text.split('"').skip(1).step_by(2) {
                assert!(string.len() <= 80, "{string}");
            }
            let s4c = CoreText { task_data: false, ..core }.data(&names).join("\n");
            assert!(data.join("\n").contains("TASK PERS") && !s4c.contains("TASK"));
        }
    }
}

#[test]
fn a_table_without_cooling_is_refused() {
    assert_eq!(Law::of(&warmth(None, None), None), Err(EmitError::CoolingUnknown));
    let growth = Some(GrowthLaw::Exp { tau_min: 46.0 });
    for absurd in [0.0, 1e-300, 1e300] {
        let refused = Law::of(&warmth(growth, Some(absurd)), None);
        assert!(matches!(refused, Err(EmitError::BadTime { .. })), "{absurd:?}");
    }
    assert!(matches!(
        Law::of(
            &Clock::Warmth {
                growth: DriftGrowth::Law(GrowthLaw::None),
                tau_cool_min: None,
                gap_min: f64::NAN
            },
            None
        ),
        Err(EmitError::BadTime { .. })
    ));
    assert_eq!(Law::of(&warmth(Some(GrowthLaw::None), None), None), Ok(Law::Elapsed));
}

#[test]
fn a_measured_temperature_wants_a_table_by_it_and_a_good_name() {
    let sensor =
        |name: &str| Clock::Sensor { source: Sensor::Pers(name.into()), hold_min: 10.0, stale_min: 60.0 };
    let range_c = Some([15.0, 40.0]);
    assert!(Law::of(&sensor("nTemp"), range_c).is_ok());
    let other = |by_temperature| Err(EmitError::ClockOfOtherKind { by_temperature });
    assert_eq!(Law::of(&sensor("nTemp"), None), other(false));
    assert_eq!(Law::of(&Clock::Elapsed, range_c), other(true));
    for bad in ["", "1a", "a b", "a;", "tcTemp", "x\u{fc}"] {
        assert!(matches!(Law::of(&sensor(bad), range_c), Err(EmitError::BadSensor { .. })), "{bad}");
    }
}
