"""The rate at which each pass of haar-cg moves the bytes that it must, beside that of a triad: by Linux' perf, in cold solves of one thread."""
import os
import re
import signal
import subprocess
import sys
import tempfile
import time

import native
from case import checked, in_child
from limits import ColdSolve
from options import listed, question, ranged
from store import Store
from tables import show

WIDE = 8  # bytes of a pressure or a compenetration


def passes_of(real):
    """(pass, functions, bytes a point, times an iteration), docs/performance.md."""
    return (('trees, finest blocks', 'finest_(up|down)', 4 * real + 6, 1),
            ('trees, coarser levels', '(up|down)', 2 * (2 * 20 / 12 + 4), 1),
            ('trees set up', '(finest_)?solve', 3 + 2 * (20 / 12 + 2), 0.5),
            ('new direction', 'turn', 4 * real + 1, 1),
            ('curvature', 'inner', 2 * real, 1),
            ('step and cut', 'advance(_and_cut)?|keep_loads|(sum|scale)_strip', 2 * WIDE + 4.5 * real, 1),
            ('residual, load and merit', 'measure', 3 * real + 2 * WIDE, 0.5),
            ('contact set', 'choose', 10 + real, 0.5))


def sampled(work):
    """{function of the inner loops: share of this process' samples} while it works; also its processor seconds, kernel and interpreter included."""
    with tempfile.TemporaryDirectory() as folder:
        data = os.path.join(folder, 'perf.data')
        recorder = subprocess.Popen(['perf', 'record', '-q', '-F', '1999', '-o', data, '-p', str(os.getpid())], stdout=subprocess.DEVNULL,
                                    stderr=subprocess.DEVNULL)
        time.sleep(0.5)  # until it has begun
        before = time.process_time()
        work()
        seconds = time.process_time() - before
        recorder.send_signal(signal.SIGINT)
        recorder.wait()
        text = subprocess.run(['perf', 'report', '-i', data, '--stdio', '-q', '--no-children', '--sort', 'symbol', '-F', 'period,symbol'],
                              check=True, capture_output=True, text=True).stdout
    found, whole = {}, 0
    for line in text.splitlines():
        match = re.match(r'\s*(\d+)\s+\[.\]\s+(.*)', line)
        if match:
            whole += int(match[1])
            name = re.search(r'::(?:baseline|avx2|avx512)::(\w+)', match[2])
            if name:
                found[name[1]] = found.get(name[1], 0) + int(match[1])
    return {name: count / whole for name, count in found.items()}, seconds


def measured(n, precision, solves, triad):
    solve = ColdSolve(n, 10, 1e-3, 'haar-cg', 'fft')
    options = {'haar-cg.nested': 0, 'haar-cg.products': 'mixed' if precision == 'single' else 'double', 'bounds': 0}
    solve.seconds(1, **options)
    shares, seconds = sampled(lambda: [solve.seconds(1, **options) for _ in range(solves)])
    rows = []
    for name, functions, size, times in passes_of(4 if precision == 'single' else 8):
        share = sum(part for function, part in shares.items() if re.fullmatch(functions, function))
        if share > 0:
            rate = size * n * n * times * solve.result.iterations * solves / (share * seconds) / 1e9
            rows.append({'n': n, 'precision': precision, 'pass': name, 'bytes_per_point': size, 'times': times, 'share_percent': 100 * share,
                         'gigabytes_per_second': rate, 'fraction_of_bandwidth': rate / triad})
    return rows


COLUMNS = ('grid={n}²; precision; pass; bytes/point={bytes_per_point:.0f}; times an iteration={times:g}; share of the solve [%]={share_percent:.1f}; '
           'GB/s={gigabytes_per_second:.1f}; of the triad={fraction_of_bandwidth:.2f}')


def run(request):
    rows, values = [], 1 << 20 if request.quick else 1 << 24
    triad = 24 * values / native.time_triad(values, 1, 1) / 1e9
    try:
        for n in request.sizes:
            for precision in ('single', 'double'):
                rows += checked(in_child(lambda n=n, precision=precision: measured(n, precision, request.solves, triad)))
    except (FileNotFoundError, subprocess.CalledProcessError) as error:
        print(f'passes: perf is not there or may not be used: {error}', file=sys.stderr)
        return
    Store(request.json, 'passes', 1).save(rows=rows, triad_gigabytes_per_second=triad)
    print(f'Cold solves by load to 1e-3 without coarser grids, one thread; the triad moves {triad:.1f} GB/s')
    show(COLUMNS, rows)


question('passes', 'the rate of each pass of haar-cg beside that of the memory, by perf', run, {
    'sizes': (listed(ranged(int, 64, 8192)), [1024, 2048], 'points per side'), 'solves': (ranged(int, 1, 1000), 5, 'of each')},
    {'sizes': [256], 'solves': 3}, '256^2')
