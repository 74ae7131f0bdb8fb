"""Backends, solvers, kernels and options by name, in the default registry or a separate one."""

from __future__ import annotations

import ctypes
import os
import sys
import weakref
from dataclasses import dataclass
from typing import Any, Callable, Dict, Iterator, List, Mapping, Optional, Sequence, Tuple, TypeVar, Union

import numpy as np

from . import _constants
from ._arrays import Doubles, Pitch, as_pitch, as_shape, as_text, columns_and_rows, pointer
from ._c import members_for
from ._calls import check
from ._errors import OptionError
from ._kernel import Symbol, register
from ._library import contact_library
from ._paths import Path, as_path
from ._structs import rc_component, rc_log_fn
from ._use import OwnsHandle

OptionValue = Union[int, float, str]
Options = Optional[Mapping[str, OptionValue]]
T = TypeVar("T")


class Lines(List[T]):
    """A list that shows one item a line."""

    def __repr__(self) -> str:
        return "\n".join(map(str, self))


@dataclass(frozen=True)
class Component:
    """A backend, solver or kernel. license: of it with what it links (SPDX). origin: "built-in" or its file."""

    name: str
    summary: str
    license: str
    origin: str

    def __str__(self) -> str:
        return f"{self.name}: {self.summary} ({self.license}, {self.origin})"


@dataclass(frozen=True)
class OptionSpec:
    """An option: kind is int, float or str; minimum and maximum are inclusive and None for text; fixed options cannot change on
    a `Contact` that exists."""

    key: str
    kind: type
    default: OptionValue
    help: str
    choices: Optional[Tuple[str, ...]]
    fixed: bool
    minimum: Optional[float]
    maximum: Optional[float]

    def __str__(self) -> str:
        """As a keyword."""
        values = ", ".join(self.choices or ()) or ("" if self.minimum is None else f"{self.minimum:g} .. {self.maximum:g}")
        keyword = self.key.replace(".", "_").replace("-", "_")
        return f"{keyword}={self.default!r}{f' ({values})' if values else ''}: {self.help}{' (fixed)' if self.fixed else ''}"


class Context(OwnsHandle):
    """A registry of its own. `Contact` and the functions below use the default one where none is given.

    plugin_path: absolute directories that are searched first for plugins
    plugins: False: never load code from disk
    environment: False: ignore RC_PLUGIN_PATH
    log: called with (level, message), level "info" or "warning", for instance about plugins that are refused
    """

    def __init__(
        self,
        plugin_path: Union[Path, Sequence[Path]] = (),
        *,
        plugins: bool = True,
        environment: bool = True,
        log: Optional[Callable[[str, str], object]] = None,
    ) -> None:
        library = contact_library()
        flags = (0 if plugins else _constants.RC_CONTEXT_NO_PLUGINS) | (0 if environment else _constants.RC_CONTEXT_NO_ENVIRONMENT)
        folders = [plugin_path] if isinstance(plugin_path, (str, bytes, os.PathLike)) else plugin_path
        path = b":".join(map(as_path, folders)) or None
        self._log = rc_log_fn() if log is None else rc_log_fn(_guarded_log(log))
        handle = ctypes.c_void_p()
        check(library.rc_context_create(flags, path, self._log, None, handle))
        self.handle = handle
        weakref.finalize(self, library.rc_context_destroy, handle).atexit = False

    def add_kernel(self, name: str, symbol: Symbol, summary: str = "a Python function") -> None:
        """Adds a kernel for periodic boundaries, to be used with options={"kernel": name}.

        symbol: called with wave numbers qx, qy >= 0, arrays of one shape [1/length], when a contact is made and on its threads;
            returns E* times the deflection by a wave of unit pressure [length], 2 / hypot(qx, qy) for a half-space. The value at
            qx = qy = 0 is not used. An exception becomes the message of an ExternalError

        The function, all that it refers to and about 3 kB remain in memory until the process ends, even without the context: add a
        kernel once, and let it read changing parameters from an object that you keep.
        """
        register(self.handle, name, symbol, summary)


def _guarded_log(log: Callable[[str, str], object]) -> Callable[[int, bytes, Any], None]:
    def call(level: int, message: bytes, _: Any) -> None:
        try:
            log("warning" if level == _constants.RC_LOG_WARNING else "info", message.decode(errors="replace"))
        except Exception:  # as Python itself does where nobody could catch it
            sys.excepthook(*sys.exc_info())

    return call


def context_handle(context: Optional[Context]) -> Optional[ctypes.c_void_p]:
    return None if context is None else context.handle


