//! Pages of what was found: one self-contained HTML file each.

use super::compensated::{Compensated, Refusal};
use super::compensation::Compensation;
use crate::report::{CompensationPage, SourceReview};
use rapid_compensation::compensate::{TcpDrift, tcp_drift};
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use std::io::{self, Write};

impl Compensated<'_> {
    /// Writes the page of the compensation; `source` holds the changes of its files.
    ///
    /// # Errors
    /// What writing to `out` fails with.
    pub fn write_page(&self, source: SourceReview, out: &mut dyn Write) -> io::Result<()> {
        self.page(self.drift().as_ref(), source).write(out)
    }

    /// Writes the page of one robot's compensation, or one page of several tasks; of each of `all` the changes of its files.
    ///
    /// # Errors
    /// What writing to `out` fails with.
    pub fn write_page_of(
        all: &[Self],
        mut sources: Vec<SourceReview>,
        out: &mut dyn Write,
    ) -> io::Result<()> {
        if let [made] = all
            && made.task.is_none()
        {
            return made.write_page(sources.pop().unwrap_or_default(), out);
        }
        let drifts: Vec<Option<TcpDrift>> = all.iter().map(Self::drift).collect();
        let pages = all.iter().zip(&drifts).zip(sources);
        let pages = pages.map(|((made, drift), source)| {
            (made.task.as_deref().unwrap_or_default(), made.page(drift.as_ref(), source))
        });
        let names: Vec<&str> = all.iter().filter_map(|made| made.task.as_deref()).collect();
        CompensationPage::write_tasks(&names.join(", "), pages.collect(), out)
    }

    fn drift(&self) -> Option<TcpDrift> {
        tcp_drift(&self.program, &self.plan, self.robot, self.deformation, self.options).ok()
    }

    fn page<'p>(&'p self, drift: Option<&'p TcpDrift>, source: SourceReview) -> CompensationPage<'p> {
        CompensationPage {
            title: self.provenance.first().map_or("", |(_, program)| program.as_str()),
            program: &self.program,
            plan: Some(&self.plan),
            kept: &[],
            messages: &self.messages,
            arm: drift.map(|drift| (self.robot, drift)),
            is_papers_case: is_papers_case(self.robot, self.deformation) && self.options.model.is_none(),
            provenance: &self.provenance,
            settings: &self.settings,
            source,
        }
    }
}

impl Refusal {
    /// Writes the page of the reasons; `job` is what was asked for, where that was understood.
    ///
    /// # Errors
    /// What writing to `out` fails with.
    pub fn write_page(&self, title: &str, job: Option<&Compensation>, out: &mut dyn Write) -> io::Result<()> {
        let drift = self.plan.as_ref().zip(job).and_then(|(plan, job)| {
            let drift: TcpDrift =
                tcp_drift(&self.program, plan, &job.robot.model, &job.deformation.model, &job.options)
                    .ok()?;
            Some((&job.robot.model, drift))
        });
        CompensationPage {
            title,
            program: &self.program,
            plan: self.plan.as_ref(),
            kept: &self.kept,
            messages: &self.messages,
            arm: drift.as_ref().map(|(robot, drift)| (*robot, drift)),
            is_papers_case: false,
            provenance: &job.map_or_else(Vec::new, |job| job.provenance(title)),
            settings: &[],
            source: SourceReview::default(),
        }
        .write(out)
    }
}

fn is_papers_case(robot: &Robot, deformation: &Deformation) -> bool {
    let papers = Robot::built_in(super::other_robot::PAPER_ROBOT);
    papers.is_some_and(|papers| papers.same_arm(robot)) && *deformation == Deformation::paper()
}
