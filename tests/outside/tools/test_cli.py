"""Arguments, units, answers, exit codes and messages of `roughcontact`."""
import json
import os
import pty
import re
import shlex
import subprocess
from pathlib import Path

import harness
from harness import CommandTest, gsf, np, paraboloid, rough, without_gnuplot

INPUT_FIELDS = "file nx ny hx hy modulus boundary control targets options library_version".split()


def read_terminal(here):
    """All that is written until its other end is closed everywhere."""
    shown = b""
    try:
        while chunk := os.read(here, 1 << 16):
            shown += chunk
    except OSError:  # EIO: Linux's end of file of a terminal
        pass
    return shown.decode()


class Answers(CommandTest):
    def steps(self, *arguments, **settings):
        self.solve(*arguments, "--out", "out", "--quiet", env=without_gnuplot(), **settings)
        return json.loads((self.folder / "out/summary.json").read_text())["steps"]

    def test_summary_names_input_and_results(self):
        surface = self.file("s.gsf", gsf(rough(), 1e-6, 2e-6, "XYUnits = m\nZUnits = m\n"))
        self.steps(surface, "--modulus", 1e9, "--load", "1e-5,2e-5", "--solver", "polonsky-keer", "--set", "max_iter=500", "--tol", "1e-7")
        summary = json.loads((self.folder / "out/summary.json").read_text())
        given = summary["input"]
        self.assertTrue(set(INPUT_FIELDS) <= set(given))
        self.assertEqual((given["file"], given["nx"], given["ny"], given["control"], given["boundary"]), ("s.gsf", 56, 40, "load", "free"))
        np.testing.assert_allclose((given["hx"], given["hy"]), (1e-6, 2e-6), rtol=1e-15)
        self.assertEqual((given["targets"], given["crossing"]), ([1e-5, 2e-5], "along x, along y"))
        self.assertEqual(given["options"], {"stiffness": "1", "resumable": "1", "solver": "polonsky-keer", "tol": "1e-7", "max_iter": "500"})
        self.assertEqual(summary["units"]["length"], "m")
        for step in summary["steps"]:
            self.assertEqual(step["solver"], "polonsky-keer")
            self.assertLessEqual(max(value for name, value in step.items() if name.startswith("kkt_")), 1e-7)


