"""Measured surfaces at about 1, 10 and 40 % contact: certified in both controls, which agree with each other.

test_measured.py ROUGHCONTACT FOLDER [all]: without "all" only those of up to 512 x 512 points, which take about a minute.
"""
import json
import os
import sys
from pathlib import Path

import harness
from harness import CommandTest, np, without_gnuplot

DATA = Path(sys.argv.pop(2)) if len(sys.argv) > 2 else Path()
ALL = sys.argv[2:] == ["all"] and bool(sys.argv.pop(2))
LARGE = {"measured/confocal_lay_1275um", "measured/x3p_rectpix_83x204um", "measured-lgpl/fv_rubber_2mm", "measured-lgpl/fv_skibase_4mm"}
# With modulus 1: rms slope, to which the mean pressure at a given contact area is proportional.
SURFACES = {
    "measured/afm_film_10um": 0.223,
    "measured/afm_film_10um_crop128": 0.223,
    "measured/afm_selfaffine_10um": 0.192,
    "measured/afm_patch_10um": 0.179,
    "measured/confocal_lay_1275um": 0.0046,
    "measured/x3p_rectpix_83x204um": 0.062,
    "measured-lgpl/fv_rubber_2mm": 0.144,
    "measured-lgpl/fv_rubber_2mm_crop256": 0.144,
    "measured-lgpl/fv_skibase_4mm": 0.390,
}


class Measured(CommandTest):
    def steps(self, surface, *arguments):
        self.solve(surface, "--modulus", "1", "--tol", "1e-8", "--threads", os.cpu_count(), *arguments, "--out", "out", "--quiet",
                   env=without_gnuplot(), timeout=3000)
        return json.loads((self.folder / "out/summary.json").read_text())["steps"]

    def test_displacement_and_load_control_agree(self):
        for name, slope in SURFACES.items():
            if name in LARGE and not ALL:
                continue
            surface = DATA / (name + ".gsf")
            with self.subTest(name):
                loaded = self.steps(surface, "--pressure", ",".join(repr(slope * p) for p in (0.005, 0.05, 0.2)))
                pressed = self.steps(surface, "--displacement", ",".join(repr(step["displacement"]) for step in loaded))
                back = self.steps(surface, "--load", ",".join(repr(step["load"]) for step in pressed))
                self.assertEqual({step["status"] for step in loaded + pressed + back}, {"RC_OK"})
                worst = max(step["kkt_" + kind] for step in loaded + pressed + back for kind in ("primal", "dual", "complementarity", "control"))
                self.assertLessEqual(worst, 1e-8)
                approach = [[step["displacement"] for step in steps] for steps in (pressed, back)]
                np.testing.assert_allclose(approach[1], approach[0], rtol=1e-7)
                for step, again in zip(pressed, back):
                    print("%-36s contact %5.1f %%  approach %.4e, recovered to %.0e  certificate %.0e  %.1f s" % (
                        name, 100 * step["area_fraction"], step["displacement"],
                        abs(again["displacement"] / step["displacement"] - 1), worst, step["seconds"]), flush=True)


if __name__ == "__main__":
    if not (DATA / "measured").is_dir():
        print("skipped: no measured surfaces in", DATA)
        sys.exit(77)
    harness.main()
