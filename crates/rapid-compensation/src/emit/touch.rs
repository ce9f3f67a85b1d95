//! `tcTouch` as RAPID: the thermal state measured at a fixed point, and what the clock keeps for it.
//!
//! The filter is [`thermal_filter`](robot_model::deform::thermal_filter)'s; its RAPID stands in `clock/touch*.mod`. The clock
//! carries on how the lags depend on what was known at the last touch, so that a touch needs no history.

use crate::emit::record_text::pose;
use nalgebra::{Isometry3, Vector3};
use rapid_program::LocalName;
use rapid_syntax::{num, operand};
use robot_model::deform::thermal_filter as filter;
use robot_model::units::{deg_from_rad, mm_from_m};

const DATA: &str = include_str!("clock/data_touch.mod");
const TOUCH: &str = include_str!("clock/touch.mod");
const STANDS: &str = include_str!("clock/touch_stands.mod");
const STANDS_S4C: &str = include_str!("clock/touch_stands_s4c.mod");
const FRAMES_S4C: [&str; 3] = [
    "  LOCAL CONST pose tcTouchAt:=@POSE_AT@;",
    "  LOCAL CONST pose tcTouchTool:=@POSE_HELD@;",
    "  LOCAL CONST pose tcTouchOn:=@POSE_ON@;",
];
const SEARCH: &str = include_str!("clock/touch_search.mod");
const ROUTINE: &str = include_str!("clock/touch_routine.mod");
const LOG: &str = include_str!("clock/touch_log.mod");
const LOG_DATA: [&str; 2] = ["  TASK PERS string tcLogFile:=\"\";", "  LOCAL PERS num tcLogged{3}:=[0,0,0];"];

/// What `tcTouch` touches and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Touch {
    /// What the point is called.
    pub name: String,
    /// Names of the target, the tool and the work object.
    pub point: [String; 3],
    /// How the point is found.
    pub by: TouchBy,
    /// One standard deviation of a coordinate of what is found, metres.
    pub sigma_m: f64,
    /// Each touch is written to a file in HOME, as `driftpost state` reads it.
    pub log: bool,
    /// Those of the three, and of the routine, that are LOCAL to their modules.
    pub local: Vec<LocalName>,
    /// Target, tool and work object as they were reckoned with.
    pub frames: TouchFrames,
    /// Nominal joints at the point, radians.
    pub q_rad: [f64; 6],
    /// By how much the cold arm must be told to go elsewhere to touch it, in the work object's axes, metres.
    pub cold_m: Vector3<f64>,
    /// By how much further the settled one must be, metres.
    pub settled_m: Vector3<f64>,
}

/// A target, a tool and a work object: what a controller without `CalcJointT` knows the joints by.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TouchFrames {
    /// The target in the work object, metres.
    pub object_from_tcp: Isometry3<f64>,
    /// `cf1`, `cf4`, `cf6` and `cfx` of the target.
    pub conf: [i32; 4],
    /// The tool's tip on the flange, metres.
    pub flange_from_tcp: Isometry3<f64>,
    /// The work object in the base, metres.
    pub base_from_object: Isometry3<f64>,
}

/// The lags of warmth that a clock keeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lags {
    /// Two in a row, not one.
    pub two: bool,
    /// Time constant of warming, minutes.
    pub tau_min: f64,
    /// Time constant of cooling, minutes.
    pub tau_cool_min: f64,
}

/// The largest amount for which the form `schedule` has buckets: touches may find so many times the table's settled drift.
pub const MAX_AMOUNT: f64 = 1.5;

/// Touches that one call of `tcTouch` makes at most: one, one more where it surprises, a third where the two do not agree.
const TRIES: u32 = 3;

/// How the point is found.
#[derive(Clone, Debug, PartialEq)]
pub enum TouchBy {
    /// Three searches towards a sphere's centre.
    Search {
        /// The signal of a touch.
        signal: String,
        /// From the sphere's centre to the tip's where they touch, metres.
        radius_m: f64,
        /// Searches begin and end so far from there, metres.
        margin_m: f64,
    },
    /// A procedure of the program: `PROC name(robtarget expected,INOUT robtarget found)`.
    Routine(String),
}

