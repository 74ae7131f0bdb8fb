#!/usr/bin/env python3
"""Solves one problem with one code: a JSON request comes on standard input, a JSON answer goes to standard output, the pressures to
the file that the request names. A process of its own, so that its peak memory is this code's."""
import importlib
import json
import os
import sys
import time

import numpy as np

RUNNERS = {'ours': 'run_ours', 'aspher': 'run_aspher', 'tamaas': 'run_tamaas', 'contactmechanics': 'run_contactmechanics',
           'nnls': 'run_nnls', 'osqp': 'run_osqp'}


TWICE = 5  # seconds: faster solves are done again in the same process


def memory(name):
    with open('/proc/self/status') as status:
        for line in status:
            if line.startswith(name + ':'):
                return 1024 * int(line.split()[1])


def forget_peak():
    """The peak counts from here; where that is not allowed, from the start of the process."""
    try:
        with open('/proc/self/clear_refs', 'w') as file:
            file.write('5')
    except OSError:
        pass


def timed(runner, request, gap):
    """One cold solve, set-up included."""
    begun = time.perf_counter()
    code = runner.Code(request, gap)
    ready = time.perf_counter()
    pressure = code.solve()
    done = time.perf_counter()
    inside = code.setup_inside()  # set-up that the code does within its solving call
    return {'setup_seconds': ready - begun + inside, 'solve_seconds': done - ready - inside}, pressure, code


def main():
    request = json.load(sys.stdin)
    answers = os.dup(1)
    os.dup2(2, 1)  # what a code prints is not the answer
    runner = importlib.import_module(RUNNERS[request['family']])
    runner.warm_up(request)
    forget_peak()
    start, cpu_start = memory('VmHWM'), time.process_time()
    gap = np.load(request['gap'])
    seconds, pressure, code = timed(runner, request, gap)
    peak, cpu = memory('VmHWM'), time.process_time() - cpu_start
    if sum(seconds.values()) < TWICE:  # plans and caches are warm for everyone
        del pressure, code
        seconds, pressure, code = timed(runner, request, np.load(request['gap']))  # a code may work in the gap it is given
    np.save(request['out'], np.asarray(pressure, dtype=np.float64).reshape(gap.shape))
    answer = {'version': runner.version(request), **seconds, 'cpu_seconds': cpu, 'start_bytes': start, 'peak_bytes': peak,
              'file': request['out'], **code.details()}
    os.write(answers, json.dumps(answer).encode())


if __name__ == '__main__':
    main()
