"""The steps that are asked for: ranges of equal ratios, the load for an area, and which files of each step are written."""
import csv
import json

import harness
from harness import CommandTest, np, paraboloid, rough, without_gnuplot

PRESS = ["--pitch", "1e-6", "--modulus", "1e9", "--quiet"]


class Steps(CommandTest):
    def steps(self, *arguments, surface=None, out="out", **settings):
        self.solve(surface or self.npy(rough()), *PRESS, *arguments, "--out", out, env=without_gnuplot(), **settings)
        summary = json.loads((self.folder / out / "summary.json").read_text())
        return summary["steps"], summary["input"]


class Ratios(Steps):
    def test_a_range_of_equal_ratios(self):
        surface = self.npy(paraboloid(24))
        for option, text, values in (("--approach", "1nm:100nm:3log", [1e-9, 1e-8, 1e-7]), ("--load", "1uN:8uN:4log", [1e-6, 2e-6, 4e-6, 8e-6]), ("--pressure", "100kPa:1kPa:2log", [1e5, 1e3]),
                                     ("--load", "3uN:9uN:1log", [3e-6]), ("--area", "1%:4%:3log", [0.01, 0.02, 0.04])):
            _, given = self.steps(option, text, surface=surface)
            np.testing.assert_allclose(given["targets"], values, rtol=1e-12)
            self.assertEqual(given["targets"][0], values[0])
        for text, says in (("0:1uN:5log", "two ends above 0"), ("1uN:2uN:0log", "whole number"), ("1uN:2uN:log", "whole number"), ("1uN:2uN", "a..b:nlog")):
            self.assert_fails("solve", surface, *PRESS, "--load", text, says=["--load", says])


class Areas(Steps):
    def assert_near(self, steps, targets, points):
        for step, target in zip(steps, targets, strict=True):
            self.assertEqual(step["status"], "RC_OK")
            self.assertLessEqual(abs(step["area_fraction"] - target), max(1e-3 * target, 0.5001 / points))

    def test_the_load_for_an_area(self):
        z = rough(64, 64)
        targets = [0.001, 0.1, 0.5, 0.02]
        for boundary in ("free", "periodic"):
            steps, given = self.steps("--area", "0.1%,10%,50%,2%", "--boundary", boundary, surface=self.npy(z))
            self.assertEqual((given["control"], given["targets"]), ("area", targets))
            self.assert_near(steps, targets, z.size)
            again, _ = self.steps("--load", repr(steps[1]["load"]), "--boundary", boundary, surface=self.npy(z), out="again")
            self.assertAlmostEqual(again[0]["area_fraction"], steps[1]["area_fraction"], delta=1e-3)
        (step,), _ = self.steps("--area", "0.1", surface=self.npy(paraboloid(radius=1e-4)))
        self.assertLess(abs(step["contacts"] - 0.1 * 48**2), 4.5)  # points touch by four and by eight

    def test_a_body_that_yields_keeps_no_trace_of_other_loads(self):
        hard = ["--hardness", "2e7"]
        steps, _ = self.steps("--area", "10%,30%", *hard)
        self.assert_near(steps, [0.1, 0.3], 40 * 56)
        self.assertGreater(steps[1]["capped"], 0)
        loads = ",".join(repr(step["load"]) for step in steps)
        again, _ = self.steps("--load", loads, *hard, out="again")
        for one, other in zip(steps, again):
            self.assertAlmostEqual(one["plastic_volume"] / other["plastic_volume"], 1, delta=1e-5)
        np.testing.assert_allclose(np.load(self.folder / "out/indentation-2.npy"), np.load(self.folder / "again/indentation-2.npy"), atol=1e-6 * 1e-7)

    def test_it_goes_on_with_the_same_bits(self):
        for more in ([], ["--hardness", "2e7", "--solver", "polonsky-keer"]):
            whole, _ = self.steps("--area", "5%,20%,10%", *more, out="whole")
            for targets in ("5%", "5%,20%", "5%,20%,10%"):
                cut, _ = self.steps("--area", targets, *more, "--resume", out="cut")
            for step in whole + cut:
                del step["seconds"], step["setup_seconds"]
            self.assertEqual(whole, cut)
            for path in (self.folder / "whole").glob("*.npy"):
                self.assertEqual(path.read_bytes(), (self.folder / "cut" / path.name).read_bytes())
            for path in (self.folder / "cut").iterdir():
                path.unlink()

    def test_the_nearest_where_areas_jump(self):
        """A wave along x alone: whole columns touch at once."""
        z = 1e-8 * np.cos(2 * np.pi * np.arange(32) / 32)[None, :] * np.ones((8, 1))
        done = self.solve(self.npy(z), *PRESS, "--boundary", "periodic", "--area", "20%,100%,0", "--out", "out", env=without_gnuplot())
        self.assertIn("remark: area: 20 % asked, 21.9 % of the grid is the nearest that a load gives", done.stderr)
        steps = json.loads((self.folder / "out/summary.json").read_text())["steps"]
        self.assertEqual([step["area_fraction"] for step in steps], [7 / 32, 1, 0])

    def test_wrong_areas(self):
        surface = self.npy(rough())
        for text, says in (("20", "more than the whole"), ("120%", "more than the whole"), ("-1%", "negative"), ("1mm", "a length, expected a share"), ("1%,0.5", "give every number its unit")):
            self.assert_fails("solve", surface, *PRESS, "--area", text, says=["--area", says])
        self.assert_fails("solve", surface, *PRESS, "--area", "1%", "--load", "1", says=["only one", "--area"])


class Files(Steps):
    def test_names_sort_as_the_steps_do(self):
        self.steps("--approach", "1e-8:1e-7:10")
        for stem in ("gap", "pressure"):
            names = [name for name in self.names("out") if name.startswith(stem)]
            self.assertEqual(names, ["%s-%02d.npy" % (stem, k) for k in range(1, 11)])

    def test_a_history_that_grows_gets_new_names(self):
        targets = ["%de-9" % k for k in range(10, 22)]
        self.steps("--approach", ",".join(targets), "--write", "vti", out="whole")
        for count in (3, 9, 10, 12):
            self.steps("--approach", ",".join(targets[:count]), "--write", "vti", "--resume", out="cut")
            self.assertEqual(len([name for name in self.names("cut") if name.startswith("gap-")]), count)
        self.assertEqual(self.names("cut"), self.names("whole"))
        for name in self.names("whole"):
            if name.endswith(".npy"):
                self.assertEqual((self.folder / "cut" / name).read_bytes(), (self.folder / "whole" / name).read_bytes())
        self.steps("--approach", "1e-8", out="cut")
        self.assertEqual(self.names("cut"), ["gap-1.npy", "heights.npy", "pressure-1.npy", "steps.csv", "summary.json"])

    def test_tables_without_maps(self):
        self.solve(self.npy(rough()), *PRESS, "--approach", "1e-8:1e-7:3", "--out", "out", "--no-maps")
        self.assertEqual([name for name in self.names("out") if name != "history.png"], ["steps.csv", "summary.json"])
        with open(self.folder / "out/steps.csv", newline="") as file:
            self.assertEqual(len(list(csv.DictReader(file))), 3)
        surface = self.npy(rough())
        for arguments, says in ((["--no-maps"], "--out"), (["--out", "x", "--no-maps", "--write", "vti"], "not both"), (["--out", "x", "--no-maps", "--resume"], "--no-maps")):
            self.assert_fails("solve", surface, *PRESS, "--approach", "1e-8", *arguments, says=says)


if __name__ == "__main__":
    harness.main()
