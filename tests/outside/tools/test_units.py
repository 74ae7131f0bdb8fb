"""Quantities with units: every option that is a length, a pressure or a force, right and wrong."""
import json

import harness
from harness import CommandTest, gsf, np, paraboloid, without_gnuplot

GOOD = {"--pitch": "1e-6", "--modulus": "1e9", "--approach": "1e-8"}


def words(options):
    return [word for pair in options.items() for word in pair]


class Units(CommandTest):
    def input_of(self, **changes):
        """What summary.json says of the input, and its first step, with some of the good options changed or left out (None)."""
        options = {**GOOD, **{"--" + name: value for name, value in changes.items()}}
        options = {name: value for name, value in options.items() if value is not None}
        self.solve(self.npy(paraboloid(24)), *words(options), "--out", "out", "--quiet", env=without_gnuplot())
        summary = json.loads((self.folder / "out/summary.json").read_text())
        return summary["input"], summary["steps"][0]

    def test_lengths(self):
        for text, metres in (("39nm", 39e-9), ("0.039um", 39e-9), ("0.039\u00b5m", 39e-9), ("0.039\u03bcm", 39e-9), ("39 nm", 39e-9), ("3.9e4pm", 39e-9),
                             ("1mm", 1e-3), ("2m", 2), ("1km", 1e3), ("1cm", 1e-2), ("390A", 39e-9), ("390\u00c5", 39e-9), ("1micron", 1e-6), ("1Mm", 1e6), ("1Gm", 1e9), ("1Tm", 1e12), ("39e-9", 39e-9)):
            given, _ = self.input_of(pitch=text, approach="0")
            np.testing.assert_allclose((given["hx"], given["hy"]), metres, rtol=1e-15)
        given, _ = self.input_of(pitch="1um,2000nm", approach="10nm,0.02um")
        np.testing.assert_allclose((given["hx"], given["hy"], *given["targets"]), (1e-6, 2e-6, 1e-8, 2e-8), rtol=1e-15)

    def test_a_unit_goes_before_that_of_the_command_line(self):
        given, _ = self.input_of(unit="mm", pitch="1e-3", approach="10nm")
        np.testing.assert_allclose((given["hx"], given["targets"][0]), (1e-6, 1e-8), rtol=1e-15)

    def test_what_is_assumed_is_said(self):
        z = paraboloid(24)
        press = ["--pitch", "1um", "--modulus", "1e9", "--boundary", "free", "--quiet"]
        said = "note: lengths without a unit are taken in m (heights of surface.npy); --unit names another\n"
        for command, how in (("solve", ["--load", "1uN", "--out", "out"]), ("law", ["--pressure", "1kPa..1MPa", "--tolerance", "10%", "--json", "law.json"])):
            done = self.run_command(command, self.npy(z), *press, *how, env=without_gnuplot())
            self.assertEqual(done.stderr.count(said), 1, done.stderr)
            self.assertNotIn("without a unit", self.run_command(command, self.npy(z), *press, *how, "--unit", "m", env=without_gnuplot()).stderr)
        given, _ = self.input_of(pitch="1e-6")
        self.assertEqual(given["assumed"], ["lengths without a unit are taken in m (heights of surface.npy, --pitch); --unit names another"])
        self.assertEqual(self.input_of(pitch="1um", unit="m")[0]["assumed"], [])
        self.file("named.gsf", gsf(z, 1e-6, 1e-6, "XYUnits = m\nZUnits = m\n"))
        self.assert_fails("solve", "named.gsf", *press[2:], "--load", "1uN", "--unit", "um", says=["named.gsf", "is m in the file", "um"])
        np.save(self.folder / "other.npy", 1e6 * z)  # of two files, one leaves its unit open
        done = self.solve("named.gsf", "--against", "other.npy", "--unit", "um", "--modulus", "1e9", "--load", "1uN", "--quiet")
        self.assertNotIn("note: lengths", done.stderr)

    def test_pressures_and_forces(self):
        for text, pascals in (("210GPa", 210e9), ("0.21TPa", 210e9), ("210e3 MPa", 210e9), ("210e6kPa", 210e9), ("210e9Pa", 210e9), ("210e9", 210e9)):
            np.testing.assert_allclose(self.input_of(modulus=text)[0]["modulus"], 210e9, rtol=1e-15)
            np.testing.assert_allclose(self.input_of(modulus=None, E=text, nu="0")[0]["modulus"], 210e9, rtol=1e-15)
        for text, newtons in (("1mN,2mN", [1e-3, 2e-3]), ("1mN:3mN:3", [1e-3, 2e-3, 3e-3]), ("100uN", [1e-4]), ("0,1mN", [0, 1e-3]), ("1e-9MN", [1e-3])):
            given, _ = self.input_of(approach=None, load=text)
            np.testing.assert_allclose(given["targets"], newtons, rtol=1e-14)
        self.assertEqual(self.input_of(hardness="20MPa")[0]["hardness"], 20e6)
        given, step = self.input_of(approach=None, pressure="5kPa")
        np.testing.assert_allclose((given["targets"][0], step["load"]), (5e3, 5e3 * 24**2 * 1e-12), rtol=1e-9)

    def test_milli_and_mega(self):
        milli, mega = (self.input_of(approach=None, load=text)[0]["targets"][0] for text in ("2mN", "2e-9MN"))
        self.assertAlmostEqual(milli / mega, 1, delta=1e-14)

    def test_refused(self):
        self.npy(paraboloid(24))
        for changes, says in (
                ({"--pitch": "39nmm"}, ["--pitch", "39nmm", "not known", "a length", "nm"]),
                ({"--pitch": "39Pa"}, ["--pitch", "39Pa", "is a pressure", "expected a length"]),
                ({"--pitch": "nm"}, ["--pitch", "not a number"]),
                ({"--pitch": "39nm,40"}, ["--pitch", "39nm", "40", "every number its unit"]),
                ({"--pitch": "-1nm"}, ["--pitch", "not positive"]),
                ({"--modulus": "210gpa"}, ["--modulus", "capitals", "expected a pressure", "GPa"]),
                ({"--modulus": "210nm"}, ["--modulus", "is a length", "expected a pressure"]),
                ({"--modulus": None, "--E": "210GN", "--nu": "0.3"}, ["--E", "is a force", "expected a pressure"]),
                ({"--approach": None, "--load": "5MPa"}, ["--load", "is a pressure", "expected a force", "mN"]),
                ({"--approach": None, "--load": "1mN,2"}, ["--load", "1mN", "every number its unit"]),
                ({"--approach": None, "--load": "1:2mN:3"}, ["--load", "every number its unit"]),
                ({"--approach": None, "--pressure": "5N"}, ["--pressure", "is a force", "expected a pressure"]),
                ({"--hardness": "2kN"}, ["--hardness", "is a force", "expected a pressure"]),
                ({"--approach": "10deg"}, ["--approach", "is an angle", "expected a length"]),
                ({"--unit": "MPa"}, ["--unit", "MPa", "nm"])):
            with self.subTest(changes):
                options = {name: value for name, value in {**GOOD, **changes}.items() if value is not None}
                self.assert_fails("solve", "surface.npy", *words(options), says=says)

    def test_generated_lengths(self):
        def made(*arguments):
            done = self.run_command("generate", *arguments, "--output", "made.npy")
            self.assertEqual(done.returncode, 0, done.stderr)
            return np.load(self.folder / "made.npy")

        sphere = made("sphere", "--size", 16, "--radius", 1000, "--pitch", 1, "--unit", "um")
        np.testing.assert_allclose(made("sphere", "--size", 16, "--radius", "1mm", "--pitch", "1um", "--unit", "um"), sphere, rtol=1e-12)
        np.testing.assert_allclose(made("sphere", "--size", 16, "--radius", "1mm", "--pitch", "1000nm"), sphere * 1e-6, rtol=1e-12)
        rough = made("spectral", "--size", 32, "--pitch", 0.5, "--unit", "um", "--rolloff", 8, "--shortest", 2, "--longest", 16, "--rms-height", 0.1)
        np.testing.assert_allclose(made("spectral", "--size", 32, "--pitch", "500nm", "--unit", "um", "--rolloff", "8um", "--shortest", "2um", "--longest",
                                        "0.016mm", "--rms-height", "100nm"), rough, rtol=1e-12, atol=1e-14)
        waves = made("waves", "--size", 16, "--pitch", 1, "--unit", "nm", "--height", 3, "--period", "8,4")
        np.testing.assert_array_equal(made("waves", "--size", 16, "--pitch", "1nm", "--unit", "nm", "--height", "3nm", "--period", "8nm,4nm"), waves)
        self.assert_fails("generate", "sphere", "--radius", "1MPa", "--output", "x.npy", says=["--radius", "is a pressure", "expected a length"])

    def test_analysed_approach(self):
        rough = np.random.default_rng(1).normal(size=(32, 32)) * 1e-8
        texts = [self.run_command("analyze", self.npy(rough), "--pitch", "1um", "--approach", text).stdout for text in ("1e-8", "10nm", "0.01\u00b5m")]
        self.assertIn("approach judged", texts[0])
        self.assertEqual(len(set(texts)), 1)


if __name__ == "__main__":
    harness.main()
