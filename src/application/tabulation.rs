//! Joints of a list of targets at every minute of warm-up: the reference paper's offline method.

use crate::report::tabulation as report;
use rapid_compensation::compensate::tabulate::{MinuteErrors, MinuteTable, TabulateError, tabulate};
use rapid_compensation::compensate::targets::NamedPose;
use robot_model::deform::Deformation;
use robot_model::kinematics::Configuration;
use robot_model::robot::Robot;
use std::io::{self, Write};

/// Tabulates the joints with which the warm arm stands on targets, minute by minute.
#[derive(Clone, Debug)]
pub struct Tabulation {
    /// The robot as its model says.
    pub robot: Robot,
    /// How it deforms as it warms up.
    pub deformation: Deformation,
    /// The branch for all targets; `None`: nearest to the previous target's joints, the first nearest to zero.
    pub configuration: Option<Configuration>,
    /// Warm-up minutes at which joints are given.
    pub minutes: Vec<f64>,
}

impl Tabulation {
    /// The reference paper's minutes: 0 to 180, each.
    #[must_use]
    pub fn new(robot: Robot, deformation: Deformation) -> Self {
        let minutes = (0..=180).map(f64::from).collect();
        Self { robot, deformation, configuration: None, minutes }
    }

    /// The joints of each target at each minute.
    ///
    /// # Errors
    /// A target that the arm cannot stand on, nominal or deformed.
    pub fn run(&self, targets: Vec<NamedPose>) -> Result<Tabulated, TabulateError> {
        let Self { robot, deformation, configuration, minutes } = self;
        let table = tabulate(robot, deformation, &targets, configuration.as_ref(), minutes)?;
        let errors_by_minute = table.errors_by_minute();
        Ok(Tabulated { targets, table, errors_by_minute })
    }
}

/// Joints of targets, minute by minute.
#[derive(Clone, Debug)]
pub struct Tabulated {
    /// The targets, in their order.
    pub targets: Vec<NamedPose>,
    /// The joints with which the arm stands on them, minute by minute.
    pub table: MinuteTable,
    /// How far they are missed before and after, minute by minute.
    pub errors_by_minute: Vec<MinuteErrors>,
}

impl Tabulated {
    /// The joints as CSV; `file` is that of the targets.
    ///
    /// # Errors
    /// Those of writing to `out`.
    pub fn write_joints(&self, file: &str, out: &mut dyn Write) -> io::Result<()> {
        report::write_joints(out, file, &self.targets, &self.table)
    }

    /// How much there is, and how far targets are missed before and after, for people.
    #[must_use]
    pub fn text(&self) -> String {
        report::text(&self.targets, &self.table, &self.errors_by_minute)
    }

    /// The JSON of the contract.
    #[must_use]
    pub fn json(&self) -> serde_json::Value {
        report::json(&self.targets, &self.table, &self.errors_by_minute)
    }
}
