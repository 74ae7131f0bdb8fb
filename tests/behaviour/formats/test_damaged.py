"""Damaged files of every format: each ends in one line, an answer or an error that names the file, never in a crash, and takes no
more memory than a file of its size justifies. test_damaged.py ROUGHCONTACT READ_SURFACES [MUTANTS]: of each sample, 1200.
"""
import os
import random
import resource
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import reading
import writers
from harness import gsf, np
from reading import ReaderTest, bumps

MUTANTS = int(sys.argv.pop(3)) if len(sys.argv) > 3 and sys.argv[3].isdigit() else 1200
HX, HY = 2e-6, 3e-6
BATCH = 250
NUMBERS = [b"0", b"-1", b"1", b"2", b"65536", b"2147483648", b"4294967297", b"9223372036854775807", b"99999999999999999999999", b"1e308", b"nan", b""]
WORDS = [0, 1, 2, 0x7F, 0xFF, 0x7FFF, 0xFFFF, 0x7FFFFFFF, 0x80000000, 0xFFFFFFFF, 0x40000000, 0x10000]


def npy(z):
    header = ("{'descr': '<f8', 'fortran_order': False, 'shape': %s, }\n" % (z.shape,)).encode()
    return b"\x93NUMPY\1\0" + struct.pack("<H", len(header)) + header + z.tobytes()


def samples():
    """A small good file of each kind: name, contents, and where its parts begin and end."""
    z, gaps = bumps(), bumps(missing=4)
    rows = [" ".join("%.9g" % v for v in row) for row in gaps]
    xyz = "".join("%g %g %.9g\n" % (ix * HX, iy * HY, z[iy, ix]) for iy in range(z.shape[0]) for ix in range(z.shape[1]))
    packed = {"chunks": (3, 4), "compression": "gzip", "shuffle": True, "fletcher32": True}
    grey = np.round((z - z.min()) * 1e9).astype("u2")
    pictures = [("a.tif", writers.tiff(grey)), ("b.tif", writers.tiff(grey, compression=8)), ("a.png", writers.png(grey))]
    containers = [("a.h5", writers.hdf5(z)), ("b.h5", writers.hdf5(z, "latest")), ("c.h5", writers.hdf5(z, **packed)), ("d.h5", writers.hdf5(z, "latest", **packed))]
    return pictures + [sample for sample in containers if sample[1]] + [
        ("a.gsf", gsf(z, HX, HY, "XYUnits = m\nZUnits = m\n")), ("a.npy", npy(z)), ("a.txt", ("# Width: 8 um\n" + "\n".join(rows)).encode()),
        ("b.txt", ("h=7 w=11\npixel size=2e-006 m\ndata unit=rad\nheight conversion factor (-> m)=1e-9\n" + "\n".join(rows)).encode()), ("a.xyz", xyz.encode()),
        ("a.x3p", writers.x3p(gaps, HX, HY)), ("b.x3p", writers.x3p(gaps, HX, HY, "I", 1e-9, valid_bits=True, method=writers.zipfile.ZIP_STORED)),
        ("c.x3p", writers.x3p(gaps, HX, HY, listed=True, method=writers.zipfile.ZIP_STORED)),
        ("a.sur", writers.sur(gaps, HX, HY, 1e-9, comment=b"a comment", private=b"data")), ("b.sur", writers.sur(gaps, HX, HY, 1e-9, 16, streams=3)),
        ("a.sdf", writers.sdf_text(gaps, HX, HY, 1e-9)), ("b.sdf", writers.sdf_binary(gaps, HX, HY, 1e-9, 5)), ("c.sdf", writers.sdf_binary(gaps, HX, HY, 1e-9, 7)),
        ("a.plu", writers.plu(gaps, HX, HY)), ("a.nc", writers.contact_engineering(gaps, HX, HY, version=1)), ("b.nc", writers.contact_engineering(gaps, HX, HY, version=2)),
        ("c.nc", writers.contact_engineering(gaps, HX, HY, version=5)),
        ("a.zip", writers.zip_of({"meta.yml": "a: 1\n", "m.nc": writers.contact_engineering(z, HX, HY)}, writers.zipfile.ZIP_STORED)),
    ]


def boundaries(data):
    """Where parts of the formats' headers begin and end, besides every length up to the first numbers."""
    fixed = [12, 20, 80, 81, 98, 120, 132, 276, 288, 334, 338, 388, 404, 428, 448, 500, 504, 508, 511, 512, 516]
    signatures = [at + d for mark in (b"PK\1\2", b"PK\3\4", b"PK\5\6", b"\n*\n", b"CDF", b"</", b"heights", b"surface", b"TREE", b"OHDR", b"\n") for at in positions(data, mark) for d in (0, len(mark))]
    return sorted({at for at in fixed + signatures + list(range(130)) + [len(data) - d for d in range(1, 40)] if 0 <= at < len(data)})


