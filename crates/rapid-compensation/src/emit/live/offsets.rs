//! What the frames' offsets are at this moment: worked out when the clock is brought up to date, not at every motion.

use super::deformation::LiveModel;
use super::text::{Body, Summand, is_nothing};
use super::turns::Turn;
use robot_model::units::mm_from_m;

/// Place of what turns a joint about its own axis among a frame's offsets: behind three shifts and three turns.
const OWN: usize = 6;

/// What frame `i` is off: shift in mm, turn in radians, and its joint's own turn, each as a sum over functions of time.
fn parts(model: &LiveModel, i: usize) -> [Vec<Summand>; 7] {
    let mut parts: [Vec<Summand>; 7] = Default::default();
    for function in (0..model.functions()).map(Some).chain([None]) {
        let factor = match function {
            Some(r) if !model.is_scaled() => format!("tcF{}", r + 1),
            _ => String::new(),
        };
        let [shift_m, turn_rad] = model.row(function, i);
        for k in 0..3 {
            parts[k].push((mm_from_m(shift_m[k]), factor.clone()));
            parts[k + 3].push((turn_rad[k], factor.clone()));
        }
    }
    if let (Some(turns), Some((_, sign))) = (model.turns.get(i), model.steps[i].axis) {
        let constant = turns.iter().filter(|turn| matches!(turn, Turn::Constant { .. }));
        parts[OWN].extend(constant.filter_map(|turn| turn.summand(sign)));
    }
    for part in &mut parts {
        part.retain(|(by, _)| !is_nothing(*by));
    }
    parts
}

fn is_of_time(part: &[Summand]) -> bool {
    part.iter().any(|(_, factor)| !factor.is_empty())
}

/// Shift, turn and own turn of frame `i`, each at most one summand.
pub(super) fn at_once(model: &LiveModel, i: usize) -> ([[Vec<Summand>; 3]; 2], Vec<Summand>) {
    let parts = parts(model, i);
    let [a, b, c, d, e, f, own] = std::array::from_fn(|k| match &parts[k] {
        part if is_of_time(part) => vec![(1.0, name(i, k))],
        part if part.is_empty() => Vec::new(),
        part => vec![(part.iter().map(|(by, _)| by).sum(), String::new())],
    });
    ([[a, b, c], [d, e, f]], own)
}

fn name(i: usize, k: usize) -> String {
    format!("tcOff{{{},{}}}", i + 1, k + 1)
}

/// The lines of the routine that works them out; `None` where there is nothing to be worked out.
pub(super) fn routine(model: &LiveModel) -> Option<Vec<String>> {
    let mut body = Body::default();
    for i in 0..model.steps.len() {
        for (k, part) in parts(model, i).iter().enumerate().filter(|(_, part)| is_of_time(part)) {
            body.set_at_once(&name(i, k), part);
        }
    }
    let lines = body.into_lines();
    if lines.is_empty() {
        return None;
    }
    let mut all = vec![
        "  LOCAL PROC tcOffsets()".to_owned(),
        "    ! Of frames 1 to 7 the shifts in mm, the turns in radians, and the joint's own turn".to_owned(),
    ];
    all.extend(lines);
    all.push("  ENDPROC".to_owned());
    Some(all)
}
