"""The folder that `roughcontact solve` writes: which files of each step, whole at every moment."""
import csv
import json

import harness
from harness import CommandTest, np, rough, without_gnuplot

PRESS = ["--modulus", "1e9", "--approach", "1.5e-7", "--boundary", "free"]


class Writing(CommandTest):
    def test_files_of_a_sequence(self):
        z = rough()
        self.solve(self.npy(z), "--pitch", "1e-6,2e-6", "--modulus", "1e9", "--approach", "1e-7,2e-7", "--out", "deep/out")
        self.assertEqual(self.names("deep/out"), sorted(["heights.npy", "history.png", "steps.csv", "summary.json"] + [n % k for k in (1, 2) for n in ("contact-%d.png", "gap-%d.npy", "pressure-%d.npy")]))
        for name in ("gap-1.npy", "pressure-2.npy"):
            array = np.load(self.folder / "deep/out" / name)
            self.assertEqual((array.dtype.str, array.shape, array.flags.c_contiguous), ("<f8", z.shape, True))
        picture = (self.folder / "deep/out/contact-2.png").read_bytes()
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
        self.assertTrue(picture.endswith(b"IEND\xaeB`\x82"))

    def test_steps_as_a_table(self):
        units = {"approach": "m", "load": "N", "mean_pressure": "Pa", "max_pressure": "Pa", "mean_gap": "m", "corrected_area": "m^2", "largest_patch": "m^2",
                 "stiffness": "N/m", "seconds": "s", "plastic_volume": "m^3"}
        few = ["--hardness", "2e7", "--set", "max_iter=2", "--solver", "polonsky-keer"]
        self.solve(self.npy(rough()), "--pitch", "1um", "--modulus", "1GPa", "--pressure", "1e5,1e6", "--out", "out", "--quiet", *few, code=2, env=without_gnuplot())
        steps = json.loads((self.folder / "out/summary.json").read_text())["steps"]
        with open(self.folder / "out/steps.csv", newline="") as file:
            head, *rows = csv.reader(file)
        names = [name.split(" [")[0] for name in head]
        self.assertEqual(names, ["step", *steps[0]])
        self.assertEqual({name: unit.rstrip("]") for name, _, unit in (field.partition(" [") for field in head) if unit and name in units}, units)
        self.assertEqual(len(rows), 2)
        for k, (row, step) in enumerate(zip(rows, steps), 1):
            self.assertTrue("," in step["message"] or "," in step["note"], step)  # what has to stand in quotes
            for name, text in zip(names, row):
                value = k if name == "step" else step[name]
                self.assertEqual(text, "" if value is None else value if isinstance(value, str) else json.dumps(value) if isinstance(value, int) else text)
                if isinstance(value, float):
                    self.assertEqual(float(text), value)

    def test_steps_of_an_earlier_run_go(self):
        common = [self.npy(rough()), "--pitch", "1e-6", "--modulus", "1e9", "--out", "out"]
        self.solve(*common, "--approach", "1e-7,2e-7,3e-7")
        self.file("out/pressure-9.npy", "of the user's own")
        self.solve(*common, "--approach", "1e-7", env=without_gnuplot())
        self.assertEqual(self.names("out"), ["gap-1.npy", "heights.npy", "pressure-1.npy", "pressure-9.npy", "steps.csv", "summary.json"])

    def test_without_gnuplot_all_but_the_pictures(self):
        done = self.solve(self.npy(rough()), "--pitch", "1e-6", "--modulus", "1e9", "--boundary", "periodic", "--approach", "1e-8,2e-8", "--out", "out", "--quiet",
                          "--unit", "m", env=without_gnuplot())
        self.assertEqual(done.stderr, "roughcontact: gnuplot not found: contact-K.png not drawn\n")
        self.assertEqual(self.names("out"), ["gap-1.npy", "gap-2.npy", "heights.npy", "pressure-1.npy", "pressure-2.npy", "steps.csv", "summary.json"])

    def test_gnuplot_that_fails_leaves_no_picture(self):
        environment = self.with_gnuplot("echo half a picture\necho boom >&2\nexit 3\n")
        done = self.solve(self.npy(rough()), "--pitch", "1um", "--unit", "m", *PRESS, "--out", "out", "--quiet", env=environment)
        self.assertEqual(done.stderr, "roughcontact: contact-1.png not drawn, gnuplot failed: boom\n")
        self.assertEqual(self.names("out"), ["gap-1.npy", "heights.npy", "pressure-1.npy", "steps.csv", "summary.json"])

    def steps_of(self, *arguments, out="out"):
        self.solve(self.npy(rough()), *PRESS[:2], "--pitch", "1e-6", "--quiet", *arguments, "--out", out, env=without_gnuplot())

    def test_a_history_that_grows_gets_new_names(self):
        targets = ["%de-9" % k for k in range(10, 22)]
        self.steps_of("--approach", ",".join(targets), "--write", "vti", out="whole")
        for count in (3, 9, 10, 12):
            self.steps_of("--approach", ",".join(targets[:count]), "--write", "vti", "--resume", out="cut")
            self.assertEqual(len([name for name in self.names("cut") if name.startswith("gap-")]), count)
        self.assertEqual(self.names("cut"), self.names("whole"))
        for name in self.names("whole"):
            if name.endswith(".npy"):
                self.assertEqual((self.folder / "cut" / name).read_bytes(), (self.folder / "whole" / name).read_bytes())
        self.steps_of("--approach", "1e-8", out="cut")
        self.assertEqual(self.names("cut"), ["gap-1.npy", "heights.npy", "pressure-1.npy", "steps.csv", "summary.json"])

    def test_tables_without_maps(self):
        self.solve(self.npy(rough()), "--pitch", "1e-6", "--modulus", "1e9", "--quiet", "--approach", "1e-8:1e-7:3", "--out", "out", "--no-maps")
        self.assertEqual([name for name in self.names("out") if name != "history.png"], ["steps.csv", "summary.json"])
        with open(self.folder / "out/steps.csv", newline="") as file:
            self.assertEqual(len(list(csv.DictReader(file))), 3)


if __name__ == "__main__":
    harness.main()
