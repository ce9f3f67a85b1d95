//! From values as written (mm, degrees, `9E9`, w first) to typed data in SI.

use super::data::{
    ConfData, ExtJoint, JointTarget, LoadData, RobTarget, SpeedData, ToolData, WobjData, ZoneData,
};
use super::motion::TargetValue;
use super::names::as_text;
use super::value::{Value, plain_numbers};
use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion};
use robot_model::units::{m_from_mm, rad_from_deg};

/// How far from 1 the length of a quaternion may be: four numbers written with three decimals each can
/// be off by 0.001 together, and twice that is still somebody's rounding.
const UNIT_LENGTH_TOLERANCE: f64 = 0.002;

/// Why a value is not a datum of its type: code and sentence.
pub(super) type ConversionError = (&'static str, String);

/// A value as `robtarget`.
pub(super) fn robtarget(value: &Value) -> Result<RobTarget, ConversionError> {
    let [trans, rot, conf, ext] = parts(value, "robtarget")?;
    Ok(RobTarget { object_from_tcp: frame(trans, rot)?, conf: confdata(conf)?, ext: extjoint(ext)? })
}

/// A `robtarget` of plain numbers from its text; `None` where it is something else, or a value says why it is none.
pub(super) fn robtarget_as_written(text: &[u8]) -> Option<RobTarget> {
    let mut rest = text.strip_prefix(b"[")?;
    let comma = |rest: &mut &[u8]| {
        *rest = rest.trim_ascii_start().strip_prefix(b",")?;
        Some(())
    };
    let trans = plain_numbers::<3>(&mut rest)?;
    comma(&mut rest)?;
    let rot = plain_numbers::<4>(&mut rest)?;
    comma(&mut rest)?;
    let conf = plain_numbers::<4>(&mut rest)?;
    comma(&mut rest)?;
    let ext = plain_numbers::<6>(&mut rest)?;
    let held = |numbers: &[f64]| numbers.iter().all(|n| n.abs() <= f64::from(f32::MAX));
    if rest.trim_ascii_start() != b"]" || !(held(&trans) && held(&rot) && held(&ext)) {
        return None;
    }
    let [x, y, z] = trans.map(m_from_mm);
    let object_from_tcp = Isometry3::from_parts(Translation3::new(x, y, z), rotation(rot).ok()?);
    Some(RobTarget { object_from_tcp, conf: quadrants(conf).ok()?, ext: ext.map(used) })
}

/// A value as `jointtarget`.
pub(super) fn jointtarget(value: &Value) -> Result<JointTarget, ConversionError> {
    let [robax, ext] = parts(value, "jointtarget")?;
    let degrees = numbers::<6>(robax, "robjoint")?;
    Ok(JointTarget { q_rad: degrees.map(|d| used(d).map(rad_from_deg)), ext: extjoint(ext)? })
}

/// A target with a correction of this program's making: a shift and the vector part of a small turn, `[1, v]`, in the axes of
/// the frame that it is given in, or six joint angles. `None` where they do not belong together.
pub(super) fn corrected(original: &TargetValue, correction: &Value) -> Option<TargetValue> {
    match original {
        TargetValue::Rob(target) => {
            let [shift, turn] = parts(correction, "pose").ok()?;
            let shift = numbers::<3>(shift, "pos").ok()?.map(m_from_mm);
            let [w, x, y, z] = numbers::<4>(turn, "orient").ok()?;
            let turn = UnitQuaternion::from_quaternion(Quaternion::new(w, x, y, z));
            let at = &target.object_from_tcp;
            let place = Translation3::from(at.translation.vector + nalgebra::Vector3::from(shift));
            let object_from_tcp = Isometry3::from_parts(place, turn * at.rotation);
            Some(TargetValue::Rob(RobTarget { object_from_tcp, ..*target }))
        }
        TargetValue::Joint(target) => {
            let by = numbers::<6>(correction, "robjoint").ok()?.map(rad_from_deg);
            let mut q_rad = target.q_rad;
            q_rad.iter_mut().zip(by).for_each(|(q_rad, by)| *q_rad = q_rad.map(|q_rad| q_rad + by));
            Some(TargetValue::Joint(JointTarget { q_rad, ext: target.ext }))
        }
        TargetValue::FromJoints(_) => None,
    }
}

/// A value as `tooldata`.
pub(super) fn tooldata(value: &Value) -> Result<ToolData, ConversionError> {
    let [robhold, tframe, tload] = parts(value, "tooldata")?;
    Ok(ToolData { robhold: boolean(robhold)?, frame_from_tcp: pose(tframe)?, load: loaddata(tload)? })
}

/// A value as `wobjdata`.
pub(super) fn wobjdata(value: &Value) -> Result<WobjData, ConversionError> {
    let [robhold, ufprog, ufmec, uframe, oframe] = parts(value, "wobjdata")?;
    let Value::Text(ufmec) = ufmec else { return Err(wrong("wobjdata")) };
    Ok(WobjData {
        robhold: boolean(robhold)?,
        ufprog: boolean(ufprog)?,
        ufmec: as_text(ufmec),
        uframe: pose(uframe)?,
        oframe: pose(oframe)?,
    })
}

/// A value as `loaddata`.
pub(super) fn loaddata(value: &Value) -> Result<LoadData, ConversionError> {
    let [mass, cog, ..] = parts::<6>(value, "loaddata")?;
    Ok(LoadData { mass_kg: number(mass)?, cog_m: numbers::<3>(cog, "pos")?.map(m_from_mm) })
}

/// A value as `speeddata`.
pub(super) fn speeddata(value: &Value) -> Result<SpeedData, ConversionError> {
    let [v_tcp, v_ori, ..] = numbers::<4>(value, "speeddata")?;
    Ok(SpeedData { v_tcp_m_s: m_from_mm(v_tcp), v_ori_rad_s: rad_from_deg(v_ori) })
}

/// A value as `zonedata`.
pub(super) fn zonedata(value: &Value) -> Result<ZoneData, ConversionError> {
    let [finep, pzone_tcp, ..] = parts::<7>(value, "zonedata")?;
    Ok(ZoneData { finep: boolean(finep)?, pzone_tcp_m: m_from_mm(number(pzone_tcp)?) })
}

/// A value as `pose`: metres.
pub(super) fn pose(value: &Value) -> Result<Isometry3<f64>, ConversionError> {
    let [trans, rot] = parts(value, "pose")?;
    frame(trans, rot)
}

/// A value as `orient`, normalised.
pub(super) fn orient(value: &Value) -> Result<UnitQuaternion<f64>, ConversionError> {
    rotation(numbers::<4>(value, "orient")?)
}

fn rotation([w, x, y, z]: [f64; 4]) -> Result<UnitQuaternion<f64>, ConversionError> {
    let quaternion = Quaternion::new(w, x, y, z);
    let length = quaternion.norm();
    if (length - 1.0).abs() > UNIT_LENGTH_TOLERANCE {
        let what = format!(
            "the orientation [{w}, {x}, {y}, {z}] is no rotation: its length is {length:.4} instead of 1"
        );
        return Err(("keep::bad-orientation", what));
    }
    Ok(UnitQuaternion::new_normalize(quaternion))
}

/// A value as so many numbers.
pub(super) fn numbers<const N: usize>(value: &Value, type_name: &str) -> Result<[f64; N], ConversionError> {
    let mut out = [0.0; N];
    for (out, part) in out.iter_mut().zip(parts::<N>(value, type_name)?) {
        *out = number(part)?;
    }
    Ok(out)
}

/// The parts of a record that has `N`.
pub(super) fn parts<'v, const N: usize>(
    value: &'v Value,
    type_name: &str,
) -> Result<&'v [Value; N], ConversionError> {
    match value {
        Value::Parts(parts) => parts.as_ref().try_into().map_err(|_| wrong(type_name)),
        Value::Unknown(why) => Err((why.code, why.reason.clone())),
        _ => Err(wrong(type_name)),
    }
}

