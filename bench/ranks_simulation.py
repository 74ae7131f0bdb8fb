"""Solves on simulated networks. The program runs under SimGrid's SMPI, all its ranks on one core, and each rank writes down the processor's
seconds before each of its exchanges, and what that carries. It does so several times. What a rank does is the same each time, and of each
of its bursts the least seconds count: longer ones are those of other programs. A second program then does the exchanges of all ranks again
on the network, with these seconds in between, for several networks at the same time."""
import json
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from contextlib import ExitStack
from itertools import count

from case import Failure

ROOT = os.path.dirname(os.path.abspath(__file__))
EXACT = ('--cfg=smpi/lat-factor:0:1', '--cfg=smpi/bw-factor:0:1',  # else SMPI has the corrections of another network
         '--cfg=smpi/host-speed:1Gf', '--cfg=smpi/cpu-threshold:0', '--log=root.thres:error')
ENVIRONMENT = {'OMPI_ALLOW_RUN_AS_ROOT': '1', 'OMPI_ALLOW_RUN_AS_ROOT_CONFIRM': '1', 'OMPI_MCA_rmaps_base_oversubscribe': '1',
               'OMPI_MCA_hwloc_base_binding_policy': 'none',
               'PRTE_MCA_rmaps_default_mapping_policy': ':oversubscribe', 'PRTE_MCA_hwloc_default_binding_policy': 'none'}


def program(variable, what):
    found = os.environ.get(variable, '')
    if not found:
        raise Failure(f'this build has no {what}')
    return found


def answer_of(command, limit, **environment):
    """The line of JSON that the program prints, or {'error': text}."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=limit, env={**os.environ, **ENVIRONMENT, **environment}, check=False)
    except subprocess.TimeoutExpired:
        return {'error': f'not finished within {limit:.0f} s'}
    lines = [line for line in done.stdout.splitlines() if line.startswith('{')]
    if done.returncode != 0 or not lines:
        return {'error': (done.stderr.strip().splitlines() or [f'exit code {done.returncode}'])[-1][:300]}
    return json.loads(lines[0])


def smpirun(network, ranks, hosts, *command):
    collectives = ['--cfg=smpi/coll-selector:ompi'] if ranks > 1 else []  # which fails on one
    return [program('RC_BENCH_SMPIRUN', "SimGrid's SMPI"), '-np', str(ranks), '-platform', os.path.join(ROOT, 'platforms', f'{network}.xml'),
            '-hostfile', hosts, *EXACT, *collectives, *command]


def least(records, into):
    """Merges one rank's records. Returns the seconds of all its bursts."""
    seconds = 0.0
    with ExitStack() as stack:
        files = [stack.enter_context(open(record, encoding='utf-8')) for record in records]
        out = stack.enter_context(open(into, 'w', encoding='utf-8'))
        for lines in zip(*files, strict=True):
            if lines[0].startswith('c '):
                burst = min(float(line[2:]) for line in lines)
                seconds += burst
                out.write(f'c {burst:.9f}\n')
            elif any(line != lines[0] for line in lines):
                raise Failure(f'runs of the same ranks differ: {lines[0].strip()} and {lines[-1].strip()}')
            else:
                out.write(lines[0])
    return seconds


def recorded(folder, n, ranks, hosts, runs, limit):
    """Runs without messages, as many as asked for and all that lie in the folder already. The answer of the last, and their folders."""
    solver = program('RC_BENCH_RANK_SIMULATION', "SimGrid's SMPI"), str(n), '1', 'ranks', 'mixed'
    done = []
    for run in count():
        into = os.path.join(folder, f'run {run}')
        finished = os.path.join(into, 'answer.json')  # which an interrupted run lacks
        if not os.path.exists(finished):
            if run >= runs:
                return answer, done
            os.makedirs(into, exist_ok=True)
            answer = answer_of(smpirun('fast', ranks, hosts, *solver), limit, RC_RECORD_TO=into)
            if 'error' in answer:
                return answer, []
            with open(finished, 'w', encoding='utf-8') as out:
                json.dump(answer, out)
        with open(finished, encoding='utf-8') as text:
            answer = json.load(text)
        done.append(into)


def simulated(n, ranks, networks, runs, records, limit):
    """The answer for each network: of the last run, with the seconds on that network. records: a folder that keeps the runs, for this
    library alone; '': none."""
    with tempfile.TemporaryDirectory() as folder:
        kept = os.path.join(records or folder, f'{n}-{ranks}')
        hosts, fewest = os.path.join(folder, 'hosts'), os.path.join(folder, 'least')
        os.makedirs(fewest)
        with open(hosts, 'w', encoding='utf-8') as out:
            out.write(''.join(f'node{k}\n' for k in range(ranks)))
        answer, done = recorded(kept, n, ranks, hosts, runs, limit)
        if not done:
            return dict.fromkeys(networks, answer)
        own = [least([os.path.join(run, str(rank)) for run in done], os.path.join(fewest, str(rank))) for rank in range(ranks)]
        said = {**answer, 'runs': len(done), 'own_seconds': sum(own) / ranks, 'most_own_seconds': max(own)}
        replay = '--cfg=smpi/simulate-computation:no', program('RC_BENCH_RANK_REPLAY', "SimGrid's SMPI"), fewest

        def on(network):
            return {**said, **answer_of(smpirun(network, ranks, hosts, *replay), limit)}
        with ThreadPoolExecutor(os.cpu_count()) as pool:  # no seconds are measured here
            return dict(zip(networks, pool.map(on, networks)))
