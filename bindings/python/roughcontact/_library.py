"""Finds and loads libroughcontact, and libroughcontact-surface, -formats, -flow, -request and -mpi.

libroughcontact, the first of these that exists:
  1. the file that the environment variable ROUGHCONTACT_LIBRARY names; nothing else is tried then
  2. the one inside this package, where it was installed from a wheel
  3. the one that was installed with this package: library_folder.txt has its folder, relative to the package
  4. the system's, by its name alone, as the dynamic loader finds it
The others are looked for beside libroughcontact, then by their name, when a function of them is first called: programs that
only solve contacts load neither the GNU Scientific Library, CHOLMOD nor what files are read with.
"""

import ctypes
import os
import pathlib
import sys
import threading
from typing import Any, Dict, List, Tuple, cast

from ._c import prototypes
from ._constants import RC_ABI
from ._errors import LibraryNotFoundError
from ._functions import ContactFunctions, FlowFunctions, FormatsFunctions, MpiFunctions, RequestFunctions, SurfaceFunctions

VARIABLE = "ROUGHCONTACT_LIBRARY"
GPL = "roughcontact-gpl"  # the distribution that adds what links libraries under the GPL to a wheel
UNDER_GPL = ("surface", "flow")


def _name_of(library: str, system: str = sys.platform) -> str:
    """What the loader of a system calls a library of ours."""
    if system == "win32":
        return f"lib{library}-{RC_ABI}.dll"
    return f"lib{library}.{RC_ABI}.dylib" if system == "darwin" else f"lib{library}.so.{RC_ABI}"


SONAME = _name_of("roughcontact")

_lock = threading.RLock()  # a signal handler may ask while its own thread loads
_loaded: Dict[str, Any] = {}


def _candidates() -> List[Tuple[str, str]]:
    """(file or SONAME, where that comes from)."""
    named = os.environ.get(VARIABLE)
    if named:
        return [(os.path.abspath(named), f"the environment variable {VARIABLE}")]
    package = pathlib.Path(__file__).resolve().parent
    places = [(package / "lib" / SONAME, "this package")]
    way = package / "library_folder.txt"
    if way.exists():
        places.append(((package / way.read_text(encoding="utf-8").strip() / SONAME).resolve(), "the same installation"))
    return [(str(file), origin) for file, origin in places if file.exists()] + [(SONAME, "the system")]


def _open(candidates: List[Tuple[str, str]], functions: type) -> Tuple[Any, str]:
    reasons = []
    for file, origin in candidates:
        try:
            library = ctypes.CDLL(file)
        except OSError as error:
            reasons.append(f"{error} ({origin})")
            continue
        for name, result, arguments in prototypes(functions):
            try:
                function = getattr(library, name)
            except AttributeError:
                raise LibraryNotFoundError(
                    f"{file} ({origin}) has no function {name}: it does not belong to this version of the "
                    "package; install both from one source"
                ) from None
            function.restype, function.argtypes = result, arguments
        return library, file
    raise LibraryNotFoundError(f"{'; '.join(reasons)}; install the library or name its file in {VARIABLE}")


def _file_of(library: Any, fallback: str) -> str:
    """The file a library was loaded from: Windows says it of the library, others of the address of a function."""
    if os.name == "nt":
        path = ctypes.create_unicode_buffer(32768)
        loader = ctypes.windll.kernel32  # type: ignore[attr-defined]
        length = loader.GetModuleFileNameW(ctypes.c_void_p(library._handle), path, len(path))
        return path.value if length else fallback

    class Information(ctypes.Structure):
        _fields_ = [("file", ctypes.c_char_p), ("base", ctypes.c_void_p), ("name", ctypes.c_char_p), ("at", ctypes.c_void_p)]

    found = Information()
    try:
        dladdr = ctypes.CDLL(None).dladdr
    except (OSError, AttributeError):
        return fallback
    dladdr.argtypes = [ctypes.c_void_p, ctypes.POINTER(Information)]
    if dladdr(ctypes.cast(library.rc_version, ctypes.c_void_p), ctypes.byref(found)) and found.file:
        return os.path.abspath(os.fsdecode(found.file))
    return fallback


def contact_library() -> ContactFunctions:
    """libroughcontact with the prototypes of all its functions."""
    if "contact" in _loaded:
        return cast(ContactFunctions, _loaded["contact"])
    with _lock:
        if "contact" not in _loaded:
            library, file = _open(_candidates(), ContactFunctions)
            abi = ctypes.c_int32()
            library.rc_version(None, None, None, ctypes.byref(abi))
            if abi.value != RC_ABI:
                raise LibraryNotFoundError(
                    f"{file} has ABI {abi.value}, this package needs {RC_ABI}; install both from one source"
                )
            _loaded["file"] = _file_of(library, file)
            _loaded["contact"] = library
        return cast(ContactFunctions, _loaded["contact"])


def library_file() -> str:
    """Path of the libroughcontact in use."""
    contact_library()
    return str(_loaded["file"])


def _from_wheel() -> bool:
    return pathlib.Path(library_file()).resolve().parent == pathlib.Path(__file__).resolve().parent / "lib"


def _beside(name: str, functions: type) -> Any:
    """libroughcontact-NAME with the prototypes of all its functions."""
    soname = _name_of(f"roughcontact-{name}")
    beside = os.path.join(os.path.dirname(library_file()), soname)
    with _lock:
        if name not in _loaded:
            candidates = [(beside, "beside libroughcontact")] if os.path.exists(beside) else []
            try:
                _loaded[name], _ = _open(candidates + [(soname, "the system")], functions)
            except LibraryNotFoundError:
                if name not in UNDER_GPL or candidates or not _from_wheel():
                    raise
                raise LibraryNotFoundError(
                    f"this needs libroughcontact-{name}, which is under the GPL and a distribution of its own: pip install {GPL}"
                ) from None
        return _loaded[name]


def surface_library() -> SurfaceFunctions:
    """libroughcontact-surface."""
    return cast(SurfaceFunctions, _beside("surface", SurfaceFunctions))


def formats_library() -> FormatsFunctions:
    """libroughcontact-formats."""
    return cast(FormatsFunctions, _beside("formats", FormatsFunctions))


def flow_library() -> FlowFunctions:
    """libroughcontact-flow."""
    return cast(FlowFunctions, _beside("flow", FlowFunctions))


def request_library() -> RequestFunctions:
    """libroughcontact-request."""
    return cast(RequestFunctions, _loaded["request"] if "request" in _loaded else _beside("request", RequestFunctions))


def mpi_library() -> MpiFunctions:
    """libroughcontact-mpi. MPI must be initialised: its own library is then there."""
    return cast(MpiFunctions, _beside("mpi", MpiFunctions))