fn frame(trans: &Value, rot: &Value) -> Result<Isometry3<f64>, ConversionError> {
    let [x, y, z] = numbers::<3>(trans, "pos")?.map(m_from_mm);
    Ok(Isometry3::from_parts(Translation3::new(x, y, z), orient(rot)?))
}

fn confdata(value: &Value) -> Result<ConfData, ConversionError> {
    quadrants(numbers::<4>(value, "confdata")?)
}

fn quadrants(numbers: [f64; 4]) -> Result<ConfData, ConversionError> {
    let mut whole = [0; 4];
    for (whole, n) in whole.iter_mut().zip(numbers) {
        if n.round() != n || n.abs() > f64::from(i16::MAX) {
            return Err(("keep::bad-number", format!("{n} in confdata is no quadrant")));
        }
        *whole = n as i32;
    }
    let [cf1, cf4, cf6, cfx] = whole;
    Ok(ConfData { cf1, cf4, cf6, cfx })
}

/// The external axes of a robtarget or jointtarget, where they are known.
pub(super) fn external_axes(value: &Value) -> Option<ExtJoint> {
    let joints = jointtarget(value).map(|joints| joints.ext);
    joints.or_else(|_| robtarget(value).map(|target| target.ext)).ok()
}

/// A value as `extjoint`: `None` for an axis that is not used.
pub(super) fn extjoint(value: &Value) -> Result<ExtJoint, ConversionError> {
    Ok(numbers::<6>(value, "extjoint")?.map(used))
}

