"""Every format read from files that independent writers made, and every way in which a header can be wrong."""
import io
import struct
import subprocess
import unittest

import reading
import writers
from harness import gsf, np
from reading import ReaderTest, bumps, has_program

HX, HY = 2e-6, 3e-6


def with_backslashes(archive, link, entry):
    """The archive with these separators of folders in the links of main.xml and in the names of entries, as .NET writes them."""
    with writers.zipfile.ZipFile(io.BytesIO(archive)) as source:
        contents = {name: source.read(name) for name in source.namelist()}
    stream = io.BytesIO()
    with writers.zipfile.ZipFile(stream, "w") as out:
        for name, data in contents.items():
            info = writers.zipfile.ZipInfo("x")
            info.filename = name.replace("/", entry)
            out.writestr(info, data.replace(b"bindata/", b"bindata" + link.encode()) if name.endswith(".xml") else data)
    return stream.getvalue()


class Formats(ReaderTest):
    def test_npy_of_every_type_and_order(self):
        z = np.arange(12).reshape(3, 4)
        for kind in ("f2", "f4", "f8", "i1", "i2", "i4", "i8", "u1", "u2", "u4", "u8"):
            for order in "<>":
                for layout in "CF":
                    stream = io.BytesIO()
                    np.save(stream, np.asarray(z, order + kind, order=layout))
                    self.assert_reads("a.npy", stream.getvalue(), z, (None, None), format="npy", rtol=0)
        halves = np.array([[0.5, -65504, 6e-8, np.inf], [-0.0, np.nan, 1e-5, 0.1]], "f2")
        stream = io.BytesIO()
        np.save(stream, halves)
        self.assert_reads("a.npy", stream.getvalue(), np.where(np.isfinite(halves), halves, np.nan).astype(float), (None, None), rtol=0, atol=0)
        for odd, says in ((z > 3, '"|b1" is truth values'), (z + 1j, '"<c16" cannot be read'), (z.astype("U3"), "cannot be read"),
                          (z.astype("g"), "astype")):
            stream = io.BytesIO()
            np.save(stream, odd)
            self.assert_refused("a.npy", stream.getvalue(), says)

    def test_whether_the_surface_repeats(self):
        z = bumps()
        for line, says in (("", "assumed"), ("Periodic = 0\n", "does not repeat"), ("Periodic = 1\n", "periodic")):
            note = self.read(self.file("a.gsf", gsf(z, HX, HY, "XYUnits = m\nZUnits = m\n" + line)))[3]
            self.assertEqual(note.strip(), "" if says == "assumed" else says)
        self.assert_refused("a.gsf", gsf(z, HX, HY, "Periodic = yes\n"), 'Periodic "yes" is neither 0 nor 1')
        self.assert_reads("a.nc", writers.contact_engineering(z, HX, HY, periodic=0), z, (HX, HY), note="does not repeat")

    def test_x3p(self):
        for kind, scale in (("D", None), ("F", None), ("D", 1e-9), ("I", 1e-9), ("L", 1e-9)):
            for folder in ("", "deep/er/"):
                for prefix in ("p:ISO5436_2", "ISO5436"):
                    z = bumps(missing=0 if kind in "IL" else 5)
                    contents = writers.x3p(z, HX, HY, kind, scale, 4e-9 if scale else 0, folder=folder, prefix=prefix)
                    self.assert_reads("a.x3p", contents, z, (HX, HY), format="x3p")
                    self.assert_reads("a.bin", contents, z, (HX, HY), format="x3p")
        for kind, scale in (("D", None), ("I", 1e-9), ("L", 1e-9)):
            self.assert_reads("a.x3p", writers.x3p(bumps(missing=9), HX, HY, kind, scale, valid_bits=True), bumps(missing=9), (HX, HY))
        self.assert_reads("a.x3p", writers.x3p(bumps(missing=9), HX, HY, listed=True), bumps(missing=9), (HX, HY))
        for folder in ("", "scan/"):
            for link, entry in (("/", "\\"), ("\\", "/"), ("\\", "\\")):
                self.assert_reads("a.x3p", with_backslashes(writers.x3p(bumps(), HX, HY, folder=folder), link, entry), bumps(), (HX, HY))
        self.assert_reads("a.x3p", writers.x3p(bumps(), HX, HY, method=writers.zipfile.ZIP_STORED), bumps(), (HX, HY))

    def test_x3p_whose_data_type_is_not_that_of_the_data(self):
        ny, nx = bumps().shape
        for kind, stored in (("D", "<f4"), ("F", "<f8"), ("I", "<i4"), ("L", "<i2")):
            xml = writers.x3p_xml(nx, ny, HX, HY, kind, "<Increment>1e-9</Increment>", "<DataLink><PointDataLink>d.bin</PointDataLink></DataLink>")
            self.assert_reads("a.x3p", writers.zip_of({"main.xml": xml, "d.bin": np.round(bumps() * 1e9).astype(stored).tobytes()}), bumps(), (HX, HY))

    def test_sur(self):
        z = bumps(missing=4)
        for bits in (16, 32):
            for streams in (0, 1, 3):
                for unit, per_metre in (("mm", 1e3), ("\xb5m", 1e6), ("nm", 1e9), ("m", 1)):
                    contents = writers.sur(z, HX, HY, 1e-9, bits, unit, per_metre, b"comment", b"private!", streams)
                    self.assert_reads("a.sur", contents, z, (HX, HY), format="sur")
        self.assert_reads("a.bin", writers.sur(z, HX, HY, 1e-9), z, (HX, HY), format="sur")
        self.assert_reads("a.sur", writers.sur(z, HX, HY, 1e-9, unit="", per_metre=1e6), z, (HX, HY), "--unit", "um")
        self.assert_reads("a.sur", writers.sur(z, HX, HY, 1e-9, objects=4) + bytes(100), z, (HX, HY), note="first of 4 surfaces")

    def test_sur_without_the_flag_has_no_special_points(self):
        z = bumps(missing=1)
        spike = np.where(np.isnan(z), np.nanmin(z) - 2e-9, z)
        self.assert_reads("a.sur", writers.sur(z, HX, HY, 1e-9, flag=0), spike, (HX, HY))

    def test_sdf_text(self):
        z = bumps(missing=6)
        for magic in ("aISO-1.0", "aBCR-1.0", "aNPL-V1.0"):
            for end in ("\n", "\r\n", "\r"):
                for encode in (bytes, lambda text: b"\xef\xbb\xbf" + text, lambda text: text.decode().encode("utf-16")):
                    text = encode(writers.sdf_text(z, HX, HY, 1e-9, magic, end, "; a comment"))
                    self.assert_reads("a.sdf", text, z, (HX, HY), format="sdf")
        self.assert_reads("a.txt", writers.sdf_text(z, HX, HY, 1), z, (HX, HY), format="sdf")

    def test_sdf_binary(self):
        for kind, dtype in enumerate(writers.SDF_TYPES):
            z = abs(bumps()) if "u" in dtype else bumps(missing=0 if dtype == "<f4" else 6)
            for magic in (b"bISO-1.0", b"bBCR-1.0"):
                self.assert_reads("a.sdf", writers.sdf_binary(z, HX, HY, 1e-9, kind, magic), z, (HX, HY), format="sdf")

    def test_plu(self):
        z = bumps(missing=5)
        self.assert_reads("a.PLU", writers.plu(z, HX, HY), z, (HX, HY), format="plu")
        self.assert_reads("a.plu", writers.plu(z, HX, HY) + bytes(1000), z, (HX, HY))
        self.assert_reads("a.bin", writers.plu(z, HX, HY), z, (HX, HY), "--format", "plu", format="plu")

    def test_netcdf(self):
        z = bumps(missing=5)
        for version in (1, 2, 5):
            for unit, scale in (("m", 1), ("um", 1e-6), ("nm", 1e-9)):
                contents = writers.contact_engineering(z / scale, HX / scale, HY / scale, unit, version)
                self.assert_reads("a.nc", contents, z, (HX, HY), format="nc")
        contents = writers.contact_engineering(z * 1e6, HX * 1e6, HY * 1e6, None)
        self.assert_reads("a.bin", contents, z, (HX, HY), "--unit", "um", format="nc")
        self.assert_reads("a.nc", writers.contact_engineering(z, HX, HY, periodic=1), z, (HX, HY), note="periodic")

    def test_netcdf_fill_values_types_and_scale(self):
        z = bumps(missing=5)
        raw = np.where(np.isnan(z), -7, np.round(z * 1e9) + 1000).T
        for kind in ("i2", "i4", "f4", "f8"):
            for key in ("_FillValue", "missing_value"):
                contents = writers.contact_engineering(z, HX, HY, "m", kind=kind, heights=raw,
                                                       height_attributes={"scale_factor": 1e-9, "add_offset": -1e-6, key: -7.0})
                self.assert_reads("a.nc", contents, z, (HX, HY))
        filled = np.where(np.isnan(z), 9.969209968386869e36, z).T
        for kind in ("f4", "f8"):
            self.assert_reads("a.nc", writers.contact_engineering(z, HX, HY, kind=kind, heights=filled), z, (HX, HY))

    def test_netcdf_without_lengths_takes_the_coordinates(self):
        z = bumps()
        ny, nx = z.shape
        contents = writers.netcdf({"heights": (("y", "x"), z, {"units": "m"}), "x": (("x",), np.arange(nx) * HX, {"units": "m"}),
                                   "y": (("y",), np.arange(ny) * HY, {"units": "m"})}, {"y": ny, "x": nx})
        self.assert_reads("a.nc", contents, z, (HX, HY))
        self.assert_reads("a.nc", writers.netcdf({"heights": (("x", "y"), z.T, {})}, {"x": nx, "y": ny}), z, (None, None))
        for places, says in ((np.arange(nx)[::-1] * HX, None), (np.arange(nx) ** 2 * HX, "x are not evenly spaced"), (np.zeros(nx), "not a positive length")):
            contents = writers.netcdf({"heights": (("y", "x"), z, {"units": "m"}), "x": (("x",), places, {"units": "m"}),
                                       "y": (("y",), np.arange(ny) * HY, {"units": "m"})}, {"y": ny, "x": nx})
            self.assert_refused("a.nc", contents, says) if says else self.assert_reads("a.nc", contents, z, (HX, HY))

    @unittest.skipUnless(has_program("ncgen"), "ncgen (netcdf-bin) is not installed")
    def test_netcdf_of_the_reference_implementation(self):
        z = np.round(bumps() * 1e9)
        rows = ", ".join("%d" % v for v in z.T.ravel())
        text = """netcdf a { dimensions: x = %d ; y = %d ; variables: double heights(x, y) ; heights:unit = "nm" ; byte odd(y) ;
            double x(x) ; x:length = %.17g ; x:unit = "um" ; float y(y) ; y:length = %.17g ; y:unit = "um" ; :json = "{}" ;
            data: heights = %s ; }""" % (z.shape[1], z.shape[0], z.shape[1] * 2.0, z.shape[0] * 3.0, rows)
        self.file("a.cdl", text)
        for kind in ("classic", "64-bit offset", "64-bit data"):
            subprocess.run(["ncgen", "-k", kind, "-o", "a.nc", "a.cdl"], cwd=self.folder, check=True)
            self.assert_reads("a.nc", (self.folder / "a.nc").read_bytes(), z * 1e-9, (HX, HY))
        subprocess.run(["ncgen", "-k", "netCDF-4", "-o", "a.nc", "a.cdl"], cwd=self.folder, check=True)
        self.assert_refused("a.nc", (self.folder / "a.nc").read_bytes(), ["NetCDF-4", "nccopy -k cdf5"])

    def test_container_of_contact_engineering(self):
        z = bumps()
        one = {"meta.yml": "versions: {}\n", "film.nc": writers.contact_engineering(z, HX, HY)}
        self.assert_reads("a.zip", writers.zip_of(one), z, (HX, HY), format="container", note='"film.nc" of the archive')
        two = {**one, "other.nc": b"not even a map"}
        self.assert_reads("a.zip", writers.zip_of(two), z, (HX, HY), note="first of 2 measurements")

    def test_mirco_and_interferometer_matrices(self):
        z = bumps(8, 8)
        mirco = "".join(";".join("%.17g" % v for v in row) + ";\n" for row in z)
        self.assert_reads("sup2.dat", mirco, z, (None, None), format="text")
        phase = "h=7 w=11\r\npixel size=2e-006 m\r\ndata unit=rad\r\nheight conversion factor (-> m)=1e-9\r\n"
        phase += "\r\n".join(" ".join("Bad" if np.isnan(v) else "%.6f" % (v * 1e9) for v in row) for row in bumps(missing=3))
        self.assert_reads("a.txt", phase, bumps(missing=3), (2e-6, 2e-6), format="text")

    def test_named_format_goes_before_contents_and_extension(self):
        z = bumps()
        self.assert_reads("a.txt", gsf(z, HX, HY, "XYUnits = m\nZUnits = m\n"), z, (HX, HY), format="gsf")
        columns = "0 0 1\n0 1 2\n1 0 3\n1 1 4\n"
        self.assert_reads("a.txt", columns, np.array([[1, 3], [2, 4.0]]), (1, 1), "--format", "xyz")
        self.assert_reads("a.xyz", columns, np.loadtxt(io.StringIO(columns)), (None, None), "--format", "text")
        self.assert_refused("a.txt", columns, "expected", "--format", "sdf")


