//! Robot Web Services of ABB controllers, in the dialects of RobotWare 6, 7 and 8.
//!
//! One [`Session`] is one login with its cookies: it asks one thing at a time, never repeats a write, gives back what right it
//! took and logs out when it ends, whichever way that is. Every request that it can make stands in [`requests::ALL`]; none of them
//! starts, stops or moves anything, and there is no other way to make one.
//!
//! Knows nothing of RAPID programs, of terminals and of the command line. Blocking; lengths are in metres and angles in radians,
//! as the controller has them.

mod abb;
mod answer;
mod contents;
mod data;
mod dialect;
mod error;
mod files;
mod form;
mod free_memory;
mod host;
mod identity;
mod kinematics;
mod login;
mod modules;
mod names;
mod open;
mod pins;
pub mod requests;
mod rights;
mod session;
mod states;
mod subscription;
mod wire;
mod xhtml;

pub use data::{DataKind, Property, same_value};
pub use dialect::Dialect;
pub use error::LinkError;
pub use files::RemoteFile;
pub use free_memory::{DeviceProperty, DiskSpace, FreeMemory};
pub use host::Host;
pub use identity::{Identity, Task};
pub use kinematics::{ArmPose, Configuration, Frame, Solution, Unit};
pub use login::Credentials;
pub use modules::LoadedModule;
pub use pins::Pins;
pub use session::{Session, Settings};
pub use states::{Execution, Mode};
pub use subscription::{DataName, Event, Subscription};
