//! Defaults of a shop: `driftpost.toml`, found upwards from what a command works on. The command line wins.

use super::{OUTPUTS, files, suggest};
use clap::error::{ContextKind, ContextValue};
use clap::parser::ValueSource;
use clap::{Arg, ArgMatches, Command};
use rapid_syntax::diagnostic::Diagnostic;
use std::any::TypeId;
use std::collections::BTreeSet;
use std::ffi::OsString;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// What a folder's defaults stand in.
const FILE: &str = "driftpost.toml";
/// Commands that take defaults. Those that work on an emitted program read what it was made with from its own comments.
const COMMANDS: [&str; 10] = [
    "accuracy",
    "closed-loop",
    "compare-measurements",
    "compensate",
    "diagnose",
    "fit",
    "plan",
    "state",
    "tabulate",
    "validate",
];
/// Options that say what is done this time, beside those that name a result.
const THIS_TIME: [&str; 8] =
    ["in_place", "force", "all", "settings", "show_settings", "quiet", "watch", "joints_hint"];

/// The defaults that hold for a command.
#[derive(Debug, Default)]
pub struct Settings {
    /// The file they stand in.
    path: PathBuf,
    /// The command that they are for.
    command: String,
    /// Words of the command line that say the same.
    words: Vec<OsString>,
    /// The options that are set, by their ids.
    ids: BTreeSet<String>,
    /// The file is named for a command that takes none.
    is_idle: bool,
}

impl Settings {
    /// The defaults of the file that `--settings` names, or that is found upwards from the command's first file, or, where it works on
    /// none, from the working folder; none for commands that take none.
    ///
    /// # Errors
    /// `settings::*`, naming file and key.
    pub fn find(command: &Command, matches: &ArgMatches) -> Result<Self, Diagnostic> {
        let Some((name, given)) = matches.subcommand() else { return Ok(Self::default()) };
        let named = matches.get_one::<PathBuf>("settings").or_else(|| given.get_one("settings"));
        if !COMMANDS.contains(&name) {
            let Some(path) = named else { return Ok(Self::default()) };
            files::read(path, "file of settings")?;
            return Ok(Self {
                path: path.clone(),
                command: name.to_owned(),
                is_idle: true,
                ..Self::default()
            });
        }
        let found = named.cloned().or_else(|| upwards(&start(command.find_subcommand(name)?, given)));
        let Some(path) = found else { return Ok(Self::default()) };
        // Built: only then the commands know the options that all of them have.
        let mut built = command.clone();
        built.build();
        let command = &built;
        let wrong =
            |code: &'static str, text: String| Diagnostic::error(code, format!("{}: {text}", path.display()));
        let text = String::from_utf8(files::read(&path, "file of settings")?)
            .map_err(|error| wrong("settings::toml", error.to_string()))?;
        let table: toml::Table =
            toml::from_str(&text).map_err(|error| wrong("settings::toml", error.to_string()))?;
        let mut settings = Self { path: path.clone(), command: name.to_owned(), ..Self::default() };
        let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
        let own = own_table(command, name, &table).map_err(|(code, text)| wrong(code, text))?;
        // What stands under the command's own name wins over what stands for all.
        let shared = table.iter().filter(|(key, value)| !value.is_table() && !own.contains_key(*key));
        let all: Vec<_> = shared.chain(&own).collect();
        let Some(command) = command.find_subcommand(name) else { return Ok(settings) };
        for (key, value) in all {
            let Some(arg) = command.get_arguments().find(|arg| arg.get_long() == Some(key)) else { continue };
            if is_overridden(command, given, arg) {
                continue;
            }
            settings.words.extend(words(key, value, |text| in_folder(arg, &folder, text)));
            settings.ids.insert(arg.get_id().to_string());
        }
        Ok(settings)
    }

    /// Whether a file says any.
    #[must_use]
    pub fn are_given(&self) -> bool {
        !self.words.is_empty()
    }

    /// That the file which is named is not read.
    #[must_use]
    pub fn warning(&self) -> Option<Diagnostic> {
        let Self { path, command, .. } = self;
        let text = format!("{command} takes no defaults: {} is passed over", path.display());
        let help = format!("settings are read by {}", COMMANDS.join(", "));
        self.is_idle.then(|| Diagnostic::warning("settings::not-read", text).help(help))
    }

