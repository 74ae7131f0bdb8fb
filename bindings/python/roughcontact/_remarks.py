"""Remarks on answers that are right and may yet mislead, in the words of the command."""

from __future__ import annotations

from ._limits import HARDNESSES, SMALL_STRAIN


def elastic_limit(max_pressure: float, modulus: float, name: str) -> str:
    """A remark on the largest pressure [Pa] of an answer without a hardness; "" if there is none. name: of the option hardness."""
    for hardness, body in HARDNESSES:
        if max_pressure > hardness:
            return f"above the hardness of {body}, this is a purely elastic answer (add {name})"
    if max_pressure > SMALL_STRAIN * modulus:
        return f"that is {max_pressure / modulus:.2g} E*, linear elasticity does not hold there (add {name})"
    return ""
