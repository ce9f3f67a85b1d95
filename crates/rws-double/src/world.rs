//! All that the connections of a double share.

use crate::Personality;
use crate::arm::{ArmLengths, Solver};
use crate::controller::Controller;
use crate::digest::Nonces;
use crate::fault::Plan;
use crate::groups::Groups;
use crate::sessions::Sessions;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// What a double is made with.
#[derive(Clone, Debug)]
pub struct Options {
    /// RobotWare that the double plays.
    pub personality: Personality,
    /// Port on this computer; 0 for any that is free.
    pub port: u16,
    /// Requests that start sooner after the last are refused and counted.
    pub least_gap: Duration,
    /// The user and the password it takes.
    pub user: (String, String),
    /// Sessions at one time.
    pub sessions: usize,
    /// The arm that it calculates with.
    pub arm: ArmLengths,
    /// The other of the two certificates.
    pub other_certificate: bool,
}

impl Options {
    /// As a controller of this RobotWare is delivered.
    #[must_use]
    pub fn new(personality: Personality) -> Self {
        Self {
            personality,
            port: 0,
            least_gap: Duration::from_millis(50),
            user: ("Default User".to_owned(), "robotics".to_owned()),
            sessions: 70,
            arm: ArmLengths::IRB140,
            other_certificate: false,
        }
    }
}

/// All that the connections share.
pub(crate) struct World {
    pub controller: Controller,
    pub sessions: Sessions,
    pub solver: Solver,
    pub groups: Groups,
    pub nonces: Nonces,
    pub plan: Option<Plan>,
    pub count: usize,
    pub hits: Vec<String>,
    pub too_fast: usize,
    pub last_start: Option<Instant>,
    pub requests: Vec<String>,
}

pub(crate) struct Shared {
    pub world: Mutex<World>,
    pub stop: AtomicBool,
    pub options: Options,
    pub in_flight: AtomicUsize,
    pub connections: AtomicU64,
}

impl Shared {
    pub(crate) fn lock(&self) -> MutexGuard<'_, World> {
        self.world.lock().unwrap_or_else(PoisonError::into_inner)
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
