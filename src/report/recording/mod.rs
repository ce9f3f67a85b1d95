//! A recording of the warm-up as MCAP with Foxglove's schemas, for Foxglove and Rerun, and the arm as URDF. SI units.
//!
//! One minute of warm-up is one minute of the recording.

mod description;
mod messages;
mod schemas;
mod urdf;

use urdf::urdf;

use messages::{FrameTransform, FrameTransforms, Log, Pose, PosesInFrame, parts};

use mcap::WriteOptions;
use mcap::records::MessageHeader;
use nalgebra::{Isometry3, Translation3, Vector3};
use prost::Message;
use prost_types::Timestamp;
use robot_model::robot::Robot;
use robot_model::units::{mm_from_m, seconds_from_min};
use std::collections::BTreeMap;
use std::io::{self, Cursor};

/// Frames of the arm from the base outward, as the URDF names its links.
const FRAMES: [&str; 7] = ["link_1", "link_2", "link_3", "link_4", "link_5", "link_6", "flange"];
const BASE: &str = "base_link";
/// Severity levels of `foxglove.Log`.
const INFO: i32 = 2;
const WARNING: i32 = 3;
const NANOSECONDS: f64 = 1e9;
/// When the first moment is recorded, nanoseconds: after the arm's description, whose joints stand at zero in Foxglove until a later transform.
const FIRST_NS: u64 = 1_000_000;

/// What goes into a recording.
#[derive(Debug)]
pub struct Recording<'a> {
    /// The arm as its model says.
    pub robot: &'a Robot,
    /// The recorded moments of the warm-up.
    pub moments: Vec<RecordingMoment>,
    /// Where the TCP is meant to be at each target, in the base.
    pub meant: Vec<Isometry3<f64>>,
    /// What becomes of each motion.
    pub corrections: Vec<LoggedCorrection<'a>>,
}

/// A moment of the warm-up.
#[derive(Debug)]
pub struct RecordingMoment {
    /// Minute of the warm-up.
    pub t_min: f64,
    /// Frames of the joints and of the flange in the base, as drawn.
    pub nominal: [Isometry3<f64>; 7],
    /// The same as table and model deform the arm.
    pub warm: [Isometry3<f64>; 7],
    /// For each target how far the TCP is from it without correction, metres.
    pub missed_m: Vec<Vector3<f64>>,
    /// The same as corrected; `None` where corrections are scaled at run time.
    pub corrected_m: Option<Vec<Vector3<f64>>>,
}

/// A line of the log.
#[derive(Debug)]
pub struct LoggedCorrection<'a> {
    /// File that the motion stands in.
    pub file: &'a str,
    /// Line of the motion there.
    pub line: u32,
    /// Name of the instruction.
    pub kind: &'a str,
    /// The largest correction, metres, or why there is none.
    pub status: Result<f64, &'a str>,
}

