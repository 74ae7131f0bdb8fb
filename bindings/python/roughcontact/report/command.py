"""roughcontact report: arguments in, exit status out."""

import os
import pathlib
import sys
from typing import Sequence

from .._errors import ArgumentError, Interrupted, RoughContactError
from .._paths import shown, write_file
from .content import collect
from .page import missing_packages, page
from .run import SolveFailed, read_arguments, run_of
from .wording import conclusion

CERTIFIED, WRONG, UNCERTIFIED, INTERRUPTED = 0, 1, 2, 130  # those of the command `roughcontact`
USAGE = "usage: python -m roughcontact report FOLDER | SURFACE [words]; see python -m roughcontact report --help"


def _one_line(error: BaseException) -> str:
    return " ".join(str(error).split()) or type(error).__name__


def report(arguments: Sequence[str]) -> int:
    asked, words = read_arguments(arguments)
    absent = missing_packages()
    if absent:
        raise ArgumentError(
            f"{' and '.join(absent)} not installed, which a page is made with: pip install 'roughcontact[report]'"
        )
    out = pathlib.Path(asked.out)
    if not out.parent.is_dir():
        raise ArgumentError(f"--out: the folder {str(out.parent)!r} does not exist")
    if out.is_dir():
        raise ArgumentError(f"--out: {asked.out!r} is a folder, name the page")
    if out.exists() and any(os.path.exists(word) and os.path.samefile(out, word) for word in words):
        raise ArgumentError(f"--out: {asked.out!r} is the surface's file, name the page")
    with run_of(words) as (folder, curve):
        content = collect(folder, curve, asked.law)
    write_file(out, page(content).encode())
    print(f"{shown(asked.out)}: {conclusion(content)}")
    return CERTIFIED if content.certified else UNCERTIFIED


def main(arguments: Sequence[str]) -> int:
    try:
        if not arguments or arguments[0] in ("-h", "--help"):
            print(USAGE)
            return CERTIFIED if arguments else WRONG
        if arguments[0] != "report":
            raise ArgumentError(f"{arguments[0]!r} is no command; {USAGE}")
        return report(arguments[1:])
    except SolveFailed as error:
        return error.code
    except (RoughContactError, OSError) as error:
        print(f"roughcontact report: {_one_line(error)}", file=sys.stderr)
        return WRONG
    except (Interrupted, KeyboardInterrupt):
        print("roughcontact report: interrupted, no page is written", file=sys.stderr)
        return INTERRUPTED
