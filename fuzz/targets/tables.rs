//! Any table, robot or model is read or refused.

#![allow(clippy::expect_used, reason = "a target stops where its promise is broken")]

use driftpost::{Deformation, Measurements, Robot, Touches};
use robot_model::deform::identified::Identified;

/// Tables of every kind, robot files and models: a table or an error; what a model writes is read again.
pub fn tables(data: &[u8]) {
    drop(Measurements::from_csv(data));
    drop(Touches::from_csv(data));
    drop(Deformation::from_csv(data, None));
    let Ok(text) = std::str::from_utf8(data) else { return };
    drop(Robot::from_toml(text));
    if let Ok(model) = Identified::from_toml(text) {
        let again = Identified::from_toml(&model.to_toml()).expect("what a model writes is read");
        assert_eq!(again.terms.len(), model.terms.len());
    }
}
