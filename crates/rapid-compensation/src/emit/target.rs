//! Targets as constant arrays: element 1 the original, element k+1 that of bucket k.

use std::borrow::Cow;

use super::aggregate::{brackets, has_components, is_plain, tail_of, with_commas};
use super::checksum::Elements;
use super::insertion::{LayoutStyle, white};
use super::options::EmitError;
use crate::compensate::plan::Corrected;
use crate::emit::record_text::{write_optional, write_orient, write_pos, write_robjoint};
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rapid_program::data::{ExtJoint, RobTarget};
use rapid_program::motion::TargetValue;
use robot_model::units::{deg_from_rad, mm_from_m};

/// The longest line that RAPID takes, characters.
pub(super) const MAX_LINE: usize = 255;

/// The text of element 1 of a target's array, on one line if it came so from the source.
///
/// The source's own spelling where that is nothing but numbers, so that it means the same wherever it
/// stands; else the numbers.
///
/// # Errors
/// [`EmitError::PlanMismatch`] for a target whose pose the plan does not tell.
pub(super) fn first_element<'s>(
    literal: Option<&'s [u8]>,
    original: Option<&TargetValue>,
) -> Result<Cow<'s, [u8]>, EmitError> {
    let components = if matches!(original, Some(TargetValue::Joint(_))) { 2 } else { 4 };
    if let Some(text) = literal.filter(|text| is_plain(text) && has_components(text, components)) {
        if text.len() < MAX_LINE / 2 + 80 && !text.iter().any(|&b| b == b'\n' || b == b'\r' || b == b'\t') {
            return Ok(Cow::Borrowed(text));
        }
        return Ok(Cow::Owned(text.iter().copied().filter(|&b| !white(b)).collect()));
    }
    let mut out = Vec::new();
    match original {
        Some(TargetValue::Rob(target)) => {
            let frame = &target.object_from_tcp;
            let q = frame.rotation.quaternion();
            out.push(b'[');
            write_pos(&mut out, frame.translation.vector.into());
            out.push(b',');
            write_orient(&mut out, [q.w, q.i, q.j, q.k]);
            write_rob_tail(&mut out, target);
        }
        Some(TargetValue::Joint(target)) => {
            out.push(b'[');
            write_robjoint(&mut out, target.q_rad);
            write_joint_tail(&mut out, &target.ext);
        }
        Some(TargetValue::FromJoints(_)) | None => {
            return Err(EmitError::PlanMismatch("a target's pose is not known".to_owned()));
        }
    }
    Ok(Cow::Owned(out))
}

fn write_rob_tail(out: &mut Vec<u8>, target: &RobTarget) {
    let conf = target.conf;
    out.extend_from_slice(format!(",[{},{},{},{}]", conf.cf1, conf.cf4, conf.cf6, conf.cfx).as_bytes());
    write_joint_tail(out, &target.ext);
}

fn write_joint_tail(out: &mut Vec<u8>, ext: &ExtJoint) {
    out.push(b',');
    write_optional(out, *ext);
    out.push(b']');
}

/// The array of a target, or of all elements of an array that it is one of.
pub(super) struct TargetArray<'p> {
    /// The name of the array.
    pub name: String,
    /// Where the source names an array's element, those of its array; else empty.
    pub dims: Vec<usize>,
    /// One for each target, in the order of the indices.
    pub rows: Vec<ArrayRow<'p>>,
}

/// The elements of one target.
pub(super) struct ArrayRow<'p> {
    /// The target as programmed.
    pub original: TargetValue,
    /// The text of element 1.
    pub first_element: Cow<'p, [u8]>,
    /// What it becomes in each bucket.
    pub corrected: Cow<'p, [Corrected]>,
}

