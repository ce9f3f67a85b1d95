//! A diagnosis as pictures (SVG): residuals by joint angle, over time and in the workspace, before and after.
//! Computes nothing but where to draw.

use super::svg::{Panel, Picture};
use metrology::diagnose::{Findings, RowResidual};
use robot_model::robot::SerialArm;

/// More rows than this are thinned: a picture of them shows no more.
const MOST_ROWS: usize = 1500;
const BEFORE: &str = "#b8860b";
const AFTER: &str = "#1f5fa8";
/// Residual vectors are drawn so that the middle one before has this length, share of the picture's width.
const ARROW_SHARE: f64 = 0.04;

/// Each picture's file name and text. None where no residual is known.
#[must_use]
pub fn pictures(d: &Findings, arm: &SerialArm) -> Vec<(&'static str, String)> {
    let robot = arm.name.as_str();
    let step = d.residuals.len().div_ceil(MOST_ROWS).max(1);
    let rows: Vec<&RowResidual> = d.residuals.iter().filter(|r| !r.outlier).step_by(step).collect();
    if rows.is_empty() {
        return Vec::new();
    }
    vec![
        ("joints.svg", by_joint(&rows, arm)),
        ("time.svg", over_time(&rows, robot)),
        ("workspace.svg", in_workspace(&rows, robot)),
    ]
}

fn length(v: &[f64; 3]) -> f64 {
    (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]).sqrt()
}

fn largest(rows: &[&RowResidual]) -> f64 {
    rows.iter().map(|r| length(&r.before_mm).max(length(&r.after_mm))).fold(1e-6, f64::max)
}

fn legend(picture: &mut Picture, x: f64, y: f64) {
    picture.dot(x, y - 4.0, 4.0, BEFORE);
    picture.text(x + 10.0, y, 13.0, "start", "before: base and target fitted, nothing else");
    picture.dot(x + 320.0, y - 4.0, 4.0, AFTER);
    picture.text(x + 330.0, y, 13.0, "start", "after: with causes and geometry");
}

/// Distance from the model by one number of each row.
fn scatter(picture: &mut Picture, panel: &Panel, rows: &[&RowResidual], x: impl Fn(&RowResidual) -> f64) {
    for (colour, of) in [(BEFORE, 0), (AFTER, 1)] {
        for row in rows {
            let y = length(if of == 0 { &row.before_mm } else { &row.after_mm });
            let [px, py] = panel.at(x(row), y);
            picture.dot(px, py, 2.0, colour);
        }
    }
}

fn range(values: impl Iterator<Item = f64> + Clone) -> [f64; 2] {
    let low = values.clone().fold(f64::INFINITY, f64::min);
    let high = values.fold(f64::NEG_INFINITY, f64::max);
    let room = 0.03 * (high - low).max(1e-3);
    [low - room, high + room]
}

fn by_joint(rows: &[&RowResidual], arm: &SerialArm) -> String {
    let robot = &arm.name;
    let lines = arm.joints.len().div_ceil(3) as f64;
    let mut picture = Picture::new(
        1080.0,
        100.0 + 300.0 * lines,
        &format!("{robot}: distance from the model by joint angle"),
    );
    legend(&mut picture, 60.0, 58.0);
    let high = 1.05 * largest(rows);
    for (j, joint) in arm.joints.iter().enumerate() {
        let (column, line) = ((j % 3) as f64, (j / 3) as f64);
        let panel = Panel {
            left: 70.0 + 345.0 * column,
            top: 95.0 + 300.0 * line,
            width: 270.0,
            height: 225.0,
            x: range(rows.iter().map(|r| r.q_deg[j])),
            y: [0.0, high],
        };
        let of = if j % 3 == 0 { "distance, mm" } else { "" };
        let unit = if joint.kind.slides() { "mm" } else { "deg" };
        picture.axes(&panel, &format!("joint {}, {unit}", j + 1), of);
        scatter(&mut picture, &panel, rows, |r| r.q_deg[j]);
    }
    picture.finish()
}

fn over_time(rows: &[&RowResidual], robot: &str) -> String {
    let timed = rows.iter().all(|r| r.t_min.is_some());
    let title = if timed { "over time" } else { "in the order of the rows" };
    let mut picture = Picture::new(1080.0, 430.0, &format!("{robot}: distance from the model {title}"));
    legend(&mut picture, 60.0, 58.0);
    let x = |r: &RowResidual| r.t_min.filter(|_| timed).unwrap_or(r.line as f64);
    let panel = Panel {
        left: 70.0,
        top: 95.0,
        width: 970.0,
        height: 270.0,
        x: range(rows.iter().map(|r| x(r))),
        y: [0.0, 1.05 * largest(rows)],
    };
    picture.axes(&panel, if timed { "minutes" } else { "line of the file" }, "distance, mm");
    scatter(&mut picture, &panel, rows, x);
    picture.finish()
}

/// Residual vectors from above and from the side, before and after, enlarged alike.
fn in_workspace(rows: &[&RowResidual], robot: &str) -> String {
    let mut picture = Picture::new(1080.0, 1060.0, &format!("{robot}: residuals in the workspace"));
    legend(&mut picture, 60.0, 58.0);
    let mut lengths: Vec<f64> = rows.iter().map(|r| length(&r.before_mm)).collect();
    sorting::numbers(&mut lengths);
    let middle = lengths[lengths.len() / 2].max(1e-6);
    let spans: Vec<[f64; 2]> = (0..3).map(|k| range(rows.iter().map(|r| r.point_mm[k]))).collect();
    let span = spans.iter().map(|s| s[1] - s[0]).fold(0.0, f64::max);
    let enlarged = ARROW_SHARE * span / middle;
    let centred = |k: usize| {
        let middle = 0.5 * (spans[k][0] + spans[k][1]);
        [middle - 0.55 * span, middle + 0.55 * span]
    };
    picture.text(1030.0, 58.0, 13.0, "end", &format!("vectors enlarged {enlarged:.0} times"));
    for (line, (a, b, view)) in [(0, 1, "from above"), (0, 2, "from the side")].into_iter().enumerate() {
        for (column, colour) in [BEFORE, AFTER].into_iter().enumerate() {
            let panel = Panel {
                left: 80.0 + 510.0 * column as f64,
                top: 95.0 + 485.0 * line as f64,
                width: 420.0,
                height: 420.0,
                x: centred(a),
                y: centred(b),
            };
            let when = if column == 0 { "before" } else { "after" };
            let names = ["x", "y", "z"];
            picture.axes(
                &panel,
                &format!("{} of the base, mm ({view}, {when})", names[a]),
                &format!("{}, mm", names[b]),
            );
            for row in rows {
                let off = if column == 0 { &row.before_mm } else { &row.after_mm };
                let from = panel.at(row.point_mm[a], row.point_mm[b]);
                let to = panel.at(row.point_mm[a] + enlarged * off[a], row.point_mm[b] + enlarged * off[b]);
                picture.vector(from, to, colour);
            }
        }
    }
    picture.finish()
}
