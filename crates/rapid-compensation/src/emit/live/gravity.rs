//! Joints that give under gravity, as RAPID: places and axes as the base sees them, torques from the tool inward.
//!
//! A joint's turn is `c T + sum_k c_k T_k` with `T` its torque, `T_k` the part of link k (`deform::gravity`). Both are linear in the
//! masses, so one weight for each link, `m_k (c + c_k)`, gives the whole in one sum. Gravity has no part along z: of places p, the
//! joint's origin o and its axis a the base's x and y are enough, `T = -g sum m (a_x (p - o)_y - a_y (p - o)_x)`. They do not hang
//! on the weights, so joints that give in other ways cost a sum more each, not a walk through the arm.

use super::deformation::LiveModel;
use super::frames::{FixedFrame, rows};
use super::text::{Body, Summand, Triple, is_nothing};
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
    for (j, own) in model.compliance.iter().enumerate().filter(|(j, _)| gives(model, *j)) {
        let Some(own) = own else { continue };
        let scale = own.scale();
        let shares = own.shares(scale);
        let same = |g: &&mut Group| g.shares.iter().zip(&shares).all(|(a, b)| (a - b).abs() < 1e-9);
        match groups.iter_mut().find(same) {
            Some(group) => group.joints.push((j, scale)),
            None => groups.push(Group { shares, joints: vec![(j, scale)] }),
        }
    }
    groups
}

/// A direction, or a place, as the base's x or y sees it: which of the two, and the stem of its names.
const SEEN: [(usize, &str); 2] = [(0, "x"), (1, "y")];

/// Statements that set `tcT1` to `tcT6` of the joints that give, from the sines and cosines `tcS1`, `tcC1` ...
pub(super) fn body(model: &LiveModel, body: &mut Body) {
    let groups = groups(model);
    let Some(first) = groups.iter().flat_map(|g| &g.joints).map(|(j, _)| *j).min() else { return };
    let links = model.links();
    let weight = |group: &Group, i: usize| links[i].0 * group.shares[i];
    let counts = |i: usize| i >= first && groups.iter().any(|group| !is_nothing(weight(group, i)));
    let turns = |i: usize| groups.iter().flat_map(|g| &g.joints).any(|(j, _)| *j == i);
    body.line("! Places, mm, and axes of the joints that give, as x and y of the base see them");
    let mut reached = ReachedFrame::base(model, body);
    // Joints whose axis is upright wherever the arm stands: gravity does not turn them.
    let mut upright = [false; 6];
    for (i, step) in model.steps.iter().enumerate() {
        reached.step(i, step, body);
        if let (Some((about, _)), Some(upright)) = (step.axis, upright.get_mut(i)) {
            *upright = reached.seen.iter().all(|of| of.get(about).is_none());
        }
        let com = links.get(i).map(|(_, com_m)| mm(com_m)).filter(|_| counts(i));
        reached.name_places(i, com, step.axis.filter(|_| turns(i)), body);
    }
    load(model.payload_kg, &reached, body);
    for group in &groups {
        sums(group, (&|i| weight(group, i), &upright), body);
    }
}

/// The frame that the statements have reached, from the base outward.
struct ReachedFrame {
    /// The base's x and y in the axes of this frame.
    seen: [Triple; 2],
    /// Whether its origin is away from 0 in the base's x and y, so that it has a name.
    at: [bool; 2],
    /// Of an arm that stands upright: its first joint turns the base's x and y themselves, with this sign.
    stands: Option<f64>,
}

impl ReachedFrame {
    /// The base itself, before the first step.
    fn base(model: &LiveModel, body: &mut Body) -> Self {
        let mut seen = SEEN.map(|(_, axis)| Triple::zero(&format!("tcU{axis}")));
        let first_step = &model.steps[0];
        let stands = match first_step.axis {
            Some((2, sign)) if first_step.rotation.is_identity(0.0) => Some(sign),
            _ => None,
        };
        for ((k, _), of) in SEEN.into_iter().zip(&mut seen).filter(|_| stands.is_none()) {
            body.increase(of, k, &[(1.0, String::new())]);
        }
        Self { seen, at: [false; 2], stands }
    }