def positions(data, mark):
    at = data.find(mark)
    while at >= 0:
        yield at
        at = data.find(mark, at + 1)


def mutate(data, chance):
    data = bytearray(data)
    for _ in range(chance.randint(1, 4)):
        near_header = chance.random() < 0.7
        at = min(int(chance.expovariate(1 / 120)) if near_header else chance.randrange(len(data) + 1), max(len(data) - 1, 0))
        kind = chance.randrange(7)
        if kind == 0:
            data[at : at + 1] = bytes([chance.randrange(256)])
        elif kind == 1:
            del data[at : at + chance.randint(1, 12)]
        elif kind == 2:
            data[at:at] = bytes(chance.choices(b"0123456789-+.eE(){}',:=#;*<>/\n\0 ", k=chance.randint(1, 8)))
        elif kind == 3:
            del data[chance.randrange(len(data) + 1) :]
        elif kind == 4:
            digits = [i for i, c in enumerate(data) if 48 <= c < 58]
            if digits:
                at = chance.choice(digits)
                data[at : at + 1] = chance.choice(NUMBERS)
        elif kind == 5:
            form = chance.choice(["<H", "<I", ">H", ">I"])
            word = chance.choice(WORDS) & (0xFFFF if form[1] == "H" else 0xFFFFFFFF)
            data[at : at + struct.calcsize(form)] = struct.pack(form, word)
        else:
            source = chance.randrange(len(data) + 1)
            data[at:at] = data[source : source + chance.randint(1, 64)]
    return bytes(data)


