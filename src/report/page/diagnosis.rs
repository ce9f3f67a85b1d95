//! The page of a diagnosis.

use super::embed::Decimals;
use super::scene::robot;
use super::{Page, write_page};
use crate::report::diagnosis::{next_step, summary};
use measurements::OwnNames;
use metrology::diagnose::{Findings, GearLine, GearSpectrum, RowResidual};
use robot_model::robot::SerialArm;
use robot_model::units::{mm_from_m, mrad_from_rad};
use serde_json::{Value, json};
use std::io::{self, Write};

/// Of more rows than this every second, third ... is shown: pictures of them show no more.
const MOST_ROWS: usize = 6_000;

/// What the page of a diagnosis is made of.
#[derive(Clone, Copy, Debug)]
pub struct DiagnosisPage<'a> {
    /// The measurement file's name.
    pub title: &'a str,
    /// Result of the diagnosis.
    pub findings: &'a Findings,
    /// The robot as its model says, of four to seven joints.
    pub robot: &'a SerialArm,
    /// What the file calls its columns.
    pub names: &'a OwnNames,
    /// Lines of the gears, joint by joint, as far as a model holds them.
    pub spectra: &'a [GearSpectrum],
    /// The report as people read it on a terminal.
    pub text: &'a str,
    /// Files with their SHA-256: names and values.
    pub provenance: &'a [(&'static str, String)],
}

impl DiagnosisPage<'_> {
    /// Writes the page.
    ///
    /// # Errors
    /// What writing to `out` fails with.
    pub fn write(self, out: &mut dyn Write) -> io::Result<()> {
        let all = &self.findings.residuals;
        let step = all.len().div_ceil(MOST_ROWS).max(1);
        let rows: Vec<&RowResidual> = all.iter().step_by(step).collect();
        let flat = |of: fn(&RowResidual) -> &[f64]| rows.iter().flat_map(|row| of(row)).copied().collect();
        let view = json!({
            "robot": robot(self.robot),
            "text": self.text,
            "mostly": summary(self.findings),
            "next": next_step(self.findings, self.robot, self.names),
            "provenance": self.provenance,
            "spectra": self.spectra.iter().map(spectrum).collect::<Vec<_>>(),
            "rows": all.len(),
            "residuals": {
                "line": rows.iter().map(|row| row.line).collect::<Vec<_>>(),
                "id": rows.iter().map(|row| &row.id).collect::<Vec<_>>(),
                "t_min": rows.iter().map(|row| row.t_min).collect::<Vec<_>>(),
                "outlier": rows.iter().map(|row| u8::from(row.outlier)).collect::<Vec<_>>(),
                "q_deg": Decimals::<3>(flat(|row| &row.q_deg)),
                "p_mm": Decimals::<2>(flat(|row| &row.point_mm)),
                "before_mm": Decimals::<4>(flat(|row| &row.before_mm)),
                "after_mm": Decimals::<4>(flat(|row| &row.after_mm)),
            },
        });
        write_page(
            out,
            &Page { command: "diagnose", title: self.title.to_owned(), data: self.findings, view },
        )
    }
}

fn spectrum(gear: &GearSpectrum) -> Value {
    let line = |line: &GearLine| {
        json!({
            "n": line.n, "named": line.is_named, "mrad": mrad_from_rad(line.size_rad), "sigma_mrad": line.sigma_rad.map(mrad_from_rad),
        })
    };
    json!({
        "joint": gear.joint, "lever_mm": mm_from_m(gear.lever_m), "lines": gear.lines.iter().map(line).collect::<Vec<_>>(),
    })
}
