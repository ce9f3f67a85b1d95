//! Play in a joint's gear: where it stands depends on where it came from.

use super::{Candidate, Effect, Form, Motion, Scene, Site, turn_joint};

/// J_j times half the gap, on the side of the last motion; where gravity's torque is large, on its side.
pub struct Backlash;

/// Share of stations whose torque is taken as large enough to hold the teeth on one side.
const HELD: [f64; 6] = [0.0, 0.12, 0.3, 0.5, 0.7, 0.9];
/// Prior weight of all forms in which gravity holds the teeth, over that in which it does not.
const HELD_WEIGHT: f64 = 1.5;

impl Effect for Backlash {
    fn name(&self) -> &'static str {
        "backlash"
    }
    fn unit(&self) -> &'static str {
        "rad"
    }
    fn usual(&self) -> &'static str {
        "0.05 to 0.5 mrad in the wrist, 0.02 to 0.2 in the arm (the full gap)"
    }
    fn source(&self) -> &'static str {
        "Ahmad 1988, Analysis of robot drive train errors, their static effects, and their compensations"
    }
    fn untestable(&self, scene: &Scene) -> Option<String> {
        (!scene.channels.direction)
            .then(|| "the file has no directions of approach (dir1 to dir6)".to_owned())
    }
    fn candidates(&self, scene: &Scene) -> Vec<Candidate> {
        let mut all = Vec::new();
        for j in 0..6 {
            let usual = if j < 3 { 1e-4 } else { 2e-4 };
            let signs: Vec<i8> = scene.sites.iter().filter_map(|s| s.direction.map(|d| d[j])).collect();
            if !(signs.contains(&1) && signs.contains(&-1)) {
                continue;
            }
            let loaded = scene.sites.iter().any(|s| s.loads.torque_n_m[j].abs() > 1.0);
            // A driven joint lags behind its motor while its load pulls it ahead: opposite signs. Files that
            // count the direction the other way are taken as well, at a price.
            let forms = if loaded { 2 * HELD.len() - 1 } else { 1 };
            for variant in 0..forms {
                let form = Form { variant, ..Form::of_joint(j) };
                let share = if variant < HELD.len() { 0.75 } else { 0.25 };
                let weight = if variant == 0 { 1.0 } else { HELD_WEIGHT * share / (HELD.len() - 1) as f64 };
                all.push(Candidate { weight, ..Candidate::new(form, vec![usual]) });
            }
        }
        all
    }
    fn motions(&self, form: &Form, scene: &Scene, site: &Site, out: &mut Vec<Motion>) {
        let j = form.joint.unwrap_or(0).min(5);
        let mut side = f64::from(site.direction.map_or(0, |d| d[j]));
        let torque = site.loads.torque_n_m[j];
        let limit_n_m = held_above_n_m(form, scene);
        if form.variant > 0 && torque.abs() > limit_n_m.abs() {
            side = torque.signum() * limit_n_m.signum();
        }
        turn_joint(site, form.joint, 0.5 * side, out);
    }
}

/// The torque above which gravity holds the teeth, N.m; negative where its side counts against the direction's.
#[must_use]
pub(in crate::diagnose) fn held_above_n_m(form: &Form, scene: &Scene) -> f64 {
    let j = form.joint.unwrap_or(0).min(5);
    let (limit, sign) = match form.variant {
        v if v < HELD.len() => (v, -1.0),
        v => ((v + 1 - HELD.len()).min(HELD.len() - 1), 1.0),
    };
    sign * scene.torque_limit_n_m[j][limit].max(1e-9)
}

/// For each joint the torque above which a share of [`HELD`] of the stations lies, N.m.
#[must_use]
pub(in crate::diagnose) fn torque_limits_n_m(sites: &[Site]) -> [[f64; 6]; 6] {
    std::array::from_fn(|j| {
        let mut torques: Vec<f64> = sites.iter().map(|s| s.loads.torque_n_m[j].abs()).collect();
        torques.sort_by(f64::total_cmp);
        HELD.map(|share| {
            let index = ((1.0 - share) * torques.len() as f64) as usize;
            torques.get(index.min(torques.len().saturating_sub(1))).copied().unwrap_or(0.0)
        })
    })
}
