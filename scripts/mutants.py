#!/usr/bin/env python3
"""Changes the certificate and the bounds one operator at a time and requires that a test fails.

Usage: mutants.py BUILD [--jobs N] [--only TEXT] [--list] [--cover]

BUILD: a build folder of this tree with lib/libroughcontact.a (target roughcontact_static) that was configured with
-DCMAKE_UNITY_BUILD=OFF; programs of the mutants are built in BUILD/mutants. Of every file and header listed below, each comparison,
sign, product, constant, minimum, condition and single statement is changed alone, and tests/mutants must fail. scripts/switched.py
puts nearly all mutants into one program; the others are compiled one by one, and so is every unexpected survivor. Mutants that do not
compile count for nothing. Those that none of these tests can tell stand in tests/mutants/equivalents.txt, with the reason:
file | function | change, and at which of its places in the function | reason. It is an error if an entry matches no mutant, or if
a test fails on its mutant. --only: mutants whose name contains the text. --cover: chooses the figures of tests/mutants/figures.txt
anew, so that they notice each mutant that all figures notice. Exit status: 0 if none survives.
"""

import argparse
import collections
import concurrent.futures
import dataclasses
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys

import switched

ROOT = pathlib.Path(__file__).resolve().parent.parent
TESTS = ROOT / "tests/mutants"
ALL = None  # every line of the file
SOURCES = {
    "src/contact/proof/certificate.cpp": ALL,
    "src/contact/proof/bounds.cpp": ALL,
    "src/contact/proof/survey.cpp": ALL,
    "src/contact/spectrum.cpp": ALL,
    "src/kernel/lowest_eigenvalue.cpp": ALL,
    "src/contact/proof/certified.cpp": (
        "only_unknowns_matter",
        "check_definite",
        "totals_of",
        "certified_numbers",
        "write_arrays",
        "fitting_compression",
        "deflection",
        "certify_given",
    ),
    "src/contact/proof/result.cpp": ("write",),
}
# Headers, with the file that each of their functions is compiled in.
TERMS = "src/core/certificate_terms.h"
INLINE = {
    TERMS: {
        "src/contact/proof/certificate.cpp": (
            "relative_violation",
            "primal_violation",
            "room_below",
            "dual_violation",
            "complementarity_violation",
            "residual_scale",
        ),
        "src/contact/proof/certified.cpp": ("load_imbalance",),
        "src/contact/target.cpp": ("beyond_mean_plane",),
    }
}
TRAPS = ("-fsanitize=bounds", "-fsanitize-undefined-trap-on-error")  # places beyond the end of an array
TIMEOUT = 20  # seconds: a mutant that never ends is found, too
MOST_NOTICE = 3  # figures of the cover that notice a mutant, if so many do
ROUNDS = 0.003, 0.02, 0.2, 1  # shares of the sections that are left


def lines_of(text, functions):
    """Numbers of the lines that are mutated."""
    lines = text.split("\n")
    if functions is ALL:
        first = next((i for i, line in enumerate(lines) if line.startswith("namespace ")), 0)
        return range(first, len(lines))
    found = []
    for function in functions:
        begin = next(i for i, line in enumerate(lines) if f" {function}(" in line and not line.startswith(" "))
        end = next(
            i for i in range(begin, len(lines)) if lines[i].rstrip() == "}" or (i == begin and lines[i].rstrip().endswith("}"))
        )
        found.extend(range(begin, end + 1))
    return found


@dataclasses.dataclass
class Mutant:
    number: int
    file: str
    line: int  # counted from 0
    function: str
    change: switched.Change
    place: int  # among the places of this change in the function
    user: str  # the file that is compiled

    def key(self):
        return self.file, self.function, self.change.name, self.place

    def __str__(self):
        return f"{self.file} | {self.function} | {self.change.name} {self.place}"


def parts_of_certificate():
    """(file, the file that is compiled, functions) of what tests/mutants must tell."""
    parts = [(name, name, functions) for name, functions in SOURCES.items()]
    return parts + [(header, user, functions) for header, users in INLINE.items() for user, functions in users.items()]


def mutants(parts):
    number, places = 0, collections.Counter()
    for file, user, functions in parts:
        text = (ROOT / file).read_text()
        lines, names = text.split("\n"), switched.function_names(text.split("\n"))
        for i in lines_of(text, functions):
            for change in switched.changes(lines[i]):
                number += 1
                places[file, names[i], change.name] += 1
                yield Mutant(number, file, i, names[i], change, places[file, names[i], change.name], user)


def equivalents():
    """{key of a mutant: reason}"""
    entries = {}
    for line in (TESTS / "equivalents.txt").read_text().split("\n"):
        if line and not line.startswith("#"):
            file, function, change, reason = line.split(" | ")
            name, _, places = change.rpartition(" ")
            entries.update({(file, function, name, int(place)): reason for place in places.split(",")})
    return entries


