//! The lines of each joint's gear that a model holds, with their size at the tool.

use super::outcome::RowResidual;
use inference::cause::Cause;
use nalgebra::Vector3;
use robot_model::deform::EffectKind;
use robot_model::deform::identified::{Estimate, Identified, Term};
use robot_model::kinematics::SerialChain;
use robot_model::robot::{Axis, JointKind, SerialArm};
use robot_model::units::{m_from_mm, rad_from_deg};

/// One line of a gear: the joint turns by its size times a sine of `n` periods a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GearLine {
    /// Periods per turn of the joint.
    pub n: u32,
    /// Amplitude of the sine, radians.
    pub size_rad: f64,
    /// One standard deviation of the amplitude, to first order, where the model has it.
    pub sigma_rad: Option<f64>,
    /// Named among the causes; otherwise one that the model holds beside them.
    pub is_named: bool,
}

/// All lines of one joint's gear.
#[derive(Clone, Debug, PartialEq)]
pub struct GearSpectrum {
    /// Joint that it turns with.
    pub joint: Axis,
    /// How far the measured points stand from the joint's axis, rms over the rows, metres: a turn of one radian moves the tool so far.
    pub lever_m: f64,
    /// Lines by their periods per turn, ascending.
    pub lines: Vec<GearLine>,
}

/// The gear lines of an identified model by joint, those of `causes` named; none of joints that slide.
#[must_use]
pub fn gear_spectra(
    model: &Identified,
    causes: &[Cause],
    robot: &SerialArm,
    rows: &[RowResidual],
) -> Vec<GearSpectrum> {
    let turns = |j: usize| robot.joints.get(j).is_some_and(|joint| joint.kind == JointKind::Revolute);
    (0..robot.joints.len())
        .filter(|&j| turns(j))
        .filter_map(|j| {
            let of_joint = model.terms.iter().filter(|term| term.joint == Some(Axis::at(j)));
            let mut lines: Vec<GearLine> =
                of_joint.flat_map(|term| lines_of(term, is_named(term, causes))).collect();
            sorting::by_key(&mut lines, |line| line.n);
            (!lines.is_empty()).then(|| GearSpectrum {
                joint: Axis::at(j),
                lever_m: lever_m(robot, j, rows),
                lines,
            })
        })
        .collect()
}

fn is_named(term: &Term, causes: &[Cause]) -> bool {
    let same_line = |cause: &Cause| term.kind != EffectKind::GearMesh || cause.n == term.n;
    let same_joint = |cause: &Cause| cause.joint == term.joint;
    causes.iter().any(|cause| cause.effect == term.kind && same_joint(cause) && same_line(cause))
}

fn lines_of(term: &Term, is_named: bool) -> Vec<GearLine> {
    let pair = |n: u32, values: &[Estimate]| {
        let [sin, cos] = [0, 1].map(|i| values.get(i).copied().unwrap_or_default());
        let size_rad = sin.value.hypot(cos.value);
        let sigma_rad = sin.sigma.zip(cos.sigma).map(|(of_sin, of_cos)| match size_rad > 0.0 {
            true => (sin.value * of_sin).hypot(cos.value * of_cos) / size_rad,
            false => of_sin.max(of_cos),
        });
        GearLine { n, size_rad, sigma_rad, is_named }
    };
    match term.kind {
        EffectKind::GearEccentricity => vec![pair(1, &term.values)],
        EffectKind::GearSecondHarmonic => vec![pair(2, &term.values)],
        EffectKind::GearMesh => term.n.map(|n| pair(n, &term.values)).into_iter().collect(),
        EffectKind::GearSpectrum => {
            // a line that is named stands on its own, and is 0 here
            let pairs = (1..).zip(term.values.chunks_exact(2));
            pairs.map(|(n, values)| pair(n, values)).filter(|line| line.size_rad > 0.0).collect()
        }
        _ => Vec::new(),
    }
}

