//! The linear problem, reduced once: whitened columns and their products, summed over atoms of stations.
//!
//! Atoms are the smallest groups of stations that a fold, a block in time or a region keeps together, so
//! every held-out fit is a sum of small matrices.

use super::effects::Candidate;
use super::scene::{Motion, Scene, Sight, Site};
use nalgebra::{DMatrix, Vector3};
use rayon::prelude::*;
use std::ops::Range;

/// Manufacturing tolerance of a joint's frame: metres, and radians.
const TOLERANCE: [f64; 2] = [1.5e-4, 2.5e-4];

/// Weights of the stations.
#[derive(Clone, Debug)]
pub struct Whitening {
    /// Weight of each station: 1 = one row of usual noise.
    pub weights: Vec<f64>,
    /// An orientation residual counts as if at this distance, metres.
    pub arm_m: f64,
}

/// Columns with their meaning: data first, then registration, geometry, and what was added.
#[derive(Clone, Debug)]
pub struct Design {
    whitening: Whitening,
    /// Sites in the order of atoms.
    order: Vec<usize>,
    /// Rows of each atom.
    atoms: Vec<Range<usize>>,
    rows_per_site: usize,
    /// Numbers measured in each atom.
    counts: Vec<usize>,
    columns: Vec<Vec<f64>>,
    /// Columns of registration, flat prior.
    pub flat: Range<usize>,
    /// Columns of geometry, scaled by tolerance.
    pub geometry: Range<usize>,
    /// Products of all columns for each atom.
    gram: Vec<DMatrix<f64>>,
    /// Whitened columns of each joint turning.
    turns: Vec<Vec<f64>>,
    /// Each of these with itself, and with every column, site by site.
    turn_squares: Vec<Vec<f64>>,
    turn_products: Vec<Vec<Vec<f64>>>,
}

/// A candidate's products for each atom, its columns scaled by their usual size.
#[derive(Clone, Debug)]
pub struct Products {
    /// Number of parameters.
    pub p: usize,
    /// With itself: p x p for each atom.
    own: Vec<f64>,
    /// With the design's columns: p values for each column, for each atom.
    cross: Vec<Vec<f64>>,
}

/// Candidates that only turn one joint: there are many, and their products come by matrix products.
#[derive(Clone, Debug)]
pub struct Turning {
    joint: usize,
    /// Indices into the candidates.
    pub members: Vec<usize>,
    /// Angles per usual size: two rows for each member, a column for each site in the order of atoms.
    angles: DMatrix<f64>,
}

/// A candidate's products over a subset of atoms.
#[derive(Clone, Debug)]
pub struct Sums {
    /// With itself, p x p.
    pub own: DMatrix<f64>,
    /// With the design's columns, p x columns.
    pub cross: DMatrix<f64>,
}

impl Design {
    /// The design of `residuals` (metres and radians, base axes) at the scene's sites; `atom_of` numbers
    /// each site's atom from 0.
    #[must_use]
    pub fn new(
        scene: &Scene,
        residuals: &[Motion],
        targets: usize,
        whitening: Whitening,
        atom_of: &[usize],
    ) -> Self {
        let mut order: Vec<usize> = (0..scene.sites.len()).collect();
        order.sort_by_key(|&i| (atom_of.get(i).copied().unwrap_or(0), i));
        let d = scene.rows_per_site;
        let mut atoms: Vec<Range<usize>> = Vec::new();
        let mut counts: Vec<usize> = Vec::new();
        let mut last = None;
        for (position, &i) in order.iter().enumerate() {
            let rows = position * d..(position + 1) * d;
            let measured = scene.sites[i].rows(d);
            if last == Some(atom_of[i]) {
                if let Some(count) = counts.last_mut() {
                    *count += measured;
                }
                if let Some(atom) = atoms.last_mut() {
                    atom.end = rows.end;
                }
            } else {
                last = Some(atom_of[i]);
                counts.push(measured);
                atoms.push(rows);
            }
        }
        let mut design = Self {
            whitening,
            order,
            atoms,
            rows_per_site: d,
            counts,
            columns: Vec::new(),
            flat: 0..0,
            geometry: 0..0,
            gram: Vec::new(),
            turns: Vec::new(),
            turn_squares: Vec::new(),
            turn_products: vec![Vec::new(); 6],
        };
        let mut columns = design.stack(scene, 1, |i, _, out| out.push(residuals[i]));
        let flat = design.stack(scene, registration_width(targets, scene.places, d), |_, site, out| {
            registration_motions(site, targets, scene.places, d, out);
        });
        let geometry = design.stack(scene, 30, |_, site, out| {
            for frame in 1..6 {
                for k in 0..6 {
                    out.push(super::scene::scaled(site.offset(frame, k), TOLERANCE[k / 3]));
                }
            }
        });
        design.flat = 1..1 + flat.len();
        design.geometry = design.flat.end..design.flat.end + geometry.len();
        columns.extend(flat);
        columns.extend(geometry);
        design.columns = columns;
        design.turns = design.stack(scene, 6, |_, site, out| out.extend((0..6).map(|j| site.joint(j))));
        design.turn_squares = design.turns.iter().map(|t| by_site(t, t, d)).collect();
        design.multiply_turns();
        design.gram = (0..design.atoms.len()).map(|a| design.gram_of(a)).collect();
        design
    }