class Workshop:
    """Compiles and links mutants in a folder."""

    def __init__(self, build, wanted):
        self.folder = build / "mutants"
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        self.compiler = [*os.environ.get("CXX", "g++").split(), "-std=c++20", "-w", *TRAPS]
        self.paths = [f"-I{ROOT}/include", f"-I{ROOT}/src", f"-I{ROOT}", f"-I{ROOT}/tests", f"-I{TESTS}"]
        self.library = build / "lib/libroughcontact.a"
        if not self.library.exists():
            sys.exit(f"{self.library} is missing: build it first")
        self.tests = []
        for source in sorted(TESTS.glob("*.cpp")):
            self.tests.append(self.folder / f"test_{source.stem}.o")
            subprocess.run([*self.compiler, *self.paths, "-O1", "-c", source, "-o", self.tests[-1]], check=True)
        self.figures = TESTS / "figures.txt"
        self.switched = set()  # numbers of the mutants that are in one program
        self.put_into_one_program(wanted)

    def linked(self, objects, program):
        subprocess.run(
            [self.compiler[0], *objects, *self.tests, self.library, "-ldl", "-lpthread", "-lgomp", "-o", program],
            check=True,
            capture_output=True,
        )

    def put_into_one_program(self, wanted):
        """The headers first, then all files that see them."""
        overlay, objects = self.folder / "src", []
        users = dict.fromkeys([*SOURCES, *(user for users in INLINE.values() for user in users)])
        for name in [*INLINE, *users]:
            numbered = collections.defaultdict(list)
            for mutant in wanted:
                if mutant.file == name:
                    numbered[mutant.line].append((mutant.number, mutant.change))
            path = overlay / name
            path.parent.mkdir(parents=True, exist_ok=True)
            what = ["-fsyntax-only", "-x", "c++"] if name in INLINE else ["-c", "-o", path.with_suffix(".o")]
            command = [*self.compiler, "-O1", "-Wno-narrowing", f"-I{overlay}/src", *self.paths, *what, path]

            def build():
                run = subprocess.run([*command, "-fsyntax-only"], capture_output=True, text=True)
                return [run.stderr] if run.returncode else []

            found = switched.built({path: (name, (ROOT / name).read_text(), numbered)}, build)
            if found is None:
                sys.exit(f"{name} does not compile: {' '.join(map(str, command))}")
            subprocess.run(command, check=True)
            self.switched.update(found)
            if name not in INLINE:
                objects.append(path.with_suffix(".o"))
        self.program = self.folder / "switched"
        self.linked(objects, self.program)

    def run(self, program, number, what=()):
        """Whether the program passes with a change, and what it prints."""
        try:
            run = subprocess.run(
                [program, *what, self.figures],
                capture_output=True,
                timeout=TIMEOUT,
                env={**os.environ, "RC_CHANGE": str(number)},
            )
            return run.returncode == 0, run.stdout
        except subprocess.TimeoutExpired:
            return False, b""

    def alone(self, mutant):
        """A program of one mutant; None if that does not compile."""
        stem = self.folder / f"m{mutant.number}"
        lines = (ROOT / mutant.file).read_text().split("\n")
        lines[mutant.line] = mutant.change.applied(lines[mutant.line])
        overlay = self.folder / f"only{mutant.number}"
        changed = overlay / mutant.file
        changed.parent.mkdir(parents=True, exist_ok=True)
        changed.write_text("\n".join(lines))
        source = changed if mutant.user == mutant.file else overlay / mutant.user
        if source != changed:
            source.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / mutant.user, source)
        built = subprocess.run(
            [*self.compiler, "-O0", f"-I{overlay}/src", *self.paths, "-c", source, "-o", f"{stem}.o"], capture_output=True
        )
        shutil.rmtree(overlay)
        if built.returncode != 0:
            return None
        self.linked([f"{stem}.o"], stem)
        pathlib.Path(f"{stem}.o").unlink()
        return stem

    def verdict(self, mutant, excused, what=()):
        """'killed', 'survived' or 'not built', and what its program prints."""
        if mutant.number in self.switched:
            passed, printed = self.run(self.program, mutant.number, what)
            if not passed or excused:
                return "survived" if passed else "killed", printed
        program = self.alone(mutant)
        if program is None:
            return "not built", b""
        passed, printed = self.run(program, 0, what)
        program.unlink()
        return "survived" if passed else "killed", printed


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default="")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--cover", action="store_true")
    arguments = parser.parse_args()

    wanted = [mutant for mutant in mutants(parts_of_certificate()) if arguments.only in str(mutant)]
    if arguments.list:
        for mutant in wanted:
            print(f"{mutant} | line {mutant.line + 1}")
        return 0
    excused = equivalents()
    shop = Workshop(arguments.build.resolve(), wanted)
    print(f"{len(shop.switched)} of {len(wanted)} mutants are in one program", flush=True)
    if arguments.cover:
        return cover(shop, [mutant for mutant in wanted if mutant.key() not in excused], arguments.jobs)
    if not shop.run(shop.program, 0)[0]:
        sys.exit("tests/mutants fails without any change")

    counts = {"killed": 0, "survived": 0, "not built": 0}
    wrong = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        verdicts = pool.map(lambda each: shop.verdict(each, each.key() in excused)[0], wanted)
        for mutant, verdict in zip(wanted, verdicts):
            counts[verdict] += 1
            reason = excused.pop(mutant.key(), None)
            if (verdict == "survived") != (reason is not None):
                wrong += 1
                what = "survives" if reason is None else f"is listed as equivalent, but was {verdict}"
                print(f"{mutant} | {what} (line {mutant.line + 1})", flush=True)
    if not arguments.only:
        for file, function, change, place in excused:
            wrong += 1
            print(f"{file} | {function} | {change} {place} | is listed as equivalent, but occurs no more")
    print(
        f"{len(wanted)} mutants: "
        + ", ".join(f"{count} {verdict}" for verdict, count in counts.items())
        + f"; {wrong} not as listed"
    )
    return 1 if wrong else 0


