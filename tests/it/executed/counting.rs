//! What a motion's argument asks is asked as often as the source asks it: a function that counts answers the same.

use super::made::{fixture, made_as, session, warmth};
use rapid_compensation::compensate::FormChoice;
use robot_model::deform::Deformation;
use robot_model::units::mm_from_m;

#[test]
fn a_function_that_counts_is_asked_as_often_as_before() {
    let (paper, original) = (Deformation::paper(), fixture("cell/counting.mod"));
    for form in [FormChoice::Schedule, FormChoice::Ramp, FormChoice::Live, FormChoice::Auto] {
        let (program, _) = made_as(form, &original, &paper, &warmth()).unwrap();
        let made = String::from_utf8_lossy(&program[0].1).into_owned();
        let asked = |text: &str| {
            text.lines()
                .filter(|line| line.contains("Move"))
                .map(|line| line.matches("nNext()").count())
                .sum::<usize>()
        };
        assert_eq!(asked(&made), 5, "{form:?}: {made}");
        let mut s = session(&program, &original, &paper, false);
        s.at_minutes(&[0.0, 60.0, 300.0]).unwrap();
        for pass in s.into_report().passes {
            assert_eq!((&pass.failure, &pass.mismatch, pass.n), (&None, &None, 7), "{form:?}");
            assert!(
                mm_from_m(pass.corrected.max_m) < 0.0055,
                "{form:?} at {}: {:?}",
                pass.t_min,
                pass.corrected
            );
        }
        // The element that an expression without a function of the program names is corrected.
        assert!(!made.contains("    MoveL pRow{Round(nAt)},v100,fine,tGun{1}"), "{form:?}: {made}");
    }
}