    /// One step further: to the place of the next frame, and about its axis.
    fn step(&mut self, i: usize, step: &FixedFrame, body: &mut Body) {
        let place = mm(&step.place_m);
        let turned_base = self.stands.filter(|_| i == 0);
        for ((k, axis), (of, is)) in SEEN.into_iter().zip(self.seen.iter().zip(&mut self.at)) {
            let summands: Vec<Summand> = match turned_base {
                Some(_) => vec![(place[k], String::new())],
                None => (0..3).filter_map(|k| of.times(k, place[k])).collect(),
            };
            *is = body.add(&format!("tcO{axis}"), *is, &summands);
        }
        for ((k, _), of) in SEEN.into_iter().zip(&mut self.seen) {
            if let Some(sign) = turned_base {
                let across = if k == 0 { -sign } else { sign };
                body.increase(of, k, &[(1.0, cosine(0))]);
                body.increase(of, 1 - k, &[(across, sine(0))]);
                continue;
            }
            body.rotate(of, &rows(&step.rotation.transpose()));
            if let Some((axis, sign)) = step.axis {
                body.turn(of, axis, -sign, [&sine(i), &cosine(i)]);
            }
        }
    }

    /// Names what torques are made of: the link's centre of mass `com`, mm, and the origin and axis of a joint that gives, which is
    /// one of the frame's with a sign.
    fn name_places(&self, i: usize, com: Option<[f64; 3]>, axis: Option<(usize, f64)>, body: &mut Body) {
        for ((_, seen_as), (of, is)) in SEEN.into_iter().zip(self.seen.iter().zip(self.at)) {
            let origin = is.then(|| (1.0, format!("tcO{seen_as}")));
            if let Some(com) = com {
                let own = (0..3).filter_map(|k| of.times(k, com[k]));
                let place: Vec<Summand> = own.chain(origin.clone()).collect();
                body.set_always(&format!("tcP{seen_as}{}", i + 1), &place);
            }
            if let Some((about, sign)) = axis {
                body.set_always(&format!("tcO{seen_as}{}", i + 1), &origin.into_iter().collect::<Vec<_>>());
                let along = of.times(about, sign);
                body.set_always(&format!("tcA{seen_as}{}", i + 1), &along.into_iter().collect::<Vec<_>>());
            }
        }
    }
}

/// The tool's mass, or the load that is given, kg, and where its centre is; the tool's is given in the flange's frame, which is the last one
/// reached.
fn load(given_kg: Option<f64>, reached: &ReachedFrame, body: &mut Body) {
    match given_kg {
        Some(kg) => body.line(format!("tcL:={kg};")),
        None => {
            body.line("tcL:=0;");
            body.line(format!("IF tcTool.tload.mass>{NO_LOAD_KG} tcL:=tcTool.tload.mass;"));
        }
    }
    for ((_, axis), (of, is)) in SEEN.into_iter().zip(reached.seen.iter().zip(reached.at)) {
        let cog = (0..3).filter_map(|k| {
            of.get(k).map(|name| (1.0, format!("{name}*tcTool.tload.cog.{}", ["x", "y", "z"][k])))
        });
        let summands: Vec<Summand> = cog.chain(is.then(|| (1.0, format!("tcO{axis}")))).collect();
        body.set_always(&format!("tcP{axis}7"), &summands);
    }
}

/// One group: what turns its joints, from the tool inward.
fn sums(group: &Group, (weight, upright): (&dyn Fn(usize) -> f64, &[bool; 6]), body: &mut Body) {
    body.line("! Masses beyond a joint times their places, kg mm, from the tool inward");
    let first = group.joints.iter().map(|(j, _)| *j).min().unwrap_or(0);
    let (share, mut mass_kg) = (group.shares[6], 0.0);
    let mut has = !is_nothing(share);
    if has {
        body.set_always("tcW", &[(share, "tcL".to_owned())]);
    }
    for (_, axis) in SEEN.into_iter().filter(|_| has) {
        body.set_always(&format!("tcM{axis}"), &[(1.0, format!("tcW*tcP{axis}7"))]);
    }
    for i in (first..6).rev() {
        let own = weight(i);
        if !is_nothing(own) {
            for (_, axis) in SEEN {
                body.add(&format!("tcM{axis}"), has, &[(own, format!("tcP{axis}{}", i + 1))]);
            }
            has = true;
            mass_kg += own;
        }
        let Some((_, scale)) = group.joints.iter().find(|(j, _)| *j == i) else { continue };
        let n = i + 1;
        let mass = [(1.0, "tcW".to_owned()), (mass_kg, String::new())];
        let mass = super::text::sum(&mass[usize::from(is_nothing(share))..]);
        let mass = if mass.is_empty() { "0" } else { &mass };
        if !has || upright[i] {
            body.line(format!("tcT{n}:=0;"));
            continue;
        }
        body.line(format!("tcK:={mass};"));
        // Display of an f32 is its shortest fixed notation: what is written as nothing elsewhere counts here.
        let by = -m_from_mm(scale * GRAVITY_M_S2) as f32;
        body.line(format!("tcT{n}:={by}*(tcAx{n}*(tcMy-tcK*tcOy{n})-tcAy{n}*(tcMx-tcK*tcOx{n}));"));
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
