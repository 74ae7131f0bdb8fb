"""What the tests of surface files share: surfaces, and reading files with read_surfaces."""
import math
import os
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "outside" / "tools"))
import harness
from harness import CommandTest, np

READER = ""


def main():
    """Runs the test classes of the calling script on the command and the program named by its first two arguments."""
    global READER
    if len(sys.argv) < 3:
        sys.exit("usage: %s ROUGHCONTACT READ_SURFACES [TEST ...]" % sys.argv[0])
    READER = str(Path(sys.argv.pop(2)).resolve())
    harness.main()


def bumps(ny=7, nx=11, missing=0, seed=3):
    """Heights in whole nanometres, exact in every number type that the tests use; the first `missing` of a random order are NaN."""
    chance = np.random.default_rng(seed)
    z = chance.integers(-90, 91, size=(ny, nx)) * 1e-9
    z.ravel()[chance.permutation(ny * nx)[:missing]] = np.nan
    return z


class ReaderTest(CommandTest):
    def lines(self, *arguments):
        """What read_surfaces prints for these files; it must not crash."""
        done = subprocess.run([READER, *map(str, arguments)], cwd=self.folder, capture_output=True, timeout=250)
        self.assertEqual((done.returncode, done.stderr), (0, b""), arguments[-1])
        return done.stdout.decode("utf-8", "replace").splitlines()

    def read(self, name, *arguments):
        """Format, heights, pitch and note of a file that can be read."""
        (line,) = self.lines(*arguments, "--heights", "heights.raw", name)
        words = line.split(" ", 7)
        self.assertEqual(words[0], "ok", line)
        nx, ny = int(words[2]), int(words[3])
        heights = np.fromfile(self.folder / "heights.raw").reshape(ny, nx)
        if "--fill" not in arguments:
            self.assertEqual(int(words[6]), np.isnan(heights).sum())
        return words[1], heights, tuple(None if math.isnan(float(w)) else float(w) for w in words[4:6]), words[7]

    def assert_reads(self, name, contents, z, pitch, *arguments, format=None, note="", rtol=1e-6, atol=1e-15):
        found, heights, found_pitch, found_note = self.read(self.file(name, contents), *arguments)
        np.testing.assert_allclose(heights, z, rtol=rtol, atol=atol)
        if None in pitch:
            self.assertEqual(found_pitch, pitch)
        else:
            np.testing.assert_allclose(found_pitch, pitch, rtol=1e-6)
        self.assertIn(note, found_note)
        if format:
            self.assertEqual(found, format)

    def assert_refused(self, name, contents, says, *arguments):
        """An error of one line that names the file and contains these words."""
        (line,) = self.lines(*arguments, self.file(name, contents))
        for words in [name, says] if isinstance(says, str) else [name, *says]:
            self.assertIn(words, line)
        self.assertTrue(line.startswith("error " + name + ": "), line)


def has_program(name):
    return any(os.access(Path(folder) / name, os.X_OK) for folder in os.get_exec_path())
