//! From given files to an emitted program, or to the reasons why there is none. Writes nothing.

use super::made::{Halt, Made, Refusal};
use super::{Args, Models};
use crate::cli::destination::Destination;
use crate::cli::given::Given;
use crate::cli::model::{self, Named};
use crate::report::{self, MotionRows, Told};
use rapid_program::compensate::plan::{Plan, Totals};
use rapid_program::compensate::{self, CompensateError, Options, Planner};
use rapid_program::emit::{Emission, EmitError, EmitOptions, EmittedFile};
use rapid_program::program::motion::Keep;
use rapid_program::program::{InParts, Overrides, Part, Parts, Program};
use rapid_syntax::diagnostic::{Diagnostic, FileId, Severity};
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use std::io::{self, Write};

/// What is to be done, all names resolved.
pub struct Job {
    robot: Named<Robot>,
    deformation: Named<Deformation>,
    options: Options,
    emit: EmitOptions,
    overrides: Overrides,
    allow_non_nominal: bool,
    /// No table and no model was given.
    default_table: bool,
}

/// The robot that the built-in deformation table is of.
const PAPER_ROBOT: &str = "irb140";

impl Job {
    /// Resolves what the options name.
    ///
    /// # Errors
    /// What is wrong with the robot or the deformation.
    pub fn new(args: &Args) -> Result<Self, Diagnostic> {
        let Models { robot, deformation, identified } = args.models()?;
        Ok(Self {
            options: args.options(identified.as_ref()),
            emit: args.emit_options(&robot, &deformation),
            overrides: args.overrides(),
            allow_non_nominal: args.allow_non_nominal,
            default_table: args.deformation.is_none() && args.model.is_none(),
            robot,
            deformation,
        })
    }

