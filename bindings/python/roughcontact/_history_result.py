"""Answers of a loading history."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Iterator, List, Optional, Tuple, Union, overload

import numpy as np
from numpy.typing import NDArray

from ._answers import Answer
from ._arrays import Doubles
from ._measures import STEP_COLUMNS
from ._pictures import curve
from ._status import Status
from .result import Grid, Result


@dataclass(frozen=True, eq=False, repr=False)
class HistoryResult(Answer):
    """Answers of a loading history: a sequence of one `Result` for each completed step. All columns of its tables are arrays with
    one value for each of these steps, such as history.load, history.area_fraction and history.contact_crosses.

    prescribed: "approach", "load", "pressure" or "area"
    targets: its values as given, those of steps that were not completed as well
    results: of the steps, without maps
    pressure: [steps, ny, nx] [force/length^2]; None unless asked for
    time: of the steps, as given; None: none were
    """

    status: Status
    message: str
    prescribed: str
    targets: Doubles
    results: Tuple[Result, ...]
    pressure: Optional[Doubles]
    grid: Grid
    time: Optional[Doubles] = None

    @property
    def assumed(self) -> Tuple[str, ...]:
        """As of a `Result`."""
        return self.results[0].assumed if self.results else ()

    @property
    def completed(self) -> int:
        """Steps that were completed."""
        return len(self.results)

    @property
    def load(self) -> Doubles:
        """[force]"""
        return self._each("load")

    @property
    def approach(self) -> Doubles:
        """[length]"""
        return self._each("approach")

    @property
    def contact_area(self) -> Doubles:
        """[length^2]"""
        return self._each("contact_area")

    @property
    def stiffness(self) -> Doubles:
        """dW/dd [force/length]; NaN unless asked for"""
        return self._each("stiffness")

    @property
    def certificate(self) -> Doubles:
        """The largest residual of each step."""
        return np.array([each.residual for each in self.results], float)

    def __getattr__(self, name: str) -> Any:
        if name in STEP_COLUMNS:
            return self._each(name)
        raise AttributeError(f"a HistoryResult has no attribute {name!r}")

    def _each(self, name: str) -> NDArray[Any]:
        return np.array([each._columns()[name] for each in self.results], None if self.results else float)

    def __len__(self) -> int:
        return self.completed

    @overload
    def __getitem__(self, index: int) -> Result: ...
    @overload
    def __getitem__(self, index: slice) -> List[Result]: ...
    def __getitem__(self, index: Union[int, slice]) -> Union[Result, List[Result]]:
        if isinstance(index, slice):
            return [self[k] for k in range(len(self))[index]]
        at = range(len(self))[index]
        return self.results[at] if self.pressure is None else self.results[at]._with(pressure=self.pressure[at])

    def __iter__(self) -> Iterator[Result]:
        return (self[k] for k in range(len(self)))

    steps = ("step",)

    def _counts(self) -> Tuple[int, ...]:
        return (self.completed,)

    def _columns(self) -> Dict[str, Any]:
        rows = [each._columns() for each in self.results]
        found = {name: np.array([row[name] for row in rows]) for name in (rows[0] if rows else STEP_COLUMNS)}
        if self.prescribed in ("pressure", "area"):
            found = {self.prescribed: self.targets[: self.completed], **found}
        return found if self.time is None else {"time": self.time, **found}

    def _rows(self) -> Dict[str, str]:
        ends = {"load": self.load, "approach": self.approach, "contact area": self.contact_area}
        return {
            "status": self.status.name,
            "steps": f"{self.completed} of {len(self.targets)}",
            **{name: f"{values.min():.6g} to {values.max():.6g}" for name, values in ends.items() if len(values)},
        }

    def _picture(self) -> Optional[str]:
        return curve(self.approach, self.load)

    def __repr__(self) -> str:
        return f"HistoryResult({self.status.name}, {self.completed} of {len(self.targets)} steps)"
