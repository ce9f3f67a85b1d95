//! The arm in the recording itself, as ROS 2 publishes it: Foxglove and Rerun draw what they find there, without the file beside.

use super::SchemaOf;

/// The topic that both look for an arm in.
pub(super) const TOPIC: &str = "/robot_description";

/// A string of ROS 2: Rerun takes an arm from no other type.
pub(super) fn schema() -> SchemaOf {
    SchemaOf {
        name: "std_msgs/msg/String".to_owned(),
        encoding: "ros2msg",
        message_encoding: "cdr",
        data: b"string data\n".to_vec(),
    }
}

/// A URDF as a message: CDR with the lowest byte first.
pub(super) fn message(urdf: &str) -> Vec<u8> {
    // four bytes say how the rest is encoded; then length with the zero at the end, text, zero
    let length = u32::try_from(urdf.len() + 1).unwrap_or(u32::MAX);
    [&[0, 1, 0, 0], &length.to_le_bytes()[..], urdf.as_bytes(), &[0]].concat()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand after OMG's CDR (a string: length with the zero at its end, text, zero) and DDSI-RTPS (CDR_LE is 00 01, options 00 00).
    #[test]
    fn a_string_is_encoded_as_by_hand() {
        assert_eq!(message("ab"), [0, 1, 0, 0, 3, 0, 0, 0, b'a', b'b', 0]);
    }
}
