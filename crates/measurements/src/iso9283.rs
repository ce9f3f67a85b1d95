//! Pose accuracy, repeatability and drift after ISO 9283:1998, of one commanded pose attained again and again.
//!
//! AP_p with AP_x, AP_y, AP_z, and AP_a, AP_b, AP_c (7.2.1); RP_l with RP_a, RP_b, RP_c (7.2.2); vAP_p (7.2.3); dAP_p and dRP_l (7.6); symbols
//! as there.

use nalgebra::{UnitQuaternion, Vector3};

/// How far the mean of the attained poses is from the command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accuracy {
    /// AP_p, the distance of the barycentre from the command, metres.
    pub ap_m: f64,
    /// AP_x, AP_y, AP_z, metres.
    pub of_axes_m: [f64; 3],
}

/// How close the attained poses are to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Repeatability {
    /// Number of attained poses.
    pub n: usize,
    /// Mean distance from their barycentre, metres.
    pub mean_m: f64,
    /// S_l, the standard deviation of the distances, metres.
    pub s_m: f64,
    /// RP_l = mean + 3 S_l, metres.
    pub rp_m: f64,
}

/// The barycentre of attained points.
#[must_use]
pub fn barycentre_m(attained_m: &[Vector3<f64>]) -> Option<Vector3<f64>> {
    (!attained_m.is_empty()).then(|| attained_m.iter().sum::<Vector3<f64>>() / attained_m.len() as f64)
}

/// AP_p = sqrt((x - x_c)^2 + (y - y_c)^2 + (z - z_c)^2) of the barycentre x, y, z.
#[must_use]
pub fn accuracy(command_m: &Vector3<f64>, attained_m: &[Vector3<f64>]) -> Option<Accuracy> {
    let off = barycentre_m(attained_m)? - command_m;
    Some(Accuracy { ap_m: off.norm(), of_axes_m: off.into() })
}

/// RP_l = l + 3 S_l, with l_j the distances from the barycentre, l their mean and S_l their standard deviation (n - 1);
/// `None` of fewer than two.
#[must_use]
pub fn repeatability(attained_m: &[Vector3<f64>]) -> Option<Repeatability> {
    let n = attained_m.len();
    let middle = barycentre_m(attained_m).filter(|_| n >= 2)?;
    let distances: Vec<f64> = attained_m.iter().map(|p| (p - middle).norm()).collect();
    let mean_m = distances.iter().sum::<f64>() / n as f64;
    let squares: f64 = distances.iter().map(|l| (l - mean_m).powi(2)).sum();
    let s_m = (squares / (n - 1) as f64).sqrt();
    Some(Repeatability { n, mean_m, s_m, rp_m: mean_m + 3.0 * s_m })
}

/// How the attained orientations turn from the command, about the x, y, z of the frame in which both are given: the base's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrientationPerformance {
    /// AP_a, AP_b, AP_c: mean turns, radians.
    pub ap_rad: [f64; 3],
    /// RP_a, RP_b, RP_c: 3 S of each, radians; of two poses and more.
    pub rp_rad: Option<[f64; 3]>,
}

/// AP and RP of orientation. The turns are small, so that their rotation vector is the standard's three angles.
#[must_use]
pub fn orientation(
    command: &UnitQuaternion<f64>,
    attained: &[UnitQuaternion<f64>],
) -> Option<OrientationPerformance> {
    if attained.is_empty() {
        return None;
    }
    let n = attained.len() as f64;
    let turns: Vec<Vector3<f64>> = attained.iter().map(|a| (a * command.inverse()).scaled_axis()).collect();
    let mean = turns.iter().sum::<Vector3<f64>>() / n;
    let spread = (attained.len() >= 2).then(|| {
        let squares: Vector3<f64> = turns.iter().map(|t| (t - mean).component_mul(&(t - mean))).sum();
        (squares / (n - 1.0)).map(|v| 3.0 * v.sqrt()).into()
    });
    Some(OrientationPerformance { ap_rad: mean.into(), rp_rad: spread })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mm(points: &[[f64; 3]]) -> Vec<Vector3<f64>> {
        points.iter().map(|p| Vector3::from(*p) / 1e3).collect()
    }

    #[test]
    fn accuracy_and_repeatability_as_worked_by_hand() {
        // Barycentre (1, 2, 2) from the command at the origin: AP = sqrt(1 + 4 + 4) = 3.
        let attained =
            mm(&[[0.0, 2.0, 2.0], [2.0, 2.0, 2.0], [1.0, 1.0, 2.0], [1.0, 3.0, 2.0], [1.0, 2.0, 2.0]]);
        let ap = accuracy(&Vector3::zeros(), &attained).unwrap();
        assert!((ap.ap_m - 3e-3).abs() < 1e-15);
        assert!(ap.of_axes_m.iter().zip([1e-3, 2e-3, 2e-3]).all(|(a, b)| (a - b).abs() < 1e-15));
        // Distances 1, 1, 1, 1, 0: l = 0.8, S_l = sqrt((4 * 0.04 + 0.64) / 4) = sqrt(0.2), RP = 0.8 + 3 sqrt(0.2).
        let rp = repeatability(&attained).unwrap();
        assert!((rp.mean_m - 0.8e-3).abs() < 1e-15 && (rp.s_m - 0.2_f64.sqrt() * 1e-3).abs() < 1e-15);
        assert!((rp.rp_m - 2.141_640_786_499_874e-3).abs() < 1e-15, "{}", rp.rp_m);
        assert_eq!(repeatability(&attained[..1]), None);
    }

    #[test]
    fn turns_as_worked_by_hand() {
        // About the base's x by 1, 2, 3 mrad, whatever the command: mean 2, S = 1, RP = 3 mrad; nothing about y and z.
        let command = UnitQuaternion::from_euler_angles(0.3, 0.2, 0.1);
        let about_x = |rad: f64| UnitQuaternion::from_scaled_axis(Vector3::x() * rad) * command;
        let OrientationPerformance { ap_rad: mean, rp_rad: spread } =
            orientation(&command, &[about_x(1e-3), about_x(2e-3), about_x(3e-3)]).unwrap();
        assert!((mean[0] - 2e-3).abs() < 1e-12 && mean[1].abs() < 1e-12 && mean[2].abs() < 1e-12);
        let spread = spread.unwrap();
        assert!((spread[0] - 3e-3).abs() < 1e-12 && spread[1] < 1e-9, "{spread:?}");
    }
}