    /// Reads, plans and emits; each changed file is given to `take` with the program, or the part of it, that it comes from.
    /// `all` motions are reviewed, or those that are corrected most.
    ///
    /// # Errors
    /// Why not; what was taken until then must not be used.
    pub fn make<'j>(
        &'j self,
        given: &'j Given,
        all: bool,
        take: &mut dyn FnMut(&Program, EmittedFile) -> Result<(), Diagnostic>,
    ) -> Result<Made<'j>, Box<Refusal>> {
        if given.is_large() {
            match self.make_in_parts(given, (given.part_bytes(), all), take) {
                Err(Stop::Before) => {} // at once, to say of all motions what keeps them
                Err(Stop::Refused(refusal)) => return Err(refusal),
                Ok(made) => return Ok(made),
            }
        }
        self.make_in_parts(given, (usize::MAX, all), take).map_err(|stop| match stop {
            Stop::Refused(refusal) => refusal,
            Stop::Before => Box::default(),
        })
    }

    fn make_in_parts<'j>(
        &'j self,
        given: &'j Given,
        (part_bytes, all): (usize, bool),
        take: &mut dyn FnMut(&Program, EmittedFile) -> Result<(), Diagnostic>,
    ) -> Result<Made<'j>, Stop> {
        let load = |FileId(id)| given.source(id as usize);
        let parts = InParts::new(given.paths.len(), part_bytes, &self.overrides, load);
        let mut parts = parts.map_err(|message| Stop::of_file(message, given))?;
        let mut messages = Vec::new();
        if let Some(program) = parts.whole() {
            messages = Told::all(self.about(program, 0).into_iter().flatten(), &program.files);
            if messages.iter().any(is_error) {
                return Err(Stop::refused(parts, None, (messages, Vec::new())));
            }
        }
        let survey = Planner::survey(&mut parts, &self.robot.model, &self.deformation.model, &self.options);
        let mut planner = match survey {
            Ok(planner) => planner,
            Err(error) => return Err(Stop::no_plan(parts, messages, error)),
        };
        let emission = Emission::new(&self.emit);
        let mut looked = Looked::new(emission, all);
        let shown = planner.each(&mut parts, &mut |part, plan| looked.look(self, part, plan));
        shown.map_err(|message| Stop::of_file(message, given))?;
        let (summary, said) = match planner.conclude() {
            Ok(concluded) => concluded,
            Err(error) => return Err(Stop::no_plan(parts, messages, error)),
        };
        let messages = looked.messages(said);
        if messages.iter().any(is_error) {
            return Err(Stop::refused(parts, planner.plan_of_only().cloned(), (messages, Vec::new())));
        }
        let Looked { totals, rows, emission, refused, .. } = looked;
        let mut made = Made {
            job: self,
            form: self.options.form,
            text_bytes: 0,
            source_bytes: given.bytes(),
            parts,
            planner,
            summary,
            totals,
            rows,
            embedded: true,
            messages,
            provenance: self.provenance(given),
        };
        let schedule = made.planner.schedule().clone();
        let ready = match refused {
            None => emission.ready(&schedule, &made.totals),
            Some(error) => Err(error),
        };
        let ready = match ready {
            Ok(ready) => ready,
            Err(_) if made.parts.count() > 1 => return Err(Stop::Before),
            Err(error) => return Err(Stop::Refused(made.refuse_with(Halt::Emit(error).into()))),
        };
        match ready.map_or(Ok(()), |ready| made.emit(&ready, take)) {
            Ok(()) => Ok(made),
            Err(halt) => Err(Stop::Refused(made.refuse_with(halt.into()))),
        }
    }

    /// The plan of a program at once, where there is one.
    pub(super) fn plan(&self, program: &Program) -> Option<Plan> {
        compensate::plan(program, &self.robot.model, &self.deformation.model, &self.options).ok()
    }

    /// What the text of a part's own files says against compensating it, and its warnings: of the text, of its meaning, of the
    /// robot, of how it was made.
    fn about(&self, program: &Program, part: usize) -> [Vec<Diagnostic>; 4] {
        let is_own = |id: FileId| program.outline(id).is_none();
        let of_text = program.files.iter().flat_map(|file| file.warnings.iter().cloned()).collect();
        let of_meaning = program.own_diagnostics(part).cloned().collect();
        let of_robot = if part == 0 { self.about_robot(program) } else { Vec::new() };
        let mut of_making = Vec::new();
        for module in program.facts.modules.iter().filter(|module| is_own(module.file)) {
            if let Some(range) = module.compensated {
                let text = format!("module {} is already compensated", module.name);
                of_making.push(
                    Diagnostic::error("refuse::already-compensated", text)
                        .at(program.file(module.file).span(range))
                        .help("give the original, or get it back with `driftpost restore`"),
                );
            }
        }
        let remarks = program.facts.kinematics.iter().filter(|remark| is_own(remark.span.file));
        for remark in remarks.filter(|remark| !remark.is_nominal()) {
            let text = format!("made with {} kinematics, not with nominal ones", remark.word);
            let (severity, help) = if self.allow_non_nominal {
                (Severity::Warning, "what the targets already correct is corrected twice")
            } else {
                (
                    Severity::Error,
                    "export from RoboDK with nominal kinematics; --allow-non-nominal takes the program as it is",
                )
            };
            of_making.push(Diagnostic::new(severity, "refuse::not-nominal", text).at(remark.span).help(help));
        }
        [of_text, of_meaning, of_robot, of_making]
    }

    /// Warnings where the program or the deformation belongs to another robot.
    fn about_robot(&self, program: &Program) -> Vec<Diagnostic> {
        let robot = &self.robot.model.name;
        let other = self.options.model.as_deref().and_then(|m| model::of_another_robot(m, &self.robot.model));
        let mut messages: Vec<Diagnostic> = other.into_iter().collect();
        if let Some(remark) = program.facts.made_for.iter().find(|remark| !remark.may_be(robot)) {
            let text = format!("made for {}, and taken as one for {robot}", remark.robot);
            let help = "name the robot that runs it with --robot";
            messages.push(Diagnostic::warning("robot::other", text).at(remark.span).help(help));
        }
        if self.default_table && self.robot.source.name != PAPER_ROBOT {
            let text = format!("the built-in deformation table is an IRB 140's, the robot is {robot}");
            let help = "give a table of this robot with --deformation";
            messages.push(Diagnostic::warning("deform::other-robot", text).help(help));
        }
        messages
    }

    fn provenance(&self, given: &Given) -> Vec<(&'static str, String)> {
        let named = |name: &str, sha256: &str| format!("{name}, SHA-256 {sha256}");
        let program = given.places.iter().map(|p| p.display().to_string()).collect::<Vec<_>>();
        let growth = self.deformation.model.growth().map(|law| format!("growth {law}; "));
        let deformation = named(&self.deformation.source.name, &self.deformation.source.sha256);
        let robot = named(&self.robot.source.name, &self.robot.source.sha256);
        vec![
            ("program", program.join(", ")),
            ("robot", format!("{}; {robot}", self.robot.model.name)),
            ("deformation", format!("{}{deformation}", growth.unwrap_or_default())),
        ]
    }
}

