"""examples/campaign on processes: a worker is killed, the client is killed, a task ends its process. Each task is in the store once, and
its numbers are those of rc_batch_solve, bit for bit."""

import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from packages import needed

needed("numpy", "tomllib", "pyarrow", "distributed", "psutil")

import campaign  # noqa: E402
import dask  # noqa: E402
import press  # noqa: E402
import psutil  # noqa: E402
import pyarrow.parquet as pq  # noqa: E402
import roughcontact as rc  # noqa: E402
import store  # noqa: E402
from distributed import Client, LocalCluster, WorkerPlugin  # noqa: E402
from test_parts import task  # noqa: E402

POINTS, SEEDS, PRESSURES, HARDNESS = 384, 40, (1e6, 5e6), 5e8
STUDY = f"""
store = "results"
[[surfaces]]
generator = "spectral"
shape = [{POINTS}, {POINTS}]
pitch = 1.0
rms_slope = 0.1
seeds = {SEEDS}
[system]
modulus = 1e9
hardness = {HARDNESS}
[loads]
pressure = [{PRESSURES[0]}, {PRESSURES[1]}, {2 * HARDNESS}]
"""
TASKS = 3 * SEEDS  # a third of them beyond the hardness
LIMIT = 600  # s


class Campaign:
    def __init__(self, folder):
        self.study, self.results = folder / "study.toml", folder / "results"
        self.study.write_text(STUDY, encoding="utf-8")

    def start(self, *arguments):
        command = [sys.executable, campaign.__file__, self.study, "--workers", "2", *arguments]
        return subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)

    def run(self, *arguments):
        with self.start(*arguments) as process:
            said = process.communicate(timeout=LIMIT)
        return process.returncode, *said

    def parts(self):
        return sorted((self.results / store.PARTS).glob("*.parquet"))

    def started(self, *arguments):
        """A campaign of which a chunk is finished, but not the last one."""
        process, begun = self.start(*arguments), time.monotonic()
        while not self.parts():
            assert process.poll() is None and time.monotonic() - begun < LIMIT, process.communicate()
            time.sleep(0.01)
        assert not (self.results / store.FILE).exists(), "the study is too short for this machine"
        return process

    def rows(self):
        return pq.read_table(self.results / store.FILE).to_pylist()


def workers_of(process):
    """They are forked by a process of the client's own."""
    children = psutil.Process(process.pid).children(recursive=True)
    servers = {child.pid for child in children if "forkserver" in " ".join(child.cmdline())}
    return [child for child in children if child.ppid() in servers]


class Killed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        surfaces = [rc.surface.spectral((POINTS,) * 2, pitch=1.0, rms_slope=0.1, seed=seed) for seed in range(1, SEEDS + 1)]
        cls.batches = {
            pressure: rc.batch(surfaces, modulus=1e9, hardness=HARDNESS, pressure=[[pressure]] * SEEDS, threads=2)
            for pressure in PRESSURES
        }

    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.campaign = Campaign(pathlib.Path(scratch.name))

    def check(self):
        """Rows of the finished store by their keys."""
        rows = self.campaign.rows()
        by_key = {row["key"]: row for row in rows}
        self.assertEqual((len(rows), len(by_key)), (TASKS, TASKS))
        for row in rows:
            if row["target"] > HARDNESS:
                self.assertEqual(row["status"], "ERR_INFEASIBLE")
                self.assertIn("hardness", row["message"])
                continue
            self.assertEqual(row["status"], "OK")
            batch = self.batches[row["target"]]
            for name in ("load", "approach", "contact_area", "iterations", "products"):
                self.assertEqual(row[name], getattr(batch, name)[row["seed"] - 1, 0], name)
        return by_key

    def test_a_worker(self):
        with self.campaign.started() as process:
            victims = workers_of(process)
            self.assertEqual(len(victims), 2)
            victims[0].kill()
            said = process.communicate(timeout=LIMIT)
        self.assertEqual(process.returncode, 1, said)
        self.assertIn(f"{TASKS} tasks, {SEEDS} failed", said[0])
        self.assertEqual(len({row["run"] for row in self.check().values()}), 1)

    def test_the_client(self):
        with self.campaign.started() as process:
            workers = workers_of(process)
            status, _, said = self.campaign.run()
            self.assertEqual(status, 2)
            self.assertIn("another campaign", said)
            process.kill()
        self.assertFalse(psutil.wait_procs(workers, timeout=60)[1], "the workers outlive the client")
        self.assertFalse((self.campaign.results / store.FILE).exists())
        kept = {row["key"]: row for part in self.campaign.parts() for row in pq.read_table(part).to_pylist()}
        self.assertTrue(0 < len(kept) < TASKS)

        status, _, said = self.campaign.run()
        self.assertEqual(status, 1, said)
        self.assertIn(f"{TASKS} tasks, {len(kept)} of them done before", said)
        finished = self.check()
        self.assertEqual(
            {key for key, row in finished.items() if row["run"] in {row["run"] for row in kept.values()}}, set(kept)
        )
        self.assertEqual(len({row["run"] for row in finished.values()}), 2)

        whole = (self.campaign.results / store.FILE).read_bytes()
        self.assertEqual(self.campaign.run()[0], 1)
        self.assertEqual((self.campaign.results / store.FILE).read_bytes(), whole)
        self.assertEqual(self.campaign.run("--retry-failed")[0], 1)
        for key, row in self.check().items():
            self.assertEqual(row["run"] == finished[key]["run"], row["status"] == "OK")


class Deadly(WorkerPlugin):
    """Gives the workers a surface that ends their process."""

    def setup(self, worker):
        rc.surface.deadly = lambda seed: os.kill(os.getpid(), signal.SIGKILL)


class TaskThatKills(unittest.TestCase):
    def test_it_alone_is_lost(self):
        rough, deadly = {"generator": "spectral", "shape": [32, 32], "pitch": 1.0, "rms_slope": 0.1}, {"generator": "deadly"}
        asked = [task([1e6], seed, details=False, surface=deadly if seed == 5 else rough).asked for seed in range(12)]
        tasks = [press.Task(str(each["surface"]["seed"]), each, 1) for each in asked]
        dask.config.set({"distributed.scheduler.worker-saturation": 1.0, "distributed.scheduler.allowed-failures": 1})
        with tempfile.TemporaryDirectory() as folder, store.Store(folder, {"run": "only"}) as kept:
            with LocalCluster(n_workers=1, threads_per_worker=1, dashboard_address=":0") as cluster, Client(cluster) as client:
                client.register_plugin(Deadly())
                campaign.solve(client, tasks, kept)
            kept.merge()
            rows = pq.read_table(pathlib.Path(folder) / store.FILE).to_pylist()
        self.assertEqual(
            {row["key"]: row["status"] for row in rows},
            {task.key: "KilledWorker" if task.key == "5" else "OK" for task in tasks},
        )
        self.assertEqual(len(rows), len(tasks))
        self.assertTrue(all(row["message"] for row in rows if row["key"] == "5"))


if __name__ == "__main__":
    unittest.main()
