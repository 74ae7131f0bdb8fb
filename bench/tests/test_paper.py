"""`documents paper --quick` finds what is known of the paper's examples, fills the page and draws the pictures, and a second call measures
nothing anew."""
import math
import os
import shutil

from program import BUILD, check_pictures, counts, load, run, sections

from paper_rows import rows
from paper_tables import INDEPENDENT, SECTIONS
from samples import median, median_interval, values_of

FOLDER, CALL = os.path.join(BUILD, 'paper-quick'), ('documents', 'paper', '--quick')
CERTIFIED = 1e-7  # of loads, a few times the tolerance


def close(value, wanted, tolerance):
    assert abs(value - wanted) <= tolerance, (value, wanted, tolerance)


shutil.rmtree(FOLDER, ignore_errors=True)
first = run(*CALL)
count, failed, before = counts(first)
assert count > 100 and failed == 0 and before == 0, first
document = load(FOLDER, 'paper')

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
    forces = [row['steps'][-1]['mean_pressure'] for row in rows(document, 'figure_4', setting=setting, seed=1) if row['status'] == 'RC_OK']
    assert len(forces) >= 6 and max(forces) / min(forces) - 1 < 1e-6, forces
assert {row['inner'] for row in rows(document, 'figure_5')} == {'cg', 'cholesky', 'gauss-seidel'}
for row in rows(document, 'figure_5'):
    assert row['candidates'] == row['n'], row
for row in rows(document, 'figure_6'):
    assert row['status'] == 'RC_OK' and row['solves'] > 0, row

lost = {h: median([abs(row['load_error']) for row in rows(document, 'figure_8', hurst=h, backend='fft', kernel='eq9')])
        for h in values_of(rows(document, 'figure_8'), 'hurst')}
assert lost[0.3] > lost[0.6] > lost[0.9], lost
for row in rows(document, 'figure_8'):
    assert row['certified_status'] == 'RC_OK' and abs(row['certified_error']) < CERTIFIED and row['load_error'] < CERTIFIED, row
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

filled = sections(FOLDER, 'paper')
assert set(filled) == {'provenance', 'claims', *SECTIONS}, filled.keys()
for name, text in filled.items():
    assert text.strip() and 'ot measured yet' not in text and 'nan' not in text, (name, text)
if shutil.which('gnuplot'):
    check_pictures(FOLDER, *(f'paper-figure-{number}' for number in (2, 4, 5, 6, 8, 9, 10)))
assert counts(run(*CALL)) == [0, 0, count]
