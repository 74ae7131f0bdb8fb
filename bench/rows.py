"""What the library is measured by, each row with its goal. Against itself, in processor time of one thread: a dense solve over its products,
products by size, small grids, Gauss points, batches, histories, odd scenes. With all threads: large grids and their memory, ASPHER."""
import os
import re
import subprocess
import sys
import tempfile

import numpy as np
import roughcontact as rc
from roughcontact import raw

import counts
import mapped
import native
from case import checked, cpu_seconds, in_child, interpreter_memory
from contact import certified, find_load, unit_square
from histories import ROUGH
from limits import ColdSolve
from options import THREADS, folder, listed, one_of, percent, question, ranged, side
from performance import against
from samples import median
from scaling import SLOPE, light_load
from store import Store, load
from surfaces import below_highest, self_affine_gap
from tables import show

DOUBLE = 3  # products of a solve that are in double precision: two residuals and the certificate's
GAUSS = 64
SMALL = 10  # solves for each repeat: they are short
TITLES = ('dense', 'products', 'small', 'gauss', 'batch', 'history', 'odd', 'large', 'peers')
PEERS = ('ours', 'ours-float', 'aspher-periodic', 'aspher-h2-float')
REMARK = ('Times of one thread are processor times, the least of several runs; those of large grids and of ASPHER are by the clock, with all threads. '
          'Other work on the machine lengthens both.')


def least(call, repeats):
    """Least processor time of a call [s]."""
    found = []
    for _ in range(repeats):
        before = cpu_seconds()
        call()
        found.append(cpu_seconds() - before)
    return min(found)


def dense(request):
    for n in request.sizes:
        def work(n=n):
            solve = ColdSolve(n, 10, 1e-8)
            solve.seconds(1)
            cpu = least(lambda: solve.seconds(1), request.repeats)
            single, double = (native.time_products(unit_square(n), solve.gap, solve.result.approach, 'fft', single=kind)['best'] for kind in (True, False))
            products = solve.result.products
            return {'value': cpu / (single * (products - DOUBLE) + double * DOUBLE), 'more': f'{1e3 * cpu:.0f} ms, {products} products'}
        yield {'row': f'dense {n}², 10 %: solve over its products', 'goal': '1.5', **checked(in_child(work))}


def small(request):
    """A cold solve by the C functions; the call from Python with its options besides."""
    for n, goal in ((32, '0.5'), (64, '1.2'), (128, '5')):
        def work(n=n):
            solve, inside = ColdSolve(n, 10, 1e-8), []

            def call():
                solve.seconds(1)
                inside.append(solve.cpu)
            whole = least(call, 1 + SMALL * request.repeats)
            return [1e3 * inside[0], 1e3 * min(inside[1:]), 1e3 * whole]
        runs = [checked(in_child(work)) for _ in range(request.repeats)]
        first, second, whole = (median(each) for each in zip(*runs))
        yield {'row': f'{n}², 10 %: second solve [ms]', 'goal': goal, 'value': second, 'more': f'from Python {whole:.2f} ms'}
        yield {'row': f'{n}², 10 %: first solve of a process, over the second [ms]', 'goal': '2', 'value': first - second}


def gauss(request):
    """Trials a thousandth of the load or depth apart, as a finite element program asks for them, by the C function itself."""
    library = raw.contact_library()
    gap = self_affine_gap(GAUSS, rms_slope=SLOPE)
    for percent, goal in ((1, '25'), (10, '120')):
        load = find_load(unit_square(GAUSS), gap, percent / 100, light_load(percent / 100), 6, {'threads': 1}).load
        for control in ('approach', 'load'):
            with rc.Contact(unit_square(GAUSS), options={'threads': 1, 'tol': 1e-8, 'bounds': 0}) as contact:
                result = certified(contact.solve(undeformed_gap=gap, load=load))
                target, change = (load, 1e-3 * load) if control == 'load' else (result.approach, 1e-3 * (result.approach - gap.min()))
                counts, step, answer = [], raw.rc_step(), raw.rc_result()
                step.control = raw.RC_CONTROL_LOAD if control == 'load' else raw.RC_CONTROL_APPROACH

                def trials():
                    for k in range(request.trials):
                        step.target = target + change * (k % 20)
                        if library.rc_contact_solve(handle, step, answer) != 0:
                            raise RuntimeError(library.rc_last_error().decode())
                        counts.append(answer.products)
                with contact._holding() as handle:
                    seconds = least(trials, request.repeats) / request.trials
            yield {'row': f'Gauss point {GAUSS}², {percent} %, {control}: next trial [us]', 'goal': goal, 'value': 1e6 * seconds,
                   'more': f'{np.mean(counts):.1f} products'}


