//! Verdicts and causes in words.

use crate::diagnose::dataset::Dataset;
use crate::diagnose::effects::Candidate;
use crate::diagnose::gp_alternative::GpAlternative;
use crate::diagnose::outcome::Cause;
use robot_model::deform::EffectKind;

/// A cause in words.
#[must_use]
pub fn describe(cause: &Cause) -> String {
    let mut text = cause.effect.to_string();
    match (cause.joint, cause.joint_b) {
        (Some(a), Some(b)) => text.push_str(&format!(" from joint {a} to joint {b}")),
        (Some(a), None) => {
            let what = if cause.effect.is_of_link() { "link" } else { "joint" };
            text.push_str(&format!(" of {what} {a}"));
        }
        _ => {}
    }
    if let Some(n) = cause.n.filter(|_| cause.effect == EffectKind::GearMesh) {
        text.push_str(&format!(", {n} per turn"));
    }
    match (cause.t0_min, cause.from_line) {
        (Some(t0_min), Some(line)) => {
            text.push_str(&format!(" at minute {t0_min:.1} (from line {line} on)"));
        }
        (Some(t0_min), None) => text.push_str(&format!(" at minute {t0_min:.1}")),
        (None, Some(line)) => text.push_str(&format!(" from line {line} on")),
        (None, None) => {}
    }
    text
}

/// A candidate in words.
#[must_use]
pub fn describe_candidate(candidate: &Candidate, dataset: &Dataset) -> String {
    let variant = &candidate.variant;
    let one = |j: Option<usize>| j.map(|j| j + 1);
    describe(&Cause {
        joint: one(variant.joint),
        joint_b: one(variant.joint_b),
        n: variant.n,
        t0_min: variant.t0_min().filter(|_| dataset.time_min.is_some()),
        from_line: variant.t0_min().and_then(|t0| dataset.line_from(t0)),
        ..Cause::of(candidate.kind, 0.0)
    })
}

/// Structure in words; `timed`: the file has times.
#[must_use]
pub fn structure_reason(gp_alternative: GpAlternative, timed: bool) -> String {
    let time = if timed { "time" } else { "the order of the rows; the time (t_min) is not in the file" };
    let of = match gp_alternative {
        GpAlternative::Joint(j) | GpAlternative::JointFine(j) => format!("the angle of joint {}", j + 1),
        GpAlternative::Joints(j) => format!("joint {}, depending on all joints' angles", j + 1),
        GpAlternative::Driven(a, b) => format!("joint {}, depending on the angle of joint {}", b + 1, a + 1),
        GpAlternative::AllJoints => "the angles of several joints".to_owned(),
        GpAlternative::Workspace | GpAlternative::WorkspaceFine => "the place in the workspace".to_owned(),
        GpAlternative::LocalBump(..) => "one place of the workspace".to_owned(),
        GpAlternative::WristCable | GpAlternative::WristCableFine => {
            "the angles of the wrist's joints".to_owned()
        }
        GpAlternative::Pair(a, b, j) => {
            format!("joint {}, depending on the angles of joints {} and {}", j + 1, a + 1, b + 1)
        }
        GpAlternative::Time | GpAlternative::TimeFine | GpAlternative::TimeVaryingCause(_) => time.to_owned(),
        GpAlternative::ToolTime => format!("the target on the flange, over {time}"),
        GpAlternative::JointTime(j) => format!("joint {}, over {time}", j + 1),
        GpAlternative::Periodic(j, n) | GpAlternative::SquareWave(j, n) => {
            format!("the angle of joint {}, {n} times per turn, with steps or corners", j + 1)
        }
    };
    format!("the gap has a structure that no effect of the library takes; it follows {of}")
}

/// Jumps at many moments in words.
#[must_use]
pub fn switched_reason(lines: &[u64], dataset: &Dataset) -> String {
    let from: Vec<String> = lines.iter().map(u64::to_string).collect();
    let payload = if dataset.channels.payload {
        ""
    } else {
        ": the payload, say, which is not in the file (payload_kg)"
    };
    format!(
        "the gap jumps to and fro, from lines {} on: something was switched that is not recorded{payload}",
        from.join(", ")
    )
}

/// Channels that are not in the file and could tell what scatters, as a phrase.
#[must_use]
pub fn missing_channels(dataset: &Dataset) -> String {
    let channels = &dataset.channels;
    let all = [
        (channels.direction, "the direction of approach (dir1 to dir6)"),
        (channels.payload, "the payload (payload_kg)"),
        (channels.joint_temperature || channels.time, "temperature or time (temp_j1_c to temp_j6_c, t_min)"),
    ];
    let missing: Vec<&str> = all.into_iter().filter(|(there, _)| !there).map(|(_, name)| name).collect();
    match missing.as_slice() {
        [] => "something is missing that is no column of such files".to_owned(),
        [one] => format!("a channel is missing: {one} is not in the file"),
        [first, more @ ..] => format!("a channel is missing: {first}, or {}", more.join(", or ")),
    }
}

/// Causes in words: gear lines joint by joint, and of many only the first few.
#[must_use]
pub fn in_short(causes: &[Cause]) -> String {
    const SAID: usize = 6;
    const LINES: usize = 4;
    let line = |c: &&Cause| c.effect == EffectKind::GearMesh;
    let mut names: Vec<String> = Vec::new();
    let mut told: Vec<Option<usize>> = Vec::new();
    for cause in causes {
        let lines: Vec<&Cause> = causes.iter().filter(line).filter(|c| c.joint == cause.joint).collect();
        if !line(&cause) || lines.len() == 1 {
            names.push(describe(cause));
        } else if !told.contains(&cause.joint) {
            told.push(cause.joint);
            let orders: Vec<String> =
                lines.iter().take(LINES).filter_map(|c| c.n).map(|n| n.to_string()).collect();
            let more = match lines.len() - orders.len() {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            let joint = cause.joint.map_or_else(String::new, |j| format!(" of joint {j}"));
            names.push(format!("gear lines{joint}, {}{more} per turn", orders.join(", ")));
        }
    }
    let more = names.len().saturating_sub(SAID);
    let said = names[..names.len() - more].join("; ");
    if more > 0 { format!("{said}; and {more} more") } else { said }
}
