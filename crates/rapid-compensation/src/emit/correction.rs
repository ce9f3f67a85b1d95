//! Corrections of the form `ramp` as constants: a shift and a small turn, or six joint angles.

use super::aggregate::{brackets, with_commas};
use super::checksum;
use super::insertion::LayoutStyle;
use super::target::MAX_LINE;
use crate::compensate::plan::Correction;
use rapid_syntax::write_num;
use robot_model::units::{deg_from_rad, mm_from_m};
use std::io::Write as _;

/// Shifts are written to this, mm, joints to this, degrees, and parts of a quaternion to this.
const SHIFT_DECIMALS: i32 = 5;
const JOINT_DECIMALS: i32 = 6;
const TURN_DECIMALS: i32 = 8;

/// The correction of a target, or of all elements of an array, at the node of one function of time.
#[derive(Clone, Debug)]
pub(super) struct CorrectionData {
    /// The name of the data.
    pub name: String,
    /// Of an array, for a target that differs with an array's element; else empty.
    pub dims: Vec<usize>,
    /// One value, or one for each element, the last dimension fastest.
    pub values: Vec<Correction>,
}

impl CorrectionData {
    /// Whether it is the same under another name.
    #[must_use]
    pub(super) fn is_same(&self, other: &Self) -> bool {
        self.dims == other.dims && self.values == other.values
    }

    /// Appends the declaration; gives what it is recognised by.
    #[must_use]
    pub(super) fn write(&self, out: &mut Vec<u8>, style: &LayoutStyle) -> Vec<u8> {
        let joint = matches!(self.values.first(), Some(Correction::Joints { .. }));
        out.extend_from_slice(&style.indent);
        out.extend_from_slice(b"LOCAL CONST ");
        out.extend_from_slice(if joint { b"robjoint " } else { b"pose " });
        out.extend_from_slice(self.name.as_bytes());
        let mut value = Vec::new();
        if self.dims.is_empty() {
            out.extend_from_slice(b":=");
            self.values.iter().for_each(|one| write_correction(&mut value, one));
            out.extend_from_slice(&value);
            out.extend_from_slice(b";");
        } else {
            out.extend_from_slice(format!("{{{}}}:=[", with_commas(&self.dims)).as_bytes());
            value.push(b'[');
            let mut column = MAX_LINE;
            for (k, one) in self.values.iter().enumerate() {
                let (open, close) = brackets(&self.dims, k);
                let mut text = b"[".repeat(open);
                write_correction(&mut text, one);
                text.extend(b"]".repeat(close));
                text.extend_from_slice(if k + 1 < self.values.len() { b"," } else { b"];" });
                style.push_part(out, &mut column, &text, MAX_LINE / 2);
                value.extend_from_slice(&text);
            }
            value.truncate(value.len().saturating_sub(1));
        }
        out.extend_from_slice(style.eol);
        checksum::of_numbers(&value).to_vec()
    }
}

/// Appends a correction as RAPID's `pose`, or `robjoint`.
pub(super) fn write_correction(out: &mut Vec<u8>, correction: &Correction) {
    match correction {
        Correction::Pose { shift_m, turn } => {
            out.push(b'[');
            write_rounded(out, shift_m.map(mm_from_m), SHIFT_DECIMALS);
            out.extend_from_slice(b",[1,");
            let mut parts = Vec::new();
            write_rounded(&mut parts, *turn, TURN_DECIMALS);
            out.extend_from_slice(parts.get(1..).unwrap_or_default());
            out.push(b']');
        }
        Correction::Joints { turn_rad } => write_rounded(out, turn_rad.map(deg_from_rad), JOINT_DECIMALS),
    }
}

/// A list of numbers with so many decimals at most.
fn write_rounded<const N: usize>(out: &mut Vec<u8>, values: [f64; N], decimals: i32) {
    let scale = 10_f64.powi(decimals);
    out.push(b'[');
    for (i, value) in values.into_iter().enumerate() {
        if i > 0 {
            out.push(b',');
        }
        write_short(out, (value * scale).round() / scale);
    }
    out.push(b']');
}

/// A number as [`write_num`] writes it, or with an exponent where that is shorter: 0.0000123 as 1.23E-5.
fn write_short(out: &mut Vec<u8>, value: f64) {
    let from = out.len();
    write_num(out, value);
    let plain = out.get(from..).unwrap_or_default();
    let digits = plain.strip_prefix(b"-").unwrap_or(plain);
    // Elsewhere an exponent takes the place of too little.
    if !digits.starts_with(b"0.00") && digits.contains(&b'.') {
        return;
    }
    let length = plain.len();
    let end = out.len();
    if write!(out, "{value:E}").is_ok() && out.len() - end < length {
        out.drain(from..end);
    } else {
        out.truncate(end);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn style() -> LayoutStyle {
        LayoutStyle { eol: b"\n", indent: b"  ".to_vec(), unit: b"  ".to_vec() }
    }

    #[test]
    fn a_shift_in_mm_and_a_small_turn() {
        let correction = Correction::Pose { shift_m: [1e-4, -2.5e-5, 0.0], turn: [1.25e-5, 0.0, -0.001] };
        let data = CorrectionData { name: "tcP10".into(), dims: Vec::new(), values: vec![correction] };
        let mut out = Vec::new();
        let checksums = data.write(&mut out, &style());
        assert_eq!(
            String::from_utf8(out).unwrap(),
            "  LOCAL CONST pose tcP10:=[[0.1,-0.025,0],[1,1.25E-5,0,-1E-3]];\n"
        );
        assert_eq!(checksums, checksum::of_numbers(b"[[0.1,-0.025,0],[1,0.0000125,0,-0.001]]"));
    }

    #[test]
    fn an_exponent_stands_where_it_is_shorter() {
        let (mut found, mut exponents) = (Vec::new(), 0);
        let steps = (-2000..2000).chain((0..40).map(|i| 25 * 10_i64.pow(i % 9) + i64::from(i)));
        for (value, decimals) in steps.flat_map(|n| [5, 6, 8].map(|d| (n as f64 / 10_f64.powi(d), d))) {
            found.clear();
            write_rounded(&mut found, [value], decimals);
            let value = (value * 10_f64.powi(decimals)).round() / 10_f64.powi(decimals);
            let (mut plain, short) = (Vec::new(), format!("{value:E}"));
            write_num(&mut plain, value);
            let shortest = if short.len() < plain.len() { short.as_bytes() } else { &plain };
            assert_eq!(found, [b"[", shortest, b"]"].concat());
            exponents += usize::from(short.len() < plain.len());
        }
        assert!(exponents > 1000, "{exponents}");
    }

    #[test]
    fn arrays_stay_within_lines() {
        let correction = Correction::Joints { turn_rad: [0.01; 6] };
        let data = CorrectionData { name: "tcHome".into(), dims: vec![9], values: vec![correction; 9] };
        let mut out = Vec::new();
        let checksums = data.write(&mut out, &style());
        let text = String::from_utf8(out).unwrap();
        assert!(text.starts_with("  LOCAL CONST robjoint tcHome{9}:=[\n    [0.572958,"), "{text}");
        assert!(text.ends_with("]];\n") && text.lines().all(|line| line.len() <= MAX_LINE));
        let value = text.split_once(":=").unwrap().1.trim_end().trim_end_matches(';');
        assert_eq!(checksums, checksum::of_numbers(value.as_bytes()));
    }
}
