#!/usr/bin/env python3
"""Tells which tests notice changes of single operators, so that tests may be deleted or replaced without a loss.

Usage: kill_sets.py BUILD --sources PATTERNS --tests REGEX [--targets NAMES] [--draw N] [--seed N] [--all] [--jobs N]
       kill_sets.py BUILD --again FILE --tests REGEX [--targets NAMES] [--jobs N]

BUILD: a build folder of this tree with its tests, such as build-gcc. Of the changes that scripts/switched.py knows of the sources
("src/law/*.cpp flow/*.cpp"), N are drawn (300), put into their files at once, each behind its number, and what the tests need is
built once. Then RC_CHANGE turns on one after the other: the tests called REGEX run ("^law|^scenes$"), the short ones first, of
`scenes` the first seeds, up to the first that fails. A line for each change says who notices it. The files are restored at the end
and after Ctrl-C; files with changes of your own are refused. --targets: what the tests need beside their own programs, such as
roughcontact_command. --all: all these tests run for each change, and a table says how many each notices, and which it notices alone.
--again: what FILE, the output of an earlier run before tests were deleted, calls noticed, instead of a draw. If no test notices a
change any more, the other seeds of `scenes` run if REGEX has it, and if these do not either, it is lost. Exit status: 1 if any is.
"""

import argparse
import collections
import concurrent.futures
import contextlib
import os
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading

import faults
import mutants
import switched

LEAST_SECONDS = 20  # of the processor's time that a test may take, or
LONGER = 10  # times as long as without a change
WAITING = 5  # times as long by the clock, since other programs run as well
MEMORY = 16_000_000  # KiB, for changes of sizes
NOBODY = "NOBODY"


class Test:
    def __init__(self, name, command, properties=None):
        properties = properties or {}
        self.name = name
        self.command = command
        self.folder = properties.get("WORKING_DIRECTORY")
        self.environment = dict(each.split("=", 1) for each in properties.get("ENVIRONMENT", []))
        self.passes = {0, properties.get("SKIP_RETURN_CODE", 0)}
        self.said = tempfile.TemporaryFile()  # without a change
        self.seconds = 60  # of the processor's time; measured without a change

    def fails(self, number):
        limit = int(max(LEAST_SECONDS, LONGER * self.seconds))
        program = subprocess.Popen(
            ["sh", "-c", f'ulimit -v {MEMORY} && ulimit -t {limit} && exec "$@"', self.name, *self.command],
            cwd=self.folder,
            env={**os.environ, **self.environment, "RC_CHANGE": str(number)},
            stdin=subprocess.DEVNULL,
            stdout=self.said if number == 0 else subprocess.DEVNULL,
            stderr=subprocess.STDOUT,
            start_new_session=True,
        )
        late = threading.Timer(WAITING * limit, os.killpg, (program.pid, signal.SIGKILL))
        late.start()
        _, status, used = os.wait4(program.pid, 0)
        late.cancel()
        program.returncode = os.waitstatus_to_exitcode(status)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(program.pid, signal.SIGKILL)  # what it has left behind
        if number == 0:
            self.seconds = used.ru_utime + used.ru_stime
        return program.returncode not in self.passes


def tests_of(build, pattern):
    """Those that pass without a change, the short ones first."""
    found, fixtures = [], set()
    for test in faults.listed(build, pattern):
        properties = {each["name"]: each["value"] for each in test.get("properties", [])}
        fixtures |= set(properties.get("FIXTURES_REQUIRED", []))
        seeds = ["--stop", "--seeds", faults.FIRST_SEEDS] if test["name"] == "scenes" else []
        if "command" not in test:
            print(f"{test['name']} is not built and left out: --targets", flush=True)
        elif not any("REGULAR_EXPRESSION" in name for name in properties):
            found.append(Test(test["name"], [*test["command"], *seeds], properties))
    for fixture in fixtures:
        subprocess.run(["ctest", "--test-dir", build, "-R", f"^{fixture}$"], check=True, capture_output=True)
    for test in list(found):
        if test.fails(0):
            test.said.seek(0)
            print(f"{test.name} fails without a change and is left out:\n{test.said.read().decode()[-2000:]}", flush=True)
            found.remove(test)
    return sorted(found, key=lambda test: test.seconds)


