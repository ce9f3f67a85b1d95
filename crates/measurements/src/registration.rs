//! Where the robot's base stands in the instrument's frame, the targets on the flange, fixed points in the base.

use super::{Reading, Station};
use nalgebra::{Isometry3, Point3, UnitQuaternion, Vector3};

/// Base and target, as fitted.
#[derive(Clone, Debug, PartialEq)]
pub struct Registration {
    /// The robot's base in the instrument's frame.
    pub instrument_from_base: Isometry3<f64>,
    /// Each target's place in the flange's frame.
    pub tools_m: Vec<Vector3<f64>>,
    /// Each fixed point in the base: nests, points touched, ends of wires.
    pub fixed_points_m: Vec<Vector3<f64>>,
    /// Standard deviation of the first target's place, metres: large where the poses do not tell it.
    pub tool_sigma_m: f64,
    /// The sensor's orientation on the flange, where orientation was measured.
    pub flange_from_sensor: Option<UnitQuaternion<f64>>,
    /// The middle distance left, metres: robust against false rows.
    pub median_m: f64,
    /// Whether the steps of the fit came to rest: the last one moved base, targets and fixed points by less than a micrometre and a microradian
    /// together. Of one that is assumed it says nothing.
    pub converged: bool,
}

impl Registration {
    /// One that is assumed, not fitted.
    #[must_use]
    pub fn assumed(
        instrument_from_base: Isometry3<f64>,
        tools_m: Vec<Vector3<f64>>,
        fixed_points_m: Vec<Vector3<f64>>,
    ) -> Self {
        Self {
            instrument_from_base,
            tools_m,
            fixed_points_m,
            tool_sigma_m: 0.0,
            flange_from_sensor: None,
            median_m: 0.0,
            converged: false,
        }
    }

    /// Measured minus predicted position in base axes, metres, for a flange pose `base_from_flange`; along the wire
    /// where a length was measured.
    #[must_use]
    pub fn residual_m(&self, station: &Station, base_from_flange: &Isometry3<f64>) -> Vector3<f64> {
        let predicted = self.predicted_m(station, base_from_flange);
        match station.reading {
            Reading::Point { position_m } | Reading::Nest { position_m, .. } => {
                self.instrument_from_base.inverse_transform_point(&position_m.into()).coords - predicted
            }
            Reading::Touch { fixed_point } => self.fixed_point_m(fixed_point) - predicted,
            Reading::Length { fixed_point, length_m } => {
                let away = predicted - self.fixed_point_m(fixed_point);
                self.along(station, base_from_flange).unwrap_or_default() * (length_m - away.norm())
            }
        }
    }

    /// [`residual_m`](Self::residual_m) and [`residual_rad`](Self::residual_rad) of a station, 0 where no orientation
    /// was measured.
    #[must_use]
    pub fn residual(&self, station: &Station, base_from_flange: &Isometry3<f64>) -> [f64; 6] {
        let fixed_point = self.residual_m(station, base_from_flange);
        let turn = self.residual_rad(station, base_from_flange).unwrap_or_default();
        [fixed_point.x, fixed_point.y, fixed_point.z, turn.x, turn.y, turn.z]
    }

    /// Where on the flange at pose `base_from_flange` the point of `station` was seen, metres; `None` where no point was.
    #[must_use]
    pub fn seen_on_flange_m(
        &self,
        station: &Station,
        base_from_flange: &Isometry3<f64>,
    ) -> Option<Vector3<f64>> {
        let seen_m = Point3::from(station.reading.position_m()?);
        let in_base_m = self.instrument_from_base.inverse_transform_point(&seen_m);
        Some(base_from_flange.inverse_transform_point(&in_base_m).coords)
    }

    /// Predicted position of the target in the base, metres; of a nest, whose "flange" is the base as it has moved.
    #[must_use]
    pub fn predicted_m(&self, station: &Station, base_from_flange: &Isometry3<f64>) -> Vector3<f64> {
        if let Reading::Nest { fixed_point, .. } = station.reading {
            return (base_from_flange * Point3::from(self.fixed_point_m(fixed_point))).coords;
        }
        let tool = self.tools_m.get(station.target).copied().unwrap_or_default();
        base_from_flange.translation.vector + base_from_flange.rotation * tool
    }

    /// Where a payload is taken to hang, flange frame, metres: amid the targets.
    #[must_use]
    pub fn payload_m(&self) -> Vector3<f64> {
        self.tools_m.iter().sum::<Vector3<f64>>() / self.tools_m.len().max(1) as f64
    }

    /// Where a length was measured: the direction from the fixed point to the target, base axes.
    #[must_use]
    pub fn along(&self, station: &Station, base_from_flange: &Isometry3<f64>) -> Option<Vector3<f64>> {
        let Reading::Length { fixed_point, .. } = station.reading else { return None };
        (self.predicted_m(station, base_from_flange) - self.fixed_point_m(fixed_point)).try_normalize(1e-9)
    }

    fn fixed_point_m(&self, fixed_point: usize) -> Vector3<f64> {
        self.fixed_points_m.get(fixed_point).copied().unwrap_or_default()
    }

    /// Measured against predicted orientation as a rotation vector in base axes, radians.
    #[must_use]
    pub fn residual_rad(&self, station: &Station, base_from_flange: &Isometry3<f64>) -> Option<Vector3<f64>> {
        let measured = self.instrument_from_base.rotation.inverse() * station.orientation?;
        let predicted = base_from_flange.rotation * self.flange_from_sensor?;
        Some((measured * predicted.inverse()).scaled_axis())
    }
}
