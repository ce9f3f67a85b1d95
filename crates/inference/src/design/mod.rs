//! The linear problem, reduced once: whitened columns and their products, summed over groups of stations.
//!
//! Groups are the smallest groups of stations that a fold, a block in time or a region keeps together, so
//! every held-out fit is a sum of small matrices.

mod inner_products;
mod matrix;
mod products;
pub mod registration;
mod scaled_motions;
mod visits;
mod whitening;

pub use inner_products::{dot, inner_products};
pub use matrix::{Design, SlowColumns, side_by_side};
pub use products::{Products, Sums};
pub use scaled_motions::ScaledMotions;
pub use visits::{VisitScatter, Visits};
pub use whitening::{SharedError, Whitening};
