//! What an identified model asks of each motion besides its joints and their directions: the load from the tool; and warnings where
//! a motion leaves the ranges in which the model was found.

use super::messages::{Messages, span_of};
use super::model::Model;
use super::options::FormChoice;
use super::resolved::Resolved;
use crate::schedule::Schedule;
use nalgebra::{Point3, Vector3};
use rapid_program::Program;
use rapid_program::data::{LoadData, ToolData, WobjData};
use rapid_program::motion::{Motion, RoutineId};
use rapid_syntax::diagnostic::Diagnostic;
use robot_model::deform::Payload;
use robot_model::deform::identified::Identified;
use robot_model::robot::Axis;
use robot_model::units::{deg_from_rad, rad_from_deg};
use std::collections::BTreeMap;

/// Joints this far outside the ranges seen are still inside, degrees.
const SLACK_DEG: f64 = 1.0;
/// The same for temperatures, degrees Celsius.
const SLACK_C: f64 = 1.0;
/// The same for the payload, kg.
const SLACK_KG: f64 = 0.1;

/// Fills in the load of every point, where the model depends on it.
pub(super) fn fill(program: &Program, model: &Model<'_>, resolved: &mut [Resolved]) {
    for (motion, resolved) in program.motions.iter().zip(resolved) {
        let setup = &motion.setup;
        resolved.set_payload(payload_under(setup.tool.as_ref(), setup.wobj.as_ref(), motion, model));
    }
}

/// What hangs on the flange in a motion with such a tool and work object, where the model depends on it: the tool's load data (RAPID
/// gives its centre in the flange's frame) and what is gripped, where that is known.
pub(super) fn payload_under(
    tool: Option<&ToolData>,
    wobj: Option<&WobjData>,
    motion: &Motion,
    model: &Model<'_>,
) -> Payload {
    if !needs_load(model) {
        return Payload::default();
    }
    payload_of((tool, wobj), motion.setup.grip.unwrap_or_default(), model.payload_kg)
}

/// Whether what is asked at run time takes another load than hangs on the flange in a motion: it asks for the tool's own.
pub(super) fn is_beyond_own_load(motion: &Motion, model: &Model<'_>) -> bool {
    let (tool, wobj) = (motion.setup.tool.as_ref(), motion.setup.wobj.as_ref());
    let own = || payload_of((tool, wobj), LoadData::default(), model.payload_kg);
    needs_load(model) && (motion.setup.has_total_load || payload_under(tool, wobj, motion, model) != own())
}

fn needs_load(model: &Model<'_>) -> bool {
    model.identified.as_ref().is_some_and(|identified| identified.needs_load())
}

/// What hangs on the flange with a tool and what is gripped, whose centre is given in the frame of a tool that the robot holds, else in the
/// object frame of the work object that it holds (ABB, RAPID reference manual, loaddata).
pub(super) fn payload_of(
    (tool, wobj): (Option<&ToolData>, Option<&WobjData>),
    grip: LoadData,
    given_kg: Option<f64>,
) -> Payload {
    let load = tool.map(|tool| tool.load).unwrap_or_default();
    if let Some(mass_kg) = given_kg {
        return Payload { mass_kg, cog_m: load.cog_m };
    }
    let own_kg = if load.weighs_nothing() { 0.0 } else { load.mass_kg };
    let holder = match tool.filter(|_| !grip.weighs_nothing()) {
        Some(tool) if tool.robhold => Some(tool.frame_from_tcp),
        Some(_) => wobj.filter(|wobj| wobj.robhold).map(WobjData::frame_from_object),
        None => None,
    };
    let Some(flange_from_holder) = holder else {
        return Payload { mass_kg: own_kg, cog_m: load.cog_m };
    };
    let gripped_m = (flange_from_holder * Point3::from(grip.cog_m)).coords;
    let mass_kg = own_kg + grip.mass_kg;
    let cog_m = (Vector3::from(load.cog_m) * own_kg + gripped_m * grip.mass_kg) / mass_kg;
    Payload { mass_kg, cog_m: cog_m.into() }
}

