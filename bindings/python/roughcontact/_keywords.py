"""What several functions take: options by their names, and one of approach, load, mean pressure and contact area."""

from __future__ import annotations

import difflib
import inspect
from dataclasses import dataclass
from typing import Any, Callable, Dict, Mapping, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _constants
from ._elastic import refuse_text
from ._errors import ArgumentError
from ._units import metres_of
from .context import Context, Options, options as all_options
from .system import System

#: words of the field that are no keywords, and the keywords that mean the same
_SAME = {
    "force": "load",
    "displacement": "approach",
    "indentation": "approach",
    "young": "E",
    "poisson": "nu",
    "method": "solver",
}


def options_of(
    function: Callable[..., Any], given: Options, keywords: Mapping[str, Any], context: Optional[Context]
) -> Options:
    """given and the options among the keywords, whose names have '_' for '.' and '-'; None stands for an option that is not given.

    function: whose keywords they are; the nearest one is named where a keyword is none
    """
    chosen: Dict[str, Any] = dict(given or {})
    if not keywords:
        return given
    keys = {spec.key.replace(".", "_").replace("-", "_"): spec.key for spec in all_options(context)}
    for name, value in keywords.items():
        if name not in keys:
            known = [*inspect.signature(function).parameters, *keys]
            begun = (
                [name]
                if name in _SAME
                else [each for each in known if len(each) > 2 and (name.startswith(each) or each.startswith(name))]
            )
            near = begun or difflib.get_close_matches(name, [*_SAME, *known], 1, 0.5)
            hint = f"; did you mean {_SAME.get(near[0], near[0])!r}?" if near else "; see roughcontact.options()"
            raise TypeError(f"{function.__name__}() got an unexpected keyword argument {name!r}{hint}")
        if keys[name] in chosen:
            raise ArgumentError(f"{name} is given twice, as a keyword and in options")
        if value is not None:
            chosen[keys[name]] = value
    return chosen


@dataclass(frozen=True)
class Prescribed:
    """What presses: name: "approach", "load", "pressure" or "area"; given: its values; control, targets: the same as C has it."""

    name: str
    given: Any
    control: int
    targets: Any

    def target(self) -> float:
        """The value of a call that solves one step."""
        if np.size(self.given) != 1:
            raise ArgumentError(
                f"{self.name} has {np.size(self.given)} values, and this call solves one step; roughcontact.history and "
                "Contact.history solve one step for each"
            )
        return float(np.ravel(self.targets)[0])


def prescribed(system: System, **ways: Optional[ArrayLike]) -> Prescribed:
    """The one that is given of approach, load, mean pressure and contact area, which is a share of the grid's."""
    refuse_text(**ways)
    found = [name for name, value in ways.items() if value is not None]
    if len(found) != 1:
        which = f"{' and '.join(found)} are {'both' if len(found) == 2 else 'all'} given" if found else "nothing presses"
        raise ArgumentError(f"{which}: one of {', '.join(ways)} is needed")
    name, given = found[0], ways[found[0]]
    targets = given
    if name == "area":
        shares = np.asarray(given, float)
        if np.any(shares > 1):
            raise ArgumentError(f"area is {float(np.max(shares)):g}: a share of the grid's area is needed, 0.05 for 5 %")
        targets = shares * (float(np.prod(system.shape)) * system.pitch[0] * system.pitch[1])
    return Prescribed(name, given, getattr(_constants, f"RC_CONTROL_{name.upper()}"), targets)


def in_metres(lengths: Optional[ArrayLike], unit: Optional[str]) -> Any:
    """Lengths as they are if no unit is given for them."""
    if lengths is None or unit is None:
        return lengths
    refuse_text(approach=lengths)
    return np.asarray(lengths, float) * metres_of(unit)


def refuse_two_sources(heights: Any, undeformed_gap: Any, system: Optional[System], **given: Any) -> None:
    """Unless there is one of heights and gap, and nothing beside a system that it has."""
    if (heights is None) == (undeformed_gap is None):
        raise ArgumentError(
            f"{'both are' if heights is not None else 'neither is'} given: one of heights, undeformed_gap is needed"
        )
    twice = [name for name, value in given.items() if value is not None]
    if system is not None and twice:
        raise ArgumentError(f"{', '.join(twice)} and system are both given; the system has them")
