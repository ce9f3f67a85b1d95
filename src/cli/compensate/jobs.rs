//! What the options of `driftpost compensate` say to the library: one job, or one for each motion task.

use super::args::Args;
use super::option_values::{ClockName, CoreName};
use crate::application::check_absolute_accuracy;
use crate::cli::model;
use crate::cli::number::{minutes, positive};
use crate::cli::other_tasks::{TaskRobot, given_for};
use driftpost::application::{Compensation, Named};
use rapid_compensation::compensate::{JointsHint, Options, Selection};
use rapid_compensation::emit::{Clock, Core, DriftGrowth, EmitOptions};
use rapid_compensation::schedule::{Until, Width};
use rapid_program::Overrides;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use robot_model::units::{m_from_mm, rad_from_deg};
use std::sync::Arc;

/// What the options name.
#[derive(Clone, Debug)]
pub struct Models {
    /// The robot and the name it was asked for by.
    pub robot: Named<Robot>,
    /// Its deformation; none of its own beside a model.
    pub deformation: Named<Deformation>,
    /// The identified model and its file.
    pub identified: Option<Named<Identified>>,
}

impl Args {
    /// What is asked of the compensation.
    ///
    /// # Errors
    /// What is wrong with the joints hint.
    pub fn options(&self, identified: Option<&Named<Identified>>) -> Result<Options, Diagnostic> {
        let [max_m, max_rad] = Compensation::largest_correction(identified.is_some());
        Ok(Options {
            form: self.form.into(),
            model: identified.map(|named| Arc::new(named.model.clone())),
            payload_kg: self.payload_kg,
            joint_temperature_c: self.temperature_c.map(|t| t.0),
            tolerance_m: m_from_mm(self.tolerance_mm),
            until: self.until,
            width: self.bucket_min.map_or(Width::Tolerance, |width_min| Width::Fixed { width_min }),
            max_correction_m: self.max_correction_mm.map_or(max_m, m_from_mm),
            max_correction_rad: self.max_correction_deg.map_or(max_rad, rad_from_deg),
            path_tolerance_m: m_from_mm(self.path_tolerance_mm),
            keep_moveabsj: self.keep_moveabsj,
            absolute_accuracy: self.absolute_accuracy,
            strict: self.strict,
            start_rad: None,
            joints_hint: self.joints_hint.as_deref().map(model::joints_hint).transpose()?.map(Arc::new),
            selection: Selection { keep: self.keep.clone(), only: self.only.clone() },
            gap_min: matches!(self.clock, ClockName::Warmth).then_some(self.gap_min),
        })
    }

    /// The robot, its deformation and its model.
    ///
    /// # Errors
    /// What is wrong with a name or a file.
    pub fn models(&self, of_task: Option<&TaskRobot>) -> Result<Models, Diagnostic> {
        let name = of_task.map_or(&self.robot.name, |task| &task.robot);
        model::robot_of_program(name)?;
        let robot = model::robot_with_source(name)?;
        if let Some(backup) = model::backup(name).transpose()? {
            check_absolute_accuracy(name, &backup, self.absolute_accuracy)?;
        }
        let identified = self.model.as_deref().map(model::identified).transpose()?;
        let table = match of_task {
            Some(task) => task.deformation.as_deref(),
            None => self.deformation.as_deref(),
        };
        let growth = self.growth.as_deref();
        let deformation = match &identified {
            Some(identified) => model::deformation_beside(identified, table, growth)?,
            None => model::deformation_with_source(table, growth)?,
        };
        Ok(Models { robot, deformation, identified })
    }

    /// The jobs, all names resolved: one for each task that is named, or the one for all that is given.
    ///
    /// # Errors
    /// What is wrong with a robot or a deformation; a task that is named twice.
    pub fn jobs(&self) -> Result<Vec<Compensation>, Diagnostic> {
        if self.task.is_empty() {
            return self.compensation(None).map(|job| vec![job]);
        }
        for (k, task) in self.task.iter().enumerate() {
            if self.task[..k].iter().any(|other| other.task.eq_ignore_ascii_case(&task.task)) {
                let text = format!("--task {} is given twice", task.task);
                return Err(Diagnostic::error("task::twice", text).help("one robot for each task"));
            }
        }
        self.task.iter().map(|task| self.compensation(Some(task))).collect()
    }

