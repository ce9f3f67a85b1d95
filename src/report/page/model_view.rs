//! How table and identified model deform the arm at each target, for the page to draw: what differs nowhere stands once.

use super::embed::Decimals;
use rapid_compensation::compensate::{DriftPoint, TcpDrift};
use robot_model::deform::ArmDeviation;
use robot_model::units::{deg_from_rad, mm_from_m};
use serde::Serialize;

/// Turns of the six joints, then dx, dy, dz, rx, ry, rz of their frames and of the flange.
const VALUES: usize = 6 + 7 * 6;
/// Of more numbers than this a page would be slow to open: the arm is then drawn as the table alone deforms it.
const MOST_NUMBERS: usize = 800_000;

/// The deformation of the arm at minute `t[i]` of the course, mm and degrees: each of its values is the sum over the nodes k of
/// `shares[k][i]` times what it is at k.
#[derive(Serialize)]
pub(super) struct ModelView {
    /// Node by node the values that are the same at every target; 0 for the others.
    common: Vec<Decimals<9>>,
    /// Values that differ between targets and are the same at every node.
    still: Columns,
    /// Values that differ between targets and between nodes.
    moving: Columns,
}

/// Some of the values: which, and the numbers; target by target, node by node (once, where nodes do not differ), column by column.
#[derive(Serialize)]
struct Columns {
    columns: Vec<usize>,
    values: Decimals<7>,
}

impl ModelView {
    /// `None` without a model, and where there would be too many numbers.
    pub(super) fn new(drift: &TcpDrift, points: &[&DriftPoint]) -> Option<Self> {
        let first = values_at(drift, points.first().filter(|_| drift.has_model)?);
        let (mut differs, mut moves) = ([false; VALUES], [false; VALUES]);
        for point in points {
            let nodes = values_at(drift, point);
            for (values, of_first) in nodes.iter().zip(&first) {
                for i in 0..VALUES {
                    differs[i] |= values[i] != of_first[i];
                    moves[i] |= values[i] != nodes[0][i];
                }
            }
        }
        let columns = |wanted: &dyn Fn(usize) -> bool| (0..VALUES).filter(|&i| wanted(i)).collect::<Vec<_>>();
        let mut still = Columns::of(columns(&|i| differs[i] && !moves[i]));
        let mut moving = Columns::of(columns(&|i| differs[i] && moves[i]));
        let each = still.columns.len() + moving.columns.len() * first.len();
        if points.len() * each > MOST_NUMBERS {
            return None;
        }
        for point in points {
            let nodes = values_at(drift, point);
            still.extend(&nodes[..1]);
            moving.extend(&nodes);
        }
        let shared = |values: &[f64; VALUES]| {
            Decimals((0..VALUES).map(|i| if differs[i] { 0.0 } else { values[i] }).collect())
        };
        Some(Self { common: first.iter().map(shared).collect(), still, moving })
    }
}

impl Columns {
    fn of(columns: Vec<usize>) -> Self {
        Self { columns, values: Decimals(Vec::new()) }
    }

    fn extend(&mut self, nodes: &[[f64; VALUES]]) {
        let Self { columns, values } = self;
        values.0.extend(nodes.iter().flat_map(|all| columns.iter().map(|&i| all[i])));
    }
}

/// Node by node the values at a target, mm and degrees.
fn values_at(drift: &TcpDrift, point: &DriftPoint) -> Vec<[f64; VALUES]> {
    let of = |ArmDeviation { turns_rad, offsets }: &ArmDeviation| {
        std::array::from_fn(|i| match i.checked_sub(6) {
            None => deg_from_rad(turns_rad[i]),
            Some(i) if i % 6 < 3 => mm_from_m(offsets.0[i / 6][i % 6]),
            Some(i) => deg_from_rad(offsets.0[i / 6][i % 6]),
        })
    };
    drift.deviations(point).iter().map(of).collect()
}
