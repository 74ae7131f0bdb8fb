"""Units of files: read at every place where exports name them, said where they are assumed, refused where they contradict."""

import reading
import writers
from harness import gsf, np
from reading import ReaderTest, bumps
from unit_matrix import STEP, cases, heights

HX, HY = 2e-6, 3e-6


class Text(ReaderTest):
    def test_every_place_of_a_unit_against_every_other(self):
        z = np.array(heights())
        for name, contents, unit, metres in cases():
            with self.subTest(name=name, header=contents[:60], unit=unit):
                arguments = [] if unit is None else ["--unit", unit]
                if metres is None:
                    self.assert_refused(name, contents, "unit", *arguments)
                    continue
                pitch = (STEP * metres[0],) * 2 if name[0] == "a" else (None, None)
                _, found, found_pitch, note = self.read(self.file(name, contents), *arguments)
                np.testing.assert_allclose(found, z * metres[1], rtol=1e-12)
                self.assertEqual(found_pitch[0] is None, pitch[0] is None)
                if pitch[0]:
                    np.testing.assert_allclose(found_pitch, pitch, rtol=1e-9)
                self.assertEqual("lengths without a unit are in m" in note, unit is None and metres == (1, 1))
        latin = "X [\u00b5m];Y [\u00b5m];Z [\u00c5]\n0;0;1\n1;0;2\n0;1;3\n1;1;4\n"
        self.assert_reads("a.csv", latin.encode("latin-1"), np.array([[1, 2], [3, 4]]) * 1e-10, (1e-6, 1e-6), atol=0)

    def test_titles_and_listings(self):
        rows, z = "1 2\n3 4\n", np.array([[1, 2], [3, 4.0]])
        for title in ("Unit 7 of the laboratory", "Units and more", "Height map of steel", "# Height, forward, 2024", "# Filter (80 um)"):
            self.assert_reads("a.txt", title + "\n" + rows, z, (None, None), note="names none of its heights")
        for title in ("Unit um", "Units [um]", "Height / um"):
            self.assert_reads("a.txt", title + "\n" + rows, z * 1e-6, (None, None), atol=0)
        nova = "File Format = ASCII\nScale X = 1\nScale Y = 1\nUnit X = um\n"
        self.assert_reads("a.txt", nova + "Z [nm]\nnan 2\n3 4\n", np.array([[np.nan, 2], [3, 4]]) * 1e-9, (1e-6, 1e-6), atol=0)
        self.assert_refused("a.txt", "# X [furlong]\n# Z [nm]\n" + rows, '"furlong", is not a length')

    def test_units_of_something_else_are_not_those_of_the_heights(self):
        points = "".join("%d %d %d\n" % (i, j, 3 * i + j) for j in range(3) for i in range(3))
        z = np.array([[3.0 * i + j for i in range(3)] for j in range(3)])
        others = ("Cutoff length: 0.8 mm", "Scan length 5 mm", "Length: 5 mm", "Evaluation length [mm]", "Unit cell 5 mm", "Lateral unit: mm", "Step height standard (nm)",
                  "x offset: 3 mm", "Y: 5 mm", "X: 5 mm, Y: 3 mm", "Data acquired at 532 nm", "Height difference: 3 um", "Max height = 3 um", "Z range: 20 um")
        for line in others:
            self.assert_refused("a.xyz", "# %s\n%s" % (line, points), ['the file says "%s"' % line, "give their unit"])
            self.assert_reads("a.xyz", "# %s\n%s" % (line, points), z * 1e-6, (1e-6, 1e-6), "--unit", "um", atol=0)
            self.assert_reads("a.xyz", "# %s\nX [mm];Y [mm];Z [um]\n%s" % (line, points.replace(" ", ";")), z * 1e-6, (1e-3, 1e-3), atol=0)
        for line in ("Z unit: um", "Height unit: um", "Unit of the heights: um", "Heights are given in um", "Z-Unit [um]", "Column 3: Z [um]"):
            self.assert_reads("a.xyz", "# %s\n%s" % (line, points), z * 1e-6, (1, 1), note="names none of its pitch", atol=0)
        for line in ("lengths in um", "All lengths are in um", "Unit of length: um", "Units of all coordinates [um]"):
            self.assert_reads("a.xyz", "# %s\n%s" % (line, points), z * 1e-6, (1e-6, 1e-6), atol=0)

    def test_lines_of_which_only_a_part_is_understood(self):
        points = "".join("%d %d %d\n" % (i, j, 3 * i + j) for j in range(3) for i in range(3))
        z = np.array([[3.0 * i + j for i in range(3)] for j in range(3)])
        for line in ("# X Y Z um", "X,Y,Z in um", "x, y [mm], z [um]", "# x,y: mm, z: um", "X [mm];Y;Z [um]", "# um", "mm", "X,mm",
                     "X:mm;Y:mm;Z:um", "X.mm;Y.mm;Z.um", "* X [mm] Y [mm] Z [um]"):
            with self.subTest(line):
                self.assert_refused("a.xyz", "%s\n%s" % (line, points), "unit")
        for line in ("um;um;um", "** um, um, um"):
            self.assert_reads("a.xyz", "%s\n%s" % (line, points), z * 1e-6, (1e-6, 1e-6), atol=0)
        for line in ("# 10:15 pm", "# Start um 12:05", "# Filter 80 um", "# Objective 50x, 0.95"):
            self.assert_reads("a.xyz", "%s\n%s" % (line, points), z, (1, 1), note="names none of its pitch and heights")

    def test_units_after_the_numbers_are_not_passed_over(self):
        rows, z = "1 2\n3 4\n", np.array([[1, 2], [3, 4.0]])
        for line in ("# Unit: um", "Unit: um", "# Z [um]", "Heights in um", "# Z / um"):
            self.assert_refused("a.txt", rows + line + "\n", ['the file says "%s"' % line, "give their unit"])
            self.assert_reads("a.txt", rows + line + "\n", z * 1e-9, (None, None), "--unit", "nm", atol=0)
            self.assert_reads("a.txt", "# Z [nm]\n" + rows + line + "\n", z * 1e-9, (None, None), atol=0)

    def test_exports_as_instruments_write_them(self):
        z = np.array([[1.5, np.nan, 2.5], [0.5, 1.0, 2.0]])
        for text in ("1.5;;2.5\n0.5;1;2\n", "1,5;;2,5;\n0,5;1;2;\n", "1.5\t\t2.5\n0.5\t1\t2\n", "1.5,,2.5\n0.5,1,2\n", "\t1.5\t\t2.5\n\t0.5\t1\t2\n",
                     "Messprotokoll;M\u00fcller\nDatum;12.05.2024\n\nA;B;C\n1,5;;2,5\n0,5;1;2\n", "1.5;;2.5\n0.5;1;2\nEnd of data\n", "1.5;;2.5\n0.5;1;2\n;;\n;;\n"):
            self.assert_reads("a.csv", text, z, (None, None))
        self.assert_refused("a.csv", "1;2;\n3;4;5;\n", "row 2 has 4 values")
        self.assert_reads("a.csv", "1;2;\n3;4;5\n", np.array([[1, 2, np.nan], [3, 4, 5]]), (None, None))
        key_and_value = "Width;6 um\nHeight [um];4\nz-unit;nm\n1;2;3\n4;5;6\n"
        self.assert_reads("a.csv", key_and_value, np.arange(1.0, 7).reshape(2, 3) * 1e-9, (2e-6, 2e-6), atol=0)
        other_order = "Z [nm];note;Y [um];X [um]\n" + "".join("%d;7;%d;%d\n" % (10 * j + i, j, i) for j in range(2) for i in range(3))
        self.assert_reads("a.csv", other_order, np.array([[0, 1, 2], [10, 11, 12]]) * 1e-9, (1e-6, 1e-6), atol=0, note="beside x, y and z are not read")
        for text, says in (("0,5, 1,5\n0,5, 2,5\n", "decimal mark"), ("1;2\nx3;4\n5;6\n", 'row 2, column 1: "x3"'), ("1;2\nwords\n5;6\n", "words"),
                           ("Left [um];Right [nm]\n1;2\n3;4\n", "two units"), ("# Width: 3 um\n# x-unit: nm\n1 2\n3 4\n", "two units")):
            self.assert_refused("a.csv", text, says)


