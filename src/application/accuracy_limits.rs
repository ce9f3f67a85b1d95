//! Limits of a robot's performance, and whether the measured poses tell if they are kept.

use measurements::{Performance, PosePerformance};
use rapid_syntax::diagnostic::counted;
use robot_model::units::mm_from_m;
use std::collections::BTreeSet;

/// Poses that ISO 9283 asks for; of fewer, where the file has more, nothing is passed.
const POSES: usize = 5;
/// Cycles of a pose that tell its repeatability: two lie equally far from their middle, whatever the robot's scatter.
const CYCLES: usize = 3;

/// What became of a limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitVerdict {
    /// Every pose that tells it keeps it.
    Within,
    /// A pose is beyond it.
    Beyond,
    /// None is beyond it, and too few poses tell of it.
    NotJudged,
}

impl LimitVerdict {
    fn word(self) -> &'static str {
        match self {
            Self::Within => "within",
            Self::Beyond => "beyond",
            Self::NotJudged => "not_judged",
        }
    }
}

/// A limit that was given.
#[derive(Clone, Debug, PartialEq)]
pub struct LimitCheck {
    /// The option that gives it.
    pub option: &'static str,
    /// What it allows, mm.
    pub limit_mm: f64,
    /// The worst that was measured, mm.
    pub worst_mm: f64,
    /// How many commanded poses tell of it.
    pub poses: usize,
    /// How many have to.
    pub needed: usize,
    /// Whether it is kept.
    pub verdict: LimitVerdict,
    what: &'static str,
}

impl LimitCheck {
    /// A limit held against the worst that was measured.
    pub(super) fn new(quantity: &Quantity, limit_mm: f64, worst_m: f64, found: &Performance) -> Self {
        let poses = commanded(found, quantity.tells);
        let (worst_mm, needed) = (mm_from_m(worst_m), commanded(found, |_| true).min(POSES));
        let verdict = match (worst_mm > limit_mm, poses < needed) {
            (true, _) => LimitVerdict::Beyond,
            (false, true) => LimitVerdict::NotJudged,
            (false, false) => LimitVerdict::Within,
        };
        let Quantity { option, what, .. } = *quantity;
        Self { option, limit_mm, worst_mm, poses, needed, verdict, what }
    }

    /// The option with its value, as the command line has it.
    #[must_use]
    pub fn text(&self) -> String {
        format!("{} {}", self.option, self.limit_mm)
    }

    /// Of how few poses it is told, of how many.
    fn shortfall(&self, all: usize) -> String {
        let Self { poses, needed, what, .. } = self;
        format!("{} ({poses} of {} {what}, {needed} are needed)", self.text(), counted(all, "pose"))
    }

    pub(super) fn json(&self) -> serde_json::Value {
        serde_json::json!({
            "limit": self.option, "limit_mm": self.limit_mm, "worst_mm": self.worst_mm,
            "poses": self.poses, "poses_needed": self.needed, "verdict": self.verdict.word(),
        })
    }
}

/// How many commanded poses there are of which `tells` holds, seen by whatever target, from whatever side, with whatever payload: several of
/// these at one pose are one pose.
pub(super) fn commanded(found: &Performance, tells: impl Fn(&PosePerformance) -> bool) -> usize {
    let of = found.poses.iter().filter(|pose| tells(pose));
    of.map(|pose| pose.pose).collect::<BTreeSet<usize>>().len()
}

/// What is limited, and which poses tell of it.
pub(super) struct Quantity {
    /// The option of its limit.
    pub(super) option: &'static str,
    what: &'static str,
    tells: fn(&PosePerformance) -> bool,
}

/// Accuracy of a pose, its repeatability, its drift.
pub(super) const QUANTITIES: [Quantity; 3] = [
    Quantity { option: "--limit-ap-mm", what: "with an accuracy", tells: |pose| pose.accuracy.is_some() },
    Quantity {
        option: "--limit-rp-mm",
        what: "measured three times and more",
        tells: |pose| pose.repeatability.is_some_and(|of| of.n >= CYCLES),
    },
    Quantity {
        option: "--limit-drift-mm",
        what: "measured at times more than 10 min apart",
        tells: |pose| pose.drift_of_accuracy_m().is_some(),
    },
];

/// Go, no go, or that it cannot be said, of limits in `all` commanded poses; `None` where there is no limit.
pub(super) fn verdict(limits: &[LimitCheck], all: usize) -> Option<String> {
    let of = |verdict| limits.iter().filter(move |limit| limit.verdict == verdict);
    let beyond: Vec<String> = of(LimitVerdict::Beyond).map(LimitCheck::text).collect();
    let not_judged: Vec<String> = of(LimitVerdict::NotJudged).map(|limit| limit.shortfall(all)).collect();
    let (beyond, not_judged) = (beyond.join(", "), not_judged.join(", "));
    match (limits, beyond.as_str(), not_judged.as_str()) {
        ([], ..) => None,
        (_, "", "") => Some("GO".to_owned()),
        (_, "", _) => Some(format!("NOT JUDGED: too few poses for {not_judged}")),
        (_, _, "") => Some(format!("NO GO: beyond {beyond}")),
        _ => Some(format!("NO GO: beyond {beyond}; too few poses for {not_judged}")),
    }
}
