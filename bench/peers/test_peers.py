#!/usr/bin/env python3
"""test_peers.py BUILD: the harness runs without network and peers; both codes are certified, a second call measures nothing anew.
Times decide nothing."""
import json
import os
import subprocess
import sys
import tempfile

try:
    import numpy as np
except ImportError:
    print('skipped: needs NumPy')
    sys.exit(77)

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)


def run(folder, *more):
    file = os.path.join(folder, 'peers.json')
    subprocess.run([sys.executable, '-B', os.path.join(HERE, 'peers.py'), sys.argv[1], '--quick', '--only', 'ours,baseline', '--sizes',
                    '64', '--repeats', '1', '--json', file, *more], check=True, stdout=subprocess.DEVNULL)
    with open(file) as text:
        return json.load(text)


def check_document(document):
    assert set(document['codes']) == {'ours', 'ours-float', 'baseline', 'mirco'} and not document['left_out']
    assert len(document['calibration']) == 4, document['calibration']
    for name, row in document['calibration'].items():
        assert row['passed'] and row['residual'] <= (1e-4 if 'float' in name else 1e-6), (name, row)
    controls = {document['cases'][group['case']]['control'] for group in document['groups'] if group['code'] == 'baseline'}
    assert controls == {'load', 'displacement'}
    for group in document['groups']:
        assert not group['stopped'], group
        assert [run['residual'] <= run['tol'] for run in group['runs']] == [True] * (1 if group['code'] == 'ours-float' else 3), group
        assert all(run['peak_bytes'] > run['start_bytes'] >= 0 or group['code'].startswith('ours') for run in group['runs']), group


def check_judge(folder):
    """The judge refuses pressures that are off in one cell, in units, or not numbers."""
    from certificate import Judge
    from library import Contact, Library
    library, n = Library(sys.argv[1]), 32
    x = (np.arange(n) + 0.5) / n - 0.5
    gap, pressure = (x[:, None]**2 + x[None, :]**2) / 2, np.zeros((n, n))
    with Contact(library, n, 'free', tol=1e-9) as contact:
        assert contact.solve('load', 0.01, gap, pressure).status == 0
    judge = Judge(library, n, 'free', 1)
    assert judge.judge('load', 0.01, gap, pressure)['residual'] <= 1e-9
    wrong = pressure.copy()
    wrong[n // 2, n // 2] *= 1.01
    for answer in (wrong, 2 * pressure, np.full((n, n), np.nan)):
        assert judge.judge('load', 0.01, gap, answer)['residual'] > 1e-4
    judge.close()


with tempfile.TemporaryDirectory() as folder:
    first = run(folder)
    check_document(first)
    assert run(folder)['groups'] == first['groups']
    assert run(folder, '--fresh')['groups'] != first['groups']
    check_judge(folder)