class Others(ReaderTest):
    def test_what_headers_leave_out_is_said(self):
        z = bumps()
        sur = lambda unit: writers.sur(z, HX, HY, 1e-9, unit=unit, per_metre=1)
        bare_y = writers.netcdf({"heights": (("x", "y"), z.T * 1e6, {}), "x": (("x",), np.arange(11.0), {"length": 22.0, "unit": "um"}),
                                 "y": (("y",), np.arange(7.0), {"length": 21.0})}, {"x": 11, "y": 7})
        for name, contents, says in (
                ("a.gsf", gsf(z, HX, HY), "names none of its pitch and heights"), ("a.gsf", gsf(z, HX, HY, "ZUnits = m\n"), "names none of its pitch"),
                ("a.gsf", gsf(z, HX, HY, "XYUnits = m\n"), "names none of its heights"), ("a.gsf", gsf(z, HX, HY, "XYUnits = m\nZUnits = m\n"), ""),
                ("a.sur", sur(""), "names none of its pitch and heights"), ("a.sur", sur("m"), ""),
                ("a.nc", writers.contact_engineering(z, HX, HY, None), "names none of its pitch and heights"),
                ("a.nc", bare_y, "the coordinates along y have no unit, that of x is taken, um; the heights have no unit, that of x is taken, um"),
                ("a.x3p", writers.x3p(z, HX, HY), ""), ("a.sdf", writers.sdf_text(z, HX, HY, 1e-9), ""), ("a.plu", writers.plu(z, HX, HY), ""),
                ("a.txt", "# Width: 22 um\n# Height: 21\n# Value units: nm\n" + "\n".join(" ".join("%g" % (v * 1e9) for v in row) for row in z), "names none of its pitch"),
                ("a.gsf", gsf(z * 1e10, HX, HY, "XYUnits = m\nZUnits = A\n"), "the unit A of the heights is read as angstrom")):
            with self.subTest(name=name, says=says):
                note = self.read(self.file(name, contents))[3].strip()
                self.assertIn(says, note)
                self.assertEqual("without a unit" in note, "names none" in says)
        self.assert_reads("a.nc", bare_y, z, (HX, HY))

    def test_a_unit_beside_those_of_the_file_is_refused(self):
        z = bumps()
        for name, contents, own in (("a.gsf", gsf(z, HX, HY, "XYUnits = m\nZUnits = m\n"), "m"), ("a.sur", writers.sur(z, HX, HY, 1e-9, unit="mm", per_metre=1e3), "mm"),
                                    ("a.nc", writers.contact_engineering(z, HX, HY), "m"), ("a.x3p", writers.x3p(z, HX, HY), "m"),
                                    ("a.sdf", writers.sdf_text(z, HX, HY, 1e-9), "m"), ("a.plu", writers.plu(z, HX, HY), "um")):
            with self.subTest(name):
                self.assert_refused(name, contents, "is %s in the file, but the unit given is nm" % own, "--unit", "nm")
                self.assert_reads(name, contents, z, (HX, HY), "--unit", own)


if __name__ == "__main__":
    reading.main()
