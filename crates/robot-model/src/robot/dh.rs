//! An arm from a table of Denavit-Hartenberg parameters, in either of the two conventions that textbooks and data sheets use.
//!
//! Denavit and Hartenberg 1955 (as in Paul 1981): `A_i = Rot_z(theta_i) Trans_z(d_i) Trans_x(a_i) Rot_x(alpha_i)`, a row's joint moves
//! about the z of the frame before it. Craig 1986 ("modified"): `A_i = Rot_x(alpha_i-1) Trans_x(a_i-1) Rot_z(theta_i) Trans_z(d_i)`, a
//! row's joint moves about the z of its own frame. The same numbers under the other convention are another arm.

mod table;

use super::refused::unless_coupled;
use super::size::beyond_any_arm;
use super::{FEWEST_JOINTS, Joint, JointKind, MOST_JOINTS, RobotError, SerialArm};
use nalgebra::{Isometry3, Translation3, UnitQuaternion, Vector3};

/// Which product of turns and shifts a row of the table stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DhConvention {
    /// Denavit and Hartenberg 1955, Paul 1981: the joint first, then the link.
    Standard,
    /// Craig 1986, "modified": the link before, then the joint.
    Modified,
}

impl SerialArm {
    /// Reads a table (CSV) of Denavit-Hartenberg parameters, a row a joint from the base outward.
    ///
    /// Columns by name: `a_mm` (or `a_m`), `alpha_deg` (`alpha_rad`), `d_mm` (`d_m`), `theta_deg` (`theta_rad`): the constants, of the
    /// joint's own coordinate what is added to it. Optional: `type` (`revolute`, `prismatic`, or `fixed` for a row that does not move:
    /// a base's or a flange's), `sign` (-1 where the joint counts the other way round) and its range `min`, `max` in degrees, mm
    /// where it slides. Lines that begin with `#` are comments. `name` is what the arm is called.
    ///
    /// # Errors
    /// [`RobotError::DhTable`] with the line: a column that is unknown or missing, a cell that is no number, a range that is
    /// reversed, fewer than four or more than seven joints.
    pub fn from_dh(bytes: &[u8], convention: DhConvention, name: &str) -> Result<Self, RobotError> {
        let mut carried = Isometry3::identity();
        let mut joints = Vec::new();
        for row in table::rows(bytes)? {
            let (before, after) = row.parts(convention);
            match row.kind {
                None => carried *= before * after,
                Some(kind) => {
                    joints.push(Joint {
                        previous_from_joint: carried * before,
                        axis: if row.counts_backwards { -Vector3::z_axis() } else { Vector3::z_axis() },
                        kind,
                        range_rad: row.range_rad,
                    });
                    carried = after;
                }
            }
        }
        if !(FEWEST_JOINTS..=MOST_JOINTS).contains(&joints.len()) {
            let problem =
                format!("there are {} joints; give four to seven, from the base outward", joints.len());
            return Err(RobotError::DhTable { line: 1, problem });
        }
        let words = match convention {
            DhConvention::Standard => "Denavit-Hartenberg parameters (Denavit and Hartenberg 1955)",
            DhConvention::Modified => "modified Denavit-Hartenberg parameters (Craig 1986)",
        };
        let arm = Self {
            name: name.to_owned(),
            source: words.to_owned(),
            joints,
            last_from_flange: carried,
            links: None,
        };
        match beyond_any_arm(&arm) {
            None => unless_coupled(arm),
            Some(problem) => Err(RobotError::DhTable {
                line: 1,
                problem: format!("{problem}; give the lengths in millimetres"),
            }),
        }
    }
}

/// The Denavit-Hartenberg parameters of one joint, SI.
struct DhRow {
    a_m: f64,
    alpha_rad: f64,
    d_m: f64,
    theta_rad: f64,
    /// `None`: it does not move.
    kind: Option<JointKind>,
    counts_backwards: bool,
    range_rad: Option<[f64; 2]>,
}

