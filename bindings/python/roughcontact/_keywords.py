"""What several functions take: words, and options by their names."""

from __future__ import annotations

import difflib
import functools
import inspect
import textwrap
from typing import Any, Callable, Dict, Mapping, Optional, Tuple, TypeVar

from ._errors import ArgumentError
from ._words import HELP
from .context import Context, Options, option_count, options as all_options

F = TypeVar("F", bound=Callable[..., Any])

#: words of the field that are no keywords, and the keywords that mean the same
_SAME = {
    "force": "load",
    "displacement": "approach",
    "indentation": "approach",
    "young": "E",
    "poisson": "nu",
    "method": "solver",
}


def _keys(context: Optional[Context]) -> Dict[str, str]:
    """Keys of options by their keywords."""
    return {spec.key.replace(".", "_").replace("-", "_"): spec.key for spec in all_options(context)}


@functools.lru_cache(maxsize=1)
def _default_keys(_: int) -> Dict[str, str]:
    """Those of the default context, as long as it has the same number of options."""
    return _keys(None)


def options_of(
    function: Callable[..., Any], given: Options, keywords: Mapping[str, Any], context: Optional[Context]
) -> Options:
    """given and the options among the keywords, whose names have '_' for '.' and '-'; None stands for an option that is not given.

    function: whose keywords they are; the nearest one is named where a keyword is none
    """
    chosen: Dict[str, Any] = dict(given or {})
    if not keywords:
        return given
    keys = _keys(context) if context else _default_keys(option_count())
    for name, value in keywords.items():
        if name not in keys:
            known = [*inspect.signature(function).parameters, *HELP, *keys]
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


def split_words(
    function: Callable[..., Any], given: Options, keywords: Mapping[str, Any], context: Optional[Context]
) -> Tuple[Dict[str, Any], Options]:
    """(words, options) of a call."""
    words = {name: value for name, value in keywords.items() if name in HELP}
    return words, options_of(function, given, {name: value for name, value in keywords.items() if name not in HELP}, context)


def documented(function: F) -> F:
    """function, with the words in its docstring."""
    if function.__doc__:
        lines = [f"{name}: {form}. {text}" for name, (form, text) in HELP.items()]
        wrapped = [textwrap.fill(line, 120, subsequent_indent="    ") for line in lines]
        function.__doc__ = "\n".join([inspect.cleandoc(function.__doc__), "", *wrapped])
    return function
