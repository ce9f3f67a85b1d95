//! What emitted modules say that they were made with, for commands that compare or execute them. An option wins.

use super::files;
use super::model;
use super::program_input::{ProgramInput, slashed};
use super::shared::{JointAngles, joint_angles};
use driftpost::application::{Named, sha256};
use rapid_program::emit::{Provenance, made_with};
use rapid_program::program::{Overrides, is_of_task};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::deform::identified::Identified;
use robot_model::robot::Robot;
use std::path::{Path, PathBuf};

/// The robot where neither an option nor a module names one.
const DEFAULT_ROBOT: &str = "irb140";

/// How an arm deforms, and its identified model.
pub type Deformed = (Deformation, Option<Named<Identified>>);

/// Settings of emitted modules by the names of options, each with the module that says so.
#[derive(Debug, Default)]
pub struct MadeWith {
    settings: Vec<(String, String, PathBuf)>,
}

impl MadeWith {
    /// What the modules of some programs say; where a task is named, those of its folder.
    #[must_use]
    pub fn of(programs: &[&ProgramInput], task: Option<&str>) -> Self {
        let mut settings: Vec<(String, String, PathBuf)> = Vec::new();
        let modules = programs.iter().flat_map(|program| program.paths.iter().zip(&program.bytes));
        for (path, bytes) in modules.filter(|(path, _)| is_of_task(&slashed(path), task)) {
            for (name, value) in made_with(bytes).unwrap_or_default() {
                if !settings.iter().any(|(n, v, _)| (n, v) == (&name, &value)) {
                    settings.push((name, value, path.clone()));
                }
            }
        }
        Self { settings }
    }

    /// The one value of a setting.
    ///
    /// # Errors
    /// `made-with::differs` where two modules say different ones.
    pub fn one(&self, name: &str) -> Result<Option<&str>, Diagnostic> {
        Ok(self.place(name)?.map(|(value, _)| value))
    }

    fn place(&self, name: &str) -> Result<Option<(&str, &Path)>, Diagnostic> {
        let mut values = self.settings.iter().filter(|(setting, ..)| setting == name);
        let Some((_, value, path)) = values.next() else { return Ok(None) };
        match values.next() {
            None => Ok(Some((value, path))),
            Some((_, other, there)) => {
                let [first, second] = [(path, value), (there, other)]
                    .map(|(path, value)| format!("{} with {}", path.display(), shown(value)));
                let text = format!("the modules were made with different {name}s: {first}, {second}");
                Err(Diagnostic::error("made-with::differs", text)
                    .help(format!("say with --{name} which one to take")))
            }
        }
    }

    /// The robot: the one that `option` names, else the modules', else an IRB 140.
    ///
    /// # Errors
    /// What is wrong with a name or a file, or that it is not there.
    pub fn robot(&self, option: Option<&str>) -> Result<Robot, Diagnostic> {
        if let Some(name) = option {
            return model::robot_of_program(name);
        }
        let Some((value, module)) = self.place("robot")? else {
            return model::robot_of_program(DEFAULT_ROBOT);
        };
        let Some(source) = Provenance::parse(value) else { return model::robot_of_program(DEFAULT_ROBOT) };
        if Robot::built_in_file(&source.name).is_some_and(|file| sha256(file.as_bytes()) == source.sha256) {
            return model::robot_of_program(&source.name);
        }
        model::robot_of_program(&found("robot", &source, module)?.to_string_lossy())
    }

    /// The deformation and the model that the modules name; `growth` is an option that wins.
    ///
    /// # Errors
    /// A file that is not there, or what is wrong in it.
    pub fn deformed(&self, growth: Option<&str>) -> Result<Option<Deformed>, Diagnostic> {
        let (table, identified) = (self.place("deformation")?, self.place("model")?);
        if table.is_none() && identified.is_none() {
            return Ok(None);
        }
        let growth = growth.or(self.one("growth")?);
        let file = |name: &str, place: Option<(&str, &Path)>| {
            let source = place.and_then(|(value, module)| Some((Provenance::parse(value)?, module)));
            let source = source.filter(|(source, _)| *source != Named::<Deformation>::paper().source);
            source.map(|(source, module)| found(name, &source, module)).transpose()
        };
        let path = file("deformation", table)?;
        let identified = file("model", identified)?.map(|path| model::identified(&path)).transpose()?;
        let deformation = match (&identified, table) {
            (Some(identified), None) => model::deformation_beside(identified, None, growth)?.model,
            _ => model::deformation(path.as_deref(), growth)?,
        };
        Ok(Some((deformation, identified)))
    }

    /// Tools and work objects: those of the options, and the modules' under other names.
    #[must_use]
    pub fn overrides(&self, tools: &[(String, String)], wobjs: &[(String, String)]) -> Overrides {
        let with = |option: &str, given: &[(String, String)]| {
            let mut all = given.to_vec();
            for (_, value, _) in self.settings.iter().filter(|(name, ..)| name == option) {
                if let Some((name, data)) = value.split_once('=')
                    && !all.iter().any(|(known, _)| known.eq_ignore_ascii_case(name))
                {
                    all.push((name.to_owned(), data.to_owned()));
                }
            }
            all
        };
        let mut base_fixed = [false; 6];
        for (_, axes, _) in self.settings.iter().filter(|(name, ..)| name == "base-fixed") {
            for (fixed, letter) in base_fixed.iter_mut().zip('a'..='f') {
                *fixed |= axes.contains(letter);
            }
        }
        Overrides {
            task: None,
            tools: with("tool", tools),
            wobjs: with("wobj", wobjs),
            home: None,
            base_fixed,
            other_tasks: Vec::new(),
        }
    }

    /// Joints with which the arm stands when the entry is called, radians: those of the option, else the modules'.
    ///
    /// # Errors
    /// Two modules that say different ones.
    pub fn start_rad(&self, option: Option<JointAngles>) -> Result<Option<[f64; 6]>, Diagnostic> {
        let angles = match option {
            Some(angles) => Some(angles),
            None => self.one("start-joints")?.and_then(|text| joint_angles(text).ok()),
        };
        Ok(angles.map(|angles| angles.0))
    }
}

/// A setting as it is shown: of a file its name.
fn shown(value: &str) -> String {
    Provenance::parse(value).map_or_else(|| value.to_owned(), |source| source.name)
}

/// So many folders above a module are looked into: from `RAPID/TASK1/PROGMOD` of a backup to what stands beside it.
const FOLDERS_ABOVE: usize = 5;

/// The file that a module was made with: beside the module, in a folder above it, or in the working folder.
fn found(option: &str, source: &Provenance, module: &Path) -> Result<PathBuf, Diagnostic> {
    let Provenance { name, sha256: digest } = source;
    let module_shown = module.display();
    let mut another = None;
    for folder in module.ancestors().skip(1).take(FOLDERS_ABOVE).chain([Path::new("")]) {
        let path = folder.join(name);
        match files::read(&path, option) {
            Ok(bytes) if sha256(&bytes) == *digest => return Ok(path),
            Ok(_) => another = another.or(Some(path)),
            Err(_) => {}
        }
    }
    let text = match another {
        Some(path) => format!(
            "{module_shown} was made with another {option} than {} now holds (its SHA-256 began with {})",
            path.display(),
            digest.get(..12).unwrap_or(digest)
        ),
        None => {
            format!("{module_shown} was made with the {option} {name}, which is neither beside it nor here")
        }
    };
    Err(Diagnostic::error("made-with::missing", text).help(format!("name the {option} with --{option}")))
}
