#!/usr/bin/env python3
"""The Python package on arguments of every kind: python_fuzzer.py LIBRARY [FILE...|FOLDER... and options of libFuzzer].

Each call ends in a result or in an exception of the package or of Python's own for wrong arguments, never in a crash. With
files or folders alone, these are run; else atheris makes up bytes. Ends with 77, "skipped", where atheris or numpy is not there.
"""
import os
import struct
import sys
from pathlib import Path

try:
    import numpy as np
except ImportError:
    print("skipped: no numpy")
    sys.exit(77)
if len(sys.argv) < 2:
    sys.exit(__doc__)
os.environ["ROUGHCONTACT_LIBRARY"] = os.path.abspath(sys.argv.pop(1))
sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "bindings" / "python"))
try:
    import atheris
except ImportError:
    atheris = None
if atheris:
    with atheris.instrument_imports(include=["roughcontact"]):
        import roughcontact as rc
else:
    import roughcontact as rc

EXPECTED = (rc.RoughContactError, TypeError, ValueError, OverflowError, MemoryError)
DTYPES = ["f8", "f4", "i4", "u1", "?", ">f8", "O", "S3"]
NAMES = ["auto", "nnls", "polonsky-keer", "haar-cg", "gp", "dense", "fft", "", "no such", "a\0b"]
KEYS = ["solver", "backend", "kernel", "tol", "max_iter", "bounds", "accuracy", "fft.precision", "nothing"]


class Bytes:
    def __init__(self, data):
        self.data, self.at = data, 0

    def byte(self):
        self.at += 1
        return self.data[self.at - 1] if self.at <= len(self.data) else 0

    def number(self):
        kind = self.byte()
        if kind < 200:
            return (kind - 100) / 16
        if kind < 210:
            return struct.unpack("<d", bytes(self.byte() for _ in range(8)))[0]
        return [None, 1, 0, -1, 10**30, "1", 1j, np.float32(2), np.array(1.0), float("nan"), True][kind % 11]

    def array(self):
        nx, ny, kind = self.byte() % 7, self.byte() % 7, self.byte()
        values = np.array([(self.byte() - 100) / 16 for _ in range(nx * ny)]).reshape(ny, nx)
        values = values.astype(DTYPES[kind % len(DTYPES)])
        layout = kind // 8 % 6
        return [values, values.T, values[::2], np.asfortranarray(values), values.tolist(), values[..., None]][layout]

    def options(self):
        return {KEYS[self.byte() % len(KEYS)]: NAMES[self.byte() % len(NAMES)] if self.byte() % 2 else self.number() for _ in range(self.byte() % 3)}


def run(data):
    source = Bytes(data)
    gap, control = source.array(), ["approach", "load"][source.byte() % 2]
    wanted = {control: source.number(), "pitch": source.number(), "modulus": source.number(), "options": source.options()}
    if source.byte() % 4 == 0:
        wanted["mask"] = source.array()
    if source.byte() % 4 == 0:
        wanted["boundary"] = ["free", "periodic", "none"][source.byte() % 3]
    try:
        result = rc.solve(undeformed_gap=gap, **wanted)
    except EXPECTED:
        return
    assert np.isfinite(result.load), "a result has a load"
    assert result.pressure.shape == np.asarray(gap).shape, "pressures have the gap's shape"


def main():
    paths = [Path(argument) for argument in sys.argv[1:]]
    if paths and all(path.exists() for path in paths):
        for path in paths:
            for file in sorted(path.iterdir()) if path.is_dir() else [path]:
                run(file.read_bytes())
    elif atheris:
        atheris.Setup(sys.argv, run)
        atheris.Fuzz()
    else:
        print("skipped: no atheris")
        sys.exit(77)


if __name__ == "__main__":
    main()
