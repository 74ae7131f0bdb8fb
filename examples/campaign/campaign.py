"""A parameter study on many processes: campaign.py STUDY.toml [--workers N | --scheduler ADDRESS] [--retry-failed]

Each task of the study is done once and kept with its message where it fails. The same command goes on after any interruption.
Needs Python 3.11 and the packages dask, distributed and pyarrow. Exits with 0 when every answer is certified, 1 when tasks
failed, 2 when the campaign could not go on, 130 after Ctrl-C.
"""

import argparse
import contextlib
import datetime
import importlib.metadata
import multiprocessing.forkserver
import os
import platform
import sys
import time

if __name__ == "__main__":  # while this process imports, so does the one from which workers will be forked
    multiprocessing.set_forkserver_preload(["distributed", "pyarrow.parquet", "roughcontact"])
    multiprocessing.forkserver.ensure_running()

import dask
import press
import roughcontact as rc
import store
import study
from distributed import Client, KilledWorker, LocalCluster, as_completed

LOCAL = {  # of dask, for processes of this machine
    "distributed.scheduler.worker-saturation": 1.0,  # a process that dies takes along no chunk that it had not begun
    "distributed.nanny.pre-spawn-environ": {},  # what is set by default makes each solve ask the system for memory anew
    "distributed.worker.multiprocessing-method": "forkserver",  # which imports once for all processes
    "distributed.worker.profile.enabled": False,  # nor does anybody look at what dask measures meanwhile
    "distributed.worker.memory.monitor-interval": "2s",
    "distributed.admin.system-monitor.interval": "10s",
    "distributed.admin.tick.interval": "1s",
}


def provenance(text, arguments):
    """What made the rows of this run."""
    parts = [part for list_of in (rc.backends, rc.solvers, rc.kernels) for part in list_of()]
    return {
        "run": datetime.datetime.now(datetime.timezone.utc).isoformat(),
        "study": text,
        "command": arguments,
        "host": platform.node(),
        "system": platform.platform(),
        "roughcontact": ".".join(map(str, rc.version())),
        "library": rc.library_file(),
        "components": [{"name": part.name, "license": part.license, "origin": part.origin} for part in parts],
        "packages": {name: importlib.metadata.version(name) for name in ("numpy", "distributed", "pyarrow")},
        "python": platform.python_version(),
    }


class Progress:
    """A line on stderr, rewritten on a terminal, otherwise every ten seconds."""

    def __init__(self, total):
        self._total, self._begin, self._shown = total, time.monotonic(), time.monotonic()
        self._live = sys.stderr.isatty()
        self.done = self.failed = 0

    def add(self, tasks, failed):
        self.done, self.failed = self.done + tasks, self.failed + failed
        now = time.monotonic()
        if now - self._shown > (0.2 if self._live else 10) or self.done == self._total:
            self._shown = now
            rate = self.done / (now - self._begin)
            left = f"{rate:.3g} a second, {(self._total - self.done) / rate:.0f} s left"
            text = f"{self.done} of {self._total} tasks, {self.failed} failed, {left}"
            ends = "\n" if self.done == self._total or not self._live else ""
            print(f"\r\033[K{text}" if self._live else text, end=ends, file=sys.stderr, flush=True)


def solve(client, tasks, kept):
    """Sends chunks to the workers, a few more than they have threads, and keeps what comes back."""
    client.wait_for_workers(1)
    client.upload_file(press.__file__)
    progress, sent = Progress(len(tasks)), {}
    waiting = study.chunks(tasks, threads(client))
    answers = as_completed()

    def send(chunk):
        future = client.submit(press.chunk, chunk, pure=False)
        sent[future] = chunk
        answers.add(future)

    def send_next():
        while len(sent) < 3 * threads(client):
            chunk = next(waiting, None)
            if chunk is None:
                return
            send(chunk)

    send_next()
    for future in answers:
        chunk = sent.pop(future)
        try:
            columns = future.result()
        except KilledWorker as error:
            if len(chunk) > 1:  # one of them ends its process
                for task in chunk:
                    send([task])
                continue
            columns = press.lost(chunk[0], error)
        kept.add(columns)
        failed = {key for key, status in zip(columns["key"], columns["status"]) if status not in press.GOOD}
        progress.add(len(chunk), len(failed))
        send_next()


def threads(client):
    return max(1, sum(client.nthreads().values()))


@contextlib.contextmanager
def client_of(arguments):
    if arguments.scheduler:
        with Client(arguments.scheduler) as client:
            yield client
        return
    workers = arguments.workers or len(os.sched_getaffinity(0))
    dask.config.set(LOCAL)
    with LocalCluster(n_workers=workers, threads_per_worker=1, dashboard_address=":0") as cluster, Client(cluster) as client:
        yield client


def run(arguments):
    tasks, folder, text = study.tasks(arguments.study)
    with store.Store(folder, provenance(text, sys.argv)) as kept:
        done, bad = kept.done()
        todo = [task for task in tasks if task.key not in done or arguments.retry_failed and task.key in bad]
        print(f"{len(tasks)} tasks, {len(tasks) - len(todo)} of them done before, in {folder}", file=sys.stderr)
        if todo:
            with client_of(arguments) as client:
                try:
                    solve(client, todo, kept)
                finally:
                    kept.merge()
        done, bad = kept.done()
        bad &= {task.key for task in tasks}
        print(f"{folder / store.FILE}: {len(tasks)} tasks, {len(bad)} failed")
        return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("study", help="the study's file")
    where = parser.add_mutually_exclusive_group()
    where.add_argument("--workers", type=int, help="processes on this machine; otherwise one for each core")
    where.add_argument("--scheduler", help="address of a running dask scheduler, as tcp://host:8786")
    parser.add_argument("--retry-failed", action="store_true", help="do tasks again that failed before")
    try:
        return run(parser.parse_args())
    except KeyboardInterrupt:
        print("stopped; the same command goes on", file=sys.stderr)
        return 130
    except (study.StudyError, store.StoreError, rc.RoughContactError, OSError, ImportError, RuntimeError) as error:
        print(f"campaign.py: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
