"""device.py [BUILD]: on a machine with a CUDA device, in less than ten minutes: builds, measures solves, batches and passes, and writes
bench/results/device.json and the tables of docs/development/device.md. Exit status 77 if there is no device: nothing is written
then. It needs Python with NumPy, nvcc, cuFFT and cmake; FFTW for the times on two threads of the host, which are left out without it.
RC_DEVICE_SECONDS: time limit of the whole run (540). RC_DEVICE_READY=1: does not build; BUILD has the programs. RC_DEVICE_COMMIT: the commit, if
this folder is no git repository.
RC_DEVICE_PAIR="haar-cuda-host cuda-host" RC_DEVICE_PASSES=device_passes_host RC_DEVICE_SHORT=1: the same steps on the host, on small grids, for
tests; nothing is written but to RC_DEVICE_OUTPUT."""
import ctypes
import json
import math
import os
import subprocess
import sys
import time

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
SETTING, SHORT, CORES = os.environ.get, 'RC_DEVICE_SHORT' in os.environ, os.cpu_count()
BUILD = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else os.path.join(ROOT, 'build-device'))
os.environ.setdefault('ROUGHCONTACT_LIBRARY', os.path.join(BUILD, 'lib', 'libroughcontact.so'))
sys.path.insert(1, os.path.join(ROOT, 'bindings', 'python'))

import roughcontact as rc  # after its place is known
from roughcontact._arrays import given
from roughcontact.context import OptionSet

from case import in_child
from contact import unit_square
from json_tables import lines, rounded
from tables import fill, records

MODULUS = 1 << 64
SOLVES = ('grid={n}²; control; tol={tol:g}; status; products; first solve [s]={first_seconds:.3g}; next solves [s]={seconds:.3g}; '
          'two threads [s]={host}; times faster={faster}')
BATCHES = ('contacts of 64²={batch}; solver, backend, threads={solver}, {backend}, {threads}; certified; first batch [s]={first_seconds:.3g}; '
           'solves a second={solves_per_second:.4g}')


def built():
    """The backend of the host for comparison, '' without FFTW."""
    fft = 'fft' if subprocess.run(['pkg-config', '--exists', 'fftw3', 'fftw3f'], check=False).returncode == 0 else ''
    architecture = SETTING('RC_DEVICE_ARCHITECTURE') or asked('compute_cap').replace('.', '') or 'native'
    os.environ['PATH'] += ':/usr/local/cuda/bin'
    without = [f'-DRC_BUILD_{part}=OFF' for part in ('TESTS', 'EXAMPLES', 'TOOLS', 'FORMATS', 'BENCH', 'SURFACE')]
    for command in (['cmake', '-S', ROOT, '-B', BUILD, '-DCMAKE_BUILD_TYPE=Release', '-DRC_CUDA=ON', f'-DRC_CUDA_ARCHITECTURES={architecture}', *without,
                     '-DRC_BUILD_DEVICE_BENCH=ON', '-DRC_BUILTIN_BACKENDS=', f'-DRC_MODULE_BACKENDS={fft}'],
                    ['cmake', '--build', BUILD, '-j', str(CORES), '--target', 'roughcontact', *(['rcb_fft'] if fft else []), 'rcb_cuda', 'device_passes']):
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    return fft


def said(*command):
    """The first line that a program prints; '' if it fails or is not there."""
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True).stdout.splitlines()[0]
    except (OSError, subprocess.CalledProcessError):
        return ''


def asked(what):
    """What the driver says of the first device; '' without one."""
    return said('nvidia-smi', f'--query-gpu={what}', '--format=csv,noheader,nounits')


def waves(n, seed):
    """(kx, ky, phase, amplitude) of waves of 2 cycles to n/8 along the side, with heights that fall as a self-affine surface's of Hurst exponent
    0.8."""
    found, k = [], 2.0
    while k <= n / 8:
        for _ in range(3):
            turns = []
            for _ in range(2):
                seed = (seed * 6364136223846793005 + 1442695040888963407) % MODULUS
                turns.append(math.pi * (seed >> 11) * 2.0**-53)
            found.append((round(k * math.cos(turns[0])), round(k * math.sin(turns[0])), 2 * turns[1], k**-0.8))
        k *= 1.3
    return np.array(found).T


