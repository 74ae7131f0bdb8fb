"""HDF5 files with a data set "surface": written by netCDF4, whose files are HDF5; and by h5py, what leads out of a file, and false sizes.
test_hdf5.py ROUGHCONTACT READ_SURFACES"""
import struct
import sys
import zlib

import reading
from harness import np
from reading import ReaderTest, bumps

try:
    import h5py
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

    def made(self, write, **how):
        """The bytes of the file in which write(file) makes the data set."""
        with h5py.File(self.folder / "made.h5", "w", **how) as file:
            write(file)
        return (self.folder / "made.h5").read_bytes()

    def chunked(self, z, chunks, **how):
        return self.made(lambda file: file.create_dataset("surface", data=z, chunks=chunks, **how))

    def laid_out(self, file, z, layout):
        creation = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
        creation.set_layout(layout)
        space = h5py.h5s.create_simple(z.shape)
        h5py.h5d.create(file.id, b"surface", h5py.h5t.NATIVE_DOUBLE, space, creation).write(h5py.h5s.ALL, h5py.h5s.ALL, z.copy())

    def test_filters_and_layouts(self):
        z = bumps()
        for how in ({}, {"fletcher32": True}, {"compression": "gzip", "shuffle": True, "fletcher32": True}):
            for chunks in ((3, 4), (11, 7)):
                for version in ("earliest", "latest"):
                    made = self.made(lambda file: file.create_dataset("surface", data=z.T, chunks=chunks, **how), libver=version)
                    self.assert_reads("a.h5", made, z, PITCH)

        for layout in (h5py.h5d.COMPACT, h5py.h5d.CONTIGUOUS):
            self.assert_reads("a.h5", self.made(lambda file: self.laid_out(file, z.T, layout)), z, PITCH)

        def parts(file):  # chunks that were never written have the fill value
            data = file.create_dataset("surface", z.T.shape, "f8", chunks=(3, 4), fillvalue=np.nan, compression="gzip")
            data[:3, :4] = z.T[:3, :4]

        some = np.where(np.add.outer(np.arange(7) >= 4, np.arange(11) >= 3), np.nan, z)
        self.assert_reads("a.h5", self.made(parts), some, PITCH)

    def test_what_leads_out_of_the_file_is_refused(self):
        secret = self.folder / self.file("secret", bytes(range(77)))
        other = self.folder / self.file("other.h5", self.written(bumps()))
        layout = h5py.VirtualLayout(shape=(7, 11), dtype="f8")
        layout[:] = h5py.VirtualSource(str(other), "surface", shape=(7, 11))
        unlimited = h5py.h5p.create(h5py.h5p.DATASET_CREATE)  # its extent is that of the other file's
        every = h5py.h5s.create_simple((7, 11), (h5py.h5s.UNLIMITED, 11))
        every.select_hyperslab((0, 0), (1, 1), (1, 1), (h5py.h5s.UNLIMITED, 11))
        unlimited.set_virtual(every, str(other).encode(), b"surface", every)
        kinds = (
            ({}, lambda file: file.create_dataset("surface", (7, 11), "i1", external=[(str(secret), 0, 77)]), ["external storage", "secret"]),
            ({}, lambda file: file.create_dataset("surface", (7, 11), "i1", external=[("a", 0, 7), ("/etc/passwd", 0, 70)]), "external storage"),
            ({}, lambda file: file.__setitem__("surface", h5py.ExternalLink(str(other), "/surface")), "an external link"),
            ({}, lambda file: file.__setitem__("surface", h5py.SoftLink("/gone")), "a soft link"),
            ({"libver": "latest"}, lambda file: file.create_virtual_dataset("surface", layout), "is virtual"),
            ({"libver": "latest"}, lambda file: h5py.h5d.create(file.id, b"surface", h5py.h5t.NATIVE_DOUBLE, every, unlimited), "is virtual"),
        )
        for how, write, says in kinds:
            self.assert_refused("a.h5", self.made(write, **how), says)

        def within(file):  # a soft link to such a data set
            file.create_dataset("hidden", (7, 11), "i1", external=[(str(secret), 0, 77)])
            file["surface"] = h5py.SoftLink("/hidden")

        self.assert_refused("a.h5", self.made(within), "a soft link")

    def test_other_filters_are_refused_by_name(self):
        whole = np.arange(77).reshape(7, 11)
        self.assert_refused("a.h5", self.chunked(whole, (3, 4), scaleoffset=0), ['filter 6 ("scaleoffset")', "deflate, shuffle and fletcher32"])
        self.assert_refused("a.h5", self.chunked(whole, (3, 4), compression="lzf"), 'filter 32000 ("lzf")')
        packed = self.chunked(whole, (3, 4), compression="gzip")
        name = packed.index(b"deflate\0")
        self.assert_refused("a.h5", packed[: name - 8] + struct.pack("<H", 32767) + packed[name - 6 :], "filter 32767")

    def test_false_sizes(self):
        """What is claimed is refused by a number, before memory is taken for it."""
        never = lambda shape, chunks: self.made(lambda file: file.create_dataset("surface", shape, "f8", maxshape=(None, None), chunks=chunks, compression="gzip"))
        for points in (1 << 31, 1 << 20, 3000):
            self.assert_refused("a.h5", never((points, points), (64, 64)), ["%d x %d points" % (points, points), "that are unpacked from a file of"])
        self.assert_refused("a.h5", never((2, 2), (1 << 14, 1 << 14)), "16384 x 16384 points")
        self.assert_refused("a.h5", never((2000, 1), (1, 1 << 12)), "2000 x 4096 points")  # all of them unpacked for a column

        self.assert_refused("a.h5", never((2000, 2000), (1, 1)), ["has 4000000 chunks", "more than the"])  # minutes to look for them
        self.assert_refused("a.h5", self.made(lambda file: file.create_dataset("surface", (7, 11), "f8")), "has 0 bytes, not 8 for each")
        for layout in (h5py.h5d.COMPACT, h5py.h5d.CONTIGUOUS):
            whole = self.made(lambda file: self.laid_out(file, bumps(), layout))
            shape = struct.pack("<2Q", 7, 11)
            self.assertEqual(whole.count(shape), 2)  # also the largest
            for nx, ny in ((8, 11), (6, 11), (7, 1 << 20), (1 << 62, 4), (1 << 63, 1 << 63), (0, 11)):
                self.assert_refused("a.h5", whole.replace(shape, struct.pack("<2Q", nx, ny)), "")
        packed = self.chunked(bumps(), (7, 11), compression="gzip")
        size = struct.pack("<3I", 7, 11, 8)  # of a chunk
        self.assertEqual(packed.count(size), 1)
        for nx, ny in ((8, 11), (7, 12), (1 << 20, 1 << 20), (1 << 31, 1)):
            self.assert_refused("a.h5", packed.replace(size, struct.pack("<3I", nx, ny, 8)), ["a.h5"])

    def test_chunks_that_unpack_to_more_or_less_than_their_size(self):
        def holding(stored, **how):
            def write(file):
                file.create_dataset("surface", (4, 4), "f8", chunks=(4, 4), **how).id.write_direct_chunk((0, 0), stored)

            return self.made(write)

        packed = {"compression": "gzip"}
        self.assert_reads("a.h5", holding(zlib.compress(bytes(128)), **packed), np.zeros((4, 4)), PITCH)
        for size in (0, 1, 127, 129, 1 << 25):
            self.assert_refused("a.h5", holding(zlib.compress(bytes(size)), **packed), "does not hold the 128 bytes")
        self.assert_refused("a.h5", holding(zlib.compress(bytes(128))[:-6], **packed), "damaged")
        twice = self.chunked(bumps(), (3, 4), compression="gzip", fletcher32=True)
        name = twice.index(b"fletcher32\0")
        self.assert_refused("a.h5", twice[: name - 8] + struct.pack("<H", 1) + twice[name - 6 :], "damaged")  # packed twice

    def test_what_is_no_map_is_refused(self):
        for contents, wrong in (
            (self.made(lambda file: file.create_group("surface")), '"surface" is no data set'),
            (self.made(lambda file: file.create_dataset("surface", (7, 11), "S9")), "holds no numbers"),
            (self.written(bumps(), name="heights"), 'no data set "surface"'),
            (self.written(bumps()[0]), "has 1 dimensions"),
            (self.written(bumps())[:600], "damaged"),
        ):
            (line,) = self.lines(self.file("a.h5", contents))
            self.assertIn(wrong, line)


if __name__ == "__main__":
    reading.main()
