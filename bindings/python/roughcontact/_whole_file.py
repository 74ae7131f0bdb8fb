"""Files that are whole or not there."""

import contextlib
import os
from typing import IO, Iterator


@contextlib.contextmanager
def whole_file(path: str) -> Iterator[IO[bytes]]:
    """An open file with a temporary name beside path, which it replaces at the end; nothing is left where the body raises."""
    folder, name = os.path.split(path)
    temporary = os.path.join(folder, f".{name}.{os.getpid()}.tmp")
    try:
        with open(temporary, "xb") as file:
            yield file
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(temporary)
