//! The growth law that a scheduled table follows: what a robot's heat does while it stands goes by the law, of which the table holds the
//! values alone.

use super::{Deformation, GrowthLaw, Knot, TIMES_MIN, TableIndex, Tabulation, interpolated};

/// A growth law and how far a table departs from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedLaw {
    /// One lag or two equal ones, with the time constant to a hundredth of a minute.
    pub law: GrowthLaw,
    /// What it leaves of the table's changes, rms, as a share of theirs.
    pub left: f64,
}

/// Arm at which turns count as shifts, metres.
const ARM_M: f64 = 0.5;
/// Time constants that are looked at, shares of the table's last minute: a table that ends at a fiftieth of its course is a straight line,
/// and one that is over after its first rows a jump.
const LEAST_TAU: f64 = 0.01;
const MOST_TAU: f64 = 10.0;
const TAUS: usize = 60;
/// Halvings of the distance between two time constants that are looked at.
const FINER: usize = 30;
/// A table that departs by more than this share follows no single law.
const FOLLOWS: f64 = 0.05;
/// Decimals that a time constant is told with, minutes.
const TOLD_MIN: f64 = 0.01;

impl FittedLaw {
    /// Whether the table follows the law.
    #[must_use]
    pub fn is_followed(&self) -> bool {
        self.left <= FOLLOWS
    }
}

impl Deformation {
    /// The law by which it warms up: a static table's own; of a table scheduled by time the one of one lag, or of two equal ones, that is
    /// nearest to its rows; `None` of one by temperature, and where nothing changes.
    #[must_use]
    pub fn warm_up_law(&self) -> Option<FittedLaw> {
        match &self.0 {
            Tabulation::Static { growth, .. } => Some(FittedLaw { law: *growth, left: 0.0 }),
            Tabulation::Scheduled { index: TableIndex::Temperature, .. } => None,
            Tabulation::Scheduled { index: TableIndex::WarmUpTime, knots } => nearest(knots),
        }
    }
}

/// The law that is nearest to the rows' changes since minute 0, each with a size of its own.
fn nearest(knots: &[Vec<Knot>; 7]) -> Option<FittedLaw> {
    let courses: Vec<Vec<(f64, f64)>> = knots.iter().flat_map(|rows| courses(rows)).collect();
    let last_min = courses.iter().flatten().map(|(t_min, _)| *t_min).fold(0.0, f64::max);
    let changes: f64 = courses.iter().flatten().map(|(_, value)| value * value).sum();
    if last_min <= 0.0 || changes <= 0.0 {
        return None;
    }
    let left = |law: GrowthLaw| courses.iter().map(|course| left_of(course, law)).sum::<f64>();
    let of_kind = |kind: GrowthLaw| {
        let at = |ln_tau: f64| kind.with_tau_min(ln_tau.exp().clamp(*TIMES_MIN.start(), *TIMES_MIN.end()));
        let (from, to) = ((LEAST_TAU * last_min).ln(), (MOST_TAU * last_min).ln());
        let mut step = (to - from) / (TAUS - 1) as f64;
        let all = (0..TAUS).map(|k| from + step * k as f64);
        let mut best = all.min_by(|a, b| left(at(*a)).total_cmp(&left(at(*b)))).unwrap_or(from);
        for _ in 0..FINER {
            step *= 0.5;
            for near in [best - step, best + step] {
                if left(at(near)) < left(at(best)) {
                    best = near;
                }
            }
        }
        at(best)
    };
    let kinds = [GrowthLaw::TwoStage { tau_min: 1.0 }, GrowthLaw::Exp { tau_min: 1.0 }];
    let law = kinds.map(of_kind).into_iter().min_by(|a, b| left(*a).total_cmp(&left(*b)))?;
    let tau_min = law.tau_min().map_or(1.0, |tau_min| (tau_min / TOLD_MIN).round().max(1.0) * TOLD_MIN);
    Some(FittedLaw { law: law.with_tau_min(tau_min), left: (left(law) / changes).sqrt() })
}

/// Minute and change since minute 0 of each of a row's six numbers, metres; turns at [`ARM_M`].
fn courses(rows: &[Knot]) -> Vec<Vec<(f64, f64)>> {
    let cold = interpolated(rows, 0.0);
    (0..6)
        .map(|k| {
            let weight = if k < 3 { 1.0 } else { ARM_M };
            rows.iter().map(|row| (row.at, weight * (row.offsets[k] - cold[k]))).collect()
        })
        .collect()
}

/// Sum of squares of what the law, at the size that suits the course best, leaves of it.
fn left_of(course: &[(f64, f64)], law: GrowthLaw) -> f64 {
    let sum = |of: fn(f64, f64) -> f64| -> f64 {
        course.iter().map(|(t_min, value)| of(law.at(*t_min), *value)).sum()
    };
    let (along, grown, all) =
        (sum(|grown, value| grown * value), sum(|grown, _| grown * grown), sum(|_, value| value * value));
    if grown > 0.0 { (all - along * along / grown).max(0.0) } else { all }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(by_joint: &[GrowthLaw; 3]) -> Deformation {
        let mut csv = "t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n".to_owned();
        for t_min in (0..=180).step_by(10) {
            for (joint, law) in (1..).zip(by_joint) {
                let grown = law.at(f64::from(t_min));
                csv += &format!(
                    "{t_min},{joint},{:.9},0,{:.9},0,{:.9},0\n",
                    0.05 * grown,
                    -0.02 * grown,
                    0.004 * grown
                );
            }
            csv += &(4..=6).map(|joint| format!("{t_min},{joint},0,0,0,0,0,0\n")).collect::<String>();
        }
        Deformation::from_csv(csv.as_bytes(), None).unwrap()
    }

    #[test]
    fn a_table_that_was_written_by_a_law_has_that_law() {
        for law in [
            GrowthLaw::TwoStage { tau_min: 62.6 },
            GrowthLaw::Exp { tau_min: 35.0 },
            GrowthLaw::Exp { tau_min: 210.0 },
        ] {
            let fitted = table(&[law; 3]).warm_up_law().unwrap();
            assert!(fitted.law.is_same_kind(&law) && fitted.is_followed(), "{fitted:?}");
            let tau_min = fitted.law.tau_min().unwrap();
            assert!((tau_min / law.tau_min().unwrap() - 1.0).abs() < 1e-3, "{fitted:?}");
        }
    }

    #[test]
    fn joints_that_warm_at_different_rates_follow_no_single_law() {
        let [quick, slow] = [8.0, 150.0].map(|tau_min| GrowthLaw::Exp { tau_min });
        let fitted = table(&[quick, slow, slow]).warm_up_law().unwrap();
        assert!(!fitted.is_followed(), "{fitted:?}");
    }

    #[test]
    fn a_static_table_has_its_own_law_and_one_that_does_not_change_none() {
        let law = GrowthLaw::TwoStage { tau_min: 46.0 };
        assert_eq!(Deformation::paper().warm_up_law(), Some(FittedLaw { law, left: 0.0 }));
        assert_eq!(table(&[law; 3]).scaled(0.0).warm_up_law(), None);
    }
}
