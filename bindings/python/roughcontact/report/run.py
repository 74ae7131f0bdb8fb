"""The folder that a report is of: one that `roughcontact solve --out` has written, or that it writes now."""

import argparse
import pathlib
import re
import subprocess
from contextlib import contextmanager
from tempfile import TemporaryDirectory
from typing import Iterator, List, NoReturn, Optional, Sequence, Tuple

from .._command import program
from .._errors import ArgumentError

CURVE_POINTS, CURVE_SPAN = 10, 100  # of the history up to a single target, and how far below that it begins
LOADING = ("--approach", "--load", "--pressure", "--area")
IN_TIME = ("--creep", "--relaxation", "--time", "--steps")  # with these the steps are as given


class SolveFailed(Exception):
    """The command has said why; code: its exit status."""

    def __init__(self, code: int) -> None:
        super().__init__(code)
        self.code = code


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise ArgumentError(message)


def read_arguments(arguments: Sequence[str]) -> Tuple[argparse.Namespace, List[str]]:
    """(what the page is, the folder or the arguments of `roughcontact solve`)"""
    made = Parser(
        prog="roughcontact report",
        usage="%(prog)s FOLDER | SURFACE [words of roughcontact solve] [--out PAGE] [--law FILE]",
        description="One page that tells what was found, how sure it is, and what was assumed: of the folder that roughcontact solve "
        f"--out has written, or of the surface, which is then solved. One target becomes the last of {CURVE_POINTS} steps.",
        epilog="Exit status: 0 every step is certified, 1 wrong input, 2 the page is written but a step is not certified.",
        allow_abbrev=False,
    )
    made.add_argument("--out", default="report.html", metavar="PAGE", help="the page to write (report.html)")
    made.add_argument("--law", metavar="FILE", help="show this contact law of the surface, in m and N, see roughcontact law")
    asked, words = made.parse_known_args(arguments)
    if not words:
        made.error("give the folder of roughcontact solve --out, or a surface file and the words of solve; see --help")
    return asked, words


def _steps_to(target: str) -> Optional[str]:
    """A range that ends at a single target above 0; None for several targets."""
    found = re.fullmatch(r"\s*([\d.]+(?:[eE][-+]?\d+)?)\s*([^\d\s.,:;+-][^\d,:]*)?\s*", target)
    if found is None or float(found[1]) == 0:
        return None
    unit = found[2] or ""
    return f"{float(found[1]) / CURVE_SPAN!r}{unit}..{found[1]}{unit}:{CURVE_POINTS}log"


def with_curve(words: Sequence[str]) -> Tuple[List[str], bool]:
    """The words with steps up to a single target, and whether these were added."""
    found = list(words)
    if any(word.partition("=")[0] in IN_TIME for word in words):
        return found, False
    for k, word in enumerate(words):
        name, joined, value = word.partition("=")
        if name not in LOADING or not (joined or k + 1 < len(words)):
            continue
        steps = _steps_to(value if joined else words[k + 1])
        if steps is not None:
            found[k : k + 1 if joined else k + 2] = [name, steps]
            return found, True
    return found, False


@contextmanager
def run_of(words: Sequence[str]) -> Iterator[Tuple[pathlib.Path, bool]]:
    """(the folder with the answers, whether steps were added for the curves); one that is made here lasts only so long."""
    if len(words) == 1 and pathlib.Path(words[0]).is_dir():
        yield pathlib.Path(words[0]), False
        return
    command = program()
    if command is None:
        raise ArgumentError("the command roughcontact, which solves, is not installed beside this Python package")
    with TemporaryDirectory() as folder:
        asked, curve = with_curve(words)
        done = subprocess.run([command, "solve", *asked, "--out", folder, "--quiet", "--no-pictures"], check=False)
        if done.returncode not in (0, 2):
            raise SolveFailed(done.returncode)
        yield pathlib.Path(folder), curve