class Output(CommandTest):
    def hertz(self, *arguments, **settings):
        return self.solve(self.npy(paraboloid(24)), "--pitch", "1e-6", "--unit", "m", "--modulus", "1e9", *arguments, **settings)

    def test_without_a_boundary_a_map_is_a_sample(self):
        """Solved as it is remarked; a shape is a whole body."""
        bare = ["solve", self.npy(rough()), "--pitch", "1um", "--unit", "m", "--modulus", "1GPa", "--load", "1mN"]
        for given, boundary, remarked in (([], "periodic", True), (["--shape", "sphere:R=1mm"], "free", False)):
            done = self.run_command(*bare, *given)
            self.assertIn(f", {boundary} boundary", done.stdout)
            self.assertEqual("note: boundary periodic" in done.stderr, remarked)

    def test_table_has_a_row_a_step(self):
        done = self.hertz("--approach", "1e-8,2e-8")
        lines = done.stdout.splitlines()
        self.assertEqual(len(lines), 5)
        self.assertRegex(lines[0], r"surface.npy, 24 x 24 points, pitch 1 \u00b5m, E\* 1 GPa, ")
        self.assertEqual(lines[1].split(), "step load approach area max pressure stiffness mean pressure mean gap residual time status".split())
        for number, line in enumerate(lines[2:4], 1):
            self.assertRegex(line, r"^ +%d +[\d.]+ \u00b5N +\d+ nm +[\d.]+ %% +[\d.]+ MPa +[\d.]+ \w?N/m +[\d.]+ \w?Pa +[\d.]+ nm  \S+ +[\d.]+ .?s  RC_OK$" % number)
            self.assertEqual(line.index("RC_OK"), lines[1].index("status"))
        self.assertEqual(done.stderr, "")  # the table has said it
        few = ["--tol", "1e-4", "--set", "max_iter=1", "--solver", "polonsky-keer"]
        for z, arguments in ((rough(), ["--pressure", "123456789Pa", "--hardness", "20GPa"]), (rough(), ["--pressure", "123456Pa", *few])):
            done = self.run_command("solve", self.npy(z), "--pitch", "1.23456um", "--modulus", "123.456GPa", *arguments)
            self.assertLessEqual(max(len(line) for line in done.stdout.splitlines()[1:-1]), 120)

    def test_the_choice_is_explained(self):
        done = self.hertz("--approach", "1e-8", "--explain")
        self.assertRegex(done.stderr, r"(?m)^roughcontact: [\w-]+ on [\w-]+: .* s, .* MiB, taken$")
        self.assertIn("admm: by name only", done.stderr)
        self.assertNotIn("by name only", self.hertz("--approach", "1e-8").stderr)

    def test_quiet_prints_nothing_and_without_out_nothing_is_written(self):
        done = self.hertz("--approach", "1e-8", "--quiet")
        self.assertEqual((done.stdout, done.stderr, self.names()), ("", "", ["surface.npy"]))

    def test_progress_bar_on_a_terminal(self):
        here, terminal = pty.openpty()
        surface = self.npy(rough(128, 128))
        with subprocess.Popen([harness.COMMAND, "solve", surface, "--pitch", "1um", "--unit", "m", "--modulus", "1e9", "--boundary", "periodic", "--approach", "2e-7"],
                              cwd=self.folder, stdout=subprocess.PIPE, stderr=terminal, text=True) as process:
            os.close(terminal)
            shown = read_terminal(here)
            printed = process.communicate(timeout=120)[0]
        os.close(here)
        self.assertEqual(process.returncode, 0)
        self.assertRegex(shown, r"\rstep 1/1 \[[#.]+\] iteration \d+  residual \S+  \d+\.\d s")
        self.assertTrue(shown.endswith("\r\x1b[K"))
        self.assertNotIn("\r", printed)

    def test_lists(self):
        for command, words in (("backends", ["dense", "built-in"]), ("solvers", ["polonsky-keer", "nnls"]),
                               ("kernels", ["love", "galerkin", "spectral"]), ("options", ["tol", "1e-8", "real", "max_iter"])):
            done = self.run_command(command)
            self.assertEqual(done.returncode, 0, done.stderr)
            for word in words:
                self.assertIn(word, done.stdout)
        self.assertRegex(self.run_command("--version").stdout, r"^roughcontact \d+\.\d+\.\d+ \(library ABI \d+, plugin ABI \d+\)\n$")
        self.assertIn("--approach", self.run_command("solve", "--help").stdout)

    def test_last_line_says_what_was_learned(self):
        last = self.hertz("--approach", "1e-8,2e-8").stdout.splitlines()[-1]
        self.assertRegex(last, r"^step 2 of 2: contact area [\d.]+ % at [\d.]+ \u00b5N; largest pressure [\d.]+ MPa$")
        steel = ["--E", "210GPa", "--nu", "0.3", "--pitch", "1um"]
        last = self.solve(self.npy(rough()), *steel, "--pressure", "3GPa").stdout.splitlines()[-1]
        self.assertRegex(last, r"^contact area [\d.]+ % at [\d.]+ N; largest pressure [\d.]+ GPa; warning: above the hardness of any steel, .* \(add --hardness\)$")
        last = self.solve(self.npy(rough()), "--modulus", "10MPa", "--pitch", "0.1um", "--pressure", "5MPa").stdout.splitlines()[-1]
        self.assertRegex(last, r"largest pressure [\d.]+ MPa; warning: that is [\d.]+ E\*, linear elasticity does not hold there")
        yielding = [self.npy(rough()), *steel, "--pressure", "3GPa", "--out", "out", "--hardness"]
        last = self.solve(*yielding, "20GPa").stdout.splitlines()[-1]
        said = re.fullmatch(r"contact area [\d.]+ % at [\d.]+ N; ([\d.]+) % of the contact is at the hardness of 20 GPa and carries ([\d.]+) % of the load", last)
        self.assertTrue(said, last)
        pressure = np.load(self.folder / "out/pressure-1.npy")
        capped = pressure[pressure == 20e9]
        np.testing.assert_allclose([float(share) for share in said.groups()],
                                   [100 * len(capped) / (pressure > 0).sum(), 100 * capped.sum() / pressure.sum()], rtol=6e-3)
        last = self.solve(*yielding, "1TPa").stdout.splitlines()[-1]
        self.assertRegex(last, r"; largest pressure [\d.]+ GPa, below the hardness of 1 TPa$")
        self.assertEqual(self.hertz("--load", "0").stdout.splitlines()[-1], "load 0 N, no contact")

    def test_an_uncertified_step_says_what_was_asked_and_reached(self):
        stopped = [self.npy(rough()), "--pitch", "1e-6", "--modulus", "1e9", "--set", "max_iter=1", "--solver"]
        for solver, target, says in (("polonsky-keer", ["--approach", "200nm"], "approach 200 nm asked, 200 nm reached"), ("nnls", ["--load", "100uN"], r"load 100 \u00b5N asked, \S+ \S*N reached"),
                                     ("nnls", ["--pressure", "1MPa"], r"mean pressure 1 MPa asked, \S+ \S*Pa reached")):
            done = self.solve(*stopped, solver, *target, code=2)
            self.assertRegex(done.stderr, r"(?m)^roughcontact: step 1 of 1 is not certified \(RC_STOP_MAX_ITER\): %s; stopped at max_iter" % says)
            self.assertRegex(done.stdout.splitlines()[-1], r"^not certified \(RC_STOP_MAX_ITER\), %s: " % says)
        self.solve(*stopped, "polonsky-keer", "--approach", "1e-7,2e-7", "--out", "out", code=2, env=without_gnuplot())  # both are written
        self.assertEqual(self.names("out"), ["gap-1.npy", "gap-2.npy", "heights.npy", "pressure-1.npy", "pressure-2.npy", "steps.csv", "summary.json"])
        steps = json.loads((self.folder / "out/summary.json").read_text())["steps"]
        self.assertEqual([step["status"] for step in steps], ["RC_STOP_MAX_ITER"] * 2)

    def test_remarks_are_told(self):
        tilted = rough() + np.linspace(0, 2e-6, 56)
        for quiet in ([], ["--quiet"]):
            done = self.solve(self.npy(tilted), "--pitch", "1um", "--modulus", "1GPa", "--approach", "1e-7,2e-7", *quiet)
            self.assertRegex(done.stderr, r"(?m)^roughcontact: remark: a plane is \d+ % of the heights' variance: level them with --remove plane$")
            self.assertEqual(done.stderr.count("remark"), 1)  # once for both steps
        common = [self.npy(rough()), "--pitch", "1um", "--load", "1e-12"]
        done = self.solve(*common, "--modulus", "1GPa", "--hardness", "150")
        self.assertRegex(done.stderr, r"(?m)^roughcontact: remark: --hardness is 150 Pa, below \d+ .?Pa: check its unit, a number alone is in Pa$")
        for unit in ("MPa", "GPa"):
            self.assertNotIn("check its unit", self.solve(*common, "--modulus", "1GPa", "--hardness", "1.5" + unit).stderr)
        self.assertIn("--E is 3 Pa, below 100 Pa", self.solve(*common, "--E", "3", "--nu", "0.3").stderr)
        done = self.solve(self.npy(rough()), "--pitch", "1um", "--unit", "m", "--modulus", "1GPa", "--load", "1e-15,1e-4,1e-15", "--quiet")
        self.assertEqual(done.stderr, 2 * "roughcontact: remark: one point in contact: check the pitch, or the map for a spike, which --despike 10 takes out\n")


