"""Starts the command `roughcontact`, which is a program of its own, and the reports, which are Python.

The script of a wheel runs this file without the package around it, so that the command does not wait for NumPy.
"""

import os
import pathlib
import shutil
import subprocess
import sys
from typing import Iterator, List, Optional

SUFFIX = ".exe" if os.name == "nt" else ""


def _places() -> Iterator[pathlib.Path]:
    """Inside a wheel, that of roughcontact-gpl first; of the build or prefix that the library is from; of the package's prefix; on the PATH."""
    here = pathlib.Path(__file__).resolve()
    for name in ("roughcontact-command-gpl", "roughcontact-command"):
        yield here.parent / "lib" / f"{name}{SUFFIX}"
    named = os.environ.get("ROUGHCONTACT_LIBRARY")
    if named:
        yield pathlib.Path(named).resolve().parent.parent / "bin" / f"roughcontact{SUFFIX}"
    if len(here.parents) > 4:
        yield here.parents[4] / "bin" / f"roughcontact{SUFFIX}"
    found = shutil.which("roughcontact")
    if found:
        yield pathlib.Path(found)


def _is_program(file: pathlib.Path) -> bool:
    """Not a script, which would start this one again."""
    if not file.is_file():
        return False
    with open(file, "rb") as stream:
        return stream.read(2) != b"#!"


def program() -> Optional[str]:
    return next((str(file) for file in _places() if _is_program(file)), None)


def run(words: List[str]) -> int:
    """The command with these words; returns only if it could not take this process's place."""
    found = program()
    if found is None:
        print(
            "roughcontact: the command is not installed beside this Python package; `report` needs no command", file=sys.stderr
        )
        return 1
    if os.name == "nt":
        return subprocess.call([found, *words])
    os.execv(found, ["roughcontact", *words])


def main(words: List[str]) -> int:
    if words and words[0] not in ("report", "-h", "--help"):
        return run(words)
    from roughcontact.report.command import main as report

    return report(words)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