    /// The command line with the defaults in it, behind the name of the command.
    #[must_use]
    pub fn add_to(&self, words: &[OsString]) -> Vec<OsString> {
        let is_value = |at: usize| at > 0 && words[at - 1] == "--settings";
        let at = (1..words.len())
            .find(|&at| words[at] == *self.command && !is_value(at))
            .unwrap_or(words.len() - 1);
        [&words[..=at], &self.words, &words[at + 1..]].concat()
    }

    /// What is wrong with a command line, told of the file where an option of it has its value from there.
    #[must_use]
    pub fn blame(&self, error: &clap::Error) -> Option<Diagnostic> {
        let Some(ContextValue::String(arg)) = error.get(ContextKind::InvalidArg) else { return None };
        let option = arg.split([' ', '=']).next()?;
        let is_it = |word: &OsString| {
            let word = word.to_string_lossy();
            word == option || word.strip_prefix(option).is_some_and(|rest| rest.starts_with('='))
        };
        self.words.iter().any(is_it).then(|| {
            let text = error.to_string();
            let message = text.split("\n\n").next().unwrap_or(&text);
            let message: Vec<&str> = message.trim_start_matches("error: ").split_whitespace().collect();
            Diagnostic::error("settings::value", format!("{}: {}", self.path.display(), message.join(" ")))
        })
    }

    /// Every option of a command with its value and where that comes from.
    #[must_use]
    pub fn table(&self, command: &Command, given: &ArgMatches) -> String {
        let mut text = String::new();
        for arg in command.get_arguments() {
            let (id, Some(long)) = (arg.get_id().as_str(), arg.get_long()) else { continue };
            if given.try_contains_id(id).is_err() || THIS_TIME.contains(&id) || OUTPUTS.contains(&id) {
                continue;
            }
            let values =
                given.get_raw(id).map_or_else(Vec::new, |all| all.map(|v| v.to_string_lossy()).collect());
            let from = match given.value_source(id) {
                Some(ValueSource::CommandLine) if self.ids.contains(id) => self.path.display().to_string(),
                Some(ValueSource::CommandLine) => "command line".to_owned(),
                Some(_) => "default".to_owned(),
                None => continue,
            };
            let value = if values.is_empty() { "true".to_owned() } else { values.join(" ") };
            let _ = writeln!(text, "{long} = {value}  ({from})"); // a String takes everything
        }
        text
    }
}

/// What stands under a command's own name, all keys of the file checked; what is wrong is a code and a text.
fn own_table(
    command: &Command,
    name: &str,
    all: &toml::Table,
) -> Result<toml::Table, (&'static str, String)> {
    let mut own = toml::Table::new();
    for (key, value) in all {
        match (value, COMMANDS.contains(&key.as_str())) {
            (toml::Value::Table(table), true) => {
                check(command, key, table)?;
                if key == name {
                    own.extend(table.clone());
                }
            }
            (toml::Value::Table(_), false) => {
                let near = suggest::nearest(key, COMMANDS);
                let near = near.map_or_else(String::new, |near| format!("; did you mean `[{near}]`?"));
                let text = format!("`[{key}]` is no command that takes defaults{near}");
                return Err(("settings::unknown", text));
            }
            _ => {
                let known = COMMANDS.iter().find(|one| option(command, one, key).is_some());
                let one = toml::Table::from_iter([(key.clone(), value.clone())]);
                check(command, known.copied().unwrap_or(name), &one)?;
            }
        }
    }
    Ok(own)
}

/// Whether the command line gives an option, or one that it cannot stand beside.
fn is_overridden(command: &Command, given: &ArgMatches, arg: &Arg) -> bool {
    let is_given = |id: &str| {
        given.try_contains_id(id).is_ok() && given.value_source(id) == Some(ValueSource::CommandLine)
    };
    let conflicts = command.get_arg_conflicts_with(arg);
    let mut against = command.get_arguments().filter(|other| {
        conflicts.iter().any(|c| c.get_id() == other.get_id())
            || command.get_arg_conflicts_with(other).iter().any(|c| c.get_id() == arg.get_id())
    });
    is_given(arg.get_id().as_str()) || against.any(|other| is_given(other.get_id().as_str()))
}