class WrongInput(CommandTest):
    def test_refusals(self):
        """Every line of refusals.txt."""
        self.npy(paraboloid(24)), self.npy(rough(16, 16), "rough.npy")
        (self.folder / "folder").mkdir()
        begins, count = {}, 0
        for line in (Path(__file__).resolve().parents[1] / "refusals.txt").read_text("utf-8").splitlines():
            name, equals, text = line.partition(" = ")
            if equals and name.isupper():
                begins[name] = text
            elif not line.startswith("#"):
                words, _, says = line.partition(" => ")
                for _ in begins:
                    first, _, rest = words.partition(" ")
                    words = (begins.get(first, first) + " " + rest).strip()
                with self.subTest(line):
                    self.assert_fails(*shlex.split(words), says=says.split(" | "))
                count += 1
        self.assertGreater(count, 80)

    def test_out_is_a_file(self):
        self.npy(paraboloid(24))
        self.file("taken", "text")
        for out in ("taken", "taken/deeper"):
            self.assert_fails("solve", "surface.npy", "--pitch", "1e-6", "--modulus", "1e9", "--approach", "1e-8", "--out", out, says="--out")

    def test_message_stays_one_line(self):
        self.assert_fails("solve", "no\nsuch\x1b[31mfile.npy", "--modulus", "1", "--load", "1", says="no?such?[31mfile.npy")

    def test_failure_in_the_middle_keeps_earlier_steps(self):
        surface = self.npy(rough())
        done = self.solve(surface, "--pitch", "1e-6", "--unit", "m", "--modulus", "1e9", "--boundary", "periodic", "--approach", "1e-7,1", "--out", "out", code=1)
        self.assertIn("step 2", done.stderr)
        self.assertEqual(self.names("out"), ["contact-1.png", "gap-1.npy", "heights.npy", "pressure-1.npy", "steps.csv", "summary.json"])
        self.assertEqual(len(json.loads((self.folder / "out/summary.json").read_text())["steps"]), 1)
        self.assertRegex(done.stderr, r"^roughcontact: step 2: .*\n$")


if __name__ == "__main__":
    harness.main()
