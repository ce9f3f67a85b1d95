//! The measurement file of a run: rows as an instrument in a place of its own records them.
//!
//! Writes what stands and what is at work; knows nothing of how either was drawn.

use super::arm::Disturbance;
use super::effect::SizedEffect;
use super::file_faults::FileFaults;
use super::recipe::Recipe;
use super::rng::Rng;
use super::run::MeasuredRun;
use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};
use robot_model::units::m_from_mm;
use std::fmt::Write as _;

/// Temperature of the air and of joints at cold start, degrees Celsius, and the scatter of a thermometer, K.
const COLD_C: f64 = 21.0;
const THERMOMETER_K: f64 = 0.1;

/// A run with all that its file is made of.
pub(super) struct RunRecord<'a> {
    pub run: &'a MeasuredRun<'a>,
    pub recipe: &'a Recipe,
    /// Number of each row's pose.
    pub poses: &'a [usize],
    pub effects: &'a [SizedEffect],
    pub background: &'a Disturbance,
    /// How far each point is off its nominal place, noise included, metres.
    pub off_m: &'a [Vector3<f64>],
    /// Whether nests on the base are read at the rows past the recipe's number.
    pub with_nests: bool,
}

/// Where nests on the base stand, base frame, metres: round the foot, none at the height of another.
const NESTS_M: [Vector3<f64>; 3] =
    [Vector3::new(0.31, 0.12, 0.0), Vector3::new(-0.13, 0.34, 0.02), Vector3::new(-0.22, -0.28, 0.04)];

/// Where an instrument stands, and how its reflector is mounted.
struct Instrument {
    instrument_from_base: Isometry3<f64>,
    flange_from_reflector: UnitQuaternion<f64>,
}

impl Instrument {
    fn draw(rng: &mut Rng) -> Self {
        let turn = Vector3::new(rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3), rng.uniform(-3.0, 3.0));
        let at_m = Vector3::new(rng.uniform(-3.0, 3.0), rng.uniform(-3.0, 3.0), rng.uniform(-1.0, 1.0));
        Self {
            instrument_from_base: Isometry3::new(at_m, turn),
            flange_from_reflector: UnitQuaternion::from_scaled_axis(Vector3::from(rng.normal3())),
        }
    }
}