impl DhRow {
    /// What stands before the joint's motion and what behind it: about z the constants and the motion commute.
    fn parts(&self, convention: DhConvention) -> (Isometry3<f64>, Isometry3<f64>) {
        let along = |axis: Vector3<f64>, shift_m: f64, turn_rad: f64| {
            Isometry3::from_parts(
                Translation3::from(axis * shift_m),
                UnitQuaternion::from_scaled_axis(axis * turn_rad),
            )
        };
        let link = along(Vector3::x(), self.a_m, self.alpha_rad);
        let joint = along(Vector3::z(), self.d_m, self.theta_rad);
        match convention {
            DhConvention::Standard => (Isometry3::identity(), joint * link),
            DhConvention::Modified => (link * joint, Isometry3::identity()),
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::kinematics::SerialChain;
    use crate::robot::Robot;
    use nalgebra::Matrix4;

    /// Denavit and Hartenberg's matrix, element by element as Paul (1981, eq. 2.32) prints it: mm, rad.
    fn paul([a, alpha, d, theta]: [f64; 4]) -> Matrix4<f64> {
        let ((st, ct), (sa, ca)) = (theta.sin_cos(), alpha.sin_cos());
        #[rustfmt::skip]
        let m = Matrix4::new(
            ct, -st * ca,  st * sa, a * ct,
            st,  ct * ca, -ct * sa, a * st,
            0.0,      sa,       ca,      d,
            0.0,     0.0,      0.0,    1.0,
        );
        m
    }

    /// Craig's matrix (Introduction to Robotics, 1986, eq. 3.6), element by element: a, alpha, d, theta in radians and one unit of length.
    pub(crate) fn craig([a, alpha, d, theta]: [f64; 4]) -> Matrix4<f64> {
        let ((st, ct), (sa, ca)) = (theta.sin_cos(), alpha.sin_cos());
        #[rustfmt::skip]
        let m = Matrix4::new(
            ct,           -st, 0.0,       a,
            st * ca,  ct * ca, -sa, -sa * d,
            st * sa,  ct * sa,  ca,  ca * d,
            0.0,          0.0, 0.0,     1.0,
        );
        m
    }

    /// A row as the matrices take it, and how its joint moves: nothing, a turn or a slide with its sign.
    type Written = ([f64; 4], Option<(bool, f64)>);

    fn by_matrices(matrix: fn([f64; 4]) -> Matrix4<f64>, rows: &[Written], q: &[f64]) -> Matrix4<f64> {
        let mut q = q.iter();
        rows.iter().fold(Matrix4::identity(), |all, ([a, alpha_deg, d, theta_deg], moves)| {
            let by = moves.map(|(slides, sign)| (slides, sign * q.next().unwrap()));
            let (d, theta) = match by {
                Some((true, mm)) => (d + mm, theta_deg.to_radians()),
                Some((false, deg)) => (*d, (theta_deg + deg).to_radians()),
                None => (*d, theta_deg.to_radians()),
            };
            all * matrix([*a, alpha_deg.to_radians(), d, theta])
        })
    }

    fn table(rows: &[Written]) -> String {
        let mut text = "a_mm,alpha_deg,d_mm,theta_deg,type,sign\n".to_owned();
        for ([a, alpha, d, theta], moves) in rows {
            let (kind, sign) = match moves {
                None => ("fixed", 1.0),
                Some((true, sign)) => ("prismatic", *sign),
                Some((false, sign)) => ("revolute", *sign),
            };
            text += &format!("{a},{alpha},{d},{theta},{kind},{sign}\n");
        }
        text
    }

    /// How far the arm's flange is from the matrices', mm, and how far its axes.
    fn apart(arm: &SerialArm, q: &[f64], meant: &Matrix4<f64>) -> [f64; 2] {
        let si: Vec<f64> = arm
            .joints
            .iter()
            .zip(q)
            .map(|(joint, &q)| if joint.kind.slides() { q / 1000.0 } else { q.to_radians() })
            .collect();
        let got = SerialChain::nominal(arm).forward(&si).to_homogeneous();
        let shift = (0..3).map(|r| (got[(r, 3)] * 1000.0 - meant[(r, 3)]).abs()).fold(0.0, f64::max);
        let turn = (0..3).flat_map(|r| (0..3).map(move |c| (r, c))).map(|at| (got[at] - meant[at]).abs());
        [shift, turn.fold(0.0, f64::max)]
    }

    const TURNS: Option<(bool, f64)> = Some((false, 1.0));
    const SLIDES: Option<(bool, f64)> = Some((true, 1.0));

    /// The Stanford arm by Paul's convention, with a hand of 263 mm; its third joint slides.
    const STANFORD: [Written; 6] = [
        ([0.0, -90.0, 0.0, 0.0], TURNS),
        ([0.0, 90.0, 154.0, 0.0], TURNS),
        ([0.0, 0.0, 0.0, 0.0], SLIDES),
        ([0.0, -90.0, 0.0, 0.0], TURNS),
        ([0.0, 90.0, 0.0, 0.0], TURNS),
        ([0.0, 0.0, 263.0, 0.0], TURNS),
    ];
    /// A PUMA 560 by Craig's, a2 = 431.8, a3 = 20.3, d3 = 124.5, d4 = 433.1 mm, with a flange turned by 30 degrees behind it.
    const PUMA: [Written; 7] = [
        ([0.0, 0.0, 0.0, 0.0], TURNS),
        ([0.0, -90.0, 0.0, 0.0], TURNS),
        ([431.8, 0.0, 124.5, 0.0], TURNS),
        ([20.3, -90.0, 433.1, 0.0], TURNS),
        ([0.0, 90.0, 0.0, 0.0], TURNS),
        ([0.0, -90.0, 0.0, 0.0], TURNS),
        ([0.0, 0.0, 56.5, 30.0], None),
    ];

    fn poses() -> impl Iterator<Item = [f64; 7]> {
        (0..25).map(|k| {
            let angle = |j: usize| 37.0 * ((k * 7 + j * 3 + 1) as f64).sin() * (1.0 + j as f64 * 0.5);
            std::array::from_fn(angle)
        })
    }

    #[test]
    fn both_conventions_are_their_textbooks_matrices() {
        let odd = [
            ([0.0, 0.0, 310.0, 12.0], None),
            ([70.0, -90.0, 42.0, 0.0], Some((false, -1.0))),
            ([360.0, 17.0, -8.0, -90.0], TURNS),
            ([11.0, 80.0, 120.0, 33.0], Some((true, -1.0))),
            ([5.0, -45.0, 60.0, 180.0], TURNS),
            ([1.0, 2.0, 3.0, 4.0], None),
        ];
        for rows in [&STANFORD[..], &PUMA[..], &odd[..]] {
            for (convention, matrix) in
                [(DhConvention::Standard, paul as fn([f64; 4]) -> _), (DhConvention::Modified, craig)]
            {
                let arm = SerialArm::from_dh(table(rows).as_bytes(), convention, "arm").unwrap();
                for q in poses() {
                    let [shift, turn] = apart(&arm, &q, &by_matrices(matrix, rows, &q));
                    assert!(shift < 1e-9 && turn < 1e-12, "{convention:?}: {shift} mm, {turn}");
                }
            }
        }
    }

    /// Of the same table the two conventions are two arms.
    #[test]
    fn the_other_convention_is_another_arm() {
        let q = [10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 0.0];
        let arm = SerialArm::from_dh(table(&PUMA).as_bytes(), DhConvention::Standard, "arm").unwrap();
        assert!(apart(&arm, &q, &by_matrices(craig, &PUMA, &q))[0] > 100.0);
    }

    #[test]
    fn a_published_table_of_the_irb_140_is_the_built_in_one() {
        let text = include_str!("../../../../fixtures/robots/irb140_dh.csv");
        let arm = SerialArm::from_dh(text.as_bytes(), DhConvention::Standard, "IRB 140").unwrap();
        let built_in = Robot::built_in("irb140").unwrap();
        let meant = SerialChain::nominal(&SerialArm::from(&built_in));
        for q in poses() {
            let si: Vec<f64> = q[..6].iter().map(|q| q.to_radians()).collect();
            let mut meant_mm = meant.forward(&si).to_homogeneous();
            (0..3).for_each(|r| meant_mm[(r, 3)] *= 1000.0);
            let [shift, turn] = apart(&arm, &q[..6], &meant_mm);
            assert!(shift < 1e-9 && turn < 1e-12, "{shift} mm, {turn}");
        }
        let ranges = |joints: &[Joint]| joints.iter().map(|joint| joint.range_rad).collect::<Vec<_>>();
        assert_eq!(ranges(&arm.joints), ranges(&built_in.joints));
    }

    #[test]
    fn the_pandas_published_table_is_its_robot_file() {
        let table = include_bytes!("../../../../fixtures/robots/panda_mdh.csv");
        let arm = SerialArm::from_dh(table, DhConvention::Modified, "Panda").unwrap();
        let file = include_str!("../../../../fixtures/robots/seven_axes.toml");
        let [arm, file] = [&arm, &SerialArm::from_toml(file).unwrap()].map(SerialChain::nominal);
        for q in poses() {
            let q = q.map(f64::to_radians);
            let (a, b) = (arm.forward(&q), file.forward(&q));
            let shift_m = (a.translation.vector - b.translation.vector).norm();
            assert!(shift_m < 1e-12 && a.rotation.angle_to(&b.rotation) < 1e-7, "{shift_m} m");
        }
    }

    #[test]
    fn units_stand_in_the_headings() {
        let mm = "a_mm,alpha_deg,d_mm,theta_deg\n70,-90,352,0\n360,0,0,-90\n0,-90,0,0\n0,90,380,0\n";
        let m = "a_m,alpha_rad,d_m,theta_rad\n0.07,-1.5707963267948966,0.352,0\n0.36,0,0,-1.5707963267948966\n\
                 0,-1.5707963267948966,0,0\n0,1.5707963267948966,0.38,0\n";
        let [a, b] =
            [mm, m].map(|text| SerialArm::from_dh(text.as_bytes(), DhConvention::Standard, "x").unwrap());
        for q in poses() {
            let q: Vec<f64> = q[..4].iter().map(|q| q.to_radians()).collect();
            let [a, b] = [&a, &b].map(|arm| SerialChain::nominal(arm).forward(&q).translation.vector);
            assert!((a - b).norm() < 1e-15);
        }
    }

    #[test]
    fn what_is_no_table_is_refused_with_its_line() {
        let four = "a_mm,alpha_deg,d_mm,theta_deg\n0,0,1,0\n0,0,1,0\n# note\n0,0,1,0\n";
        for (text, line, error_text) in [
            (format!("{four}0,x,1,0\n"), 6, "alpha_deg `x` is no number"),
            (format!("{four}0,,1,0\n"), 6, "alpha_deg is empty"),
            (format!("{four}0,NaN,1,0\n"), 6, "is no number"),
            (four.to_owned(), 1, "there are 3 joints"),
            (format!("{four}0,0\n"), 6, "2 cells"),
            (four.replace("d_mm", "d"), 1, "column `d` is unknown"),
            (four.replace("d_mm,", "").replace("0,0,1,0", "0,0,0"), 1, "column `d_mm` is missing"),
            (four.replace("theta_deg", "d_m"), 1, "not both"),
            ("a_mm,alpha_deg,d_mm,theta_deg,type\n0,0,1,0,belt\n".to_owned(), 2, "type `belt`"),
            ("a_mm,alpha_deg,d_mm,theta_deg,sign\n0,0,1,0,2\n".to_owned(), 2, "sign 2"),
            ("a_mm,alpha_deg,d_mm,theta_deg,min,max\n0,0,1,0,9,-9\n".to_owned(), 2, "empty or reversed"),
            ("a_mm,alpha_deg,d_mm,theta_deg,min,max\n0,0,1,0,9,\n".to_owned(), 2, "both ends"),
            ("a_mm,alpha_deg,d_mm,theta_deg,min,max\n0,0,1,0,-9,10801\n".to_owned(), 2, "10800 degrees"),
            (String::new(), 1, "is missing"),
        ] {
            let error = SerialArm::from_dh(text.as_bytes(), DhConvention::Modified, "x").unwrap_err();
            let RobotError::DhTable { line: at, problem } = &error else { panic!("{error}") };
            assert!(*at == line && problem.contains(error_text), "{text:?}: {error}");
        }
    }
}
