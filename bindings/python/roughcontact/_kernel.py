"""Kernels from Python functions: the part of plugin.h that they need, by hand, since the other bindings have no use for it."""

import ctypes
from typing import Any, Callable, List, Tuple

import numpy as np
from numpy.typing import ArrayLike

from . import _constants
from ._arrays import Doubles, as_doubles, as_text
from ._c import *  # noqa: F403
from ._calls import check
from ._library import contact_library
from ._structs import rc_system

Symbol = Callable[[Doubles, Doubles], ArrayLike]
PERIODIC, ABI_MAJOR, ABI_MINOR = 2, 1, 0  # RC_KERNEL_PERIODIC, RC_PLUGIN_ABI_MAJOR, RC_PLUGIN_ABI_MINOR

_fail = callback(rc_status, handle, rc_status, text)
_system = ctypes.POINTER(rc_system)


@struct
class rc_host(Sized):
    """Its first members."""

    members = "size_t struct_size; uint32_t abi_major abi_minor; _fail fail"


@struct
class rc_kernel_spec(Sized):
    members = "size_t struct_size; handle kernel; _system system; handle options; double length modulus"


_symbol = callback(rc_status, rc_host, rc_kernel_spec, doubles)


@struct
class rc_kernel(Sized):
    members = """size_t struct_size; text name summary license; uint64_t caps; int64_t n_options; handle options window;
    _symbol symbol; handle bounds user"""


_kernels = ctypes.POINTER(ctypes.POINTER(rc_kernel))


@struct
class rc_plugin(Sized):
    members = """size_t struct_size; uint32_t abi_major abi_minor; text name version; 
    int64_t n_backends n_solvers n_kernels; handle backends solvers; _kernels kernels"""


_registered: List[Any] = []  # the library may look at them as long as the process lives


def _waves(system: rc_system, length: float) -> Tuple[Doubles, Doubles]:
    """Wave numbers of the grid [1/length], each with the shape of the symbol."""
    along = [2 * np.pi * np.arange(n // 2 + 1) / (n * h * length) for n, h in ((system.nx, system.hx), (system.ny, system.hy))]
    qx, qy = np.meshgrid(*along)
    return qx, qy


def register(context: Any, name: str, symbol: Symbol, summary: str) -> None:
    """Adds the kernel to a context of C's."""
    known, said = as_text(name, "name"), as_text(summary, "summary")

    def call(host: Any, spec: Any, out: Any) -> int:
        try:
            qx, qy = _waves(spec.contents.system.contents, spec.contents.length)
            with np.errstate(divide="ignore", invalid="ignore"):  # at the mean, which is not looked at
                found = as_doubles(symbol(qx, qy), "the symbol", qx.shape)
            np.ctypeslib.as_array(out, (qx.size,)).reshape(qx.shape)[...] = found / spec.contents.length
            return 0
        except BaseException as error:  # nothing may pass through C
            said_by = f"kernel {name}: {type(error).__name__}: {error}"
            return int(host.contents.fail(host, _constants.RC_ERR_EXTERNAL, said_by.encode(errors="replace")))

    kernel = rc_kernel()
    kernel.name, kernel.summary, kernel.license = known, said, b""
    kernel.caps, kernel.symbol = PERIODIC, _symbol(call)
    kernels = (ctypes.POINTER(rc_kernel) * 1)(ctypes.pointer(kernel))
    plugin = rc_plugin()
    plugin.abi_major, plugin.abi_minor, plugin.name, plugin.version = ABI_MAJOR, ABI_MINOR, known, b""
    plugin.n_kernels, plugin.kernels = 1, kernels
    check(contact_library().rc_context_register(context, ctypes.byref(plugin)))
    _registered.append((kernel, kernels, plugin))
