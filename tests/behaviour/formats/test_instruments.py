"""Files as instruments and other programs wrote them, with what is known of them. They are skipped where they are absent."""
import sys
from pathlib import Path

import reading
from harness import np
from reading import ReaderTest

DATA = Path(sys.argv.pop(3)) / "formats" if len(sys.argv) > 3 else Path()
# File: format, nx, ny, pitch, missing points, raw rms height. All in metres.
FILES = {
    "plu-1.plu": ("plu", 768, 576, (1.66000009e-6, 1.66000009e-6), 0, 2.834391e-6),
    "sur-2.sur": ("sur", 563, 484, (3.484e-6, 3.484e-6), 117, None),
    "x3p-2.x3p": ("x3p", 650, 650, (1.27656509837346e-7, 3.14582113527746e-7), 0, 7.728033e-8),
    "matrix-4.txt": ("text", 75, 305, (3.69862e-7, 3.69862e-7), 0, None),
}


class Instruments(ReaderTest):
    def test_what_is_known_of_them(self):
        for name, (kind, nx, ny, pitch, missing, rms) in FILES.items():
            with self.subTest(name):
                found, heights, found_pitch, _ = self.read(DATA / name)
                self.assertEqual((found, heights.shape, np.isnan(heights).sum()), (kind, (ny, nx), missing))
                np.testing.assert_allclose(found_pitch, pitch, rtol=1e-6)
                print("%-14s %d x %d, rms %.6e m" % (name, nx, ny, np.nanstd(heights)))
                if rms:
                    np.testing.assert_allclose(np.nanstd(heights), rms, rtol=1e-5)

    def test_text_matrix_against_numpy(self):
        _, heights, _, _ = self.read(DATA / "matrix-4.txt")
        np.testing.assert_allclose(heights, np.loadtxt(DATA / "matrix-4.txt", skiprows=4) * 2.91818e-008, rtol=1e-12)

    def test_sur_against_numpy(self):
        _, heights, _, _ = self.read(DATA / "sur-2.sur")
        raw = np.frombuffer((DATA / "sur-2.sur").read_bytes(), "<i4", 563 * 484, 512).reshape(484, 563)
        np.testing.assert_allclose(heights, np.where(raw == 89120 - 2, np.nan, raw * 1e-10), rtol=1e-6)


if __name__ == "__main__":
    if not DATA.is_dir():
        print("skipped: no files of instruments in", DATA)
        sys.exit(77)
    reading.main()
