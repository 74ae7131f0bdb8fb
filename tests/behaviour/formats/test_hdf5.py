"""HDF5 files with a data set "surface", written by netCDF4, whose files are HDF5. test_hdf5.py ROUGHCONTACT READ_SURFACES"""
import sys

import reading
from harness import np
from reading import ReaderTest, bumps

try:
    import netCDF4
except ImportError:
    sys.exit(77)

PITCH = None, None  # the file names none


class Hdf5(ReaderTest):
    def written(self, values, name="surface", kind="f8", **how):
        """The bytes of a file with this data set."""
        with netCDF4.Dataset(str(self.folder / "w.h5"), "w") as file:
            axes = [file.createDimension(f"d{axis}", points).name for axis, points in enumerate(values.shape)]
            file.createVariable(name, kind, axes, **how)[:] = values
        return (self.folder / "w.h5").read_bytes()

    def test_first_index_is_x(self):
        z = bumps()
        for kind in ("f8", "f4"):
            self.assert_reads("a.h5", self.written(z.T, kind=kind), z, PITCH, format="hdf5", atol=1e-14)
        self.assert_reads("a.dat", self.written(z.T), z, PITCH, format="hdf5")  # by its first bytes
        self.assert_reads("a.h5", self.written(z.T, zlib=True, chunksizes=(3, 4)), z, PITCH)
        whole = np.round(z * 1e9).astype("i4")
        self.assert_reads("a.h5", self.written(whole.T, kind="i4"), z, PITCH, "--unit", "nm")

    def test_what_is_no_map_is_refused(self):
        for contents, wrong in (
            (self.written(bumps(), name="heights"), 'no data set "surface"'),
            (self.written(bumps()[0]), "has 1 dimensions"),
            (self.written(bumps())[:600], "damaged"),
        ):
            (line,) = self.lines(self.file("a.h5", contents))
            self.assertIn(wrong, line)


if __name__ == "__main__":
    reading.main()
