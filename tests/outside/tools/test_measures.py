"""What summary.json says of the contact's shape, against NumPy and flood fills."""
import json

import harness
from harness import CommandTest, np, rough, without_gnuplot


def flooded(inside, periodic):
    """The connected parts, each as a set of points."""
    left = set(zip(*np.nonzero(inside)))
    while left:
        border = [left.pop()]
        met = set(border)
        while border:
            y, x = border.pop()
            for point in ((y + 1, x), (y - 1, x), (y, x + 1), (y, x - 1)):
                point = (point[0] % inside.shape[0], point[1] % inside.shape[1]) if periodic else point
                if point in left:
                    left.discard(point)
                    met.add(point)
                    border.append(point)
        yield met


def crossing(inside, periodic):
    """The sides at the ends of an axis stay apart; across it a periodic map repeats."""
    found = ""
    for name, along in (("x", inside.T), ("y", inside)):
        n, width = along.shape
        met = {(0, k) for k in np.flatnonzero(along[0])}
        border = list(met)
        while border:
            i, k = border.pop()
            for point in ((i + 1, k), (i - 1, k), (i, k + 1), (i, k - 1)):
                point = (point[0], point[1] % width) if periodic else point
                if 0 <= point[0] < n and 0 <= point[1] < width and along[point] and point not in met:
                    met.add(point)
                    border.append(point)
        if any(i == n - 1 for i, _ in met):
            found += name
    return found or "none"


class Measures(CommandTest):
    def steps(self, z, *arguments):
        self.solve(self.npy(z), "--pitch", "1um,2um", "--modulus", "1GPa", *arguments, "--out", "out", "--quiet", env=without_gnuplot())
        for k, step in enumerate(json.loads((self.folder / "out/summary.json").read_text())["steps"], 1):
            yield step, np.load(self.folder / ("out/pressure-%d.npy" % k)), np.load(self.folder / ("out/gap-%d.npy" % k))

    def test_against_numpy(self):
        crossed = set()
        for seed, boundary in ((1, "free"), (2, "periodic"), (3, "free"), (4, "periodic")):
            z = rough(24, 32, seed=seed)
            for step, pressure, gap in self.steps(z, "--boundary", boundary, "--pressure", "0.5MPa:20MPa:8"):
                contact, periodic = pressure > 0, boundary == "periodic"
                self.assertEqual(step["max_pressure"], pressure.max())
                self.assertAlmostEqual(step["mean_gap"], gap.mean(), delta=1e-12 * np.ptp(z))
                parts = [len(part) for part in flooded(contact, periodic)]
                self.assertEqual(step["patches"], len(parts))
                self.assertAlmostEqual(step["largest_patch"] / (max(parts) * 2e-12), 1, delta=1e-12)
                area = contact.sum() * 2e-12
                self.assertTrue(0.5 * area < step["corrected_area"] <= area)
                self.assertEqual(step["contact_crosses"], crossing(contact, periodic))
                self.assertEqual(step["gap_crosses"], crossing(~contact, periodic))
                crossed |= {step["contact_crosses"], step["gap_crosses"]}
        self.assertEqual(json.loads((self.folder / "out/summary.json").read_text())["input"]["crossing"], "along x with y periodic, along y with x periodic")
        self.assertIn("none", crossed)
        self.assertIn("xy", crossed)

    def test_ridges(self):
        y, x = np.mgrid[:32, :32] / 32
        for z, boundary, contact, gap in ((np.cos(2 * np.pi * x), "free", "y", "y"), (np.cos(2 * np.pi * y), "periodic", "x", "x"),
                                          (np.cos(2 * np.pi * (x + y)), "periodic", "xy", "xy"), (np.cos(2 * np.pi * x) * np.cos(2 * np.pi * y), "periodic", "none", "xy")):
            ((step, _, _),) = self.steps(1e-7 * z, "--boundary", boundary, "--pressure", "1MPa")
            self.assertEqual((step["contact_crosses"], step["gap_crosses"]), (contact, gap))
        ((step, _, _),) = self.steps(1e-9 * np.cos(2 * np.pi * x), "--boundary", "periodic", "--pressure", "10MPa")
        self.assertEqual((step["contact_crosses"], step["gap_crosses"], step["patches"]), ("xy", "none", 1))

    def test_excluded_points(self):
        z = rough(24, 32)
        z[:, 10] = np.nan
        for step, pressure, gap in self.steps(z, "--missing", "exclude", "--pressure", "1MPa,20MPa"):
            self.assertEqual(step["max_pressure"], pressure.max())
            self.assertAlmostEqual(step["mean_gap"], np.nanmean(gap), delta=1e-20)
            self.assertNotIn("x", step["contact_crosses"] + step["gap_crosses"])

    def test_overlaps_of_yielding_points_are_closed(self):
        for step, pressure, gap in self.steps(rough(24, 32), "--hardness", "40MPa", "--pressure", "5MPa,20MPa"):
            self.assertEqual(step["max_pressure"], 40e6)
            self.assertLess(gap.min(), 0)
            self.assertAlmostEqual(step["mean_gap"] / np.where(pressure == 40e6, np.maximum(gap, 0), gap).mean(), 1, delta=1e-12)

    def test_nothing_in_contact(self):
        ((step, _, gap),) = self.steps(rough(24, 32), "--load", "0")
        self.assertEqual([step[name] for name in ("max_pressure", "corrected_area", "patches", "largest_patch", "contact_crosses", "gap_crosses")], [0, 0, 0, 0, "none", "xy"])
        self.assertAlmostEqual(step["mean_gap"], gap.mean(), delta=1e-20)


if __name__ == "__main__":
    harness.main()
