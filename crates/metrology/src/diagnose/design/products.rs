//! Products of a candidate's columns with themselves and with the design's, group by group.

use super::matrix::{Design, dot};
use nalgebra::DMatrix;

/// Rows that are multiplied at one go: so many of all columns stay in the processor's cache.
const BLOCK: usize = 1024;

/// A candidate's products for each group, its columns scaled by their prior sigma.
#[derive(Clone, Debug)]
pub struct Products {
    /// Number of parameters of the candidate.
    pub p: usize,
    /// With itself: p x p for each group.
    pub(super) own: Vec<f64>,
    /// With the design's columns: p values for each column, for each group.
    pub(super) cross: Vec<Vec<f64>>,
}

/// A candidate's products over a subset of groups.
#[derive(Clone, Debug)]
pub struct Sums {
    /// With itself, p x p.
    pub own: DMatrix<f64>,
    /// With the design's columns, p x columns.
    pub cross: DMatrix<f64>,
}

impl Design {
    /// Products of `columns` with each other and with the design.
    #[must_use]
    pub fn products(&self, columns: &[Vec<f64>]) -> Products {
        let p = columns.len();
        let mut own = Vec::with_capacity(self.groups.len() * p * p);
        for rows in &self.groups {
            for a in columns {
                for b in columns {
                    own.push(dot(&a[rows.clone()], &b[rows.clone()]));
                }
            }
        }
        let mut products = Products { p, own, cross: vec![Vec::new(); self.groups.len()] };
        self.extend(&mut products, columns);
        products
    }

    /// The same over all groups at once.
    #[must_use]
    pub fn sums(&self, columns: &[Vec<f64>]) -> Sums {
        let p = columns.len();
        let own = DMatrix::from_fn(p, p, |a, b| if a < b { 0.0 } else { dot(&columns[a], &columns[b]) });
        let mut sums = Sums { own, cross: DMatrix::zeros(p, 0) };
        sums.own.fill_upper_triangle_with_lower_triangle();
        self.extend_sums(&mut sums, columns);
        sums
    }

    /// Brings `sums` over all groups up to date with columns appended since.
    pub fn extend_sums(&self, sums: &mut Sums, columns: &[Vec<f64>]) {
        let known = sums.cross.ncols();
        let cross = std::mem::replace(&mut sums.cross, DMatrix::zeros(0, 0));
        sums.cross = cross.resize_horizontally(self.columns.len(), 0.0);
        let rows = columns.first().map_or(0, Vec::len);
        for from in (0..rows).step_by(BLOCK) {
            let block = from..rows.min(from + BLOCK);
            for (c, b) in self.columns.iter().enumerate().skip(known) {
                for (a, column) in columns.iter().enumerate() {
                    sums.cross[(a, c)] += dot(&column[block.clone()], &b[block.clone()]);
                }
            }
        }
    }

    /// Brings `products` up to date with columns appended since.
    pub fn extend(&self, products: &mut Products, columns: &[Vec<f64>]) {
        for (rows, cross) in self.groups.iter().zip(&mut products.cross) {
            let known = cross.len() / products.p.max(1);
            cross.reserve_exact(columns.len() * (self.columns.len() - known));
            for b in &self.columns[known..] {
                for a in columns {
                    cross.push(dot(&a[rows.clone()], &b[rows.clone()]));
                }
            }
        }
    }
}

impl Products {
    /// Products of no columns at all.
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
        for &group in subset {
            for (to, from) in more.iter_mut().zip(&self.cross[group][p * known..]) {
                *to += from;
            }
        }
        let cross = std::mem::replace(&mut sums.cross, DMatrix::zeros(0, 0));
        sums.cross = cross.resize_horizontally(width, 0.0);
        sums.cross.as_mut_slice()[p * known..].copy_from_slice(&more);
    }

    /// Over a subset of groups.
    #[must_use]
    pub fn sum(&self, subset: &[usize]) -> Sums {
        let p = self.p;
        let width = self.cross.first().map_or(0, |c| c.len() / p.max(1));
        let mut own = DMatrix::zeros(p, p);
        let mut cross = DMatrix::zeros(p, width);
        for &group in subset {
            for (to, from) in own.as_mut_slice().iter_mut().zip(&self.own[group * p * p..]) {
                *to += from;
            }
            for (to, from) in cross.as_mut_slice().iter_mut().zip(&self.cross[group]) {
                *to += from;
            }
        }
        Sums { own, cross }
    }
}