/// Warns of what the model does not know of a program's motions, some of which may ask it at run time.
pub(super) fn check(
    program: &Program,
    model: &Model<'_>,
    resolved: &[Resolved],
    form: FormChoice,
    messages: &mut Messages,
) {
    let Some(identified) = &model.identified else { return };
    let unknown_grip = identified.needs_load() && model.payload_kg.is_none();
    for (motion, resolved) in program.motions.iter().zip(resolved) {
        let asks = form.corrects_run_time() && motion.run_time && resolved.skip_reason().is_some();
        if asks && unknown_grip && (motion.setup.grip.is_none() || is_beyond_own_load(motion, model)) {
            let text = format!(
                "line {}: the model is asked at run time with the tool's own load, not with what GripLoad has put on it or \\TLoad says",
                motion.line
            );
            let message = Diagnostic::warning("model::live-load", text).at(span_of(motion));
            let help = "--payload-kg KG names the whole load on the flange";
            messages.add(Some(motion.setup.routine), message.help(help));
        }
        if unknown_grip && motion.setup.grip.is_none() && !resolved.q_rad().is_empty() {
            let text = format!(
                "line {}: what GripLoad has put on the tool, or \\TLoad says, is not known here",
                motion.line
            );
            let message = Diagnostic::warning("model::gripload", text).at(span_of(motion));
            let help =
                "the tool's own load data are taken; --payload-kg KG names the whole load on the flange";
            messages.add(Some(motion.setup.routine), message.help(help));
        }
        for q_rad in resolved.q_rad() {
            check_point(motion, q_rad, model, messages);
        }
    }
    check_loads(program, identified, resolved, messages);
}

/// Warns of what the model has that a program cannot have, and of the conditions for which it is asked.
pub(super) fn check_model(model: &Model<'_>, schedule: Option<&Schedule>, messages: &mut Messages) {
    // One message: of several with one code only the first is shown, and each of these is something else.
    if !model.left_out.is_empty() {
        let text = format!("of the model {}", model.left_out.join("; "));
        messages.add(None, Diagnostic::warning("model::left-out", text));
    }
    warn_of_mounting(model, messages);
    warmer(model, messages);
    if let Some(schedule) = schedule {
        check_schedule(model, schedule, messages);
    }
}

/// Warns of terms that may be the instrument's or the reflector's: measurements show base and instrument, tool and reflector as one.
fn warn_of_mounting(model: &Model<'_>, messages: &mut Messages) {
    let Some(identified) = &model.identified else { return };
    let mut names: Vec<&str> =
        identified.terms.iter().filter(|t| t.kind.is_of_mounting()).map(|t| t.kind.name()).collect();
    sorting::ascending(&mut names);
    names.dedup();
    if names.is_empty() {
        return;
    }
    let text = format!(
        "the model's terms of base and tool ({}) are taken for the robot's: programs are corrected for them as for the arm itself",
        names.join(", ")
    );
    let help = "right where the robot's base or its tool moved; where it was the instrument's stand or the reflector, take the term out of \
                the model first";
    messages.add(None, Diagnostic::warning("model::base-and-tool", text).help(help));
}

/// Warns where the joints are said to be warmer or colder than they were measured.
fn warmer(model: &Model<'_>, messages: &mut Messages) {
    let Some(identified) = model.identified.as_ref().filter(|m| m.needs_temperature()) else { return };
    let (Some(seen), Some(now)) = (identified.measured_range.joint_temperature_c, model.joint_temperature_c)
    else {
        return;
    };
    let outside = (0..6).find(|&j| now[j] < seen[j][0] - SLACK_C || now[j] > seen[j][1] + SLACK_C);
    let Some(j) = outside else { return };
    let [low, high] = seen[j];
    let text =
        format!("axis {} is at {} C; the model was found between {low} and {high} C", Axis::at(j), now[j]);
    let help = "outside of what was measured the model is a guess: measure that warm too";
    messages.add(None, Diagnostic::warning("model::temperature-range", text).help(help));
}

