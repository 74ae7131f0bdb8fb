"""examples/campaign without processes: which tasks a study asks for, what a worker answers, and a store that is interrupted."""

import contextlib
import os
import pathlib
import tempfile
import unittest
from unittest import mock

from packages import needed

needed("numpy", "tomllib", "pyarrow")

import numpy as np  # noqa: E402
import press  # noqa: E402
import pyarrow.parquet as pq  # noqa: E402
import roughcontact as rc  # noqa: E402
import store  # noqa: E402
import study  # noqa: E402

STUDY = """
store = "results"
[[surfaces]]
generator = "spectral"
shape = [24, 32]
pitch = 1.0
rms_slope = 0.1
vary = { hurst = [0.5, 0.8] }
seeds = 3
[system]
E = 1e9
nu = 0.3
[loads]
pressure = [1e6, 2e6, [1e6, 3e6, 1e6]]
"""
SPECTRAL = {"generator": "spectral", "shape": [24, 32], "pitch": 1.0, "rms_slope": 0.1}


class InFolder(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.folder = pathlib.Path(scratch.name)

    def tasks(self, text=STUDY):
        file = self.folder / "study.toml"
        file.write_text(text, encoding="utf-8")
        return study.tasks(file)[0]

    def refused(self, words, text):
        with self.assertRaisesRegex((study.StudyError, rc.RoughContactError), words):
            self.tasks(text)


class Plans(InFolder):
    def test_every_combination_once(self):
        tasks = self.tasks()
        self.assertEqual(len(tasks), 2 * 3 * 3)
        self.assertEqual(len({task.key for task in tasks}), len(tasks))
        said = {(t.asked["surface"]["hurst"], t.asked["surface"]["seed"], tuple(t.asked["history"])) for t in tasks}
        self.assertEqual(len(said), len(tasks))
        self.assertEqual({task.work for task in tasks}, {24 * 32, 3 * 24 * 32})

    def test_keys_follow_what_is_asked_and_not_how_it_is_written(self):
        keys = [task.key for task in self.tasks()]
        self.assertEqual(
            keys, [task.key for task in self.tasks(STUDY.replace("E = 1e9\nnu = 0.3", "# a word\nnu = 0.3\nE = 1e9"))]
        )
        more = [task.key for task in self.tasks(STUDY.replace("seeds = 3", "seeds = 4"))]
        self.assertEqual(len(set(more) & set(keys)), len(keys))
        for old, new in (
            ("E = 1e9", "E = 2e9"),
            ("rms_slope = 0.1", "rms_slope = 0.2"),
            ("[loads]", "[options]\ntol = 1e-4\n[loads]"),
        ):
            self.assertFalse(set(keys) & {task.key for task in self.tasks(STUDY.replace(old, new))}, new)
        with mock.patch.object(rc, "version", lambda: (99, 0, 0)):
            self.assertFalse(set(keys) & {task.key for task in self.tasks()})

    def test_files_by_their_contents(self):
        text = STUDY[: STUDY.index("generator")] + 'files = "*.npy"\nmissing = "fill"\n' + STUDY[STUDY.index("[system]") :]
        self.refused("no file", text)
        np.save(self.folder / "a.npy", np.zeros((4, 4)))
        with mock.patch.object(rc, "read", lambda file: rc.Surface(np.load(file), (1.0, 1.0))):
            before = self.tasks(text)
            np.save(self.folder / "a.npy", np.eye(4))
            self.assertFalse({task.key for task in before} & {task.key for task in self.tasks(text)})
            self.refused("missing", text.replace('"fill"', '"full"'))

    def test_refusals_say_what_is_wrong(self):
        for words, old, new in (
            ("stor is unknown", "store =", "stor ="),
            ("has no store", 'store = "results"', ""),
            ("a list is needed", "[[surfaces]]", "[surfaces]"),
            ("generator", '"spectral"', '"Statistics"'),
            ("slope", "rms_slope", "slope"),
            ("list of values", "[0.5, 0.8]", "0.5"),
            ("seed", "seeds = 3", "seeds = 0"),
            ("exactly one", "pressure = [1e6", "load = [1.0]\npressure = [1e6"),
            ("numbers are needed", "[1e6, 2e6", '["1MPa", 2e6'),
            ("nu is missing", "nu = 0.3", ""),
            ("boundary", "nu = 0.3", 'nu = 0.3\nboundary = "none"'),
            ("tolerance", "[loads]", "[options]\ntolerance = 1e-4\n[loads]"),
            ("time_limit", "[loads]", "[options]\ntime_limit = 1.0\n[loads]"),
            ("line 2", 'store = "results"', "store = results"),
        ):
            with self.subTest(words):
                self.assertIn(old, STUDY)
                self.refused(words, STUDY.replace(old, new))

    def test_chunks_hold_every_task_once_and_not_too_many(self):
        tasks = self.tasks(STUDY.replace("seeds = 3", "seeds = 100"))
        for workers in (1, 7):
            parts = list(study.chunks(tasks, workers))
            self.assertEqual([task for part in parts for task in part], tasks)
            self.assertGreaterEqual(len(parts), 8 * workers)
        large = [press.Task(str(k), {}, 10**9) for k in range(3)]
        self.assertEqual([len(part) for part in study.chunks(large, 1)], [1, 1, 1])


def task(history, seed=1, options=None, details=True, surface=SPECTRAL, version=".".join(map(str, rc.version())), **system):
    described = {"surface": {**surface, "seed": seed}, "control": "pressure", "history": history, "system": {"modulus": 1e9, **system}}
    described |= {"options": options or {}, "details": details, "version": version}
    return press.Task(str(described), described, 1)


class Answers(unittest.TestCase):
    def same(self, rows, batch):
        for name in ("load", "approach", "contact_area", "iterations", "products"):
            self.assertEqual([row[name] for row in rows], getattr(batch, name).ravel().tolist(), name)

    def test_bits_are_those_of_a_batch(self):
        surfaces = [rc.surface.spectral((24, 32), pitch=1.0, rms_slope=0.1, seed=seed) for seed in (1, 2, 3)]
        for history, system in (([1e6], {}), ([1e6, 4e6, 2e6], {"hardness": 3e7}), ([2e6], {"boundary": "free"})):
            rows = answers(*(task(history, seed, **system) for seed in (1, 2, 3)))
            self.same(rows, rc.batch(surfaces, modulus=1e9, pressure=history, threads=2, **system))
            self.assertEqual({row["status"] for row in rows}, {"OK"})
            self.assertTrue(all(row["load_lower"] <= row["load"] <= row["load_upper"] for row in rows))
            few = answers(*(task(history, seed, details=False, **system) for seed in (1, 2, 3)))
            for row, less in zip(rows, few, strict=True):
                # The certificate is of another product where more is asked for: the same residual, but for rounding.
                self.assertLess(abs(less.pop("certificate") - row["certificate"]), 1e-14)
                self.assertEqual(less, {name: row[name] for name in less} | {"task": less["task"], "key": less["key"]})
            self.assertTrue(all(0 < row["area_fraction"] < 1 and row["max_pressure"] > row["mean_pressure"] for row in rows))

    def test_histories_of_different_lengths_in_one_chunk(self):
        histories = {1: [1e6], 2: [1e6, 2e6], 3: [3e6]}
        rows = answers(*(task(history, seed) for seed, history in histories.items()))
        found = {seed: [row["target"] for row in rows if row["seed"] == seed] for seed in histories}
        self.assertEqual(found, histories)

    def test_failures_are_rows_and_touch_no_other(self):
        good, whole = task([1e6], 2, hardness=1e7), rc.batch(
            [rc.surface.spectral((24, 32), pitch=1.0, rms_slope=0.1, seed=2)], modulus=1e9, pressure=1e6, hardness=1e7
        )
        heavy = task([1e6, 2e7], 1, hardness=1e7)
        rows = answers(task([1e9], 3, hardness=1e7), good, heavy)
        by_seed = {seed: [row for row in rows if row["seed"] == seed] for seed in (1, 2, 3)}
        self.same(by_seed[2], whole)
        self.assertEqual([row["status"] for row in by_seed[1]], ["OK", "ERR_INFEASIBLE"])
        self.assertEqual(by_seed[3][0]["status"], "ERR_INFEASIBLE")
        self.assertIn("hardness", by_seed[3][0]["message"])
        self.assertNotIn("contacts are not certified", by_seed[1][1]["message"])

    def test_what_raises_is_a_failure_of_its_task_alone(self):
        """And an answer that is not certified keeps its numbers."""
        lost = task([1e6], 5, surface={"file": "no such file.gsf", "contents": ""})
        del lost.asked["surface"]["seed"]
        other = task([1e6], 6, surface={**SPECTRAL, "shape": [16, 16]})
        rows = answers(task([1e6], 4), lost, other, task([1e6], 7, options={"max_iter": 1, "solver": "polonsky-keer"}))
        self.assertEqual([row["status"] == "OK" for row in rows], [True, False, True, False])
        self.assertTrue(rows[1]["message"] and rows[3]["message"] and rows[3]["load"] > 0)
        self.assertEqual(rows[3]["status"], "STOP_MAX_ITER")

    def test_another_library_is_refused(self):
        with self.assertRaisesRegex(RuntimeError, "0.0.1"):
            press.chunk([task([1e6], version="0.0.1")])


def answers(*tasks):
    """Rows of a chunk."""
    found = press.chunk(list(tasks))
    return [dict(zip(found, values)) for values in zip(*found.values())]


def rows_of(*keys, status="OK", **more):
    return press.columns([{"key": key, "step": 0, "status": status, **more} for key in keys])


class Died(BaseException):
    """In the place of a signal that ends the process."""


class Stores(InFolder):
    def open(self, name):
        return store.Store(self.folder / "results", {"run": name, "study": name})

    def contents(self):
        table = pq.read_table(self.folder / "results" / store.FILE).to_pylist()
        return [(row["key"], row["run"]) for row in table]

    def test_rows_and_provenance_of_all_runs(self):
        with self.open("first") as kept:
            kept.add(rows_of("b", load=1))
            kept.add(rows_of("a", hurst=0.5, load=2.5))
        with self.open("second") as kept:
            self.assertEqual(kept.done(), ({"a", "b"}, set()))
            kept.add(rows_of("c", status="ERR_MEMORY"))
            kept.merge()
            self.assertEqual(kept.done(), ({"a", "b", "c"}, {"c"}))
        self.assertEqual(self.contents(), [("a", "first"), ("b", "first"), ("c", "second")])
        about = pq.read_schema(self.folder / "results" / store.FILE).metadata[store.ABOUT]
        self.assertEqual([run["study"] for run in store.json.loads(about)["runs"]], ["first", "second"])

    def test_rows_of_tasks_done_again_take_the_place_of_the_old(self):
        with self.open("first") as kept:
            kept.add(rows_of("a", "b", status="ERR_MEMORY"))
        with self.open("second") as kept:
            kept.add(rows_of("a"))
            kept.merge()
            self.assertEqual(kept.done(), ({"a", "b"}, {"b"}))
        self.assertEqual(self.contents(), [("a", "second"), ("b", "first")])

    def test_one_client_at_a_time(self):
        with self.open("first"):
            with self.assertRaisesRegex(store.StoreError, "another campaign"):
                self.open("second")
        self.open("third").__exit__()

    def test_a_death_anywhere_loses_nothing_that_was_kept(self):
        """The process ends before the k-th call that changes the folder."""
        changes = [(os, "replace"), (pathlib.Path, "unlink"), (os, "fsync")]
        for k in range(1, 30):
            with self.subTest(k), tempfile.TemporaryDirectory() as scratch:
                self.folder, count, kept = pathlib.Path(scratch), iter(range(1, 1000)), []

                def dying(function):
                    def call(*arguments, **named):
                        if next(count) == k:
                            raise Died
                        return function(*arguments, **named)

                    return call

                with contextlib.ExitStack() as stack:
                    for place, name in changes:
                        stack.enter_context(mock.patch.object(place, name, dying(getattr(place, name))))
                    with contextlib.suppress(Died):
                        with self.open("first") as results:
                            for key in "abc":
                                results.add(rows_of(key))
                                kept.append(key)
                            results.merge()
                        with self.open("second") as results:
                            results.add(rows_of("d"))
                            kept.append("d")
                            results.merge()
                with self.open("third") as results:
                    done, _ = results.done()
                    self.assertEqual(list((self.folder / "results" / store.PARTS).iterdir()), [])
                self.assertLessEqual(set(kept), done)
                if done:
                    self.assertEqual([key for key, _ in self.contents()], sorted(done))
                if next(count) <= k:
                    return
        self.fail("the process never lived")


if __name__ == "__main__":
    unittest.main()
