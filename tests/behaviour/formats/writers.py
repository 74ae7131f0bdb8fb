"""Writers of surface files, from the formats' descriptions and independent of the readers. Heights z[iy, ix] in metres; NaN: missing."""
import io
import struct
import zipfile
import zlib

import numpy as np

DEFLATED = zipfile.ZIP_DEFLATED


def zip_of(entries, method=DEFLATED):
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w", method) as archive:
        for name, contents in entries.items():
            archive.writestr(name, contents)
    return stream.getvalue()


def x3p_xml(nx, ny, hx, hy, kind="D", z_axis="", data="", prefix="p:ISO5436_2", axis_type="I", feature="SUR", layers=1):
    space = ' xmlns:p="http://www.opengps.eu/2008/ISO5436_2"' if prefix.startswith("p:") else ""
    return """<?xml version="1.0" encoding="UTF-8"?>
<%s%s>
  <Record1><Revision>ISO5436 - 2000</Revision><FeatureType>%s</FeatureType><Axes>
    <CX><AxisType>%s</AxisType><DataType>D</DataType><Increment>%.17g</Increment><Offset>0</Offset></CX>
    <CY><AxisType>I</AxisType><DataType>D</DataType><Increment>%.17g</Increment></CY>
    <CZ><AxisType>A</AxisType><DataType>%s</DataType>%s</CZ></Axes></Record1>
  <Record3><MatrixDimension><SizeX>%d</SizeX><SizeY>%d</SizeY><SizeZ>%d</SizeZ></MatrixDimension>%s</Record3>
</%s>
""" % (prefix, space, feature, axis_type, hx, hy, kind, z_axis, nx, ny, layers, data, prefix)


def x3p(z, hx, hy, kind="D", scale=None, offset=0, valid_bits=False, folder="", prefix="p:ISO5436_2", listed=False, method=DEFLATED):
    ny, nx = z.shape
    z_axis = "" if scale is None else "<Increment>%.17g</Increment><Offset>%.17g</Offset>" % (scale, offset)
    raw = z if scale is None else np.round((z - offset) / scale)
    missing = np.isnan(raw)
    if listed:
        items = ("<Datum>%s</Datum>" % ("" if np.isnan(v) else "%.17g" % v) for v in raw.ravel())
        data = "<DataList>%s</DataList>" % "".join(items)
        return zip_of({folder + "main.xml": x3p_xml(nx, ny, hx, hy, kind, z_axis, data, prefix)}, method)
    values = np.where(missing, 0, raw) if valid_bits else raw
    data = "<PointDataLink>bindata/data.bin</PointDataLink><MD5ChecksumPointData>0</MD5ChecksumPointData>"
    entries = {folder + "bindata/data.bin": values.astype({"I": "<i2", "L": "<i4", "F": "<f4", "D": "<f8"}[kind]).tobytes()}
    if valid_bits:
        data += "<ValidPointsLink>bindata/valid.bin</ValidPointsLink>"
        entries[folder + "bindata/valid.bin"] = np.packbits(~missing.ravel(), bitorder="little").tobytes()
    entries[folder + "main.xml"] = x3p_xml(nx, ny, hx, hy, kind, z_axis, "<DataLink>%s</DataLink>" % data, prefix)
    return zip_of(entries, method)


