"""Kinematics on numpy arrays."""

from __future__ import annotations

import os
from dataclasses import dataclass

import numpy as np

from . import _driftpost
from ._errors import DriftpostError
from ._files import Folder, path_of


def _array(name: str, values, shape: tuple[int, ...]) -> tuple[np.ndarray, bool]:
    """Values as (N, *shape) of float64, and whether one row stood alone."""
    try:
        # What is masked is no number.
        is_masked = isinstance(values, np.ma.MaskedArray) and values.dtype.kind in "iuf"
        array = np.asarray(values.astype(np.float64).filled(np.nan) if is_masked else values)
    except (TypeError, ValueError) as error:
        raise DriftpostError(f"{name} is no array of numbers: {error}", "array::shape") from None
    if array.dtype.kind not in "iuf":
        raise DriftpostError(f"{name} is no array of numbers, but of {array.dtype}", "array::shape")
    array = array.astype(np.float64, copy=False)
    if array.shape == shape:
        return array[np.newaxis], True
    if array.ndim != len(shape) + 1 or array.shape[1:] != shape:
        wanted = "(" + ", ".join(["N", *map(str, shape)]) + ")"
        raise DriftpostError(f"{name} has shape {array.shape}, {wanted} is needed", "array::shape")
    return array, False


def _number(name: str, value) -> float:
    if isinstance(value, bool) or not isinstance(value, (int, float, np.number)):
        raise DriftpostError(f"{name} is {type(value).__name__}, not a number", "option::usage")
    return float(value)


def _flat(array: np.ndarray) -> np.ndarray:
    return np.ascontiguousarray(array).reshape(-1)


@dataclass(frozen=True, eq=False)
class Calibration:
    """The offsets of a robot's joint frames that explain measured flange poses best."""

    offsets: np.ndarray
    """(6, 6), a row for each joint: shifts x, y, z in mm, turns about x, y, z in degrees, as in a deformation table."""
    rms_mm: float
    """What is left between measured and calibrated positions, root of the mean square."""
    rms_deg: float | None
    """The same of orientations; None where positions alone were measured."""
    steps: int
    """Steps of the fit."""

    @property
    def table(self) -> str:
        """The offsets as a static deformation table (CSV): ``deformation=`` with ``growth="none"`` takes it."""
        rows = [",".join(map(repr, map(float, row))) for row in self.offsets]
        return "\n".join(["Dx [mm],Dy[mm],Dz[mm],DOx[deg],DOy[deg],DOz[deg]", *rows]) + "\n"


