//! The twist of all frames at given joints, and the target moved by it, as RAPID.

use super::deformation::LiveModel;
use super::frames::{FixedFrame, rows};
use super::gears;
use super::gravity::{self, cosine, gives, sine};
use super::offsets;
use super::text::{Body, Summand, Triple, num};
use robot_model::units::{deg_from_rad, mm_from_m};
use std::collections::BTreeSet;

const BEFORE: &str = "  LOCAL FUNC bool tcCorrect(INOUT robtarget tcGoal,robjoint tcQ,PERS tooldata tcTool,num tcSign@WOBJ@)
    ! Moves a target by tcSign times what the deformed arm is off at these joints; FALSE over the cap.
    ! tcDx, tcDy, tcDz are its shift in mm, tcRx, tcRy, tcRz its turn in radians, in the axes of one frame after the other
    VAR pose tcTo;
    VAR pose tcWas;
    VAR pose tcBy;
    VAR pose tcTurn;
twice#    VAR robjoint tcJ;";
const AFTER: &str = include_str!("correct.mod");
/// Names in it that are not the routine's own numbers.
const OTHERS: [&str; 13] = [
    "tcGoal", "tcQ", "tcTool", "tcSign", "tcTo", "tcWas", "tcBy", "tcTurn", "tcJ", "tcN", "tcOff",
    "tcSolved", "tcWarn",
];

/// The lines of the routine.
pub(super) fn routine(model: &LiveModel) -> Vec<String> {
    let mut body = Body::default();
    let loads = (0..6).any(|j| gives(model, j));
    if loads {
        for i in 0..6 {
            trigonometry(&mut body, i, [&sine(i), &cosine(i)]);
        }
        gravity::body(model, &mut body);
    }
    // Where they are needed once more, sines and cosines are kept joint by joint.
    let kept = loads || (0..6).any(|i| !gears::lines(model, i).is_empty());
    frames(model, &mut body, (loads, kept));
    let mut again = Body::default();
    if model.looks_again() {
        evaluate_steep_turns_again(model, &mut again);
    }
    let again = again.into_lines();
    let factor = if model.is_scaled() { "tcE" } else { "tcSign" };
    let squared = |x: f64| num(x * x);
    let (cap_mm, cap_deg) = (mm_from_m(model.cap.shift_m), deg_from_rad(model.cap.turn_rad));
    let numbers = [
        ("@FACTOR@", factor.to_owned()),
        ("@CAP_RAD2@", squared(model.cap.turn_rad)),
        ("@CAP_MM@", num(cap_mm)),
        ("@CAP_DEG@", num(cap_deg)),
        ("@WOBJ@", if model.looks_again() { "\\PERS wobjdata WObj" } else { "" }.to_owned()),
        ("@AGAIN@", again.join("\n")),
    ];
    let filled = |template: &str| model.filled_with(template, &numbers);
    let (mut after, mut behind) = (filled(AFTER), Vec::new());
    let at = |lines: &[String], word: &str| lines.iter().position(|line| line.trim_start().starts_with(word));
    if let Some(end) = at(&after, "ENDFUNC") {
        behind = after.split_off(end);
    }
    if let (Some(from), Some(to)) = (at(&after, "FOR "), at(&after, "ENDFOR")) {
        after[from + 1..to].iter_mut().for_each(|line| line.insert_str(0, "  "));
    }
    let work: Vec<String> = body.into_lines().into_iter().chain(after).collect();
    let mut lines = filled(BEFORE);
    lines.extend(own_numbers(&work).into_iter().map(|name| format!("    VAR num {name}:=0;")));
    lines.extend(work);
    lines.extend(behind);
    lines
}

/// The names of the numbers that the statements use.
fn own_numbers(work: &[String]) -> BTreeSet<String> {
    let code = work.iter().filter(|line| !line.trim_start().starts_with('!'));
    let words = code
        .flat_map(|line| line.split('"').step_by(2))
        .flat_map(|code| code.split(|c: char| !c.is_ascii_alphanumeric() && c != '_'));
    words
        .filter(|word| word.starts_with("tc") && !OTHERS.contains(word))
        .filter(|word| word.strip_prefix("tcF").is_none_or(|n| n.parse::<u32>().is_err()))
        .map(str::to_owned)
        .collect()
}

