"""`solve --leak` and `solve --closing-pressure`."""

import json
import re

import numpy as np
from harness import CommandTest, main, rough, without_gnuplot

FLUID = "viscosity=1mPas,drop=1bar"


class Leaks(CommandTest):
    def setUp(self):
        super().setUp()
        self.surface = [self.npy(rough(48, 48)), "--pitch", "1um", "--unit", "m", "--modulus", "1GPa", "--boundary", "periodic"]

    def steps(self, *arguments):
        done = self.solve(*self.surface, *arguments, "--out", "out", "--no-maps", env=without_gnuplot())
        return done.stdout, json.loads((self.folder / "out/summary.json").read_text())

    def test_steps_have_intervals_that_fall_with_the_pressure(self):
        said, summary = self.steps("--pressure", "1MPa,5MPa,20MPa,1GPa", "--leak", FLUID)
        first, second, last, full = summary["steps"]
        for step in (first, second):
            self.assertTrue(0 < step["leak_lower"] <= step["leak"] <= step["leak_upper"] < 1.01 * step["leak_lower"])
            self.assertTrue(step["constriction"] > 0 and 0 <= step["constriction_x"] < 48 and 0 <= step["constriction_y"] < 48)
        self.assertGreater(first["leak_lower"], second["leak_upper"])
        self.assertEqual((last["leak"], last["leak_upper"], last["gap_crosses"], last["constriction_x"]), (0, 0, "none", -1))
        self.assertEqual([full[name] for name in ("leak", "leak_upper", "gap_crosses")], [0, None, "none"])
        self.assertIn("leak along x 0 m^3/s, no bound is known\n", said)
        self.assertEqual((summary["input"]["viscosity"], summary["input"]["pressure_drop"], summary["input"]["leak_along"]), (1e-3, 1e5, "x"))
        lines = re.findall(r"leak along x (\S+) m\^3/s, exact at this approach: (\S+) \.\. (\S+); lowest gap on the best path [\d.]+ nm", said)
        np.testing.assert_allclose(np.array(lines[1], float), [second[name] for name in ("leak", "leak_lower", "leak_upper")], rtol=1e-3)
        self.assertIn("leak along x 0: no path through the gap is left, proven", said)
        header = (self.folder / "out/steps.csv").read_text().splitlines()[0]
        self.assertIn("leak [m^3/s],leak_lower [m^3/s],leak_upper [m^3/s],constriction [m]", header)

    def test_a_history_with_leaks_goes_on_and_no_other(self):
        _, whole = self.steps("--pressure", "1MPa,2MPa", "--leak", FLUID)
        (self.folder / "out").rename(self.folder / "whole")
        arguments = [*self.surface, "--leak", FLUID, "--out", "out", "--quiet"]
        self.solve(*arguments, "--pressure", "1MPa", env=without_gnuplot())
        self.solve(*arguments, "--pressure", "1MPa,2MPa", "--resume", env=without_gnuplot())
        resumed = json.loads((self.folder / "out/summary.json").read_text())
        for mine, other in zip(resumed["steps"], whole["steps"]):
            self.assertEqual([mine[name] for name in ("leak_lower", "leak_upper")], [other[name] for name in ("leak_lower", "leak_upper")])
        arguments[arguments.index(FLUID)] = "viscosity=2mPas,drop=1bar"
        self.assert_fails("solve", *arguments, "--pressure", "1MPa,2MPa", "--resume", says="viscosity")


if __name__ == "__main__":
    main()