impl TargetArray<'_> {
    /// Whether it is the array of these dimensions and rows.
    #[must_use]
    pub(super) fn is_of(&self, dims: &[usize], rows: &[ArrayRow<'_>]) -> bool {
        let same =
            |(a, b): (&ArrayRow<'_>, &ArrayRow<'_>)| a.original == b.original && a.corrected == b.corrected;
        self.dims == dims && self.rows.len() == rows.len() && self.rows.iter().zip(rows).all(same)
    }

    /// Appends the declaration, one element a line; gives what its elements are recognised by, which `elements` works out.
    ///
    /// # Errors
    /// [`EmitError::PlanMismatch`] where a robtarget's correction is given as joints or the other way.
    pub(super) fn write(
        &self,
        out: &mut Vec<u8>,
        style: &LayoutStyle,
        elements: &mut Elements,
    ) -> Result<Vec<u8>, EmitError> {
        let first = self.rows.first();
        let joint = first.is_some_and(|row| matches!(row.original, TargetValue::Joint(_)));
        let buckets = first.map_or(0, |row| row.corrected.len());
        elements.begin();
        out.extend_from_slice(&style.indent);
        out.extend_from_slice(b"LOCAL CONST ");
        out.extend_from_slice(if joint { b"jointtarget " } else { b"robtarget " });
        out.extend_from_slice(self.name.as_bytes());
        let dims = [&self.dims[..], &[buckets + 1]].concat();
        out.extend_from_slice(format!("{{{}}}:=[", with_commas(&dims)).as_bytes());
        out.extend_from_slice(style.eol);
        for (r, ArrayRow { first_element, corrected, .. }) in self.rows.iter().enumerate() {
            let last_row = r + 1 == self.rows.len();
            let mut line = out.len();
            out.extend_from_slice(&style.indent);
            out.extend_from_slice(&style.unit);
            // Of the row itself, and of what it is the first of.
            let is_nested = usize::from(!self.dims.is_empty());
            let (open, close) = brackets(&self.dims, r);
            out.extend(b"[".repeat(open + is_nested));
            let from = out.len();
            out.extend_from_slice(first_element);
            elements.add(out.get(from..).unwrap_or_default());
            let tail = tail_of(first_element, if joint { 1 } else { 2 });
            let of_tail = elements.numbers(tail);
            for corrected in corrected.iter() {
                end_element(out, line, b",", style);
                line = out.len();
                out.extend_from_slice(&style.indent);
                out.extend_from_slice(&style.unit);
                let from = out.len();
                let (numbers, count) = write_corrected(out, corrected, joint, tail)
                    .map_err(|what| EmitError::PlanMismatch(format!("{}: {what}", self.name)))?;
                match &of_tail {
                    Some(of_tail) => elements.add_numbers(&numbers[..count], of_tail),
                    None => elements.add(out.get(from..).unwrap_or_default()),
                }
            }
            let end = if last_row { "];" } else { "," };
            end_element(out, line, format!("{}{end}", "]".repeat(close + is_nested)).as_bytes(), style);
        }
        Ok(elements.checksums())
    }
}

/// A target that no bucket changes; `None` where it is no pose and no joints of all axes.
#[must_use]
pub(super) fn as_it_is(original: &TargetValue) -> Option<Corrected> {
    match original {
        TargetValue::Rob(target) => {
            let frame = &target.object_from_tcp;
            let q = frame.rotation.quaternion();
            let orientation_wxyz = [q.w, q.i, q.j, q.k];
            Some(Corrected::Pose { position_m: frame.translation.vector.into(), orientation_wxyz })
        }
        TargetValue::Joint(target) => {
            let [Some(a), Some(b), Some(c), Some(d), Some(e), Some(f)] = target.q_rad else { return None };
            Some(Corrected::Joints { q_rad: [a, b, c, d, e, f] })
        }
        TargetValue::FromJoints(_) => None,
    }
}

/// How far a corrected target is from the original: mm of a robtarget, degrees of the joint that changes most.
#[must_use]
pub(super) fn distance(original: &TargetValue, corrected: &Corrected) -> f64 {
    match (original, corrected) {
        (TargetValue::Rob(target), Corrected::Pose { position_m, .. }) => {
            let to = Vector3::from(*position_m);
            mm_from_m((to - target.object_from_tcp.translation.vector).norm())
        }
        (TargetValue::Joint(target), Corrected::Joints { q_rad }) => {
            let turns = target.q_rad.iter().zip(q_rad).map(|(from, to)| (to - from.unwrap_or(*to)).abs());
            deg_from_rad(turns.fold(0.0, f64::max))
        }
        _ => 0.0,
    }
}