fn trigonometry(body: &mut Body, i: usize, [sin, cos]: [&str; 2]) {
    body.line(format!("{sin}:=Sin(tcQ.rax_{});", i + 1));
    body.line(format!("{cos}:=Cos(tcQ.rax_{});", i + 1));
}

/// Carries shift and turn into the next frame, which is off itself, before its joint turns.
fn into_frame(step: &FixedFrame, carried: [&mut Triple; 2], off: [[Vec<Summand>; 3]; 2], body: &mut Body) {
    let ([shift, turn], [shifts, turns]) = (carried, off);
    let lever = [step.place_m.x, step.place_m.y, step.place_m.z].map(mm_from_m);
    for (k, own) in shifts.into_iter().enumerate() {
        let summands: Vec<Summand> = turn.cross(&lever, k).into_iter().chain(own).collect();
        body.increase(shift, k, &summands);
    }
    for (k, own) in turns.iter().enumerate() {
        body.increase(turn, k, own);
    }
    let back = rows(&step.rotation.transpose());
    body.rotate(shift, &back);
    body.rotate(turn, &back);
}

fn comment(i: usize, step: &FixedFrame) -> String {
    step.axis.map_or_else(|| "! Flange".to_owned(), |_| format!("! Joint {}", i + 1))
}

/// The twist through all frames, up to the flange; `loads`: sines and cosines are there, `kept`: they stay.
fn frames(model: &LiveModel, body: &mut Body, (loads, kept): (bool, bool)) {
    let mut shift = Triple::zero("tcD");
    let mut turn = Triple::zero("tcR");
    for (i, step) in model.steps.iter().enumerate() {
        let (off, own) = offsets::at_once(model, i);
        if !turn.is_zero() || !shift.is_zero() || off.iter().flatten().any(|part| !part.is_empty()) {
            body.line(comment(i, step));
        }
        into_frame(step, [&mut shift, &mut turn], off, body);
        let Some((axis, sign)) = step.axis else { continue };
        let turns_with = |t: &Triple| (0..3).any(|k| k != axis && t.get(k).is_some());
        let names = if kept { [sine(i), cosine(i)] } else { ["tcS".to_owned(), "tcC".to_owned()] };
        let names = [names[0].as_str(), names[1].as_str()];
        let lines = !gears::lines(model, i).is_empty();
        if !loads && (turns_with(&shift) || turns_with(&turn) || lines) {
            trigonometry(body, i, names);
        }
        body.turn(&mut shift, axis, -sign, names);
        body.turn(&mut turn, axis, -sign, names);
        let gains = model.turns[i].iter().filter(|turn| turn.is_gain()).filter_map(|turn| turn.summand(sign));
        let mut own: Vec<Summand> = own.into_iter().chain(gains).collect();
        own.extend(gears::body(model, i, sign, body));
        if gives(model, i) {
            own.push((sign, format!("tcT{}", i + 1)));
        }
        body.increase(&mut turn, axis, &own);
    }
    // The tool's lever asks for all six.
    [&shift, &turn].into_iter().for_each(|carried| body.zero_stale(carried));
}

/// What the twist is more at the joints `tcJ` than at `tcQ`, of the turns that are steep.
fn evaluate_steep_turns_again(model: &LiveModel, body: &mut Body) {
    let mut shift = Triple::zero("tcX");
    let mut turn = Triple::zero("tcY");
    for (i, step) in model.steps.iter().enumerate() {
        into_frame(step, [&mut shift, &mut turn], Default::default(), body);
        let Some((axis, sign)) = step.axis else { continue };
        let names = [sine(i), cosine(i)];
        let names = [names[0].as_str(), names[1].as_str()];
        body.turn(&mut shift, axis, -sign, names);
        body.turn(&mut turn, axis, -sign, names);
        let more = gears::change(model, i, sign, body);
        body.increase(&mut turn, axis, &more);
    }
    for (of, stem) in [(&shift, "tcD"), (&turn, "tcR")] {
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            body.add(&format!("{stem}{axis}"), true, &of.times(k, 1.0).into_iter().collect::<Vec<_>>());
        }
    }
}
