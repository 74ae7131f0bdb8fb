"""A study's results in one Parquet file, written so that the death of the client loses no finished chunk."""

import fcntl
import json
import os
import pathlib

import press
import pyarrow as pa
import pyarrow.compute as pc
import pyarrow.parquet as pq

FILE, PARTS, LOCK = "study.parquet", "parts", "lock"
ABOUT = b"roughcontact-campaign"  # the file's metadata: {"runs": [...]}, the provenance of every run that added rows


class StoreError(Exception):
    """The store is in use, or is none."""


class Store:
    """A folder: study.parquet, and parts/ with the chunks that were finished since it was written. Opened by one client at a
    time.

    A chunk is written to a temporary name, then renamed: a part is whole, or is not there. Merging writes the new file before
    it removes parts, so that a merge which is interrupted is made again with the same result.
    """

    def __init__(self, folder, run):
        """run: the provenance of what is going to be added, a dictionary with a name that no other run has under "run"."""
        self.folder, self._run, self._count = pathlib.Path(folder), run, 0
        (self.folder / PARTS).mkdir(parents=True, exist_ok=True)
        self._lock = open(self.folder / LOCK, "w")
        try:
            fcntl.flock(self._lock, fcntl.LOCK_EX | fcntl.LOCK_NB)  # ends with the process, however that ends
        except OSError:
            self._lock.close()
            raise StoreError(f"another campaign is writing to {self.folder}; wait for it, or end it") from None
        self.merge()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._lock.close()

    def add(self, columns):
        """Keeps a finished chunk."""
        table = pa.table({**columns, "run": [self._run["run"]] * len(columns["key"])})
        _write(_about(table, [self._run]), self.folder / PARTS / f"{self._count:08d}.parquet")
        self._count += 1

    def merge(self):
        """Makes one file of all. Rows of a part are in the place of the file's with the same keys: tasks that were done again."""
        for file in (self.folder / PARTS).glob("*.tmp"):
            file.unlink()
        parts = sorted((self.folder / PARTS).glob("*.parquet"))
        if not parts:
            return
        tables = [pq.read_table(file, partitioning=None) for file in parts]
        if (self.folder / FILE).exists():
            old = pq.read_table(self.folder / FILE)
            done = pa.chunked_array([chunk for table in tables for chunk in table["key"].chunks])
            tables.insert(0, old.filter(pc.invert(pc.is_in(old["key"], done))))
        runs = {run["run"]: run for table in tables for run in json.loads(table.schema.metadata[ABOUT])["runs"]}
        whole = pa.concat_tables(tables, promote_options="permissive").sort_by([("key", "ascending"), ("step", "ascending")])
        _write(_about(whole, list(runs.values())), self.folder / FILE)
        for file in parts:
            file.unlink()

    def done(self):
        """Keys of the tasks in the file, and of those that failed."""
        if not (self.folder / FILE).exists():
            return set(), set()
        table = pq.read_table(self.folder / FILE, columns=["key", "status"])
        bad = table.filter(pc.invert(pc.is_in(table["status"], pa.array(press.GOOD))))
        return set(table["key"].to_pylist()), set(bad["key"].to_pylist())


def _about(table, runs):
    return table.replace_schema_metadata({ABOUT: json.dumps({"runs": runs})})


def _write(table, file):
    temporary = file.with_suffix(".tmp")
    with open(temporary, "wb") as stream:
        pq.write_table(table, stream, compression="zstd")
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(temporary, file)