impl Recording<'_> {
    /// The arm as a description (URDF) for tools that do not read the one in the recording.
    #[must_use]
    pub fn arm_urdf(&self) -> String {
        urdf(self.robot)
    }

    /// The file, whole.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn mcap(&self) -> io::Result<Vec<u8>> {
        let mut bytes = Cursor::new(Vec::new());
        let library = concat!("driftpost ", env!("CARGO_PKG_VERSION"));
        let options = WriteOptions::new().compression(None).profile("").library(library);
        let mut writer = Topics { to: options.create(&mut bytes).map_err(io::Error::other)?, count: 0 };
        let [transforms, log, poses] = ["FrameTransforms", "Log", "PosesInFrame"].map(SchemaOf::foxglove);
        let arm = writer.topic(description::TOPIC, &description::schema())?;
        let tf = writer.topic("/tf", &transforms)?;
        let all: Vec<u16> = ["/targets/meant", "/targets/uncorrected", "/targets/corrected"]
            .iter()
            .map(|topic| writer.topic(topic, &poses))
            .collect::<io::Result<_>>()?;
        let corrections_topic = writer.topic("/corrections", &log)?;
        writer.write(arm, 0, &description::message(&urdf(self.robot)))?;
        for row in &self.corrections {
            writer.write(corrections_topic, FIRST_NS, &logged(row).encode_to_vec())?;
        }
        for moment in &self.moments {
            let (t_min, at_ns) = (moment.t_min, nanoseconds(moment.t_min));
            let mut list = chain(t_min, "", &moment.nominal);
            list.extend(chain(t_min, "warm/", &moment.warm));
            writer.write(tf, at_ns, &FrameTransforms { transforms: list }.encode_to_vec())?;
            let missed = Some(&moment.missed_m);
            let off = [None, missed, moment.corrected_m.as_ref()];
            for (k, (channel, off_m)) in all.iter().zip(off).enumerate() {
                if k == 0 || off_m.is_some() {
                    writer.write(*channel, at_ns, &self.poses(t_min, off_m).encode_to_vec())?;
                }
            }
        }
        writer.to.finish().map_err(io::Error::other)?;
        drop(writer);
        Ok(bytes.into_inner())
    }

    fn poses(&self, t_min: f64, off_m: Option<&Vec<Vector3<f64>>>) -> PosesInFrame {
        let moved = |(i, meant): (usize, &Isometry3<f64>)| {
            let by_m = off_m.and_then(|off_m| off_m.get(i)).copied().unwrap_or_default();
            let pose = Translation3::from(by_m) * meant;
            let (position, orientation) = parts(&pose);
            Pose { position: Some(position), orientation: Some(orientation) }
        };
        let poses = self.meant.iter().enumerate().map(moved).collect();
        PosesInFrame { timestamp: Some(time(t_min)), frame_id: BASE.to_owned(), poses }
    }
}

/// Transforms from frame to frame; names of the child frames begin with `prefix`.
fn chain(t_min: f64, prefix: &str, frames: &[Isometry3<f64>; 7]) -> Vec<FrameTransform> {
    let mut parent = (BASE.to_owned(), Isometry3::identity());
    let one = |(name, frame): (&&str, &Isometry3<f64>)| {
        let child = format!("{prefix}{name}");
        let (translation, rotation) = parts(&parent.1.inv_mul(frame));
        let (parent_frame_id, _) = std::mem::replace(&mut parent, (child.clone(), *frame));
        FrameTransform {
            timestamp: Some(time(t_min)),
            parent_frame_id,
            child_frame_id: child,
            translation: Some(translation),
            rotation: Some(rotation),
        }
    };
    FRAMES.iter().zip(frames).map(one).collect()
}

fn logged(row: &LoggedCorrection<'_>) -> Log {
    let LoggedCorrection { file, line, kind, .. } = row;
    let (level, message) = match row.status {
        Ok(by_m) => (INFO, format!("{kind}: corrected by {:.4} mm at most", mm_from_m(by_m))),
        Err(why) => (WARNING, format!("{kind} stays as it is: {why}")),
    };
    Log {
        timestamp: Some(time(0.0)),
        level,
        message,
        name: "driftpost".to_owned(),
        file: (*file).to_owned(),
        line: *line,
    }
}

fn nanoseconds(t_min: f64) -> u64 {
    ((seconds_from_min(t_min) * NANOSECONDS).round() as u64).max(FIRST_NS)
}

fn time(t_min: f64) -> Timestamp {
    let all = nanoseconds(t_min);
    let second = NANOSECONDS as u64;
    // less than a second, and a warm-up of less than 290 years
    Timestamp { seconds: (all / second) as i64, nanos: (all % second) as i32 }
}

struct Topics<'b> {
    to: mcap::Writer<&'b mut Cursor<Vec<u8>>>,
    count: u32,
}

/// How the messages of a topic are to be read.
struct SchemaOf {
    name: String,
    encoding: &'static str,
    message_encoding: &'static str,
    data: Vec<u8>,
}

