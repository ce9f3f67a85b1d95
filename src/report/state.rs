//! The thermal state of a robot for people and as JSON.

use super::{counted, notes};
use robot_model::deform::thermal_filter::TouchOutcome;
use robot_model::units::mm_from_m;
use serde_json::{Value, json};
use std::fmt::Write as _;
use warm_up::{AmountBound, RobotState};

/// Two decimals are enough beyond this.
fn word(outcome: Option<TouchOutcome>) -> &'static str {
    match outcome {
        Some(TouchOutcome::Taken) => "taken",
        Some(TouchOutcome::Reset) => "taken, the state begins anew",
        Some(TouchOutcome::Refused) => "refused: over three sigma",
        None => "refused: off the drift's line",
    }
}

/// Amount and time constants in minutes, each with its standard deviation.
fn learnt(state: &RobotState) -> [[f64; 2]; 3] {
    let sigma = |i: usize| state.covariance[(i, i)].max(0.0).sqrt();
    let tau = |i: usize| [state.state[i].exp(), state.state[i].exp() * sigma(i)];
    [[state.state[2], sigma(2)], tau(3), tau(4)]
}

/// For people; `plan` adds how often to touch which point.
#[must_use]
pub fn text(state: &RobotState, points: &[String], plan: bool) -> String {
    let mut out = opening(state, points);
    // writing to a String cannot fail
    let _ = writeln!(out, "   minute point         seen   off   share           smoothed");
    for t in &state.touches {
        let _ = writeln!(
            out,
            "{:9.1} {:10} {:7.3} {:5.1} {:7.3} +- {:.3} {:7.3} +- {:.3}  {}",
            t.t_min,
            points.get(t.point).map_or("", String::as_str),
            t.seen,
            t.off_sigmas,
            t.share[0],
            t.share[1],
            t.smoothed[0],
            t.smoothed[1],
            word(t.outcome)
        );
    }
    out.push('\n');
    out.push_str(&closing(state));
    if plan {
        how_often(&mut out, state);
        out.push_str(&tells_most(state));
    }
    out
}

/// How many touches there are, and which of them are no good.
fn opening(state: &RobotState, points: &[String]) -> String {
    let mut out = String::new();
    let _ = writeln!(out, "{}, {} refused\n", counted(state.touches.len(), "touch"), state.refused());
    if state.drifts_otherwise() {
        out.push_str(
            "So many are no accidents of single touches: this arm does not drift as the table says, or its noise is larger than --sigma-mm, or the tip is \
             elsewhere. What follows holds for no such arm; `driftpost fit` makes a table of touches.\n\n",
        );
    }
    for one in &state.false_first {
        let _ = writeln!(
            out,
            "line {}: the first touch of {} stands {:.3} mm from where its later ones have the cold arm (+- {:.3} mm along the drift): it is left out, and theirs is taken\n",
            one.line,
            points.get(one.point).map_or("", String::as_str),
            mm_from_m(one.off_m.norm()),
            mm_from_m(one.sigma_m)
        );
    }
    out
}

/// What was learnt of the robot, and when it stood.
fn closing(state: &RobotState) -> String {
    let mut out = String::new();
    let [amount, tau, cool] = learnt(state);
    let _ = writeln!(
        out,
        "of this robot: {}{:.2} +- {:.2} times the table's settled drift",
        match state.held_at {
            None => "",
            Some(AmountBound::Least) => "held at the least, ",
            Some(AmountBound::Most) => "held at the most, ",
        },
        amount[0],
        amount[1]
    );
    let _ = writeln!(out, "  tau {:.0} +- {:.0} min", tau[0], tau[1]);
    for stop in &state.stops {
        let by_pause = if state.stops_are_named {
            ""
        } else {
            ", by the pause between touches (--stop FROM:TO says when)"
        };
        let _ = writeln!(out, "  it stood from minute {:.0} to {:.0}{by_pause}", stop.from_min, stop.to_min);
    }
    let _ = match state.stops.is_empty() {
        false => writeln!(out, "  cooling tau {:.0} +- {:.0} min", cool[0], cool[1]),
        true => writeln!(out, "  no stop: nothing is known of its cooling"),
    };
    out
}

/// What is left by how often each point is touched.
fn how_often(out: &mut String, state: &RobotState) {
    let _ = writeln!(
        out,
        "\nwhat is left over a shift where the points drift most, mm (one standard deviation), by minutes between touches"
    );
    for point in &state.plan {
        let cells: Vec<String> = point
            .intervals
            .iter()
            .map(|i| format!("{:.0}: {:.4}", i.every_min, mm_from_m(i.rms_m)))
            .collect();
        let _ = writeln!(
            out,
            "  {:10} moves {:.3} mm; {}",
            point.name,
            mm_from_m(point.settled_m),
            cells.join(", ")
        );
    }
}

/// The point that is worth most touches.
fn tells_most(state: &RobotState) -> String {
    state.plan.first().map_or_else(String::new, |best| format!("  {} tells most\n", best.name))
}

/// For scripts: shares, mm, minutes.
#[must_use]
pub fn json(state: &RobotState, points: &[String]) -> Value {
    let [amount, tau, cool] = learnt(state);
    let notes = notes(&(opening(state, points) + &closing(state) + &tells_most(state)));
    json!({
        "notes": notes, "growth": state.law.to_string(),
        "refused": state.refused(), "drifts_otherwise": state.drifts_otherwise(),
        "amount": amount[0], "amount_sigma": amount[1], "amount_held": state.held_at.map(AmountBound::name),
        "stops": state.stops.iter().map(|stop| [stop.from_min, stop.to_min]).collect::<Vec<_>>(),
        "tau_min": tau[0], "tau_sigma_min": tau[1],
        "tau_cool_min": (!state.stops.is_empty()).then_some(cool[0]), "tau_cool_sigma_min": (!state.stops.is_empty()).then_some(cool[1]),
        "false_first": state.false_first.iter().map(|one| json!({
            "line": one.line, "point": points.get(one.point), "off_mm": mm_from_m(one.off_m.norm()), "sigma_mm": mm_from_m(one.sigma_m),
        })).collect::<Vec<_>>(),
        "touches": state.touches.iter().map(|t| json!({
            "line": t.line, "point": points.get(t.point), "t_min": t.t_min, "seen": t.seen, "off_sigmas": t.off_sigmas,
            "taken": matches!(t.outcome, Some(TouchOutcome::Taken | TouchOutcome::Reset)), "outcome": word(t.outcome),
            "share": t.share[0], "sigma": t.share[1], "smoothed": t.smoothed[0], "smoothed_sigma": t.smoothed[1],
        })).collect::<Vec<_>>(),
        "plan": state.plan.iter().map(|p| json!({
            "point": p.name, "settled_mm": mm_from_m(p.settled_m),
            "intervals": p.intervals.iter().map(|i| json!({ "every_min": i.every_min, "rms_mm": mm_from_m(i.rms_m) }))
                .collect::<Vec<_>>(),
        })).collect::<Vec<_>>(),
    })
}