class WrongHeaders(ReaderTest):
    def test_text(self):
        for name, contents, says in (("a.csv", "x1,2,3\n4,5,6\n", 'row 1, column 1: "x1" is not a number'), ("a.txt", "1;2\n;abc;\n3;4\n", 'row 2, column 2: "abc"'),
                                     ("a.csv", "0,5, 1,5\n2,5, 3,5\n", "a comma may be a decimal mark or separate numbers"),
                                     ("a.txt", "1,5,7 2,5\n", '"7 2" is not a number'), ("a.txt", "1 2\nabc 4\n", 'row 2, column 1: "abc" is not a number')):
            with self.subTest(contents):
                self.assert_refused(name, contents, says)

    def test_sizes_that_lie(self):
        z = bumps()
        at = lambda data, offset, form, *values: data[:offset] + struct.pack(form, *values) + data[offset + struct.calcsize(form):]
        sur, plu, sdf = writers.sur(z, HX, HY, 1e-9), writers.plu(z, HX, HY), writers.sdf_binary(z, HX, HY, 1e-9, 5)
        big = 2**31 - 1
        cases = [
            ("a.sur", at(sur, 108, "<3i", 46341, 46341, -2147479015), "46341 x 46341"),
            ("a.sur", at(sur, 108, "<3i", 40000, 50000, 2000000000), ["40000 x 50000", "truncated"]),
            ("a.sur", at(sur, 108, "<3i", -7, -11, 77), "-7 x -11"),
            ("a.sur", at(sur, 108, "<3i", 0, 0, 0), "0 x 0"),
            ("a.sur", at(sur, 98, "<H", 24), "24 bits"),
            ("a.sur", at(sur, 12, "<H", 1), "byte order"),
            ("a.sur", at(sur, 18, "<H", 1), ["type 1", "profile"]),
            ("a.sur", at(sur, 120, "<f", float("nan")), "pitch along x"),
            ("a.sur", at(sur, 128, "<f", -1), "step of heights"),
            ("a.sur", at(sur, 180, "16s", b"furlong"), ["furlong", "not a length"]),
            ("a.sur", at(sur, 334, "<2H", 65535, 65535), "the comment"),
            ("a.plu", at(at(plu, 388, "<2I", big, big), 500, "<2I", big, big), "truncated"),
            ("a.plu", at(plu, 500, "<2I", 3, 4), "not a .plu"),
            ("a.plu", at(plu, 428, "<I", 1), ["type 1", "profile"]),
            ("a.plu", at(plu, 404, "<f", 0), "pitch along x"),
            ("a.plu", at(plu, 408, "<f", float("inf")), "pitch along y"),
            ("a.sdf", at(sdf, 42, "<2H", 65535, 65535), "truncated"),
            ("a.sdf", at(sdf, 42, "<2H", 0, 5), "0 x 5"),
            ("a.sdf", at(sdf, 46, "<d", -1e-6), "Xscale"),
            ("a.sdf", at(sdf, 62, "<d", float("nan")), "Zscale"),
            ("a.sdf", at(sdf, 78, "B", 1), "compression 1"),
            ("a.sdf", at(sdf, 79, "B", 9), "data type 9"),
            ("a.sdf", at(sdf, 80, "B", 1), "checksum"),
        ]
        for name, contents, says in cases:
            with self.subTest(says=says):
                self.assert_refused(name, contents, says)

    def test_compressed_sur_that_lies(self):
        good = writers.sur(bumps(), HX, HY, 1e-9, streams=2)
        table = 512
        word = lambda value, offset: good[: table + offset] + struct.pack("<I", value) + good[table + offset + 4 :]
        for contents, says in ((word(2**32 - 1, 0), "table of compressed streams"), (word(2**32 - 1, 4), "more than"),
                               (word(10, 4), "the header asks for"), (word(2**32 - 1, 8), "compressed stream 1"),
                               (good[:-3] + b"\0\0\0", "cannot be unpacked"), (good[:-20], "truncated")):
            with self.subTest(says=says):
                self.assert_refused("a.sur", contents, says)

    def test_sdf_text(self):
        good = writers.sdf_text(bumps(), HX, HY, 1e-9).decode()
        for contents, says in ((good.replace("NumPoints = 11", "NumPoints = 99999999999"), "truncated"),
                               (good.replace("NumPoints = 11", "NumPoints = 12"), "the file has 77"),
                               (good.replace("NumPoints = 11", "NumPoints = 10"), "more numbers"),
                               (good.replace("NumPoints = 11", "NumPoints = many"), ["NumPoints", "many"]),
                               (good.replace("NumProfiles", "NumberProfiles"), "no NumProfiles"),
                               (good.replace("Xscale = ", "Xscale = x"), "Xscale"), (good.replace("Zscale = ", "Zscale = -"), "Zscale"),
                               (good.replace("\n*\n", "\n"), "has no '='"), (good[:40], "no end"), ("aISO-1.0", "no end"),
                               (good.replace("\n*\n", "\n*\nx1 ", 1), "not a number"), (good.replace("ModDate =", "ModDate"), "no '='")):
            with self.subTest(says=says):
                self.assert_refused("a.sdf", contents, says)

    def test_x3p(self):
        z = bumps()
        ny, nx = z.shape
        data, link = z.tobytes(), "<DataLink><PointDataLink>d.bin</PointDataLink></DataLink>"
        xml = lambda **changes: writers.x3p_xml(**{**dict(nx=nx, ny=ny, hx=HX, hy=HY, data=link), **changes})
        archive = lambda text, values=data: writers.zip_of({"main.xml": text, "d.bin": values})
        cases = [
            (archive(xml(nx=10**9, ny=10**9)), "truncated"), (archive(xml(nx=nx + 1)), "truncated"), (archive(xml(), data[:-1]), "truncated"),
            (archive(xml(), b""), "truncated"), (archive(xml(nx=0)), "SizeX"), (archive(xml(layers=2)), "2 layers"), (archive(xml(feature="PRF")), "profile"),
            (archive(xml(axis_type="A")), "AxisType"), (archive(xml(hx=-1)), "CX/Increment"), (archive(xml(hx=1e308)), "CX/Increment is 1e+308 m, which no surface has"),
            (archive(xml(z_axis="<Increment>1e308</Increment>")), "CZ/Increment is 1e+308 m"), (archive(xml(kind="Q")), "DataType"),
            (archive(xml(z_axis="<Increment>-1</Increment>")), "CZ/Increment"), (archive(xml(data="")), "neither"),
            (archive(xml(data=link.replace("d.bin", "e.bin"))), "e.bin"), (archive(xml().replace("SizeX", "SizeQ")), "no MatrixDimension/SizeX"),
            (archive(xml()[:-30]), "not XML"), (archive("<a>" * 5000), "not XML"), (archive(xml(data="<DataList><Datum>1</Datum></DataList>")), "the list has 1"),
            (archive(xml(nx=10**9, ny=10**9, data="<DataList/>")), "truncated"), (archive(xml(nx=1, ny=1, data="<DataList><Datum>one</Datum></DataList>")), "one"),
            (writers.zip_of({"other.xml": "<a/>"}), "no main.xml"), (b"PK\3\4 and nothing", "zip archive"), (b"", "zip archive"),
        ]
        for contents, says in cases:
            with self.subTest(says=says):
                self.assert_refused("a.x3p", contents, says)
        short = xml().replace("</PointDataLink>", "</PointDataLink><ValidPointsLink>v.bin</ValidPointsLink>")
        self.assert_refused("a.x3p", writers.zip_of({"main.xml": short, "d.bin": data, "v.bin": b"\xff" * 9}), "bits of valid points")

    def test_x3p_that_names_other_files(self):
        """Data is read of the archive alone, and entities of XML stay as they are."""
        secret = self.folder / self.file("secret", bytes(32))
        for link in (str(secret), "secret", "../secret", "/proc/self/cwd/secret", "file://%s" % secret, "..\\secret"):
            for name in ("PointDataLink", "ValidPointsLink"):
                data = "<DataLink><PointDataLink>d.bin</PointDataLink></DataLink>".replace("</DataLink>", "<%s>%s</%s></DataLink>" % (name, link, name))
                data = data.replace("<PointDataLink>d.bin</PointDataLink>", "") if name == "PointDataLink" else data
                file = writers.zip_of({"main.xml": writers.x3p_xml(2, 2, 1e-6, 1e-6, data=data), "d.bin": bytes(32)})
                self.assert_refused("a.x3p", file, "which is not in the archive")
        listed = "<DataList>%s</DataList>" % ("<Datum>1</Datum>" * 4)
        (self.folder / "number").write_text("2")
        for entity in ('SYSTEM "file://%s/number"' % self.folder, 'SYSTEM "number"', '"2"'):
            xml = writers.x3p_xml(2, 2, 1e-6, 1e-6, data=listed).replace("<SizeX>2<", "<SizeX>&e;<")
            xml = xml.replace("?>\n", "?>\n<!DOCTYPE x [<!ENTITY e %s>]>\n" % entity, 1)
            self.assert_refused("a.x3p", writers.zip_of({"main.xml": xml}), ["SizeX", '"&e;"'])

    def test_zip_archives(self):
        good = writers.x3p(bumps(), HX, HY)
        directory = good.rindex(b"PK\1\2")  # of main.xml
        huge = good[: directory + 24] + struct.pack("<I", 2**31) + good[directory + 28 :]
        self.assert_refused("a.x3p", huge, ["claims 2147483648 bytes", "damaged"])
        self.assert_refused("a.x3p", writers.x3p(bumps(), HX, HY, method=writers.zipfile.ZIP_BZIP2), "only deflate")
        body = good.index(b"main.xml") + 12
        self.assert_refused("a.x3p", good[:body] + bytes(20) + good[body + 20 :], "main.xml")
        self.assert_refused("a.zip", writers.zip_of({"meta.yml": ""}), "no file *.nc")
        self.assert_refused("a.zip", writers.zip_of({"a.nc": "CDF"}), ['"a.nc" in the archive', "CDF and version"])

    def test_netcdf(self):
        z = bumps()
        ny, nx = z.shape
        size = {"x": nx, "y": ny}
        good = writers.contact_engineering(z, HX, HY)
        cases = [
            (writers.netcdf({"z": (("x", "y"), z.T, {})}, size), 'no variable "heights"'),
            (writers.netcdf({"heights": (("x",), z[0], {})}, size), "profile"),
            (writers.netcdf({"heights": (("lon", "lat"), z.T, {})}, {"lon": nx, "lat": ny}), ["lon", "lat"]),
            (writers.netcdf({"heights": (("x", "y"), z.T, {})}, {"x": 0, "y": ny}), "nccopy -u"),
            (writers.netcdf({"heights": (("x", "y"), z.T, {})}, {"x": 2**31 - 1, "y": 2**31 - 1}), "more values than the file"),
            (writers.netcdf({"heights": (("x", "y"), z.T, {})}, {"x": nx + 1, "y": ny}), "truncated"),
            (writers.netcdf({"heights": (("x", "y"), z.T, {"unit": "V"})}, size), '"V"'),
            (writers.netcdf({"heights": (("x", "y"), z.T, {}), "x": (("x",), z[0], {"length": -1.0})}, size), "pitch along x"),
            (writers.netcdf({"heights": (("x", "y"), z.T, {}), "x": (("x",), z[0], {"length": "long"})}, size), "a number is needed"),
            (good.replace(b"\0\0\0\x0a\0\0\0\2", b"\0\0\0\x0a\x7f\xff\xff\xff", 1), "more than the file has room for"),
            (good.replace(b"\0\0\0\x0b\0\0\0\3", b"\0\0\0\x0d\0\0\0\3", 1), "tag 13"), (good[:-1], "truncated"), (good[:60], "truncated"), (b"CDF\3", "CDF and version"),
        ]
        for contents, says in cases:
            with self.subTest(says=says):
                self.assert_refused("a.nc", contents, says)


class Command(ReaderTest):
    def test_formats_are_listed(self):
        done = self.run_command("formats")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        names = [line.split()[0] for line in done.stdout.splitlines()]
        self.assertEqual(names, ["name", "gsf", "npy", "text", "xyz", "x3p", "sur", "sdf", "plu", "nc", "container"] + [name for name in ("hdf5", "tiff", "png") if name in names])  # a matter of the build


if __name__ == "__main__":
    reading.main()
