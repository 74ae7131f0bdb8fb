"""`roughcontact solve --resume`: a history that was cut goes on with the bits of the one that was not."""
import csv
import json

import harness
from harness import CommandTest, np, rough, without_gnuplot

PRESS = ["--pitch", "1e-6", "--modulus", "1e9", "--boundary", "free"]
TIMES = ("seconds", "setup_seconds")


def said(folder):
    """summary.json without the times."""
    summary = json.loads((folder / "summary.json").read_text())
    for step in summary["steps"]:
        for name in TIMES:
            del step[name]
    return summary


def rows(folder):
    """steps.csv without the times."""
    with open(folder / "steps.csv", newline="") as file:
        return [{name: value for name, value in row.items() if name not in ("seconds [s]", "setup_seconds [s]")} for row in csv.DictReader(file)]


def assert_same_results(test, one, other):
    test.assertEqual(said(one), said(other))
    test.assertEqual(rows(one), rows(other))
    test.assertEqual(sorted(path.name for path in one.iterdir()), sorted(path.name for path in other.iterdir()))
    for path in one.glob("*.npy"):
        test.assertEqual(path.read_bytes(), (other / path.name).read_bytes(), path.name)


class Resume(CommandTest):
    def setUp(self):
        super().setUp()
        self.surface = self.npy(rough(32, 40))

    def press(self, targets, out, *arguments, control="--approach", **settings):
        return self.solve(self.surface, *PRESS, control, targets, "--out", out, *arguments, env=without_gnuplot(), **settings)

    def assert_refused(self, *arguments, says, surface=None):
        before = {path.name: path.read_bytes() for path in (self.folder / "out").iterdir()}
        self.assert_fails("solve", surface or self.surface, *arguments, "--out", "out", "--resume", says=says, env=without_gnuplot())
        self.assertEqual(before, {path.name: path.read_bytes() for path in (self.folder / "out").iterdir()})

    def both(self, targets, *arguments, control="--approach", times=()):
        """The folder of a history at once, the same as that of one to which each run, with a contact of its own, adds a step."""
        whole, cut = (self.folder / ("%s-%d" % (name, len(self.names()))) for name in ("whole", "cut"))
        for steps in (len(targets), *range(1, len(targets) + 1)):
            timed = ["--time", ",".join(times[:steps])] if times else []
            out = ["--resume"] if whole.exists() else []
            self.press(",".join(targets[:steps]), cut if out else whole, "--quiet", *out, *arguments, *timed, control=control)
        assert_same_results(self, cut, whole)
        return whole, cut

    def test_a_longer_history_goes_on(self):
        methods = [], ["--solver", "nnls", "--backend", "dense"], ["--solver", "polonsky-keer", "--backend", "fft"]
        for control, targets in (("--approach", ["5e-8", "1e-7", "2e-7", "1.9e-7", "3e-8", "2.5e-7"]), ("--pressure", ["1e5", "2e5", "1e6", "9e5", "1e4"]), ("--area", ["5%", "20%", "10%"])):
            for arguments in methods:
                self.both(targets, *arguments, control=control)

    def test_resumed_with_another_body(self):
        self.npy(rough(seed=1), "one.npy"), self.npy(rough(seed=2), "other.npy"), self.npy(rough(seed=3), "third.npy")
        common = ["solve", "one.npy", "--pitch", "1um", "--modulus", "1GPa", "--out", "out", "--quiet"]
        self.run_command(*common, "--against", "other.npy", "--approach", "1e-7", env=without_gnuplot())
        (self.folder / "other.npy").rename(self.folder / "moved.npy")
        done = self.run_command(*common, "--against", "moved.npy", "--approach", "1e-7,2e-7", "--resume", env=without_gnuplot())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_fails(*common, "--against", "third.npy", "--approach", "1e-7,2e-7", "--resume", says="checksum")

    def test_bodies_that_creep_go_on(self):
        targets, times = ["5e-8", "1e-7", "1e-7", "9e-8", "2e-7"], ["0", "1", "30", "30", "60"]
        creep = ["--creep", "0.5:1s,1.5:20s", "--hardness", "5e7", "--quiet"]
        whole, cut = self.both(targets, *creep[:-1], times=times)
        cut = cut.rename(self.folder / "out")
        self.assertEqual([path.name for path in whole.glob("creep-*")], ["creep-5.npy"])
        self.assertEqual(np.load(whole / "creep-5.npy").shape, (3 * 32, 40))
        summary = said(whole)
        self.assertEqual(summary["input"]["creep"], {"ratios": [0.5, 1.5], "times": [1, 20]})
        self.assertEqual([step["time"] for step in summary["steps"]], summary["input"]["times"])
        self.assertEqual([float(row["time [s]"]) for row in rows(whole)], summary["input"]["times"])
        again = [*PRESS, "--approach", ",".join([*targets, "1e-7"]), *creep]
        self.assert_refused(*again, "--time", "0,2,30,30,60,70", says="time of step 2 1, this one has 2")
        self.assert_refused(*again, "--time", "0,1,30,30,60,50", says="step 6 is at 50, before step 5 at 60")
        self.assert_refused(*[word.replace("1.5:20s", "1.5:21s") for word in again], "--time", "0,1,30,30,60,70", says="20")
        kept = (cut / "creep-5.npy").read_bytes()
        np.save(cut / "creep-5.npy", np.zeros((32, 40)))
        self.assert_refused(*again, "--time", "0,1,30,30,60,70", says="creep-5.npy has 40 x 32 points, the surface has 40 x 32, and 3 maps are needed")
        (cut / "creep-5.npy").unlink()
        self.assert_refused(*again, "--time", "0,1,30,30,60,70", says="creep-5.npy")
        (cut / "creep-5.npy").write_bytes(kept)
        self.assertEqual(self.press(",".join([*targets, "1e-7"]), cut, "--resume", *creep, "--time", "0,1,30,30,60,70").returncode, 0)

    def test_a_plastic_history_goes_on(self):
        yielding = ["--hardness", "2e7", "--solver", "polonsky-keer", "--quiet"]
        for control, targets in (("--approach", ["1e-7", "2e-7", "1.9e-7", "3e-8", "2.5e-7"]), ("--pressure", ["1e5", "1e6", "9e5", "1e4", "2e6"])):
            whole, _ = self.both(targets, *yielding[:-1], control=control)
            summary = said(whole)
            self.assertEqual(summary["input"]["hardness"], 2e7)
            last, step = np.load(whole / "indentation-5.npy"), summary["steps"][-1]
            self.assertGreater(step["capped"], 0)
            self.assertEqual(step["capped"], int((np.load(whole / "pressure-5.npy") == 2e7).sum()))
            added = (last - np.load(whole / "indentation-4.npy")).sum() * 1e-12
            self.assertAlmostEqual(step["plastic_volume"] / added, 1, places=9)
            self.assertTrue((np.load(whole / "indentation-4.npy") == np.load(whole / "indentation-2.npy")).all())
        self.press("1e-7", "out", *yielding)
        self.assert_refused(*PRESS, "--approach", "1e-7", "--quiet", says="is of a run with hardness 20000000.0, this one has nothing")

    def test_uncertified_steps_count_as_finished(self):
        few = ["--set", "max_iter=2", "--solver", "polonsky-keer", "--quiet"]
        self.press("1e-7,2e-7,1e-9", "whole", *few, code=2)
        self.press("1e-7,2e-7", "cut", *few, code=2)
        self.press("1e-7,2e-7,1e-9", "cut", "--resume", *few, code=2)
        assert_same_results(self, self.folder / "cut", self.folder / "whole")
        self.press("1e-7,2e-7,1e-9", "cut", "--resume", *few, code=2)

    def test_an_interrupted_step_is_solved_again(self):
        for out in ("whole", "cut"):
            self.press("1e-7,2e-7,2.5e-7", out, "--quiet")
        summary = json.loads((self.folder / "cut/summary.json").read_text())
        summary["steps"] = summary["steps"][:2]
        summary["steps"][1]["status"] = "RC_STOP_CANCELLED"
        self.file("cut/summary.json", json.dumps(summary))
        done = self.press("1e-7,2e-7,2.5e-7", "cut", "--resume")
        self.assertIn("1 of 3 steps are complete", done.stderr)
        self.assertEqual(len(done.stdout.splitlines()), 5)  # two of head, two steps, the conclusion
        assert_same_results(self, self.folder / "cut", self.folder / "whole")

    def test_nothing_to_go_on_from_is_a_beginning(self):
        self.press("1e-7,2e-7", "cut", "--quiet", "--resume")
        before = {path.name: path.read_bytes() for path in (self.folder / "cut").iterdir()}
        done = self.press("1e-7,2e-7", "cut", "--resume")
        self.assertEqual(done.stderr, "roughcontact: --resume: 2 of 2 steps are complete\n")
        self.assertEqual(before, {path.name: path.read_bytes() for path in (self.folder / "cut").iterdir()})

    def test_another_problem_is_refused(self):
        self.press("1e-7,2e-7", "out", "--quiet")
        good = [*PRESS, "--approach"]
        self.assert_refused(*good, "1e-7,2.5e-7,3e-7", says=["--resume", "summary.json", "target of step 2"])
        self.assert_refused(*good, "1e-7", says="complete steps 2, this one has 1")
        self.assert_refused(*good, "1e-7,2e-7,3e-7", "--tol", "1e-6", says="tol")
        self.assert_refused(*good, "1e-7,2e-7,3e-7", "--solver", "nnls", says="solver")
        self.assert_refused("--pitch", "1e-6", "--modulus", "2e9", "--boundary", "free", "--approach", "1e-7,2e-7,3e-7", says="modulus")
        self.assert_refused(*PRESS, "--load", "1e-7,2e-7,3e-7", says="control")
        self.assert_refused(*good, "1e-7,2e-7,3e-7", surface=self.npy(rough(32, 40, seed=2), "other.npy"), says="checksum")
        self.assert_fails("solve", self.surface, *good, "1e-7", "--resume", says=["--resume", "--out"])

    def test_a_step_that_is_none_is_refused(self):
        self.press("1e-7,2e-7", "out", "--quiet")
        path = self.folder / "out/summary.json"
        for damage in (None, {}, {"status": None}, {"approach": None}, {"load": "much"}):
            summary = json.loads(path.read_text())
            whole = summary["steps"][0]
            summary["steps"][0] = {**whole, **damage} if damage else damage
            path.write_text(json.dumps(summary))
            self.assert_refused(*PRESS, "--approach", "1e-7,2e-7,3e-7", says="belongs to no earlier run in summary.json")
            summary["steps"][0] = whole
            path.write_text(json.dumps(summary))

    def test_damaged_pressures_are_refused(self):
        self.press("1e-7,2e-7", "out", "--quiet")
        path, again = self.folder / "out/pressure-2.npy", [*PRESS, "--approach", "1e-7,2e-7,3e-7"]
        whole = np.load(path)
        for wrong in (whole[:-1], np.where(whole > 0, np.nan, whole)):
            np.save(path, wrong)
            self.assert_refused(*again, says="--resume")
        path.write_bytes(path.read_bytes()[:-8])
        self.assert_refused(*again, says="pressure-2.npy")
        path.unlink()
        self.assert_refused(*again, says="pressure-2.npy")


if __name__ == "__main__":
    harness.main()