/// What a target is corrected by: a robtarget's shift, mm, and turn about the frame's axes, degrees; a jointtarget's six axes, degrees.
pub(super) fn difference(original: &TargetValue, corrected: &Corrected) -> Option<[f64; 6]> {
    match (original, corrected) {
        (TargetValue::Rob(target), Corrected::Pose { position_m, orientation_wxyz: [w, x, y, z] }) => {
            let from = &target.object_from_tcp;
            let shift_m = Vector3::from(*position_m) - from.translation.vector;
            let to = UnitQuaternion::from_quaternion(Quaternion::new(*w, *x, *y, *z));
            let turn_rad = (to * from.rotation.inverse()).scaled_axis();
            Some(std::array::from_fn(|k| match k {
                0..3 => mm_from_m(shift_m[k]),
                _ => deg_from_rad(turn_rad[k - 3]),
            }))
        }
        (TargetValue::Joint(target), Corrected::Joints { q_rad }) => {
            Some(std::array::from_fn(|k| deg_from_rad(q_rad[k] - target.q_rad[k].unwrap_or(q_rad[k]))))
        }
        _ => None,
    }
}

/// Appends the target of a bucket, with a `tail` that does not change; gives what is read back before that: so many numbers.
///
/// # Errors
/// What is wrong where a robtarget's correction is given as joints or the other way.
fn write_corrected(
    out: &mut Vec<u8>,
    corrected: &Corrected,
    joint: bool,
    tail: &[u8],
) -> Result<([f32; 7], usize), &'static str> {
    out.push(b'[');
    let read = match (corrected, joint) {
        (Corrected::Pose { position_m, orientation_wxyz }, false) => {
            let [x, y, z] = write_pos(out, *position_m);
            out.push(b',');
            let [q1, q2, q3, q4] = write_orient(out, *orientation_wxyz);
            ([x, y, z, q1, q2, q3, q4], 7)
        }
        (Corrected::Joints { q_rad }, true) => {
            let [a, b, c, d, e, f] = write_robjoint(out, q_rad.map(Some));
            ([a, b, c, d, e, f, 0.0], 6)
        }
        _ => return Err("a bucket's target is of another type than the original"),
    };
    out.push(b',');
    out.extend_from_slice(tail);
    Ok(read)
}

