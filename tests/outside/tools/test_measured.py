"""Surfaces at about 1, 10 and 40 % contact: certified in both controls, which agree with each other.

test_measured.py ROUGHCONTACT FOLDER: every .gsf file below FOLDER.
"""
import json
import os
import sys
from pathlib import Path

import harness
from harness import CommandTest, np, without_gnuplot

FOLDER = Path(sys.argv.pop(2)) if len(sys.argv) > 2 else Path()


class Measured(CommandTest):
    def slope_of(self, surface):
        """The rms slope, to which the mean pressure at a given contact area is proportional."""
        done = self.run_command("analyze", surface, "--missing", "fill", "--json", "found.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / "found.json").read_text())["statistics"]["rms_slope"]

    def steps(self, surface, *arguments):
        self.solve(surface, "--modulus", "1", "--tol", "1e-8", "--threads", os.cpu_count(), *arguments, "--out", "out", "--quiet",
                   "--missing", "exclude", env=without_gnuplot(), timeout=3000)
        return json.loads((self.folder / "out/summary.json").read_text())["steps"]

    def test_approach_and_load_control_agree(self):
        for surface in sorted(FOLDER.rglob("*.gsf")):
            with self.subTest(surface.stem):
                pressures = (self.slope_of(surface) * p for p in (0.005, 0.05, 0.2))
                loaded = self.steps(surface, "--pressure", ",".join(map(repr, map(float, pressures))))
                pressed = self.steps(surface, "--approach", ",".join(repr(step["approach"]) for step in loaded))
                back = self.steps(surface, "--load", ",".join(repr(step["load"]) for step in pressed))
                self.assertEqual({step["status"] for step in loaded + pressed + back}, {"RC_OK"})
                worst = max(step["kkt_" + kind] for step in loaded + pressed + back for kind in ("primal", "dual", "complementarity", "control"))
                self.assertLessEqual(worst, 1e-8)
                approach = [[step["approach"] for step in steps] for steps in (pressed, back)]
                np.testing.assert_allclose(approach[1], approach[0], rtol=1e-7)
                for step, again in zip(pressed, back):
                    print("%-24s contact %5.1f %%  approach %.4e, recovered to %.0e  certificate %.0e  %.1f s" % (
                        surface.stem, 100 * step["area_fraction"], step["approach"],
                        abs(again["approach"] / step["approach"] - 1), worst, step["seconds"]), flush=True)


if __name__ == "__main__":
    if not FOLDER.is_dir():
        print("skipped: no surfaces in", FOLDER)
        sys.exit(77)
    harness.main()
