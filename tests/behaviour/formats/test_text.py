"""Matrices of text: headers of several programs, encodings, ends of lines, decimal marks, several maps in a file."""
import reading
from harness import np
from reading import ReaderTest, bumps

Z = np.array([[1.0, 2, 3], [4, 5, 6]])
ROWS = "1 2 3\n4 5 6\n"
NM, UM = 1e-9, 1e-6


class Headers(ReaderTest):
    def test_gwyddion_in_its_languages(self):
        labels = (("Channel:", "Width:", "Height:", "Value units:"), ("Kan\u00e1l:", "\u0160\u00ed\u0159ka:", "V\u00fd\u0161ka:", "Jednotky hodnot:"),
                  ("Kanal:", "Breite:", "H\u00f6he:", "Einheiten:"), ("Kanal:", "Breite:", "H\u00f6he:", "Einheiten der Werte:"),
                  ("Canal :", "Largeur :", "Hauteur :", "Unit\u00e9s :"), ("Canale:", "Larghezza:", "Altezza:", "unit\u00e0 valore:"),
                  ("Canal:", "Anchura:", "Altura:", "Unidades de valor:"), ("\u30c1\u30e3\u30cd\u30eb\uff1a", "\u5e45:", "\u9ad8\u3055\uff1a", "\u5024\u306e\u5358\u4f4d:"),
                  ("\u041a\u0430\u043d\u0430\u043b:", "\u0428\u0438\u0440\u0438\u043d\u0430:", "\u0412\u044b\u0441\u043e\u0442\u0430:", "\u0415\u0434\u0438\u043d\u0438\u0446\u044b \u0438\u0437\u043c\u0435\u0440\u0435\u043d\u0438\u044f:"))
        for channel, width, height, unit in labels:
            text = "# %s Topo\n# %s 3.0 \u00b5m\n# %s 4,0 \u00b5m\n# %s nm\n" % (channel, width, height, unit) + ROWS
            self.assert_reads("a.txt", text.encode(), Z * NM, (UM, 2 * UM), atol=0)
        for unit in ("\u00b5m", "\u03bcm", "um"):
            self.assert_reads("a.txt", ("# Width: 3,5 %s\n# Height: 2 %s\n# Value units: %s\n" % (unit, unit, unit) + ROWS).encode(), Z * UM, (3.5 / 3 * UM, UM))
        latin = "# Kanal: H\u00f6he\n# Breite: 3 \u00b5m\n# H\u00f6he: 2 \u00b5m\n# Einheiten: \u00b5m\n" + ROWS
        self.assert_reads("a.txt", latin.encode("latin-1"), Z * UM, (UM, UM))
        self.assert_refused("a.txt", "# Width: 3 um\n# Height: 2 um\n# Value units: V\n" + ROWS, '"V" is not a length')

    def test_spip_attocube_nova_and_esri(self):
        spip = "# File Format = ASCII\n# Created by SPIP 6.3\n# x-pixels = 3\n# y-pixels = 2\n# x-length = 3000\n# y-length = 4000\n# x-offset = 0\n# z-unit = %s\n# voidpixels =0\n# Start of Data:\n"
        self.assert_reads("a.asc", spip % "nm" + ROWS, Z * NM, (UM, 2 * UM), atol=0)
        self.assert_reads("a.asc", (spip % "nm").replace("x-length = 3000", "x-length = 3\n# x-unit = um\n# y-unit = nm") + ROWS, Z * NM, (UM, 2 * UM), atol=0)
        self.assert_reads("a.asc", (spip % "um") + ROWS, Z * UM, (UM, 2 * UM))
        self.assert_reads("a.asc", spip.replace("# z-unit = %s\n", "# Bit2nm = 0.5\n") + ROWS, Z * NM / 2, (UM, 2 * UM), atol=0)
        attocube = "# Daisy frame view snapshot\n# x-pixels: 3\n# y-pixels: 2\n# x-length: 6\n# y-length: 2\n# x-unit: um\n# y-unit: um\n# z-unit: nm\n# Start of Data:\n"
        self.assert_reads("a.asc", attocube + ROWS, Z * NM, (2 * UM, UM), atol=0)
        nova = "File Format = ASCII\nCreated by Nova\nNX = 3\nNY = 2\nScale X = 0.5\nScale Y = 0.25\nUnit X = um\nUnit Data = nm\nScale Data = 2\nDataScaleNeeded = no\nStart of Data :\n"
        self.assert_reads("a.txt", nova + ROWS, Z * NM * 2, (0.5 * UM, 0.25 * UM), atol=0)
        # Only lengths of whole sides are in nm without a unit, not the pitch.
        self.assert_reads("a.txt", nova.replace("Unit X = um\n", "") + ROWS, Z * NM * 2, (0.5, 0.25), atol=0)
        for pitch in ("Pitch: 0.5 um\n", "# Pitch X = 500 nm\n# Pitch Y = 0.5 um\n", "X pitch [um];0.5\nY pitch [um];0.5\n", "spacing = 500 nm\n"):
            self.assert_reads("a.txt", pitch + "# Value units: nm\n" + ROWS, Z * NM, (0.5 * UM, 0.5 * UM), atol=0)
        esri = "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 2\nNODATA_value -9999\n1 2 -9999\n4 5 6\n"
        self.assert_reads("a.asc", esri, np.where(Z == 3, np.nan, Z), (2, 2))

    def test_sizes_in_the_header_are_those_of_the_rows(self):
        for header in ("# rows = 3\n# columns = 3\n", "# 3 rows, 3 columns\n", "# NX: 4\n", "h=2 w=4\n", "h=3 w=3\n", "ncols 3\nnrows 3\n", "# x-pixels = 2\n", "# size: 3 x 4\n",
                       "# Zeilen: 1\n", "# number of rows: 3, number of columns: 3\n", "# nx=3 ny=3\n", "# Resolution: 4 x 2 pixels\n", "# columns: 4 rows: 2\n", "# rows = 3, columns = 3\n", "# shape: (3, 3)\n", "# resolution: 512x512\n", "# XRes = 4\n# YRes = 2\n"):
            with self.subTest(header):
                self.assert_refused("a.txt", header + ROWS, ["the header says ", "there are 2 rows of 3 values", "truncated"])
        for header in ("# rows = 2\n# columns = 3\n", "# 2 rows, 3 columns\n", "h=2 w=3\n", "# size: 3 x 2\n", "# shape: (2, 3)\n", "# columns: x, y, z\n", "# mean of 7 lines\n", "# h: 7 nm\n", "# size: 9 x 9 um\n",
                       "# lines: 1 to 9\n", "# nx=3 ny=2\n", "# number of columns: 3 number of rows: 2\n"):
            self.assert_reads("a.txt", header + ROWS, Z, (None, None))

    def test_files_of_other_programs_are_named(self):
        for begin, says in ((b"\x88\x1b\x03\x6f", "MetroPro"), (b"\x88\x1b\x03\x70", "MetroPro"), (b"Wyko ASCII Data File Format 0\t0\t1\nX Size\t2\n", "Wyko ASCII"),
                            (b"\x01\x00Directory", "Wyko OPD"), (b"\\*File list\r\n", "NanoScope"), (b"\x1f\x8b", "gzip")):
            for suffix in ("dat", "asc", "txt", "opd"):
                self.assert_refused("a." + suffix, begin + bytes(64), ["the file is a ", says, "SurfaceTopography"])
        for suffix in ("dat", "h5"):  # builds with a reader of such files say that it is damaged
            for begin, says in ((b"\x89HDF\r\n\x1a\n", "HDF5"), (b"\x89PNG\r\n\x1a\n", "PNG"), (b"MM\0*", "TIFF"), (b"II*\0", "TIFF")):
                self.assert_refused("a." + suffix, begin + bytes(64), says)
        self.assert_refused("a.dat", b"12 3\x00\x01\x02\x07", ["the file is binary, not text", "SurfaceTopography"])
        self.assert_refused("a.xyz", b"1 2 3\n\x01\x02", "the file is binary, not text")