fn lever_m(robot: &SerialArm, j: usize, rows: &[RowResidual]) -> f64 {
    let chain = SerialChain::nominal(robot);
    let squares: Vec<f64> = rows
        .iter()
        .filter(|row| !row.outlier)
        .map(|row| {
            let q = row.q_deg.iter().zip(&robot.joints);
            let q_rad: Vec<f64> = q
                .map(|(q, joint)| match joint.kind {
                    JointKind::Revolute => rad_from_deg(*q),
                    JointKind::Prismatic => m_from_mm(*q),
                })
                .collect();
            let base_from_joint = chain.frames(&q_rad)[j];
            let axis = base_from_joint.rotation * robot.joints[j].axis.into_inner();
            let from_joint_m =
                Vector3::from(row.point_mm.map(m_from_mm)) - base_from_joint.translation.vector;
            axis.cross(&from_joint_m).norm_squared()
        })
        .collect();
    (squares.iter().sum::<f64>() / squares.len().max(1) as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use robot_model::robot::{Joints, Robot};

    fn term(kind: EffectKind, n: Option<u32>, values: &[(f64, f64)]) -> Term {
        let values = values.iter().map(|&(value, sigma)| Estimate { value, sigma: Some(sigma) });
        Term { n, ..Term::plain(kind, Some(Axis::at(0)), values.collect()) }
    }

    /// An amplitude is the hypotenuse of its sine and cosine (3, 4, 5); the lever about joint 1 the distance from the vertical axis.
    #[test]
    fn lines_stand_by_their_periods_with_amplitude_and_lever() {
        let spectrum = [(0.0, 0.0), (0.0, 0.0), (3e-5, 1e-5), (0.0, 0.0), (0.0, 2e-5), (5e-6, 2e-5)];
        let model = Identified {
            terms: vec![
                term(EffectKind::GearMesh, Some(18), &[(3e-4, 1e-5), (-4e-4, 1e-5)]),
                term(EffectKind::GearEccentricity, None, &[(0.0, 1e-6), (2e-4, 3e-6)]),
                Term { cause: false, ..term(EffectKind::GearSpectrum, None, &spectrum) },
                // In the model, but too unlikely to be told.
                term(EffectKind::GearMesh, Some(20), &[(0.0, 1e-5), (1e-5, 1e-5)]),
                term(EffectKind::JointOffset, None, &[(1e-3, 1e-4)]),
            ],
            ..Identified::default()
        };
        let row = |point_mm, outlier| RowResidual {
            line: 2,
            id: None,
            q_deg: Joints::from([10.0, 20.0, 0.0, 0.0, 30.0, 0.0]),
            t_min: None,
            point_mm,
            before_mm: [0.0; 3],
            after_mm: [0.0; 3],
            outlier,
        };
        let rows =
            [row([300.0, 400.0, 900.0], false), row([0.0, -700.0, 0.0], false), row([9e3, 0.0, 0.0], true)];
        let robot = Robot::built_in("irb140").unwrap();
        let cause = |effect, n| Cause { joint: Some(Axis::at(0)), n, ..Cause::of(effect, 1.0) };
        let causes = [cause(EffectKind::GearMesh, Some(18)), cause(EffectKind::GearEccentricity, Some(1))];
        let [found] = gear_spectra(&model, &causes, &(&robot).into(), &rows).try_into().unwrap();
        assert_eq!(found.joint, Axis::at(0));
        assert!((found.lever_m - ((0.25_f64 + 0.49) / 2.0).sqrt()).abs() < 1e-12, "{}", found.lever_m);
        let line = |n, size_rad, sigma_rad, is_named| (n, size_rad, sigma_rad, is_named);
        let wanted = [
            line(1, 2e-4, 3e-6, true),
            line(2, 3e-5, 1e-5, false),
            line(3, 5e-6, 2e-5, false),
            line(18, 5e-4, 1e-5, true),
            line(20, 1e-5, 1e-5, false),
        ];
        assert_eq!(found.lines.len(), wanted.len());
        for (found, (n, size_rad, sigma_rad, is_named)) in found.lines.iter().zip(wanted) {
            assert_eq!((found.n, found.is_named), (n, is_named));
            assert!((found.size_rad - size_rad).abs() < 1e-15, "{found:?}");
            assert!((found.sigma_rad.unwrap() - sigma_rad).abs() < 1e-15, "{found:?}");
        }
    }
}