/// Warns of motions under loads that the model was not found with, and says in each routine which is the furthest.
fn check_loads(program: &Program, identified: &Identified, resolved: &[Resolved], messages: &mut Messages) {
    if !identified.needs_load() {
        return;
    }
    let [low, high] = identified.measured_range.payload_kg.unwrap_or([0.0, 0.0]);
    let beyond_kg = |kg: f64| (low - kg).max(kg - high);
    let loads = || {
        program.motions.iter().zip(resolved).flat_map(|(motion, resolved)| {
            (0..resolved.q_rad().len()).map(move |k| (resolved.conditions_at(k).payload.mass_kg, motion))
        })
    };
    let mut furthest: BTreeMap<RoutineId, (f64, u32)> = BTreeMap::new();
    for (kg, motion) in loads() {
        let known = furthest.entry(motion.setup.routine).or_insert((kg, motion.line));
        if beyond_kg(kg) > beyond_kg(known.0) {
            *known = (kg, motion.line);
        }
    }
    for (kg, motion) in loads().filter(|(kg, _)| beyond_kg(*kg) > SLACK_KG) {
        let further = furthest.get(&motion.setup.routine).filter(|(further_kg, _)| *further_kg != kg);
        let elsewhere = further.map_or_else(String::new, |(kg, line)| format!(", {kg} kg in line {line}"));
        let text = format!(
            "line {}: the load is {kg} kg{elsewhere}; the model was found with {low} to {high} kg",
            motion.line
        );
        let message = Diagnostic::warning("model::payload", text).at(span_of(motion));
        let help = "measure with that load too, or name the load with --payload-kg";
        messages.add(Some(motion.setup.routine), message.help(help));
    }
}

fn check_point(motion: &Motion, q_rad: &[f64; 6], model: &Model<'_>, messages: &mut Messages) {
    let Some(identified) = &model.identified else { return };
    let seen = &identified.measured_range;
    let mut warn = |code, text: String, help: &'static str| {
        let message = Diagnostic::warning(code, format!("line {}: {text}", motion.line));
        messages.add(Some(motion.setup.routine), message.at(span_of(motion)).help(help));
    };
    let slack_rad = rad_from_deg(SLACK_DEG);
    let is_outside =
        |j: &usize, [low, high]: [f64; 2]| q_rad[*j] < low - slack_rad || q_rad[*j] > high + slack_rad;
    let outside =
        seen.q_rad.and_then(|seen| (0..6).map(|j| (j, seen[j])).find(|(j, range)| is_outside(j, *range)));
    if let Some((j, range)) = outside {
        let [low, high] = range.map(deg_from_rad);
        warn(
            "model::range",
            format!(
                "axis {} stands at {:.1} deg; the model was found between {low:.1} and {high:.1} deg",
                Axis::at(j),
                deg_from_rad(q_rad[j])
            ),
            "outside of what was measured the model is a guess: measure there too",
        );
    }
}

/// Warns where the schedule goes on after the minutes that were measured.
fn check_schedule(model: &Model<'_>, schedule: &Schedule, messages: &mut Messages) {
    let Some(identified) = model.identified.as_ref().filter(|m| m.moves_with_time()) else { return };
    let (Some([_, high]), Some(last)) = (identified.measured_range.t_min, schedule.buckets.last()) else {
        return;
    };
    if last.from_min > high + 1.0 {
        messages.add(
            None,
            Diagnostic::warning(
                "model::time",
                format!(
                    "the schedule goes on to minute {:.0}; the model was found up to minute {high:.0}",
                    last.from_min
                ),
            )
            .help(
                "after what was measured the growth law is believed: --until MIN ends the schedule earlier",
            ),
        );
    }
}
