//! Verdicts and causes in words.

use super::two_states::{State, TwoStates};
use inference::cause::Cause;
use inference::dataset::Dataset;
use inference::effects::{Candidate, RigidBody};
use inference::gp_alternative::GpAlternative;
use inference::missing_channel::MissingChannel;
use measurements::{direction_columns, temperature_columns};
use nalgebra::Vector3;
use rapid_syntax::diagnostic::plural;
use robot_model::deform::EffectKind;
use robot_model::robot::{Axis, MOST_JOINTS};
use robot_model::units::{mm_from_m, mrad_from_rad};

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
pub(crate) fn describe_candidate(candidate: &Candidate, dataset: &Dataset) -> String {
    let variant = &candidate.variant;
    describe(&Cause {
        joint: variant.joint,
        joint_b: variant.joint_b,
        n: variant.n,
        t0_min: variant.t0_min().and_then(|t0| dataset.minute_of(t0)),
        from_line: variant.t0_min().and_then(|t0| dataset.line_from(t0)),
        unit: candidate.unit(),
        usual: candidate.usual_size(),
        ..Cause::of(candidate.kind, 0.0)
    })
}

/// Structure in words; `timed`: the file has times.
#[must_use]
pub(super) fn structure_reason(gp_alternative: GpAlternative, timed: bool) -> String {
    let time = if timed { "time" } else { "the order of the rows; the time (t_min) is not in the file" };
    let of = match gp_alternative {
        GpAlternative::Joint(j) | GpAlternative::JointFine(j) => format!("the angle of joint {j}"),
        GpAlternative::Joints(j) => format!("joint {j}, depending on all joints' angles"),
        GpAlternative::Driven(a, b) => format!("joint {b}, depending on the angle of joint {a}"),
        GpAlternative::AllJoints => "the angles of several joints".to_owned(),
        GpAlternative::Workspace | GpAlternative::WorkspaceFine | GpAlternative::WorkspaceBroad => {
            "the place in the workspace".to_owned()
        }
        GpAlternative::LocalBump(..) => "one place of the workspace".to_owned(),
        GpAlternative::WristCable | GpAlternative::WristCableFine => {
            "the angles of the wrist's joints".to_owned()
        }
        GpAlternative::WristFlip(_) => "the side to which the wrist is bent".to_owned(),
        GpAlternative::Pair(a, b, j) => {
            format!("joint {j}, depending on the angles of joints {a} and {b}")
        }
        GpAlternative::Time | GpAlternative::TimeFine | GpAlternative::TimeVaryingCause(_) => time.to_owned(),
        GpAlternative::ToolTime => format!("the target on the flange, over {time}"),
        GpAlternative::JointTime(j) | GpAlternative::JointTimeFine(j) => format!("joint {j}, over {time}"),
        GpAlternative::HiddenLoad => {
            format!(
                "what the arm gives under a load that comes and goes over {time}: the payload (payload_kg) is not in the file"
            )
        }
        GpAlternative::Cycle(half_cycles) => {
            format!(
                "{time}, to and fro {:.1} times from the first row to the last",
                0.5 * f64::from(half_cycles)
            )
        }
        GpAlternative::ToolSag => {
            "how gravity pulls along the flange's axes, as a tool does that gives or is loose".to_owned()
        }
        GpAlternative::LoadedTarget => {
            "the payload: the target sits elsewhere on the flange under load".to_owned()
        }
        GpAlternative::LoadedZeros => {
            "the payload: joints stand elsewhere under load, whatever their torque".to_owned()
        }
        GpAlternative::LoadedPlay(j) => {
            format!(
                "the way in which joint {j} turned last, and gravity's torque on it: friction that winds the joint up under load, not play"
            )
        }
        GpAlternative::WanderingScale => {
            format!("the distance from the instrument, over {time}: its scale wanders")
        }
        GpAlternative::Periodic(j, n) | GpAlternative::SquareWave(j, n) => {
            format!("the angle of joint {j}, {n} times per turn, with steps or corners")
        }
    };
    format!("the gap has a structure that no effect of the library takes; it follows {of}")
}

