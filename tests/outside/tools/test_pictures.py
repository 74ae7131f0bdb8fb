"""The pictures that the command draws, looked at pixel by pixel. Skipped without gnuplot."""
import ctypes
import json
import shutil
import sys

import harness
from harness import CommandTest, np, rough

CONTACT = np.array([0xE6, 0x00, 0x2E])
EXCLUDED = np.array([0xCC, 0xE0, 0xF5])
OPEN = np.array([0x14, 0x14, 0x1C])


def cairo():
    """gnuplot's own drawing library, here to read its pictures."""
    library = ctypes.CDLL("libcairo.so.2")
    for name, result in (("create_from_png", ctypes.c_void_p), ("get_data", ctypes.c_void_p), ("get_width", ctypes.c_int), ("get_height", ctypes.c_int),
                         ("get_stride", ctypes.c_int)):
        getattr(library, "cairo_image_surface_" + name).restype = result
    return library


def pixels(file):
    """Red, green and blue of a picture, shape (height, width, 3)."""
    library = cairo()
    surface = ctypes.c_void_p(library.cairo_image_surface_create_from_png(str(file).encode()))
    width, height, stride = (getattr(library, "cairo_image_surface_get_" + name)(surface) for name in ("width", "height", "stride"))
    data = ctypes.string_at(library.cairo_image_surface_get_data(surface), height * stride)
    library.cairo_surface_destroy(surface)
    words = np.frombuffer(data, np.uint32).reshape(height, stride // 4)[:, :width]
    return np.stack([words >> 16 & 255, words >> 8 & 255, words & 255], axis=2).astype(float)


def runs(flags):
    """(begin, end) of every run of true."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], flags.astype(int), [0]))))
    return list(zip(edges[::2], edges[1::2]))


def panels(image):
    """The two panels, without their borders."""
    inked = image.min(axis=2) < 250
    columns = [run for run in runs(inked.mean(axis=0) > 0.3) if run[1] - run[0] > 60]
    found = []
    for left, right in columns:
        for top, bottom in runs(inked[:, left:right].mean(axis=1) > 0.95):
            if bottom - top > 60:
                found.append(image[top + 1:bottom - 1, left + 1:right - 1])
    return found


def drawn_contact(panel):
    """The share of a panel of greys that is mixed with the colour of contact."""
    return ((panel[:, :, 0] - panel[:, :, 1]) / (CONTACT[0] - CONTACT[1])).mean()


class Pictures(CommandTest):
    def press(self, z, pressures, pitch="1um", *arguments, **settings):
        self.solve(self.npy(z), "--pitch", pitch, "--modulus", "1GPa", "--boundary", "periodic", "--tol", "1e-4", "--pressure", pressures, "--out", "out",
                   "--quiet", *arguments, **settings)
        steps = json.loads((self.folder / "out/summary.json").read_text())["steps"]
        for k, step in enumerate(steps, 1):
            yield step, np.load(self.folder / ("out/pressure-%d.npy" % k)), pixels(self.folder / ("out/contact-%d.png" % k))

    def test_the_area_drawn_is_the_area_stated(self):
        """From a thousandth to nearly all; points larger and smaller than pixels."""
        for z, pressures in ((rough(64, 64), "0.01MPa,0.8MPa,9MPa,45MPa"), (rough(1000, 1000, rms=1e-6), "0.02MPa,3MPa"), (rough(2048, 2048, rms=3e-6), "0.3MPa"),
                             (rough(64, 512, rms=1e-6), "3MPa"), (rough(512, 64, rms=1e-6), "3MPa")):
            for step, pressure, image in self.press(z, pressures):
                with self.subTest(shape=z.shape, area=step["area_fraction"]):
                    heights, _ = panels(image)
                    self.assertAlmostEqual(drawn_contact(heights) / step["area_fraction"], 1, delta=0.003)

    def test_nothing_is_cut_off(self):
        for z, missing in ((rough(512, 64, rms=1e-6), False), (rough(512, 160, rms=1e-6), True), (rough(64, 64), True)):
            if missing:
                z[:5, :5] = np.nan
            ((_, _, image),) = self.press(z, "12.345MPa", "12.345um", "--missing", "exclude")
            self.assertEqual(image[:, -6:].min(), 255)
            inked = image.min(axis=2) < 250
            _, (right, _) = [run for run in runs(inked.mean(axis=0) > 0.3) if run[1] - run[0] > 60]
            top = np.flatnonzero(inked[:, right:right + 60].all(axis=1))[0]
            self.assertFalse(inked[top - 55:top - 14, right - 25:right - 3].any())  # the left title ends before the right one begins

    def test_rows_go_down_and_the_hottest_spot_stands_out(self):
        for shape in ((64, 64), (32, 128)):
            ((step, pressure, image),) = self.press(rough(*shape, seed=3), "1MPa")
            heights, hot = panels(image)
            y, x = np.unravel_index(pressure.argmax(), pressure.shape)
            at = [int((i + 0.5) / n * m) for i, n, m in zip((y, x), shape, hot.shape)]
            self.assertGreater(np.abs(hot[at[0], at[1]] - OPEN).sum(), 300)
            self.assertGreater((heights[at[0], at[1]] - CONTACT)[0], -30)
            drawn = np.abs(hot - OPEN).sum(axis=2) > 60
            cells = np.array([[drawn[int((j + 0.5) / shape[0] * hot.shape[0]), int((i + 0.5) / shape[1] * hot.shape[1])] for i in range(shape[1])] for j in range(shape[0])])
            self.assertGreater((cells == (pressure > 0)).mean(), 0.97)  # but for the ring
            self.assertLess((cells[::-1] == (pressure > 0)).mean(), 0.95)

    def test_excluded_points_are_blue(self):
        z = rough(64, 64)
        z[:20, :20] = np.nan
        self.solve(self.npy(z), "--pitch", "1um", "--modulus", "1GPa", "--missing", "exclude", "--pressure", "1MPa", "--out", "out", "--quiet")
        heights, _ = panels(pixels(self.folder / "out/contact-1.png"))
        self.assertEqual(np.abs(heights[20:150, 20:150] - EXCLUDED).max(), 0)
        self.assertGreater(np.abs(heights[300:, 300:] - EXCLUDED).sum(axis=2).min(), 30)

    def test_history(self):
        list(self.press(rough(32, 32), "1MPa"))
        self.assertNotIn("history.png", self.names("out"))
        list(self.press(rough(32, 32), "1MPa:20MPa:4"))
        whole = (self.folder / "out/history.png").read_bytes()
        self.assertGreater((np.abs(pixels(self.folder / "out/history.png") - CONTACT).sum(axis=2) < 9).sum(), 500)
        common = [self.npy(rough(32, 32)), "--pitch", "1um", "--modulus", "1GPa", "--boundary", "periodic", "--tol", "1e-4", "--out", "cut", "--quiet"]
        targets = "1000000.0,%r,%r,20000000.0" % (22e6 / 3, 41e6 / 3)
        self.solve(*common, "--pressure", ",".join(targets.split(",")[:2]))
        self.solve(*common, "--pressure", targets, "--resume")
        self.assertEqual(pixels(self.folder / "cut/history.png").shape, pixels(self.folder / "out/history.png").shape)
        self.assertEqual((self.folder / "cut/history.png").read_bytes(), whole)

    def test_history_is_not_cut_off(self):
        for pressures in ("1Pa,100Pa,1kPa,1MPa", "123.456kPa,234.567kPa"):
            list(self.press(rough(64, 64), pressures, "12.345nm"))
            image = pixels(self.folder / "out/history.png")
            self.assertEqual(min(image[:, :4].min(), image[:, -4:].min(), image[:4].min(), image[-4:].min()), 255)

    def test_unloading_is_told_from_loading(self):
        blue = np.array([0x00, 0x60, 0xC0])
        for pressures, falls in (("1MPa,2MPa,4MPa", False), ("1MPa,4MPa,2MPa", True)):
            list(self.press(rough(64, 64), pressures))
            count = (np.abs(pixels(self.folder / "out/history.png") - blue).sum(axis=2) < 9).sum()
            self.assertEqual(count > 100, falls, count)

    def script_of_history(self, z, *arguments):
        """What gnuplot gets to draw, of the steps and of the history."""
        shutil.rmtree(self.folder / "out", ignore_errors=True)
        (self.folder / "script").unlink(missing_ok=True)
        environment = self.with_gnuplot("cat >>'%s/script'\necho picture\n" % self.folder)
        self.solve(self.npy(z), "--pitch", "1um", "--modulus", "1GPa", "--pressure", "1MPa,2MPa", "--out", "out", "--quiet", *arguments,
                   env=environment)
        return (self.folder / "script").read_bytes().decode("utf-8", "replace")

    def test_what_is_written_in_pictures(self):
        periodic = ["--boundary", "periodic"]
        script = self.script_of_history(rough(64, 64), *periodic)
        for words in (" in the ring", "Persson", "2 steps, E* 1 GPa, nominal area 4096 \u00b5m^2, periodic boundary", "load against approach"):
            self.assertIn(words, script)
        yielding = self.script_of_history(rough(64, 64), *periodic, "--hardness", "20MPa")
        capped = (np.load(self.folder / "out/pressure-2.npy") == 20e6).sum()
        self.assertGreater(capped, 1)
        self.assertIn("largest 20 MPa at %d points, one in the ring" % capped, yielding)
        holes = rough(64, 64)
        holes[:9, :9] = np.nan
        wave = np.cos(2 * np.pi * np.arange(64) / 32)[None, :] * np.ones((64, 1)) * 1e-7
        self.assertNotIn("Persson", yielding)
        for z, arguments in ((rough(64, 64), ["--boundary", "free"]), (wave, periodic), (rough(64, 64), [*periodic, "--shape", "sphere:R=10mm"]),
                             (holes, [*periodic, "--missing", "exclude"])):
            self.assertNotIn("Persson", self.script_of_history(z, *arguments))

    def test_pictures_have_few_pixels(self):
        """They cost what the solve does otherwise."""
        ((_, _, image),) = self.press(rough(512, 512, rms=1e-6), "1MPa")
        self.assertLess(image.shape[0] * image.shape[1], 1.3e6)


if __name__ == "__main__":
    if not shutil.which("gnuplot"):
        print("skipped: gnuplot is not installed")
        sys.exit(77)
    harness.main()
