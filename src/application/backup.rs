//! What a controller's backup says against correcting programs of its robots.

use rapid_syntax::diagnostic::Diagnostic;
use robot_model::robot::{BackedUp, BaseFrame};
use robot_model::units::mm_from_m;

/// Refuses a robot whose base stands elsewhere than in the world's frame; `name` is what it was asked for by.
///
/// # Errors
/// `robot::base-frame`.
pub(crate) fn check_base(name: &str, robot: &BackedUp) -> Result<(), Diagnostic> {
    let Some(BaseFrame { position_m, orientation_wxyz: turned }) = robot.base_frame else { return Ok(()) };
    let at_mm = position_m.map(mm_from_m);
    Err(moved(Diagnostic::error(
        "robot::base-frame",
        format!("the base of {name} stands at {at_mm:?} mm, turned by {turned:?}, in the world"),
    )))
}

/// Refuses programs of a backup whose robots all stand elsewhere than in the world's frame; says which robots do where not all do.
///
/// # Errors
/// `robot::base-frame`.
pub(crate) fn check_bases(moc_cfg: &str) -> Result<Option<Diagnostic>, Diagnostic> {
    let (elsewhere, all) = BackedUp::moved_bases(moc_cfg);
    if elsewhere.is_empty() {
        return Ok(None);
    }
    let text = format!(
        "by the backup's MOC.cfg the base of {} stands elsewhere than in the world's frame",
        elsewhere.join(", ")
    );
    if all {
        return Err(moved(Diagnostic::error("robot::base-frame", text)));
    }
    let warning = Diagnostic::warning("robot::base-frame", text);
    Ok(Some(warning.help("a program of that robot would be corrected for another place: do not load it")))
}

fn moved(message: Diagnostic) -> Diagnostic {
    message.help(
        "targets are given in the world, and corrections are made for an arm whose base is the world's frame; work objects of this one would be taken for other places",
    )
}

/// Refuses a robot that its controller corrects by a calibration of its own, unless `is_in_use` says that this is known.
///
/// # Errors
/// `robot::absolute-accuracy`.
pub(crate) fn check_absolute_accuracy(
    name: &str,
    robot: &BackedUp,
    is_in_use: bool,
) -> Result<(), Diagnostic> {
    if !robot.absolute_accuracy || is_in_use {
        return Ok(());
    }
    let text = format!("{name}: the controller corrects this robot by a calibration of its own");
    Err(Diagnostic::error("robot::absolute-accuracy", text).help(
        "--absolute-accuracy says that it is in use, and leaves alone what would be corrected twice; give the robot's name where it is switched off",
    ))
}
