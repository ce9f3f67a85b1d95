//! The growth law that a robot warms up by: what its heat does while it stands goes by one law, where a scheduled table holds the values
//! alone, and a model a law for each of its terms.

use super::identified::{Growth, Identified, Term, ThermalState, Unit};
use super::{Deformation, EffectKind, GrowthLaw, Knot, TIMES_MIN, TableIndex, Tabulation, interpolated};
use crate::kinematics::FrameOffsets;
use crate::robot::JointKind;

/// A growth law and how far the robot departs from it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FittedLaw {
    /// One lag or two equal ones, with the time constant to a hundredth of a minute.
    pub law: GrowthLaw,
    /// What it leaves of the changes, rms, as a share of theirs.
    pub left: f64,
}

/// Arm at which turns count as shifts, and lengths of which a part grows, metres.
const ARM_M: f64 = 0.5;
/// Time constants that are looked at, shares of the minutes in which most changes. A shorter one would be over before all has changed, and a
/// clock that goes by its lag in single precision would stand still; the longest is a straight line.
const LEAST_TAU: f64 = 1.0 / 16.0;
const MOST_TAU: f64 = 10.0;
const TAUS: usize = 60;
/// Halvings of the distance between two time constants that are looked at.
const FINER: usize = 30;
/// What departs by more than this share follows no single law.
const FOLLOWS: f64 = 0.05;
/// A time constant is told to one part in so many of a minute.
const TOLD_PARTS: f64 = 100.0;
/// Time constants after which the program's clock stands still: it knows the minute by a share that is still to come of 1E-33 and more.
const LAGS_OF_CLOCK: f64 = 70.0;
/// Minutes at which a course is looked at, and the time constants of its slowest law after which it is over.
const LOOKS: usize = 400;
const LAST_LAGS: f64 = 8.0;
/// All has changed where less than this share of the whole change is still to come.
const STILL_TO_COME: f64 = 0.002;
/// A law that has less of its own course behind it at the last minute is a straight line, which says nothing of where it ends: there a table holds what
/// its last row says.
const STRAIGHT: f64 = 0.3;
/// Rows in fewer minutes than these tell no law by themselves: what is straight between them counts as well.
const FEWEST_ROWS: usize = 4;

impl FittedLaw {
    /// Whether the robot follows the law.
    #[must_use]
    pub fn is_followed(&self) -> bool {
        self.left <= FOLLOWS
    }

    fn exactly(law: GrowthLaw) -> Self {
        Self { law, left: 0.0 }
    }

    /// The law, or one of its kind that is slow enough for a clock that goes by it to reach minute `until_min`.
    fn lasting(self, until_min: f64) -> Self {
        let Some(tau_min) = self.law.tau_min().filter(|tau_min| tau_min * LAGS_OF_CLOCK < until_min) else {
            return self;
        };
        let law = self.law.with_tau_min(told(until_min / LAGS_OF_CLOCK));
        let course = |law: GrowthLaw| -> Vec<f64> {
            (0..=LOOKS).map(|k| law.at(LAST_LAGS * tau_min * k as f64 / LOOKS as f64)).collect()
        };
        let own = course(self.law);
        let squares: f64 = own.iter().map(|value| value * value).sum();
        Self { law, left: self.left.hypot((left_of(&own, &course(law)) / squares).sqrt()) }
    }
}

impl Deformation {
    /// The law by which a robot warms up that deforms so, and as a model has it besides: the one by which all of it grows; else the one of
    /// one lag, or of two equal ones, that is nearest to the table's rows and the model's terms together. `None` of one by temperature, and
    /// where nothing changes.
    #[must_use]
    pub fn warm_up_law(&self, model: Option<&Identified>) -> Option<FittedLaw> {
        let terms: Vec<&Term> = model.iter().flat_map(|model| model.warming()).collect();
        let (table, until_min) = match &self.0 {
            Tabulation::Static { growth, .. } if terms.is_empty() => {
                let until_min = model.and_then(Identified::creeps_until_min).unwrap_or(0.0);
                return Some(FittedLaw::exactly(*growth).lasting(until_min));
            }
            Tabulation::Static { growth, .. } => (self.grows().then_some(Growth::Law(*growth)), 0.0),
            Tabulation::Scheduled { index: TableIndex::Temperature, .. } => return None,
            Tabulation::Scheduled { index: TableIndex::WarmUpTime, knots } => (None, last_minute(knots)),
        };
        let mut laws: Vec<Growth> = terms.iter().map(|term| term.growth).chain(table).collect();
        laws.dedup();
        let creeps_until_min = model.and_then(Identified::creeps_until_min).unwrap_or(0.0);
        if let (&[Growth::Law(law)], true) = (laws.as_slice(), self.growth().is_some()) {
            return Some(FittedLaw::exactly(law).lasting(creeps_until_min));
        }
        let last_min = laws.iter().filter_map(end_min).fold(until_min, f64::max);
        let evenly = || (0..=LOOKS).map(|k| last_min * k as f64 / LOOKS as f64).collect();
        let rows = self.row_minutes();
        let minutes: Vec<f64> = if laws.is_empty() && rows.len() >= FEWEST_ROWS { rows } else { evenly() };
        let mut courses = self.courses(&minutes);
        courses.extend(terms.iter().flat_map(|term| term.courses(&minutes)));
        nearest(&minutes, &courses).map(|fitted| fitted.lasting(creeps_until_min))
    }

