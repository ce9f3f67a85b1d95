//! What can tell causes apart that further poses cannot.

use measurements::Channels;
use robot_model::deform::EffectKind;

/// What tells a gear of joint 2 from its balancing.
pub(super) const BALANCING: &str = "look at the balancing of joint 2 (a gas cylinder's pressure, a spring's seat) and measure again after it was set; as it is, the model corrects either";

/// What tells `kinds` apart besides poses, as a phrase; `None` where nothing is known to.
pub(super) fn other_means(kinds: &[EffectKind], channels: &Channels) -> Option<&'static str> {
    use EffectKind::{
        Backlash, BaseDrift, BaseStep, BaseTilt, InstrumentScale, JointCompliance, JointStep, LinkBending,
        LinkGeometry, PayloadMass, ThermalJointDrift, ThermalLinkGrowth, ToolDrift, ToolStep,
    };
    let has = |list: &[EffectKind]| kinds.iter().any(|k| list.contains(k));
    if has(&[InstrumentScale]) {
        return Some("measure a scale bar: lengths then count apart from links");
    }
    if has(&[BaseDrift, BaseStep]) {
        return Some(
            "put nests on the base and measure them again and again between the poses: only the base moves them",
        );
    }
    if has(&[ToolDrift, ToolStep, JointStep]) {
        return Some(
            "put further reflectors on the flange and nests on the base, and measure them before and after a run",
        );
    }
    if has(&[ThermalJointDrift, ThermalLinkGrowth]) {
        return Some(if channels.joint_temperature {
            "warm up once more from cold, one joint after the other, and measure nests on the base meanwhile"
        } else {
            "warm up once more from cold, one joint after the other, and record the joints' temperatures (temp_j1_c and so on)"
        });
    }
    if has(&[JointCompliance, LinkBending, BaseTilt, PayloadMass]) {
        return Some(
            "measure the same poses with two payloads, and nests or reflectors on the base and before the joint in doubt",
        );
    }
    if has(&[Backlash]) && !channels.direction {
        return Some("drive to each pose from both sides and record the directions (dir1 and so on)");
    }
    if has(&[LinkGeometry]) {
        return Some("measure with the target on a longer arm on the flange, and with orientation");
    }
    None
}