    /// Weights of the stations.
    #[must_use]
    pub fn whitening(&self) -> &Whitening {
        &self.whitening
    }

    /// Number of columns.
    #[must_use]
    pub fn width(&self) -> usize {
        self.columns.len()
    }

    /// Number of atoms.
    #[must_use]
    pub fn atoms(&self) -> usize {
        self.atoms.len()
    }

    /// Numbers measured in a subset of atoms.
    #[must_use]
    pub fn rows(&self, subset: &[usize]) -> usize {
        subset.iter().filter_map(|&a| self.counts.get(a)).sum()
    }

    /// Offset `k` of frame `i` is column `geometry.start + 6 (i - 1) + k`, per this many SI units.
    #[must_use]
    pub fn tolerance(k: usize) -> f64 {
        TOLERANCE[usize::from(k >= 3)]
    }

    /// Products of all columns over a subset of atoms.
    #[must_use]
    pub fn gram(&self, subset: &[usize]) -> DMatrix<f64> {
        let mut sum = DMatrix::zeros(self.width(), self.width());
        for &a in subset {
            sum += &self.gram[a];
        }
        sum
    }

    /// Adds columns and their products; gives their place.
    pub fn append(&mut self, columns: Vec<Vec<f64>>) -> Range<usize> {
        let start = self.columns.len();
        self.columns.extend(columns);
        self.multiply_turns();
        self.gram = (0..self.atoms.len()).map(|a| self.gram_of(a)).collect();
        start..self.columns.len()
    }

    /// A candidate's columns, scaled by their usual size.
    #[must_use]
    pub fn columns_of(&self, scene: &Scene, candidate: &Candidate) -> Vec<Vec<f64>> {
        self.stack(scene, candidate.usual.len(), |_, site, out| {
            let from = out.len();
            candidate.effect().motions(&candidate.form, scene, site, out);
            for (motion, usual) in out.iter_mut().skip(from).zip(&candidate.usual) {
                *motion = super::scene::scaled(*motion, *usual);
            }
        })
    }

    /// Whitened columns of `width` motions for each site.
    #[must_use]
    pub fn stack(
        &self,
        scene: &Scene,
        width: usize,
        motions: impl Fn(usize, &Site, &mut Vec<Motion>),
    ) -> Vec<Vec<f64>> {
        let d = self.rows_per_site;
        let mut columns = vec![vec![0.0; self.order.len() * d]; width];
        let mut buffer = Vec::with_capacity(width);
        for (position, &i) in self.order.iter().enumerate() {
            buffer.clear();
            motions(i, &scene.sites[i], &mut buffer);
            let root = self.whitening.weights[i].sqrt();
            for (column, motion) in columns.iter_mut().zip(&buffer) {
                let motion = scene.sites[i].seen(*motion);
                for (k, value) in column[position * d..(position + 1) * d].iter_mut().enumerate() {
                    *value = motion[k] * root * if k < 3 { 1.0 } else { self.whitening.arm_m };
                }
            }
        }
        columns
    }

    /// A column times a number for each site.
    #[must_use]
    pub fn modulated(&self, scene: &Scene, column: usize, factor: impl Fn(&Site) -> f64) -> Vec<f64> {
        let d = self.rows_per_site;
        let mut out = self.columns[column].clone();
        for (rows, &i) in out.chunks_exact_mut(d).zip(&self.order) {
            let factor = factor(&scene.sites[i]);
            rows.iter_mut().for_each(|v| *v *= factor);
        }
        out
    }

    /// Products of `columns` with each other and with the design.
    #[must_use]
    pub fn products(&self, columns: &[Vec<f64>]) -> Products {
        let p = columns.len();
        let mut own = Vec::with_capacity(self.atoms.len() * p * p);
        for rows in &self.atoms {
            for a in columns {
                for b in columns {
                    own.push(dot(&a[rows.clone()], &b[rows.clone()]));
                }
            }
        }
        let mut products = Products { p, own, cross: vec![Vec::new(); self.atoms.len()] };
        self.extend(&mut products, columns);
        products
    }