/// The words of a command line that say what a key of a TOML file says; `place` makes of a text what stands for it. A list of numbers is one
/// value, as of `--tool 0,0,100`; a list of texts repeats its option.
pub fn words(key: &str, value: &toml::Value, place: impl Fn(&str) -> String) -> Vec<OsString> {
    let is_number = |value: &toml::Value| value.is_integer() || value.is_float();
    let values = match value {
        toml::Value::Array(list) if !list.is_empty() && list.iter().all(is_number) => {
            let numbers: Vec<String> = list.iter().map(toml::Value::to_string).collect();
            return vec![format!("--{key}={}", numbers.join(",")).into()];
        }
        toml::Value::Array(list) => list.as_slice(),
        one => std::slice::from_ref(one),
    };
    let word = |value: &toml::Value| match value {
        toml::Value::Boolean(true) => Some(format!("--{key}").into()),
        toml::Value::Boolean(false) => None,
        toml::Value::String(text) => Some(format!("--{key}={}", place(text)).into()),
        number => Some(format!("--{key}={number}").into()),
    };
    values.iter().filter_map(word).collect()
}

fn option<'c>(command: &'c Command, name: &str, key: &str) -> Option<&'c Arg> {
    command.find_subcommand(name)?.get_arguments().find(|arg| arg.get_long() == Some(key))
}

/// Whether the keys of a table are options of a command that may have a default.
fn check(command: &Command, name: &str, table: &toml::Table) -> Result<(), (&'static str, String)> {
    for key in table.keys() {
        let Some(arg) = option(command, name, key) else {
            let known = command.find_subcommand(name).into_iter().flat_map(Command::get_arguments);
            let near = suggest::nearest(key, known.filter_map(Arg::get_long));
            let near = near.map_or_else(String::new, |near| format!("; did you mean `{near}`?"));
            return Err(("settings::unknown", format!("`{key}` is no option of {name}{near}")));
        };
        let id = arg.get_id().as_str();
        if THIS_TIME.contains(&id) || OUTPUTS.contains(&id) || id.ends_with("_out") {
            return Err(("settings::not-a-default", format!("`{key}` belongs on the command line")));
        }
    }
    Ok(())
}

/// A file as the folder of the settings has it; what is no file stays as it is.
fn in_folder(arg: &Arg, folder: &Path, text: &str) -> String {
    // Robot and table of a task may be files, too.
    if arg.get_id() == "task"
        && let Some((task, models)) = text.split_once('=')
    {
        let placed = models.split(',').map(|name| {
            let file = folder.join(name.trim());
            if file.is_file() { file.display().to_string() } else { name.trim().to_owned() }
        });
        return format!("{task}={}", placed.collect::<Vec<_>>().join(","));
    }
    let file = folder.join(text);
    let is_path = arg.get_value_parser().type_id() == TypeId::of::<PathBuf>();
    if is_path || file.is_file() { file.display().to_string() } else { text.to_owned() }
}

/// The first file or folder that a command works on, else the working folder.
fn start(command: &Command, given: &ArgMatches) -> PathBuf {
    let first = command.get_positionals().next().map(|arg| arg.get_id().as_str());
    // Measurements may stand in two files.
    let ids = first.into_iter().chain(["points"]);
    let mut paths = ids.filter_map(|id| given.try_get_many::<PathBuf>(id).ok().flatten()?.next());
    paths.next().cloned().unwrap_or_else(|| PathBuf::from("."))
}

/// The nearest of its name; a folder and a link to nothing are found too, for whoever put them there means something by it.
fn upwards(from: &Path) -> Option<PathBuf> {
    let real = std::path::absolute(from).ok()?;
    let is_meant = |file: &PathBuf| file.is_file() || file.is_dir() || file.is_symlink();
    real.ancestors().map(|folder| folder.join(FILE)).find(is_meant)
}
