"""`documents physics --quick` gives certified rows that agree with each other, a second call measures nothing anew, and the page is filled and
every picture drawn."""
import os

from program import BUILD, check_pictures, load, remade, run

FOLDER = os.path.join(BUILD, 'physics-quick')


def check_rows(document):
    points = document['surface']['points']
    curves = {}
    for row in document['rows']:
        assert row['status'] == 'RC_OK' and row['kkt_control'] <= row['tol'], row
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
                assert abs(share / row['area'] - 1) < 1e-12, row
                assert sum(row['patch_octaves']) == row['patches'] > 1 and 0 < row['largest_patch'] <= 1, row


def check_summary(document):
    fits = document['fits']
    assert fits['corrected_kappa']['mean'] < fits['kappa']['mean'], fits
    assert 1.2 < fits['corrected_kappa']['mean'] < 2.6, fits
    assert abs(fits['decay']['mean'] / fits['stiffness_decay']['mean'] - 1) < 0.25, fits
    for row in document['curve']:
        assert row['surfaces'] == 2 and abs(row['area'] - row['persson']) < 0.2, row
    assert document['curve'][-1]['area'] > 0.95
    assert len(document['meshes']) == 6
    for row in document['meshes'][:-1]:
        assert row['raw_error'] > 0 and abs(row['corrected_error']) < row['raw_error'], row


_, filled = remade('physics', '--threads', '1')
first = load(FOLDER, 'physics')
check_rows(first)
check_summary(first)
again = [line for line in run('documents', 'physics', '--quick', '--threads', '1').splitlines() if '^2, surface' in line]
assert again and all('measured before' in line for line in again), again
second = load(FOLDER, 'physics')
assert all(second[key] == first[key] for key in ('rows', 'curve', 'fits', 'meshes'))
assert set(filled) == {'fits', 'curve', 'meshes', 'provenance'}, filled.keys()
assert filled['curve'].count('\n') == 2 + 11 and filled['meshes'].count('\n') == 2 + 6, filled
assert f'{first["fits"]["corrected_kappa"]["mean"]:.2f} (' in filled['fits'], filled['fits']
check_pictures(FOLDER, *(f'physics-{name}' for name in ('area', 'gap', 'patches', 'mesh')))