    /// In how many minutes the rows of a table by warm-up time stand, minute 0 counted, where they are too few to tell a law.
    #[must_use]
    pub fn few_rows(&self) -> Option<usize> {
        let Tabulation::Scheduled { index: TableIndex::WarmUpTime, .. } = &self.0 else { return None };
        Some(self.row_minutes().len()).filter(|rows| *rows < FEWEST_ROWS)
    }

    /// Whether a static table has anything that is not there from the cold start on.
    fn grows(&self) -> bool {
        self.growth() != Some(&GrowthLaw::None) && self.settled() != FrameOffsets::default()
    }

    /// The minutes of a scheduled table's rows and minute 0, ascending.
    fn row_minutes(&self) -> Vec<f64> {
        let mut minutes = self.knots();
        minutes.retain(|t_min| *t_min > 0.0);
        minutes.insert(0, 0.0);
        minutes
    }

    /// What each number of each frame has changed by since minute 0 at these minutes, metres; turns at [`ARM_M`].
    fn courses(&self, minutes: &[f64]) -> Vec<Vec<f64>> {
        let course = |frame: usize, number: usize| -> Vec<f64> {
            let weight = if number < 3 { 1.0 } else { ARM_M };
            match &self.0 {
                Tabulation::Static { offsets, growth } => minutes
                    .iter()
                    .map(|t_min| weight * offsets.0[frame][number] * (growth.at(*t_min) - growth.at(0.0)))
                    .collect(),
                Tabulation::Scheduled { knots, .. } => {
                    let cold = interpolated(&knots[frame], 0.0)[number];
                    let at = |t_min: &f64| weight * (interpolated(&knots[frame], *t_min)[number] - cold);
                    minutes.iter().map(at).collect()
                }
            }
        };
        (0..7)
            .flat_map(|frame| (0..6).map(move |number| (frame, number)))
            .map(|(f, n)| course(f, n))
            .collect()
    }
}

impl Identified {
    /// The law by which the terms that warm up grow, or the one that is nearest to all of them; `None` where none does.
    #[must_use]
    pub fn warm_up_law(&self) -> Option<FittedLaw> {
        let nothing = Deformation::from_static(FrameOffsets::default(), GrowthLaw::None);
        nothing.warm_up_law(Some(self)).filter(|fitted| fitted.law != GrowthLaw::None)
    }

    /// The terms that grow with the arm's warmth and fall back with it. Base and target that creep from one minute to another do not.
    fn warming(&self) -> Vec<&Term> {
        let is_warm = |term: &&Term| match term.growth {
            Growth::Law(_) => true,
            Growth::Linear { .. } => !term.creeps(),
            Growth::Always | Growth::Step { .. } | Growth::Temperature { .. } => false,
        };
        self.terms.iter().filter(is_warm).filter(|term| term.drifts()).collect()
    }

    /// The terms of base and target that creep from one minute to another, whatever the arm does.
    pub fn creeping(&self) -> impl Iterator<Item = &Term> {
        self.terms.iter().filter(|term| term.creeps() && term.drifts())
    }

    /// The last minute of what creeps.
    fn creeps_until_min(&self) -> Option<f64> {
        self.creeping().filter_map(|term| end_min(&term.growth)).reduce(f64::max)
    }
}

