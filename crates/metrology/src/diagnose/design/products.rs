//! Products of a candidate's columns with themselves and with the design's, group by group.

use super::matrix::{Design, dot};
use nalgebra::DMatrix;
use std::ops::Range;

/// Rows that are multiplied at one go: so many of all columns stay in the processor's cache.
const BLOCK: usize = 1024;

/// A candidate's products for each group, its columns scaled by their prior sigma.
#[derive(Clone, Debug)]
pub struct Products {
    /// Number of parameters of the candidate.
    pub p: usize,
    /// With itself: p x p for each group.
    pub(super) own: Vec<f64>,
    /// With the design's columns: p values for each group, for each column.
    pub(super) cross: Vec<f64>,
    /// How many groups of observations the numbers above run over.
    pub(super) groups: usize,
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
        let mut products = Products { p, own, cross: Vec::new(), groups: self.groups.len() };
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

    /// Products of `columns` with each other over a subset of groups.
    #[must_use]
    pub fn products_among(&self, columns: &[&[f64]], subset: &[usize]) -> DMatrix<f64> {
        let rows: usize = subset.iter().filter_map(|&a| self.groups.get(a)).map(Range::len).sum();
        let mut stacked = DMatrix::zeros(rows, columns.len());
        for (mut to, column) in stacked.column_iter_mut().zip(columns) {
            let mut at = 0;
            for range in subset.iter().filter_map(|&a| self.groups.get(a)) {
                to.as_mut_slice()[at..at + range.len()].copy_from_slice(&column[range.clone()]);
                at += range.len();
            }
        }
        stacked.transpose() * &stacked
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
        let known = products.columns();
        products.cross.reserve(columns.len() * self.groups.len() * (self.columns.len() - known));
        for b in &self.columns[known..] {
            for rows in &self.groups {
                for a in columns {
                    products.cross.push(dot(&a[rows.clone()], &b[rows.clone()]));
                }
            }
        }
    }
}

impl Products {
    /// Products of no columns at all.
    #[must_use]
    pub fn none() -> Self {
        Self { p: 0, own: Vec::new(), cross: Vec::new(), groups: 0 }
    }

    /// Columns of the design that are covered.
    pub(super) fn columns(&self) -> usize {
        self.cross.len() / (self.p * self.groups).max(1)
    }

    /// Adds the columns that `sums` lacks.
    pub fn sum_more(&self, subset: &[usize], sums: &mut Sums) {
        let (p, known) = (self.p, sums.cross.ncols());
        let width = self.columns();
        if width <= known {
            return;
        }
        let cross = std::mem::replace(&mut sums.cross, DMatrix::zeros(0, 0));
        sums.cross = cross.resize_horizontally(width, 0.0);
        self.sum_cross(subset, known, &mut sums.cross.as_mut_slice()[p * known..]);
    }

    /// Over a subset of groups.
    #[must_use]
    pub fn sum(&self, subset: &[usize]) -> Sums {
        let p = self.p;
        let mut own = DMatrix::zeros(p, p);
        let mut cross = DMatrix::zeros(p, self.columns());
        for &group in subset {
            for (to, from) in own.as_mut_slice().iter_mut().zip(&self.own[group * p * p..]) {
                *to += from;
            }
        }
        self.sum_cross(subset, 0, cross.as_mut_slice());
        Sums { own, cross }
    }

    /// Adds the products with the columns from number `from` on over `subset`, p values for each column.
    fn sum_cross(&self, subset: &[usize], from: usize, into: &mut [f64]) {
        // The widths that occur as constants: thousands of candidates, and sums that stay in registers.
        match self.p {
            0 => {}
            1 => self.sum_cross_of::<1>(subset, from, into),
            2 => self.sum_cross_of::<2>(subset, from, into),
            3 => self.sum_cross_of::<3>(subset, from, into),
            6 => self.sum_cross_of::<6>(subset, from, into),
            p => {
                let columns = self.cross.chunks_exact(p * self.groups).skip(from);
                for (to, column) in into.chunks_exact_mut(p).zip(columns) {
                    for &group in subset {
                        for (to, from) in to.iter_mut().zip(&column[group * p..]) {
                            *to += from;
                        }
                    }
                }
            }
        }
    }

    fn sum_cross_of<const P: usize>(&self, subset: &[usize], from: usize, into: &mut [f64]) {
        let columns = self.cross.chunks_exact(P * self.groups).skip(from);
        for (to, column) in into.chunks_exact_mut(P).zip(columns) {
            let mut sum: [f64; P] = std::array::from_fn(|a| to[a]);
            for &group in subset {
                for (sum, from) in sum.iter_mut().zip(&column[group * P..(group + 1) * P]) {
                    *sum += from;
                }
            }
            to.copy_from_slice(&sum);
        }
    }
}
