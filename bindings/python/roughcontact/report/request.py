"""What `python -m roughcontact report` is asked for: its options, checked, in SI units."""

import argparse
import difflib
import shlex
from typing import Any, List, NoReturn, Optional, Sequence, Tuple

from .._errors import ArgumentError
from .._elastic import modulus_of
from .._units import KNOWN, metres_of, metres_per
from ..system import REPEATS
from .quantities import quantities, quantity, targets

CURVE_POINTS, CURVE_SPAN = 10, 100.0  # of the history up to a single target, and how far below that it begins


class Request(argparse.Namespace):
    """control, targets: "approach", "load" or "pressure", and its values; curve: whether only the last target was asked
    for, and the others lead up to it; pitch: in `unit`; modulus: E*; material: what it was made of, in words"""

    file: str
    out: str
    format: Optional[str]
    pitch: Optional[Tuple[float, float]]
    unit: Optional[str]
    missing: str
    remove: str
    boundary: Optional[str]
    modulus: float
    material: str
    hardness: Optional[float]
    control: str
    targets: List[float]
    curve: bool
    tol: Optional[float]
    accuracy: Optional[float]
    threads: Optional[int]
    law: Optional[str]
    command: str


class Parser(argparse.ArgumentParser):
    def error(self, message: str) -> NoReturn:
        raise ArgumentError(message)


def _number(text: str) -> float:
    try:
        return float(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f"{text!r} is not a number") from None


def _unit(text: str) -> str:
    if metres_per(text) is None:
        raise argparse.ArgumentTypeError(f"{text!r} is not a length unit, give {KNOWN}")
    return text


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
    made.add_argument("--format", metavar="NAME", help="format of the file, where contents and extension do not say it")
    made.add_argument("--pitch", metavar="H or HX,HY", help="cell size, where the file does not say it")
    made.add_argument("--unit", type=_unit, help="unit of lengths without a unit (m)")
    made.add_argument("--missing", choices=["reject", "fill", "exclude"], default="reject", help="missing points")
    made.add_argument(
        "--remove", choices=["none", "mean", "plane", "quadric"], default="none", help="least-squares form to take off (none)"
    )
    made.add_argument("--boundary", choices=list(REPEATS), help="as the file says, else periodic: the map is a sample of a larger surface")
    made.add_argument("--modulus", metavar="E*", help="contact modulus, or")
    made.add_argument("--E", metavar="E", help="Young's modulus, with")
    made.add_argument("--nu", type=_number, metavar="NU", help="Poisson's ratio")
    made.add_argument("--E2", metavar="E", help="Young's modulus of the other body (default: rigid)")
    made.add_argument("--nu2", type=_number, metavar="NU", help="Poisson's ratio of the other body")
    made.add_argument("--hardness", metavar="H", help="largest pressure; above it the surface yields")
    made.add_argument("--load", metavar="TARGETS", help="normal force: one, a list a,b,c or a range a:b:n, or a:b:nlog with equal ratios; or")
    made.add_argument("--pressure", metavar="TARGETS", help="mean pressure; or")
    made.add_argument("--approach", metavar="TARGETS", help="approach from first touch")
    made.add_argument("--tol", type=_number, metavar="TOL", help="convergence tolerance, relative (default 1e-8)")
    made.add_argument(
        "--accuracy", type=_number, metavar="GOAL", help="accepted relative error of the load: a coarser grid is used if its estimated error is below this"
    )
    made.add_argument("--law", metavar="FILE", help="show this contact law of the surface, in m and N, see roughcontact law")
    made.add_argument("--threads", type=_threads, metavar="N", help="number of threads (default: all cores)")
    return made


def _elasticity(given: Any) -> Tuple[float, str]:
    """(E*, where it comes from)"""
    bodies = [[getattr(given, name) for name in names] for names in (("E", "nu"), ("E2", "nu2"))]
    if given.modulus is not None:
        if any(value is not None for body in bodies for value in body):
            raise ArgumentError("give either --modulus or --E and --nu, not both")
        return quantity("--modulus", given.modulus, "pressure"), "the contact modulus was given"
    if bodies[0] == [None, None]:
        raise ArgumentError("the elastic modulus is missing, give --modulus or --E and --nu")
    young, poisson = [], []
    for which, (E, nu) in zip(("", "2"), bodies):
        if (E is None) != (nu is None):
            raise ArgumentError(f"--E{which} and --nu{which} go together")
        if E is not None:
            young.append(quantity("--E" + which, E, "pressure"))
            poisson.append(nu)
    modulus = modulus_of(None, young, poisson)
    assert modulus is not None
    told = " and ".join(f"E = {E}, \u03bd = {nu}" for E, nu in bodies if E is not None)
    return modulus, told + ("" if len(young) == 2 else "; the other body is rigid")


def _loading(given: Any, unit: float) -> Tuple[str, List[float], bool]:
    kinds = {"approach": ("length", unit), "load": ("force", 1.0), "pressure": ("pressure", 1.0)}
    asked = [name for name in kinds if getattr(given, name) is not None]
    if not asked:
        raise ArgumentError("what to press with is missing, give --approach, --load or --pressure")
    if len(asked) > 1:
        raise ArgumentError(f"give only one of --{asked[0]} and --{asked[1]}")
    found = targets("--" + asked[0], getattr(given, asked[0]), *kinds[asked[0]])
    if len(found) > 1 or not found[0] > 0:
        return asked[0], found, False
    last = CURVE_POINTS - 1
    return asked[0], [found[0] * CURVE_SPAN ** (k / last - 1) for k in range(last)] + found, True


def _check_words(arguments: Sequence[str], known: Sequence[str], unknown: Sequence[str]) -> None:
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
    _check_words(arguments, known, unknown)
    unit = metres_of(asked.unit or "m")
    asked.modulus, asked.material = _elasticity(asked)
    asked.control, asked.targets, asked.curve = _loading(asked, unit)
    if asked.pitch is not None:
        given: Any = asked.pitch
        sides = [quantity("--pitch", text, "length", unit) / unit for text in given.split(",")]
        quantities("--pitch", given.split(","), "length", unit)
        if len(sides) > 2:
            raise ArgumentError(f"--pitch: {given!r} is neither H nor HX,HY")
        asked.pitch = (sides[0], sides[-1])
    if asked.hardness is not None:
        asked.hardness = quantity("--hardness", str(asked.hardness), "pressure")
    asked.command = shlex.join(["python3", "-m", "roughcontact", "report", *arguments])
    return asked
