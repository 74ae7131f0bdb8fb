"""What `python -m roughcontact report` is asked for: the words of `solve`, and a few options of its own."""

import argparse
import difflib
import shlex
from typing import Any, Dict, List, NoReturn, Optional, Sequence

from .. import _constants
from .._errors import ArgumentError
from .._request import Pressed, pressed
from .._words import HELP

CURVE_POINTS, CURVE_SPAN = 10, 100.0  # of the history up to a single target, and how far below that it begins


class Request(argparse.Namespace):
    """words: as given; problem: what they mean; targets: of its loading; curve: whether only the last target was asked for, and the
    others lead up to it; material: what E* was made of, in words"""

    file: str
    out: str
    tol: Optional[float]
    accuracy: Optional[float]
    threads: Optional[int]
    law: Optional[str]
    words: Dict[str, str]
    command: str
    problem: Pressed
    targets: List[float]
    curve: bool

    @property
    def control(self) -> str:
        return self.problem.needed().name

    @property
    def modulus(self) -> float:
        found = self.problem.system.modulus
        assert found is not None
        return found

    @property
    def hardness(self) -> Optional[float]:
        return self.problem.system.hardness

    @property
    def material(self) -> str:
        if "modulus" in self.words:
            return "the contact modulus was given"
        bodies = [(self.words.get("E" + which), self.words.get("nu" + which)) for which in ("", "2")]
        told = " and ".join(f"E = {E}, \u03bd = {nu}" for E, nu in bodies if E is not None)
        return told + ("" if "E2" in self.words else "; the other body is rigid")


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise ArgumentError(message)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None


def _threads(text: str) -> int:
    if not text.isdecimal() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"{text!r} is not a whole number above 0")
    return int(text)


def parser() -> Parser:
    made = Parser(
        prog="python -m roughcontact report",
        description="Press a rough surface against a flat and write one page that tells what was found, how sure it is, and what was assumed.",
        epilog="Lengths, pressures and forces may have a unit with an SI prefix: 39nm, 210GPa, 1mN. Numbers without a unit are in m (or --unit), Pa and N. "
        "Exit status: 0 every step is certified, 1 wrong input, 2 the page is written but a step is not certified.",
        allow_abbrev=False,
    )
    made.add_argument("file", metavar="FILE", help="surface file, see roughcontact.formats()")
    made.add_argument("--out", default="report.html", metavar="PAGE", help="the page to write (report.html)")
    for name, (form, text) in HELP.items():
        made.add_argument("--" + name.replace("_", "-"), dest="word_" + name, metavar=form, help=text.replace("%", "%%"))
    made.add_argument("--tol", type=_number, metavar="TOL", help="convergence tolerance, relative (default 1e-8)")
    made.add_argument(
        "--accuracy",
        type=_number,
        metavar="GOAL",
        help="accepted relative error of the load: a coarser grid is used if its estimated error is below this",
    )
    made.add_argument("--law", metavar="FILE", help="show this contact law of the surface, in m and N, see roughcontact law")
    made.add_argument("--threads", type=_threads, metavar="N", help="number of threads (default: all cores)")
    return made


def _check_options(arguments: Sequence[str], known: Sequence[str], unknown: Sequence[str]) -> None:
    names = [word.split("=")[0] for word in arguments]
    for name in known:
        if names.count(name) > 1:
            times = "twice" if names.count(name) == 2 else f"{names.count(name)} times"
            several = ", give several steps as a,b,c" if name in ("--load", "--pressure", "--approach") else ""
            raise ArgumentError(f"{name} is given {times}{several}")
    if unknown:
        word = unknown[0].split("=")[0]
        letters = {name.lstrip("-"): name for name in known}
        near = [name for name in known if len(name) > 4 and word.startswith(name)]
        near += [letters[each] for each in difflib.get_close_matches(word.lstrip("-"), letters, 1, 0.75)]
        raise ArgumentError(f"{unknown[0]!r} is not expected" + (f"; did you mean {near[0]!r}?" if near else "; see --help"))


def read_request(arguments: Sequence[str]) -> Request:
    """Raises an ArgumentError at the first argument that is wrong; exits if help is asked for."""
    made = parser()
    asked, unknown = made.parse_known_args(arguments, Request())
    known = [name for action in made._actions for name in action.option_strings if name.startswith("--") and name != "--help"]
    _check_options(arguments, known, unknown)
    given: Dict[str, Any] = {name: getattr(asked, "word_" + name) for name in HELP}
    asked.words = {name: value for name, value in given.items() if value is not None}
    asked.command = shlex.join(["python3", "-m", "roughcontact", "report", *arguments])
    return asked


def press(asked: Request) -> None:
    """Reads the surface; one target above 0 becomes the last of a curve."""
    asked.problem = pressed(
        _constants.RC_CALL_HISTORY, asked.file, None, None, None, asked.words, spelling=_constants.RC_SPELLING_OPTION
    )
    asked.targets = asked.problem.needed().given.tolist()
    asked.curve = len(asked.targets) == 1 and asked.targets[0] > 0
    if asked.curve:
        last = CURVE_POINTS - 1
        asked.targets = [asked.targets[0] * CURVE_SPAN ** (k / last - 1) for k in range(last)] + asked.targets
