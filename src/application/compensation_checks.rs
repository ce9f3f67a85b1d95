//! What speaks against compensating a program: its text, its meaning, the robot, its table, how it was made.

use super::compensation::Compensation;
use super::cooling_checks;
use super::other_robot::{default_table_of_another_robot, model_of_another_robot, refusal};
use rapid_compensation::emit::Clock;
use rapid_program::{Program, is_of_task, task_of};
use rapid_syntax::SourceFile;
use rapid_syntax::diagnostic::{Diagnostic, FileId, Severity, TextRange, is_or_are, plural};
use rapid_syntax::tree::{FileItem, ModuleItem, Scope};
use std::collections::{BTreeMap, BTreeSet};

/// Makers of arms that run no RAPID, as they stand in the names of robots.
const OTHER_MAKERS: [&str; 12] = [
    "COMAU",
    "DENSO",
    "EPSON",
    "FANUC",
    "KAWASAKI",
    "KUKA",
    "MITSUBISHI",
    "MOTOMAN",
    "NACHI",
    "STAUBLI",
    "UNIVERSAL ROBOTS",
    "YASKAWA",
];

/// Modules that a message names at most.
const MOST_NAMED: usize = 6;

/// The modules that an earlier run has made; and what is half done, where others that move the arm are not of its making: a run with
/// `--in-place` may have been killed between them.
fn already_compensated(program: &Program) -> Vec<Diagnostic> {
    let modules = &program.facts.modules;
    let mut found: Vec<Diagnostic> = Vec::new();
    for module in modules {
        if let Some(range) = module.compensated {
            let text = format!("module {} is already compensated", module.name);
            // Without its comment block it is known by the names in it alone.
            let help = match program.file(module.file).text(range).first() {
                Some(b'!') => "give the original, or get it back with `driftpost restore`",
                _ => {
                    "give the original: the module's comment block is gone, without which `driftpost restore` cannot get it back"
                }
            };
            found.push(
                Diagnostic::error("refuse::already-compensated", text)
                    .at(program.file(module.file).span(range))
                    .help(help),
            );
        }
    }
    let is_made = |file: FileId| modules.iter().any(|of| of.file == file && of.compensated.is_some());
    let mut originals: Vec<FileId> =
        program.routines.iter().map(|routine| routine.file).filter(|file| !is_made(*file)).collect();
    originals.dedup();
    if !found.is_empty() && !originals.is_empty() {
        let names = |files: &[FileId]| {
            let paths: Vec<&str> =
                files.iter().take(MOST_NAMED).map(|file| program.file(*file).path.as_str()).collect();
            let more = files.len().saturating_sub(MOST_NAMED);
            if more == 0 { paths.join(", ") } else { format!("{} and {more} more", paths.join(", ")) }
        };
        let made: Vec<FileId> =
            modules.iter().filter(|of| of.compensated.is_some()).map(|of| of.file).collect();
        let text = format!(
            "{} {} compensated, and what moves the arm in {} is not: a run with --in-place may have been stopped between them",
            names(&made),
            is_or_are(found.len()),
            names(&originals)
        );
        found.push(Diagnostic::error("refuse::half-compensated", text).help(
            "`driftpost restore FOLDER -o OTHER` writes the originals of all to another folder and leaves the common module out; compensate those",
        ));
    }
    found
}

/// Functions that corrected motions ask, in lower case, each with what stands behind its name.
const ASKED: [&str; 8] =
    ["tcat(", "tcatsame(", "tcatone(", "tcatj(", "tclive(", "tclivesame(", "tclivej(", "tck()}"];

/// Corrected motions that were copied into a module of its own: they ask for what no given module declares, and would be corrected once more.
fn copied_motions(program: &Program) -> Option<Diagnostic> {
    let modules = program.files.iter().flat_map(|file| file.tree.items.iter().map(move |item| (file, item)));
    let declared: Vec<String> = modules
        .filter_map(|(file, item)| match item {
            FileItem::Module(module) => Some((file, module)),
            _ => None,
        })
        .flat_map(|(file, module)| module.routines().map(|routine| file.text(routine.name)))
        .map(|name| String::from_utf8_lossy(name).to_ascii_lowercase())
        .collect();
    let found = program.motions.iter().find_map(|motion| {
        let asked = motion.targets.iter().find_map(|target| {
            let text = program.file(motion.file).text(target.range).to_ascii_lowercase();
            let asked = ASKED.into_iter().find(|asked| match asked.ends_with('(') {
                true => text.starts_with(asked.as_bytes()),
                false => text.starts_with(b"tc") && text.ends_with(asked.as_bytes()),
            })?;
            let name = asked.trim_end_matches(['(', ')', '}']);
            (!declared.iter().any(|declared| declared == name)).then_some(target.range)
        })?;
        Some((motion, asked))
    })?;
    let (motion, asked) = found;
    let text = format!(
        "line {}: this {} is already compensated, and what it asks for is in none of the given files",
        motion.line, motion.setup.kind
    );
    Some(
        Diagnostic::error("refuse::already-compensated", text)
            .at(program.file(motion.file).span(asked))
            .help("put the original target there, or take the routine from the original"),
    )
}