impl SchemaOf {
    fn foxglove(name: &str) -> Self {
        let (encoding, message_encoding) = ("protobuf", "protobuf");
        Self { name: format!("foxglove.{name}"), encoding, message_encoding, data: schemas::of(name) }
    }
}

impl Topics<'_> {
    fn topic(&mut self, topic: &str, schema: &SchemaOf) -> io::Result<u16> {
        let SchemaOf { name, encoding, message_encoding, data } = schema;
        let schema = self.to.add_schema(name, encoding, data).map_err(io::Error::other)?;
        self.to.add_channel(schema, topic, message_encoding, &BTreeMap::new()).map_err(io::Error::other)
    }

    fn write(&mut self, channel_id: u16, at_ns: u64, message: &[u8]) -> io::Result<()> {
        self.count += 1;
        let header = MessageHeader { channel_id, sequence: self.count, log_time: at_ns, publish_time: at_ns };
        self.to.write_to_known_channel(&header, message).map_err(io::Error::other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    fn at(x: f64) -> Isometry3<f64> {
        Translation3::new(x, 0.0, 0.0).into()
    }

    /// An arm of frames one metre apart whose first frame creeps by a millimetre, and one target that it misses by as much.
    #[test]
    fn what_is_recorded_is_read_back() {
        let robot = Robot::built_in("irb140").unwrap();
        let moment = |t_min: f64, by_m: f64| RecordingMoment {
            t_min,
            nominal: std::array::from_fn(|i| at((i + 1) as f64)),
            warm: std::array::from_fn(|i| at((i + 1) as f64 + by_m)),
            missed_m: vec![Vector3::new(by_m, 0.0, 0.0)],
            corrected_m: None,
        };
        let recording = Recording {
            robot: &robot,
            moments: vec![moment(0.0, 0.0), moment(1.5, 0.001)],
            meant: vec![at(7.0)],
            corrections: vec![LoggedCorrection {
                file: "a.mod",
                line: 3,
                kind: "MoveL",
                status: Ok(0.000_19),
            }],
        };
        let bytes = recording.mcap().unwrap();
        let messages: Vec<_> = mcap::MessageStream::new(&bytes).unwrap().map(Result::unwrap).collect();
        let topics: BTreeSet<&str> = messages.iter().map(|m| m.channel.topic.as_str()).collect();
        assert_eq!(
            Vec::from_iter(topics),
            ["/corrections", "/robot_description", "/targets/meant", "/targets/uncorrected", "/tf"]
        );
        assert_eq!(messages.len(), 1 + 1 + 2 * 3);
        let last = |topic: &str| messages.iter().rfind(|m| m.channel.topic == topic).unwrap();
        assert_eq!(last("/tf").log_time, 90_000_000_000);
        // the description first: whatever comes later is after it
        assert_eq!((&*messages[0].channel.topic, messages[0].log_time), ("/robot_description", 0));
        assert!(messages[1..].iter().all(|message| message.log_time > 0));
        assert_eq!(last("/tf").channel.schema.as_ref().unwrap().name, "foxglove.FrameTransforms");
        assert_eq!(last("/tf").channel.message_encoding, "protobuf");
        let tf = FrameTransforms::decode(&*last("/tf").data).unwrap();
        let warm = &tf.transforms[7];
        assert_eq!((&*warm.parent_frame_id, &*warm.child_frame_id), ("base_link", "warm/link_1"));
        assert_eq!(warm.translation.as_ref().unwrap().x, 1.001);
        assert_eq!(warm.timestamp.unwrap(), Timestamp { seconds: 90, nanos: 0 });
        let missed = PosesInFrame::decode(&*last("/targets/uncorrected").data).unwrap();
        assert_eq!(missed.poses[0].position.as_ref().unwrap().x, 7.001);
        let log = Log::decode(&*last("/corrections").data).unwrap();
        assert_eq!((&*log.message, log.line), ("MoveL: corrected by 0.1900 mm at most", 3));
    }
}
