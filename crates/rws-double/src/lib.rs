//! A strict double of Robot Web Services: one server with the personalities of RobotWare 6, 7 and 8.
//!
//! It refuses what a controller is known to refuse, and what it does not know: 404, never a polite 200. A request that could move
//! a robot, change its configuration or restart it is a hit of the [`tripwire`], and fails the test that made it. It answers
//! kinematics by `rs-opw-kinematics`.
//!
//! Knows nothing of the client that it tests: requests, answers, digest and RAPID data are read and written by code of its own.
//!
//! # Not proven
//!
//! What no document says and no one has written down from a controller; RobotStudio's virtual controller would tell:
//!
//! - Kinematics: on RobotWare 7 at all, and its units there; base or world frame; the sense of `robot_fixed_object`; whether
//!   Absolute Accuracy is in it; whether it answers while the robot moves.
//! - Load: whether RobotWare 7 and 8 want the program pointer reset; errors of RAPID (299008) on 8; the code of a clash of names.
//! - Data: a write in automatic while the program runs; elements `{i}` on 7 and 8; the codes for a wrong type, VAR, CONST, more
//!   than 80 characters.
//! - Rights: RobotWare 8 in manual mode; which grant each write needs; edit in manual mode on 7; PUT on 8 without write access;
//!   whether a logout gives mastership back on 7.
//! - Stations: whether a station that registers again in another session still holds its write access, as here;
//!   the request to the operator on 8.2 and later; rules of pin codes; the status while nobody holds write access.
//! - Sessions: 70 of them, 300 s, 25 minutes; their number on OmniCore; logout on 6; how strict `nc` is; mastership for each
//!   connection on every RobotWare 6.
//! - Memory: what the tree of devices calls RAPID and its memory, and whether it shows it at all; whether RobotWare 7 and 8 tell
//!   the space of their disks anywhere.
//! - Text: `$HOME` against `HOME`; escapes in JSON; exponents of numbers; `;` in subscriptions encoded or not.

mod arm;

mod certificate;
mod changes;
mod controller;
mod decide;
mod digest;
mod events;
mod fault;
mod groups;
mod http;
mod motion;
mod page;
mod personality;
mod rapid;
mod resources;
mod rights;
mod serve;
mod sessions;
pub mod tripwire;
mod world;

pub use arm::{ArmLengths, Planted};
pub use controller::{Controller, Holder, Module, Operator};
pub use fault::{Fault, Plan, RequestSeen};
pub use personality::Personality;
pub use serve::Double;
pub use world::Options;
