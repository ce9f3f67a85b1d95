//! Joints that give under gravity, as RAPID: weighted mass moments from the tool inward, the upward direction outward.
//!
//! A joint's turn is `c T + sum_k c_k T_k` with `T` its torque, `T_k` the part of link k (`deform::gravity`). Both are linear
//! in the masses, so one weight for each link, `m_k (c + c_k)`, gives the whole in one sum.

use super::deformation::LiveModel;
use super::frames::rows;
use super::text::{Body, Summand, Triple, num, sum};
use nalgebra::Vector3;
use robot_model::deform::gravity::GRAVITY_M_S2;
use robot_model::units::{m_from_mm, mm_from_m};

/// Tool loads from here on count, kg: a tool of a gram, as tool0, is none.
const NO_LOAD_KG: f64 = 0.001_001;

/// Joints whose links have the same shares: one sum serves them all.
struct Group {
    /// For each link, and the payload.
    shares: [f64; 7],
    joints: Vec<(usize, f64)>,
}

fn groups(model: &LiveModel) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    for (j, own) in model.compliance.iter().enumerate() {
        let Some(own) = own else { continue };
        let scale = own.scale();
        if scale == 0.0 {
            continue;
        }
        let shares = own.shares(scale);
        let same = |g: &&mut Group| g.shares.iter().zip(&shares).all(|(a, b)| (a - b).abs() < 1e-9);
        match groups.iter_mut().find(same) {
            Some(group) => group.joints.push((j, scale)),
            None => groups.push(Group { shares, joints: vec![(j, scale)] }),
        }
    }
    groups
}

/// Statements that set `tcT1` to `tcT6` of the joints that give, from the sines and cosines `tcS1`, `tcC1` ...
pub(super) fn body(model: &LiveModel, body: &mut Body) {
    let groups = groups(model);
    if groups.is_empty() {
        return;
    }
    body.line("! Upward, seen from the joints that give");
    let mut up = Triple::zero("tcU");
    body.increase(&mut up, 2, &[(1.0, String::new())]);
    let last = groups.iter().flat_map(|g| &g.joints).map(|(j, _)| *j).max().unwrap_or(0);
    for (i, step) in model.steps.iter().enumerate().take(last + 1) {
        body.rotate(&mut up, &rows(&step.rotation.transpose()));
        if let Some((axis, sign)) = step.axis {
            body.turn(&mut up, axis, -sign, [&sine(i), &cosine(i)]);
            if groups.iter().flat_map(|g| &g.joints).any(|(j, _)| *j == i) {
                for (k, stem) in [((axis + 1) % 3, "tcV"), ((axis + 2) % 3, "tcW")] {
                    body.line(format!("{stem}{}:={};", i + 1, up.get(k).unwrap_or("0")));
                }
            }
        }
    }
    for group in &groups {
        sums(model, group, body);
    }
}

/// One group: mass moments in kg mm from the tool inward.
fn sums(model: &LiveModel, group: &Group, body: &mut Body) {
    body.line("! Masses beyond a joint times their places, kg mm, from the tool inward");
    let links = model.links();
    let flange = &model.steps[6];
    let first = group.joints.iter().map(|(j, _)| *j).min().unwrap_or(0);
    let mut moment = Triple::zero("tcM");
    // The load of the tool: its centre is given in the flange's frame.
    let places = mm(&flange.place_m);
    body.line("tcL:=0;");
    body.line(format!("IF tcTool.tload.mass>{NO_LOAD_KG} tcL:={}*tcTool.tload.mass;", num(group.shares[6])));
    let rotation = flange.rotation;
    for k in 0..3 {
        let cog = (0..3).map(|j| (rotation[(k, j)], format!("tcL*tcTool.tload.cog.{}", ["x", "y", "z"][j])));
        let mut summands: Vec<Summand> = cog.collect();
        summands.push((places[k], "tcL".to_owned()));
        body.increase(&mut moment, k, &summands);
    }
    let mut mass_kg = 0.0;
    for i in (first..6).rev() {
        let step = &model.steps[i];
        let weight = links[i].0 * group.shares[i];
        let com = mm(&links[i].1);
        for (k, com_mm) in com.into_iter().enumerate() {
            body.increase(&mut moment, k, &[(weight * com_mm, String::new())]);
        }
        mass_kg += weight;
        let Some((axis, sign)) = step.axis else { continue };
        if let Some((_, scale)) = group.joints.iter().find(|(j, _)| *j == i) {
            let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
            let by = -sign * m_from_mm(scale * GRAVITY_M_S2);
            let inner = [
                moment.get(b).map(|m| (1.0, format!("{m}*tcW{}", i + 1))),
                moment.get(c).map(|m| (-1.0, format!("{m}*tcV{}", i + 1))),
            ];
            let inner: Vec<Summand> = inner.into_iter().flatten().collect();
            let inner = sum(&inner);
            let inner = if inner.is_empty() { "0" } else { &inner };
            // Millionths: what is smaller would be written as nothing.
            body.line(format!("tcT{}:={}*({inner})/1000000;", i + 1, num(by * 1e6)));
        }
        if i == first {
            break;
        }
        body.turn(&mut moment, axis, sign, [&sine(i), &cosine(i)]);
        body.rotate(&mut moment, &rows(&step.rotation));
        let place = mm(&step.place_m);
        for (k, place_mm) in place.into_iter().enumerate() {
            let summands = [(mass_kg * place_mm, String::new()), (place_mm, "tcL".to_owned())];
            body.increase(&mut moment, k, &summands);
        }
    }
}

fn mm(place_m: &Vector3<f64>) -> [f64; 3] {
    [place_m.x, place_m.y, place_m.z].map(mm_from_m)
}

/// Name of a joint's sine.
pub(super) fn sine(i: usize) -> String {
    format!("tcS{}", i + 1)
}

/// Name of a joint's cosine.
pub(super) fn cosine(i: usize) -> String {
    format!("tcC{}", i + 1)
}

/// Whether joint `j` gives.
pub(super) fn gives(model: &LiveModel, j: usize) -> bool {
    model.compliance[j].is_some_and(|own| own.scale() != 0.0)
}
