//! Products of a candidate's columns with themselves and with the design's, group by group.

use super::inner_products::inner_products;
use super::matrix::Design;
use nalgebra::DMatrix;
use std::ops::Range;

/// A candidate's products for each group, its columns scaled by their prior sigma.
#[derive(Clone, Debug)]
pub struct Products {
    /// Number of parameters of the candidate.
    pub p: usize,
    /// With itself: p x p for each group.
    pub(super) own: Vec<f64>,
    /// With the design's columns: p values for each group, for each column.
    pub(super) cross: Vec<f64>,
    /// The latter summed over all groups.
    total: Vec<f64>,
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

/// Columns of the design that there is room for beyond those that are there.
const COLUMNS_AHEAD: usize = 16;

impl Design {
    /// Products of `columns` with each other and with the design.
    #[must_use]
    pub fn products(&self, columns: &DMatrix<f64>) -> Products {
        let p = columns.ncols();
        let of_group = |rows: &Range<usize>| -> Vec<f64> {
            let columns = columns.rows(rows.start, rows.len());
            inner_products(columns, columns).data.into()
        };
        let own = self.groups.iter().flat_map(of_group).collect();
        let mut products = Products::begun(p, own, self.groups.len());
        self.extend(&mut products, columns);
        products
    }

    /// The same over all groups at once.
    #[must_use]
    pub fn sums(&self, columns: &DMatrix<f64>) -> Sums {
        let own = inner_products(columns.as_view(), columns.as_view());
        let mut sums = Sums { own, cross: DMatrix::zeros(columns.ncols(), 0) };
        self.extend_sums(&mut sums, columns);
        sums
    }

    /// Products of `columns` with each other over a subset of groups.
    #[must_use]
    pub fn products_among(&self, columns: &DMatrix<f64>, subset: &[usize]) -> DMatrix<f64> {
        let mut sum = DMatrix::zeros(columns.ncols(), columns.ncols());
        for rows in subset.iter().filter_map(|&a| self.groups.get(a)) {
            let columns = columns.rows(rows.start, rows.len());
            sum += inner_products(columns, columns);
        }
        sum
    }

    /// Brings `sums` over all groups up to date with columns appended since.
    pub fn extend_sums(&self, sums: &mut Sums, columns: &DMatrix<f64>) {
        let known = sums.cross.ncols();
        let new = inner_products(columns.as_view(), self.columns_from(known));
        let cross = std::mem::replace(&mut sums.cross, DMatrix::zeros(0, 0));
        sums.cross = cross.resize_horizontally(self.width(), 0.0);
        sums.cross.columns_mut(known, new.ncols()).copy_from(&new);
    }

    /// Brings `products` up to date with columns appended since.
    pub fn extend(&self, products: &mut Products, columns: &DMatrix<f64>) {
        let new = self.columns_from(products.columns());
        let of_group = |rows: &Range<usize>| {
            inner_products(columns.rows(rows.start, rows.len()), new.rows(rows.start, rows.len()))
        };
        let of_groups: Vec<DMatrix<f64>> = self.groups.iter().map(of_group).collect();
        products.reserve(self.room_beyond(products.columns()));
        for column in 0..new.ncols() {
            for of in &of_groups {
                products.cross.extend(of.column(column).iter());
            }
        }
        products.sum_all();
    }
}
impl Products {
    /// Products of no columns at all.
    #[must_use]
    pub fn none() -> Self {
        Self::begun(0, Vec::new(), 0)
    }

    /// Products with itself alone.
    pub(super) fn begun(p: usize, own: Vec<f64>, groups: usize) -> Self {
        Self { p, own, cross: Vec::new(), total: Vec::new(), groups }
    }

    /// Takes off the products with the design's columns from number `width` on.
    pub fn truncate(&mut self, width: usize) {
        self.cross.truncate(self.p * self.groups * width);
        self.total.truncate(self.p * width);
    }

    /// Sums over all groups of what was added to the products with the design's columns.
    pub(super) fn sum_all(&mut self) {
        let known = self.total.len();
        let mut total = std::mem::take(&mut self.total);
        total.resize(self.p * self.columns(), 0.0);
        let all: Vec<usize> = (0..self.groups).collect();
        self.add_groups(&all, known / self.p.max(1), 1.0, &mut total[known..]);
        self.total = total;
    }

    /// Makes room for `more` columns of the design, and for some after them: thousands of candidates are not copied for each that joins.
    pub(super) fn reserve(&mut self, more: usize) {
        let column = self.p * self.groups;
        if self.cross.capacity() < self.cross.len() + more * column {
            self.cross.reserve_exact((more + COLUMNS_AHEAD) * column);
            self.total.reserve_exact((more + COLUMNS_AHEAD) * self.p);
        }
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

    /// Products with the columns from number `from` on over `subset`, p values for each column.
    fn sum_cross(&self, subset: &[usize], from: usize, into: &mut [f64]) {
        if 2 * subset.len() <= self.groups {
            return self.add_groups(subset, from, 1.0, into);
        }
        let others: Vec<usize> = (0..self.groups).filter(|group| !subset.contains(group)).collect();
        into.copy_from_slice(&self.total[self.p * from..]);
        self.add_groups(&others, from, -1.0, into);
    }

    /// Adds those of `groups` times `sign`.
    fn add_groups(&self, groups: &[usize], from: usize, sign: f64, into: &mut [f64]) {
        // The widths that occur as constants: thousands of candidates, and sums that stay in registers.
        match self.p {
            0 => {}
            1 => self.add_groups_of::<1>(groups, from, sign, into),
            2 => self.add_groups_of::<2>(groups, from, sign, into),
            3 => self.add_groups_of::<3>(groups, from, sign, into),
            6 => self.add_groups_of::<6>(groups, from, sign, into),
            p => {
                let columns = self.cross.chunks_exact(p * self.groups).skip(from);
                for (to, column) in into.chunks_exact_mut(p).zip(columns) {
                    for &group in groups {
                        for (to, from) in to.iter_mut().zip(&column[group * p..]) {
                            *to += sign * from;
                        }
                    }
                }
            }
        }
    }

    fn add_groups_of<const P: usize>(&self, groups: &[usize], from: usize, sign: f64, into: &mut [f64]) {
        let columns = self.cross.chunks_exact(P * self.groups).skip(from);
        for (to, column) in into.chunks_exact_mut(P).zip(columns) {
            let mut sum = [0.0; P];
            for &group in groups {
                for (sum, from) in sum.iter_mut().zip(&column[group * P..(group + 1) * P]) {
                    *sum += from;
                }
            }
            to.iter_mut().zip(sum).for_each(|(to, sum)| *to += sign * sum);
        }
    }
}