def sur(z, hx, hy, dz, bits=32, unit="mm", per_metre=1e3, comment=b"", private=b"", streams=0, objects=1, kind=2, flag=1):
    """`streams` > 0: compressed into so many."""
    ny, nx = z.shape
    missing = np.isnan(z)
    raw = np.where(missing, 0, np.round(z / dz)).astype("i8")
    zmin, zmax = raw[~missing].min(), raw[~missing].max()
    raw[missing] = zmin - 2
    word = lambda text: text.encode("latin-1").ljust(16)
    header = (b"DSCOMPRESSED" if streams else b"DIGITAL SURF") + struct.pack("<4H", 0, objects, 1, kind) + bytes(60)
    header += struct.pack("<5H", 0, 0, 0, flag, 1) + bytes(8) + struct.pack("<H5i", bits, zmin, zmax, nx, ny, nx * ny)
    header += struct.pack("<3f", hx * per_metre, hy * per_metre, dz * per_metre)
    header += word("X") + word("Y") + word("Z") + 6 * word(unit) + struct.pack("<3f", 1, 1, 1)
    header = header.ljust(334, b"\0") + struct.pack("<2H", len(comment), len(private))
    header = header.ljust(512, b"\0")
    data = raw.astype("<i2" if bits == 16 else "<i4").tobytes()
    if streams:
        parts = [data[i * len(data) // streams : (i + 1) * len(data) // streams] for i in range(streams)]
        packed = [zlib.compress(part) for part in parts]
        table = b"".join(struct.pack("<2I", len(part), len(small)) for part, small in zip(parts, packed))
        data = struct.pack("<I", streams) + table + b"".join(packed)
    return header + comment + private + data


def sdf_text(z, hx, hy, scale, magic="aISO-1.0", end="\n", extra=""):
    ny, nx = z.shape
    lines = [magic, "ManuFacID = test", "CreateDate = 010120200000", "ModDate = 010120200000", "NumPoints = %d" % nx, "NumProfiles = %d" % ny,
             "Xscale = %.17g" % hx, "Yscale = %.17g" % hy, "Zscale = %.17g" % scale, "Zresolution = -1", "Compression = 0", "DataType = 7", "CheckType = 0"]
    if extra:
        lines.insert(3, extra)
    lines.append("*")
    lines += [" ".join("BAD" if np.isnan(v) else "%.17g" % (v / scale) for v in row) for row in z]
    return (end.join(lines + ["*", "trailer", "*"]) + end).encode()


SDF_TYPES = ["u1", "<u2", "<u4", "<f4", "i1", "<i2", "<i4", "<f8"]


def sdf_binary(z, hx, hy, scale, kind, magic=b"bISO-1.0", compression=0, check=0):
    ny, nx = z.shape
    dtype = np.dtype(SDF_TYPES[kind])
    raw = z / scale
    if dtype.kind in "iu":
        missing = np.iinfo(dtype).min
        raw = np.where(np.isnan(raw), missing, np.round(raw))
    header = magic + b"test".ljust(10) + b"010120200000" * 2 + struct.pack("<2H4d", nx, ny, hx, hy, scale, -1)
    return header + bytes([compression, kind, check]) + raw.astype(dtype).tobytes()


def plu(z, hx, hy, kind=3):
    ny, nx = z.shape
    header = b"Fri Mar 10 16:35:59 2023".ljust(128, b"\0") + struct.pack("<I", 1) + bytes(256)
    header += struct.pack("<3I7f", ny, nx, nx, 1, hx * 1e6, hy * 1e6, 0, 0, hx * 1e6, 0) + struct.pack("<5I", kind, 0, 0, 0, 0) + bytes(40 + 12)
    header += struct.pack("<2I", ny, nx)
    assert len(header) == 508
    return header + np.where(np.isnan(z), 1000001, z * 1e6).astype("<f4").tobytes() + struct.pack("<2f", 0, 0)


def netcdf(variables, dimensions, version=2):
    """Classic NetCDF. dimensions: name: length. variables: name: (dimensions, array, attributes)."""
    count = lambda n: struct.pack(">q" if version == 5 else ">i", n)
    padded = lambda data: data + bytes(-len(data) % 4)
    name = lambda text: count(len(text)) + padded(text.encode())
    types = {"S": 2, "i2": 3, "i4": 4, "f4": 5, "f8": 6}

    def attribute(key, value):
        if isinstance(value, (str, bytes)):
            data = value if isinstance(value, bytes) else value.encode()
            return name(key) + struct.pack(">i", 2) + count(len(data)) + padded(data)
        array = np.atleast_1d(value)
        array = array.astype(array.dtype.newbyteorder(">")) if array.dtype.str[1:] in types else array.astype(">f8")
        return name(key) + struct.pack(">i", types[array.dtype.str[1:]]) + count(array.size) + padded(array.tobytes())

    def listed(tag, items):
        return struct.pack(">i", tag if items else 0) + count(len(items)) + b"".join(items)

    ids = {key: i for i, key in enumerate(dimensions)}
    arrays = {key: np.asarray(array).astype(np.asarray(array).dtype.newbyteorder(">")) for key, (_, array, _) in variables.items()}

    def header(begins):
        entries = []
        for key, (shape, _, attributes) in variables.items():
            data = padded(arrays[key].tobytes())
            entries.append(name(key) + count(len(shape)) + b"".join(count(ids[d]) for d in shape)
                           + listed(12, [attribute(k, v) for k, v in attributes.items()])
                           + struct.pack(">i", types[arrays[key].dtype.str[1:]]) + count(len(data))
                           + struct.pack(">i" if version == 1 else ">q", begins[key]))
        return (b"CDF" + bytes([version]) + count(0) + listed(10, [name(d) + count(n) for d, n in dimensions.items()])
                + listed(12, [attribute("title", "made by a test")]) + listed(11, entries))

    at, begins = len(header(dict.fromkeys(variables, 0))), {}
    for key in variables:
        begins[key] = at
        at += len(padded(arrays[key].tobytes()))
    return header(begins) + b"".join(padded(arrays[key].tobytes()) for key in variables)


def contact_engineering(z, hx, hy, unit="m", version=2, periodic=0, kind="f8", height_attributes=None, heights=None):
    ny, nx = z.shape
    lateral = lambda n, h: {"length": n * h, "periodic": np.int32(periodic), **({"unit": unit} if unit else {})}
    own = {"unit": unit} if unit else {}
    return netcdf({"heights": (("x", "y"), (z.T if heights is None else heights).astype(kind), {**own, **(height_attributes or {})}),
                   "x": (("x",), np.arange(nx) * hx, lateral(nx, hx)), "y": (("y",), np.arange(ny) * hy, lateral(ny, hy))},
                  {"x": nx, "y": ny}, version)


def hdf5(z, version="earliest", **how):
    """A data set "surface" by h5py, None if that is not installed. how: as its create_dataset takes them."""
    try:
        import h5py
    except ImportError:
        return None
    with io.BytesIO() as stream:
        with h5py.File(stream, "w", libver=version) as file:
            file.create_dataset("surface", data=z.T, **how)
        return stream.getvalue()


def tiff(values, order="<", compression=1, **tags):
    """A TIFF of one strip; tags: instead of those that the values have."""
    values = values.astype(values.dtype.newbyteorder(order))
    data = values.tobytes() if compression == 1 else zlib.compress(values.tobytes())
    kind = {"u": 1, "i": 2, "f": 3}[values.dtype.kind]
    found = {256: values.shape[1], 257: values.shape[0], 258: 8 * values.dtype.itemsize, 259: compression, 262: 1, 273: 8, 277: 1,
             278: values.shape[0], 279: len(data), 339: kind, **{int(tag[1:]): value for tag, value in tags.items()}}
    entries = b"".join(struct.pack(order + "HHII", tag, 4, 1, value) for tag, value in sorted(found.items()))
    head = (b"II*\0" if order == "<" else b"MM\0*") + struct.pack(order + "I", 8 + len(data) + len(data) % 2)
    return head + data + bytes(len(data) % 2) + struct.pack(order + "H", len(found)) + entries + bytes(4)


def png(values, colour=0, bits=None, chunks=()):
    values = values.astype(values.dtype.newbyteorder(">"))
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    header = struct.pack(">IIBBBBB", values.shape[1], values.shape[0], bits or 8 * values.dtype.itemsize, colour, 0, 0, 0)
    rows = b"".join(b"\0" + row.tobytes() for row in values)
    extra = b"".join(chunk(*each) for each in chunks)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra + chunk(b"IDAT", zlib.compress(rows)) + chunk(b"IEND", b"")
