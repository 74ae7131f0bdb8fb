"""`documents PAGE --quick` on nothing measured before: answers that are certified and agree with what is known, a page that is filled, pictures
that are drawn; a second call measures nothing anew. The second argument names the page: performance, paper, pareto (speed-accuracy), physics,
published."""
import math
import os
import sys

from program import BUILD, check_pictures, counts, load, remade, run

from paper_tables import INDEPENDENT, SECTIONS, measured as rows
from samples import median, median_interval, rows_of, values_of
from speed_accuracy_tables import FAST, cases, enough, front, grid_error, grids, lines, time_to

CERTIFIED = 1e-7  # of loads, a few times the tolerance


def close(value, wanted, tolerance):
    assert abs(value - wanted) <= tolerance, (value, wanted, tolerance)


def performance(folder):
    first, filled = remade('performance')
    assert 'measured before' not in first, first
    for name in ('scaling', 'batch', 'mapped'):
        assert filled[name].startswith('|') and 'Not measured' not in filled[name], name
    assert filled['scaling-single'].startswith('Not measured yet'), filled
    # Every row by load once.
    assert filled['scaling'].count('²') == 4, filled['scaling']
    assert run('documents', 'performance', '--quick').count('measured before') == 8 + 3


def paper(folder):
    first, filled = remade('paper')
    count, failed, before = counts(first)
    assert count > 100 and failed == 0 and before == 0, first
    document = load(folder, 'paper')

    # Example 1: within the independent program's interval, widened by the sampling error of few draws.
    found = {row['n']: row for row in rows(document, 'example_1', kernel='eq9', spacing=1)}
    for n in (25, 100, 400):
        share, half = (value / 100 for value in INDEPENDENT[n])
        close(found[n]['share'], share, math.hypot(half, 1.96 * math.sqrt(share * (1 - share) / found[n]['draws'])))
    for row in rows(document, 'example_1'):
        assert row['dishonest'] == 0, row
        assert row['failures'] == 0 or (row['kernel'], row['spacing']) == ('eq9', 1), row
    row = rows(document, 'figure_2')[0]
    assert row['status'] == 'RC_UNCERTIFIED' and min(row['w']) < -1e-6 and min(row['exact']) == 0, row
    # Smooth shapes: greedy elimination is right there, and Hertz's load comes out as far as the kernel lets it.
    for row in rows(document, 'smooth'):
        assert row['kernel'] == 'eq9' or row['failures'] == 0, row
        if 'load_error' in row:
            close(row['load_error'], 0, 0.002 if row['kernel'] == 'love' else 0.03)

    for row in rows(document, 'figure_4'):
        assert row['status'] == 'RC_OK' or row['method'] == 'greedy CG', row
    for setting in ('small', 'small, love', 'dense', 'fft'):
        forces = [row['steps']['mean_pressure'][-1] for row in rows(document, 'figure_4', setting=setting, seed=1) if row['status'] == 'RC_OK']
        assert len(forces) >= 6 and max(forces) / min(forces) - 1 < 1e-6, forces
    assert {row['inner'] for row in rows(document, 'figure_5')} == {'cg', 'cholesky', 'gauss-seidel'}
    for row in rows(document, 'figure_6'):
        assert row['solves'] > 0, row

    lost = {h: median([abs(row['load_error']) for row in rows(document, 'figure_8', hurst=h, backend='fft', kernel='eq9')])
            for h in values_of(rows(document, 'figure_8'), 'hurst')}
    assert lost[0.3] > lost[0.6] > lost[0.9], lost
    for row in rows(document, 'figure_8'):
        assert abs(row['certified_error']) < CERTIFIED and row['load_error'] < CERTIFIED, row
        assert 0 < row['kept'] <= row['diagonal']['kept'] <= 1, row
    for row in rows(document, 'figure_9'):
        kept = [entry['kept'] for entry in row['radii']]
        assert kept == sorted(kept) and all(abs(entry['certified_error']) < CERTIFIED for entry in row['radii']), row
    surfaces = {row['surface']: row for row in rows(document, 'figure_10')}
    power_law = surfaces['generated, power law']
    close(power_law['hurst'], 0.6, 0.15)
    for part in (2, 5):
        plain = [[abs(case['load_error']) for case in surfaces[name]['cases'] if case['part'] == part] for name in
                 ('generated, power law', 'generated, roll-off')]
        assert max(plain[0]) < max(plain[1]), plain
    for row in surfaces.values():
        assert all(abs(case['certified_error']) < CERTIFIED for case in row['cases']), row

    # Order statistics: 20 values leave five out at either end.
    assert median_interval(range(1, 21)) == (10.5, 6, 15) and median_interval([1, 2, 4]) == (2, 1, 4)

    assert set(filled) == {'provenance', 'claims', *SECTIONS}, filled.keys()
    for name, text in filled.items():
        assert text.strip() and 'ot measured yet' not in text and 'nan' not in text, (name, text)
    check_pictures(folder, *(f'paper-figure-{number}' for number in (2, 4, 5, 6, 8, 9, 10)))
    assert counts(run('documents', 'paper', '--quick')) == [0, 0, count]