/// Jumps at many moments in words.
#[must_use]
pub(super) fn switched_reason(lines: &[u64], dataset: &Dataset) -> String {
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

/// A load that was changed unrecorded in words; `lines`: those from which on it is another one.
#[must_use]
pub(super) fn hidden_load_reason(lines: &[u64], dataset: &Dataset) -> String {
    let from: Vec<String> = lines.iter().map(u64::to_string).collect();
    let payload = match dataset.channels.payload {
        true => "is the same in all rows of the file",
        false => "is not in the file",
    };
    format!(
        "the gap changes from {} {} on, and follows what the arm gives under a load that was changed: the payload (payload_kg) {payload}",
        plural(lines.len(), "line"),
        from.join(" and ")
    )
}

/// Two states that nothing in the file tells apart in words.
#[must_use]
pub(super) fn two_states_reason(states: &TwoStates, dataset: &Dataset) -> String {
    match states.state {
        State::Side(joint) => {
            let gap = match dataset.slides[joint.index()] {
                true => format!("{:.3} mm", mm_from_m(states.distance)),
                false => format!("{:.3} mrad", mrad_from_rad(states.distance)),
            };
            format!(
                "joint {joint} stands now on one side and now on the other, {gap} apart, whatever its angle, as a gear with play does: a \
                 channel is missing: the direction of approach ({}) is not in the file",
                direction_columns(dataset.joints())
            )
        }
        State::Load(joint) => format!(
            "joint {joint} gives at some rows as under a load that hangs at the tool, and at others not: a channel is missing: the payload \
             (payload_kg) is not in the file"
        ),
        State::LoadOnBase => "the base tilts at some rows as under a load that hangs at the tool, and at others not: a channel is missing: \
             the payload (payload_kg) is not in the file"
            .to_owned(),
        State::Place(body, along) => {
            let (body, of) = match body {
                RigidBody::Tool => ("target", "a mount with play, or two targets, do that"),
                RigidBody::Base => ("base", "a stand with play, or a frame that was taken anew, does that"),
            };
            format!(
                "the {body} stands now in one place and now in another, {:.3} mm apart along its {}, whatever the pose: {of}",
                mm_from_m(states.distance),
                direction(along)
            )
        }
    }
}

/// A direction by the axis that it is, or by its numbers.
fn direction(along: Vector3<f64>) -> String {
    match ["x", "y", "z"].into_iter().zip(along.iter()).find(|(_, share)| share.abs() > 0.999) {
        Some((axis, _)) => axis.to_owned(),
        None => format!("({:.2} {:.2} {:.2})", along.x, along.y, along.z),
    }
}

/// What may stand in the place of steps.
pub(super) const OR_LOAD: &str =
    "; or in the place of the steps a load that was changed, and is not in the file (payload_kg)";

/// What is not in the library and may stand in the place of an error that goes with the angle of joint 2.
pub(super) const OR_BALANCING: &str = "; a balancing spring or cylinder of joint 2, which is not in it, does the same where it pulls other than the controller expects";

/// Two links that are one beam in words.
#[must_use]
pub(super) fn one_beam_reason([before, link]: &[Axis; 2]) -> String {
    format!("; links {before} and {link} are one beam to any poses, as joint {link} turns along it")
}

/// Channels that are not in the file and could tell what scatters, with their names for people.
fn missing(dataset: &Dataset) -> Vec<(MissingChannel, String)> {
    let channels = &dataset.channels;
    let with_warmth = channels.joint_temperature || channels.time;
    let (directions, temperatures) =
        (direction_columns(dataset.joints()), temperature_columns(dataset.joints()));
    let all = [
        (channels.direction, MissingChannel::Direction, format!("the direction of approach ({directions})")),
        (channels.payload, MissingChannel::Payload, "the payload (payload_kg)".to_owned()),
        (with_warmth, MissingChannel::Time, format!("temperature or time ({temperatures}, t_min)")),
    ];
    all.into_iter().filter(|(there, ..)| !there).map(|(_, channel, name)| (channel, name)).collect()
}

/// The same as a phrase.
#[must_use]
pub(super) fn missing_channels(dataset: &Dataset) -> String {
    let names: Vec<String> = missing(dataset).into_iter().map(|(_, name)| name).collect();
    match names.as_slice() {
        [] => "something is missing that is no column of such files".to_owned(),
        [one] => format!("a channel is missing: {one} is not in the file"),
        [first, more @ ..] => format!("a channel is missing: {first}, or {}", more.join(", or ")),
    }
}

/// The only channel that is not in the file and could tell what scatters; `None` of several.
#[must_use]
pub(super) fn only_missing(dataset: &Dataset) -> Option<MissingChannel> {
    match missing(dataset).as_slice() {
        [(channel, _)] => Some(*channel),
        _ => None,
    }
}

/// Lines of one joint's gear together.
#[derive(Clone, Debug, PartialEq)]
pub struct GearBand {
    /// Joint it turns with.
    pub joint: Axis,
    /// How many lines of the spectrum were found.
    pub lines: usize,
    /// The lowest and the highest period per turn.
    pub n: [u32; 2],
    /// rms of the joint's angle over a turn, all lines together, rad.
    pub rms_rad: f64,
    /// At the measured point over these poses, all lines together, mm.
    pub rms_mm: f64,
    /// What of it is left beside base and target, mm.
    pub seen_mm: f64,
}

/// So many lines of one joint's gear are said together.
const BAND: usize = 3;

/// The lines of each joint's gear together, where there are several; and all other causes.
#[must_use]
pub fn gear_bands(causes: &[Cause]) -> (Vec<GearBand>, Vec<&Cause>) {
    let of = |joint: Axis| -> Vec<&Cause> {
        let alone = |c: &&Cause| causes.iter().filter(|other| other.slot == c.slot).count() == 1;
        let is_line = |c: &&Cause| c.effect == EffectKind::GearMesh && c.joint == Some(joint);
        causes.iter().filter(is_line).filter(alone).collect()
    };
    // Lines of different periods are independent over a turn: their squares add.
    let together = |squares: f64| squares.sqrt();
    let bands: Vec<GearBand> = (0..MOST_JOINTS)
        .map(|j| (Axis::at(j), of(Axis::at(j))))
        .filter(|(_, lines)| lines.len() >= BAND)
        .map(|(joint, lines)| GearBand {
            joint,
            lines: lines.len(),
            n: [
                lines.iter().filter_map(|c| c.n).min().unwrap_or(0),
                lines.iter().filter_map(|c| c.n).max().unwrap_or(0),
            ],
            rms_rad: together(lines.iter().filter_map(|c| c.size).map(|size| 0.5 * size * size).sum()),
            rms_mm: together(lines.iter().filter_map(|c| c.rms_mm).map(|mm| mm * mm).sum()),
            seen_mm: together(lines.iter().map(|c| c.seen_mm().powi(2)).sum()),
        })
        .collect();
    let mut others: Vec<&Cause> = causes.iter().collect();
    for band in &bands {
        let lines = of(band.joint);
        others.retain(|c| !lines.iter().any(|line| std::ptr::eq(*line, *c)));
    }
    (bands, others)
}

/// Likelier than this, and alone in its place, a cause is certain.
pub(in crate::diagnose) const CERTAIN: f64 = 0.9;

/// What is certain and what is one of several, the largest at the tool first; of many only the first few.
#[must_use]
pub(super) fn in_short(causes: &[Cause]) -> String {
    const SAID: usize = 5;
    let (bands, others) = gear_bands(causes);
    let mut certain: Vec<(f64, String)> = bands
        .iter()
        .map(|b| {
            (
                b.seen_mm,
                format!("{} gear lines of joint {}, {} to {} per turn", b.lines, b.joint, b.n[0], b.n[1]),
            )
        })
        .collect();
    let mut open: Vec<(f64, String)> = Vec::new();
    let mut slots: Vec<usize> = others.iter().map(|c| c.slot).collect();
    sorting::ascending(&mut slots);
    slots.dedup();
    for slot in slots {
        let alternatives: Vec<&&Cause> = others.iter().filter(|c| c.slot == slot).collect();
        let size = alternatives.iter().map(|c| c.seen_mm()).fold(0.0, f64::max);
        let names = names_by_line(&alternatives);
        let sure = alternatives.len() == 1 && alternatives[0].posterior >= CERTAIN;
        match names.as_slice() {
            [one] if sure => certain.push((size, one.clone())),
            [one] if alternatives.len() > 1 => open.push((size, format!("one of: {one}"))),
            [one] => open.push((size, format!("one of: {one} or something that is not in the library"))),
            many => open.push((size, format!("one of: {}", many.join(" or ")))),
        }
    }
    let join = |mut list: Vec<(f64, String)>, limit: usize| {
        sorting::by(&mut list, |a, b| b.0.total_cmp(&a.0));
        let more = list.len().saturating_sub(limit);
        let mut names: Vec<String> = list.into_iter().take(limit).map(|(_, name)| name).collect();
        names.extend((more > 0).then(|| format!("{more} more")));
        names.join("; ")
    };
    match (certain.is_empty(), open.is_empty()) {
        (_, true) => join(certain, SAID),
        (true, false) => join(open, SAID),
        (false, false) => format!("certain: {}; {}", join(certain, SAID), join(open, SAID)),
    }
}

/// Each of a place's alternatives in words, those that are lines of one joint's gear together.
fn names_by_line(alternatives: &[&&Cause]) -> Vec<String> {
    let of_gear = |c: &Cause| (c.effect == EffectKind::GearMesh).then_some(c.joint);
    let mut names = Vec::new();
    for (i, cause) in alternatives.iter().enumerate() {
        let same = |other: &&&&Cause| of_gear(cause).is_some() && of_gear(other) == of_gear(cause);
        if alternatives[..i].iter().any(|other| same(&other)) {
            continue;
        }
        let periods: Vec<String> =
            alternatives[i..].iter().filter(same).filter_map(|c| c.n).map(|n| n.to_string()).collect();
        names.push(match (periods.as_slice(), cause.joint) {
            ([_, _, ..], Some(joint)) => {
                format!("{} of joint {joint}, {} per turn", cause.effect, periods.join(" or "))
            }
            _ => describe(cause),
        });
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cause(effect: EffectKind, joint: usize, slot: usize, rms_mm: f64) -> Cause {
        Cause { joint: Axis::numbered(joint), slot, rms_mm: Some(rms_mm), ..Cause::of(effect, 0.9) }
    }

    /// By hand: sizes 3 and 4 urad beside 0 add to 5 / sqrt 2 rms; 0.03 and 0.04 mm to 0.05.
    #[test]
    fn lines_of_a_gear_are_one_band() {
        let line = |n, size, rms_mm| Cause {
            n: Some(n),
            size: Some(size),
            ..cause(EffectKind::GearMesh, 2, n as usize, rms_mm)
        };
        let causes = [line(11, 3e-6, 0.03), line(33, 4e-6, 0.04), line(20, 0.0, 0.0)];
        let (bands, others) = gear_bands(&causes);
        assert_eq!(others.len(), 0);
        let [band] = bands.as_slice() else { panic!("{bands:?}") };
        assert_eq!((band.joint, band.lines, band.n), (Axis::at(1), 3, [11, 33]));
        assert!((band.rms_rad - 5e-6 / 2f64.sqrt()).abs() < 1e-18 && (band.rms_mm - 0.05).abs() < 1e-15);
        assert_eq!(gear_bands(&causes[..2]).1.len(), 2, "two lines are named one by one");
    }

    /// Lines that are the same numbers at the angles measured stand in one place: no band of lines that are all there.
    #[test]
    fn lines_that_may_be_one_another_are_said_as_one_choice() {
        let line =
            |n, posterior, slot| Cause { n: Some(n), posterior, ..cause(EffectKind::GearMesh, 2, slot, 0.1) };
        let causes = [line(8, 0.6, 1), line(28, 0.2, 1), line(44, 0.1, 1)];
        assert_eq!(gear_bands(&causes).0, []);
        assert_eq!(in_short(&causes), "one of: gear_mesh of joint 2, 8 or 28 or 44 per turn");
        let sure = [line(17, 0.99, 1), line(8, 0.6, 2), line(28, 0.3, 2)];
        assert_eq!(
            in_short(&sure),
            "certain: gear_mesh of joint 2, 17 per turn; one of: gear_mesh of joint 2, 8 or 28 per turn"
        );
    }

    #[test]
    fn alternatives_are_told_from_what_is_certain() {
        use EffectKind::{BaseTilt, JointCompliance, JointGain};
        let tilt = Cause { slot: 2, rms_mm: Some(0.5), ..Cause::of(BaseTilt, 0.4) };
        let causes = [cause(JointGain, 1, 1, 0.1), tilt, cause(JointCompliance, 2, 2, 0.4)];
        assert_eq!(
            in_short(&causes),
            "certain: joint_gain of joint 1; one of: base_tilt or joint_compliance of joint 2"
        );
        assert_eq!(in_short(&causes[..1]), "joint_gain of joint 1");
        assert_eq!(in_short(&causes[1..]), "one of: base_tilt or joint_compliance of joint 2");
    }
}
