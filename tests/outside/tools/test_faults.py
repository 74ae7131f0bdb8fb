"""What `roughcontact` makes of closed streams, full disks, two runs in one folder, files of others, and signals."""
import itertools
import json
import os
import signal
import subprocess
import time

import harness
from harness import CommandTest, np, paraboloid, rough, step_file, without_gnuplot

HERTZ = ["--pitch", "1e-6", "--modulus", "1e9"]
DRAWING = "touch drawing\nwhile [ -e drawing ]; do sleep 0.02; done\n"
STREAMS = ("stdin", "stdout", "stderr")


def closing(numbers):
    def close():
        for number in numbers:
            os.close(number)

    return close


def wait_for(condition, seconds=100):
    deadline = time.monotonic() + seconds
    while not condition() and time.monotonic() < deadline:
        time.sleep(0.005)
    assert condition()


class Streams(CommandTest):
    def test_full_output_is_an_error(self):
        surface = self.npy(paraboloid(24))
        solve = ["solve", surface, *HERTZ, "--approach", "1e-8"]
        commands = [solve, ["analyze", self.npy(rough(), "rough.npy"), "--pitch", "1e-6"], ["--help"], ["solve", "--help"], ["--version"]]
        commands += [[name] for name in ("backends", "solvers", "kernels", "options", "formats")]
        for command in commands:
            with self.subTest(command), open("/dev/full", "w") as full:
                done = subprocess.run([harness.COMMAND, *command], cwd=self.folder, stdout=full, stderr=subprocess.PIPE, encoding="utf-8", timeout=60)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn("roughcontact: cannot write to standard output", done.stderr.splitlines()[-1])
        self.solve(surface, *HERTZ, "--approach", "1e-8", "--quiet")

    def test_any_streams_closed(self):
        surface = self.npy(paraboloid(24))
        for count in range(4):
            for closed in itertools.combinations(range(3), count):
                for quiet in (True, False) if 1 in closed else (True,):
                    with self.subTest([STREAMS[number] for number in closed], quiet=quiet):
                        out = self.folder / "out"
                        command = [harness.COMMAND, "solve", surface, *HERTZ, "--approach", "1e-8", "--out", out]
                        streams = {name: subprocess.DEVNULL for number, name in enumerate(STREAMS) if number not in closed}
                        code = subprocess.run(command + ["--quiet"] * quiet, cwd=self.folder, preexec_fn=closing(closed), timeout=60, **streams).returncode
                        self.assertEqual(code, 0 if quiet or 1 not in closed else 1)
                        self.assertEqual(self.names("out"), ["contact-1.png", "gap-1.npy", "heights.npy", "pressure-1.npy", "steps.csv", "summary.json"])
                        picture = (out / "contact-1.png").read_bytes()
                        self.assertTrue(picture.startswith(b"\x89PNG") and picture.endswith(b"IEND\xaeB`\x82"))
                        self.assertEqual(np.load(out / "pressure-1.npy").shape, (24, 24))
                        self.assertEqual(len(json.loads((out / "summary.json").read_text())["steps"]), 1)


