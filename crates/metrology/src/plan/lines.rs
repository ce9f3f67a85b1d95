//! What can be expected of the lines of a gear, 3 to 320 per turn of each joint: how exactly one will be known, and which
//! periods look like another over the angles that are planned.

use super::information::{APART, RIVAL, nuisance};
use crate::diagnose::SizeUnit;
use inference::effects::PERIODS;
use inference::normal_equations::LINE_RAD;
use inference::search::NAMED_NATS;
use inference::signature::Signatures;
use nalgebra::DMatrix;
use robot_model::deform::EffectKind;
use robot_model::robot::{Axis, Joints};

/// The lines of one joint's gear.
#[derive(Clone, Debug, PartialEq, serde::Serialize)]
pub struct GearLines {
    /// Always the kind `gear_mesh`.
    pub effect: EffectKind,
    /// The joint whose gear it is.
    pub joint: Axis,
    /// Unit of the sizes.
    pub unit: SizeUnit,
    /// Usual size of a sine or cosine.
    pub usual: f64,
    /// Expected standard deviation of a line, it being the only cause: the middle one over all periods.
    pub sigma: f64,
    /// From this size on it will be named.
    pub seen_from: f64,
    /// Periods that are told from every other at their usual size.
    pub told_apart: usize,
    /// Number of periods compared.
    pub of: usize,
    /// Periods with the one each is most easily taken for, hardest first: `[n, taken for]`.
    pub confounded: Vec<[u32; 2]>,
}

/// The lines of every joint over measurements at `q_rad`, in the order of `signatures`' rows; a joint whose lines
/// leave no signal is left out.
#[must_use]
pub(super) fn lines(signatures: &Signatures, q_rad: &[Joints], sigma_m: f64) -> Vec<GearLines> {
    let width = signatures.width;
    let rows = q_rad.len() * 3;
    let columns = signatures.registration + signatures.geometry;
    let surroundings = DMatrix::from_fn(rows, columns, |r, c| signatures.rows[r * width + c] / sigma_m);
    let Some(inner) = nuisance(surroundings.transpose() * &surroundings, signatures) else {
        return Vec::new();
    };
    let joint = |j: usize| {
        let columns = DMatrix::from_fn(rows, 2 * PERIODS.count(), |r, c| {
            let n = f64::from(*PERIODS.start()) + (c / 2) as f64;
            let (sin, cos) = (n * q_rad[r / 3][j]).sin_cos();
            let turn_m = signatures.turns[r / 3][j][r % 3] * LINE_RAD / sigma_m;
            turn_m * if c % 2 == 0 { sin } else { cos }
        });
        let cross = surroundings.transpose() * &columns;
        let own = columns.transpose() * &columns - cross.transpose() * inner.solve(&cross);
        of_joint(j, &own)
    };
    (0..q_rad.first().map_or(0, |q| q.len())).filter_map(joint).collect()
}

/// From what base, target and tolerances leave of all lines, two columns each, per usual size over the noise.
fn of_joint(j: usize, own: &DMatrix<f64>) -> Option<GearLines> {
    let count = own.nrows() / 2;
    let block = |a: usize, b: usize| own.fixed_view::<2, 2>(2 * a, 2 * b).into_owned();
    let alone: Vec<f64> = (0..count).map(|a| 0.5 * block(a, a).trace()).collect();
    let inverses: Vec<_> = (0..count)
        .map(|b| (block(b, b) + nalgebra::Matrix2::identity() / (RIVAL * RIVAL)).try_inverse())
        .collect();
    let mut confounded: Vec<(f64, [u32; 2])> = Vec::new();
    for a in (0..count).filter(|&a| alone[a] >= APART) {
        let left = |b: usize| {
            let with = block(b, a);
            let taken = inverses[b].map_or(0.0, |inverse| 0.5 * (with.transpose() * inverse * with).trace());
            (alone[a] - taken, b)
        };
        let nearest = (0..count).filter(|&b| b != a).map(left).reduce(|x, y| if y.0 < x.0 { y } else { x });
        if let Some((separation, b)) = nearest.filter(|n| n.0 < APART) {
            let period = |i: usize| PERIODS.start() + u32::try_from(i).unwrap_or(0);
            confounded.push((separation / alone[a], [period(a), period(b)]));
        }
    }
    sorting::by(&mut confounded, |x, y| x.0.total_cmp(&y.0).then(x.1.cmp(&y.1)));
    let mut sorted = alone.clone();
    sorting::numbers(&mut sorted);
    let middle = sorted.get(count / 2).copied().filter(|m| *m > 1e-6)?;
    let seen = alone.iter().filter(|a| **a >= APART).count();
    let sigma = LINE_RAD / middle.sqrt();
    Some(GearLines {
        effect: EffectKind::GearMesh,
        joint: Axis::at(j),
        unit: SizeUnit::Radian,
        usual: LINE_RAD,
        sigma,
        seen_from: sigma * (2.0 * NAMED_NATS).sqrt(),
        told_apart: seen - confounded.len(),
        of: count,
        confounded: confounded.into_iter().map(|c| c.1).collect(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A whole turn in steps of one degree: there n and 360 - n are one and the same, sine for sine but for the sign. Of 3
    /// to 320 those from 40 on have their mirror among them, but for 180, which is its own.
    #[test]
    fn steps_of_one_degree_mirror_the_periods_at_180() {
        let q_rad: Vec<Joints> =
            (0..360).map(|k| Joints::from([f64::from(k).to_radians(), 0.0, 0.0, 0.0, 0.0, 0.0])).collect();
        let mut turns = vec![Joints::from([[0.0; 3]; 6]); 360];
        turns.iter_mut().for_each(|turn| turn[0] = [0.5, 0.0, 0.0]);
        let signatures = Signatures {
            registration: 1,
            geometry: 0,
            effects: Vec::new(),
            width: 1,
            rows: vec![0.0; 3 * 360],
            turns,
        };
        let found = lines(&signatures, &q_rad, 2e-5);
        assert_eq!(found.len(), 1, "the other joints move nothing");
        let of = &found[0];
        assert_eq!((of.joint, of.of, of.told_apart), (Axis::at(0), 318, 38));
        assert_eq!(of.confounded.len(), 280);
        assert!(of.confounded.iter().all(|[n, other]| n + other == 360));
        // 360 squares of a sine are 180: 1e-4 rad at half a metre is 2.5 times the noise.
        let expected = 1e-4 / (180.0_f64.sqrt() * 2.5);
        assert!((of.sigma / expected - 1.0).abs() < 1e-9, "{} {expected}", of.sigma);
    }
}
