"""The harness of peers runs without network and peers; both codes are certified, a second call measures nothing anew."""
import tempfile

import numpy as np
import program

from samples import rows_of


def run(folder, *more):
    program.run('peers', '--here', '--quick', '--only', 'ours,baseline', '--sizes', '64', '--repeats', '1', '--json', folder + '/peers.json',
                *more)
    return program.load(folder, 'peers')


def check_document(document):
    assert set(document['codes']) == {'ours', 'ours-float', 'baseline', 'mirco'} 
    assert len(document['calibration']) == 4, document['calibration']
    for name, row in document['calibration'].items():
        assert row['passed'] and row['residual'] <= (1e-4 if 'float' in name else 1e-6), (name, row)
    controls = {document['cases'][group['case']]['control'] for group in document['groups'] if group['code'] == 'baseline'}
    assert controls == {'load', 'approach'}
    for group in document['groups']:
        assert not group['stopped'], group
        runs = rows_of(group['runs'])
        assert runs and all(run['residual'] <= run['tol'] for run in runs), group
        assert all(run['peak_bytes'] > run['start_bytes'] >= 0 or group['code'].startswith('ours') for run in runs), group


def check_judge():
    """The judge refuses pressures that are off in one cell, in units, or not numbers."""
    from contact import solve, unit_square
    from peers import Judge
    from surfaces import paraboloid_gap
    n = 32
    gap, judge = paraboloid_gap(n), Judge(n, 'free', 1)
    pressure = solve(unit_square(n), gap, {'tol': 1e-9}, load=0.01).pressure
    assert judge.judge('load', 0.01, gap, pressure)['residual'] <= 1e-9
    wrong = pressure.copy()
    wrong[n // 2, n // 2] *= 1.01
    for answer in (wrong, 2 * pressure, np.full((n, n), np.nan)):
        assert judge.judge('load', 0.01, gap, answer)['residual'] > 1e-4


with tempfile.TemporaryDirectory() as folder:
    first = run(folder)
    check_document(first)
    assert run(folder)['groups'] == first['groups']
    assert run(folder, '--again')['groups'] != first['groups']
    check_judge()