/// Global names of a task that two of its modules declare, as a warning: programs that stand side by side in a folder are corrected each
/// by itself, and no controller loads them together.
fn declared_twice<'f>(files: impl Iterator<Item = &'f SourceFile>) -> Option<Diagnostic> {
    let mut seen: BTreeMap<(Option<String>, String), &SourceFile> = BTreeMap::new();
    let mut twice: Vec<(String, [&SourceFile; 2], TextRange)> = Vec::new();
    for file in files {
        let task = task_of(&file.path).map(str::to_ascii_lowercase);
        let modules = file.tree.items.iter().filter_map(|item| match item {
            FileItem::Module(module) => Some(module),
            _ => None,
        });
        for name in modules.flat_map(|module| &module.items).filter_map(global_name) {
            let shown = String::from_utf8_lossy(file.text(name)).into_owned();
            let first = *seen.entry((task.clone(), shown.to_ascii_lowercase())).or_insert(file);
            if first.id != file.id {
                twice.push((shown, [first, file], name));
            }
        }
    }
    let (name, [first, second], at) = twice.first()?;
    let more = match twice.len() - 1 {
        0 => String::new(),
        n => format!(", and {n} more such {}", plural(n, "name")),
    };
    let text = format!("{name} is declared globally in {} and in {}{more}", first.path, second.path);
    Some(
        Diagnostic::warning("input::name-twice", text)
            .at(second.span(*at))
            .help("no controller loads both in one task: each is corrected as if the other were not there; declare one as LOCAL, or load them one at a time"),
    )
}

/// The name that a part of a module gives to the whole task.
fn global_name(item: &ModuleItem) -> Option<TextRange> {
    match item {
        ModuleItem::Data(data) => (data.scope != Scope::Local).then_some(data.name),
        ModuleItem::Routine(routine) => (routine.scope != Scope::Local).then_some(routine.name),
        ModuleItem::Record(_) | ModuleItem::Alias(_) | ModuleItem::Comment(_) | ModuleItem::Opaque(_) => None,
    }
}

impl Compensation {
    /// What the text of a program says against compensating it, and its warnings: of the text, of its meaning, of the robot,
    /// of how it was made.
    pub(super) fn check_program(&self, program: &Program) -> Vec<Diagnostic> {
        let mut found: Vec<Diagnostic> =
            self.own_files(program).flat_map(|file| file.warnings.iter().cloned()).collect();
        found.extend(program.diagnostics.iter().cloned());
        found.extend(self.check_robot(program));
        found.extend(self.check_table());
        found.extend(self.check_end_of_table());
        if matches!(self.emit.clock, Clock::Warmth { .. }) {
            let deformation = &self.deformation;
            found.extend(cooling_checks::all(
                &deformation.source.name,
                &deformation.model,
                self.options.model.as_deref(),
            ));
        }
        found.extend(self.check_outside_names(program));
        found.extend(declared_twice(self.own_files(program)));
        found.extend(already_compensated(program));
        if found.iter().all(|message| message.code != "refuse::already-compensated") {
            found.extend(copied_motions(program));
        }
        for remark in program.facts.kinematics.iter().filter(|remark| !remark.is_nominal()) {
            let text = format!("made with {} kinematics, not with nominal ones", remark.word);
            let (severity, help) = if self.allow_non_nominal {
                (Severity::Warning, "what the targets already correct is corrected twice")
            } else {
                (
                    Severity::Error,
                    "export from RoboDK with nominal kinematics; --allow-non-nominal takes the program as it is",
                )
            };
            found.push(Diagnostic::new(severity, "refuse::not-nominal", text).at(remark.span).help(help));
        }
        found
    }

