//! What a search finds: spheres that stand fixed in the cell, touched by the true robot's tip.
//!
//! The controller moves by its nominal kinematics and is told by a signal where the tip touches; where that is, only the
//! true arm knows. Knows nothing of why a program searches.

use super::frame::Setup;
use nalgebra::Point3;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use robot_model::deform::{Conditions, DeformedArm};
use robot_model::units::m_from_mm;
use serde::Deserialize;

/// A sphere that stands fixed in the cell.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    /// The signal that a touch of it sets.
    pub signal: String,
    /// Its centre in the base, mm.
    pub centre_mm: [f64; 3],
    /// From its centre to the tip's centre where they touch, mm.
    pub radius_mm: f64,
    /// One standard deviation of where a touch is felt, mm.
    #[serde(default)]
    pub noise_mm: f64,
    /// So many of all searches find something that lies on the sphere, 0 to 1.
    #[serde(default)]
    pub false_share: f64,
    /// How thick it is, least and most, mm.
    #[serde(default)]
    pub false_mm: [f64; 2],
    /// What noise and false touches are drawn by.
    #[serde(default)]
    pub seed: u64,
}

/// The spheres of a cell, and the arm that touches them.
#[derive(Debug, Default)]
pub(super) struct Spheres {
    all: Vec<(Sphere, ChaCha8Rng)>,
    /// The true arm as it is now; without one the nominal arm's touches are not known.
    pub arm: Option<DeformedArm>,
}

/// How far the tip's centre is from where it is felt to touch, metres, by the joints.
pub(super) struct Feeler<'s> {
    arm: &'s DeformedArm,
    centre_m: Point3<f64>,
    reach_m: f64,
    conditions: Conditions,
    setup: &'s Setup,
}

impl Spheres {
    pub(crate) fn add(&mut self, sphere: Sphere) {
        let rng = ChaCha8Rng::seed_from_u64(sphere.seed);
        self.all.push((sphere, rng));
    }

    /// What a search by this signal feels; `None` where no sphere sets it, or the arm holds no tool.
    pub(crate) fn feeler<'s>(&'s mut self, signal: &str, setup: &'s Setup) -> Option<Feeler<'s>> {
        let arm = self.arm.as_ref().filter(|_| setup.tool_held)?;
        let (sphere, rng) = self.all.iter_mut().find(|(s, _)| s.signal.eq_ignore_ascii_case(signal))?;
        let noise: f64 = StandardNormal.sample(rng);
        let [is_false, thick] = [(); 2].map(|()| rng.random::<f64>());
        let [least, most] = sphere.false_mm;
        let dirt_mm = if is_false < sphere.false_share { least + (most - least) * thick } else { 0.0 };
        Some(Feeler {
            arm,
            centre_m: Point3::from(sphere.centre_mm.map(m_from_mm)),
            reach_m: m_from_mm(sphere.radius_mm + noise * sphere.noise_mm + dirt_mm),
            conditions: Conditions { payload: setup.payload, direction: [0; 6] },
            setup,
        })
    }
}

impl Feeler<'_> {
    /// Metres; under 0 from where the touch is felt.
    pub(crate) fn gap_m(&self, q_rad: &[f64; 6]) -> f64 {
        let base_from_tcp = self.arm.under(&self.conditions).forward(q_rad) * self.setup.frame_from_tcp;
        (Point3::from(base_from_tcp.translation.vector) - self.centre_m).norm() - self.reach_m
    }
}
