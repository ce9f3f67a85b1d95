//! The robot and its deformation, as the options name them.

use super::{files, suggest};
use crate::application::{check_base, check_bases};
use driftpost::application::Named;
use rapid_program::compensate::JointsHint;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::Identified;
use robot_model::deform::{DeformError, Deformation, GrowthLaw};
use robot_model::robot::{BackedUp, DhConvention, Robot, SerialArm};
use std::path::{Path, PathBuf};

/// As [`robot`], with what the header of an emitted program says of it.
///
/// # Errors
/// As [`robot`].
pub fn robot_with_source(name: &str) -> Result<Named<Robot>, Diagnostic> {
    let model = robot(name)?;
    Ok(match Robot::built_in_file(name) {
        Some(text) => Named::new(model, name, text.as_bytes()),
        None => {
            if backup(name).is_some() {
                // The dimensions are a built-in robot's; the bounds make it this one.
                let text = model.to_toml();
                return Ok(Named::new(model, name, text.as_bytes()));
            }
            let described = dh_table(name).map(|(path, _)| path).or(urdf(name).map(|(path, _)| path));
            let path = described.unwrap_or(Path::new(name));
            Named::new(model, file_name(path), &files::read(path, "robot file")?)
        }
    })
}

/// As [`deformation`], with what the header of an emitted program says of it.
///
/// # Errors
/// As [`deformation`].
pub fn deformation_with_source(
    file: Option<&Path>,
    growth: Option<&str>,
) -> Result<Named<Deformation>, Diagnostic> {
    let model = deformation(file, growth)?;
    Ok(match file {
        None => Named::of_paper_table(model),
        Some(path) => Named::new(model, file_name(path), &files::read(path, "deformation table")?),
    })
}

/// The identified model of a file, with what the header of an emitted program says of it.
///
/// # Errors
/// A file that cannot be read, or what is wrong in it.
pub fn identified(path: &Path) -> Result<Named<Identified>, Diagnostic> {
    let bytes = files::read(path, "model")?;
    let text = String::from_utf8_lossy(&bytes);
    let model =
        Identified::from_toml(&text).map_err(|error| in_file(&path.display().to_string(), error.into()))?;
    Ok(Named::new(model, file_name(path), &bytes))
}

/// The joints that a program's motions are known to end with.
///
/// # Errors
/// A file that cannot be read, or what is wrong in it.
pub fn joints_hint(path: &Path) -> Result<JointsHint, Diagnostic> {
    let bytes = files::read(path, "joints hint")?;
    JointsHint::read(&bytes).map_err(|error| in_file(&path.display().to_string(), error.into()))
}

/// The deformation beside a model: the table that is named, else none, growing as the model's own terms do.
///
/// # Errors
/// As [`deformation_with_source`].
pub fn deformation_beside(
    model: &Named<Identified>,
    file: Option<&Path>,
    growth: Option<&str>,
) -> Result<Named<Deformation>, Diagnostic> {
    match file {
        None => Ok(Named::of_model_alone(model, growth.map(growth_law).transpose()?)),
        Some(_) => Ok(deformation_with_source(file, growth)?.with_model(model)),
    }
}

/// The last part of a path: what an emitted program calls a file, wherever it stood.
pub fn file_name(path: &Path) -> String {
    path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned())
}

/// The six-axis robot that `--robot` names: a built-in one, or a file.
///
/// # Errors
/// What is wrong with the name or the file; `robot::six-axis` for an arm of other joints.
pub fn robot(name: &str) -> Result<Robot, Diagnostic> {
    arm(name)?.six_axis().map_err(|error| in_file(name, error.into()))
}

/// The arm that `--robot` names, of four to seven joints: a built-in robot, or a file.
///
/// # Errors
/// What is wrong with the name or the file.
pub fn arm(name: &str) -> Result<SerialArm, Diagnostic> {
    if let Some(robot) = Robot::built_in(name) {
        return Ok(robot.into());
    }
    if let Some(found) = backup(name) {
        return Ok(found?.robot.into());
    }
    if let Some((path, convention)) = dh_table(name) {
        let bytes = files::read(path, "Denavit-Hartenberg table")?;
        let called = path.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        return SerialArm::from_dh(&bytes, convention, &called)
            .map_err(|error| in_file(&path.display().to_string(), error.into()));
    }
    if let Some((path, tip)) = urdf(name) {
        let bytes = files::read(path, "URDF description")?;
        return SerialArm::from_urdf(&String::from_utf8_lossy(&bytes), tip)
            .map_err(|error| in_file(&path.display().to_string(), error.into()));
    }
    let path = Path::new(name);
    let looks_like_a_path =
        path.components().count() > 1 || path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"));
    if !path.exists() && !looks_like_a_path {
        return Ok(Robot::by_name(name)?.into());
    }
    let bytes = files::read(path, "robot file")?;
    let text = std::str::from_utf8(&bytes).map_err(|error| {
        Diagnostic::error("robot::toml", format!("{name}: not UTF-8 text after byte {}", error.valid_up_to()))
    })?;
    SerialArm::from_toml(text).map_err(|error| in_file(name, error.into()))
}

