"""TIFF and PNG of one grey channel, written by their descriptions, and by Pillow if it is installed.
test_pictures.py ROUGHCONTACT READ_SURFACES"""
import struct
import zlib

import reading
from harness import np
from reading import ReaderTest
from writers import png, tiff

try:
    from PIL import Image
except ImportError:
    Image = None

PITCH = None, None  # pictures name none
RANGE = 120e-9
DEEP = np.random.default_rng(5).integers(0, 65536, (7, 11)).astype("u2")
PRESS = ["--E", "1GPa", "--nu", "0.3", "--pressure", "1kPa", "--pitch", "1um", "--boundary", "periodic", "--quiet"]


class Pictures(ReaderTest):
    def assert_scaled(self, name, contents, values, **more):
        z = RANGE * values / np.iinfo(values.dtype).max
        self.assert_reads(name, contents, z, PITCH, "--height-range", str(RANGE), atol=1e-22, rtol=1e-14, **more)

    def test_whole_numbers_of_16_bits(self):
        for order in "<>":
            for compression in (1, 8):
                self.assert_scaled("a.tif", tiff(DEEP, order, compression), DEEP, format="tiff")
        self.assert_scaled("a.png", png(DEEP), DEEP, format="png")
        gamma = [(b"gAMA", struct.pack(">I", 45455)), (b"pHYs", struct.pack(">IIB", 2835, 2835, 1))]
        self.assert_scaled("a.dat", png(DEEP, chunks=gamma), DEEP)  # neither is applied

    def test_whole_numbers_of_8_and_32_bits(self):
        for values in ((DEEP >> 8).astype("u1"), DEEP.astype("u4") << 16):
            self.assert_scaled("a.tif", tiff(values), values, note="8 bits" if values.itemsize == 1 else "")
        self.assert_scaled("a.png", png((DEEP >> 8).astype("u1")), (DEEP >> 8).astype("u1"), note="8 bits")

    def test_the_height_range_counts_in_the_unit(self):
        z = 120e-9 * DEEP / 65535
        self.assert_reads("a.tif", tiff(DEEP), z, PITCH, "--unit", "nm", "--height-range", "120", atol=1e-21, rtol=1e-14)

    def test_floats_are_lengths(self):
        z = DEEP.astype("f4")
        for kind in ("f4", "f8"):
            self.assert_reads("a.tif", tiff(z.astype(kind)), z * 1e-9, PITCH, "--unit", "nm")

    def test_pictures_of_pillow(self):
        if Image is None:
            self.skipTest("Pillow is not installed")
        for name, how in (("a.tif", {"compression": "tiff_lzw"}), ("a.tif", {"compression": "tiff_adobe_deflate"}), ("a.png", {})):
            Image.fromarray(DEEP.astype("u2")).save(str(self.folder / name), **how)
            self.assert_scaled(name, (self.folder / name).read_bytes(), DEEP)
        Image.fromarray((DEEP >> 8).astype("u1")).save(str(self.folder / "a.png"))
        self.assert_scaled("a.png", (self.folder / "a.png").read_bytes(), (DEEP >> 8).astype("u1"))

    def test_without_a_range_the_word_is_named(self):
        for name, contents in (("a.tif", tiff(DEEP)), ("a.png", png(DEEP))):
            self.assert_refused(name, contents, ["whole numbers from 0 to 65535", "give height_range"])
            self.assert_fails("solve", self.file(name, contents), *PRESS, says=["give --height-range"])
            self.solve(name, *PRESS, "--height-range", "120nm")
            self.solve(name, *PRESS, "--height-range", "0.12", "--unit", "um")

    def test_the_word_is_refused_where_heights_are_lengths(self):
        np.save(self.folder / "a.npy", DEEP * 1e-12)
        said = ["--height-range is of TIFF and PNG"]
        self.assert_fails("solve", "a.npy", *PRESS, "--height-range", "120nm", says=said)
        self.file("b.tif", tiff(DEEP))
        self.solve("b.tif", *PRESS, "--against", "a.npy", "--height-range", "120nm")
        self.assert_fails("solve", "b.tif", *PRESS, "--height-range", "-1nm", says=["not positive"])

    def test_other_pictures_are_refused(self):
        deep = np.dstack([DEEP] * 3)
        self.assert_refused("a.tif", tiff(DEEP, t277=3), "3 channels")
        self.assert_refused("a.tif", tiff(DEEP, t262=0), "colours (photometric interpretation 0)")
        self.assert_refused("a.tif", tiff(DEEP.astype("i2")), "samples of format 2")
        self.assert_refused("a.tif", tiff(DEEP, t274=3), "orientation 3")
        self.assert_refused("a.tif", tiff(DEEP, t322=16, t323=16, t324=8, t325=154), "tiles")
        self.assert_refused("a.tif", tiff(DEEP, t258=12), "samples of 12 bits")
        self.assert_refused("a.png", png(deep.reshape(7, 33), 2)[:16] + struct.pack(">I", 11) + b"", "damaged")
        self.assert_refused("a.png", png((DEEP >> 8).astype("u1"), colour=3, chunks=[(b"PLTE", bytes(768))]), "3 channels")
        self.assert_refused("a.png", png((DEEP >> 8).astype("u1")[:, ::2], colour=4)[:200], "2 channels")

    def test_truncated_files_are_damaged(self):  # test_damaged.py has more
        self.assert_refused("a.tif", tiff(DEEP)[:150], "damaged")
        self.assert_refused("a.png", png(DEEP)[:-20], ["the PNG file is damaged", "truncated"])

    def test_headers_ask_for_no_more_memory_than_the_file_justifies(self):
        self.assert_refused("a.tif", tiff(DEEP, t256=1 << 20, t257=1 << 20), "more than the")
        huge = png(DEEP)
        huge = huge[:16] + struct.pack(">II", 1 << 20, 1 << 20) + huge[24:29] + struct.pack(">I", zlib.crc32(huge[12:16] + struct.pack(">II", 1 << 20, 1 << 20) + huge[24:29])) + huge[33:]
        self.assert_refused("a.png", huge, "more than the")


if __name__ == "__main__":
    reading.main()
