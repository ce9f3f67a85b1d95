//! The place that an element of an array holds, between text and numbers.

use crate::emit::aggregate::{singles, tail_of};
use crate::emit::record_text::write_orient;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use rapid_syntax::write_num;
use robot_model::units::{deg_from_rad, rad_from_deg};

/// Numbers of a robtarget.
pub(super) const ROBTARGET: usize = 17;

/// A target's place: a position with an orientation, or joints.
#[derive(Clone, Debug)]
pub(super) enum TargetPose {
    Pose(Vector3<f64>, UnitQuaternion<f64>),
    /// Six joint angles of a jointtarget, degrees.
    Joints([f64; 6]),
}

impl TargetPose {
    pub(super) fn of(text: &[u8]) -> Option<Self> {
        Self::of_numbers(singles(text)?.into_iter())
    }

    pub(super) fn of_numbers(numbers: impl Iterator<Item = f32>) -> Option<Self> {
        let n: Vec<f64> = numbers.map(f64::from).collect();
        if n.len() == ROBTARGET {
            let q = UnitQuaternion::from_quaternion(Quaternion::new(n[3], n[4], n[5], n[6]));
            return Some(Self::Pose(Vector3::new(n[0], n[1], n[2]), q));
        }
        Some(Self::Joints(n.get(..6)?.try_into().ok()?))
    }

    /// mm, or degrees of the joint that differs most; and the angle, degrees.
    pub(super) fn distance(&self, other: &Self) -> (f64, f64) {
        match (self, other) {
            (Self::Pose(a, q), Self::Pose(b, p)) => ((a - b).norm(), deg_from_rad(q.angle_to(p))),
            (Self::Joints(a), Self::Joints(b)) => {
                (a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max), 0.0)
            }
            _ => (f64::INFINITY, f64::INFINITY),
        }
    }

    /// How far it is from another, and in what unit it is told.
    pub(super) fn moved_from(&self, from: &Self) -> (f64, &'static str) {
        let (far, turned) = self.distance(from);
        match self {
            Self::Joints(_) => (far, "deg"),
            Self::Pose(..) if far < 1e-4 && turned > 0.0 => (turned, "deg"),
            Self::Pose(..) => (far, "mm"),
        }
    }

    /// The place moved so many `times` by a correction as the comment block holds it.
    pub(super) fn moved_by(&self, correction: &[f64; 6], times: f64) -> Self {
        let [x, y, z, rx, ry, rz] = correction.map(|number| number * times);
        match self {
            Self::Pose(at, q) => {
                let turn = UnitQuaternion::from_scaled_axis(Vector3::new(rx, ry, rz).map(rad_from_deg));
                Self::Pose(at + Vector3::new(x, y, z), turn * q)
            }
            Self::Joints(at) => Self::Joints(std::array::from_fn(|i| at[i] + times * correction[i])),
        }
    }

    /// The place without `times` what leads from `from` to `to`.
    pub(super) fn without(&self, times: f64, from: &Self, to: &Self) -> Option<Self> {
        match (self, from, to) {
            (Self::Pose(at, q), Self::Pose(a, p), Self::Pose(b, r)) => {
                let turn = (r * p.inverse()).scaled_axis() * times;
                Some(Self::Pose(at - (b - a) * times, UnitQuaternion::from_scaled_axis(-turn) * q))
            }
            (Self::Joints(at), Self::Joints(a), Self::Joints(b)) => {
                Some(Self::Joints(std::array::from_fn(|i| at[i] - times * (b[i] - a[i]))))
            }
            _ => None,
        }
    }

    /// As text, with configuration and external axes as `touched`, the text of an element, has them.
    pub(super) fn written(&self, touched: &[u8]) -> Vec<u8> {
        let mut out = b"[".to_vec();
        let rounded = |value: f64| (value * 1e4).round() / 1e4;
        let list = |out: &mut Vec<u8>, values: &[f64]| {
            out.push(b'[');
            for (i, value) in values.iter().enumerate() {
                if i > 0 {
                    out.push(b',');
                }
                write_num(out, rounded(*value));
            }
            out.push(b']');
        };
        let components = match self {
            TargetPose::Pose(at, q) => {
                list(&mut out, at.as_slice());
                out.push(b',');
                write_orient(&mut out, [q.w, q.i, q.j, q.k]);
                2
            }
            TargetPose::Joints(joints) => {
                list(&mut out, joints);
                1
            }
        };
        out.push(b',');
        out.extend_from_slice(tail_of(touched, components));
        out
    }
}
