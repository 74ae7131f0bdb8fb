"""Derivatives of a contact's last step, see <roughcontact/derivatives.h>."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, Shape, as_doubles, given
from ._brief import brief
from ._c import members_for
from ._structs import rc_gradient, rc_tangent


@dataclass(frozen=True, eq=False, repr=False)
class Gradient:
    """Derivatives of a number J, which depends on a step's answer, by the step's data.

    gap: by each value of the undeformed gap, of the grid's shape; by a height it is the opposite, as long as the highest point
        does not move
    target: by the approach or the load; modulus: by E*, NaN if the system has none
    error: bound of the Euclidean norm of the error in gap; NaN if no bound is known
    undecided: points neither proven to be in contact nor to be open, whose derivatives are one-sided; -1: nothing is proven
    products: with H
    """

    gap: Doubles
    target: float
    modulus: float
    error: float
    undecided: int
    products: int

    __repr__ = brief


@dataclass(frozen=True, eq=False, repr=False)
class Tangent:
    """Change of a step's answer for given changes of its data.

    pressure, gap: of pressures and deformed gap, of the grid's shape; load, approach
    error: the Euclidean norm of what the solves leave wrong in pressure is at most this; undecided, products: as in `Gradient`
    """

    pressure: Doubles
    gap: Doubles
    load: float
    approach: float
    error: float
    undecided: int
    products: int

    __repr__ = brief


def optional(values: Optional[ArrayLike], name: str, shape: Shape) -> Optional[Doubles]:
    return None if values is None else as_doubles(values, name, shape)


def gradient_request(
    shape: Shape, pressure: Optional[ArrayLike], gap: Optional[ArrayLike], load: float, approach: float
) -> Tuple[rc_gradient, Doubles, Any]:
    """(struct, where it writes to, what it must not outlive)"""
    by_pressure, by_gap, out = optional(pressure, "pressure", shape), optional(gap, "gap", shape), np.zeros(shape)
    struct = given(rc_gradient(), dJ_dp=by_pressure, dJ_dgap=by_gap, dJ_dundeformed_gap=out)
    given(struct, dJ_dload=float(load), dJ_dapproach=float(approach))
    return struct, out, (by_pressure, by_gap)


def gradient_from(struct: rc_gradient, out: Doubles) -> Gradient:
    own = {"gap": out, "target": struct.dJ_dtarget, "modulus": struct.dJ_dmodulus}
    return Gradient(**{**members_for(Gradient, struct), **own})


def tangent_request(
    shape: Shape, undeformed_gap: Optional[ArrayLike], target: float, modulus: float
) -> Tuple[rc_tangent, Tuple[Doubles, Doubles], Any]:
    change, out = optional(undeformed_gap, "undeformed_gap", shape), (np.zeros(shape), np.zeros(shape))
    struct = given(rc_tangent(), dundeformed_gap=change, dp=out[0], dgap=out[1])
    given(struct, dtarget=float(target), dmodulus=float(modulus))
    return struct, out, change


def tangent_from(struct: rc_tangent, out: Tuple[Doubles, Doubles]) -> Tangent:
    own = {"pressure": out[0], "gap": out[1], "load": struct.dload, "approach": struct.dapproach}
    return Tangent(**{**members_for(Tangent, struct), **own})