/// What the backup says that `backup:FOLDER` or `backup:FOLDER:UNIT` names; `None` where the name is no such.
pub fn backup(name: &str) -> Option<Result<BackedUp, Diagnostic>> {
    let rest = name.strip_prefix("backup:")?;
    let (folder, unit) = match rest.rsplit_once(':') {
        Some((folder, unit)) if !unit.contains(['/', '\\']) && !folder.is_empty() && folder.len() > 1 => {
            (folder, Some(unit))
        }
        _ => (rest, None),
    };
    let path = moc_of(folder);
    Some(files::read(&path, "backup's MOC.cfg").and_then(|bytes| {
        BackedUp::from_moc(&String::from_utf8_lossy(&bytes), unit)
            .map_err(|error| in_file(&path.display().to_string(), error.into()))
    }))
}

/// The robot that moves a program: as [`robot`], its base in the world's frame.
///
/// # Errors
/// As [`robot`]; `robot::base-frame` where a backup says that the base stands elsewhere.
pub fn robot_of_program(name: &str) -> Result<Robot, Diagnostic> {
    if let Some(backup) = backup(name).transpose()? {
        check_base(name, &backup)?;
    }
    robot(name)
}

/// Refuses a program in a backup whose robots all stand elsewhere than in the world's frame; says which robots do where not all do.
///
/// # Errors
/// `robot::base-frame`.
pub fn base_beside(program: &Path) -> Result<Option<Diagnostic>, Diagnostic> {
    let real = std::fs::canonicalize(program).unwrap_or_else(|_| program.to_owned());
    let moc = real.ancestors().take(5).map(|folder| folder.join("SYSPAR").join("MOC.cfg"));
    let Some(text) = moc.filter_map(|path| std::fs::read(path).ok()).next() else { return Ok(None) };
    check_bases(&String::from_utf8_lossy(&text))
}

fn moc_of(folder: &str) -> PathBuf {
    Path::new(folder).join("SYSPAR").join("MOC.cfg")
}

/// The table that `dh:FILE.csv` or, by Craig's convention, `mdh:FILE.csv` names.
fn dh_table(name: &str) -> Option<(&Path, DhConvention)> {
    let (convention, path) = match name.split_once(':')? {
        ("dh", path) => (DhConvention::Standard, path),
        ("mdh", path) => (DhConvention::Modified, path),
        _ => return None,
    };
    Some((Path::new(path), convention))
}

/// `FILE.urdf`, or `FILE.urdf:LINK` with the link that is the flange.
fn urdf(name: &str) -> Option<(&Path, Option<&str>)> {
    const ENDING: &str = ".urdf";
    let end = name.to_ascii_lowercase().rfind(ENDING)? + ENDING.len();
    match name.get(end..)? {
        "" => Some((Path::new(name), None)),
        rest => {
            Some((Path::new(name.get(..end)?), Some(rest.strip_prefix(':').filter(|tip| !tip.is_empty())?)))
        }
    }
}

/// The deformation that `--deformation` and `--growth` name; without both the reference paper's.
///
/// # Errors
/// What is wrong with the table or the growth law.
pub fn deformation(file: Option<&Path>, growth: Option<&str>) -> Result<Deformation, Diagnostic> {
    let growth = growth.map(growth_law).transpose()?;
    match (file, growth) {
        (None, None) => Ok(Deformation::paper()),
        (None, Some(growth)) => Ok(Deformation::from_static(Deformation::paper().settled(), growth)),
        (Some(path), growth) => {
            let bytes = files::read(path, "deformation table")?;
            Deformation::from_csv(&bytes, growth)
                .map_err(|error| in_file(&path.display().to_string(), error.into()))
        }
    }
}

fn growth_law(text: &str) -> Result<GrowthLaw, Diagnostic> {
    text.parse().map_err(|error| {
        let word = text.split(':').next().unwrap_or_default();
        let mut refusal = Diagnostic::from(DeformError::Growth(error));
        let near = suggest::nearest(word, ["none", "exp", "two-stage"]).filter(|near| *near != word);
        refusal.help = near.map(|near| format!("did you mean `{near}`?"));
        refusal
    })
}

/// The same message with the file's name before it.
pub fn in_file(name: &str, mut diagnostic: Diagnostic) -> Diagnostic {
    diagnostic.message = format!("{name}: {}", diagnostic.message);
    diagnostic
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_and_paths_are_told_apart() {
        assert_eq!(robot("irb120").unwrap().name, "ABB IRB 120-3/0.58");
        assert_eq!(
            robot("crates/robot-model/src/robot/built_in/irb120.toml").unwrap().name,
            "ABB IRB 120-3/0.58"
        );
        assert_eq!(robot("irb121").unwrap_err().code, "robot::unknown");
        assert_eq!(robot("mine.toml").unwrap_err().code, "input::missing");
        assert_eq!(robot("IRB 2400").unwrap_err().code, "robot::coupled");
        assert_eq!(arm("fixtures/robots/scara.toml").unwrap().joints.len(), 4);
        assert_eq!(robot("fixtures/robots/scara.toml").unwrap_err().code, "robot::six-axis");
    }

    #[test]
    fn without_options_it_is_the_papers_deformation() {
        assert_eq!(deformation(None, None).unwrap(), Deformation::paper());
        let grown = deformation(None, Some("none")).unwrap();
        assert_eq!(grown.offsets_at(0.0), Deformation::paper().settled());
        let table = Path::new("fixtures/paper/table2_deformation.csv");
        let error = deformation(Some(table), None).unwrap_err();
        assert_eq!(error.code, "deform::no-growth");
        assert!(error.message.starts_with("fixtures/paper/table2_deformation.csv: "), "{error}");
        assert_eq!(deformation(Some(table), Some("two-stage:46")).unwrap(), Deformation::paper());
        assert_eq!(deformation(None, Some("linear")).unwrap_err().code, "deform::growth");
    }
}
