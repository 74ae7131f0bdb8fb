"""Columns x, y, z: the regular grid is found in any order, with missing nodes, rounded coordinates and any separator."""
import reading
from harness import np
from reading import ReaderTest, bumps

HX, HY = 0.4, 0.75


def columns(z, x0=-3.0, y0=10.0, digits=9):
    """One row x, y, z for each point, y slowest."""
    y, x = np.mgrid[0 : z.shape[0], 0 : z.shape[1]]
    return np.stack([np.round(x0 + x * HX, digits).ravel(), np.round(y0 + y * HY, digits).ravel(), z.ravel()], axis=1)


def text(rows, separator=" ", number="%.12g"):
    return "".join(separator.join(number % v for v in row) + "\n" for row in rows)


class Grids(ReaderTest):
    def test_any_order(self):
        z = bumps()
        rows = columns(z)
        orders = [rows, rows[::-1], rows[np.lexsort((rows[:, 1], rows[:, 0]))], rows[np.lexsort((-rows[:, 1], -rows[:, 0]))],
                  rows[np.random.default_rng(1).permutation(len(rows))]]
        for ordered in orders:
            self.assert_reads("a.xyz", text(ordered), z, (HX, HY), format="xyz")

    def test_missing_nodes_rows_and_columns(self):
        chance = np.random.default_rng(2)
        for share in (0.1, 0.4, 0.7):
            z = bumps(20, 30)
            gone = chance.random(z.shape) < share
            gone[:, 12:24] = gone[3] = True
            gone[0, 0] = gone[-1, -1] = gone[0, -1] = gone[-1, 0] = False  # the corners keep the size
            gone[7, 7:10] = gone[8:10, 7] = False
            rows = columns(z)[~gone.ravel()]
            self.assert_reads("a.xyz", text(chance.permutation(rows)), np.where(gone, np.nan, z), (HX, HY))

    def test_marks_of_missing_heights(self):
        z = bumps(missing=9)
        for mark in ("nan", "NaN", "bad", "BAD", "No Data", "***"):
            self.assert_reads("a.xyz", text(columns(z)).replace("nan", mark), z, (HX, HY))

    def test_rounded_coordinates(self):
        z = bumps(60, 50)
        for digits, x0, y0 in ((3, 1 / 3, 2 / 3), (2, 1 / 3, 2 / 3), (9, 1e5, -2e5)):
            found, heights, pitch, _ = self.read(self.file("a.xyz", text(columns(z, x0, y0, digits), number="%.15g")))
            np.testing.assert_allclose(heights, z, atol=1e-15)
            np.testing.assert_allclose(pitch, (HX, HY), rtol=1e-3)
        rows = columns(bumps(60, 50))
        rows[:, 0] += np.random.default_rng(3).uniform(-0.02, 0.02, len(rows))  # a stage that is off by a twentieth of the pitch
        found, heights, pitch, _ = self.read(self.file("a.xyz", text(rows)))
        np.testing.assert_allclose(heights, z, atol=1e-15)
        np.testing.assert_allclose(pitch, (HX, HY), rtol=2e-3)

    def test_three_columns_of_any_text_that_are_points(self):
        z = bumps(20, 30)
        rows, chance = columns(z), np.random.default_rng(6)
        note = "three columns are taken as x, y, z; give the format text for a map of 3 x 600"
        for name, separator in (("a.txt", " "), ("a.csv", ","), ("a.dat", ";"), ("a.asc", "\t")):
            self.assert_reads(name, text(chance.permutation(rows), separator), z, (HX, HY), format="xyz", note=note)
        self.assert_reads("a.txt", text(columns(bumps(2, 2))), bumps(2, 2), (HX, HY), format="xyz")
        self.assert_reads("a.txt", text(rows), rows, (None, None), "--format", "text", rtol=1e-9)
        by_scan = "\n".join(text(rows[k : k + 30]) for k in range(0, 600, 30))  # a blank line after each, as gnuplot wants it
        self.assert_reads("a.txt", by_scan, z, (HX, HY), format="xyz")

    def test_points_in_any_text_that_fill_no_grid(self):
        z, chance = bumps(20, 30), np.random.default_rng(7)
        rows = columns(z)
        for share in (0.05, 0.3, 0.6):  # scans with gaps
            gone = chance.random(z.shape) < share
            gone[0, 0] = gone[-1, -1] = False
            self.assert_reads("a.txt", text(rows[~gone.ravel()]), np.where(gone, np.nan, z), (HX, HY), format="xyz")
        says = ["three columns that look like x, y, z: ", "or give the format text for a map of 3 x "]
        jitter = rows.copy()
        jitter[:, :2] += chance.uniform(-0.25, 0.25, (600, 2)) * (HX, HY)
        for contents, why in ((text(rows) + text(rows[7:8]), "two points are at"), (text(rows[[0, 1, 2, 30, 31, 32, 30]]), "two points are at"),
                              (text(jitter), "no regular grid"), (text(jitter[np.lexsort((rows[:, 1], rows[:, 0]))]), "no regular grid"),
                              (text(np.insert(jitter, 99, jitter[98], axis=0)), "no regular grid"), (text(chance.permutation(jitter)), "no regular grid"),
                              (text(np.concatenate([jitter[k : k + 30][:: 1 - k // 30 % 2 * 2] for k in range(0, 600, 30)])), "no regular grid")):
            with self.subTest(contents[:80]):
                self.assert_refused("a.txt", contents, [*says, why])

    def test_matrices_of_three_columns(self):
        rows = columns(bumps(20, 30))
        chance = np.random.default_rng(6)
        y, x = np.mgrid[0:40, 0:3] * 1.0
        diagonal = np.stack([np.arange(40.0)] * 3, axis=1)
        levels = chance.integers(-9, 10, size=(50, 3)) * 1.0  # whole numbers, as of a converter
        for matrix in (diagonal, levels[:7], np.ones((9, 3)), np.where(rows == rows[7, 0], np.nan, rows), rows[:3],
                       np.cos(y / 3 + x / 9), y - 2 * x, np.arange(12.0).reshape(4, 3), np.round(9 * np.cos(y / 3 + x / 9)),
                       np.cumsum(chance.normal(size=(60, 1)), axis=0) + chance.normal(size=(60, 3)) / 9):
            self.assert_reads("a.txt", text(matrix), matrix, (None, None), format="text", rtol=1e-9)
        # Columns that differ are no map's; what they are has to be said.
        for matrix in (bumps(40, 3), levels, chance.normal(size=(400, 3)), chance.integers(0, 3, size=(30, 3)) * 1.0):
            self.assert_refused("a.txt", text(matrix), ["three columns", "give the format text for a map of 3 x %d" % len(matrix)])
            self.assert_reads("a.txt", text(matrix), matrix, (None, None), "--format", "text", rtol=1e-9)
            self.assert_reads("a.txt", "# columns = 3\n" + text(matrix), matrix, (None, None), rtol=1e-9)
        self.assert_reads("a.txt", "# columns = 3\n" + text(rows), rows, (None, None), format="text", rtol=1e-9)

    def test_what_is_no_grid(self):
        rows = columns(bumps())
        scattered = np.random.default_rng(4).uniform(size=(300, 3))
        diagonal = np.stack([np.arange(2000.0)] * 3, axis=1)
        uneven = rows.copy()
        uneven[:, 0] = 1.37 ** uneven[:, 0]
        for contents, says in ((text(scattered), "no regular grid along x"), (text(diagonal), ["2000 x 2000 nodes", "less than one in 10"]),
                               (text(uneven), "no regular grid along x"), (text(rows) + text(rows[5:6]), "two points"),
                               (text(rows[rows[:, 0] == rows[0, 0]]), "same x: a profile"), (text(rows[:1]), "same x"),
                               ("x y z\n", "no line with three numbers"), ("", "no line"), (text(rows[:, :2]), "2 columns"),
                               ("1 2 3\n1 2 3 4 5\n", "line 2 has 5 columns"), ("1 2 3\n1,5,2,5 3\n", "line 2"), ("1 2 3\n1 inf 3\n", ["line 2", "y"]),
                               ("1 2 3\n2 2 x\n", ["line 2", "z", '"x"']), ("0 0 0\n1e308 1 1\n-1e308 0 0\n1e-300 1 1\n", "a.xyz")):
            with self.subTest(says=says):
                self.assert_refused("a.xyz", contents, says)


if __name__ == "__main__":
    reading.main()
