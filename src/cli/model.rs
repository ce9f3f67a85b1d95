//! The robot and its deformation, as the options name them.

use super::{files, suggest};
use crate::application::{check_base, check_bases};
use driftpost::application::Named;
use rapid_compensation::compensate::JointsHint;
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::identified::Identified;
use robot_model::deform::{DeformError, Deformation, GrowthLaw};
use robot_model::robot::{BackedUp, Robot, RobotSource, SerialArm};
use std::path::Path;

/// As [`robot`], with what the header of an emitted program says of it.
///
/// # Errors
/// As [`robot`].
pub fn robot_with_source(name: &str) -> Result<Named<Robot>, Diagnostic> {
    let model = robot(name)?;
    let source = RobotSource::named(name);
    Ok(match (source, source.file()) {
        // The dimensions are a built-in robot's; the bounds make it this one.
        (RobotSource::Backup { .. }, _) => {
            let text = model.to_toml();
            Named::new(model, name, text.as_bytes())
        }
        (_, Some(path)) => Named::new(model, file_name(&path), &files::read(&path, "robot file")?),
        (_, None) => {
            let text = Robot::built_in_file(name).unwrap_or_default();
            Named::new(model, name, text.as_bytes())
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
        None => {
            let growth = growth.map(growth_law).transpose()?;
            own_growth(&model.model, growth)?;
            Ok(Named::of_model_alone(model, growth))
        }
        Some(_) => Ok(deformation_with_source(file, growth)?.with_model(model)),
    }
}

/// Refuses a growth law beside a model whose terms have one of their own, which it does not change.
fn own_growth(model: &Identified, growth: Option<GrowthLaw>) -> Result<(), Diagnostic> {
    match (model.warm_up_law(), growth) {
        (Some(own), Some(growth)) if own.law != growth => {
            let laws = match own.is_followed() {
                true => own.law.to_string(),
                false => format!("laws of their own ({} is nearest)", own.law),
            };
            let text =
                format!("the model's terms grow by {laws}, and --growth {growth} does not change them");
            Err(Diagnostic::error("deform::growth-not-used", text).help("leave --growth out"))
        }
        _ => Ok(()),
    }
}

/// The model of a file as [`identified`], and nothing beside it that the model has itself.
///
/// # Errors
/// As [`identified`]; `deform::growth-not-used` where `growth` is another law than the model's.
pub fn identified_alone(path: &Path, growth: Option<&str>) -> Result<Named<Identified>, Diagnostic> {
    let model = identified(path)?;
    own_growth(&model.model, growth.map(growth_law).transpose()?)?;
    Ok(model)
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
    let source = RobotSource::named(name);
    let Some(path) = source.file() else { return Ok(Robot::by_name(name)?.into()) };
    let looks_like_a_path =
        path.components().count() > 1 || path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"));
    if matches!(source, RobotSource::Toml(_)) && !path.exists() && !looks_like_a_path {
        return Ok(Robot::by_name(name)?.into());
    }
    let bytes = files::read(&path, source.file_kind())?;
    if let (RobotSource::Toml(_), Err(error)) = (source, std::str::from_utf8(&bytes)) {
        let text = format!("{name}: not UTF-8 text after byte {}", error.valid_up_to());
        return Err(Diagnostic::error("robot::toml", text));
    }
    source.read(&bytes).map_err(|error| in_file(&path.display().to_string(), error.into()))
}

/// What the backup says that `backup:FOLDER` or `backup:FOLDER:UNIT` names; `None` where the name is no such.
pub fn backup(name: &str) -> Option<Result<BackedUp, Diagnostic>> {
    let source = RobotSource::named(name);
    let RobotSource::Backup { unit, .. } = source else { return None };
    let path = source.file()?;
    Some(files::read(&path, source.file_kind()).and_then(|bytes| {
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