    /// Brings `products` up to date with columns appended since.
    pub fn extend(&self, products: &mut Products, columns: &[Vec<f64>]) {
        for (rows, cross) in self.atoms.iter().zip(&mut products.cross) {
            let known = cross.len() / products.p.max(1);
            cross.reserve_exact(columns.len() * (self.columns.len() - known));
            for b in &self.columns[known..] {
                for a in columns {
                    cross.push(dot(&a[rows.clone()], &b[rows.clone()]));
                }
            }
        }
    }

    /// Angles of the candidates that only turn `joint`: one row for each parameter, one column for each
    /// site in the order of atoms.
    #[must_use]
    pub fn turning(&self, scene: &Scene, candidates: &[Candidate], joint: usize) -> Turning {
        let members: Vec<usize> = (0..candidates.len())
            .filter(|&c| {
                let form = &candidates[c].form;
                form.joint == Some(joint)
                    && scene.sites.first().is_some_and(|s| candidates[c].effect().angles(form, s).is_some())
            })
            .collect();
        let mut angles = DMatrix::zeros(2 * members.len(), self.order.len());
        for (mut column, &i) in angles.column_iter_mut().zip(&self.order) {
            for (k, &c) in members.iter().enumerate() {
                let candidate = &candidates[c];
                let here = candidate.effect().angles(&candidate.form, &scene.sites[i]).unwrap_or_default();
                for a in 0..2 {
                    column[2 * k + a] = here[a] * candidate.usual.get(a).copied().unwrap_or(0.0);
                }
            }
        }
        Turning { joint, members, angles }
    }

    /// Products of all members of `turning` with themselves, into `products`.
    pub fn begin_turning(&self, turning: &Turning, products: &mut [Products]) {
        let squares = &self.turn_squares[turning.joint];
        for (k, &c) in turning.members.iter().enumerate() {
            let mut own = Vec::with_capacity(self.atoms.len() * 4);
            for rows in &self.atoms {
                let mut sums = [0.0; 3];
                let sites = rows.start / self.rows_per_site..rows.end / self.rows_per_site;
                for (site, w) in sites.clone().zip(&squares[sites]) {
                    let (s, c) = (turning.angles[(2 * k, site)], turning.angles[(2 * k + 1, site)]);
                    sums[0] += w * s * s;
                    sums[1] += w * s * c;
                    sums[2] += w * c * c;
                }
                own.extend([sums[0], sums[1], sums[1], sums[2]]);
            }
            products[c] = Products { p: 2, own, cross: vec![Vec::new(); self.atoms.len()] };
        }
    }

    /// Brings the members' products up to date with columns appended since: one matrix product per atom.
    pub fn extend_turning(&self, turning: &Turning, products: &mut [Products]) {
        let Some(first) = turning.members.first().and_then(|&c| products.get(c)) else { return };
        let known = first.cross.first().map_or(0, |c| c.len() / 2);
        let columns = &self.turn_products[turning.joint][known..];
        if columns.is_empty() {
            return;
        }
        let crossed: Vec<DMatrix<f64>> = self
            .atoms
            .par_iter()
            .map(|rows| {
                let sites = rows.start / self.rows_per_site..rows.end / self.rows_per_site;
                let with = DMatrix::from_fn(sites.len(), columns.len(), |r, c| columns[c][sites.start + r]);
                turning.angles.columns(sites.start, sites.len()) * with
            })
            .collect();
        for (k, &c) in turning.members.iter().enumerate() {
            for (to, from) in products[c].cross.iter_mut().zip(&crossed) {
                to.reserve_exact(2 * from.ncols());
                for column in from.column_iter() {
                    to.push(column[2 * k]);
                    to.push(column[2 * k + 1]);
                }
            }
        }
    }

    fn multiply_turns(&mut self) {
        let d = self.rows_per_site;
        for (turn, products) in self.turns.iter().zip(&mut self.turn_products) {
            for column in &self.columns[products.len()..] {
                products.push(by_site(turn, column, d));
            }
        }
    }

    /// Residual of `coefficients` (one for each column after the data) at each site, unwhitened: metres, radians.
    #[must_use]
    pub fn residuals(&self, coefficients: &[f64]) -> Vec<Motion> {
        let d = self.rows_per_site;
        let mut out = vec![[0.0; 6]; self.order.len()];
        for (position, &i) in self.order.iter().enumerate() {
            let root = self.whitening.weights[i].sqrt().max(1e-12);
            for (k, to) in out[i].iter_mut().enumerate().take(d) {
                let row = position * d + k;
                let mut value = self.columns[0][row];
                for (c, column) in coefficients.iter().zip(&self.columns[1..]) {
                    if *c != 0.0 {
                        value -= c * column[row];
                    }
                }
                *to = value / root / if k < 3 { 1.0 } else { self.whitening.arm_m };
            }
        }
        out
    }