impl Term {
    /// Whether base or target creep on from one minute to another.
    fn creeps(&self) -> bool {
        matches!(self.growth, Growth::Linear { .. })
            && matches!(self.kind, EffectKind::BaseDrift | EffectKind::ToolDrift)
    }

    /// What each of its values adds at these minutes to what is there at minute 0, metres; turns and parts of lengths at [`ARM_M`].
    fn courses(&self, minutes: &[f64]) -> Vec<Vec<f64>> {
        let at = |t_min: f64| self.growth.at(&ThermalState { t_min, joint_temperature_c: None }, self.joint);
        let grown: Vec<f64> = minutes.iter().map(|t_min| at(*t_min) - at(0.0)).collect();
        let units = self.kind.parameters(JointKind::Revolute);
        let weights = units.iter().map(|(_, unit)| match unit {
            Unit::Millimetre => 1.0,
            Unit::Degree | Unit::PartsPerMillion => ARM_M,
            Unit::Plain => 0.0,
        });
        let sizes =
            weights.zip(&self.values).take(self.growing()).map(|(weight, value)| weight * value.value);
        sizes.map(|size| grown.iter().map(|grown| size * grown).collect()).collect()
    }
}

/// The minute from which on a growth changes nothing any more; `None` of what does not grow with time.
fn end_min(growth: &Growth) -> Option<f64> {
    match *growth {
        Growth::Law(law) => law.tau_min().map(|tau_min| LAST_LAGS * tau_min),
        Growth::Linear { to_min, .. } => Some(to_min),
        Growth::Always | Growth::Step { .. } | Growth::Temperature { .. } => None,
    }
}

fn last_minute(knots: &[Vec<Knot>; 7]) -> f64 {
    knots.iter().flatten().map(|knot| knot.at).fold(0.0, f64::max)
}

/// The law that is nearest to the changes since minute 0, each with a size of its own. What goes on straight to its last minute is held there: where the law
/// is not over by then, what is held counts as well.
fn nearest(minutes: &[f64], courses: &[Vec<f64>]) -> Option<FittedLaw> {
    let &last_min = minutes.last()?;
    let changed = |k: usize| courses.iter().map(|course| course[k] * course[k]).sum::<f64>();
    let most = (0..minutes.len()).map(changed).fold(0.0, f64::max);
    if last_min <= 0.0 || most <= 0.0 {
        return None;
    }
    let still =
        |k: usize| courses.iter().map(|course| (course[minutes.len() - 1] - course[k]).powi(2)).sum::<f64>();
    let is_over = (0..minutes.len()).rev().find(|&k| still(k) > STILL_TO_COME.powi(2) * most);
    let over_min = is_over.and_then(|k| minutes.get(k + 1)).copied().unwrap_or(last_min);
    let fitted = fitted(minutes, courses, over_min)?;
    if fitted.law.at(last_min) >= STRAIGHT {
        return Some(fitted);
    }
    let steps = minutes.len() - 1;
    let held_at = (1..=steps).map(|k| last_min * (1.0 + k as f64 / steps as f64));
    let held_min: Vec<f64> = minutes.iter().copied().chain(held_at).collect();
    let held = |course: &Vec<f64>| {
        let last = course.last().copied().unwrap_or_default();
        course.iter().copied().chain(std::iter::repeat_n(last, steps)).collect()
    };
    let courses: Vec<Vec<f64>> = courses.iter().map(held).collect();
    self::fitted(&held_min, &courses, over_min)
}

fn fitted(minutes: &[f64], courses: &[Vec<f64>], over_min: f64) -> Option<FittedLaw> {
    let changes: f64 = courses.iter().flatten().map(|value| value * value).sum();
    let left = |law: GrowthLaw| -> f64 {
        let grown: Vec<f64> = minutes.iter().map(|t_min| law.at(*t_min)).collect();
        courses.iter().map(|course| left_of(course, &grown)).sum()
    };
    let of_kind = |kind: GrowthLaw| {
        let at = |ln_tau: f64| kind.with_tau_min(ln_tau.exp().clamp(*TIMES_MIN.start(), *TIMES_MIN.end()));
        let (from, to) = ((LEAST_TAU * over_min).ln(), (MOST_TAU * over_min).ln());
        let mut step = (to - from) / (TAUS - 1) as f64;
        let all = (0..TAUS).map(|k| from + step * k as f64);
        let mut best = all.min_by(|a, b| left(at(*a)).total_cmp(&left(at(*b)))).unwrap_or(from);
        for _ in 0..FINER {
            step *= 0.5;
            for near in [best - step, best + step] {
                if near >= from && left(at(near)) < left(at(best)) {
                    best = near;
                }
            }
        }
        at(best)
    };
    let kinds = [GrowthLaw::TwoStage { tau_min: 1.0 }, GrowthLaw::Exp { tau_min: 1.0 }];
    let law = kinds.map(of_kind).into_iter().min_by(|a, b| left(*a).total_cmp(&left(*b)))?;
    Some(FittedLaw { law: law.with_tau_min(told(law.tau_min()?)), left: (left(law) / changes).sqrt() })
}

