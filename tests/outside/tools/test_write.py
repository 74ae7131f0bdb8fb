"""`roughcontact solve --write`: what other programs read from the files of a step. VTK's part is skipped where Python has no VTK."""
import json
import os
import shutil
import struct
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import harness
from harness import CommandTest, np, rough, without_gnuplot

EXTENSIONS = {"vti": "vti", "netcdf": "nc", "hdf5": "h5"}
MODULE = "lib/**/roughcontact/write-netcdf.so"


def needs(module):
    try:
        return __import__(module)
    except ImportError:
        raise unittest.SkipTest("Python has no " + module) from None


class Write(CommandTest):
    def press(self, written, *arguments, command=None, z=None, **settings):
        """The summary's steps, where the format was built in."""
        if written != "vti" and not list(Path(harness.COMMAND).parent.parent.glob(MODULE)):
            self.skipTest("built without NetCDF")
        self.solve(self.npy(rough() if z is None else z), "--pitch", "1um,2um", "--modulus", "1GPa", "--pressure", "1MPa,5MPa", "--out", "out", "--quiet",
                   "--write", written, *arguments, env=without_gnuplot(), **settings)
        return json.loads((self.folder / "out/summary.json").read_text())["steps"]

    def fields(self, k, z):
        """What the files of step k are to hold: unit and values by name."""
        found = {"heights": ("m", z), "pressure": ("Pa", np.load(self.folder / ("out/pressure-%d.npy" % k))), "gap": ("m", np.load(self.folder / ("out/gap-%d.npy" % k)))}
        if (self.folder / "out/indentation-1.npy").exists():
            found["indentation"] = ("m", np.load(self.folder / ("out/indentation-%d.npy" % k)))
        return found

    def assert_numbers(self, step, read):
        """read(name): the number, or None where the file has none."""
        for name, value in step.items():
            found = read(name)
            if value is None:
                self.assertFalse(found is not None and np.isfinite(found).any(), name)
            else:
                self.assertEqual(found.decode() if isinstance(found, bytes) else found, value, name)

    def surfaces(self):
        """Plain, with excluded points, and yielding."""
        z = rough()
        holes = z.copy()
        holes[3:6, 7] = np.nan
        return (z, []), (holes, ["--missing", "exclude"]), (z, ["--hardness", "50MPa"])

    def assert_file(self, file, k, z, step, numbers, text):
        """Fields with their units, coordinates, and the step's numbers. text: of an attribute"""
        for name, (unit, values) in self.fields(k, z).items():
            np.testing.assert_array_equal(file[name][:], values)
            self.assertEqual(text(file[name], "units"), unit)
        np.testing.assert_allclose(file["x"][:], (np.arange(z.shape[1]) + 0.5) * 1e-6, rtol=1e-14)
        np.testing.assert_allclose(file["y"][:], (np.arange(z.shape[0]) + 0.5) * 2e-6, rtol=1e-14)
        self.assert_numbers(step, numbers)
        self.assertEqual([text(file, name + "_unit") for name in ("load", "mean_pressure", "stiffness")], ["N", "Pa", "N/m"])

    def test_hdf5(self):
        h5py = needs("h5py")
        for z, arguments in self.surfaces():
            for k, step in enumerate(self.press("hdf5", *arguments, z=z), 1):
                with h5py.File(self.folder / ("out/step-%d.h5" % k)) as file:
                    self.assertEqual(set(file), {"x", "y", *self.fields(k, z)})
                    self.assert_file(file, k, z, step, file.attrs.get, lambda of, name: of.attrs[name].decode())

    def test_netcdf(self):
        netcdf = needs("netCDF4")
        for z, arguments in self.surfaces():
            for k, step in enumerate(self.press("netcdf", *arguments, z=z), 1):
                with netcdf.Dataset(self.folder / ("out/step-%d.nc" % k)) as file:
                    file.set_auto_mask(False)
                    self.assertEqual(file["gap"].dimensions, ("y", "x"))
                    self.assert_file(file, k, z, step, lambda name: getattr(file, name), getattr)

    def test_vti_as_its_format_says(self):
        for z, arguments in self.surfaces():
            for k, step in enumerate(self.press("vti", *arguments, z=z), 1):
                contents = (self.folder / ("out/step-%d.vti" % k)).read_bytes()
                mark = b'<AppendedData encoding="raw">_'
                begin = contents.index(mark) + len(mark)
                end = contents.rindex(b"</AppendedData>")
                root = ElementTree.fromstring(contents[:begin] + contents[end:])
                self.assertEqual((root.get("type"), root.get("byte_order"), root.get("header_type")), ("ImageData", "LittleEndian", "UInt64"))
                grid = root.find("ImageData")
                self.assertEqual(grid.get("WholeExtent"), "0 %d 0 %d 0 0" % z.shape[::-1])
                np.testing.assert_allclose([float(value) for value in grid.get("Spacing").split()], [1e-6, 2e-6, 1], rtol=1e-14)
                arrays = {array.get("Name"): int(array.get("offset")) for array in grid.iter("DataArray") if array.get("offset")}
                for name, (unit, values) in self.fields(k, z).items():
                    at = begin + arrays.pop("%s [%s]" % (name, unit))
                    self.assertEqual(struct.unpack_from("<Q", contents, at)[0], values.nbytes)
                    np.testing.assert_array_equal(np.frombuffer(contents, "<f8", values.size, at + 8).reshape(values.shape), values)
                    last = at + 8 + values.nbytes
                self.assertEqual((arrays, last), ({}, end))
                numbers = {array.get("Name").split(" [")[0]: array for array in grid.find("FieldData")}

                def read(name):
                    if name not in numbers:
                        return None
                    text, kind = numbers[name].text, numbers[name].get("type")
                    return bytes(map(int, text.split()[:-1])) if kind == "String" else int(text) if kind == "Int64" else float(text)

                self.assert_numbers(step, read)

    def test_vti_as_vtk_reads_it(self):
        vtk = needs("vtk")
        from vtk.util.numpy_support import vtk_to_numpy

        for z, arguments in self.surfaces():
            for k, step in enumerate(self.press("vti", *arguments, z=z), 1):
                reader = vtk.vtkXMLImageDataReader()
                reader.SetFileName(str(self.folder / ("out/step-%d.vti" % k)))
                reader.Update()
                self.assertEqual(reader.GetErrorCode(), 0)
                image = reader.GetOutput()
                self.assertEqual(image.GetDimensions(), (z.shape[1] + 1, z.shape[0] + 1, 1))
                for name, (unit, values) in self.fields(k, z).items():
                    np.testing.assert_array_equal(vtk_to_numpy(image.GetCellData().GetArray("%s [%s]" % (name, unit))).reshape(z.shape), values)
                said = image.GetFieldData()
                self.assertEqual(said.GetAbstractArray("status").GetValue(0), step["status"])
                self.assertEqual(said.GetArray("load [N]").GetValue(0), step["load"])

    def test_files_belong_to_the_run(self):
        self.press("vti")
        self.assertTrue({"step-1.vti", "step-2.vti"} <= set(self.names("out")))
        again = [self.npy(rough()), "--pitch", "1um", "--modulus", "1GPa", "--pressure", "1MPa", "--out", "out", "--quiet"]
        self.solve(*again, env=without_gnuplot())
        self.assertFalse([name for name in self.names("out") if name.startswith("step-")])
        self.file("out/step-2.nc", "mine")
        self.solve(*again, env=without_gnuplot())
        self.assertIn("step-2.nc", self.names("out"))

    def test_a_resumed_run_writes_the_rest(self):
        common = ["--pitch", "1um", "--modulus", "1GPa", "--out", "out", "--quiet", "--write", "vti"]
        self.solve(self.npy(rough()), *common, "--pressure", "1MPa", env=without_gnuplot())
        before = (self.folder / "out/step-1.vti").read_bytes()
        self.solve("surface.npy", *common, "--pressure", "1MPa,2MPa", "--resume", env=without_gnuplot())
        self.assertEqual((self.folder / "out/step-1.vti").read_bytes(), before)
        self.assertIn("step-2.vti", self.names("out"))

    def test_a_command_that_was_built_without(self):
        """A copy of the command that stands alone finds no modules."""
        alone = self.folder / "roughcontact"
        shutil.copy(harness.COMMAND, alone)
        libraries = Path(harness.COMMAND).parent.parent / "lib"
        for name in ("netcdf", "hdf5"):
            done = subprocess.run([alone, "solve", self.npy(rough()), "--pitch", "1um", "--modulus", "1GPa", "--load", "1mN", "--out", "out", "--write", name],
                                  cwd=self.folder, capture_output=True, text=True, env=dict(os.environ, LD_LIBRARY_PATH=str(libraries)), timeout=60)
            self.assertEqual((done.returncode, done.stdout), (1, ""))
            self.assertRegex(done.stderr, r"^roughcontact: --write: %s was not built in .*\(Debian: libnetcdf-dev\), or give vti\n$" % name)
            self.assertFalse((self.folder / "out").exists())


if __name__ == "__main__":
    harness.main()