class Folder(CommandTest):
    def pressed(self, surface):
        return self.start("solve", surface, *HERTZ, "--approach", "1e-8:4e-7:20000", "--out", "out", "--quiet", env=without_gnuplot())

    def test_a_second_writer_is_refused(self):
        small, out = self.npy(paraboloid(24), "small.npy"), self.folder / "out"
        first = self.pressed(self.npy(rough(64, 64)))
        wait_for(lambda: (out / step_file("pressure", 2, 20000)).exists())
        second = self.run_command("solve", small, *HERTZ, "--approach", "1e-8", "--out", "out")
        self.assertEqual(second.returncode, 1, second.stderr)
        self.assertRegex(second.stderr, r"^roughcontact: --out: folder .* process %d\b.*\n$" % first.pid)
        first.send_signal(signal.SIGINT)
        self.assertEqual(first.wait(60), 130)
        first.communicate()
        self.assertEqual(json.loads((out / "summary.json").read_text())["input"]["nx"], 64)
        self.solve(small, *HERTZ, "--approach", "1e-8", "--out", "out", env=without_gnuplot())
        self.assertEqual(self.names("out"), ["gap-1.npy", "heights.npy", "pressure-1.npy", "steps.csv", "summary.json"])

    def test_a_killed_run_leaves_no_lock(self):
        surface, out = self.npy(rough(64, 64)), self.folder / "out"
        killed = self.pressed(surface)
        wait_for(lambda: (out / step_file("pressure", 2, 20000)).exists())
        killed.kill()
        killed.communicate()
        (out / ".pressure-7.npy.0123456789abcdef.tmp").write_text("half a file")
        (out / ".mine.0123456789abcdef.tmp").write_text("of the user's own")
        self.solve(surface, *HERTZ, "--approach", "1e-8", "--out", "out", env=without_gnuplot())
        self.assertEqual(self.names("out"), [".mine.0123456789abcdef.tmp", "gap-1.npy", "heights.npy", "pressure-1.npy", "steps.csv", "summary.json"])

    def test_files_of_others_are_not_overwritten(self):
        surface = self.npy(paraboloid(24))
        (self.folder / "out").mkdir()
        for name, contents in (("pressure-2.npy", "mine"), ("gap-1.npy", "mine"), ("contact-1.png", "mine"), ("history.png", "mine"), ("step-1.h5", "mine"), ("steps.csv", "mine"), ("summary.json", "mine"), ("summary.json", "{}"),
                               ("summary.json", "[" * 100000), ("summary.json", '{"input": {"targets": 1}, "steps": [{}]}')):
            with self.subTest(name=name, contents=contents[:50]):
                self.file("out/" + name, contents)
                self.assert_fails("solve", surface, *HERTZ, "--approach", "1e-8,2e-8", "--out", "out", says=["--out", name, "another folder"])
                self.assertEqual((self.folder / "out" / name).read_text(), contents)
                (self.folder / "out" / name).unlink()

    def test_special_files_are_not_opened(self):
        surface = self.npy(paraboloid(24))
        (self.folder / "out").mkdir()
        for name in ("summary.json", "steps.csv", "pressure-1.npy", "gap-1.npy", "contact-1.png", ".roughcontact.lock"):
            for make in (os.mkfifo, os.mkdir):
                for resume in ([], ["--resume"]):
                    with self.subTest(name=name, make=make.__name__, resume=resume):
                        path = self.folder / "out" / name
                        make(path)
                        self.assert_fails("solve", surface, *HERTZ, "--approach", "1e-8", "--out", "out", *resume, says=["--out", name, "is no regular file"])
                        path.rmdir() if path.is_dir() else path.unlink()


class Signals(CommandTest):
    def started(self, gnuplot):
        """A run that is being held up where it draws: in the middle of writing a file."""
        run = self.start("solve", self.npy(rough()), *HERTZ, "--approach", "1e-7,2e-7", "--out", "out", "--quiet", env=self.with_gnuplot(gnuplot))
        self.addCleanup(lambda: run.poll() is None and run.kill())
        wait_for(lambda: (self.folder / "drawing").exists())
        return run

    def test_the_second_signal_ends_at_once(self):
        for first, second in itertools.product((signal.SIGINT, signal.SIGTERM, signal.SIGHUP), repeat=2):
            with self.subTest(first=first, second=second):
                run = self.started(DRAWING)
                run.send_signal(first)
                time.sleep(0.05)
                self.assertIsNone(run.poll())
                run.send_signal(second)
                self.assertEqual(run.wait(10), -second)
                (self.folder / "drawing").unlink()
                run.communicate()
                self.assertEqual([name for name in self.names("out") if name.endswith(".tmp")], [])
                self.assertEqual(self.names("out")[-4:], ["gap-1.npy", "heights.npy", "pressure-1.npy", "summary.json"])

    def test_other_commands_end_without_their_file(self):
        surface, environment = self.npy(rough()), self.with_gnuplot(DRAWING)
        before = self.names()
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            run = self.start("analyze", surface, "--pitch", "1e-6", "--picture", "a.png", env=environment, stdout=subprocess.DEVNULL)
            wait_for(lambda: (self.folder / "drawing").exists())
            run.send_signal(number)
            self.assertEqual(run.wait(10), -number)
            (self.folder / "drawing").unlink()
            self.assertEqual(self.names(), before)

    def test_temporary_names_cannot_be_guessed(self):
        names = set()
        for _ in range(2):
            run = self.started("ls -A out > drawing.txt\nmv drawing.txt drawing\nwhile [ -e drawing ]; do sleep 0.02; done\n")
            names |= {name for name in (self.folder / "drawing").read_text().split() if name.endswith(".tmp")}
            run.kill()
            (self.folder / "drawing").unlink()
            run.communicate()
        self.assertEqual(len(names), 2)
        for name in names:
            self.assertRegex(name, r"^\.contact-1\.png\.[0-9a-f]{16}\.tmp$")


if __name__ == "__main__":
    harness.main()
