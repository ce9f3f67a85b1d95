//! The side that a joint with play comes from: what its way from one target to the next says of it.

/// Joints that turn by less have not moved, radians: what targets are rounded to moves those that stand still by up to 1e-6.
pub(super) const STILL_RAD: f64 = 1e-5;
/// On a line or an arc a joint may turn round on the way: its last motion is that over the last part of it, where it turns by so much there,
/// radians. Joints that stand still at both ends are moved a little in between, where what is corrected turns the tool.
pub(super) const LAST_SHARE: f64 = 1.0 / 16.0;
pub(super) const LAST_MIN_RAD: f64 = 2e-4;

/// WhyUnknown a joint's side is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum WhyUnknown {
    /// The arm comes from where the text does not say.
    Start,
    /// The program comes there from different sides.
    Paths,
    /// What is corrected turns it round while the arm warms up.
    WarmUp,
    /// Play that leads is corrected backwards, by more than the joint moves.
    Correction,
}

/// The side of a joint: the sign of its last motion.
pub(super) type Side = Result<i8, WhyUnknown>;

/// The joints at a target, radians.
#[derive(Clone, Copy, Debug)]
pub(super) struct TargetJoints {
    /// Those that the target as programmed has on the nominal arm.
    pub(super) nominal_rad: [f64; 6],
    /// Where the motion is corrected, those that are wanted of the links; else as programmed.
    pub(super) q_rad: [f64; 6],
    pub(super) is_corrected: bool,
    /// By how much each link stands from its joint where the joint came from below: half the gap, below 0 where it lags.
    pub(super) half_gap_rad: [f64; 6],
}

/// The side that holds at two moments.
pub(super) fn common(side: Side, then: Side) -> Side {
    match (side, then) {
        (Ok(side), Ok(then)) if side != then => Err(WhyUnknown::WarmUp),
        (Ok(_), Err(why)) => Err(why),
        (side, _) => side,
    }
}

/// The side from which joint `j` comes from one place to the next, given its side at the first; `last_rad` is how far it turns over
/// the last part of the way, where that is no joint move, and less than `still_rad` is no motion.
pub(super) fn side_at(
    (from, side): (&TargetJoints, Side),
    to: &TargetJoints,
    (last_rad, still_rad): (Option<f64>, f64),
    j: usize,
) -> Side {
    let before = f64::from(side.unwrap_or_default());
    let bridged_rad = from.half_gap_rad[j] * before;
    let from_rad = match (from.is_corrected, to.is_corrected) {
        // Where the links were, to where they are to be.
        (true, true) => from.q_rad[j],
        (false, true) => from.q_rad[j] + bridged_rad,
        // Where the joints were, to where they are sent.
        (true, false) => from.q_rad[j] - bridged_rad,
        (false, false) => from.q_rad[j],
    };
    let whole_rad = to.q_rad[j] - from_rad;
    let (moved_rad, share) = match last_rad {
        Some(last_rad) if last_rad.abs() > LAST_MIN_RAD => (last_rad, LAST_SHARE),
        _ => (whole_rad, 1.0),
    };
    if moved_rad.abs() <= still_rad {
        return side;
    }
    let sign = moved_rad.signum();
    if !to.is_corrected {
        return Ok(sign as i8);
    }
    // The joint itself goes farther than the link where play lags, and less far or back where it leads.
    let goes_with = |sign: f64| {
        let joint_rad = moved_rad - share * (to.half_gap_rad[j] * sign - bridged_rad);
        joint_rad * sign > STILL_RAD
    };
    match to.half_gap_rad[j] > 0.0 {
        false => Ok(sign as i8),
        true if goes_with(sign) => Ok(sign as i8),
        true if goes_with(-sign) => Ok(-sign as i8),
        true => Err(WhyUnknown::Correction),
    }
}

/// What is known of a joint's side where it was known as `known` and something else comes from `new`.
pub(super) fn merged(known: Option<Side>, new: Option<Side>) -> Option<Side> {
    match (known, new) {
        (None, other) | (other, None) => other,
        (Some(Ok(known)), Some(Ok(new))) if known != new => Some(Err(WhyUnknown::Paths)),
        (Some(Ok(_)), Some(Err(why))) => Some(Err(why)),
        (known, _) => known,
    }
}
