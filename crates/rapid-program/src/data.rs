//! RAPID's motion data as typed values, in SI.
//!
//! RAPID's `orient` is written w first; nalgebra stores x, y, z, w. The conversion is made where text is
//! read and where it is written, nowhere else.

use nalgebra::Isometry3;

/// `confdata`: which of the arm's solutions is meant, in quarter turns (cf1, cf4, cf6) and the
/// controller's number of the solution (cfx).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConfData {
    /// Quadrant of axis 1.
    pub cf1: i32,
    /// Quadrant of axis 4.
    pub cf4: i32,
    /// Quadrant of axis 6.
    pub cf6: i32,
    /// 4·(wrist centre behind axis 1) + 2·(wrist centre behind the lower arm) + (axis 5 negative).
    pub cfx: i32,
}

/// `extjoint`: external axes as written (mm or degrees, as the axis is); `None` where it is not used
/// (`9E9` in RAPID).
pub type ExtJoint = [Option<f64>; 6];

/// The letter by which RAPID names an external axis, of `eax_a` to `eax_f`; `axis` counts from 0.
pub(super) fn external_axis_letter(axis: usize) -> char {
    ['a', 'b', 'c', 'd', 'e', 'f'].get(axis).copied().unwrap_or('?')
}

/// The letters of the external axes that `chosen` says, separated by commas as `--base-fixed` takes them.
pub(super) fn external_axis_letters(chosen: impl IntoIterator<Item = bool>) -> String {
    let letters: Vec<String> = chosen
        .into_iter()
        .enumerate()
        .filter(|(_, is_chosen)| *is_chosen)
        .map(|(axis, _)| external_axis_letter(axis).to_string())
        .collect();
    letters.join(",")
}

/// What is to be said of a place of an external axis to which none gets: 1E9 where 9E9 is meant.
pub(super) fn meant_as_unused(place: f64) -> Option<String> {
    (place.abs() >= FAR_FROM_ANY_AXIS)
        .then(|| format!("; {place:E} is a place, and only 9E9 says that there is no axis"))
}

/// No external axis goes so far, mm or degrees.
const FAR_FROM_ANY_AXIS: f64 = 1e7;

/// `robtarget`: a pose of the TCP with the arm's configuration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RobTarget {
    /// The TCP frame in the work object: `object_from_tcp`, metres.
    pub object_from_tcp: Isometry3<f64>,
    /// Which of the arm's solutions is meant.
    pub conf: ConfData,
    /// External axes as they are written.
    pub ext: ExtJoint,
}

/// `jointtarget`: the positions of all axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JointTarget {
    /// The six axes in radians; `None` where a robot axis is written `9E9`.
    pub q_rad: [Option<f64>; 6],
    /// External axes as they are written.
    pub ext: ExtJoint,
}

/// `loaddata`, of which gravity effects need mass and centre.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LoadData {
    /// Mass of the load, kg.
    pub mass_kg: f64,
    /// Centre of gravity in the tool frame's mounting frame, metres.
    pub cog_m: [f64; 3],
}

impl LoadData {
    /// Whether it is none: RAPID's `load0`, and what hangs on `tool0`, weigh a gram.
    #[must_use]
    pub fn weighs_nothing(&self) -> bool {
        const NO_LOAD_KG: f64 = 0.001;
        self.mass_kg <= NO_LOAD_KG
    }
}

/// `tooldata`: a tool's frame and load.
#[derive(Clone, Debug, PartialEq)]
pub struct ToolData {
    /// The robot holds the tool; otherwise it is stationary and the robot holds the work object.
    pub robhold: bool,
    /// `flange_from_tcp` where the robot holds it, `world_from_tcp` where it is stationary. Metres.
    pub frame_from_tcp: Isometry3<f64>,
    /// The load of the tool.
    pub load: LoadData,
}

/// `wobjdata`: where a work object stands.
#[derive(Clone, Debug, PartialEq)]
pub struct WobjData {
    /// The robot holds the work object (the tool is then stationary).
    pub robhold: bool,
    /// The user frame is fixed; otherwise it is moved by the mechanical unit `ufmec`.
    pub ufprog: bool,
    /// Mechanical unit that moves the user frame.
    pub ufmec: String,
    /// `world_from_user`, or `flange_from_user` where the robot holds the work object. Metres.
    pub uframe: Isometry3<f64>,
    /// The object frame: `user_from_object`, metres.
    pub oframe: Isometry3<f64>,
}

impl WobjData {
    /// `uframe · oframe`: where the object frame stands.
    #[must_use]
    pub fn frame_from_object(&self) -> Isometry3<f64> {
        self.uframe * self.oframe
    }

    /// `wobj0`: the frame of the base.
    #[must_use]
    pub fn wobj0() -> Self {
        Self {
            robhold: false,
            ufprog: true,
            ufmec: String::new(),
            uframe: Isometry3::identity(),
            oframe: Isometry3::identity(),
        }
    }
}

impl ToolData {
    /// `tool0`: the flange, weighing a gram.
    #[must_use]
    pub fn tool0() -> Self {
        Self {
            robhold: true,
            frame_from_tcp: Isometry3::identity(),
            load: LoadData { mass_kg: 0.001, cog_m: [0.0, 0.0, 0.001] },
        }
    }
}

/// `speeddata`, of which the time between updates of the clock is estimated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpeedData {
    /// Speed of the TCP, m/s.
    pub v_tcp_m_s: f64,
    /// Speed of turning about the TCP, rad/s.
    pub v_ori_rad_s: f64,
}

/// `zonedata`, of which the review needs whether the point is passed or stopped in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ZoneData {
    /// The robot stops in the point.
    pub finep: bool,
    /// Radius of the TCP's zone, metres.
    pub pzone_tcp_m: f64,
}