class Encodings(ReaderTest):
    def test_unicode_with_and_without_its_mark(self):
        z, head = bumps(), "# Width: 11 \u00b5m\n# Height: 7 \u00b5m\n# Value units: m\n"
        matrix = head + "".join("\t".join("%.9g" % v for v in row) + "\n" for row in z)
        points = "".join("%g\t%g\t%.9g\n" % (i, j, z[j, i]) for j in range(7) for i in range(11))
        for code in ("utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"):
            for mark in ("\ufeff", "") if code[6:] in ("-le", "-be") else ("",):
                for end in ("\n", "\r\n", "\r"):
                    encode = lambda text: (mark + text.replace("\n", end)).encode(code)
                    if code == "utf-8" or mark or code in ("utf-16", "utf-8-sig"):
                        self.assert_reads("a.txt", encode(matrix), z, (UM, UM))
                    self.assert_reads("a.csv", encode(matrix.replace("\u00b5", "u").replace("\t", ";")), z, (UM, UM))
                    self.assert_reads("a.xyz", encode(points), z, (1, 1), format="xyz")
                    self.assert_reads("a.txt", encode(points), z, (1, 1), format="xyz")
        self.assert_refused("a.txt", ROWS.encode("utf-32"), "UTF-32")
        self.assert_refused("a.txt", ROWS.encode("utf-16") + b"1", ["UTF-16", "truncated"])

    def test_ends_of_lines(self):
        z = np.arange(20.0).reshape(4, 5)
        for separator in ("\t", " ", ",", ";"):
            for end in ("\n", "\r\n", "\r", "\r\r\n"):
                for last in (end, ""):
                    self.assert_reads("a.txt", (end.join(separator.join("%g" % v for v in row) for row in z) + last).encode(), z, (None, None))
        self.assert_reads("a.txt", ROWS + "\x1a", Z, (None, None))

    def test_decimal_marks_and_numbers_of_other_programs(self):
        z = Z + 0.5
        for separator, mark in ((" ", ","), ("\t", ","), (";", ","), ("; ", ","), (" ", "."), (",", "."), (", ", ".")):
            text = "".join(separator.join(("%.1f" % v).replace(".", mark) for v in row) + "\n" for row in z)
            self.assert_reads("a.txt", text, z, (None, None))
        self.assert_reads("a.csv", '"1.5","2.5","3.5"\n"4.5","5.5","6.5"\n', z, (None, None))
        self.assert_reads("a.txt", "1.5D+00 25d-1 3.5\n4.5 5.5 6.5\n", z, (None, None))
        for mark in ("1.#QNAN", "-1.#IND", "--", "N/A", "Bad", "***"):
            self.assert_reads("a.txt", "1.5 %s 3.5\n4.5 5.5 6.5\n" % mark, np.where(z == 2.5, np.nan, z), (None, None))
        self.assert_refused("a.txt", "1.234,5 2,5\n", "is not a number")
        self.assert_refused("a.txt", "1,5\n4,5\n2,5\n", ["decimal comma", "two whole numbers", "2 x 3"])
        self.assert_reads("a.txt", "1,5\n4,5\n", np.array([[1, 5], [4, 5.0]]), (None, None), "--format", "text")


