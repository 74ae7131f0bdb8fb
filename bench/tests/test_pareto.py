"""`documents speed-accuracy --quick` gives certified points whose errors are what their tolerances allow, fills the page and draws the
pictures, and a second call measures nothing anew."""
import os

from program import BUILD, check_pictures, counts, load, remade, run

from speed_accuracy_tables import FAST, cases, enough, front, grid_error, grids, lines, name_of, time_to

FOLDER = os.path.join(BUILD, 'speed-accuracy-quick')


def check_front():
    assert front([(3, 1e-3), (1, 1e-1), (2, 1e-1), (4, 1e-2), (5, 1e-9)]) == [(1, 1e-1), (3, 1e-3), (5, 1e-9)]
    points = [{'tol': 1e-2, 'a': 1e-5, 'b': 1e-1, 'setup_seconds': 1, 'solve_seconds': 1},
              {'tol': 1e-4, 'a': 1e-5, 'b': 1e-4, 'setup_seconds': 1, 'solve_seconds': 2},
              {'tol': 1e-6, 'a': 1e-9, 'b': 1e-6, 'setup_seconds': 1, 'solve_seconds': 3}]
    assert enough(points, {'a': 1e-4, 'b': 1e-3}) == 1e-4 and enough(points, {'a': 1e-4, 'b': 1e-9}) is None
    assert time_to(points, 1e-4, 'b') == 3 and time_to(points, 1e-8, 'b') is None


def check_case(document, case):
    known = lines(document, case)
    assert {'auto', FAST, 'haar-cg, fft, double', 'haar-cg, fft, single', 'haar-cg, split', 'polonsky-keer, fft', 'nnls, fft', 'nnls, dense',
            'gp, fft', 'admm, fft', 'greedy, fft', 'cmr, fft'} <= known.keys(), known.keys()
    assert case['certified_residual'] <= 1e-12, case
    for row in document['methods']:
        for point in row['points']:
            assert point['status'] in ('RC_OK', 'RC_STOP_TIME'), (name_of(row), point)
    for name, points in known.items():
        for point in points:
            assert point['residual'] <= point['tol'] and point['setup_seconds'] + point['solve_seconds'] > 0, (name, point)
            # The load is second order in the residual, pressures are first order with a constant of the matrix.
            assert point['load_error'] < 20 * point['tol'] and point['pressure_error'] < 100 * point['tol'], (name, point)
            assert point['true_load_error'] < 0.05 + 20 * point['tol'], (name, point)
        # Those with a matrix may be stopped at their limit of time.
        assert any(part in name for part in ('single', 'dense', 'cholmod')) or points[-1]['tol'] <= 1e-4, (name, points)
    assert known[FAST][-1]['pressure_error'] < 1e-6 < grid_error(document, case, 'pressure_error') < 0.3
    loads = {grid: points[-1]['true_load_error'] for (grid, kernel), points in grids(document, case).items()}
    assert sorted(loads) == [32, 64, 128] and loads[32] > loads[128], loads
    kernels = {kernel: points[-1]['true_load_error'] for (grid, kernel), points in grids(document, case, usual=False).items() if grid == 64}
    assert set(kernels) == {'love', 'galerkin', 'disc', 'punch', 'eq9'} and kernels['eq9'] > 3 * kernels['love'], kernels


check_front()
first, filled = remade('speed-accuracy', '--threads', '1')
count, failed, before = counts(first)
assert count > 80 and failed == 0 and before == 0, first
document = load(FOLDER, 'pareto')
assert [case['scene'] for case in cases(document)] == ['hertz', 'self-affine']
assert [case['truth'] for case in cases(document)] == ['analytic', 'finest grid']
for case in cases(document):
    assert abs(case['contacts'] / case['points'] / case['contact'] - 1) < 0.1, case
    check_case(document, case)
goals = load(FOLDER, 'goal')['rows']
assert len(goals) == 3 * 2 * 2 * 4 and {row['status'] for row in goals} == {'RC_OK', 'RC_WITHIN_GOAL'}, len(goals)
assert sum(row['error'] <= row['goal'] for row in goals) >= 0.95 * len(goals), goals
for row in goals:
    assert (row['model'] < row['points']) == (row['status'] == 'RC_WITHIN_GOAL') == (row['estimate'] > 0), row
assert [scene['scene'] for scene in load(os.path.join(FOLDER, 'scenes'), 'scenes')] == ['hertz', 'self-affine']

assert set(filled) == {'provenance', 'picks', 'methods', 'tolerances', 'grids', 'goals'}, filled.keys()
for name, text in filled.items():
    assert text.strip() and 'nan' not in text and 'None' not in text, (name, text)
assert filled['tolerances'].count('²') == 2 and filled['picks'].count('\n- ') >= 5, filled
check_pictures(FOLDER, 'speed-accuracy', 'pareto-generated', 'pareto-contacts', 'pareto-grids', 'pareto-kernels')
assert counts(run('documents', 'speed-accuracy', '--quick', '--threads', '1'))[:2] == [0, 0]