def check_front():
    assert front([(3, 1e-3), (1, 1e-1), (2, 1e-1), (4, 1e-2), (5, 1e-9)]) == [(1, 1e-1), (3, 1e-3), (5, 1e-9)]
    points = [{'tol': 1e-2, 'a': 1e-5, 'b': 1e-1, 'seconds': 2}, {'tol': 1e-4, 'a': 1e-5, 'b': 1e-4, 'seconds': 3},
              {'tol': 1e-6, 'a': 1e-9, 'b': 1e-6, 'seconds': 4}]
    assert enough(points, {'a': 1e-4, 'b': 1e-3}) == 1e-4 and enough(points, {'a': 1e-4, 'b': 1e-9}) is None
    assert time_to(points, 1e-4, 'b') == 3 and time_to(points, 1e-8, 'b') is None


def check_case(document, case):
    known = lines(document, case)
    assert {'auto', FAST, 'haar-cg, fft, double', 'haar-cg, fft, single', 'haar-cg, split', 'polonsky-keer, fft', 'nnls, fft', 'nnls, dense',
            'gp, fft', 'admm, fft', 'greedy, fft', 'cmr, fft'} <= known.keys(), known.keys()
    assert case['certified_residual'] <= 1e-12, case
    for name, points in known.items():
        for point in points:
            assert point['seconds'] > 0, (name, point)
            # The load is second order in the residual, pressures are first order with a constant of the matrix.
            assert point['load_error'] < 20 * point['tol'] and point['pressure_error'] < 100 * point['tol'], (name, point)
        # Solves with a matrix may be stopped at their time limit.
        assert any(part in name for part in ('single', 'dense', 'cholmod')) or points[-1]['tol'] <= 1e-4, (name, points)
    assert known[FAST][-1]['pressure_error'] < 1e-6 < grid_error(document, case, 'pressure_error') < 0.3
    loads = {grid: points[-1]['true_load_error'] for (grid, kernel), points in grids(document, case).items()}
    assert sorted(loads) == [32, 64, 128] and loads[32] > loads[128], loads
    kernels = {kernel: points[-1]['true_load_error'] for (grid, kernel), points in grids(document, case, usual=False).items() if grid == 64}
    assert set(kernels) == {'love', 'galerkin', 'disc', 'punch', 'eq9'} and kernels['eq9'] > 3 * kernels['love'], kernels


def pareto(folder):
    check_front()
    first, filled = remade('speed-accuracy', '--threads', '1')
    count, failed, before = counts(first)
    assert count > 80 and failed == 0 and before == 0, first
    document = load(folder, 'pareto')
    assert [case['scene'] for case in cases(document)] == ['hertz', 'self-affine']
    assert [case['truth'] for case in cases(document)] == ['analytic', 'finest grid']
    for case in cases(document):
        assert abs(case['contacts'] / case['points'] / case['contact'] - 1) < 0.1, case
        check_case(document, case)
    goals = [{**run, **row} for run in load(folder, 'goal')['runs'] for row in rows_of(run['goals'])]
    assert len(goals) == 3 * 2 * 2 * 4 and {row['status'] for row in goals} == {'RC_OK', 'RC_WITHIN_GOAL'}, len(goals)
    assert sum(row['error'] <= row['goal'] for row in goals) >= 0.95 * len(goals), goals
    for row in goals:
        assert (row['model'] < row['points']) == (row['status'] == 'RC_WITHIN_GOAL') == (row['estimate'] > 0), row
    assert [scene['scene'] for scene in load(os.path.join(folder, 'scenes'), 'scenes')['scenes']] == ['hertz', 'self-affine']

    assert set(filled) == {'provenance', 'picks', 'methods', 'tolerances', 'grids', 'goals'}, filled.keys()
    for name, text in filled.items():
        assert text.strip() and 'nan' not in text and 'None' not in text, (name, text)
    assert filled['tolerances'].count('²') == 2 and filled['picks'].count('\n- ') >= 5, filled
    check_pictures(folder, 'speed-accuracy', 'speed-accuracy-grids')
    assert counts(run('documents', 'speed-accuracy', '--quick', '--threads', '1'))[:2] == [0, 0]


