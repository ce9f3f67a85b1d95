//! `tcCorrect`: the twist of the deformed arm at given joints, and a target moved by it.

use super::deformation::LiveModel;
use super::frames::rows;
use super::gravity::{self, cosine, gives, sine};
use super::text::{Body, Summand, Triple, num};
use robot_model::units::{deg_from_rad, mm_from_m};
use std::collections::BTreeSet;

const BEFORE: &str = "  LOCAL FUNC bool tcCorrect(INOUT robtarget tcGoal,robjoint tcQ,PERS tooldata tcTool,num tcSign)
    ! Moves a target by tcSign times what the deformed arm is off at these joints; FALSE over the cap.
    ! tcDx, tcDy, tcDz are its shift in mm, tcRx, tcRy, tcRz its turn in radians, in the axes of one frame after the other
    VAR pose tcTo:=[[0,0,0],[1,0,0,0]];
    VAR pose tcBy:=[[0,0,0],[1,0,0,0]];
    VAR pose tcTurn:=[[0,0,0],[1,0,0,0]];";
const AFTER: &str = include_str!("correct.mod");
/// Names in it that are not the routine's own numbers.
const OTHERS: [&str; 7] = ["tcGoal", "tcQ", "tcTool", "tcSign", "tcTo", "tcBy", "tcTurn"];

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
    frames(model, &mut body, loads);
    let factor = if model.is_scaled() { "tcSign*tcF1" } else { "tcSign" };
    let squared = |x: f64| num(x * x);
    let (cap_mm, cap_deg) = (mm_from_m(model.cap.shift_m), deg_from_rad(model.cap.turn_rad));
    let numbers = [
        ("@FACTOR@", factor.to_owned()),
        ("@CAP_MM2@", squared(cap_mm)),
        ("@CAP_RAD2@", squared(model.cap.turn_rad)),
        ("@CAP_MM@", num(cap_mm)),
        ("@CAP_DEG@", num(cap_deg)),
    ];
    let after = AFTER
        .lines()
        .map(|line| numbers.iter().fold(line.to_owned(), |l, (mark, text)| l.replace(mark, text)));
    let work: Vec<String> = body.into_lines().into_iter().chain(after).collect();
    let mut lines: Vec<String> = BEFORE.lines().map(str::to_owned).collect();
    lines.extend(own_numbers(&work).into_iter().map(|name| format!("    VAR num {name}:=0;")));
    lines.extend(work);
    lines
}

/// The names of the numbers that the statements use.
fn own_numbers(work: &[String]) -> BTreeSet<String> {
    let code = work.iter().filter(|line| !line.trim_start().starts_with('!'));
    let words = code
        .flat_map(|line| line.split('"').step_by(2))
        .flat_map(|code| code.split(|c: char| !c.is_ascii_alphanumeric() && c != '_'));
    words
        .filter(|word| word.starts_with("tc") && !OTHERS.contains(word) && *word != "tcWarn")
        .filter(|word| word.strip_prefix("tcF").is_none_or(|n| n.parse::<u32>().is_err()))
        .map(str::to_owned)
        .collect()
}

fn trigonometry(body: &mut Body, i: usize, [sin, cos]: [&str; 2]) {
    body.line(format!("{sin}:=Sin(tcQ.rax_{});", i + 1));
    body.line(format!("{cos}:=Cos(tcQ.rax_{});", i + 1));
}

/// The twist through all frames, up to the flange.
fn frames(model: &LiveModel, body: &mut Body, loads: bool) {
    let mut shift = Triple::zero("tcD");
    let mut turn = Triple::zero("tcR");
    for (i, step) in model.steps.iter().enumerate() {
        let [shifts, turns] = offsets(model, i);
        let all = shifts.iter().chain(&turns).flatten();
        if !turn.is_zero() || !shift.is_zero() || all.count() > 0 {
            body.line(match step.axis {
                Some(_) => format!("! Joint {}", i + 1),
                None => "! Flange".to_owned(),
            });
        }
        let lever = [step.place_m.x, step.place_m.y, step.place_m.z].map(mm_from_m);
        for (k, own) in shifts.into_iter().enumerate() {
            let summands: Vec<Summand> = turn.cross(&lever, k).into_iter().chain(own).collect();
            body.increase(&mut shift, k, &summands);
        }
        for (k, own) in turns.iter().enumerate() {
            body.increase(&mut turn, k, own);
        }
        let back = rows(&step.rotation.transpose());
        body.rotate(&mut shift, &back);
        body.rotate(&mut turn, &back);
        let Some((axis, sign)) = step.axis else { continue };
        let turns_with = |t: &Triple| (0..3).any(|k| k != axis && t.get(k).is_some());
        let names = if loads { [sine(i), cosine(i)] } else { ["tcS".to_owned(), "tcC".to_owned()] };
        let names = [names[0].as_str(), names[1].as_str()];
        if !loads && (turns_with(&shift) || turns_with(&turn)) {
            trigonometry(body, i, names);
        }
        body.turn(&mut shift, axis, -sign, names);
        body.turn(&mut turn, axis, -sign, names);
        let mut own: Vec<Summand> = model.turns[i].iter().flat_map(|t| t.summands(i, sign)).collect();
        if gives(model, i) {
            own.push((sign, format!("tcT{}", i + 1)));
        }
        body.increase(&mut turn, axis, &own);
    }
}

/// What frame `i` adds: shift in mm and turn in radians, by component.
fn offsets(model: &LiveModel, i: usize) -> [[Vec<Summand>; 3]; 2] {
    let mut parts: [[Vec<Summand>; 3]; 2] = Default::default();
    for function in (0..model.functions()).map(Some).chain([None]) {
        let factor = match function {
            Some(r) if !model.is_scaled() => format!("tcF{}", r + 1),
            _ => String::new(),
        };
        let [shift_m, turn_rad] = model.row(function, i);
        for k in 0..3 {
            for (part, value) in parts.iter_mut().zip([mm_from_m(shift_m[k]), turn_rad[k]]) {
                if !super::text::is_nothing(value) {
                    part[k].push((value, factor.clone()));
                }
            }
        }
    }
    parts
}