/// `9E9` in any spelling, as the single precision of the controller sees it, is an axis not used.
pub(super) fn used(n: f64) -> Option<f64> {
    (n as f32 != 9e9).then_some(n)
}

fn number(value: &Value) -> Result<f64, ConversionError> {
    match value {
        Value::Num(n) if n.abs() <= f64::from(f32::MAX) => Ok(*n),
        Value::Num(n) => Err(("keep::bad-number", format!("{n:e} is beyond what a num can hold"))),
        Value::Unknown(why) => Err((why.code, why.reason.clone())),
        _ => Err(wrong("num")),
    }
}

fn boolean(value: &Value) -> Result<bool, ConversionError> {
    match value {
        Value::Bool(b) => Ok(*b),
        Value::Unknown(why) => Err((why.code, why.reason.clone())),
        _ => Err(wrong("bool")),
    }
}

fn wrong(type_name: &str) -> ConversionError {
    ("keep::wrong-type", format!("what stands here is no {type_name}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn target(orientation: &[f64], x_mm: f64) -> Value {
        Value::parts([
            Value::numbers(&[x_mm, 0.0, 250.0]),
            Value::numbers(orientation),
            Value::numbers(&[-1.0, 0.0, 2.0, 5.0]),
            Value::numbers(&[9e9, 9_000_000_000.0, 12.5, 9e9, 9e9, 9e9]),
        ])
    }

    #[test]
    fn a_robtarget_in_si_with_w_first() {
        let read = robtarget(&target(&[0.0, 1.0, 0.0, 0.0], 400.0)).unwrap();
        assert_eq!(read.object_from_tcp.translation.vector.as_slice(), [0.4, 0.0, 0.25]);
        assert_eq!((read.object_from_tcp.rotation.w, read.object_from_tcp.rotation.i), (0.0, 1.0));
        assert_eq!(read.conf, ConfData { cf1: -1, cf4: 0, cf6: 2, cfx: 5 });
        assert_eq!(read.ext, [None, None, Some(12.5), None, None, None]);
    }

    #[test]
    fn a_robtarget_right_from_its_text_is_that_of_its_value() {
        let written = [
            &b"[[400, -0.5,250.0],[0,1,0.0,0],[-1,0,2,5],[9E+09,9E9,12.5,9e9,9E09,9E9]]"[..],
            b" [[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]",
            b"[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]] ",
            b"[\r\n[1 ,2\t,3] , [0.707,0,0.707,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,-7] ]",
            b"[[1,2,3],[1,1,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]",
            b"[[1,2,3],[1,0,0,0],[0,0.5,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]",
            b"[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9]]",
            b"[[1,2,1e39],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]",
            b"[[1,2,+3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]",
            b"[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9],0]",
        ];
        let read = written.map(robtarget_as_written);
        for (text, read) in written.iter().zip(&read) {
            let by_value = Value::of_plain_list(text).and_then(|value| robtarget(&value).ok());
            assert_eq!(*read, by_value, "{}", String::from_utf8_lossy(text));
        }
        assert_eq!(read.iter().flatten().count(), 2);
    }

    #[test]
    fn quaternions_with_three_decimals_pass_and_others_do_not() {
        let read = robtarget(&target(&[0.707, 0.0, 0.707, 0.0], 0.0)).unwrap();
        assert!((read.object_from_tcp.rotation.norm() - 1.0).abs() < 1e-15);
        for bad in [[0.0; 4], [1.0, 1.0, 0.0, 0.0], [0.71, 0.0, 0.71, 0.0]] {
            assert_eq!(robtarget(&target(&bad, 0.0)).unwrap_err().0, "keep::bad-orientation");
        }
    }

    #[test]
    fn numbers_no_controller_can_hold_are_refused() {
        assert_eq!(robtarget(&target(&[1.0, 0.0, 0.0, 0.0], 1e39)).unwrap_err().0, "keep::bad-number");
        assert_eq!(robtarget(&Value::numbers(&[1.0])).unwrap_err().0, "keep::wrong-type");
        assert_eq!(jointtarget(&Value::Num(1.0)).unwrap_err().0, "keep::wrong-type");
    }

    #[test]
    fn joints_in_radians_with_unused_axes() {
        let read = jointtarget(&Value::parts([
            Value::numbers(&[90.0, 0.0, -180.0, 9e9, 0.0, 0.0]),
            Value::numbers(&[9e9; 6]),
        ]))
        .unwrap();
        assert_eq!(read.q_rad[0], Some(std::f64::consts::FRAC_PI_2));
        assert_eq!(read.q_rad[2], Some(-std::f64::consts::PI));
        assert_eq!((read.q_rad[3], read.ext), (None, [None; 6]));
    }
}