def batch(request):
    gaps = np.stack([below_highest(ROUGH.heights(128, seed)) for seed in range(1, request.surfaces + 1)])
    targets = 0.5 * gaps.mean(axis=(1, 2))[:, None] * np.arange(1, 11) / 10
    options = {'threads': 1, 'tol': 1e-8, 'solver': 'haar-cg', 'backend': 'fft'}
    found = []
    cpu = least(lambda: found.append(rc.batch(undeformed_gap=gaps, system=unit_square(128), options=options, approach=targets)), request.repeats)
    products = int(np.maximum(found[0].products, 0).sum()) / targets.size
    yield {'row': 'batch 128², 10 steps: solves per CPU second', 'goal': '2000', 'value': targets.size / cpu, 'more': f'{products:.1f} products a solve'}


def history(request):
    for n in request.histories:
        gap = self_affine_gap(n, rms_slope=SLOPE)
        gap -= gap.min()
        for boundary, control in ((b, c) for b in ('free', 'periodic') for c in ('approach', 'load')):
            targets = gap.mean() / 2 * np.arange(1, 21) / 20

            def steps(warm, targets, control):
                counts, before = [], cpu_seconds()
                with rc.Contact(unit_square(n, boundary), options={'threads': 1, 'tol': 1e-8, 'bounds': 0}) as contact:
                    for k, target in enumerate(targets):
                        result = certified(contact.solve(undeformed_gap=None if warm and k else gap, warm_start=warm, want_pressure=False,
                                                         **{control: target}))
                        counts.append(result.products)
                        if not warm:
                            contact.reset()
                return counts, cpu_seconds() - before, result.load

            if control == 'load':
                targets = steps(True, targets[-1:], 'approach')[2] * np.arange(1, 21) / 20
            (cold, cold_cpu, _), (warm, warm_cpu, _) = steps(False, targets, control), steps(True, targets, control)
            yield {'row': f'history of 20 steps, {n}², {boundary}, {control}: warm over cold products', 'goal': '0.5', 'value': sum(warm) / sum(cold),
                   'more': f'CPU {warm_cpu / cold_cpu:.2f}; {sum(w > c for w, c in zip(warm, cold))} steps take more, {max(w - c for w, c in zip(warm, cold))} at most'}


def products(request):
    for n in request.counted:
        for boundary in ('free', 'periodic'):
            found = {share: checked(in_child(lambda: counts.measure(request, n, boundary, share / 100))) for share in (1, 10, 40)}
            for control in ('approach', 'load'):
                each = {share: next(row['products'] for row in same if row['control'] == control) for share, same in found.items()}
                yield {'row': f'{n}², {boundary}, {control}: most products to 1e-8', 'goal': '26', 'value': max(each.values()),
                       'more': ', '.join(f'{share} %: {count}' for share, count in each.items())}


def odd(request):
    program = os.path.join(os.environ['RC_BENCH_BUILD'], 'bin', 'test_odd_scenes')
    if not os.path.exists(program):
        yield {'row': 'odd scenes: above 1.5 times polonsky-keer', 'goal': '0', 'more': 'not built: the target test_odd_scenes'}
        return
    said = subprocess.run([program], capture_output=True, text=True, env={**os.environ, 'RC_TEST_QUICK': '1'}).stdout
    scenes, most, above, astray = (int(re.search(pattern, said)[1]) for pattern in (r'(\d+) scenes:', r'most (\d+)', r'(\d+) scenes above', r'; (\d+) scenes above'))
    yield {'row': 'odd scenes: above 1.5 times polonsky-keer', 'goal': '0', 'value': astray, 'more': f'of {scenes}'}
    yield {'row': 'odd scenes: most products', 'goal': '600', 'value': most, 'more': f'{above} above it'}


