"""What the tests of the command share: running it, generating surfaces, and judging how it fails."""
import os
import signal
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print("skipped: NumPy is not installed")
    sys.exit(77)

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "support"))
from stand_ins import gsf  # noqa: E402, F401

COMMAND = ""


def main():
    """Runs the test classes of the calling script on the binary named by its first argument."""
    global COMMAND
    if len(sys.argv) < 2:
        sys.exit("usage: %s ROUGHCONTACT [TEST ...]" % sys.argv[0])
    COMMAND = str(Path(sys.argv.pop(1)).resolve())
    unittest.main(module="__main__")


def default_signals():
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def paraboloid(n=48, pitch=1e-6, radius=1e-3):
    """Heights of a sphere's tip on an n x n grid, highest at the centre."""
    x = (np.arange(n) - (n - 1) / 2) * pitch
    return -(x[None, :] ** 2 + x[:, None] ** 2) / (2 * radius)


def rough(ny=40, nx=56, rms=1e-7, seed=1):
    """A smooth random surface, not square."""
    noise = np.fft.rfft2(np.random.default_rng(seed).normal(size=(ny, nx)))
    q = np.hypot(np.fft.fftfreq(ny)[:, None], np.fft.rfftfreq(nx)[None, :])
    q[0, 0] = 1
    z = np.fft.irfft2(noise * np.where(q > 0.02, q**-1.8, 0), s=(ny, nx))
    return z * rms / z.std()


class CommandTest(unittest.TestCase):
    """Every test has an empty working folder of its own."""

    in_memory = False  # where thousands of files are brought to the disk

    def setUp(self):
        memory = "/dev/shm" if self.in_memory and os.access("/dev/shm", os.W_OK) else None
        scratch = tempfile.TemporaryDirectory(dir=memory)
        self.addCleanup(scratch.cleanup)
        self.folder = Path(scratch.name)

    def run_command(self, *arguments, **settings):
        settings.setdefault("timeout", 120)
        return subprocess.run([COMMAND, *map(str, arguments)], cwd=self.folder, encoding="utf-8", errors="replace", capture_output=True, **settings)

    def solve(self, *arguments, code=0, **settings):
        """Bodies end at their edges, if a test does not say otherwise."""
        said = any(str(word).split("=")[0] == "--boundary" for word in arguments)
        done = self.run_command("solve", *arguments, *([] if said else ["--boundary", "free"]), **settings)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def start(self, *arguments, **settings):
        """The command, which the signals end that a shell's background ignores."""
        usual = dict(stdout=subprocess.PIPE, stderr=subprocess.PIPE, encoding="utf-8", preexec_fn=default_signals)
        return subprocess.Popen([COMMAND, *map(str, arguments)], cwd=self.folder, **{**usual, **settings})

    def with_gnuplot(self, script, folder="."):
        """An environment in which gnuplot is this script."""
        self.file(folder + "/gnuplot", "#!/bin/sh\n" + script)
        (self.folder / folder / "gnuplot").chmod(0o755)
        return dict(os.environ, PATH="%s:/usr/bin:/bin" % (self.folder / folder))

    def npy(self, z, name="surface.npy"):
        np.save(self.folder / name, z)
        return name

    def file(self, name, contents):
        (self.folder / name).write_bytes(contents if isinstance(contents, bytes) else contents.encode("utf-8"))
        return name

    def names(self, folder="."):
        return sorted(os.listdir(self.folder / folder))

    def assert_fails(self, *arguments, says=(), **settings):
        """Wrong input: code 1, nothing on stdout, one line on stderr with these words, no file more or less."""
        before = self.names()
        done = self.run_command(*arguments, **settings)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(done.stdout, "")
        self.assertTrue(done.stderr.startswith("roughcontact: "), done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for words in [says] if isinstance(says, str) else says:
            self.assertIn(words, done.stderr)
        self.assertEqual(self.names(), before)


def step_file(stem, number, steps, extension="npy"):
    """The name of a step's file in a history of so many steps."""
    return "%s-%0*d.%s" % (stem, len(str(steps)), number, extension)


def without_gnuplot():
    """An environment in which the command draws nothing, for tests that are not about pictures."""
    return dict(os.environ, PATH="/nonexistent")