class Maps(ReaderTest):
    def test_of_several_the_first_is_read(self):
        other = "7 8 9\n1 1 1\n"
        self.assert_reads("a.txt", ROWS + "\n" + other, Z, (None, None), note="the first of 2 maps, which blank lines divide, is read")
        head = "# Channel: %s\n# Width: %d um\n# Height: 2 um\n# Value units: nm\n"
        for gap in ("", "\n"):
            text = head % ("one", 3) + ROWS + gap + head % ("two", 9) + "1 2\n"
            self.assert_reads("a.txt", text, Z * NM, (UM, UM), note="the first of several maps in the file is read", atol=0)
        self.assert_refused("a.txt", ROWS + "\n" + "1 2 3\n", "blank lines divide the 3 rows into 2 blocks, the first of 2")
        self.assert_refused("a.txt", ROWS + "\n" + "1 2\n", ["row 3, after a blank line, has 2 values", "one map"])

    def test_blank_lines_that_divide_nothing(self):
        self.assert_reads("a.txt", "\n\n" + ROWS + "\n\n", Z, (None, None), note="")
        self.assert_reads("a.txt", ROWS.replace("\n", "\n\n"), Z, (None, None))
        self.assert_reads("a.txt", "# rows = 4\n" + ROWS + "\n" + ROWS, np.concatenate([Z, Z]), (None, None))
        self.assert_reads("a.txt", "1 2 3\n# a remark\n4 5 6\n", Z, (None, None))


if __name__ == "__main__":
    reading.main()