def cover(shop, wanted, jobs):
    """Writes figures that notice what all figures notice. Few sections are tried first: what these notice need not run through all.
    Of a round the figure comes first that notices most of what is left, and of equals that of the shortest line; each mutant is
    noticed by three of its round's figures if so many do."""
    listed, shop.figures = shop.figures, shop.folder / "round.txt"
    subprocess.run([shop.program, "--write-all", shop.figures], check=True)
    lines = shop.figures.read_text().split("\n")[:-1]
    sections = list(dict.fromkeys(line.split(" ")[0] for line in lines))
    random.Random(1).shuffle(sections)
    chosen, left, crashed = [], wanted, []
    for share in ROUNDS:
        tried = set(sections[: max(1, int(share * len(sections)))])
        sections = sections[len(tried) :]
        tried = [line for line in lines if line.split(" ")[0] in tried]
        shop.figures.write_text("\n".join(tried) + "\n")

        def tell(mutant):
            verdict, printed = shop.verdict(mutant, True, ["--each"])
            return verdict, printed if len(printed) == len(tried) else b""  # nothing if it crashes

        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            found = list(zip(left, pool.map(tell, left)))
        left = [mutant for mutant, (verdict, _) in found if verdict == "survived"]
        rows = [printed for _, (verdict, printed) in found if verdict == "killed" and printed]
        crashed += [(mutant, tried) for mutant, (verdict, printed) in found if verdict == "killed" and not printed]
        chosen += [tried[i] for i in greedy(rows, [len(line) for line in tried])]
        print(
            f"{len(tried)} figures: {len(rows)} mutants change some, {len(left)} change none; {len(chosen)} chosen so far",
            flush=True,
        )
    chosen += [line for mutant, tried in crashed if (line := crashing_line(shop, mutant, chosen, tried))]
    order = {line: i for i, line in enumerate(lines)}
    listed.write_text("\n".join(sorted(set(chosen), key=order.get)) + "\n")
    print(f"{len(chosen)} of {len(lines)} figures are chosen, {listed.stat().st_size} bytes")
    return 0


def crashing_line(shop, mutant, chosen, tried):
    """A line at which the mutant crashes; None if it does so at the chosen ones."""

    def fails(lines):
        shop.figures.write_text("\n".join(lines) + "\n")
        return shop.verdict(mutant, True)[0] == "killed"

    if fails(chosen):
        return None
    while len(tried) > 1:
        half = tried[: len(tried) // 2]
        tried = half if fails(half) else tried[len(half) :]
    return tried[0]


def greedy(rows, lengths):
    """Indices of the chosen figures. rows: of each mutant a letter for each figure, x if the mutant changes it."""
    columns = [0] * len(lengths)
    for i, row in enumerate(rows):
        at = row.find(b"x")
        while at >= 0:
            columns[at] |= 1 << i
            at = row.find(b"x", at + 1)
    shortest = {columns[i]: i for i in sorted(range(len(lengths)), key=lambda i: -lengths[i]) if columns[i]}  # of equal columns
    missing = [min(MOST_NOTICE, row.count(b"x")) for row in rows]
    left, chosen = (1 << len(rows)) - 1, []
    while shortest:
        best = max(shortest, key=lambda column: (bin(column & left).count("1"), -lengths[shortest[column]]))
        if not best & left:
            break
        chosen.append(shortest.pop(best))
        for i in range(len(rows)):
            if best >> i & 1 and missing[i] > 0:
                missing[i] -= 1
                left &= ~(1 << i) if missing[i] == 0 else -1
    return chosen


if __name__ == "__main__":
    sys.exit(main())