def gap_of(n, seed):
    """The gap over the unit square, and a load that brings about a tenth of it into contact, for contact modulus 1."""
    kx, ky, phase, amplitude = waves(n, seed)
    turn = 2 * math.pi * np.arange(n) / n
    along, across = np.outer(kx, turn) + phase[:, None], np.outer(turn, ky)
    gap = np.hstack([amplitude * np.cos(across), -amplitude * np.sin(across)]) @ np.vstack([np.cos(along), np.sin(along)])
    gap -= gap.min()
    return gap, 0.05 * math.sqrt(np.sum(2 * (math.pi * amplitude)**2 * (kx**2 + ky**2)))


def solve(n, control, tol, solver, backend, threads, runs):
    """Cold solves; of those under an approach it is that of the load."""
    gap, load = gap_of(n, 1)
    pressure, step, result, times = np.zeros_like(gap), rc.raw.rc_step(), rc.raw.rc_result(), []
    step.control, step.target, step.borrow, step.warm_start = rc.raw.RC_CONTROL_LOAD, load, 1, 0
    step.undeformed_gap.data, result.p.data = gap.ctypes.data, pressure.ctypes.data
    options = {'solver': solver, 'backend': backend, 'threads': threads, 'tol': tol}
    with rc.Contact(unit_square(n), options=options) as contact, contact._holding() as handle:
        for run in range(runs + (control == 'approach')):
            begun = time.perf_counter()
            if rc.raw.contact_library().rc_contact_solve(handle, step, result) < 0:
                raise RuntimeError(rc.raw.contact_library().rc_last_error().decode())
            times.append(time.perf_counter() - begun)
            if control == 'approach' and run == 0:
                step.control, step.target = rc.raw.RC_CONTROL_APPROACH, result.approach
    return {'n': n, 'control': control, 'tol': tol, 'backend': backend, 'status': 'RC_' + rc.Status(result.status).name, 'products': result.products,
            'first_seconds': times[0], 'seconds': min(times[1:] or times)}


def solve_batch(count, solver, backend, threads):
    gaps = np.empty((count, 64, 64))
    for k in range(count):
        gaps[k] = gap_of(64, k + 1)[0] if k < 64 else gaps[k % 64]
    targets, pressures, certificates, times = np.full((count, 1), gap_of(64, 1)[1]), np.zeros_like(gaps), np.zeros((count, 1)), []
    batch = given(rc.raw.rc_batch(), control=rc.raw.RC_CONTROL_LOAD, n=count, steps=1, targets=targets, undeformed_gap=gaps, p=pressures,
                  certificate=certificates)
    system, _ = unit_square(64).struct()
    with OptionSet({'solver': solver, 'backend': backend, 'threads': threads, 'tol': 1e-8}, None) as options:
        for _ in range(4):  # the first one sets the device up
            begun = time.perf_counter()
            if rc.raw.contact_library().rc_batch_solve(system, options, batch) < 0:
                raise RuntimeError(rc.raw.contact_library().rc_last_error().decode())
            times.append(time.perf_counter() - begun)
    return {'batch': count, 'solver': solver, 'backend': backend, 'threads': threads, 'certified': batch.certified, 'first_seconds': times[0],
            'solves_per_second': count / min(times[1:])}


