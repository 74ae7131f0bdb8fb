"""What presses what: two rough surfaces, nominal shapes that carry the roughness, two elastic bodies."""
import json

import harness
from harness import CommandTest, gsf, np, rough, without_gnuplot

PRESS = ["--modulus", "1GPa", "--approach", "0,1.5e-7"]


class Bodies(CommandTest):
    def solved(self, *arguments, press=PRESS, **settings):
        self.solve(*arguments, *press, "--out", "out", "--quiet", env=without_gnuplot(), **settings)
        summary = json.loads((self.folder / "out/summary.json").read_text())
        return summary, np.load(self.folder / "out/gap-1.npy"), np.load(self.folder / ("out/pressure-%d.npy" % len(summary["steps"])))

    def heights(self, *arguments):
        """As pressed, less their largest."""
        return -self.solved(*arguments)[1]

    def test_two_moduli(self):
        def modulus(*arguments):
            return self.solved(self.npy(rough(16, 16)), "--pitch", "1um", *arguments, press=["--load", "1uN"])[0]["input"]["modulus"]

        self.assertEqual(modulus("--E", "210GPa", "--nu", "0.3"), 210e9 / (1 - 0.3**2))
        both = 1 / ((1 - 0.3**2) / 210e9 + (1 - 0.17**2) / 70e9)
        self.assertAlmostEqual(modulus("--E", "210GPa", "--nu", "0.3", "--E2", "70GPa", "--nu2", "0.17") / both, 1, delta=1e-14)
        self.assertAlmostEqual(modulus("--E2", "210GPa", "--nu2", "0.3", "--E", "70GPa", "--nu", "0.17") / both, 1, delta=1e-14)

    def test_moduli_refused(self):
        common = ["solve", self.npy(rough(16, 16)), "--pitch", "1um", "--load", "1uN"]
        for arguments, says in ((["--E", "1GPa", "--nu", "0", "--E2", "1GPa"], "--nu2 is missing"), (["--E2", "1GPa", "--nu2", "0"], "--E is missing"),
                                (["--modulus", "1GPa", "--E2", "1GPa", "--nu2", "0"], "not both"), (["--E", "1GPa", "--nu", "0", "--E2", "1GN", "--nu2", "0"], "--E2"),
                                (["--E", "1GPa", "--nu", "0", "--E2", "1GPa", "--nu2", "0.6"], ["--nu2", "(-1, 0.5]"])):
            self.assert_fails(*common, *arguments, says=says)

    def test_two_rough_surfaces(self):
        one, other = rough(seed=1), rough(seed=2)
        self.npy(one, "one.npy"), self.npy(other, "other.npy"), self.npy(one + other, "sum.npy")
        self.file("other.gsf", gsf(other.astype("f4"), 1e-6, 2e-6, "XYUnits = m\nZUnits = m\n"))
        _, gap, pressure = self.solved("sum.npy", "--pitch", "1um,2um")
        summary, gap_of_two, pressure_of_two = self.solved("one.npy", "--pitch", "1um,2um", "--against", "other.npy")
        np.testing.assert_array_equal(gap_of_two, gap)
        np.testing.assert_array_equal(pressure_of_two, pressure)
        self.assertEqual(summary["input"]["against"], "other.npy")
        np.testing.assert_allclose(self.solved("one.npy", "--pitch", "1um,2um", "--against", "other.gsf")[1], gap, atol=1e-6 * np.ptp(gap))
        tilted = other + np.linspace(0, 1e-6, 56)
        self.npy(tilted, "tilted.npy"), self.npy(one + tilted, "sum.npy")
        np.testing.assert_allclose(self.heights("one.npy", "--pitch", "1um", "--against", "tilted.npy", "--remove", "plane"),
                                   self.heights("sum.npy", "--pitch", "1um", "--remove", "plane"), atol=1e-12 * np.ptp(one))
        other[3, 4] = np.nan
        self.npy(other, "holed.npy")
        self.assertTrue(np.isnan(self.heights("one.npy", "--pitch", "1um", "--against", "holed.npy", "--missing", "exclude")[3, 4]))

    def test_other_grids_are_refused(self):
        self.npy(rough(), "one.npy"), self.npy(rough(40, 55), "narrow.npy")
        self.file("fine.gsf", gsf(rough(), 0.5e-6, 2e-6, "XYUnits = m\nZUnits = m\n"))
        common = ["solve", "one.npy", "--pitch", "1um,2um", *PRESS]
        self.assert_fails(*common, "--against", "narrow.npy", says=["--against", "narrow.npy has 55 x 40 points, pitch 1 \u00b5m x 2 \u00b5m", "one.npy has 56 x 40 points"])
        self.assert_fails(*common, "--against", "fine.gsf", says=["fine.gsf has 56 x 40 points, pitch 500 nm x 2 \u00b5m", "one.npy has 56 x 40 points, pitch 1 \u00b5m x 2 \u00b5m"])
        self.assert_fails(*common, "--against", "none.npy", says="none.npy")

    def test_resumed_with_another_body(self):
        self.npy(rough(seed=1), "one.npy"), self.npy(rough(seed=2), "other.npy"), self.npy(rough(seed=3), "third.npy")
        common = ["solve", "one.npy", "--pitch", "1um", "--modulus", "1GPa", "--out", "out", "--quiet"]
        self.run_command(*common, "--against", "other.npy", "--approach", "1e-7", env=without_gnuplot())
        (self.folder / "other.npy").rename(self.folder / "moved.npy")
        done = self.run_command(*common, "--against", "moved.npy", "--approach", "1e-7,2e-7", "--resume", env=without_gnuplot())
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assert_fails(*common, "--against", "third.npy", "--approach", "1e-7,2e-7", "--resume", says="checksum")

    def test_shapes(self):
        ny, nx = 40, 56
        y, x = (np.arange(ny) - 19.5)[:, None] * 2e-6, (np.arange(nx) - 27.5)[None, :] * 1e-6
        base = rough()
        self.npy(base)
        for text, shape in (("sphere:R=1mm", np.sqrt(1e-6 - x**2 - y**2) - 1e-3), ("cylinder:R=1mm,axis=x", np.sqrt(1e-6 - y**2) - 1e-3 + 0 * x),
                            ("cylinder:axis=y,R=0.001", np.sqrt(1e-6 - x**2) - 1e-3 + 0 * y), ("wedge:angle=5deg,axis=y", -np.abs(x) * np.tan(np.radians(5)) + 0 * y),
                            ("wedge:angle=10mrad", -np.abs(y) * np.tan(0.01) + 0 * x)):
            z = base + shape
            summary, gap, _ = self.solved("surface.npy", "--pitch", "1um,2um", "--shape", text, press=["--modulus", "1GPa", "--approach", "0"])
            np.testing.assert_allclose(-gap, z - z.max(), atol=1e-9 * np.ptp(z))
            self.assertEqual(summary["input"]["shape"], text)
        # After the form is removed, which would else be the shape's.
        heights = self.heights("surface.npy", "--pitch", "1um,2um", "--shape", "wedge:angle=5deg,axis=y", "--remove", "quadric")
        self.assertGreater(np.ptp(heights), 27e-6 * np.tan(np.radians(5)))

    def test_smooth_sphere_is_hertz(self):
        self.npy(np.zeros((48, 48)))
        summary, _, _ = self.solved("surface.npy", "--pitch", "1um", "--shape", "sphere:R=1mm", press=["--modulus", "70GPa", "--approach", "256nm"])
        self.assertAlmostEqual(summary["steps"][0]["load"] / (4 / 3 * 70e9 * 1e-3**0.5 * 256e-9**1.5), 1, delta=0.01)

    def test_shapes_refused(self):
        common = ["solve", self.npy(rough()), "--pitch", "1um,2um", *PRESS, "--shape"]
        for text, says in (("spher:R=1mm", ['did you mean "sphere"?', "cylinder"]), ("sphere", "has no size"), ("sphere:", "key=value"), ("sphere:1mm", "key=value"),
                           ("sphere:R=0", "not positive"), ("sphere:R=1GPa", ["R", "is a pressure", "expected a length"]), ("sphere:R=1mm,axis=x", "no axis"),
                           ("sphere:r=1mm", ['"r"', "R"]), ("sphere:R=40um", ["reaches", "beyond R = 40 \u00b5m"]), ("cylinder:axis=x", "has no size"),
                           ("cylinder:R=1mm,axis=z", ["axis", "x or y"]), ("wedge:angle=5", ["no unit", "deg or rad"]), ("wedge:angle=90deg", "below 90deg"),
                           ("wedge:angle=5mm", ["is a length", "expected an angle"]), ("wedge:R=1mm", ['"R"', "angle"])):
            with self.subTest(text):
                self.assert_fails(*common, text, says=["--shape"] + ([says] if isinstance(says, str) else says))


if __name__ == "__main__":
    harness.main()
