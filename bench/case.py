"""A case in a process of its own: its peak memory is its own, and its end gives everything back. Clocks and memory of processes."""
import ctypes
import math
import multiprocessing
import os
import resource
import sys
import time

MOST_REPEATS = 20
FORK = multiprocessing.get_context('fork')


class Failure(Exception):
    """Something that cannot be measured; the message says why."""


def plain(value):
    """What JSON can hold: NumPy's numbers as Python's, those that are not finite as null."""
    if isinstance(value, dict):
        return {key: plain(each) for key, each in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(each) for each in value]
    if hasattr(value, 'tolist'):
        return plain(value.tolist())
    return None if isinstance(value, float) and not math.isfinite(value) else value


def in_child(work, limit=None, cores=None):
    """What work() returns, as JSON holds it, or {'error': text} if it raises, the process dies or takes more than `limit` seconds.
    cores: how many it may use at most."""
    sys.stdout.flush()
    sys.stderr.flush()
    ctypes.CDLL(None).malloc_trim(0)  # so that the memory of a case counts and is not taken from what an earlier one left
    answers, ours = FORK.Pipe(duplex=False)
    child = FORK.Process(target=run_child, args=(work, ours, cores))
    child.start()
    ours.close()
    try:
        if answers.poll(limit):
            return answers.recv()
        child.kill()
        return {'error': 'over the limit'}
    except EOFError:
        return {'error': 'the process died'}
    finally:
        child.join()


def run_child(work, answers, cores):
    allowed = sorted(os.sched_getaffinity(0))
    if cores and len(allowed) > cores:
        os.sched_setaffinity(0, allowed[:cores])
    os.dup2(2, 1)  # what is printed here is no answer
    try:
        answers.send(plain(work()))
    except Exception as error:  # whatever it is, the measurements go on
        answers.send({'error': str(error) or type(error).__name__, **({'missing': True} if isinstance(error, ImportError) else {})})
    os._exit(0)  # without the end of libraries, which may wait for threads that are not here


def checked(answer):
    if isinstance(answer, dict) and 'error' in answer:
        raise Failure(answer['error'])
    return answer


def peak_memory():
    """Largest resident memory of this process so far [bytes]."""
    return 1024 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def status_line(file, name):
    with open(file) as lines:
        return next((1024 * int(line.split()[1]) for line in lines if line.startswith(name + ':')), None)


def resident_memory():
    return status_line('/proc/self/status', 'VmRSS')


def interpreter_memory():
    """What a child process has before anything is made [bytes]: no part of what the library needs."""
    return in_child(resident_memory)


def available_memory():
    return status_line('/proc/meminfo', 'MemAvailable') or math.inf


def limit_growth(more):
    """Refuses this process more than so many further bytes."""
    resource.setrlimit(resource.RLIMIT_AS, (status_line('/proc/self/status', 'VmSize') + int(more), resource.RLIM_INFINITY))


def cpu_seconds(of=resource.RUSAGE_SELF):
    """Processor time of all threads of this process, or of its children."""
    usage = resource.getrusage(of)
    return usage.ru_utime + usage.ru_stime


def repeats(call, budget, most=MOST_REPEATS):
    """What call() returned, once at least and until `budget` seconds are spent."""
    begun, found = time.perf_counter(), []
    while not found or (len(found) < most and time.perf_counter() - begun < budget):
        found.append(call())
    return found


class Progress:
    """How far a plan is, on standard error; `total` is in any unit of cost."""

    def __init__(self, total):
        self.total, self.spent, self.begun = total or 1, 0, time.monotonic()
        self.last = self.begun

    def done(self, name, cost=1):
        self.spent += cost
        seconds, self.last = time.monotonic() - self.last, time.monotonic()
        share = self.spent / self.total
        left = (time.monotonic() - self.begun) * (1 - share) / share if share else 0
        print(f'{100 * share:3.0f} %  {name}  {seconds:.1f} s, {left / 60:.0f} min left', file=sys.stderr, flush=True)
