"""Files of `roughcontact`: surfaces it reads, and the folder it writes, whole at every moment."""
import csv
import io
import json
import os
import resource
import signal
import struct
import subprocess
import time

import harness
from harness import CommandTest, gsf, np, rough, step_file, without_gnuplot

PRESS = ["--modulus", "1e9", "--approach", "1.5e-7", "--boundary", "free"]


class Reading(CommandTest):
    def gap_of(self, surface, *arguments):
        """The deformed gap at first touch is max(z) - z, so it shows the heights that were read."""
        self.solve(surface, "--modulus", "1e9", "--approach", "0", "--out", "out", "--quiet", *arguments, env=without_gnuplot())
        given = json.loads((self.folder / "out/summary.json").read_text())["input"]
        return np.load(self.folder / "out/gap-1.npy"), (given["hx"], given["hy"])

    def assert_reads(self, surface, z, pitch, *arguments, rtol=1e-15):
        gap, found = self.gap_of(surface, *arguments)
        np.testing.assert_allclose(gap, z.max() - z, rtol=rtol, atol=rtol * np.ptp(z))
        np.testing.assert_allclose(found, pitch, rtol=1e-14)

    def test_gsf_units_and_pitch(self):
        z = rough().astype("<f4").astype(float)
        for fields, lateral, vertical in (("XYUnits = m\nZUnits = m\n", 1, 1), ("XYUnits=um\nZUnits=nm\n", 1e-6, 1e-9),
                                          ("XYUnits = \u00b5m\nZUnits = \u03bcm\nTitle = M\u00fcnze\n", 1e-6, 1e-6), ("", 1, 1)):
            bare = [] if fields else ["--unit", "m"]
            self.assert_reads(self.file("a.gsf", gsf(z, 3, 5, fields)), z * vertical, (3 * lateral, 5 * lateral), *bare)
            offset = self.file("a.gsf", gsf(z, 3, 5, fields + "ZOffset = 0.25\n"))
            self.assert_reads(offset, (z + 0.25) * vertical, (3 * lateral, 5 * lateral), *bare)
        self.assert_reads(self.file("a.gsf", gsf(z, 3, 5)), z * 1e-6, (3e-6, 5e-6), "--unit", "um")

    def test_contents_go_before_the_extension(self):
        z = np.arange(12.0).reshape(3, 4)
        stream = io.BytesIO()
        np.save(stream, z)
        for name, contents in (("array.gsf", stream.getvalue()), ("array", stream.getvalue()), ("field.npy", gsf(z, 1, 1))):
            self.assert_reads(self.file(name, contents), z, (1, 1), "--pitch", "1", "--unit", "m")

    def test_wrong_files(self):
        good = gsf(rough(6, 8), 1, 1)
        cases = [
            ("missing.npy", None, "No such file"),
            ("empty.txt", "", "no numbers"),
            ("empty.npy", "", "NUMPY"),
            ("a.png", b"\x89PNG", "PNG"),
            ("a.txt", "1 2 3\n4 5\n", ["row 2", "2 values", "expected 3"]),
            ("a.txt", "1 2\n3 x\n", ["row 2, column 2", '"x"']),
            ("a.txt", "1;;2\n", "1 missing value of 3, first at ix=1, iy=0"),
            ("a.txt", "# Width: 10 px\n1 2\n", '"px" is not a length'),
            ("a.txt", "# Value units: V\n1 2\n", ["heights", '"V"']),
            ("a.txt", "1 nan 3\n4 5 inf\n", "2 missing values of 6, first at ix=1, iy=0; give --missing fill"),
            ("a.gsf", gsf(np.where(np.arange(6) == 4, np.nan, 1.0).reshape(2, 3), 1e-6, 1e-6), "1 missing value of 6, first at ix=1, iy=1"),
            ("a.gsf", good[:-1], ["8 x 6", "truncated"]),
            ("a.gsf", good + b"\0\0\0\0", ["8 x 6", "4 bytes follow"]),
            ("a.gsf", good.replace(b"XRes = 8", b"XRes = -8"), ["XRes", "-8"]),
            ("a.gsf", good.replace(b"XRes = 8\nYRes = 6", b"XRes = 4294967296\nYRes = 4294967296"), "truncated"),
            ("a.gsf", good.replace(b"XRes", b"Xres"), "no XRes"),
            ("a.gsf", gsf(rough(6, 8), -1, 1), "XReal"),
            ("a.gsf", gsf(rough(6, 8), 1, 1, "ZUnits = V\n"), ["heights", '"V"']),
            ("a.gsf", gsf(rough(6, 8), 1, 1, "nonsense\n"), "nonsense"),
            ("a.gsf", gsf(rough(6, 8), 1, 1, "ZOffset = inf\n"), ["ZOffset", "inf"]),
            ("a.gsf", b"Gwyddion Simple Field 1.0\nXRes = 1\nYRes = 1\n", "no end"),
            ("a.gsf", b"Gwyddion Simple Field 2.0\n", "first line"),
        ]
        for descr, shape, says in (("<f8", "(2,)", "shape"), ("<f8", "(1, 2, 3)", "shape"), ("<f8", "(-2, -3)", "-3 x -2"),
                                   ("<f8", "(2, 4)", "truncated"), ("<f8", "(2, 2)", "bytes follow"), ("<c16", "(2, 3)", "<c16"),
                                   ("|O", "(2, 3)", "|O"), ("<f8", "(4294967296, 4294967296)", "truncated"), ("<f8", "(99999999999999999999, 1)", "shape")):
            header = ("{'descr': '%s', 'fortran_order': False, 'shape': %s, }\n" % (descr, shape)).encode()
            cases.append(("a.npy", b"\x93NUMPY\x01\x00" + struct.pack("<H", len(header)) + header + bytes(48), says))
        cases.append(("a.npy", b"\x93NUMPY\x02\x00" + struct.pack("<I", 0xFFFFFFF0), "at most"))
        cases.append(("a.npy", b"\x93NUMPY\x09\x00", "version 9"))
        for name, contents, says in cases:
            with self.subTest(name=name, says=says):
                if contents is not None:
                    self.file(name, contents)
                self.assert_fails("solve", name, "--pitch", "1e-6", *PRESS, "--unit", "m", "--out", "out", says=[name] + ([says] if isinstance(says, str) else says))
        self.assert_fails("solve", ".", *PRESS, says="folder")


