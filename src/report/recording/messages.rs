//! Foxglove's messages as Protobuf: Foxglove reads them in any encoding, Rerun in this one alone.
//!
//! Fields and numbers are those of Foxglove's schemas (foxglove-sdk, `schemas/proto/foxglove`, MIT).

use nalgebra::Isometry3;
use prost_types::Timestamp;

#[derive(Clone, PartialEq, prost::Message)]
pub(super) struct Xyz {
    #[prost(double, tag = "1")]
    pub x: f64,
    #[prost(double, tag = "2")]
    pub y: f64,
    #[prost(double, tag = "3")]
    pub z: f64,
}

#[derive(Clone, PartialEq, prost::Message)]
pub(super) struct Xyzw {
    #[prost(double, tag = "1")]
    pub x: f64,
    #[prost(double, tag = "2")]
    pub y: f64,
    #[prost(double, tag = "3")]
    pub z: f64,
    #[prost(double, tag = "4")]
    pub w: f64,
}

/// `foxglove.FrameTransform`
#[derive(Clone, PartialEq, prost::Message)]
pub(super) struct FrameTransform {
    #[prost(message, optional, tag = "1")]
    pub timestamp: Option<Timestamp>,
    #[prost(string, tag = "2")]
    pub parent_frame_id: String,
    #[prost(string, tag = "3")]
    pub child_frame_id: String,
    #[prost(message, optional, tag = "4")]
    pub translation: Option<Xyz>,
    #[prost(message, optional, tag = "5")]
    pub rotation: Option<Xyzw>,
}

/// `foxglove.FrameTransforms`
#[derive(Clone, PartialEq, prost::Message)]
pub(super) struct FrameTransforms {
    #[prost(message, repeated, tag = "1")]
    pub transforms: Vec<FrameTransform>,
}

/// `foxglove.Pose`
#[derive(Clone, PartialEq, prost::Message)]
pub(super) struct Pose {
    #[prost(message, optional, tag = "1")]
    pub position: Option<Xyz>,
    #[prost(message, optional, tag = "2")]
    pub orientation: Option<Xyzw>,
}

/// `foxglove.PosesInFrame`
#[derive(Clone, PartialEq, prost::Message)]
pub(super) struct PosesInFrame {
    #[prost(message, optional, tag = "1")]
    pub timestamp: Option<Timestamp>,
    #[prost(string, tag = "2")]
    pub frame_id: String,
    #[prost(message, repeated, tag = "3")]
    pub poses: Vec<Pose>,
}

/// `foxglove.Log`
#[derive(Clone, PartialEq, prost::Message)]
pub(super) struct Log {
    #[prost(message, optional, tag = "1")]
    pub timestamp: Option<Timestamp>,
    /// Severity: 2 is information, 3 a warning.
    #[prost(int32, tag = "2")]
    pub level: i32,
    #[prost(string, tag = "3")]
    pub message: String,
    #[prost(string, tag = "4")]
    pub name: String,
    #[prost(string, tag = "5")]
    pub file: String,
    #[prost(fixed32, tag = "6")]
    pub line: u32,
}

/// Place, metres, and orientation of a pose.
pub(super) fn parts(pose: &Isometry3<f64>) -> (Xyz, Xyzw) {
    let (p, q) = (&pose.translation.vector, pose.rotation.quaternion());
    (Xyz { x: p.x, y: p.y, z: p.z }, Xyzw { x: q.i, y: q.j, z: q.k, w: q.w })
}

#[cfg(test)]
mod tests {
    use super::*;
    use prost::Message;

    /// By hand after Protobuf's encoding: field number times 8 plus 1 for eight bytes, 2 for what has a length, 5 for four bytes; lengths; and
    /// doubles with the lowest byte first (1.0 is 3F F0 and six zeros). A zero is left out.
    #[test]
    fn messages_are_encoded_as_by_hand() {
        let one = [0, 0, 0, 0, 0, 0, 0xf0, 0x3f];
        let pose = Pose {
            position: Some(Xyz { x: 0.0, y: 1.0, z: 0.0 }),
            orientation: Some(Xyzw { x: 0.0, y: 0.0, z: 0.0, w: 1.0 }),
        };
        let in_pose = [&[0x0a, 9, 0x11], &one[..], &[0x12, 9, 0x21], &one].concat();
        assert_eq!(pose.encode_to_vec(), in_pose);
        let time = Timestamp { seconds: 90, nanos: 5 };
        let in_time = [0x0a, 4, 0x08, 90, 0x10, 5];
        let poses = PosesInFrame { timestamp: Some(time), frame_id: "b".to_owned(), poses: vec![pose] };
        assert_eq!(poses.encode_to_vec(), [&in_time[..], &[0x12, 1, b'b', 0x1a, 22], &in_pose].concat());
        let transform = FrameTransform {
            timestamp: Some(time),
            parent_frame_id: "b".to_owned(),
            child_frame_id: "c".to_owned(),
            translation: Some(Xyz { x: 1.0, y: 0.0, z: 0.0 }),
            rotation: None,
        };
        let in_transform = [&in_time[..], &[0x12, 1, b'b', 0x1a, 1, b'c', 0x22, 9, 0x09], &one].concat();
        let all = FrameTransforms { transforms: vec![transform] };
        assert_eq!(all.encode_to_vec(), [&[0x0a, in_transform.len() as u8], &in_transform[..]].concat());
        let log = Log {
            timestamp: None,
            level: 3,
            message: "m".to_owned(),
            name: "n".to_owned(),
            file: "f".to_owned(),
            line: 258,
        };
        let in_log = [0x10, 3, 0x1a, 1, b'm', 0x22, 1, b'n', 0x2a, 1, b'f', 0x35, 2, 1, 0, 0];
        assert_eq!(log.encode_to_vec(), in_log);
    }
}