impl Touch {
    /// The data declarations, one a line; `s4c`: of an S4C controller.
    #[must_use]
    pub fn data(&self, s4c: bool) -> Vec<String> {
        let frames = FRAMES_S4C.iter().copied().filter(|_| s4c);
        let log = LOG_DATA.iter().copied().filter(|_| self.log);
        DATA.lines().chain(log).chain(frames).map(str::to_owned).collect()
    }

    /// The texts of the routines: the one to call, the one that knows the point again, the one it is found by, the one that logs.
    ///
    /// An S4C controller has no `CalcJointT`: it knows the point again by its frames.
    #[must_use]
    pub fn routines(&self, s4c: bool) -> Vec<&'static str> {
        let stands = if s4c { STANDS_S4C } else { STANDS };
        let probe = if matches!(self.by, TouchBy::Search { .. }) { SEARCH } else { ROUTINE };
        [TOUCH, stands, probe].into_iter().chain(self.log.then_some(LOG)).collect()
    }

    /// What stands for each `@NAME@`; `largest_m`: the largest settled correction of the program, metres.
    #[must_use]
    pub fn numbers(&self, lags: &Lags, largest_m: f64) -> Vec<(&'static str, String)> {
        let mut numbers = self.filter_numbers(lags, largest_m);
        numbers.extend(self.place_numbers());
        numbers.extend(self.by.numbers());
        numbers
    }

    /// The numbers of the filter, and of the point that it looks at.
    fn filter_numbers(&self, lags: &Lags, largest_m: f64) -> Vec<(&'static str, String)> {
        let Lags { two, tau_min, tau_cool_min } = *lags;
        let seen = if two { 2.0 } else { 1.0 };
        let settled = self.settled_m.map(mm_from_m);
        let square = settled.norm_squared();
        let variance = mm_from_m(self.sigma_m).powi(2);
        let both = filter::FIRST_CORRELATION * filter::FIRST_SIGMA[0] * filter::FIRST_SIGMA[1];
        let first = |i: usize, j: usize| match (i, j) {
            _ if i == j => filter::FIRST_SIGMA[i].powi(2),
            (0, 1) | (1, 0) => both,
            _ => 0.0,
        };
        let row = |i: usize| (0..5).map(|j| num(first(i, j))).collect::<Vec<_>>().join(",");
        let known: Vec<String> = (0..5).map(|i| format!("[{}]", row(i))).collect();
        let hour = |i: usize| num(filter::HOUR_SIGMA[i].powi(2));
        let [point, tool, wobj] = &self.point;
        let lag =
            |name: &str, k: usize| format!("tcHeld({name}+tcG{{2,{k}}}*tcOff,0,{})", num(filter::MOST_SHARE));
        let agree = filter::AGREE.powi(2) * 2.0 * variance / square;
        let mut numbers = vec![
            ("@NAME@", self.name.clone()),
            ("@COLD@", self.cold_target()),
            ("@POINT@", point.clone()),
            ("@TOOL@", format!("{tool}\\WObj:={wobj}")),
            ("@SECOND_HALF@", if two { "tcPart(tcAmount/2)".to_owned() } else { "0".to_owned() }),
            ("@DX@", operand(settled.x)),
            ("@DY@", operand(settled.y)),
            ("@DZ@", operand(settled.z)),
            ("@SQUARE@", num(square)),
            ("@PER_SQUARE@", num(1.0 / square)),
            ("@R@", num(variance / square)),
            ("@ACROSS@", num(filter::GATE_ACROSS * variance)),
            ("@GATE@", num(filter::GATE * filter::GATE)),
            ("@AGREE@", num(agree)),
            ("@PLAIN@", num(filter::GATE.powi(2) * variance / square)),
            ("@TRIES@", TRIES.to_string()),
            ("@RHO@", num(filter::FIRST_CORRELATION)),
            ("@LEAST@", num(-filter::GATE * (variance / square).sqrt())),
            ("@SEEN@", num(seen)),
            ("@LARGEST@", num(mm_from_m(largest_m.max(self.settled_m.norm())))),
            ("@VARIANCE@", variance_seen(seen)),
            ("@QSEEN@", hour(if two { 1 } else { 0 })),
            ("@KNOWN@", known.join(",")),
            ("@LAG1@", lag("tcLag1", 1)),
            ("@LAG2@", if two { lag("tcHas", 2) } else { "0".to_owned() }),
            ("@P11@", num(first(0, 0))),
            ("@P12@", num(first(0, 1))),
            ("@P22@", num(first(1, 1))),
            ("@AMOUNT_LEAST@", num(filter::LEAST_AMOUNT)),
            ("@TAU_LEAST@", num(tau_min / filter::MOST_TAU)),
            ("@TAU_MOST@", num(tau_min * filter::MOST_TAU)),
            ("@COOL_LEAST@", num(tau_cool_min / filter::MOST_TAU)),
            ("@COOL_MOST@", num(tau_cool_min * filter::MOST_TAU)),
            ("@TABLE_TAU_COOL@", num(tau_cool_min)),
            ("@TABLE_TAU@", num(tau_min)),
        ];
        numbers.extend(["@Q11@", "@Q22@", "@Q33@", "@Q44@", "@Q55@"].into_iter().zip((0..5).map(hour)));
        numbers
    }

    /// The target that the cold arm must be told to go to.
    fn cold_target(&self) -> String {
        let [point, ..] = &self.point;
        match self.cold_m.map(mm_from_m) {
            cold if cold == Vector3::zeros() => point.clone(),
            cold => format!("Offs({point},{},{},{})", num(cold.x), num(cold.y), num(cold.z)),
        }
    }

    /// Target, tool and work object as numbers, and the joints there.
    fn place_numbers(&self) -> Vec<(&'static str, String)> {
        let [_, tool, wobj] = &self.point;
        let [cf1, cf4, cf6, cfx] = self.frames.conf.map(|cf| format!("({cf})"));
        let mut numbers = vec![("@CF1@", cf1), ("@CF4@", cf4), ("@CF6@", cf6), ("@CFX@", cfx)];
        numbers.extend([
            ("@HELD@", tool.clone()),
            ("@ON@", wobj.clone()),
            ("@POSE_AT@", pose(&self.frames.object_from_tcp)),
            ("@POSE_HELD@", pose(&self.frames.flange_from_tcp)),
            ("@POSE_ON@", pose(&self.frames.base_from_object)),
        ]);
        let [q1, q2, q3, q4, q5, q6] = self.q_rad.map(|q| format!("({})", num(deg_from_rad(q))));
        numbers.extend([("@Q1@", q1), ("@Q2@", q2), ("@Q3@", q3), ("@Q4@", q4), ("@Q5@", q5), ("@Q6@", q6)]);
        numbers
    }
}

impl TouchBy {
    fn numbers(&self) -> Vec<(&'static str, String)> {
        match self {
            Self::Search { signal, radius_m, margin_m } => vec![
                ("@SIGNAL@", signal.clone()),
                ("@RADIUS@", num(mm_from_m(*radius_m))),
                ("@FAR@", num(mm_from_m(radius_m + margin_m))),
                ("@NEAR@", num(mm_from_m(radius_m - margin_m))),
            ],
            Self::Routine(name) => vec![("@ROUTINE@", name.clone())],
        }
    }
}

/// The variance of what a touch sees as an expression: its row of the observation on both sides of the covariance; `seen` is the
/// number of the row.
fn variance_seen(seen: f64) -> String {
    let seen_row = |k: usize| format!("tcTo{{{seen},{k}}}");
    let of_known = |k: usize| {
        (1..=5).map(|j| format!("{}*tcKnown{{{k},{j}}}", seen_row(j))).collect::<Vec<_>>().join("+")
    };
    let sum: Vec<String> = (1..=5).map(|k| format!("{}*({})", seen_row(k), of_known(k))).collect();
    sum.join("\n      +")
}
