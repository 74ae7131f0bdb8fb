"""A step as a function that can be differentiated, for `roughcontact.torch` and `roughcontact.jax`."""

import threading
from typing import Any, Optional, Tuple

import numpy as np
from numpy.typing import ArrayLike

from ._arrays import Doubles, as_doubles
from ._errors import ArgumentError
from .contact import Contact
from .context import Options
from .system import HalfSpace, System

# pressures, deformed gap, load, approach
Answer = Tuple[Doubles, Doubles, float, float]


class Press:
    """Steps of one system, from any thread, one at a time; each on its surface as given, whatever was pressed before.

    system: `HalfSpace`, `Matrix` or `Product`
    control: "approach" or "load": what the target is
    mask, options: as in `Contact.solve` and `Contact`
    """

    def __init__(self, system: System, *, control: str, mask: Optional[ArrayLike] = None, options: Options = None) -> None:
        if control not in ("approach", "load"):
            raise ArgumentError(f"control is {control!r}: 'approach' or 'load'")
        self.system, self.control, self._mask, self._options = system, control, mask, options
        self._lock = threading.Lock()
        self._contact: Optional[Contact] = None
        self._modulus: Optional[float] = None
        self._solved: Optional[Tuple[Doubles, float, Optional[float]]] = None  # the contact's last step

    def __getstate__(self) -> Any:
        return {"system": self.system, "control": self.control, "mask": self._mask, "options": self._options}

    def __setstate__(self, state: Any) -> None:
        self.__init__(**state)  # type: ignore[misc]

    def solve(self, undeformed_gap: ArrayLike, target: float, modulus: Optional[float] = None) -> Answer:
        """modulus: None: the system's"""
        with self._lock:
            return self._answer(as_doubles(undeformed_gap, "undeformed_gap", self.system.shape), float(target), modulus, None)

    def pull_back(
        self,
        undeformed_gap: ArrayLike,
        target: float,
        modulus: Optional[float],
        pressure: ArrayLike,
        by: Tuple[ArrayLike, ArrayLike, float, float],
    ) -> Tuple[Doubles, float, float]:
        """Derivatives of J by gap, target and modulus, from those by pressures, deformed gap, load and approach.

        pressure: of the step, which is solved again from there where another one came after it
        """
        array = as_doubles(undeformed_gap, "undeformed_gap", self.system.shape)
        if not any(np.any(each) for each in by):  # without cotangents the contact means the load or the approach
            return np.zeros(self.system.shape), 0.0, 0.0
        with self._lock:
            if not self._is_solved(array, float(target), modulus):
                self._answer(array, float(target), modulus, pressure)
            assert self._contact is not None
            found = self._contact.gradient(by[0], by[1], load=by[2], approach=by[3])
        return found.gap, found.target, found.modulus

    def _is_solved(self, gap: Doubles, target: float, modulus: Optional[float]) -> bool:
        return (
            self._solved is not None
            and self._solved[1:] == (target, modulus)
            and np.array_equal(self._solved[0], gap, equal_nan=True)
        )

    def _answer(self, gap: Doubles, target: float, modulus: Optional[float], start: Optional[ArrayLike]) -> Answer:
        contact, self._solved = self._contact_of(modulus), None
        if self.system.hardness is not None:
            contact.reset()  # no step is to feel the plastic indentation that another one left
        step = {self.control: target}
        result = contact.solve(undeformed_gap=gap, mask=self._mask, start=start, want_gap=True, **step)  # type: ignore[arg-type]
        assert result.pressure is not None and result.gap is not None
        self._solved = gap.copy(), target, modulus
        return result.pressure, result.gap, result.load, result.approach

    def _contact_of(self, modulus: Optional[float]) -> Contact:
        if self._contact is None or modulus != self._modulus:
            system = self.system
            if modulus is not None:
                if not isinstance(system, HalfSpace):
                    raise ArgumentError("modulus is given, but the system is no HalfSpace")
                system = HalfSpace(
                    system.shape, pitch=system.pitch, modulus=float(modulus), boundary=system.boundary, hardness=system.hardness
                )
            if self._contact is not None:
                self._contact.close()
            self._contact, self._modulus = Contact(system, options=self._options), modulus
        return self._contact