def check_rows(document):
    points = document['surface']['points']
    curves = {}
    for row in document['rows']:
        assert row['status'] == 'RC_OK', row
        assert 0.527 * row['area'] < row['corrected_area'] <= row['area'], row
        if row['n'] == points:
            curves.setdefault(row['seed'], []).append(row)
    assert len(curves) == 2 and all(len(rows) == 11 for rows in curves.values())
    for rows in curves.values():
        for low, high in zip(rows, rows[1:]):
            assert low['area'] < high['area'] and low['mean_gap'] > high['mean_gap'] >= 0, high
            if 'stiffness' in high:  # between two loads the slope of the load lies between its ends
                slope = (high['pressure'] - low['pressure']) / (low['mean_gap'] - high['mean_gap'])
                assert low['stiffness'] < slope < high['stiffness'], (low, high)
        for row in rows:
            if 'histogram' in row:
                share = sum(row['histogram']['density']) * row['histogram']['width'] + row['histogram']['above'] / points**2
                assert abs(share / row['area'] - 1) < 1e-5, row
                assert sum(row['patch_octaves']) == row['patches'] > 1 and 0 < row['largest_patch'] <= 1, row


def check_summary(document):
    fits = document['fits']
    assert fits['corrected_kappa']['mean'] < fits['kappa']['mean'], fits
    assert 1.2 < fits['corrected_kappa']['mean'] < 2.6, fits
    assert abs(fits['decay']['mean'] / fits['stiffness_decay']['mean'] - 1) < 0.25, fits
    for row in document['curve']:
        assert abs(row['area'] - row['persson']) < 0.2, row
    assert document['curve'][-1]['area'] > 0.95
    assert len(document['meshes']) == 6
    for row in document['meshes'][:-1]:
        assert row['raw_error'] > 0 and abs(row['corrected_error']) < row['raw_error'], row
    assert len(document['hard']) == 24
    for row in document['hard']:
        assert row['excess'] >= 1 and 0 <= row['capped'] <= 1 and abs(row['area'] - row['persson']) < 0.12, row
        assert row['share'] < 0.99 or row['excess'] < 1.02 and row['capped'] > 0.9, row  # next to full plasticity


def physics(folder):
    _, filled = remade('physics', '--threads', '1')
    first = load(folder, 'physics')
    check_rows(first)
    check_summary(first)
    again = [line for line in run('documents', 'physics', '--quick', '--threads', '1').splitlines() if '^2, surface' in line]
    assert again and all('measured before' in line for line in again), again
    second = load(folder, 'physics')
    assert all(second[key] == first[key] for key in ('rows', 'capped', 'curve', 'fits', 'meshes', 'hard'))
    assert set(filled) == {'fits', 'curve', 'meshes', 'provenance'}, filled.keys()
    assert filled['curve'].count('\n') == 2 + 11 and filled['meshes'].count('\n') == 2 + 6, filled
    assert f'{first["fits"]["corrected_kappa"]["mean"]:.2f} (' in filled['fits'], filled['fits']
    check_pictures(folder, *(f'physics-{name}' for name in ('area', 'gap', 'patches', 'mesh', 'hardness')))


def published(folder):
    _, filled = remade('published', '--threads', '1')
    document = load(folder, 'published')
    assert all(row['status'] == 'RC_OK' and row['lower'] <= row['area'] <= row['upper'] for table in ('breadth', 'gfmd', 'challenge')
               for row in document[table]), document
    for row in document['forms']:
        assert abs(row['error_of']) < (0.01 if 'punch' in row['title'] else 3e-3), row
    for row in document['spheres']:
        assert row['model_middle'] < row['middle'] < 1 < row['distance'] < row['model_distance'], row
    assert all(0.1 < row[axis] < 0.8 for row in document['crossing'] for axis in 'xy'), document['crossing']
    for table in ('breadth', 'gfmd', 'challenge'):  # areas grow with the load
        rows = document[table]
        assert all(b['area'] > a['area'] for a, b in zip(rows, rows[1:]) if a['pressure'] < b['pressure']), rows
    for row in document['slip']:  # the model is exact at nu = 0
        assert row['gap'] < 1e-7 and max(map(abs, row['force'][0])) < 1e-5 < max(map(abs, row['force'][-1])) < 0.03, row
    for row in document.get('leak', ()):  # a medium with gaps of one height only would have 1
        assert 0 < row['ours'] < 1 > row['medium'] > 0 and row['width'] < 0.01, row
    assert not document.get('mirco') or max(abs(row['difference']) for row in document['mirco']) < 0.015, document['mirco']
    assert run('documents', 'published', '--quick', '--threads', '1').count('measured before') == sum(
        len(document[table]) for table in ('forms', 'waves', 'spheres', 'crossing', 'breadth', 'gfmd', 'challenge', 'distributions', 'mirco', 'slip', 'leak') if table in document)
    assert 'not reproduced' in open(os.path.join(folder, 'published.md'), encoding='utf-8').read()
    assert set(filled) >= {'summary', 'forms', 'crossing', 'gfmd', 'challenge', 'provenance'}, filled.keys()
    check_pictures(folder, *(f'published-{name}' for name in ('forms', 'crossing', 'area', 'challenge', 'slip')))


page = {'pareto': 'speed-accuracy'}.get(sys.argv[2], sys.argv[2])
globals()[sys.argv[2]](os.path.join(BUILD, f'{page}-quick'))