class OptionSet(OwnsHandle):
    """Options in C's form, for the time of a with statement."""

    def __init__(self, options: Options, context: Optional[Context]) -> None:
        self._given, self._context = dict(options or {}), context
        self.handle = ctypes.c_void_p()

    def __enter__(self) -> ctypes.c_void_p:
        library = contact_library()
        check(library.rc_options_create(context_handle(self._context), self.handle))
        try:
            for key, value in self._given.items():
                self._set(library, as_text(str(key), "an option's name", OptionError), value)
        except BaseException:
            self.__exit__()
            raise
        return self.handle

    def _set(self, library: Any, key: bytes, value: OptionValue) -> None:
        if isinstance(value, str):
            check(library.rc_options_set_text(self.handle, key, as_text(value, f"option {key.decode()}", OptionError)))
        elif isinstance(value, (bool, np.bool_, int, np.integer)):
            check(library.rc_options_set_text(self.handle, key, str(int(value)).encode()))  # of any size
        elif isinstance(value, (float, np.floating)):
            check(library.rc_options_set_number(self.handle, key, float(value)))
        else:
            raise TypeError(f"option {key.decode()!r} is {type(value).__name__}; int, float or str is needed")

    def __exit__(self, *_: object) -> None:
        contact_library().rc_options_destroy(self.handle)


def _text(value: Optional[bytes]) -> str:
    return (value or b"").decode(errors="replace")


def _described(kind: int, context: Optional[Context]) -> Iterator[rc_component]:
    library, handle = contact_library(), context_handle(context)
    for i in range(library.rc_component_count(handle, kind)):
        each = rc_component()
        check(library.rc_component_describe(handle, kind, i, each))
        yield each


def _components(kind: int, context: Optional[Context]) -> List[Component]:
    return Lines(Component(**members_for(Component, each)) for each in _described(kind, context))


def backends(context: Optional[Context] = None) -> List[Component]:
    """Backends, sorted by name. The first call loads the plugins."""
    return _components(_constants.RC_COMPONENT_BACKEND, context)


def solvers(context: Optional[Context] = None) -> List[Component]:
    """Solvers, sorted by name."""
    return _components(_constants.RC_COMPONENT_SOLVER, context)


def kernels(context: Optional[Context] = None) -> List[Component]:
    """Influence kernels, sorted by name."""
    return _components(_constants.RC_COMPONENT_KERNEL, context)


def option_count() -> int:
    """In the default context."""
    return contact_library().rc_component_count(None, _constants.RC_COMPONENT_OPTION)


def options(context: Optional[Context] = None) -> List[OptionSpec]:
    """All options: the core's, then those of every component; printed, one a line, as the keywords that `solve` takes."""
    kinds: Dict[int, Any] = {_constants.RC_TYPE_INT: int, _constants.RC_TYPE_REAL: float, _constants.RC_TYPE_TEXT: str}
    found: Lines[OptionSpec] = Lines()
    for each in _described(_constants.RC_COMPONENT_OPTION, context):
        kind = kinds[each.type]
        own = {
            "key": _text(each.name),
            "help": _text(each.summary),
            "kind": kind,
            "default": kind(float(each.default_value)) if kind is int else kind(_text(each.default_value)),
            "choices": tuple(_text(each.choices).split("|")) if each.choices else None,
            "fixed": bool(each.fixed),
        }
        limits = {"minimum": None, "maximum": None} if kind is str else {}
        found.append(OptionSpec(**{**members_for(OptionSpec, each), **own, **limits}))
    return found


def _value(handle: ctypes.c_void_p, spec: OptionSpec) -> OptionValue:
    library, key = contact_library(), spec.key.encode()
    if spec.kind is str:
        text = ctypes.c_char_p()
        check(library.rc_options_get_text(handle, key, text))
        return _text(text.value)
    number = ctypes.c_double()
    check(library.rc_options_get_number(handle, key, number))
    return spec.kind(number.value)  # type: ignore[no-any-return]


def effective_options(given: Options = None, context: Optional[Context] = None) -> Mapping[str, OptionValue]:
    """The value of every option after these were set."""
    with OptionSet(given, context) as handle:
        return {spec.key: _value(handle, spec) for spec in options(context)}


def default(key: str) -> float:
    """The default of an option that is a number."""
    with OptionSet(None, None) as handle:
        number = ctypes.c_double()
        check(contact_library().rc_options_get_number(handle, key.encode(), number))
        return number.value


def version() -> Tuple[int, int, int]:
    """(major, minor, patch) of the library in use."""
    major, minor, patch = ctypes.c_int32(), ctypes.c_int32(), ctypes.c_int32()
    contact_library().rc_version(major, minor, patch, None)
    return major.value, minor.value, patch.value


def kernel_coefficients(kernel: str, shape: Union[int, Sequence[int]], pitch: Pitch) -> Doubles:
    """[ny, nx] E* times the deflection at offset (ix hx, iy hy) from a cell under unit pressure, free boundaries [length]."""
    sides, (hx, hy) = as_shape(shape), as_pitch(pitch)
    nx, ny = columns_and_rows(sides)
    out = np.empty(sides)
    check(contact_library().rc_kernel_coefficients(as_text(kernel, "kernel"), hx, hy, nx, ny, pointer(out)))
    return out