def known(patterns):
    """All changes that can be switched of these sources."""
    files = sorted({str(path.relative_to(mutants.ROOT)) for each in patterns.split() for path in mutants.ROOT.glob(each)})
    return [each for each in mutants.mutants([(file, file, mutants.ALL) for file in files]) if each.change.switch]


def noticed_before(report):
    """The names of the changes that an earlier run calls noticed."""
    lines = [line.rpartition(" | ") for line in report.read_text().split("\n") if line.count(" | ") == 3]
    return [name for name, _, who in lines if who != NOBODY]


def build_with(build, wanted, targets, jobs):
    """Builds the targets: which of the changes are in them."""
    numbered = collections.defaultdict(lambda: collections.defaultdict(list))
    for mutant in wanted:
        numbered[mutant.file][mutant.line].append((mutant.number, mutant.change))
    on = ["-k", "0"] if (build / "build.ninja").exists() else ["-k"]

    said = []

    def messages():
        run = subprocess.run(
            ["cmake", "--build", build, "--parallel", str(jobs), "--target", *sorted(targets), "--", *on],
            capture_output=True,
            text=True,
        )
        said[:] = run.stdout.split("FAILED: ")[1:] or [run.stdout + run.stderr]
        return said if run.returncode else []

    sources = {mutants.ROOT / file: (file, (mutants.ROOT / file).read_text(), each) for file, each in numbered.items()}
    found = switched.built(sources, messages)
    if found is None:
        sys.exit(f"does not build:\n{said[0][-4000:]}")
    return [mutant for mutant in wanted if mutant.number in set(found)]


def who_notices(mutant, tests, everything):
    found = []
    for test in tests:
        if test.fails(mutant.number):
            found.append(test.name)
            if not everything:
                break
    return found


def table(found, tests):
    print("\nnoticed, of these alone | test")
    for name in dict.fromkeys(test.name for test in tests):
        alone = [mutant for mutant, who in found if who == [name]]
        print(f"{sum(name in who for _, who in found):4} {len(alone):4} | {name}")
        for mutant in alone:
            print(f"          | {mutant}")


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--sources", default="")
    parser.add_argument("--tests", required=True)
    parser.add_argument("--targets", default="")
    parser.add_argument("--draw", type=int, default=300)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--again", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()

    if arguments.again:
        before = noticed_before(arguments.again)
        by_name = {str(each): each for each in known(" ".join({name.split(" | ")[0] for name in before}))}
        wanted = [by_name[name] for name in before if name in by_name]
        for name in before:
            if name not in by_name:
                print(f"occurs no more: {name}")
    else:
        wanted = known(arguments.sources)
        wanted = random.Random(arguments.seed).sample(wanted, min(arguments.draw, len(wanted)))
    build = arguments.build.resolve()
    _, targets = faults.tests_of(build, arguments.tests)
    with faults.restored(sorted({mutant.file for mutant in wanted})):
        drawn, wanted = len(wanted), build_with(build, wanted, targets | set(arguments.targets.split()), arguments.jobs)
        tests = tests_of(build, arguments.tests)
        if arguments.again and any(test.name == "scenes" for test in tests):
            tests.append(Test("scenes", [build / "bin/test_scenes", "--stop", "--seeds", faults.OTHER_SEEDS]))
        print(
            f"{len(wanted)} of {drawn} changes compile; {len(tests)} tests, {sum(test.seconds for test in tests):.0f} s",
            flush=True,
        )
        found = []
        with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
            for mutant, who in zip(wanted, pool.map(lambda each: who_notices(each, tests, arguments.all), wanted)):
                found.append((mutant, who))
                print(f"{mutant} | {', '.join(who) or NOBODY}", flush=True)
    lost = sum(not who for _, who in found)
    print(f"{len(found)} changes, {len(found) - lost} noticed")
    if arguments.all:
        table(found, tests)
    return 1 if arguments.again and lost else 0


if __name__ == "__main__":
    sys.exit(main())