class Robot:
    """A six-axis arm: ``Robot.load("irb140")``.

    Joints are in degrees, lengths in mm. Every method takes one row or N and works on all cores without the interpreter's lock;
    an array that is not finite or of another shape raises DriftpostError (``array::*``) and names the row, from 0.
    """

    def __init__(self, core: _driftpost.Robot):
        if not isinstance(core, _driftpost.Robot):
            raise DriftpostError("a robot is loaded: Robot.load(\"irb140\")", "option::usage")
        self._core = core

    def __reduce__(self):
        return type(self).load, (self._core.source,)

    @classmethod
    def load(cls, name: str | os.PathLike[str]) -> Robot:
        """A built-in robot by its name, or a robot file by its path, as ``--robot`` takes them.

        Raises DriftpostError (``robot::*``, ``input::*``).
        """
        return cls(_driftpost.Robot.load(path_of("robot", name)))

    @property
    def name(self) -> str:
        """The robot's own name."""
        return self._core.name

    @property
    def ranges(self) -> np.ndarray:
        """(6, 2) lowest and highest angle of each joint, degrees; NaN where it has no range."""
        return np.array([[np.nan, np.nan] if r is None else r for r in self._core.ranges])

    def fk(self, q) -> np.ndarray:
        """Poses of the flange in the base, (N, 4, 4) with shifts in mm, of joints (N, 6) in degrees."""
        q, alone = _array("q", q, (6,))
        poses = self._core.forward(_flat(q)).reshape(-1, 4, 4)
        return poses[0] if alone else poses

    def fk_deformed(self, q, t_min, *, deformation=None, growth: str | None = None) -> np.ndarray:
        """As fk, of the arm as it has deformed at warm-up minutes ``t_min`` (one number, or N).

        ``deformation`` is a table (a path, CSV text, anything with ``__arrow_c_stream__``), ``growth`` its law (``"two-stage:46"``); without both the reference paper's,
        which is an IRB 140's: a UserWarning says so for any other arm.
        """
        q, alone = _array("q", q, (6,))
        t_min, _ = _array("t_min", np.atleast_1d(t_min) if np.isscalar(t_min) else t_min, ())
        if growth is not None and not isinstance(growth, str):
            raise DriftpostError(f"growth is {type(growth).__name__}, not a law like \"two-stage:46\"", "option::usage")
        with Folder() as folder:
            path = None if deformation is None else folder.table(deformation, "deformation.csv")
            try:
                poses = self._core.forward_deformed(_flat(q), _flat(t_min), path, growth).reshape(-1, 4, 4)
            except DriftpostError as error:
                raise folder.error(error) from None
        return poses[0] if alone else poses

    def calibrate(self, q, pose, *, sigma_mm: float = 0.02, sigma_deg: float | None = 0.0057, prior_shift_mm: float = 1.0,
                  prior_turn_deg: float = 0.115) -> Calibration:
        """The offsets of the joint frames that explain flange poses (N, 4, 4), shifts in mm, measured at joints (N, 6) best.

        Poses are in the robot's base frame. ``sigma_mm`` and ``sigma_deg`` are the noise of one coordinate of a measured position and
        orientation (``sigma_deg=None``: orientations were not measured), ``prior_shift_mm`` and ``prior_turn_deg`` the usual size of
        an offset: no measurement tells all 36 apart, and of those that it does not the smallest are taken. Use them all together.

        Raises DriftpostError (``array::*`` with the row, ``option::usage``, ``calibrate::not-settled``).
        """
        q, pose = _array("q", q, (6,))[0], _array("pose", pose, (4, 4))[0]
        sizes = [_number(name, value) for name, value in [("sigma_mm", sigma_mm), ("prior_shift_mm", prior_shift_mm), ("prior_turn_deg", prior_turn_deg)]]
        turn = None if sigma_deg is None else _number("sigma_deg", sigma_deg)
        offsets, rms_mm, rms_deg, steps = self._core.calibrate(_flat(q), _flat(pose), (sizes[0], turn), (sizes[1], sizes[2]))
        return Calibration(offsets.reshape(6, 6), rms_mm, rms_deg, steps)

    def jacobian(self, q) -> np.ndarray:
        """Geometric Jacobians (N, 6, 6) at the flange's origin in the base's axes, of joints (N, 6) in degrees.

        Rows vx vy vz in mm/rad and wx wy wz in rad/rad, columns joints.
        """
        q, alone = _array("q", q, (6,))
        jacobians = self._core.jacobian(_flat(q)).reshape(-1, 6, 6)
        return jacobians[0] if alone else jacobians

    def ik(self, pose, near=None) -> np.ndarray:
        """Joints in degrees that reach poses (N, 4, 4) with shifts in mm.

        Without ``near`` all eight branches, (N, 8, 6) in (-180, 180], by ABB's cfx (4 wrist centre behind axis 1, 2 behind the
        lower arm, 1 axis 5 negative), whatever the ranges. With ``near`` (N, 6) the nearest solution within the ranges, (N, 6).
        NaN where there is none.
        """
        pose, alone = _array("pose", pose, (4, 4))
        if near is None:
            found = self._core.branches(_flat(pose)).reshape(-1, 8, 6)
        else:
            found = self._core.nearest(_flat(pose), _flat(_array("near", near, (6,))[0]))
        return found[0] if alone else found

    def __repr__(self) -> str:
        return f"<Robot {self.name}>"
