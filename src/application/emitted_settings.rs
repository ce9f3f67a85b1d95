//! What emitted modules say that they were made with, for jobs that compare or execute them. What is asked for beside it wins.

use super::named::{Named, sha256};
use super::other_robot::PAPER_ROBOT;
use super::program_files::ProgramFiles;
use rapid_compensation::emit::{self, Clock, Provenance, made_with};
use rapid_program::{Overrides, is_of_task};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Deformation;
use robot_model::robot::Robot;
use robot_model::units::rad_from_deg;

/// Settings of emitted modules by the names of options.
#[derive(Clone, Debug, Default)]
pub struct EmittedSettings {
    settings: Vec<Setting>,
}

#[derive(Clone, Debug)]
struct Setting {
    name: String,
    value: String,
    /// The path of the module that says so.
    module: String,
}

/// Where a robot, a table or a model comes from that modules were made with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin<'m> {
    /// It is the library's, by this name.
    BuiltIn(String),
    /// A file.
    File {
        /// Its name and SHA-256.
        source: Provenance,
        /// The path of the module that says so.
        module: &'m str,
    },
}

impl EmittedSettings {
    /// What the modules of some programs say, the first program's before the others'; where a task is named, those of its folder.
    #[must_use]
    pub fn of(programs: &[&ProgramFiles], task: Option<&str>) -> Self {
        let mut settings: Vec<Setting> = Vec::new();
        let modules = programs.iter().flat_map(|program| program.iter());
        for (path, bytes) in modules.filter(|(path, _)| is_of_task(path, task)) {
            for (name, value) in made_with(bytes).unwrap_or_default() {
                if !settings.iter().any(|known| (&known.name, &known.value) == (&name, &value)) {
                    settings.push(Setting { name, value, module: path.to_owned() });
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
        Ok(self.setting(name)?.map(|setting| setting.value.as_str()))
    }

    fn setting(&self, name: &str) -> Result<Option<&Setting>, Diagnostic> {
        let mut all = self.settings.iter().filter(|setting| setting.name == name);
        let (first, second) = (all.next(), all.next());
        let (Some(first), Some(second)) = (first, second) else { return Ok(first) };
        let [first, second] = [first, second].map(|of| format!("{} with {}", of.module, shown(&of.value)));
        let text = format!("the modules were made with different {name}s: {first}, {second}");
        Err(Diagnostic::error("made-with::differs", text)
            .help(format!("say with --{name} which one to take")))
    }

    /// The robot; an IRB 140 where no module names one.
    ///
    /// # Errors
    /// Modules that say different things, as [`one`](Self::one).
    pub fn robot(&self) -> Result<Origin<'_>, Diagnostic> {
        let is_built_in = |source: &Provenance| {
            Robot::built_in_file(&source.name).is_some_and(|file| sha256(file.as_bytes()) == source.sha256)
        };
        let papers = || Origin::BuiltIn(PAPER_ROBOT.to_owned());
        Ok(self.origin("robot", is_built_in)?.unwrap_or_else(papers))
    }

    /// The deformation table, where a module names one.
    ///
    /// # Errors
    /// Modules that say different things, as [`one`](Self::one).
    pub fn deformation(&self) -> Result<Option<Origin<'_>>, Diagnostic> {
        let papers = Named::<Deformation>::paper().source;
        self.origin("deformation", |source| *source == papers)
    }

    /// The identified model, where a module names one.
    ///
    /// # Errors
    /// Modules that say different things, as [`one`](Self::one).
    pub fn model(&self) -> Result<Option<Origin<'_>>, Diagnostic> {
        self.origin("model", |_| false)
    }