    /// Tools and work objects that are given for names which stand nowhere in the program, as far as it `mentions` any.
    pub(super) fn unused_frames(
        &self,
        mentions: &dyn Fn(&str) -> bool,
        program: &Program,
    ) -> Vec<Diagnostic> {
        let setups = || program.motions.iter().map(|motion| &motion.setup);
        let tools: BTreeSet<&str> = setups()
            .filter(|setup| setup.tool.is_none())
            .filter_map(|setup| setup.tool_name.as_deref())
            .collect();
        let wobjs: BTreeSet<&str> = setups()
            .filter(|setup| setup.wobj.is_none())
            .filter_map(|setup| setup.wobj_name.as_deref())
            .collect();
        let given = [("--tool", &self.overrides.tools, tools), ("--wobj", &self.overrides.wobjs, wobjs)];
        let warning = |option: &str, name: &str, lacking: &BTreeSet<&str>| {
            let text = format!("{option} {name}=: the program names no {name}");
            let lacking: Vec<&str> = lacking.iter().copied().take(MOST_NAMED).collect();
            let help = match lacking.as_slice() {
                [] => "correct the name, or leave the option out".to_owned(),
                names => format!("no value is known for {}", names.join(", ")),
            };
            Diagnostic::warning("override::unused", text).help(help)
        };
        let of = |(option, given, lacking): (&str, &Vec<(String, String)>, BTreeSet<&str>)| {
            let unused = given.iter().filter(|(name, _)| !mentions(name));
            unused.map(|(name, _)| warning(option, name, &lacking)).collect::<Vec<_>>()
        };
        given.into_iter().flat_map(of).collect()
    }

    /// The files of the task that is compensated, or all.
    fn own_files<'p>(&'p self, program: &'p Program) -> impl Iterator<Item = &'p SourceFile> {
        program.files.iter().filter(|file| is_of_task(&file.path, self.overrides.task.as_deref()))
    }

    /// A table of which the last rows are missing.
    fn check_end_of_table(&self) -> Option<Diagnostic> {
        let (joints, at) = self.deformation.model.cut_off()?;
        let joints: Vec<String> = joints.iter().map(ToString::to_string).collect();
        let text = format!(
            "{}: at {at}, its last time or temperature, rows of joints {} are missing, which have all before it: they are held as they were",
            self.deformation.source.name,
            joints.join(", ")
        );
        Some(
            Diagnostic::warning("deform::cut-off", text)
                .help("was the file cut off? copy it again, or add the rows"),
        )
    }

    /// A table by warm-up time that says nothing of the cold robot.
    fn check_table(&self) -> Option<Diagnostic> {
        let (frame, minute) = self.deformation.model.late_start()?;
        let text = format!(
            "{}: the rows of joint {frame} begin at minute {minute} with a deformation: before, it is taken to be deformed as much",
            self.deformation.source.name
        );
        let help = "where the cold robot is not, write a row of zeros at minute 0";
        Some(Diagnostic::warning("deform::late-start", text).help(help))
    }

    /// What says that the program, the model or the deformation belongs to another robot: errors unless that is allowed. And what is to be
    /// known of the robot itself: that nothing shows it to be ABB's, that one description alone has its dimensions.
    fn check_robot(&self, program: &Program) -> Vec<Diagnostic> {
        let mut messages = self.of_another_robot(program);
        if !self.allow_other_robot {
            messages = messages.into_iter().map(refusal).collect();
        }
        let robot = &self.robot.model;
        let is_told = messages.iter().any(|message| message.code == "robot::not-abb");
        if !is_told && !robot.is_known_as_abbs() {
            let text = format!(
                "nothing says that {} is an ABB robot: neither its name nor dimensions of one that is built in",
                robot.name
            );
            let help = "RAPID runs on ABB's controllers alone; where it is ABB's, name it so in the robot file: name = \"ABB IRB ...\"";
            messages.push(Diagnostic::warning("robot::maker-unknown", text).help(help));
        }
        if robot.is_of_one_description() {
            let text = format!(
                "no second public description confirms the dimensions of {}: {}",
                robot.name, robot.source
            );
            let help = "compare them with the data sheet: `driftpost robot --robot NAME` prints them, and writes a file that can be corrected";
            messages.push(Diagnostic::warning("robot::one-description", text).help(help));
        }
        messages
    }

    fn of_another_robot(&self, program: &Program) -> Vec<Diagnostic> {
        let robot = &self.robot.model.name;
        let other = self
            .options
            .model
            .as_deref()
            .and_then(|m| model_of_another_robot(m, robot, &self.robot.model.geometry()));
        let mut messages: Vec<Diagnostic> = other.into_iter().collect();
        if let Some(remark) = program.facts.made_for.iter().find(|remark| !remark.may_be(robot)) {
            let text = format!("made for {}, and taken as one for {robot}", remark.robot);
            let help = "name the robot that runs it with --robot";
            messages.push(Diagnostic::warning("robot::other", text).at(remark.span).help(help));
        }
        if let Some(maker) = OTHER_MAKERS.iter().find(|maker| robot.to_ascii_uppercase().contains(*maker)) {
            let text = format!("{robot} is {maker}'s, and RAPID runs on ABB's controllers alone");
            let help =
                "its measurements can be diagnosed; a program can only be corrected for an arm that runs it";
            messages.push(Diagnostic::warning("robot::not-abb", text).help(help));
        }
        messages.extend(default_table_of_another_robot(&self.robot.model).filter(|_| self.default_table));
        messages
    }
}
