"""Exports as instruments write them: each is right without further words, or refused with the word that makes it right."""
import reading
from harness import np, rough
from reading import ReaderTest

NM, UM = 1e-9, 1e-6
NY, NX = 12, 16
Z = np.round(rough(NY, NX, rms=300) * 1e4) / 1e4  # nanometres
PITCH = 0.5 * UM
PRESS = ["--E", "1GPa", "--nu", "0.3", "--pressure", "1kPa", "--quiet"]


def rows(separator, z=Z, form="%.4f", comma=False, end=""):
    """Lines of numbers; NaN is an empty field."""
    fields = [["" if np.isnan(v) else (form % v).replace(".", "," if comma else ".") for v in row] for row in z]
    return "".join(separator.join(row) + end + "\n" for row in fields)


class Exports(ReaderTest):
    def assert_right(self, name, text, z=Z, **more):
        """Read, and pressed by the command without further words."""
        self.assert_reads(name, text, z * NM, (PITCH, PITCH), atol=1e-14, **more)
        return self.solve(name, *PRESS, "--boundary", "periodic").stderr

    def test_a_preamble_of_ten_lines_with_numbers_in_it(self):
        head = ("Instrument;ProfilerX 3000\nOperator;A. Smith\nDate;2024-03-11 10:22:31\n12,5;3\nObjective;50x\nNA;0.8\nX-Pixels;16\nY-Pixels;12\n"
                "Pixel size;0.5 um\nZ-Unit;nm\n")
        self.assert_right("a.csv", head + rows(";"), note="1 line of numbers before the table is not read")
        self.assert_right("a.csv", "10.5, 3.5, 1\nPixel size: 0.5 um\nZ-Unit: nm\n" + rows(","))

    def test_nanoscope_ascii(self):
        for head in ("Scan size: 8 um\nSamps/line: 16\nLines: 12\nZ-Unit: nm\n", "# Scan Size: 8000 nm\n# Samps/line: 16\n# Number of lines: 12\n# Value units: nm\n"):
            self.assert_right("a.txt", head + rows("\t"), note="the scan size is that of a line")
        self.assert_refused("a.txt", "Scan size: 8 um\nSamps/line: 99\n" + rows("\t"), "the header says 99 x 12 points")

    def test_separators_that_end_lines_and_words_after_them(self):
        text = "Pixel size: 0.5 um\nZ-Unit: nm\n" + rows(",", end=",") + "\nEnd of data\n"
        self.assertIn("words after the numbers are not read", self.assert_right("a.csv", text))


class Damaged(ReaderTest):
    def test_rows_with_words_in_them_are_no_preamble(self):
        lines = rows(",").splitlines(keepends=True)
        head = "Pixel size: 0.5 um\nZ-Unit: nm\n"
        for k in (1, 5, NY - 1):
            text = "".join(lines[:k] + [lines[k].replace(lines[k].split(",")[2], "oops", 1)] + lines[k + 1 :])
            self.assert_refused("a.csv", head + text, '"oops" is not a number')
        self.assert_refused("a.csv", head + "".join(lines[:3] + ["a remark\n"] + lines[3:]), '"a" is not a number')
        self.assert_refused("a.csv", head + "".join([lines[0].rsplit(",", 1)[0] + "\n"] + lines[1:]), "has 16 values, expected 15")
        self.assert_refused("a.csv", head + rows(",") + "mean, rms\n1.5, 2\n", "words part 12 rows of numbers from 1 of another length")


if __name__ == "__main__":
    reading.main()