/// A time constant to as many decimals as it is told with, minutes.
fn told(tau_min: f64) -> f64 {
    (tau_min * TOLD_PARTS).round().max(1.0) / TOLD_PARTS
}

/// Sum of squares of what a law, `grown` at each minute, leaves of a course at the size that suits it best.
fn left_of(course: &[f64], grown: &[f64]) -> f64 {
    let sum = |of: fn(f64, f64) -> f64| -> f64 {
        course.iter().zip(grown).map(|(value, grown)| of(*grown, *value)).sum()
    };
    let (along, squares, all) = (sum(|g, v| g * v), sum(|g, _| g * g), sum(|_, v| v * v));
    if squares > 0.0 { (all - along * along / squares).max(0.0) } else { all }
}

#[cfg(test)]
mod tests {
    use super::super::identified::Estimate;
    use super::*;
    use crate::robot::Axis;

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
            let fitted = table(&[law; 3]).warm_up_law(None).unwrap();
            assert!(fitted.law.is_same_kind(&law) && fitted.is_followed(), "{fitted:?}");
            let tau_min = fitted.law.tau_min().unwrap();
            assert!((tau_min / law.tau_min().unwrap() - 1.0).abs() < 1e-3, "{fitted:?}");
        }
    }

    #[test]
    fn joints_that_warm_at_different_rates_follow_no_single_law() {
        let [quick, slow] = [8.0, 150.0].map(|tau_min| GrowthLaw::Exp { tau_min });
        let fitted = table(&[quick, slow, slow]).warm_up_law(None).unwrap();
        assert!(!fitted.is_followed(), "{fitted:?}");
    }

    #[test]
    fn a_static_table_has_its_own_law_and_one_that_does_not_change_none() {
        let law = GrowthLaw::TwoStage { tau_min: 46.0 };
        assert_eq!(Deformation::paper().warm_up_law(None), Some(FittedLaw { law, left: 0.0 }));
        assert_eq!(table(&[law; 3]).scaled(0.0).warm_up_law(None), None);
    }

    /// Two rows say no more than a straight line, which every law is at the size that suits it: the clock's law must reach its end all the same.
    #[test]
    fn two_rows_have_a_law_that_lasts_to_the_second() {
        for last_min in [60.0, 120.0, 200.0] {
            let rows = |row: &str| {
                format!(
                    "t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n0,2,0,0,0,0,0,0\n{last_min},2,{row}\n"
                )
            };
            let table = Deformation::from_csv(rows("0,0,0,0,0.03,0").as_bytes(), None).unwrap();
            let fitted = table.warm_up_law(None).unwrap();
            let tau_min = fitted.law.tau_min().unwrap();
            // A lag in single precision tells minutes up to 16 time constants; over the second row all of it has come.
            assert!(last_min < 16.0 * tau_min && fitted.law.at(2.0 * last_min) > 0.9, "{fitted:?}");
        }
        // Quick in one joint, slow in another, to minute 600.
        let laws = [3.0, 150.0, 150.0].map(|tau_min| GrowthLaw::Exp { tau_min });
        let until = |last: usize| -> String {
            let minutes = (0..=last).step_by(20);
            let row = |t_min: usize, joint: usize| {
                let grown = laws[joint - 1].at(t_min as f64) * if joint == 1 { 0.5 } else { 0.02 };
                format!("{t_min},{joint},{grown:.9},0,0,0,0,0\n")
            };
            minutes
                .flat_map(|t_min| (1..=3).map(move |joint| (t_min, joint)))
                .map(|(t, j)| row(t, j))
                .collect()
        };
        let csv = format!("t_min,joint,dx_mm,dy_mm,dz_mm,rx_deg,ry_deg,rz_deg\n{}", until(600));
        let fitted = Deformation::from_csv(csv.as_bytes(), None).unwrap().warm_up_law(None).unwrap();
        assert!(fitted.law.tau_min().unwrap() > 15.0, "{fitted:?}");
    }

    fn model(terms: &[(u8, GrowthLaw, f64)]) -> Identified {
        let term = |&(joint, law, drift_rad): &(u8, GrowthLaw, f64)| {
            let values = [drift_rad, 0.0].map(|value| Estimate { value, sigma: None });
            let axis = Some(Axis::at(usize::from(joint)));
            Term {
                growth: Growth::Law(law),
                ..Term::plain(EffectKind::ThermalJointDrift, axis, values.to_vec())
            }
        };
        Identified { terms: terms.iter().map(term).collect(), ..Identified::default() }
    }

    #[test]
    fn the_terms_of_a_model_have_one_law_or_the_nearest_to_all_in_any_order() {
        let [quick, slow] = [15.0, 90.0].map(|tau_min| GrowthLaw::Exp { tau_min });
        let alike = model(&[(1, slow, 5e-4), (2, slow, -2e-4)]).warm_up_law();
        assert_eq!(alike, Some(FittedLaw { law: slow, left: 0.0 }));
        let [one, other] = [[(1, quick, 5e-4), (2, slow, 5e-4)], [(2, slow, 5e-4), (1, quick, 5e-4)]]
            .map(|terms| model(&terms).warm_up_law().unwrap());
        assert_eq!(one.law, other.law);
        let tau_min = one.law.tau_min().unwrap();
        assert!(!one.is_followed() && (15.0..90.0).contains(&tau_min), "{one:?}");
        // A table that is there from the cold start on has no law beside the term's.
        let cold = Deformation::from_static(Deformation::paper().settled(), GrowthLaw::None);
        let beside = cold.warm_up_law(Some(&model(&[(1, quick, 1e-3)])));
        assert_eq!(beside, Some(FittedLaw { law: quick, left: 0.0 }));
        // A table with a law of its own beside a term of another.
        let table = Deformation::paper();
        let both = table.warm_up_law(Some(&model(&[(1, quick, 1e-3)]))).unwrap();
        assert!(!both.is_followed(), "{both:?}");
        let same = GrowthLaw::TwoStage { tau_min: 46.0 };
        assert_eq!(
            table.warm_up_law(Some(&model(&[(1, same, 1e-3)]))),
            Some(FittedLaw { law: same, left: 0.0 })
        );
    }

    #[test]
    fn a_base_that_creeps_has_no_warmth_and_a_joint_that_drifts_straight_has() {
        let linear = |kind: EffectKind, values: usize| {
            let values = vec![Estimate { value: 1e-4, sigma: None }; values];
            let growth = Growth::Linear { from_min: 0.0, to_min: 120.0 };
            Identified {
                terms: vec![Term { growth, ..Term::plain(kind, Some(Axis::at(1)), values) }],
                ..Identified::default()
            }
        };
        let [creeps, drifts] = [linear(EffectKind::BaseDrift, 6), linear(EffectKind::ThermalJointDrift, 2)];
        assert_eq!(creeps.warm_up_law(), None);
        // Beside a joint that is warm in a quarter of an hour: a clock by that law would stand still after 70 lags, 210 minutes; by one of
        // 600 / 70 minutes it lasts.
        let mut both = model(&[(3, GrowthLaw::Exp { tau_min: 3.0 }, 5e-4)]);
        both.terms.push(Term {
            growth: Growth::Linear { from_min: 0.0, to_min: 600.0 },
            ..creeps.terms[0].clone()
        });
        let slow = both.warm_up_law().unwrap();
        assert_eq!(slow.law, GrowthLaw::Exp { tau_min: 8.57 });
        assert!(!slow.is_followed() && both.creeping().count() == 1, "{slow:?}");
        let mut until_200 = both.clone();
        until_200.terms[1].growth = Growth::Linear { from_min: 0.0, to_min: 200.0 };
        assert_eq!(
            until_200.warm_up_law(),
            Some(FittedLaw { law: GrowthLaw::Exp { tau_min: 3.0 }, left: 0.0 })
        );
        // Two equal lags that are nearest to a straight course of two hours, over when it ends and not long before.
        let law = drifts.warm_up_law().unwrap().law;
        assert!(law.at(120.0) > 0.8 && law.at(60.0) < 0.7, "{law}");
    }
}
