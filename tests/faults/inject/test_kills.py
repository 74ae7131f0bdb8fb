"""`roughcontact solve --out` ended by a signal at every rename of a history: what is there is whole, and --resume goes on to the results
of a run that was not disturbed.

Usage: test_kills.py ROUGHCONTACT INJECT [TEST ...]
"""
import json
import os
import shutil
import signal
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "outside" / "tools"))
import harness  # noqa: E402
from faulted import Faulted, take_arguments  # noqa: E402
from harness import CommandTest, np, rough  # noqa: E402
from test_resume import PRESS, assert_same_results  # noqa: E402

TARGETS = "5e-8,2e-7,1.9e-7"


class Kills(CommandTest):
    in_memory = True

    def setUp(self):
        super().setUp()
        (self.folder / "gnuplot").symlink_to("/bin/echo")  # it takes far longer than all the rest
        self.environment = dict(os.environ, PATH="%s:/usr/bin:/bin" % self.folder)
        self.surface = self.npy(rough(24, 24))

    def arguments(self, out, *more):
        return ["solve", self.surface, *PRESS, "--approach", TARGETS, "--out", out, "--quiet", *more]

    def assert_whole(self, out):
        for path in out.glob("[!.]*.npy"):
            self.assertEqual(np.load(path).shape, (24, 24))
        if (out / "summary.json").exists():
            steps = json.loads((out / "summary.json").read_text())["steps"]
            self.assertTrue({n % (k + 1) for k in range(len(steps)) for n in ("gap-%d.npy", "pressure-%d.npy")} <= set(os.listdir(out)))

    def end_at_every_rename(self, number, *before):
        """`before`: arguments of a run whose results are in the folder at the start."""
        whole, out = self.folder / "whole", self.folder / "out"
        if not whole.exists():
            self.assertEqual(self.run_command(*self.arguments("whole"), env=self.environment).returncode, 0)
        faulted = Faulted(INJECT, [harness.COMMAND, *self.arguments("out")], self.folder, PATH=self.environment["PATH"])
        total = None
        at = 1
        while total is None or at <= total:
            shutil.rmtree(out, ignore_errors=True)
            if before:
                self.assertEqual(self.run_command(*before, env=self.environment).returncode, 0)
            if total is None:
                total = faulted.calls("rename")
                continue
            with self.subTest(signal=number, rename=at, of=total, before=bool(before)):
                done, lines = faulted.run("rename", at, how=int(number))
                self.assertEqual(lines[0], "struck %d" % at)
                self.assertEqual(done.returncode, -number if number == signal.SIGKILL else 130, done.stderr)
                self.assert_whole(out)
                again = self.run_command(*self.arguments("out", "--resume"), env=self.environment)
                if before and "give the same arguments" in again.stderr:  # the earlier run was still there
                    again = self.run_command(*self.arguments("out"), env=self.environment)
                self.assertEqual(again.returncode, 0, again.stderr)
                assert_same_results(self, out, whole)
            at += 1
        self.assertGreaterEqual(total, 13)

    def test_killed(self):
        self.end_at_every_rename(signal.SIGKILL)

    def test_interrupted(self):
        self.end_at_every_rename(signal.SIGINT)

    def test_terminated(self):
        self.end_at_every_rename(signal.SIGTERM)

    def test_killed_in_the_folder_of_another_run(self):
        other = ["solve", self.surface, *PRESS, "--approach", "1e-9:3e-7:6", "--out", "out", "--quiet"]
        self.end_at_every_rename(signal.SIGKILL, *other)


if __name__ == "__main__":
    COMMAND, INJECT = take_arguments(["ROUGHCONTACT", "INJECT"])
    harness.COMMAND = COMMAND
    unittest.main()
