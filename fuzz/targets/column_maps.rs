//! Any file of measurements under any column map is read or refused.

use measurements::{ColumnMap, Measurements};

/// A column map and, behind a zero byte, the file of measurements that it is for.
pub fn column_maps(data: &[u8]) {
    let (map, file) = match data.iter().position(|&byte| byte == 0) {
        Some(at) => (&data[..at], &data[at + 1..]),
        None => (data, data),
    };
    let Ok(map) = ColumnMap::from_toml(&String::from_utf8_lossy(map)) else { return };
    let Ok(table) = map.table(file) else { return };
    let Ok(measurements) = Measurements::from_table(&table) else { return };
    let coordinates_m = measurements.rows.iter().filter_map(|row| row.reading.coordinates());
    assert!(
        coordinates_m.into_iter().all(|read| read.value_m.iter().all(|m| m.is_finite())),
        "a point without a place"
    );
    assert!(
        measurements.rows.iter().all(|row| row.q_rad.iter().all(|q| q.is_finite())),
        "joints without an angle"
    );
    assert!(measurements.rows.iter().all(|row| row.t_min.is_none_or(f64::is_finite)), "a time that is none");
}
