"""`roughcontact generate` and `roughcontact analyze`: files, units, numbers against NumPy, the picture, odd input."""
import json

import harness
from harness import CommandTest, np, rough


def read_gsf(contents):
    end = contents.index(b"\0")
    fields = dict(line.split(" = ") for line in contents[:end].decode().splitlines()[1:])
    nx, ny = int(fields["XRes"]), int(fields["YRes"])
    z = np.frombuffer(contents[(end // 4 + 1) * 4 :], "<f4").reshape(ny, nx)
    return z, float(fields["XReal"]) / nx, float(fields["YReal"]) / ny, fields


class Generate(CommandTest):
    def generate(self, *arguments):
        done = self.run_command("generate", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout + done.stderr, "")

    def made(self, *arguments, name="s.npy"):
        self.generate(*arguments, "--output", name)
        self.assertEqual([n for n in self.names() if n.startswith(".")], [])
        return np.load(self.folder / name) if name.endswith(".npy") else read_gsf((self.folder / name).read_bytes())

    def test_shapes_are_numpys(self):
        y, x = np.mgrid[0:30, 0:40] * 0.5
        grid = ["--size", "40,30", "--pitch", "0.5"]
        r2 = (x - x.max() / 2) ** 2 + (y - y.max() / 2) ** 2
        np.testing.assert_allclose(self.made("sphere", *grid, "--radius", 50), np.sqrt(2500 - r2) - 50, atol=1e-12)
        np.testing.assert_allclose(self.made("sphere", "--paraboloid", *grid, "--radius", 50), -r2 / 100, atol=1e-14)
        waves = 3 * np.cos(2 * np.pi * x / 7) * np.cos(2 * np.pi * y / 4)
        np.testing.assert_allclose(self.made("waves", *grid, "--height", 3, "--period", "7,4"), waves, atol=1e-12)
        np.testing.assert_allclose(self.made("waves", *grid, "--period", "7,0"), np.cos(2 * np.pi * x / 7), atol=1e-12)
        tip = lambda t: np.abs(1 - 2 * ((t / 7) % 1))
        np.testing.assert_allclose(self.made("pyramids", *grid, "--period", 7), np.minimum(tip(x), tip(y)), atol=1e-12)
        noise = self.made("noise", "--size", 200, "--rms-height", 2)
        self.assertAlmostEqual(noise.std(), 2, delta=0.03)

    def test_spectral_surface_has_its_slope_and_cut_offs(self):
        z = self.made("spectral", "--size", "96,80", "--rms-slope", 0.2, "--longest", 48, "--shortest", 6, "--seed", 5)
        q = np.hypot(2 * np.pi * np.fft.fftfreq(96)[None], 2 * np.pi * np.fft.fftfreq(80)[:, None])
        power = np.abs(np.fft.fft2(z) / z.size) ** 2
        self.assertAlmostEqual(np.sqrt((q**2 * power).sum()), 0.2, delta=1e-12)
        outside = (q < 2 * np.pi / 48.001) | (q > 2 * np.pi / 5.999)
        self.assertLess(power[outside].max(), 1e-25 * power.max())
        self.assertGreater(power[~outside].min(), 0)

    def test_unit_is_that_of_the_command_line(self):
        common = ["spectral", "--size", 32, "--pitch", "0.5,2", "--unit", "um", "--rms-height", 1.5]
        plain = self.made(*common)
        self.assertAlmostEqual(plain.std(), 1.5, delta=1e-9)
        z, hx, hy, fields = self.made(*common, name="s.gsf")
        np.testing.assert_allclose(z, plain * 1e-6, rtol=1e-6)
        np.testing.assert_allclose([hx, hy], [0.5e-6, 2e-6], rtol=1e-14)
        self.assertEqual((fields["XYUnits"], fields["ZUnits"]), ("m", "m"))

    def test_generated_lengths(self):
        sphere = self.made("sphere", "--size", 16, "--radius", 1000, "--pitch", 1, "--unit", "um")
        np.testing.assert_allclose(self.made("sphere", "--size", 16, "--radius", "1mm", "--pitch", "1um", "--unit", "um"), sphere, rtol=1e-12)
        np.testing.assert_allclose(self.made("sphere", "--size", 16, "--radius", "1mm", "--pitch", "1000nm"), sphere * 1e-6, rtol=1e-12)
        rough = self.made("spectral", "--size", 32, "--pitch", 0.5, "--unit", "um", "--rolloff", 8, "--shortest", 2, "--longest", 16, "--rms-height", 0.1)
        np.testing.assert_allclose(self.made("spectral", "--size", 32, "--pitch", "500nm", "--unit", "um", "--rolloff", "8um", "--shortest", "2um", "--longest",
                                        "0.016mm", "--rms-height", "100nm"), rough, rtol=1e-12, atol=1e-14)
        waves = self.made("waves", "--size", 16, "--pitch", 1, "--unit", "nm", "--height", 3, "--period", "8,4")
        np.testing.assert_array_equal(self.made("waves", "--size", 16, "--pitch", "1nm", "--unit", "nm", "--height", "3nm", "--period", "8nm,4nm"), waves)

    def test_gsf_says_whether_the_surface_repeats(self):
        for repeats, kind in (("1", ["spectral"]), ("1", ["noise"]), ("1", ["waves", "--period", "4"]), ("1", ["pyramids", "--period", "4"]),
                              (None, ["rmd", "--levels", "3"]), ("0", ["sphere", "--radius", "9"])):
            self.assertEqual(self.made(*kind, *([] if kind[0] == "rmd" else ["--size", "8"]), name="s.gsf")[3].get("Periodic"), repeats)

    def test_gsf_headers_of_every_length_are_padded(self):
        for nx in (1, 9, 10, 99, 100):
            self.assertEqual(self.made("noise", "--size", "%d,3" % nx, name="s.gsf")[0].shape, (3, nx))


class Analyze(CommandTest):
    def analyze(self, *arguments, **settings):
        done = self.run_command("analyze", *arguments, "--json", "a.json", **settings)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads((self.folder / "a.json").read_text()), done

    def test_names_of_every_kind_can_be_drawn(self):
        for name in ("it's 100%.npy", "a{b}_c^d.npy", "\u00fcber.npy"):
            done = self.run_command("analyze", self.npy(rough(), name), "--pitch", "1um", "--unit", "m", "--picture", "psd.png")
            self.assertEqual((done.returncode, done.stderr.replace("roughcontact: gnuplot not found: psd.png not drawn\n", "")), (0, ""))

    def test_odd_surfaces(self):
        self.assert_fails("analyze", self.npy(np.ones((32, 32))), "--pitch", 1, "--unit", "m", "--json", "a.json", says="flat")
        for shape in ((2, 2), (3, 3), (1, 7), (5, 1), (4, 400)):
            found, done = self.analyze(self.npy(np.random.default_rng(1).normal(size=shape)), "--pitch", 1, "--unit", "m")
            self.assertNotIn("nan", done.stdout)
            self.assertEqual(sum(found["psd"]["modes"]), shape[0] * shape[1] - 1)


if __name__ == "__main__":
    harness.main()
