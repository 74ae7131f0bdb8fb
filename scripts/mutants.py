#!/usr/bin/env python3
"""Changes the certificate and the bounds one operator at a time and requires that a test fails.

Usage: mutants.py BUILD [--jobs N] [--only TEXT] [--list]

BUILD: a build folder of this tree with lib/libroughcontact.a (target roughcontact_static) that was configured with
-DCMAKE_UNITY_BUILD=OFF; programs of the mutants are built in BUILD/mutants. Of every file
and header listed below, each comparison, sign, product, constant, minimum, condition and single statement is changed alone: the file is compiled
again, linked with tests/mutants, and that program must fail. Mutants that do not compile count for nothing. Those that none of these tests can tell
stand in tests/mutants/equivalents.txt, with the reason: file | line of the source | change | reason. An entry that no longer occurs, or
that a test does fail on, is an error, too. --only: mutants whose name contains the text. Exit status: 0 if none survives.
"""

import argparse
import concurrent.futures
import os
import pathlib
import re
import shutil
import subprocess
import sys

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
        "src/contact/proof/certificate.cpp": ("relative_violation", "primal_violation", "room_below", "dual_violation", "complementarity_violation", "residual_scale"),
        "src/contact/proof/certified.cpp": ("load_imbalance",),
        "src/contact/target.cpp": ("beyond_mean_plane",),
    }
}
TRAPS = ("-fsanitize=bounds", "-fsanitize-undefined-trap-on-error")  # places beyond the end of an array
TIMEOUT = 20  # seconds: a mutant that never ends is found, too

OPPOSITE = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
EDGE = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
OTHER_SIGN = {"+": "-", "-": "+", "*": "/", "/": "*"}
SPACED = re.compile(r"(?<= )(<=|>=|==|!=|<|>|\+|-|\*|/|&&|\|\||\+=|-=|\*=|/=)(?= )")
NUMBER = re.compile(r"(?<![\w.\"])(\d+\.?\d*(?:e-?\d+)?)(?![\w.\"])")
STATEMENT = re.compile(r"^\s*(?!return|const|double|auto|using|if|for|else|std::size_t|std::int64_t|constexpr|static_assert)[\w.>\-\[\]()*&:]+"
                       r"(?: [-+*/]?= |\()[^{}]*;\s*$")


def code_of(line):
    """The line with its comment and the insides of its strings blanked, of the same length."""
    blank = re.sub(r'"(?:[^"\\]|\\.)*"', lambda m: '"' + " " * (len(m.group()) - 2) + '"', line)
    comment = blank.find("//")
    return blank if comment < 0 else blank[:comment] + " " * (len(blank) - comment)


def end_of_term(code, start):
    """Where the factors that begin at `start` end."""
    depth, i = 0, start
    while i < len(code):
        c = code[i]
        if c in "([{":
            depth += 1
        elif c in ")]}":
            if depth == 0:
                return i
            depth -= 1
        elif depth == 0 and (c in ",;?:" and code[i : i + 2] != "::" and code[i - 1 : i + 1] != "::" or re.match(r" [-+<>=!&|?:]", code[i:])):
            return i
        i += 1
    return i


def changes(line):
    """(name, changed line) of every mutant of one line."""
    code = code_of(line)

    def put(begin, end, text):
        return line[:begin] + text + line[end:]

    for m in SPACED.finditer(code):
        op, begin, end = m.group(), m.start(), m.end()
        at = f"at {begin}"
        if op in OPPOSITE:
            yield f"{op} to {OPPOSITE[op]} {at}", put(begin, end, OPPOSITE[op])
        if op in EDGE and re.match(r" [01]\b(?!\.)", code[end:]):
            yield f"{op} to {EDGE[op]} {at}", put(begin, end, EDGE[op])
        if op in OTHER_SIGN:
            yield f"{op} to {OTHER_SIGN[op]} {at}", put(begin, end, OTHER_SIGN[op])
        if op in ("+", "-") and end_of_term(code, end + 1) <= len(code.rstrip()):
            yield f"{op} skipped {at}", put(begin, end_of_term(code, end + 1), "").rstrip()
        if op in ("&&", "||"):
            yield f"{op} to {'||' if op == '&&' else '&&'} {at}", put(begin, end, "||" if op == "&&" else "&&")
        if op in ("+=", "-=", "*=", "/="):
            other = OTHER_SIGN[op[0]] + "="
            yield f"{op} to {other} {at}", put(begin, end, other)
    for m in re.finditer(r"std::(min|max)\b", code):
        other = "max" if m.group(1) == "min" else "min"
        yield f"{m.group(1)} to {other} at {m.start()}", put(m.start(1), m.end(1), other)
    for m in re.finditer(r"(?<=[(,=] )-(?=\w)|(?<=\()-(?=\w)|(?<=[({])!(?=[\w(])|(?<=&& )!(?=[\w(])|(?<=\|\| )!(?=[\w(])", code):
        yield f"{m.group()} dropped at {m.start()}", put(m.start(), m.end(), "")
    for m in NUMBER.finditer(code):
        if re.match(r"\s*>", code[m.end() :]) and "<" in code[: m.start()][-12:]:
            continue
        value = m.group(1)
        other = str(int(value) + 1) if value.isdigit() else "1.0" if float(value) == 0 else f"(2 * {value})"
        yield f"{value} to {other} at {m.start()}", put(m.start(), m.end(), other)
    for m in re.finditer(r"\b(true|false)\b", code):
        other = "false" if m.group() == "true" else "true"
        yield f"{m.group()} to {other} at {m.start()}", put(m.start(), m.end(), other)
    for m in re.finditer(r"\bstd::(sqrt|abs)\(", code):
        yield f"{m.group(1)} skipped at {m.start()}", put(m.start(), m.end() - 1, "")
    if STATEMENT.match(code):
        yield "statement skipped", ";"


