"""Names of files, which need not be text, and the library's way to write one."""

import errno
import os
from typing import Any, Union

from ._calls import check, of_a_file
from ._errors import ArgumentError
from ._library import contact_library

Path = Union[str, bytes, "os.PathLike[str]", "os.PathLike[bytes]"]


def as_path(path: Path) -> bytes:
    """path as C reads it."""
    try:
        name = os.fsencode(path)
    except UnicodeEncodeError:
        raise ArgumentError(f"path is {path!r}, which is no name: it has half of a surrogate pair") from None
    if b"\0" in name:
        raise ArgumentError(f"path is {path!r}; a name with a NUL character cannot be passed on")
    return name


def shown(text: str) -> str:
    """text with marks in place of bytes that are not characters, for pages and terminals."""
    return os.fsencode(text).decode(errors="replace")


def write_file(path: Path, contents: Any) -> None:
    """As `rc_file_write`. contents: bytes."""
    name = as_path(path)
    try:
        check(contact_library().rc_file_write(name, contents, len(contents)))
    except ArgumentError as error:
        raise of_a_file(_as_python_has_it(name, str(error))) from None


def _as_python_has_it(name: bytes, message: str) -> OSError:
    folder = os.path.dirname(os.path.realpath(name))
    if os.path.isdir(name):
        code = errno.EISDIR
    elif not os.path.isdir(folder):
        code = errno.ENOENT
    elif not os.access(name if os.path.exists(name) else folder, os.W_OK, effective_ids=os.access in os.supports_effective_ids):
        code = errno.EACCES
    else:
        return OSError(message)
    return OSError(code, message.rpartition("cannot be written: ")[2], os.fsdecode(name))