    fn gram_of(&self, atom: usize) -> DMatrix<f64> {
        let rows = self.atoms[atom].clone();
        let n = self.columns.len();
        let known = self.gram.get(atom).map_or(0, DMatrix::nrows);
        let mut gram = DMatrix::zeros(n, n);
        for a in 0..n {
            for b in a..n {
                let value = match self.gram.get(atom) {
                    Some(old) if b < known => old[(a, b)],
                    _ => dot(&self.columns[a][rows.clone()], &self.columns[b][rows.clone()]),
                };
                gram[(a, b)] = value;
                gram[(b, a)] = value;
            }
        }
        gram
    }
}

impl Products {
    /// None yet.
    #[must_use]
    pub fn none() -> Self {
        Self { p: 0, own: Vec::new(), cross: Vec::new() }
    }

    /// Adds the columns that `sums` lacks.
    pub fn sum_more(&self, subset: &[usize], sums: &mut Sums) {
        let (p, known) = (self.p, sums.cross.ncols());
        let width = self.cross.first().map_or(0, |c| c.len() / p.max(1));
        if width <= known {
            return;
        }
        let mut more = vec![0.0; p * (width - known)];
        for &atom in subset {
            for (to, from) in more.iter_mut().zip(&self.cross[atom][p * known..]) {
                *to += from;
            }
        }
        let cross = std::mem::replace(&mut sums.cross, DMatrix::zeros(0, 0));
        sums.cross = cross.resize_horizontally(width, 0.0);
        sums.cross.as_mut_slice()[p * known..].copy_from_slice(&more);
    }

    /// Over a subset of atoms.
    #[must_use]
    pub fn sum(&self, subset: &[usize]) -> Sums {
        let p = self.p;
        let width = self.cross.first().map_or(0, |c| c.len() / p.max(1));
        let mut own = DMatrix::zeros(p, p);
        let mut cross = DMatrix::zeros(p, width);
        for &atom in subset {
            for (to, from) in own.as_mut_slice().iter_mut().zip(&self.own[atom * p * p..]) {
                *to += from;
            }
            for (to, from) in cross.as_mut_slice().iter_mut().zip(&self.cross[atom]) {
                *to += from;
            }
        }
        Sums { own, cross }
    }
}

fn registration_width(targets: usize, places: usize, rows_per_site: usize) -> usize {
    6 + 3 * targets + 3 * places + if rows_per_site == 6 { 3 } else { 0 }
}

fn registration_motions(
    site: &Site,
    targets: usize,
    places: usize,
    rows_per_site: usize,
    out: &mut Vec<Motion>,
) {
    // Touches and lengths know nothing of an instrument.
    let by_instrument = f64::from(u8::from(matches!(site.sight, Sight::Instrument | Sight::Nest)));
    for k in 0..6 {
        out.push(super::scene::scaled(site.offset(0, k), by_instrument));
    }
    for target in 0..targets {
        for k in 0..3 {
            let axis: Vector3<f64> = site.flange.column(k).into_owned();
            let here = f64::from(u8::from(site.target == target));
            out.push([axis.x * here, axis.y * here, axis.z * here, 0.0, 0.0, 0.0]);
        }
    }
    for place in 0..places {
        for k in 0..3 {
            let mut shift = [0.0; 6];
            shift[k] = f64::from(u8::from(site.place == Some(place)));
            out.push(shift);
        }
    }
    if rows_per_site == 6 {
        for k in 0..3 {
            let axis = site.flange.column(k);
            out.push([0.0, 0.0, 0.0, axis[0], axis[1], axis[2]]);
        }
    }
}

/// Products of two columns, summed over each site's rows.
fn by_site(a: &[f64], b: &[f64], rows_per_site: usize) -> Vec<f64> {
    a.chunks_exact(rows_per_site)
        .zip(b.chunks_exact(rows_per_site))
        .map(|(x, y)| x.iter().zip(y).map(|(x, y)| x * y).sum())
        .collect()
}

/// Sum of products, in eight running sums: fast, and the same for every number of threads.
fn dot(a: &[f64], b: &[f64]) -> f64 {
    let mut sums = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let tail: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(x, y)| x * y).sum();
    for (x, y) in a8.zip(b8) {
        for k in 0..8 {
            sums[k] += x[k] * y[k];
        }
    }
    sums.iter().sum::<f64>() + tail
}
