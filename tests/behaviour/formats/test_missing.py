"""Missing points and form removal: rules, what they do to heights, and that answers stay certified."""
import json

import reading
from harness import gsf, np, rough, without_gnuplot
from reading import ReaderTest

H = 1e-6
PRESS = ["--modulus", "1e9", "--approach", "1.5e-7"]


def holes(z, *places):
    out = z.copy()
    for iy, ix in places:
        out[iy, ix] = np.nan
    return out


def form(ny, nx, quadratic):
    y, x = np.mgrid[0:ny, 0:nx] * 1.0
    plane = 3 + 0.2 * x - 0.7 * y
    return plane + (0.01 * x * x - 0.02 * x * y + 0.005 * y * y if quadratic else 0)


class Filling(ReaderTest):
    def filled(self, z, hx=H, hy=H):
        return self.read(self.file("a.gsf", gsf(z, hx, hy, "XYUnits = m\nZUnits = m\n")), "--fill")[1]

    def test_one_hole_takes_the_weighted_mean_of_its_neighbours(self):
        z = np.arange(25.0).reshape(5, 5) ** 2
        for hx, hy in ((1, 1), (2, 1), (1, 3)):
            wx, wy = hx**-2, hy**-2
            expected = (wx * (z[2, 1] + z[2, 3]) + wy * (z[1, 2] + z[3, 2])) / (2 * wx + 2 * wy)
            self.assertAlmostEqual(self.filled(holes(z, (2, 2)), hx, hy)[2, 2], expected, delta=1e-9 * expected)

    def test_planes_are_kept_and_harmonic_heights_are_found(self):
        y, x = np.mgrid[0:20, 0:30] * 1.0
        for z in (2 + x - 3 * y, x * x - y * y):
            gap = z.copy()
            gap[5:12, 7:21] = np.nan
            np.testing.assert_allclose(self.filled(gap, 1, 1), z, atol=2e-4)  # float32 in the file

    def test_corners_edges_and_lonely_points(self):
        z = rough(12, 9, 1.0)
        out = self.filled(holes(z, (0, 0), (0, 1), (1, 0), (11, 8), (5, 0), (5, 1)))
        self.assertTrue(np.isfinite(out).all())
        lonely = np.full((6, 7), np.nan)
        lonely[3, 3] = 2.5
        np.testing.assert_allclose(self.filled(lonely), 2.5, rtol=1e-12)

    def test_no_summit_is_made_up(self):
        chance = np.random.default_rng(5)
        for share in (0.05, 0.5, 0.95):
            z = np.where(chance.random((40, 50)) < share, np.nan, rough(40, 50, 1.0))
            out = self.filled(z)
            self.assertGreaterEqual(out.min(), np.nanmin(z) - 1e-6)
            self.assertLessEqual(out.max(), np.nanmax(z) + 1e-6)


class Form(ReaderTest):
    def removed(self, z, which):
        return self.read(self.npy(z), "--remove", which)[1]

    def test_forms_are_taken_off_exactly(self):
        for ny, nx in ((30, 40), (7, 3), (1, 9), (9, 1), (2, 2), (1, 1)):
            np.testing.assert_allclose(self.removed(form(ny, nx, False), "plane"), 0, atol=1e-12)
            np.testing.assert_allclose(self.removed(form(ny, nx, True), "quadric"), 0, atol=1e-11)
            np.testing.assert_allclose(self.removed(np.full((ny, nx), 1e6), "mean"), 0, atol=1e-12)

    def test_against_numpy_with_missing_points(self):
        z = holes(rough(30, 40, 1.0) + form(30, 40, True), (0, 0), (3, 4), (29, 39))
        y, x = np.mgrid[0:30, 0:40] * 1.0
        there = ~np.isnan(z)
        for which, terms in (("mean", [x * 0 + 1]), ("plane", [x * 0 + 1, x, y]), ("quadric", [x * 0 + 1, x, y, x * x, x * y, y * y])):
            columns = np.stack([t[there] for t in terms], axis=1)
            best = np.linalg.lstsq(columns, z[there], rcond=None)[0]
            out = self.removed(z, which)
            np.testing.assert_allclose(out[there], z[there] - columns @ best, atol=1e-10)
            self.assertTrue(np.isnan(out[~there]).all())

    def test_none_changes_nothing(self):
        z = rough(5, 6)
        np.testing.assert_array_equal(self.removed(z, "none"), z)


class Rules(ReaderTest):
    def answer(self, *arguments, **settings):
        done = self.solve(*arguments, *PRESS, "--out", "out", env=without_gnuplot(), **settings)
        summary = json.loads((self.folder / "out/summary.json").read_text())
        return summary, np.load(self.folder / "out/pressure-1.npy"), np.load(self.folder / "out/gap-1.npy"), done

    def test_excluded_points_carry_nothing_and_the_others_are_certified(self):
        z = rough()
        top = np.unravel_index(z.argmax(), z.shape)
        z = holes(z, top, (3, 5), (20, 21), (20, 22))
        missing = np.isnan(z)
        for boundary in ("free", "periodic"):
            summary, p, gap, done = self.answer(self.npy(z), "--pitch", H, "--missing", "exclude", "--boundary", boundary)
            self.assertIn("4 missing points excluded", done.stdout)
            self.assertEqual((summary["input"]["missing"], summary["input"]["missing_rule"]), (4, "exclude"))
            self.assertEqual(summary["steps"][0]["status"], "RC_OK")
            self.assertTrue((p[missing] == 0).all())
            self.assertGreater(p.max(), 0)
            self.assertTrue(np.isfinite(gap[~missing]).all())
            self.assertGreaterEqual(gap[~missing].min(), -1e-6 * PRESS_LENGTH)

    def test_flat_maps_are_told_from_tilted_ones(self):
        tilted = np.arange(400.0).reshape(20, 20)
        for z, says in ((np.ones((20, 20)), ": the map is flat: "), (tilted, "the map is flat after its plane is removed")):
            self.assert_fails("analyze", self.npy(z), "--pitch", 1, "--unit", "m", says=says)

    def test_removed_form_is_stated(self):
        z = rough()
        done = self.run_command("analyze", self.npy(holes(z, (2, 2))), "--pitch", H, "--missing", "fill", "--remove", "quadric", "--json", "a.json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("quadric removed, 1 missing point filled", done.stdout)
        given = json.loads((self.folder / "a.json").read_text())["input"]
        self.assertEqual((given["removed"], given["missing"], given["missing_rule"]), ("quadric", 1, "fill"))


PRESS_LENGTH = 1.5e-7

if __name__ == "__main__":
    reading.main()
