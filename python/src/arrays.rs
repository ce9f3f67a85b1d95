//! Kinematics on numpy arrays.

use crate::errors::one;
use driftpost::application::{BRANCHES, CalibrationSizes, JACOBIAN, JOINTS, POSE};
use driftpost::{Arm, Diagnostic, command_line};
use numpy::{PyArray1, PyArrayMethods, PyReadonlyArray1};
use pyo3::exceptions::PyUserWarning;
use pyo3::prelude::*;
use std::ffi::CString;
use std::path::Path;

/// A robot arm.
#[pyclass(frozen, module = "driftpost._driftpost")]
pub struct Robot {
    arm: Arm,
    source: String,
}

type Flat<'py> = PyReadonlyArray1<'py, f64>;

/// Runs without the interpreter's lock, and gives rows of `width` numbers.
fn rows<'py>(
    py: Python<'py>,
    width: usize,
    work: impl Send + FnOnce() -> Result<Vec<f64>, Diagnostic>,
) -> PyResult<Bound<'py, PyAny>> {
    let made = py.detach(work).map_err(|diagnostic| one(py, diagnostic))?;
    let n = made.len() / width;
    Ok(PyArray1::from_vec(py, made).reshape([n, width])?.into_any())
}

#[pymethods]
impl Robot {
    /// The robot that `--robot` names.
    #[staticmethod]
    fn load(py: Python<'_>, name: &str) -> PyResult<Self> {
        let robot = command_line::robot(name).map_err(|diagnostic| one(py, diagnostic))?;
        Ok(Self { arm: Arm::new(robot), source: name.to_owned() })
    }

    #[getter]
    fn name(&self) -> &str {
        &self.arm.robot().name
    }

    #[getter]
    fn source(&self) -> &str {
        &self.source
    }

    /// What names the robot to a command; refused where that is another robot by now.
    fn current_source(&self, py: Python<'_>) -> PyResult<&str> {
        let now = command_line::robot(&self.source).map_err(|diagnostic| one(py, diagnostic))?;
        if now == *self.arm.robot() {
            return Ok(&self.source);
        }
        let text = format!("{} is another robot than when it was loaded", self.source);
        let help = "the file was changed since, or the working folder: load the robot again";
        Err(one(py, Diagnostic::error("robot::changed", text).help(help)))
    }

    /// Degrees, `None` where a joint has no range.
    #[getter]
    fn ranges(&self) -> Vec<Option<[f64; 2]>> {
        self.arm.ranges_deg()
    }

    fn forward<'py>(&self, py: Python<'py>, q: Flat<'py>) -> PyResult<Bound<'py, PyAny>> {
        let q = q.as_slice()?;
        rows(py, POSE, || self.arm.forward(q))
    }

    fn forward_deformed<'py>(
        &self,
        py: Python<'py>,
        q: Flat<'py>,
        t_min: Flat<'py>,
        deformation: Option<&str>,
        growth: Option<&str>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (q, t_min) = (q.as_slice()?, t_min.as_slice()?);
        let of_another = || command_line::default_table_of_another(self.arm.robot());
        if let Some(message) = deformation.is_none().then(of_another).flatten() {
            let message = CString::new(message).unwrap_or_default();
            PyErr::warn(py, &py.get_type::<PyUserWarning>(), &message, 1)?;
        }
        rows(py, POSE, || {
            let deformation = command_line::deformation(deformation.map(Path::new), growth)?;
            self.arm.forward_deformed(q, t_min, &deformation)
        })
    }

    fn jacobian<'py>(&self, py: Python<'py>, q: Flat<'py>) -> PyResult<Bound<'py, PyAny>> {
        let q = q.as_slice()?;
        rows(py, JACOBIAN, || self.arm.jacobian(q))
    }

    /// Offsets of the joints' frames, flat; rms of positions, mm, and of orientations, degrees, where there are any; steps.
    fn calibrate<'py>(
        &self,
        py: Python<'py>,
        q: Flat<'py>,
        pose: Flat<'py>,
        noise: (f64, Option<f64>),
        prior: (f64, f64),
    ) -> PyResult<(Bound<'py, PyAny>, f64, Option<f64>, usize)> {
        let (q, pose) = (q.as_slice()?, pose.as_slice()?);
        let sizes = CalibrationSizes {
            sigma_mm: noise.0,
            sigma_deg: noise.1,
            prior_shift_mm: prior.0,
            prior_turn_deg: prior.1,
        };
        let found =
            py.detach(|| self.arm.calibrate(q, pose, &sizes)).map_err(|diagnostic| one(py, diagnostic))?;
        let offsets = PyArray1::from_vec(py, found.offsets.concat()).into_any();
        Ok((offsets, found.rms_mm, found.rms_deg, found.steps))
    }

    fn branches<'py>(&self, py: Python<'py>, pose: Flat<'py>) -> PyResult<Bound<'py, PyAny>> {
        let pose = pose.as_slice()?;
        rows(py, BRANCHES, || self.arm.branches(pose))
    }

    fn nearest<'py>(&self, py: Python<'py>, pose: Flat<'py>, near: Flat<'py>) -> PyResult<Bound<'py, PyAny>> {
        let (pose, near) = (pose.as_slice()?, near.as_slice()?);
        rows(py, JOINTS, || self.arm.nearest(pose, near))
    }
}
