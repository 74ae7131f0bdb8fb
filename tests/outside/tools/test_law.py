"""`roughcontact law`: made, read, evaluated, exported and drawn; odd input."""
import json
import pathlib
import os
import signal
import time

import harness
from harness import CommandTest, np, rough, without_gnuplot

MAKE = ["--pitch", "1um", "--E", "210GPa", "--nu", "0.3", "--boundary", "periodic", "--pressure", "10MPa..500MPa", "--tolerance", "1%"]
MODULUS = 210e9 / (1 - 0.3**2)


class Laws(CommandTest):
    def law(self, *arguments, code=0, **settings):
        done = self.run_command("law", *arguments, **settings)
        self.assertEqual(done.returncode, code, done.stderr)
        return done

    def made(self, *arguments, **settings):
        """A law, and what its JSON says."""
        name = self.npy(rough(24, 24, rms=5e-8))
        self.law(name, *MAKE, "-o", "a.law", "--json", "a.json", "--quiet", *arguments, **settings)
        return json.loads((self.folder / "a.json").read_text())

    def test_a_law_that_is_read_has_the_rows_of_the_one_made(self):
        rows = self.made("--at", "20MPa,200MPa")["rows"]
        shown = self.law("a.law", "--at", "20MPa,200MPa", "--json", "b.json").stdout
        self.assertEqual(json.loads((self.folder / "b.json").read_text())["rows"], rows)
        self.assertEqual(len(shown.splitlines()), 10)
        self.assertRegex(shown.splitlines()[-1], r"^ +[\d.]+ nm +200 MPa +\S+ % +[\d.]+ \w?Pa/m +[\d.]+ \w?N/m +[\d.]+ % +\S+ /m$")
        for row in rows:
            self.assertTrue(row["p_lower"] <= row["p"] <= row["p_upper"] and not row["beyond"])
            np.testing.assert_allclose(row["conductance"], 2 * row["slope"] / MODULUS, rtol=1e-12)
        again = self.law("a.law", "-o", "b.law", "--quiet")
        self.assertEqual((again.stdout, again.stderr), ("", ""))
        self.assertEqual((self.folder / "a.law").read_bytes(), (self.folder / "b.law").read_bytes())
        os.rename(self.folder / "a.law", self.folder / "steel")  # known by its contents
        self.law("steel", "--at", "1nm")
        self.assert_fails("law", "steel", "--pressure", "1MPa..2MPa", says='--pressure is about making a law, and "steel" is one already')

    def test_a_conductance_that_is_not_within_its_tolerance_is_told(self):
        """Where points touch the slope jumps, and no number of nodes narrows that; the exit status counts the pressures."""
        for share, stated in (("2%", True), ("90%", False)):
            self.npy(rough(24, 24, rms=5e-8), "surface.npy")
            done = self.run_command("law", "surface.npy", *MAKE, "--conductance-tolerance", share, "--json", "a.json", "--quiet")
            self.assertEqual(done.returncode, 0, done.stderr)
            width = json.loads((self.folder / "a.json").read_text())["law"]["width_conductance"]
            self.assertEqual(width > float(share[:-1]) / 100, stated)
            self.assertEqual(("note: the conductance is within %.2g %% somewhere, not within the %s %% of --conductance-tolerance" % (100 * width, share[:-1]))
                             in done.stderr, stated, done.stderr)

    def test_beyond_the_law(self):
        self.made()
        done = self.law("a.law", "--at", "1m", code=2)
        self.assertIn("--at: 1 m is beyond the law, which ends at ", done.stderr)
        self.assertIn("unknown", done.stdout)
        self.assertEqual(self.law("a.law", "--at", "0").stderr, "")

    def test_exports_are_in_units_of_the_deck(self):
        self.made("--export", "calculix=a.inp,csv=a.csv", "--export", "moose=a.txt", "--export", "abaqus=b.inp,table=a.tab", "--deck-units", "mm,N",
                  "--conductivity", "50,200", "--rows", 20, "--beyond", 3)
        columns = np.genfromtxt(self.folder / "a.csv", delimiter=",", names=True)
        nodes = json.loads((self.folder / "a.json").read_text())["nodes"]
        np.testing.assert_allclose((columns["overclosure"][-1], columns["pressure"][-1]), (nodes[-1]["x"] * 1e3, 500), rtol=1e-9)
        np.testing.assert_allclose(columns["conductance"][-1], 2 * nodes[-1]["slope"] / MODULUS / 1e3 / (1 / 50 + 1 / 200), rtol=1e-9)
        lines = (self.folder / "a.inp").read_text().splitlines()
        self.assertIn("*GAP CONDUCTANCE", lines)
        self.assertIn("*GAP CONDUCTANCE, PRESSURE", (self.folder / "b.inp").read_text())
        moose = np.genfromtxt(self.folder / "a.txt", delimiter=",")
        self.assertEqual(moose.shape, (20, 2))
        np.testing.assert_allclose(moose[-1, 0], 3 * moose[-2, 0], rtol=1e-9)
        table = (self.folder / "a.tab").read_text().split()
        self.assertEqual(int(table[0]), len(table) - 1)

    def test_laws_of_others_have_their_units(self):
        said = self.made()["law"]
        self.law("a.law", "--law-units", "um,mN", "--json", "b.json", "--export", "csv=b.csv", "--deck-units", "um,mN")
        other = json.loads((self.folder / "b.json").read_text())["law"]
        for name, factor in (("x_upper", 1e-6), ("p_upper", 1e9), ("area", 1e-12), ("modulus", 1e9)):
            np.testing.assert_allclose(other[name], said[name] * factor, rtol=1e-12)
        np.testing.assert_allclose(np.genfromtxt(self.folder / "b.csv", delimiter=",", names=True)["pressure"][-1], said["p_upper"], rtol=1e-9)

    def test_too_few_nodes_are_said(self):
        name = self.npy(rough(24, 24, rms=5e-8))
        done = self.law(name, *MAKE, "--max-nodes", 4, "-o", "a.law", code=2)
        self.assertIn("the law is not certified (RC_STOP_MAX_ITER): more than --max-nodes = 4 nodes are needed", done.stderr)
        self.assertIn("a.law", self.names())
        read = self.law("a.law", "--json", "b.json", code=2)
        self.assertIn("the law is not certified (RC_STOP_MAX_ITER): --max-nodes did not allow the nodes that the tolerance needs", read.stderr)
        self.assertEqual(json.loads((self.folder / "b.json").read_text())["law"]["status"], "RC_STOP_MAX_ITER")

    def test_picture(self):
        self.made()
        done = self.law("a.law", "--picture", "a.png", "--quiet")
        if "gnuplot not found" in done.stderr:
            self.skipTest("gnuplot is not installed")
        picture = (self.folder / "a.png").read_bytes()
        self.assertTrue(picture.startswith(b"\x89PNG") and len(picture) > 20000)
        done = self.law("a.law", "--picture", "b.png", "--quiet", env=without_gnuplot())
        self.assertEqual(done.stderr, "roughcontact: gnuplot not found: b.png not drawn\n")
        self.assertNotIn("b.png", self.names())

    def test_interrupted_it_has_written_nothing(self):
        name = self.npy(rough(600, 600))
        with self.start("law", name, *MAKE, "-o", "a.law", "--export", "csv=a.csv") as process:
            stat = pathlib.Path(f"/proc/{process.pid}/stat")
            while int(stat.read_text().rpartition(")")[2].split()[11]) < 50:  # hundredths of a second of its own: it solves
                self.assertIsNone(process.poll(), "the law is made before it can be interrupted")
                time.sleep(0.01)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(60), -signal.SIGINT)
        self.assertEqual(self.names(), ["surface.npy"])


if __name__ == "__main__":
    harness.main()