class Writing(CommandTest):
    def test_files_of_a_sequence(self):
        z = rough()
        self.solve(self.npy(z), "--pitch", "1e-6,2e-6", "--modulus", "1e9", "--approach", "1e-7,2e-7", "--out", "deep/out")
        self.assertEqual(self.names("deep/out"), sorted(["heights.npy", "history.png", "steps.csv", "summary.json"] + [n % k for k in (1, 2) for n in ("contact-%d.png", "gap-%d.npy", "pressure-%d.npy")]))
        for name in ("gap-1.npy", "pressure-2.npy"):
            array = np.load(self.folder / "deep/out" / name)
            self.assertEqual((array.dtype.str, array.shape, array.flags.c_contiguous), ("<f8", z.shape, True))
        picture = (self.folder / "deep/out/contact-2.png").read_bytes()
        self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
        self.assertTrue(picture.endswith(b"IEND\xaeB`\x82"))

    def test_steps_as_a_table(self):
        units = {"approach": "m", "load": "N", "mean_pressure": "Pa", "max_pressure": "Pa", "mean_gap": "m", "corrected_area": "m^2", "largest_patch": "m^2",
                 "stiffness": "N/m", "seconds": "s", "plastic_volume": "m^3"}
        few = ["--hardness", "2e7", "--set", "max_iter=2", "--solver", "polonsky-keer"]
        self.solve(self.npy(rough()), "--pitch", "1um", "--modulus", "1GPa", "--pressure", "1e5,1e6", "--out", "out", "--quiet", *few, code=2, env=without_gnuplot())
        steps = json.loads((self.folder / "out/summary.json").read_text())["steps"]
        with open(self.folder / "out/steps.csv", newline="") as file:
            head, *rows = csv.reader(file)
        names = [name.split(" [")[0] for name in head]
        self.assertEqual(names, ["step", *steps[0]])
        self.assertEqual({name: unit.rstrip("]") for name, _, unit in (field.partition(" [") for field in head) if unit and name in units}, units)
        self.assertEqual(len(rows), 2)
        for k, (row, step) in enumerate(zip(rows, steps), 1):
            self.assertTrue("," in step["message"] or "," in step["note"], step)  # what has to stand in quotes
            for name, text in zip(names, row):
                value = k if name == "step" else step[name]
                self.assertEqual(text, "" if value is None else value if isinstance(value, str) else json.dumps(value) if isinstance(value, int) else text)
                if isinstance(value, float):
                    self.assertEqual(float(text), value)

    def test_steps_of_an_earlier_run_go(self):
        common = [self.npy(rough()), "--pitch", "1e-6", "--modulus", "1e9", "--out", "out"]
        self.solve(*common, "--approach", "1e-7,2e-7,3e-7")
        self.file("out/pressure-9.npy", "of the user's own")
        self.solve(*common, "--approach", "1e-7", env=without_gnuplot())
        self.assertEqual(self.names("out"), ["gap-1.npy", "heights.npy", "pressure-1.npy", "pressure-9.npy", "steps.csv", "summary.json"])

    def test_without_gnuplot_all_but_the_pictures(self):
        done = self.solve(self.npy(rough()), "--pitch", "1e-6", "--modulus", "1e9", "--boundary", "periodic", "--approach", "1e-8,2e-8", "--out", "out", "--quiet",
                          "--unit", "m", env=without_gnuplot())
        self.assertEqual(done.stderr, "roughcontact: gnuplot not found: contact-K.png not drawn\n")
        self.assertEqual(self.names("out"), ["gap-1.npy", "gap-2.npy", "heights.npy", "pressure-1.npy", "pressure-2.npy", "steps.csv", "summary.json"])

    def test_gnuplot_that_fails_leaves_no_picture(self):
        self.file("gnuplot", "#!/bin/sh\necho half a picture\necho boom >&2\nexit 3\n")
        (self.folder / "gnuplot").chmod(0o755)
        done = self.solve(self.npy(rough()), "--pitch", "1um", "--unit", "m", *PRESS, "--out", "out", "--quiet", env=dict(os.environ, PATH=str(self.folder)))
        self.assertEqual(done.stderr, "roughcontact: contact-1.png not drawn, gnuplot failed: boom\n")
        self.assertEqual(self.names("out"), ["gap-1.npy", "heights.npy", "pressure-1.npy", "steps.csv", "summary.json"])

    def test_full_disk_leaves_nothing(self):
        def small_disk():
            resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096))

        # Python ignores SIGXFSZ and hands that on, so that writing fails as it does on a full disk.
        self.npy(rough())
        self.assert_fails("solve", "surface.npy", "--pitch", "1um", "--unit", "m", *PRESS, "--out", "out", "--quiet", says=["cannot write", "heights.npy"],
                          preexec_fn=small_disk, restore_signals=False)

    def test_interrupt_keeps_finished_steps(self):
        surface = self.npy(rough(128, 128))
        for number in (signal.SIGINT, signal.SIGTERM):
            out = self.folder / ("out-%d" % number)
            run = subprocess.Popen([harness.COMMAND, "solve", surface, "--pitch", "1e-6", "--modulus", "1e9", "--approach", "1e-8:4e-7:5000",
                                    "--out", out], cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=without_gnuplot())
            deadline = time.monotonic() + 100
            while not (out / step_file("pressure", 4, 5000)).exists() and time.monotonic() < deadline:
                time.sleep(0.01)
            run.send_signal(number)
            self.assertEqual(run.wait(timeout=60), 130)

            steps = json.loads((out / "summary.json").read_text())["steps"]
            self.assertGreaterEqual(len(steps), 3)
            self.assertLess(len(steps), 5000)
            self.assertEqual({step["status"] for step in steps[:-1]}, {"RC_OK"})
            self.assertIn(steps[-1]["status"], ("RC_OK", "RC_STOP_CANCELLED"))
            self.assertEqual(sorted(os.listdir(out)), sorted(["heights.npy", "steps.csv", "summary.json"] + [step_file(stem, k + 1, 5000) for k in range(len(steps)) for stem in ("gap", "pressure")]))
            for k, step in enumerate(steps, 1):
                self.assertAlmostEqual(np.load(out / step_file("pressure", k, 5000)).sum() * 1e-12, step["load"], delta=1e-12 * step["load"])


if __name__ == "__main__":
    harness.main()
