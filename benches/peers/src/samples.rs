//! Joints at which kinematics are compared: all over the ranges, at their limits, and near each of the three singularities.

use robot_model::kinematics::ClosedForm;
use robot_model::robot::Robot;
use std::f64::consts::PI;

/// Lengths of the ortho-parallel basis (Brandstötter, Angerer, Hofbaur 2014), metres, as another than driftpost says them.
#[derive(Clone, Copy)]
pub struct Lengths {
    pub a1: f64,
    pub a2: f64,
    pub b: f64,
    pub c1: f64,
    pub c2: f64,
    pub c3: f64,
    pub c4: f64,
}

impl Lengths {
    /// Of a built-in robot, from the tables that the tests and `differential.py` read too: RobotComponents' lengths, or else those of
    /// the first table of Denavit and Hartenberg's numbers, or GoFa's, without the offset of its wrist.
    pub fn of(name: &str) -> Option<Self> {
        let in_basis = include_str!("../../../fixtures/oracle/robotcomponents.csv");
        let denavit_hartenberg = include_str!("../../../fixtures/oracle/denavit_hartenberg.csv");
        let offset_wrist = include_str!("../../../fixtures/oracle/robotcomponents_offset_wrist.csv");
        if let Some([a1, a2, b, c1, c2, c3, c4]) = row_m(in_basis, name) {
            return Some(Self { a1, a2, b, c1, c2, c3, c4 });
        }
        if let Some([d1, a1, a2, a3, d4, d6]) = row_m(denavit_hartenberg, name) {
            return Some(Self { a1, a2: -a3, b: 0.0, c1: d1, c2: a2, c3: d4, c4: d6 });
        }
        let [a1, a2, _a3, b, c1, c2, c3, c4] = row_m(offset_wrist, name)?;
        Some(Self { a1, a2, b, c1, c2, c3, c4 })
    }
}

/// The lengths in a robot's first row, metres.
fn row_m<const N: usize>(table: &str, name: &str) -> Option<[f64; N]> {
    let row = table.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(','))?;
    let mm: Vec<f64> = row.split(',').filter_map(|field| field.parse().ok()).collect();
    <[f64; N]>::try_from(mm).ok().map(|lengths| lengths.map(|mm| mm / 1000.0))
}

/// Numbers in 0..1, the same on every machine (xorshift, Marsaglia 2003).
pub struct Random(pub u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Of either sign, its size between 1e-9 and 1e-2, all orders of magnitude alike.
    fn small(&mut self) -> f64 {
        let size = 10f64.powf(-9.0 + 7.0 * self.next());
        if self.next() < 0.5 { -size } else { size }
    }
}

/// `count` joints within the ranges of `robot`, radians: of each ten five anywhere, two with a joint on or within 0.01 rad of its limit, and
/// one each with joint 5 near zero, the arm near stretched or folded, and the wrist centre near axis 1.
pub fn samples(robot: &Robot, lengths: Lengths, count: usize) -> impl Iterator<Item = [f64; 6]> {
    let ranges = robot.joints.each_ref().map(|joint| joint.range_rad.unwrap_or([-PI, PI]));
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    // The forearm's line and length from axis 3 to the wrist centre, the arm drawn with joints 2 and 3 at zero.
    let (forearm_m, forearm_rad) = (lengths.c3.hypot(lengths.a2), (-lengths.a2).atan2(lengths.c3));
    (0..count).map(move |k| {
        let mut q_rad: [f64; 6] =
            std::array::from_fn(|i| ranges[i][0] + (ranges[i][1] - ranges[i][0]) * random.next());
        match k % 10 {
            5 | 6 => {
                let (joint, end) = ((6.0 * random.next()) as usize, usize::from(random.next() < 0.5));
                let inwards = if random.next() < 0.2 { 0.0 } else { random.small().abs() };
                q_rad[joint] = ranges[joint][end] + if end == 0 { inwards } else { -inwards };
            }
            7 => q_rad[4] = random.small(),
            8 => {
                // Forearm in line with the lower arm, which stands upright at joint 2 = 0: stretched, or folded half a turn further.
                let stretched = forearm_rad - PI / 2.0;
                let folded = stretched - PI * (stretched + PI).signum();
                let within = |q: f64| ranges[2][0] < q && q < ranges[2][1];
                q_rad[2] =
                    if within(folded) && random.next() < 0.5 { folded } else { stretched } + random.small();
            }
            9 => {
                // a1 + c2 sin(q2) + forearm cos(q2 + q3 - forearm_rad) = 0, solved for joint 2.
                let turn = q_rad[2] - forearm_rad;
                let (s, c) = (lengths.c2 - forearm_m * turn.sin(), forearm_m * turn.cos());
                let (size, phase) = (s.hypot(c), c.atan2(s));
                if size > lengths.a1 {
                    let turned = (-lengths.a1 / size).asin();
                    let other = if random.next() < 0.5 { turned } else { PI - turned };
                    let at = other - phase;
                    let at = at - 2.0 * PI * (at / (2.0 * PI)).round();
                    q_rad[1] = at + random.small();
                }
            }
            _ => {}
        }
        q_rad
    })
}

/// Whether each branch is well apart from its neighbours here: 1 mm from axis 1, 1e-3 rad at elbow and wrist.
pub fn is_regular(closed: &ClosedForm, q_rad: &[f64; 6]) -> bool {
    let posture = closed.posture(q_rad);
    posture.shoulder_m.abs() > 1e-3 && posture.elbow_rad.abs() > 1e-3 && posture.wrist_rad.abs() > 1e-3
}
