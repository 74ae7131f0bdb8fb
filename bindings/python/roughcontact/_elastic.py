"""The contact modulus, from what callers give."""

from __future__ import annotations

from typing import Any, Optional, Sequence, Union

import numpy as np

from ._errors import ArgumentError

Constant = Union[float, Sequence[float]]


def refuse_text(**given: Any) -> None:
    for name, value in given.items():
        if isinstance(value, str):
            raise ArgumentError(f"{name} = {value!r} is a text; give a number, such as 3e9 for 3 GPa if lengths are in m")


def modulus_of(modulus: Optional[float], E: Optional[Constant], nu: Optional[Constant]) -> Optional[float]:
    """The contact modulus E*, given, or 1/((1-nu1^2)/E1 + (1-nu2^2)/E2) of two bodies; of one, the other being rigid."""
    refuse_text(modulus=modulus, E=E, nu=nu)
    if E is None and nu is None:
        return modulus
    if modulus is not None:
        raise ArgumentError("modulus and E or nu are both given; modulus is E*, and E with nu makes it")
    if E is None or nu is None:
        raise ArgumentError(f"{'E' if E is None else 'nu'} is missing: E and nu go together")
    young, poisson = np.atleast_1d(np.asarray(E, float)), np.atleast_1d(np.asarray(nu, float))
    if young.shape != poisson.shape or young.ndim != 1 or len(young) > 2:
        raise ArgumentError("E and nu are one number each, or two each, of the two bodies")
    if not (np.isfinite(young).all() and (young > 0).all()):
        raise ArgumentError(f"E = {E} must be positive and finite [force/length^2]")
    if not ((poisson > -1) & (poisson <= 0.5)).all():
        raise ArgumentError(f"nu = {nu} is not in (-1, 0.5]")
    return float(1 / ((1 - poisson**2) / young).sum())


def needed_modulus(modulus: Optional[float], E: Optional[Constant], nu: Optional[Constant], more: str = "") -> float:
    """The same, which must be given; more: what else would do."""
    found = modulus_of(modulus, E, nu)
    if found is None:
        raise ArgumentError(f"modulus is missing: the contact modulus E*, or E and nu{more}")
    return found
