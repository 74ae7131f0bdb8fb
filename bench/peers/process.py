"""One run of one code in a process of its own."""
import json
import os
import resource
import subprocess
import sys
import time

HERE = os.path.dirname(os.path.abspath(__file__))
THREAD_VARIABLES = ('OMP_NUM_THREADS', 'OPENBLAS_NUM_THREADS', 'MKL_NUM_THREADS', 'NUMEXPR_NUM_THREADS')
PLANNING = 120  # seconds that FFTW_MEASURE may take for the padded transform, once a grid
START = 20  # seconds for imports and warm-up, beside the limit


def environment(threads):
    known = dict(os.environ, PYTHONDONTWRITEBYTECODE='1')
    known.update({name: str(threads) for name in THREAD_VARIABLES})
    return known


def on_cores(threads):
    """A code that minds no setting has no more cores either."""
    def choose():
        allowed = sorted(os.sched_getaffinity(0))
        if len(allowed) > threads:
            os.sched_setaffinity(0, allowed[:threads])
    return choose


def busy_seconds():
    """Processor time of everything on the machine; None where the system does not tell."""
    try:
        with open('/proc/stat') as stat:
            ticks = [int(word) for word in stat.readline().split()[1:]]
    except (OSError, ValueError):
        return None
    return (sum(ticks[:3]) + sum(ticks[5:8])) / os.sysconf('SC_CLK_TCK')


def children_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run(command, threads, limit, text=''):
    """(standard output, None) or (None, reason), and the share of the machine's time that others took: cores busy with them."""
    busy, own, begun = busy_seconds(), children_seconds(), time.monotonic()
    child = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                             env=environment(threads), preexec_fn=on_cores(threads))
    try:
        output, errors = child.communicate(text, timeout=limit + START)
        reason = None
        if child.returncode < 0:
            reason = f'killed by signal {-child.returncode}'
        elif child.returncode:
            reason = (errors.strip().splitlines() or [f'exit status {child.returncode}'])[-1]
    except subprocess.TimeoutExpired:
        child.kill()
        child.communicate()
        output, reason = None, f'over the limit of {limit:g} s'
    wall = time.monotonic() - begun
    others = None if busy is None else max(0.0, (busy_seconds() - busy - (children_seconds() - own)) / wall)
    return (None if reason else output), reason, others


def solve(code, request, limit):
    """The answers of a run as a list: the standard method gives one for every level it met."""
    if code.family == 'baseline':
        command = [os.path.join(request['build'], 'bin', 'roughcontact-baseline'), '--gap', request['gap'], '--out', request['out'],
                   '--control', request['control'], '--target', repr(request['target']), '--threads', str(request['threads']),
                   '--limit', str(limit), '--planning', str(PLANNING), '--wisdom', os.path.join(os.path.dirname(request['out']), 'wisdom')]
        output, reason, others = run(command, request['threads'], limit + PLANNING)
        if reason:
            return [{'error': reason, 'other_cores': others}]
        whole = json.loads(output)
        # Plans are warm for everyone: measuring them is not this method's set-up.
        shared = {'setup_seconds': whole['setup_seconds'] - whole['planning_seconds'],
                  **{key: whole[key] for key in ('planning_seconds', 'start_bytes', 'cpu_seconds')}}
        answers = [{**entry, **shared} for entry in whole['reached']]
        if len(answers) < 3:
            answers.append({'error': f'over the limit of {limit:g} s'})
        return [{**answer, 'other_cores': others} for answer in answers]
    text = json.dumps({**request, 'family': code.family, 'options': code.options})
    output, reason, others = run([sys.executable, os.path.join(HERE, 'child.py')], request['threads'], limit, text)
    return [{**({'error': reason} if reason else json.loads(output)), 'tol': request['tol'], 'other_cores': others}]