/// Ends the line that an element stands on, and breaks it at commas where it is too long for RAPID.
fn end_element(out: &mut Vec<u8>, line: usize, end: &[u8], style: &LayoutStyle) {
    out.extend_from_slice(end);
    if out.len() - line > MAX_LINE {
        let text = out.split_off(line);
        let mut column = 0;
        let mut from = 0;
        while from < text.len() {
            let to =
                from + text[from..].iter().position(|&b| b == b',').map_or(text.len() - from, |at| at + 1);
            if column > 0 && column + to - from > MAX_LINE {
                out.extend_from_slice(style.eol);
                column = 0;
            }
            out.extend_from_slice(&text[from..to]);
            column += to - from;
            from = to;
        }
    }
    out.extend_from_slice(style.eol);
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::Isometry3;
    use robot_model::units::{m_from_mm, rad_from_deg};

    const LITERAL: &[u8] = b"[[400.000, 0, 250],[1,0,0,0],[0,0,-1,1],[9E+09,9E+09,9E9,9E9,9E9,9E9]]";

    fn written() -> TargetValue {
        TargetValue::Rob(RobTarget {
            object_from_tcp: Isometry3::translation(0.4, 0.0, 0.25),
            conf: rapid_program::data::ConfData { cf1: 0, cf4: 0, cf6: -1, cfx: 1 },
            ext: [None; 6],
        })
    }

    fn array<'t>(
        name: &str,
        first_element: Cow<'t, [u8]>,
        original: TargetValue,
        corrected: &'t [Corrected],
    ) -> TargetArray<'t> {
        TargetArray {
            name: name.into(),
            dims: Vec::new(),
            rows: vec![ArrayRow { original, first_element, corrected: Cow::Borrowed(corrected) }],
        }
    }

    fn pose(x_mm: f64) -> Corrected {
        Corrected::Pose {
            position_m: [m_from_mm(x_mm), 0.0, m_from_mm(250.0)],
            orientation_wxyz: [1.0, 0.0, 0.0, 0.0],
        }
    }

    fn style() -> LayoutStyle {
        LayoutStyle { eol: b"\r\n", indent: b"  ".to_vec(), unit: b"  ".to_vec() }
    }

    #[test]
    fn an_array_of_robtargets() {
        let written = written();
        let first_element = first_element(Some(LITERAL), Some(&written)).unwrap();
        let corrected = [pose(400.125), pose(400.0625)];
        let array = array("tc57", first_element, written, &corrected);
        let mut out = Vec::new();
        array.write(&mut out, &style(), &mut Elements::default()).unwrap();
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "  LOCAL CONST robtarget tc57{3}:=[\r\n\
             \x20   [[400.000, 0, 250],[1,0,0,0],[0,0,-1,1],[9E+09,9E+09,9E9,9E9,9E9,9E9]],\r\n\
             \x20   [[400.125,0,250],[1,0,0,0],[0,0,-1,1],[9E+09,9E+09,9E9,9E9,9E9,9E9]],\r\n\
             \x20   [[400.0625,0,250],[1,0,0,0],[0,0,-1,1],[9E+09,9E+09,9E9,9E9,9E9,9E9]]];\r\n"
        );
    }

    #[test]
    fn without_plain_spelling_the_numbers_stand() {
        let written = written();
        for literal in [None, Some(b"[[x,0,250],ori,conf,ext]".as_slice()), Some(b"p10")] {
            let text = first_element(literal, Some(&written)).unwrap();
            assert_eq!(
                String::from_utf8_lossy(&text),
                "[[400,0,250],[1,0,0,0],[0,0,-1,1],[9E9,9E9,9E9,9E9,9E9,9E9]]"
            );
        }
        let broken_over_lines = b"[[400.0,\r\n\t0,250],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]";
        let text = first_element(Some(broken_over_lines), Some(&written)).unwrap();
        assert_eq!(
            String::from_utf8_lossy(&text),
            "[[400.0,0,250],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]"
        );
    }

    #[test]
    fn joints_are_jointtargets() {
        let target =
            rapid_program::data::JointTarget { q_rad: [Some(rad_from_deg(90.0)); 6], ext: [None; 6] };
        let written = TargetValue::Joint(target);
        let first_element = first_element(None, Some(&written)).unwrap();
        let corrected = [Corrected::Joints { q_rad: [rad_from_deg(45.0); 6] }];
        let joints = array("tc3", first_element, written, &corrected);
        let mut out = Vec::new();
        joints.write(&mut out, &style(), &mut Elements::default()).unwrap();
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "  LOCAL CONST jointtarget tc3{2}:=[\r\n    \
             [[90,90,90,90,90,90],[9E9,9E9,9E9,9E9,9E9,9E9]],\r\n    \
             [[45,45,45,45,45,45],[9E9,9E9,9E9,9E9,9E9,9E9]]];\r\n"
        );
        let corrected = [pose(1.0)];
        let mixed = array("tc3", Cow::Borrowed(b"[[],[]]"), written, &corrected);
        assert!(mixed.write(&mut Vec::new(), &style(), &mut Elements::default()).is_err());
    }

    #[test]
    fn long_elements_are_broken_at_commas() {
        let number = "1234567.123456789012";
        let six = [number; 6].join(",");
        let literal = format!("[[{number},{number},{number}],[1,0,0,0],[0,0,0,0],[{six}]]");
        let written = written();
        let first_element = first_element(Some(literal.as_bytes()), Some(&written)).unwrap();
        let corrected = [pose(400.0)];
        let array = array("tc3", first_element, written, &corrected);
        let mut out = Vec::new();
        let deep = LayoutStyle { eol: b"\n", indent: vec![b' '; 16], unit: vec![b' '; 8] };
        array.write(&mut out, &deep, &mut Elements::default()).unwrap();
        assert!(out.split(|&b| b == b'\n').all(|line| line.len() <= MAX_LINE));
        let joined: Vec<u8> = out.iter().copied().filter(|&b| !white(b)).collect();
        assert!(String::from_utf8_lossy(&joined).contains(&literal));
    }
}