class Damaged(ReaderTest):
    def results(self, named):
        """read_surfaces on many files at once; each prints one line. Memory is bounded, so a huge allocation ends it."""
        sanitized = b"__asan_init" in Path(reading.READER).read_bytes()  # which takes terabytes of addresses
        lines = []
        for start in range(0, len(named), BATCH):
            names = []
            for number, (name, contents) in enumerate(named[start : start + BATCH]):
                names.append(self.file("%d-%s" % (number, name), contents))
            ranged = ["--height-range", "1e-6"] if named[start][0].endswith(("tif", "png")) else []
            done = subprocess.run([reading.READER, *ranged, *names], cwd=self.folder, capture_output=True, timeout=250,
                                  preexec_fn=None if sanitized else lambda: resource.setrlimit(resource.RLIMIT_AS, (1 << 28, 1 << 28)))
            printed = done.stdout.decode("utf-8", "replace").splitlines()
            if done.returncode != 0 or len(printed) != len(names):
                culprit = names[min(len(printed), len(names) - 1)]
                self.fail("crash at file %s: %r\n%s" % (culprit, (self.folder / culprit).read_bytes(), done.stderr.decode("utf-8", "replace")))
            for name, line in zip(names, printed):
                self.assertTrue(line.startswith(("ok ", "error %s: " % name)), line)
            lines += printed
        return lines

    def test_truncated_at_every_boundary_and_at_random(self):
        chance = random.Random(1)
        for name, data in samples():
            with self.subTest(name):
                lengths = sorted({*boundaries(data), *(chance.randrange(len(data)) for _ in range(200))})
                lines = self.results([(name, data[:length]) for length in lengths])
                if name in ("a.txt", "b.txt", "a.xyz"):
                    continue  # fewer rows are a smaller matrix, fewer digits another number
                needed = {"a.plu": len(data) - 8, "a.png": len(data) - 12, "a.tif": len(data) - 4, "b.tif": len(data) - 4, "a.sdf": data.rindex(b"\n*\ntrailer") if name == "a.sdf" else 0}.get(name, len(data))
                read = [length for length, line in zip(lengths, lines) if line.startswith("ok") and length < needed]
                # The last number of text may lose digits.
                self.assertEqual([length for length in read if name != "a.sdf" or length < needed - 3], [], "of %d bytes" % len(data))

    def test_mutants(self):
        chance = random.Random(20)
        good = 0
        for name, data in samples():
            lines = self.results([(name, mutate(data, chance)) for _ in range(MUTANTS)])
            good += sum(line.startswith("ok") for line in lines)
        print("%d mutants, %d of them readable" % (MUTANTS * len(samples()), good))
        self.assertGreater(good, 0)

    def test_garbage(self):
        chance = random.Random(7)
        magics = [b"", b"Gwyddion Simple Field 1.0\n", b"\x93NUMPY\1\0", b"PK\3\4", b"DIGITAL SURF", b"DSCOMPRESSED", b"aISO-1.0\n", b"bISO-1.0", b"CDF\1", b"CDF\2", b"CDF\5", b"\x89HDF\r\n\x1a\n"]
        extensions = ["gsf", "npy", "txt", "xyz", "x3p", "sur", "sdf", "plu", "nc", "zip", "h5"]
        files = [("g." + extension, magic + chance.randbytes(chance.choice([0, 1, 30, 600]))) for magic in magics for extension in extensions for _ in range(4)]
        self.results(files)

    def test_bombs(self):
        """Files that unpack to much more than they seem to: refused by size, or read within what was announced."""
        nx = ny = 20000
        xml = writers.x3p_xml(nx, ny, HX, HY, data="<DataLink><PointDataLink>d.bin</PointDataLink></DataLink>")
        self.assert_refused("a.x3p", writers.zip_of({"main.xml": xml, "d.bin": bytes(1 << 20)}), "truncated")
        link = "<DataLink><PointDataLink>d.bin</PointDataLink>%s</DataLink>"
        small = writers.x3p_xml(2, 2, HX, HY, data=link % "")
        self.assert_refused("a.x3p", writers.zip_of({"main.xml": small, "d.bin": bytes(1 << 26)}), ['"d.bin" unpacks to 67108864 bytes', "more than the 32 "])
        bits = writers.x3p_xml(2, 2, HX, HY, data=link % "<ValidPointsLink>v.bin</ValidPointsLink>")
        self.assert_refused("a.x3p", writers.zip_of({"main.xml": bits, "d.bin": bytes(32), "v.bin": bytes(1 << 20)}), '"v.bin" unpacks to 1048576 bytes, more than the 1024 ')
        self.assert_refused("a.x3p", writers.zip_of({"main.xml": b"<r>" + b"<a/>" * (1 << 22) + b"</r>"}), '"main.xml" unpacks to 16777223 bytes')
        self.assert_refused("a.zip", writers.zip_of({"a.nc": bytes((1 << 27) + (1 << 24))}), '"a.nc" unpacks to 150994944 bytes')
        flat = lambda n: writers.zip_of({"main.xml": writers.x3p_xml(n, n, HX, HY, "I", data=link % ""), "d.bin": bytes(2 * n * n)})
        self.assertLess(len(flat(8192)), 140000)
        self.assert_refused("a.x3p", flat(8192), ["8192 x 8192 points", "that are unpacked from a file of"])
        (line,) = self.results([("f.x3p", flat(2048))])
        self.assertTrue(line.startswith("ok x3p 2048 2048"), line)
        sur = bytearray(writers.sur(bumps(), HX, HY, 1e-9, streams=1))
        sur[108:120] = struct.pack("<3i", nx, ny, nx * ny)
        sur[516:520] = struct.pack("<I", nx * ny * 4)
        self.assert_refused("a.sur", bytes(sur), "more than")
        nx = ny = 4096  # what the header says would be 2^26 bytes, and there are so many packed ones that it could be true
        sur[108:120] = struct.pack("<3i", nx, ny, nx * ny)
        sur[512:] = struct.pack("<3I", 1, nx * ny * 4, 3 << 20) + bytes(3 << 20)
        (line,) = self.results([("b.sur", bytes(sur))])
        self.assertIn("compressed stream 1 cannot be unpacked", line)
        nested = "<a>" * 200000 + "</a>" * 200000
        self.assert_refused("b.x3p", writers.zip_of({"main.xml": nested}), "main.xml has no")

    def test_the_command_ends_with_a_code_of_its_own(self):
        chance = random.Random(4)
        for name, data in samples():
            for _ in range(6):
                done = self.run_command("solve", self.file(name, mutate(data, chance)), "--pitch", "1e-6", "--modulus", "1e9", "--approach", "1e-9",
                                        "--missing", chance.choice(["reject", "fill", "exclude"]), "--remove", chance.choice(["none", "quadric"]), "--quiet")
                self.assertIn(done.returncode, (0, 1, 2), done.stderr)
                if done.returncode == 1:
                    self.assertEqual(done.stderr.rstrip("\n").count("\n"), 0, done.stderr)


if __name__ == "__main__":
    if os.access("/dev/shm", os.W_OK):
        tempfile.tempdir = "/dev/shm"  # tens of thousands of small files
    reading.main()
