"""Histories as sequences of steps."""

from dataclasses import dataclass
from typing import Any, Iterator, List, Optional, Union, overload

from ._arrays import Doubles


@dataclass(frozen=True, eq=False)
class Step:
    """One step of a `HistoryResult`, under the names there."""

    target: float
    load: float
    approach: float
    contact_area: float
    certificate: float
    products: int
    stiffness: Optional[float]
    pressure: Optional[Doubles]


class Steps:
    """What makes a history a sequence of `Step`."""

    def __len__(self) -> int:
        found: Any = self
        return len(found.load)

    @overload
    def __getitem__(self, index: int) -> Step: ...
    @overload
    def __getitem__(self, index: slice) -> List[Step]: ...
    def __getitem__(self, index: Union[int, slice]) -> Union[Step, List[Step]]:
        found: Any = self
        if isinstance(index, slice):
            return [self[k] for k in range(len(self))[index]]
        at = range(len(self))[index]
        members = {"target": found.targets[at]}
        for name in Step.__dataclass_fields__:
            if name != "target":
                values = getattr(found, name)
                members[name] = None if values is None else values[at]
        return Step(**members)

    def __iter__(self) -> Iterator[Step]:
        return (self[k] for k in range(len(self)))
