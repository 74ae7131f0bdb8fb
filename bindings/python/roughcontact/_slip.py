"""Slip of a rough patch under friction, from its contact law."""

from __future__ import annotations

from typing import Any, Callable, NamedTuple, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import ArrayLike

from . import plot
from ._arrays import Doubles, as_doubles, pointer
from ._calls import check
from ._errors import ArgumentError
from ._library import contact_library
from ._structs import rc_law_slip_state


class ShearBounds(NamedTuple):
    """Two arrays, between which the exact shears of the uncoupled model lie."""

    lower: Doubles
    upper: Doubles


class SlipState:
    """A patch between the steps of a host: `step` returns the next state, and this one stays as it is.

    p, slope: nominal pressure, dp/dx; shear: both components; shear_by_x, shear_by_slip: the tangent of the step; dissipated: by
    friction, per nominal area; joined: see `rc_law_slip`
    """

    def __init__(self, law: Any, struct: rc_law_slip_state) -> None:
        self._law, self._struct = law, struct
        self.p, self.slope, self.dissipated, self.joined = struct.p, struct.slope, struct.dissipated, struct.joined
        self.shear, self.shear_by_x = np.array(struct.shear), np.array(struct.shear_by_x)
        self.shear_by_slip = np.array(struct.shear_by_slip).reshape(2, 2)

    def step(self, x: float, slip: Sequence[float] = (0, 0)) -> SlipState:
        """The state at the overclosure x, after the slip (two components) in the step."""
        after, both = rc_law_slip_state(), np.array(slip, dtype=float)
        if both.shape != (2,):
            raise ArgumentError(f"slip has the shape {both.shape}: two components are needed")
        check(contact_library().rc_law_slip(self._law._handle, self._struct, float(x), pointer(both), after))
        return SlipState(self._law, after)

    def bounds(self) -> ShearBounds:
        """Bounds of both components of the shear."""
        lower, upper = np.empty(2), np.empty(2)
        check(contact_library().rc_law_slip_bounds(self._law._handle, self._struct, pointer(lower), pointer(upper)))
        return ShearBounds(lower, upper)


class Slip:
    """Slip of a law: call it with slips and nominal pressures, both numbers or arrays, for the shear at first loading.

    mu: coefficient of friction; nu: Poisson's ratio of both bodies
    """

    def __init__(self, law: Any, mu: float, nu: float) -> None:
        self.law, self.mu, self.nu = law, float(mu), float(nu)
        self.rest.step(0)  # refuses bad numbers

    @property
    def rest(self) -> SlipState:
        """Before first touch."""
        struct = rc_law_slip_state()
        struct.mu, struct.nu = self.mu, self.nu
        return SlipState(self.law, struct)

    def __call__(self, slip: ArrayLike, pressure: ArrayLike) -> Any:
        """Shear traction [force/length^2]"""
        return self._first(slip, pressure, lambda state: state.shear[0])

    def stiffness(self, slip: ArrayLike, pressure: ArrayLike) -> Any:
        """Its derivative by the slip [force/length^3]"""
        return self._first(slip, pressure, lambda state: state.shear_by_slip[0, 0])

    def bounds(self, slip: ArrayLike, pressure: ArrayLike) -> ShearBounds:
        """Bounds of the shear, at the overclosure that the law has at the pressure."""
        return ShearBounds(
            self._first(slip, pressure, lambda state: state.bounds().lower[0]),
            self._first(slip, pressure, lambda state: state.bounds().upper[0]),
        )

    def sliding_slip(self, pressure: ArrayLike) -> Any:
        """The slip from which on the whole patch slides."""
        return self.mu * (2 - self.nu) / (2 - 2 * self.nu) * self.law.overclosure(pressure)

    def loop(self, amplitude: float, pressure: float, points: int = 100) -> Tuple[Doubles, Doubles]:
        """Slips and shears along three branches, each of so many points: first loading to the amplitude, unloading, reloading."""
        x, up = float(self.law.overclosure(pressure)), np.linspace(0, 1, points)
        slips = amplitude * np.concatenate([up, 1 - 2 * up, 2 * up - 1])
        state, before, shears = self.rest.step(x), 0.0, []
        for slip in slips.tolist():
            state, before = state.step(x, (float(slip - before), 0)), slip
            shears.append(state.shear[0])
        return slips, np.array(shears)

    def dissipated(self, amplitude: float, pressure: float) -> float:
        """Energy that a cycle of this amplitude dissipates, per nominal area [force/length]."""
        x = float(self.law.overclosure(pressure))
        turned = self.rest.step(x).step(x, (amplitude, 0))
        return float(turned.step(x, (-2 * amplitude, 0)).step(x, (2 * amplitude, 0)).dissipated - turned.dissipated)

    def _first(self, slip: ArrayLike, pressure: ArrayLike, of: Callable[[SlipState], float]) -> Any:
        slips, pressures = np.broadcast_arrays(as_doubles(slip, "slip"), as_doubles(pressure, "pressure"))
        if np.any((slips != 0) & (pressures <= 0)):
            raise ArgumentError("slip before contact: where slip is not 0, pressure must be positive")
        found = np.empty(slips.shape)
        for i, x in np.ndenumerate(np.asarray(self.law.overclosure(pressures), dtype=float)):
            found[i] = of(self.rest.step(float(x)).step(float(x), (float(slips[i]), 0)))
        return found[()]

    def plot(self, pressure: Optional[float] = None, **how: Any) -> Any:
        """`roughcontact.plot.slip` of this slip."""
        return plot.slip(self, pressure, **how)
