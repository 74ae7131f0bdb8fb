"""The smallest run of each benchmark gives JSON in which every answer is certified."""
import tempfile

import program


def run(*arguments):
    with tempfile.TemporaryDirectory() as folder:
        program.run(*arguments, '--json', folder + '/out.json')
        document = program.load(folder, 'out')
    for key in ('date', 'commit', 'compiler', 'flags', 'fftw', 'cpu', 'threads'):
        assert document['provenance'][key], key
    return document


for row in run('passes', '--quick')['rows']:
    assert row['ns'] > 0 and row['share'] > 0, row
products = run('products', '--quick', '--sizes', '128')
for row in products['products']:
    assert row['difference'] < 1e-12 and row['single_difference'] < 1e-5, row

failures = run('failures', '--quick')
assert len(failures['atlas']) > 5 and all(all(row.values()) for row in failures['atlas'])
assert all(row['dishonest'] == 0 for row in failures['greedy'] + failures['cmr'])
for row in failures['cmr']:
    assert abs(row['certified_error']) < 1e-7, row

batch = run('batch', '--quick', '--surfaces', '5', '--points', '32', '--steps', '3', '--threads', '2')
for row in batch['batch']:
    assert row['certified'] == 5 and row['products'] > 15, row
assert [row['threads'] for row in batch['batch']] == [1, 2] and batch['scaling'] > 0

small = run('small', '--quick')['rows']
assert len(small) == 6 and all(row['value'] > 0 for row in small if 'first' not in row['row']), small

overhead = run('overhead', '--repeats', '5')['rows']
assert [row['value'] > 0 for row in overhead[:2]] == [True, True], overhead

leak = run('leak', '--quick')['leaks'][0]
assert 'roughcontact-flow' in leak.get('error', '') or 0 < leak['width'] < 1e-2 and 15 < leak['contact_percent'] < 25, leak
