//! Touches that are no measurement of this robot, and those that a person should look at.

use super::recipe;
use exam::rng::Rng;
use exam::touch::touches;
use measurements::{Touch, Touches};
use nalgebra::Vector3;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use warm_up::{FitOptions, fit};

/// Those that take seconds: `cargo test --test it -- --ignored long::`.
mod long {
    use super::*;

    /// A fit of touches in other units would be a table for another arm; one of rounded or late ones is said to be that.
    #[test]
    #[ignore = "long"]
    fn touches_in_other_units_are_refused_and_doubtful_ones_are_named() {
        let robot = Robot::built_in("irb140").unwrap();
        let csv =
            touches(&robot, &recipe(0.01, Deformation::paper().settled().0), &mut Rng::new(3, 0)).unwrap();
        let sound = Touches::from_csv(csv.as_bytes()).unwrap();
        let options = FitOptions { tool_m: Vector3::new(0.0, 0.0, 0.1), stops: None };
        type Change<'c> = &'c dyn Fn(usize, &mut Touch);
        let first_q2 = |point| sound.touches.iter().find(|touch| touch.point == point).unwrap().q_rad[1];
        let changed = |change: Change<'_>| {
            let mut touches = sound.clone();
            touches.touches.iter_mut().enumerate().for_each(|(k, touch)| change(k, touch));
            fit(&touches, &robot, &options)
        };
        let refusals: [(Change<'_>, &str); 3] = [
            (&|_, touch| touch.q_rad = touch.q_rad.map(f64::to_radians), "are in radians"),
            (&|_, touch| touch.q_rad.swap(1, 2), "outside the range"),
            (
                &|k, touch| {
                    if k >= 90 {
                        touch.t_min *= 60.0;
                    }
                },
                "t_min is in seconds in 95 rows",
            ),
        ];
        for (change, reason) in refusals {
            let error = changed(change).unwrap_err();
            assert_eq!(error.code(), "measure::fault");
            assert!(error.to_string().contains(reason), "{error}");
        }
        assert_eq!(changed(&|_, _| {}).unwrap().warnings, []);
        let doubtful: [(Change<'_>, &str, &str); 3] = [
            (&|_, touch| touch.t_min += 480.0, "fit::minutes", "the first touch is at minute 480"),
            (
                &|_, touch| {
                    touch.q_rad[0] = ((100.0 * touch.q_rad[0].to_degrees()).round() / 100.0).to_radians();
                },
                "fit::rounded",
                "column q1_deg is rounded to 0.01 deg",
            ),
            (&|_, touch| touch.q_rad[1] = first_q2(touch.point), "fit::frozen", "column q2_deg is the same"),
        ];
        for (change, code, reason) in doubtful {
            let found = changed(change).expect(reason).warnings;
            assert!(
                found.iter().any(|w| w.code == code && w.message.contains(reason)),
                "{reason}: {found:?}"
            );
        }
        // 225 minutes as seconds are 9.4 days.
        let seconds: Diagnostic = changed(&|_, touch| touch.t_min *= 60.0).unwrap_err().into();
        assert!(seconds.help.as_ref().is_some_and(|help| help.contains("over 9 days")), "{seconds:?}");
    }
}
