"""What one-shot functions take beside their own arguments: options by their names, elastic constants, a mean pressure."""

import difflib
import inspect
from typing import Any, Callable, Dict, Mapping, Optional, Sequence, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike

from ._errors import ArgumentError
from ._option_texts import OPTIONS
from .context import Context, Options, options as all_options
from .system import System

Constant = Union[float, Sequence[float]]
#: words of the field that are no keywords, and the keywords that mean the same
_SAME = {
    "force": "load",
    "displacement": "approach",
    "indentation": "approach",
    "young": "E",
    "poisson": "nu",
    "method": "solver",
}


F = TypeVar("F", bound=Callable[..., Any])


def lists_options(function: F) -> F:
    """Adds all options to what help() says of a function that takes them as keywords."""
    if function.__doc__:  # there is none under python -OO
        head = "\n\n    Options as keywords, with their defaults; `roughcontact.options()` lists those of this machine's plugins as well:"
        function.__doc__ = function.__doc__.rstrip() + head + "\n" + OPTIONS
    return function


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
            begun = [each for each in known if len(each) > 2 and (name.startswith(each) or each.startswith(name))]
            near = [_SAME[name]] if name in _SAME else begun or difflib.get_close_matches(name, known, 1, 0.5)
            hint = f"; did you mean {near[0]!r}?" if near else "; see roughcontact.options()"
            raise TypeError(f"{function.__name__}() got an unexpected keyword argument {name!r}{hint}")
        if keys[name] in chosen:
            raise ArgumentError(f"{name} is given twice, as a keyword and in options")
        if value is not None:
            chosen[keys[name]] = value
    return chosen


def refuse_text(**given: Any) -> None:
    for name, value in given.items():
        if isinstance(value, str):
            raise ArgumentError(f"{name} = {value!r} is a text; a number is expected, as 3e9 for 3 GPa where lengths are in m")


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


def load_of(load: Optional[ArrayLike], pressure: Optional[ArrayLike], approach: Optional[ArrayLike], system: System) -> Any:
    """load, or that of a mean pressure over the whole grid."""
    refuse_text(load=load, pressure=pressure, approach=approach)
    if pressure is None:
        return load
    for name, other in (("load", load), ("approach", approach)):
        if other is not None:
            raise ArgumentError(f"pressure and {name} are both given; exactly one of approach, load and pressure is needed")
    return np.asarray(pressure, float) * (float(np.prod(system.shape)) * system.pitch[0] * system.pitch[1])


def refuse_beside_system(**given: Any) -> None:
    twice = [name for name, value in given.items() if value is not None]
    if twice:
        raise ArgumentError(f"{', '.join(twice)} and system are both given; the system has them")