def large(request):
    """Load control, single precision, certified 1e-4, in floats. First a dense contact, whose pressures are asked for, then mapped files."""
    interpreter = interpreter_memory()
    for n, share, time, memory in zip(request.large, request.large_percents, ('75', '12', ''), ('12', '12', '20')):
        dense = share >= 1
        with tempfile.TemporaryDirectory(dir=request.folder) as place:
            file = os.path.join(place, 'gap.f32')

            def write():
                if not dense:
                    return mapped.write_gap(file, n)
                gap = self_affine_gap(n, rms_slope=SLOPE)
                gap -= gap.min()
                gap.astype(np.float32).tofile(file)
                return SLOPE / n
            slope = checked(in_child(write))
            found = checked(in_child(lambda: mapped.solve(file, n, slope, share / 100, THREADS, interpreter, want_pressure=dense)))
        row = f'{n}², {share:g} %, single, 1e-4'
        more = f'{found["contact_percent"]:.3g} %, {found["products"]} products, CPU {found["cpu_seconds"]:.3g} s, {found["status"]}'
        yield {'row': row + ' [s]', 'goal': time, 'value': found['seconds'], 'more': more}
        yield {'row': row + ': memory in all [GB]', 'goal': memory, 'value': found['peak_gigabytes']}


def peers(request):
    """Where both are certified at the tightest level that both reach, the second solve of a process."""
    with tempfile.TemporaryDirectory(dir=request.folder) as place:
        for sizes, shares in ((request.against, request.against_percents), ([n for n in request.against if n <= 1024], [50])):
            if not sizes or not shares:
                continue
            subprocess.run([os.path.join(os.environ['RC_BENCH_BUILD'], 'bin', 'roughcontact-bench'), 'peers', '--only', ','.join(PEERS),
                            '--sizes', ','.join(map(str, sizes)), '--percents', ','.join(f'{share:g}' for share in shares), '--repeats', '2',
                            '--threads', str(THREADS), '--json', os.path.join(place, 'peers.json')], check=True, stdout=sys.stderr)
        document = load(place, 'peers')
    for code, surface, words in (('aspher-periodic', 'wavy', 'periodic'), ('aspher-h2-float', 'rough', 'free, h2, single')):
        for each in against(document, code, surface, 'load'):
            share, periodic = each.case['percent'], code == 'aspher-periodic'
            goal = ('5' if share <= 1 else '8') if periodic else ('7' if share <= 1 else '')
            row = f'ASPHER, {words}, {each.label.replace(" load,", ",")}'
            yield {'row': row + ': times slower', 'goal': goal, 'value': each.ratio, 'more': f'{1e3 * each.ours:.0f} ms, {1e3 * each.theirs:.0f} ms'}
            if share >= 10 and not np.isnan(each.memory):
                yield {'row': row + ': our memory over theirs', 'goal': '0.5', 'value': each.memory}


def run(request):
    store, rows = Store(request.json, 'rows', 1), []
    for name in request.rows:
        for row in globals()[name](request):
            rows.append(row)
            print(row['row'], file=sys.stderr)
    store.save(rows=rows)
    show('row; measured={value:.3g}; goal; more', rows)
    print(REMARK)


SHARES = listed(percent)
question('rows', 'what the library is measured by, each row with its goal', run, {
    'rows': (listed(one_of(*TITLES)), list(TITLES), 'which'), 'sizes': (listed(side), [1024, 2048, 4096], 'points per side of dense solves'),
    'counted': (listed(side), [512, 1024, 2048], 'points per side where products are counted'),
    'histories': (listed(side), [256, 512, 1024], 'points per side of histories'), 'surfaces': (ranged(int, 1, 1000), 40, 'of the batch'),
    'trials': (ranged(int, 1, 100000), 200, 'of a Gauss point in a row'),
    'large': (listed(ranged(int, 256, 131072)), [16384, 32768, 65536], 'points per side of large grids'),
    'large_percents': (SHARES, [10, 0.04, 0.02], 'contact area of each, in percent of the grid'),
    'against': (listed(side), [512, 1024], 'points per side against ASPHER'),
    'against_percents': (SHARES, [0.1, 1, 10], 'contact areas there'), 'seed': (int, 1, 'of the surfaces'), 'tol': (float, 1e-8, 'of products'),
    'folder': (folder, tempfile.gettempdir(), 'where large gaps are written'), 'threads': (ranged(int, 1, 1024), 1, 'for products'),
    'repeats': (ranged(int, 1, 1000), 5, 'runs of which the least counts')},
    {'rows': [name for name in TITLES if name not in ('odd', 'peers')], 'sizes': [128], 'counted': [128], 'histories': [64], 'surfaces': 4,
     'trials': 20, 'large': [512], 'large_percents': [10], 'repeats': 1}, 'small sizes, one run each')
