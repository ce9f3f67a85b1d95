//! What the text of the clock says differently for each law: how a warm start begins, what the index is called, and the law's own
//! numbers.
//!
//! Knows nothing of buckets and corrections.

use super::amount::Amount;
use super::{BEYOND, Law};
use crate::emit::touch::Lags;
use rapid_syntax::{num, operand};

impl Law {
    /// The state of a robot that is fully warm, as `tcWarmStart` begins with it; `last_min`: where the last bucket begins.
    pub(super) fn warm_state(&self, amount: Amount, last_min: f64) -> String {
        let full = amount.full();
        match self {
            Self::TwoStage { .. } => format!("{full},{full}"),
            Self::OneLag { .. } => format!("{full},0"),
            Self::Elapsed | Self::Sensor { .. } => format!("{},0", num(last_min.ceil() + 1.0)),
        }
    }

    /// The call that begins with a robot which has worked for `tcRunMinutes`.
    pub(super) fn start_at(&self, amount: Amount) -> String {
        match self {
            Self::TwoStage { tau_min, .. } => {
                let lag = format!("tcLags(tcRunMinutes,{})", amount.tau(*tau_min, "tcTau"));
                let [first, second] = [format!("1-Exp(-{lag})"), format!("1-(1+{lag})*Exp(-{lag})")]
                    .map(|share| amount.times(&share));
                format!("tcBegin tcPart({first}),\n        tcPart({second});")
            }
            Self::OneLag { tau_min, .. } => {
                let lag = format!("tcLags(tcRunMinutes,{})", amount.tau(*tau_min, "tcTau"));
                format!("tcBegin tcPart({}),0;", amount.times(&format!("1-Exp(-{lag})")))
            }
            Self::Elapsed | Self::Sensor { .. } => "tcBegin tcRunMinutes,0;".to_owned(),
        }
    }

    /// The lags that a touch measures; of a clock without any, one that means nothing.
    pub(super) fn lags(&self) -> Lags {
        match *self {
            Self::TwoStage { tau_min, tau_cool_min, .. } => Lags { two: true, tau_min, tau_cool_min },
            Self::OneLag { tau_min, tau_cool_min, .. } => Lags { two: false, tau_min, tau_cool_min },
            Self::Elapsed | Self::Sensor { .. } => Lags { two: false, tau_min: 1.0, tau_cool_min: 1.0 },
        }
    }

    /// What the index is, the expression that gives it, and what is said where it is not known or cannot be.
    pub(super) fn wording(&self) -> [&'static str; 4] {
        match self {
            Self::Sensor { .. } => [
                "the temperature",
                "tcAbove()",
                "No temperature yet: original targets",
                "Temperature lost, out of range or stale: original targets",
            ],
            Self::TwoStage { .. } | Self::OneLag { .. } | Self::Elapsed => [
                "the warm-up minute",
                "tcMinute",
                "Warm-up not known, call tcColdStart or tcWarmStart: original targets",
                "Warm-up state or date cannot be, call tcColdStart: original targets",
            ],
        }
    }

    /// What stands for the marks of this law alone.
    pub(super) fn numbers(&self, amount: Amount) -> Vec<(&'static str, String)> {
        match self {
            Self::Sensor { read, range_c: [low_c, high_c], hold_min, stale_min } => {
                let beyond_c = BEYOND * (high_c - low_c);
                vec![
                    ("@READ@", read.clone()),
                    ("@LOW@", num(low_c - beyond_c)),
                    ("@HIGH@", num(high_c + beyond_c)),
                    ("@FROM@", operand(*low_c)),
                    ("@HOLD@", num(*hold_min)),
                    ("@STALE@", num(*stale_min)),
                ]
            }
            Self::TwoStage { tau_min, tau_cool_min, gap_min }
            | Self::OneLag { tau_min, tau_cool_min, gap_min } => vec![
                ("@MINUTE@", amount.minute(*tau_min)),
                ("@TAU@", amount.tau(*tau_min, "tcTau")),
                ("@TABLE_TAU@", num(*tau_min)),
                ("@TAU_COOL@", amount.tau(*tau_cool_min, "tcTauCool")),
                ("@GAP@", num(*gap_min)),
            ],
            Self::Elapsed => Vec::new(),
        }
    }
}