fn is_error(message: &Told) -> bool {
    message.diagnostic.severity == Severity::Error
}

/// Why nothing was made.
enum Stop {
    /// Found before anything was taken, in a program of several parts.
    Before,
    /// Nothing more can be done.
    Refused(Box<Refusal>),
}

impl Stop {
    /// Of a program in one part, with all that is known of it.
    fn refused(parts: InParts<'_>, plan: Option<Plan>, (messages, kept): (Vec<Told>, Vec<Keep>)) -> Self {
        match parts.into_whole() {
            Some(program) => Self::Refused(Box::new(Refusal { program, plan, kept, messages })),
            None => Self::Before,
        }
    }

    fn no_plan(parts: InParts<'_>, mut messages: Vec<Told>, error: CompensateError) -> Self {
        let (why, kept) = why_no_plan(error);
        if let Some(program) = parts.whole() {
            messages.extend(Told::all(why, &program.files));
        }
        Self::refused(parts, None, (messages, kept))
    }

    /// A file that cannot be used.
    fn of_file(message: Diagnostic, given: &Given) -> Self {
        let files = given.sources();
        let messages = vec![Told::new(message, &files)];
        let program = Program { files, ..Program::default() };
        Self::Refused(Box::new(Refusal { program, messages, ..Refusal::default() }))
    }
}

/// What is found in one part after the other.
struct Looked<'o> {
    emission: Emission<'o>,
    /// Why some part cannot be emitted.
    refused: Option<EmitError>,
    about: [Vec<Told>; 4],
    of_plan: Vec<Told>,
    totals: Totals,
    rows: MotionRows,
}

impl<'o> Looked<'o> {
    fn new(emission: Emission<'o>, all: bool) -> Self {
        let (about, of_plan, totals) = ([const { Vec::new() }; 4], Vec::new(), Totals::default());
        Self { emission, refused: None, about, of_plan, totals, rows: MotionRows::new(all) }
    }

    fn look(&mut self, job: &Job, part: Part<'_>, plan: &Plan) {
        let Part { program, number, .. } = part;
        for (all, own) in self.about.iter_mut().zip(job.about(program, number)) {
            all.extend(Told::all(own, &program.files));
        }
        self.of_plan.extend(Told::all(plan.diagnostics.iter().cloned(), &program.files));
        self.totals.add(&Totals::of(program, plan));
        self.rows.add(program, plan);
        if self.refused.is_none() {
            self.refused = self.emission.look(program, plan).err();
        }
    }

    /// All there is to be said; `said`: of the program as a whole.
    fn messages(&mut self, said: Vec<Diagnostic>) -> Vec<Told> {
        let about = std::mem::take(&mut self.about).into_iter().flatten();
        about.chain(Told::all(said, &[])).chain(std::mem::take(&mut self.of_plan)).collect()
    }
}

/// What there is to be said, and why each motion is kept.
fn why_no_plan(error: CompensateError) -> (Vec<Diagnostic>, Vec<Keep>) {
    let (code, text) = (error.code(), error.to_string());
    let (mut messages, kept) = match error {
        CompensateError::NothingToCompensate { diagnostics, kept, .. } => (diagnostics, kept),
        _ => (Vec::new(), Vec::new()),
    };
    messages.push(Diagnostic::error(code, text));
    (messages, kept)
}

/// The diff of a changed file, or of a new one.
///
/// # Errors
/// Those of `out`.
pub fn write_diff(
    out: &mut dyn Write,
    program: &Program,
    file: &EmittedFile,
    given: &Given,
    destination: &Destination,
) -> io::Result<()> {
    let path = destination.path_of(file, given).display().to_string();
    match file.source {
        Some(id) => {
            let source = program.file(id);
            report::write_edits(out, &source.path, &path, &source.bytes, &file.edits)
        }
        None => report::write_created(out, &path, &mut io::Cursor::new(&file.bytes)),
    }
}