def lines_of(text, functions):
    """Numbers of the lines that are mutated."""
    lines = text.split("\n")
    if functions is ALL:
        first = next(i for i, line in enumerate(lines) if line.startswith("namespace rc"))
        return range(first, len(lines))
    found = []
    for function in functions:
        begin = next(i for i, line in enumerate(lines) if f" {function}(" in line and not line.startswith(" "))
        end = next(i for i in range(begin, len(lines)) if lines[i].rstrip() == "}" or (i == begin and lines[i].rstrip().endswith("}")))
        found.extend(range(begin, end + 1))
    return found


def included(header):
    return f'#include "{header.removeprefix("src/")}"'


def mutants():
    """(file, line of the source, its number, change, file that is compiled, its text)"""
    for name, functions in SOURCES.items():
        text = (ROOT / name).read_text()
        lines = text.split("\n")
        for i in lines_of(text, functions):
            for change, changed in changes(lines[i]):
                yield name, lines[i].strip(), i + 1, change, name, "\n".join([*lines[:i], changed, *lines[i + 1 :]])
    for header, users in INLINE.items():
        text = (ROOT / header).read_text().replace("#pragma once", "")
        lines = text.split("\n")
        for user, functions in users.items():
            for i in lines_of(text, functions):
                for change, changed in changes(lines[i]):
                    inlined = "\n".join([*lines[:i], changed, *lines[i + 1 :]])
                    yield header, lines[i].strip(), i + 1, change, user, (ROOT / user).read_text().replace(included(header), inlined)


def equivalents():
    entries = {}
    for line in (TESTS / "equivalents.txt").read_text().split("\n"):
        if line and not line.startswith("#"):
            name, rest = line.split(" | ", 1)
            source, change, reason = (part.strip() for part in rest.rsplit(" | ", 2))
            entries[name, source, change] = reason
    return entries


class Workshop:
    """Compiles and links mutants in a folder."""

    def __init__(self, build):
        self.build = build
        self.folder = build / "mutants"
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        self.compiler = [os.environ.get("CXX", "g++"), "-std=c++20", "-w", *TRAPS, f"-I{ROOT}/include", f"-I{ROOT}/src", f"-I{ROOT}", f"-I{ROOT}/tests", f"-I{TESTS}"]
        self.library = build / "lib/libroughcontact.a"
        if not self.library.exists():
            sys.exit(f"{self.library} is missing: build it first")
        self.tests = []
        for source in sorted(TESTS.glob("*.cpp")):
            target = self.folder / f"test_{source.stem}.o"
            subprocess.run([*self.compiler, "-O1", "-c", source, "-o", target], check=True)
            self.tests.append(target)

    def headers(self, name):
        """What a file includes, compiled once."""
        header = self.folder / (name.replace("/", "_") + ".h")
        includes = re.findall(r"^#include .*$", (ROOT / name).read_text(), re.M)
        header.write_text("\n".join(each for each in includes if each not in map(included, INLINE)) + "\n")
        subprocess.run([*self.compiler, "-O0", "-x", "c++-header", header, "-o", f"{header}.gch"], check=True)

    def verdict(self, number, name, text):
        """'killed', 'survived' or 'not built'."""
        stem = self.folder / f"m{number}"
        source, target, program = stem.with_suffix(".cpp"), stem.with_suffix(".o"), stem
        source.write_text(text)
        try:
            header = self.folder / (name.replace("/", "_") + ".h")
            built = subprocess.run([*self.compiler, "-O0", "-include", header, "-c", source, "-o", target], capture_output=True)
            if built.returncode != 0:
                return "not built"
            linked = [self.compiler[0], target, *self.tests, self.library, "-ldl", "-lpthread", "-lgomp", "-o", program]
            subprocess.run(linked, check=True, capture_output=True)
            run = subprocess.run([program, TESTS / "figures.txt"], capture_output=True, timeout=TIMEOUT)
            return "survived" if run.returncode == 0 else "killed"
        except subprocess.TimeoutExpired:
            return "killed"
        finally:
            for each in (source, target, program):
                each.unlink(missing_ok=True)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--only", default="")
    parser.add_argument("--list", action="store_true")
    arguments = parser.parse_args()

    wanted = [m for m in mutants() if arguments.only in " | ".join((m[0], m[1], m[3]))]
    if arguments.list:
        for name, source, number, change, *_ in wanted:
            print(f"{name} | {source} | {change}")
        return 0
    excused = equivalents()
    shop = Workshop(arguments.build)
    for name, text in [(name, (ROOT / name).read_text()) for name in SOURCES]:
        shop.headers(name)
        if shop.verdict("original", name, text) != "survived":
            sys.exit(f"tests/mutants fails on {name} as it is")

    counts = {"killed": 0, "survived": 0, "not built": 0}
    wrong = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        verdicts = pool.map(lambda m: shop.verdict(m[0], m[1][4], m[1][5]), enumerate(wanted))
        for (name, source, number, change, *_), verdict in zip(wanted, verdicts):
            counts[verdict] += 1
            reason = excused.pop((name, source, change), None)
            if (verdict == "survived") != (reason is not None):
                wrong += 1
                what = "survives" if reason is None else f"is listed as equivalent, but was {verdict}"
                print(f"{name} | {source} | {change} | {what} (line {number})", flush=True)
    if not arguments.only:
        for entry in excused:
            wrong += 1
            print(" | ".join(entry), "| is listed as equivalent, but occurs no more")
    print(f"{len(wanted)} mutants: " + ", ".join(f"{count} {verdict}" for verdict, count in counts.items()) + f"; {wrong} not as listed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