    /// A job, all names resolved: that of a task, or the one for all that is given.
    ///
    /// # Errors
    /// What is wrong with the robot or the deformation.
    pub fn compensation(&self, of_task: Option<&TaskRobot>) -> Result<Compensation, Diagnostic> {
        let Models { robot, deformation, identified } = self.models(of_task)?;
        let start = given_for("--start-joints", &self.start_joints, &self.task, of_task)?;
        let home = given_for("--home", &self.home, &self.task, of_task)?.cloned();
        if let Some(joints) = start {
            joints.check(&robot.model)?;
        }
        let start_rad = start.map(|joints| joints.0);
        let mut options = Options { start_rad, ..self.options(identified.as_ref())? };
        if let (Some(of), Some(hint)) = (of_task, &mut options.joints_hint) {
            let others = self.task.iter().filter(|other| *other != of).map(|other| other.task.clone());
            *hint = Arc::new(JointsHint::clone(hint).without_tasks(others.collect()));
        }
        Ok(Compensation {
            options,
            emit: self.emit_options(&robot, &deformation, identified.as_ref())?,
            overrides: Overrides { task: of_task.map(|of| of.task.clone()), home, ..self.overrides() },
            allow_non_nominal: self.allow_non_nominal,
            allow_other_robot: self.allow_other_robot,
            default_table: match of_task {
                Some(task) => task.deformation.is_none(),
                None => self.deformation.is_none() && self.model.is_none(),
            },
            touch: self.touch.request()?,
            robot,
            deformation,
        })
    }

    /// How the program is emitted.
    ///
    /// # Errors
    /// What is wrong with the deformation table.
    pub fn emit_options(
        &self,
        robot: &Named<Robot>,
        deformation: &Named<Deformation>,
        model: Option<&Named<Identified>>,
    ) -> Result<EmitOptions, Diagnostic> {
        let clock = match &self.clock {
            ClockName::Elapsed => Clock::Elapsed,
            ClockName::Measured(source) => {
                Clock::Sensor { source: source.clone(), hold_min: self.hold_min, stale_min: self.stale_min }
            }
            ClockName::Warmth => Clock::Warmth {
                growth: DriftGrowth::of(&deformation.model, model.map(|model| &model.model)),
                tau_cool_min: self.tau_cool.or(model.and_then(|model| model.model.tau_cool_min)),
                gap_min: self.gap_min,
            },
        };
        // Beside a model the deformation is that of both.
        let table = match (model, self.deformation.as_deref()) {
            (None, _) => Some(deformation.source.clone()),
            (Some(_), None) => None,
            (Some(_), table) => Some(model::deformation_with_source(table, self.growth.as_deref())?.source),
        };
        Ok(EmitOptions {
            form: self.form.into(),
            clock,
            growth: deformation.model.one_law(model.map(|model| &model.model)),
            core: self.core.map(|core| match core {
                CoreName::Embedded => Core::Embedded,
                CoreName::Separate => Core::Separate,
            }),
            robot: robot.source.clone(),
            deformation: table,
            model: model.map(|model| model.source.clone()),
            settings: Vec::new(),
            absolute_accuracy: self.absolute_accuracy,
            self_test: self.self_test,
            touch: None,
        })
    }

    /// Tools and work objects given as options.
    #[must_use]
    pub fn overrides(&self) -> Overrides {
        let mut base_fixed = [false; 6];
        for axis in &self.base_fixed {
            base_fixed[axis.0] = true;
        }
        Overrides { tools: self.tool.clone(), wobjs: self.wobj.clone(), base_fixed, ..Overrides::default() }
    }

    /// Refuses numbers that make no sense before any work is done.
    ///
    /// # Errors
    /// `option::number`, naming the option.
    pub fn check(&self) -> Result<(), Diagnostic> {
        positive(&[
            ("--max-correction-mm", self.max_correction_mm),
            ("--max-correction-deg", self.max_correction_deg),
            ("--payload-kg", self.payload_kg.filter(|kg| *kg != 0.0)),
            ("--path-tolerance-mm", Some(self.path_tolerance_mm)),
        ])?;
        let until = match self.until {
            Until::Minutes(minutes) if minutes > 0.0 => Some(minutes),
            _ => None,
        };
        minutes(&[
            ("--gap-min", Some(self.gap_min)),
            ("--hold-min", Some(self.hold_min)),
            ("--stale-min", Some(self.stale_min)),
            ("--tau-cool", self.tau_cool),
            ("--until", until),
            ("--bucket-min", self.bucket_min.filter(|minutes| *minutes > 0.0)),
        ])
    }
}
