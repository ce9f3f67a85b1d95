//! What the clock's text reckons with: the drift and the time constants of the table, or what touches have taught of them.

use crate::emit::touch::MAX_AMOUNT;
use rapid_syntax::num;
use robot_model::deform::thermal_filter::MOST_SHARE;

/// Where the amount of drift and the time constants come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Amount {
    /// The table: numbers in the text.
    OfTable,
    /// Touches of a fixed point: the data `tcAmount`, `tcTau`, `tcTauCool` and `tcHas`.
    Learnt,
}

impl Amount {
    /// All of the drift.
    pub(super) fn full(self) -> &'static str {
        match self {
            Self::OfTable => "1",
            Self::Learnt => "tcAmount",
        }
    }

    /// So much of all of it.
    pub(super) fn times(self, share: &str) -> String {
        match self {
            Self::OfTable => share.to_owned(),
            Self::Learnt => format!("tcAmount*({share})"),
        }
    }

    /// A time constant, minutes, or the name of the data that hold it.
    pub(super) fn tau(self, tau_min: f64, name: &str) -> String {
        match self {
            Self::OfTable => num(tau_min),
            Self::Learnt => name.to_owned(),
        }
    }

    /// No state holds more of the table's drift.
    pub(super) fn most(self) -> f64 {
        match self {
            Self::OfTable => 1.0,
            Self::Learnt => MOST_SHARE,
        }
    }

    /// What has come of the drift, where `tcE` of it is still to come.
    pub(super) fn grown(self) -> &'static str {
        match self {
            Self::OfTable => "    tcWarm:=tcPart(1-tcE);",
            Self::Learnt => "    tcWarm:=tcHas;",
        }
    }

    /// The warm-up minute, where `tcE` of the drift is still to come; the table's time constant in minutes.
    pub(super) fn minute(self, tau_min: f64) -> String {
        match self {
            Self::OfTable => "    tcMinute:=tcMinuteOf(tcE);".to_owned(),
            Self::Learnt => format!(
                "    tcHas:=tcPart(tcAmount-tcE);\n    tcMinute:=tcTau/{}*tcMinuteOf(tcE/tcAmount);",
                num(tau_min)
            ),
        }
    }

    /// What buckets are chosen by: the index itself, or the share of the amplified table as the minute at which a cold robot
    /// has it.
    pub(super) fn index(self, index: &str) -> String {
        match self {
            Self::OfTable => index.to_owned(),
            Self::Learnt => format!("tcMinuteOf(1-tcHas/{})", num(MAX_AMOUNT)),
        }
    }
}