impl RunRecord<'_> {
    /// The text of the file, in the order of the rows. Those past the recipe's number draw from `later`.
    pub(super) fn csv(&self, rng: &mut Rng, later: &mut Rng) -> String {
        let instrument = Instrument::draw(rng);
        let faults = FileFaults::of(self.effects, self.run.states.len());
        let seen =
            |k: usize| instrument.instrument_from_base * Point3::from(self.run.nominal_m[k] + self.off_m[k]);
        let points: Vec<Point3<f64>> = (0..self.run.states.len()).map(seen).collect();
        let mut out = self.header();
        for (k, pose) in (0..self.run.states.len()).zip(self.poses) {
            let rng = if k < self.recipe.n { &mut *rng } else { &mut *later };
            // writing to a String cannot fail
            let _ = write!(out, "{k},{}", faults.pose(*pose));
            out += &self.arm_cells(k, &faults);
            out += &faults.point_cells(k, faults.point_of(k).map(|row| &points[row]));
            out += &self.optional_cells(k, &instrument, &faults, rng);
            if self.with_nests {
                out += ",pose,";
            }
            out.push('\n');
            if self.with_nests && k >= self.recipe.n {
                self.push_nests(&mut out, k, &instrument, &faults, rng);
            }
        }
        self.recipe.gaps.as_ref().map_or_else(|| out.clone(), |gaps| gaps.made_in(&out))
    }

    /// The rows of the nests on the base while the arm stands as in row `k`.
    fn push_nests(
        &self,
        out: &mut String,
        k: usize,
        instrument: &Instrument,
        faults: &FileFaults,
        rng: &mut Rng,
    ) {
        let disturbance = self.run.disturbance(k, self.effects, self.background);
        for (nest, stands_m) in NESTS_M.into_iter().enumerate() {
            let noise_m = Vector3::from(rng.normal3()) * m_from_mm(self.recipe.sigma_mm);
            let seen_m = MeasuredRun::nest_m(stands_m, &disturbance) + noise_m;
            let point = instrument.instrument_from_base * Point3::from(seen_m);
            // writing to a String cannot fail
            let _ = write!(out, "{k}n{nest},{k}n{nest}");
            *out += &self.arm_cells(k, faults);
            *out += &faults.point_cells(k, Some(&point));
            *out += &self.optional_cells(k, instrument, faults, rng);
            let _ = writeln!(out, ",base,N{nest}");
        }
    }

    fn header(&self) -> String {
        let recorded = self.recipe.recorded;
        let joints = self.run.arm.joints();
        let mut names = vec!["id".to_owned(), "pose_id".to_owned()];
        if recorded.time {
            names.push("t_min".to_owned());
        }
        names.extend((0..joints).map(|j| {
            let unit = if self.run.arm.slides(j) { "mm" } else { "deg" };
            format!("q{}_{unit}", j + 1)
        }));
        names.extend(["x_mm", "y_mm", "z_mm"].map(str::to_owned));
        if recorded.orientation {
            names.extend(["qw", "qx", "qy", "qz"].map(str::to_owned));
        }
        if recorded.direction {
            names.extend((1..=joints).map(|joint| format!("dir{joint}")));
        }
        if recorded.payload {
            names.push("payload_kg".to_owned());
        }
        if recorded.temperature {
            names.extend((1..=joints).map(|joint| format!("temp_j{joint}_c")));
            names.push("temp_air_c".to_owned());
        }
        if self.with_nests {
            names.extend(["kind", "fixed_id"].map(str::to_owned));
        }
        names.join(",") + "\n"
    }

    /// The time and the joints of row `k`.
    fn arm_cells(&self, k: usize, faults: &FileFaults) -> String {
        let now = &self.run.states[k];
        let mut out = String::new();
        if self.recipe.recorded.time {
            let _ = write!(out, ",{:.2}", now.t_min);
        }
        for (j, q) in now.q_rad.into_iter().enumerate() {
            out.push(',');
            out += &faults.joint_cell(j, q, self.run.arm.slides(j));
        }
        out
    }

    /// What is recorded of row `k` beside joints and point.
    fn optional_cells(
        &self,
        k: usize,
        instrument: &Instrument,
        faults: &FileFaults,
        rng: &mut Rng,
    ) -> String {
        let recorded = self.recipe.recorded;
        let now = &self.run.states[k];
        let mut out = String::new();
        if recorded.orientation {
            // an orientation from three reflectors 0.1 m apart is as good as the points over that distance
            let blur = Vector3::from(rng.normal3()) * (m_from_mm(self.recipe.sigma_mm) / 0.1);
            let flange = self.run.flange(k, &self.run.disturbance(k, self.effects, self.background));
            let r = UnitQuaternion::from_scaled_axis(blur)
                * instrument.instrument_from_base.rotation
                * flange.rotation
                * instrument.flange_from_reflector;
            let _ = write!(out, ",{:.8},{:.8},{:.8},{:.8}", r.w, r.i, r.j, r.k);
        }
        if recorded.direction {
            for d in now.direction {
                let _ = write!(out, ",{d}");
            }
        }
        if recorded.payload {
            let _ = write!(out, ",{:.2}", faults.payload(now.payload_kg));
        }
        if recorded.temperature {
            for warmer in now.warmer_k.into_iter().chain([0.0]) {
                let read_c = COLD_C + warmer + THERMOMETER_K * rng.normal();
                let _ = write!(out, ",{:.2}", faults.temperature(read_c));
            }
        }
        out
    }
}
