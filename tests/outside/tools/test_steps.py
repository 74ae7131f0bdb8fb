"""The steps that are asked for: areas that go on, and which files of each step are written."""
import csv
import json

import harness
from harness import CommandTest, rough, without_gnuplot

PRESS = ["--pitch", "1e-6", "--modulus", "1e9", "--quiet"]


class Steps(CommandTest):
    def steps(self, *arguments, surface=None, out="out", **settings):
        self.solve(surface or self.npy(rough()), *PRESS, *arguments, "--out", out, env=without_gnuplot(), **settings)
        summary = json.loads((self.folder / out / "summary.json").read_text())
        return summary["steps"], summary["input"]


class Areas(Steps):
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