def text_of(result):
    beside = {(row['n'], row['control'], row['tol']): row['seconds'] for row in result['solves'] if row['backend'] == 'fft'}
    rows = [{**row, 'host': beside.get((row['n'], row['control'], row['tol']))} for row in result['solves'] if row['backend'] != 'fft']
    for row in rows:
        row.update(faster=f'{row["host"] / row["seconds"]:.3g}' if row['host'] else '', host=f'{row["host"]:.3g}' if row['host'] else 'not measured')
    passes = [{**row, 'rate': row['bytes'] / row['seconds']} for row in result.get('passes', [])]
    copy = next((row['rate'] for row in passes if row['pass'] == 'copy'), None)
    columns = f'pass over {result.get("n")}² cells={{pass}}; seconds={{seconds:.3g}}; bytes a second={{rate:.3g}}; share of a copy\'s={{share:.2f}}'
    return '\n\n'.join([f'Measured by `bench/device.py` on {result["device"]}, commit {result["commit"]}; transfers and the certificate are included, '
                        'set-up is in the first solve.', records(SOLVES, rows), records(BATCHES, result['batches']),
                        records(columns, [{**row, 'share': row['rate'] / copy} for row in passes]) if copy else '',
                        *(f'Not measured: {row["what"]}: {row["error"]}.' for row in result['missing'])]).rstrip()


def main():
    ends, fft = time.monotonic() + float(SETTING('RC_DEVICE_SECONDS', '540')), 'fft' if SHORT or 'RC_DEVICE_READY' in os.environ else built()
    pair, passes = SETTING('RC_DEVICE_PAIR', 'haar-cuda cuda').split(), os.path.join(BUILD, 'bin', SETTING('RC_DEVICE_PASSES', 'device_passes'))
    first = subprocess.run([passes, '64'], stdout=subprocess.DEVNULL, check=False).returncode
    if first:
        sys.exit(print('bench/device.py: no device answers; nothing is measured', file=sys.stderr) or first)
    memory = float(asked('memory.total') or 0)  # MiB
    largest, sizes, large, count, few, teams = (64, (128,), ((160, 1e-4),), 20, 20, (2,)) if SHORT else (
        8192, (1024, 4096), ((16384, 1e-4), (32768, 1e-8))[:1 + (memory > 130000)], 20000, 2000, (1, 2, 4, CORES))
    rows = {'solves': [], 'batches': [], 'missing': []}

    def run(kind, limit, work, *arguments):
        answer = in_child(lambda: work(*arguments), max(min(limit, ends - time.monotonic()), 1))
        what = f'{work.__name__} {" ".join(map(str, arguments))}'
        rows['missing' if 'error' in answer else kind].append({'what': what, **answer} if 'error' in answer else answer)
        print(what, answer, flush=True)
    for n in sizes:
        for control in ('load', 'approach'):
            run('solves', 60, solve, n, control, 1e-8, *pair, CORES, 5)
            if fft:
                run('solves', 90, solve, n, control, 1e-8, 'haar-cg', fft, 2, 2)
    for threads in teams:
        run('batches', 60, solve_batch, count, *pair, threads)
    if fft:
        run('batches', 60, solve_batch, few, 'haar-cg', fft, 2)
    measured = in_child(lambda: json.loads(subprocess.run([passes, str(largest)], capture_output=True, check=True).stdout), 60)
    if 'error' in measured:
        rows['missing'].append({'what': f'passes {largest}', 'error': measured['error']})
    for n, tol in large:
        run('solves', 200, solve, n, 'load', tol, *pair, CORES, 2)
    device = asked('name,driver_version,memory.total')
    commit = SETTING('RC_DEVICE_COMMIT') or said('git', '-C', ROOT, 'describe', '--always', '--dirty', '--abbrev=12', '--exclude=*') or 'unknown'
    result = {'benchmark': 'device', 'date': time.strftime('%Y-%m-%dT%H:%M:%SZ', time.gmtime()), 'commit': commit,
              'device': f'{device} MiB' if device else 'host', **rows, **({} if 'error' in measured else measured)}
    with open(SETTING('RC_DEVICE_OUTPUT') or os.path.join(ROOT, 'bench', 'results', 'device.json'), 'w', encoding='utf-8') as out:
        out.write(lines(rounded(result)))
    if 'RC_DEVICE_OUTPUT' not in os.environ:
        fill(os.path.join(ROOT, 'docs', 'development', 'device.md'), {'measured': text_of(result)})
    print(text_of(result))


if __name__ == '__main__':
    main()