    fn origin(
        &self,
        name: &str,
        is_built_in: impl Fn(&Provenance) -> bool,
    ) -> Result<Option<Origin<'_>>, Diagnostic> {
        let Some(Setting { value, module, .. }) = self.setting(name)? else { return Ok(None) };
        Ok(Provenance::parse(value).map(|source| match is_built_in(&source) {
            true => Origin::BuiltIn(source.name),
            false => Origin::File { source, module },
        }))
    }

    /// Tools and work objects: those that are given, and the modules' under other names.
    #[must_use]
    pub fn overrides(&self, tools: &[(String, String)], wobjs: &[(String, String)]) -> Overrides {
        let values_of = |option: &str| {
            self.settings.iter().filter(move |of| of.name == option).map(|of| of.value.as_str()).collect()
        };
        let with = |option: &str, given: &[(String, String)]| {
            let mut all = given.to_vec();
            let values: Vec<&str> = values_of(option);
            for (name, data) in values.into_iter().filter_map(|value| value.split_once('=')) {
                if !all.iter().any(|(known, _)| known.eq_ignore_ascii_case(name)) {
                    all.push((name.to_owned(), data.to_owned()));
                }
            }
            all
        };
        let mut base_fixed = [false; 6];
        for axes in values_of("base-fixed") {
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
            // The original that a program is compared with calls what the program was given.
            added_routines: emit::routines_to_call(&Clock::Elapsed, true),
        }
    }

    /// Joints with which the arm stands when the entry is called, radians: those that are given, else the modules'.
    ///
    /// # Errors
    /// Modules that say different things, as [`one`](Self::one).
    pub fn start_rad(&self, given: Option<[f64; 6]>) -> Result<Option<[f64; 6]>, Diagnostic> {
        match given {
            Some(q_rad) => Ok(Some(q_rad)),
            None => Ok(self.one("start-joints")?.and_then(|text| joints_rad(text).ok())),
        }
    }

    /// How warm the joints are, degrees Celsius.
    ///
    /// # Errors
    /// Modules that say different things, as [`one`](Self::one).
    pub fn joint_temperature_c(&self) -> Result<Option<[f64; 6]>, Diagnostic> {
        Ok(self.one("temperature-c")?.and_then(|text| temperatures_c(text).ok()))
    }

    /// The whole load on the flange, kg.
    ///
    /// # Errors
    /// Modules that say different things, as [`one`](Self::one).
    pub fn payload_kg(&self) -> Result<Option<f64>, Diagnostic> {
        Ok(self.one("payload-kg")?.and_then(|text| text.parse().ok()))
    }
}

/// A setting as it is shown: of a file its name.
fn shown(value: &str) -> String {
    Provenance::parse(value).map_or_else(|| value.to_owned(), |source| source.name)
}

/// Six angles in degrees with commas, as radians.
///
/// # Errors
/// Anything else, as a sentence.
pub fn joints_rad(text: &str) -> Result<[f64; 6], String> {
    let wrong = || "write six angles in degrees with commas, such as 0,0,0,0,30,0".to_owned();
    let numbers = text.split(',').map(|q| q.trim().parse::<f64>().ok().filter(|q| q.is_finite()));
    let degrees: Vec<f64> = numbers.collect::<Option<_>>().ok_or_else(wrong)?;
    let degrees: [f64; 6] = degrees.try_into().map_err(|_| wrong())?;
    Ok(degrees.map(rad_from_deg))
}

/// One temperature for all six joints, or six, degrees Celsius.
///
/// # Errors
/// Anything else, as a sentence.
pub fn temperatures_c(text: &str) -> Result<[f64; 6], String> {
    let all: Vec<f64> = text
        .split(',')
        .map(|t| t.trim().parse::<f64>().ok().filter(|t| t.is_finite()))
        .collect::<Option<_>>()
        .ok_or_else(|| "write one temperature in degrees Celsius, or six with commas".to_owned())?;
    match all[..] {
        [one] => Ok([one; 6]),
        [a, b, c, d, e, f] => Ok([a, b, c, d, e, f]),
        _ => Err(format!("one temperature or six are needed, there are {}", all.len())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Compensation, Robot};

    #[test]
    fn modules_tell_what_they_were_made_with() {
        let cube = ProgramFiles::one("Cube45.mod", *include_bytes!("../../fixtures/robodk/irc5/Cube45.mod"));
        let mut job = Compensation::new(Robot::built_in("irb140").unwrap(), Deformation::paper());
        job.options.start_rad = Some([0.0, 0.0, 0.0, 0.0, rad_from_deg(30.0), 0.0]);
        let made = job.run(&cube).unwrap();
        let emitted = ProgramFiles::new(made.loaded());
        let emitted_settings = EmittedSettings::of(&[&emitted, &cube], None);
        assert_eq!(emitted_settings.robot(), Ok(Origin::BuiltIn("irb140".to_owned())));
        assert_eq!(emitted_settings.deformation(), Ok(Some(Origin::BuiltIn("paper, Table 2".to_owned()))));
        assert_eq!((emitted_settings.model(), emitted_settings.payload_kg()), (Ok(None), Ok(None)));
        assert_eq!(emitted_settings.start_rad(None), Ok(job.options.start_rad));
        assert_eq!(emitted_settings.start_rad(Some([0.1; 6])), Ok(Some([0.1; 6])));
        let bare = EmittedSettings::of(&[&cube], None);
        assert_eq!(bare.robot(), Ok(Origin::BuiltIn("irb140".to_owned())));
        assert_eq!(bare.deformation(), Ok(None));
    }

    #[test]
    fn two_modules_that_say_different_things_are_told() {
        let setting = |value: &str, module: &str| Setting {
            name: "growth".into(),
            value: value.into(),
            module: module.into(),
        };
        let emitted_settings =
            EmittedSettings { settings: vec![setting("exp:30", "a.mod"), setting("exp:40", "b.mod")] };
        let error = emitted_settings.one("growth").unwrap_err();
        assert_eq!(error.code, "made-with::differs");
        assert!(error.message.ends_with("a.mod with exp:30, b.mod with exp:40"), "{error}");
    }
}
