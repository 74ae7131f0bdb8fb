"""Runs of a program in which one of its calls fails, by the preloaded library of inject.c."""
import os
import signal
import subprocess
import sys
from pathlib import Path

# Words of failures that people can act on; a program may also find another way and end well.
CRASHES = {-number for number in (signal.SIGABRT, signal.SIGSEGV, signal.SIGBUS, signal.SIGFPE, signal.SIGILL)}


def take_arguments(names):
    """The paths that the calling script's first arguments name, off sys.argv."""
    if len(sys.argv) <= len(names):
        sys.exit("usage: %s %s [TEST ...]" % (sys.argv[0], " ".join(names)))
    return [str(Path(sys.argv.pop(1)).resolve()) for _ in names]


class Faulted:
    """A program with its arguments; `loaded`: libraries whose constructors are to have run before calls count."""

    def __init__(self, inject, command, folder, loaded=(), **environment):
        self.command, self.folder = command, folder
        self.preload = ":".join([inject, *loaded])
        self.environment = dict(os.environ, **environment)

    def run(self, call, at=0, how="", least=0, every=0):
        """What it did, and the lines of the log: "struck N" for every fault, "calls N" at a regular end."""
        log = Path(self.folder) / "faults.log"
        log.unlink(missing_ok=True)
        settings = {"RC_FAULT": call, "RC_FAULT_AT": at, "RC_FAULT_HOW": how, "RC_FAULT_LEAST": least, "RC_FAULT_EVERY": every, "RC_FAULT_LOG": log}
        environment = dict(self.environment, LD_PRELOAD=self.preload, **{name: str(value) for name, value in settings.items()})
        done = subprocess.run(self.command, cwd=self.folder, env=environment, capture_output=True, encoding="utf-8", errors="replace", timeout=60)
        lines = log.read_text().splitlines() if log.exists() else []
        log.unlink(missing_ok=True)
        return done, lines

    def calls(self, call, least=0):
        """How many such calls an undisturbed run makes."""
        done, lines = self.run(call, least=least)
        assert done.returncode == 0 and lines, done.stderr
        return int(lines[-1].split()[1])


def spread(total, runs):
    """At most so many of 1 .. total: the first ones, then ever further apart but for the last."""
    if total <= runs:
        return range(1, total + 1)
    return sorted({1 + round(k * (total - 1) / (runs - 1)) for k in range(runs)})
