"""A surface as the words of `solve` prepare it."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, Optional

from numpy.typing import ArrayLike

from . import _constants
from ._calls import short_traceback
from ._errors import ArgumentError
from ._height_map import Surface
from ._keywords import documented, split_words
from ._pressed import pressed


@documented
@short_traceback
def prepare(heights: Any, *, mask: Optional[ArrayLike] = None, **words: Any) -> Surface:
    """The surface that `solve` presses, to be analysed, drawn or saved; `remarks` says what was assumed and done.

    heights, mask: as in `solve`

    Words that describe a surface, as in `solve`; those of bodies, loads and methods are refused:
    """
    given, options = split_words(prepare, None, words, None)
    if options:
        raise ArgumentError(f"{next(iter(options))} is an option of the library, and nothing is solved")
    what = pressed(_constants.RC_CALL_ANALYZE, heights, None, mask, None, given)
    if given.get("boundary") is None:
        return what.surface()
    if isinstance(what.system.periodic, str):
        raise ArgumentError(f"boundary is {given['boundary']!r}: a surface repeats along both axes or none")
    return replace(what.surface(), periodic=what.system.periodic)
