#!/usr/bin/env python3
"""run.py MPIRUN PROGRAM RANKS[xTHREADS]... [-- ARGUMENT...]: runs the program on so many ranks each; fails where one run does, or prints
another text."""
import os
import subprocess
import sys

ENVIRONMENT = {  # Open MPI: more ranks than cores, as any user, and none of them spins
    'OMPI_ALLOW_RUN_AS_ROOT': '1',
    'OMPI_ALLOW_RUN_AS_ROOT_CONFIRM': '1',
    'OMPI_MCA_rmaps_base_oversubscribe': '1',
    'OMPI_MCA_hwloc_base_binding_policy': 'none',
    'PRTE_MCA_rmaps_default_mapping_policy': ':oversubscribe', 'PRTE_MCA_hwloc_default_binding_policy': 'none',
    'OMPI_MCA_mpi_yield_when_idle': '1',
    'OMPI_MCA_btl_vader_single_copy_mechanism': 'none',
    'ASAN_OPTIONS': 'detect_leaks=0',  # there are some in MPI itself
}


def run(mpirun, ranks, command, timeout=1500):
    environment = {**os.environ, **ENVIRONMENT}
    return subprocess.run([mpirun, '-n', str(ranks), *command], env=environment, stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, timeout=timeout)


def main():
    mpirun, program, *runs = sys.argv[1:]
    end = runs.index('--') if '--' in runs else len(runs)
    runs, given = runs[:end], runs[end + 1:]
    first = None
    for each in runs:
        ranks, _, threads = each.partition('x')
        done = run(mpirun, ranks, [program, threads or '1', *given])
        if done.returncode != 0:
            sys.exit(f'{each}: exit status {done.returncode}\n{done.stdout}{done.stderr}')
        if first is None:
            first = done.stdout
            print(first, end='')
        elif done.stdout != first:
            lines = [f'- {a}\n+ {b}' for a, b in zip(first.splitlines(), done.stdout.splitlines()) if a != b]
            sys.exit(f'{each} prints another text than {runs[0]}:\n' + '\n'.join(lines) + done.stderr)
        print(f'{each}: the same')


if __name__ == '__main__':
    main()
