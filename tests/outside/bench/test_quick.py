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


def check_certified(row, tol):
    assert row.get('status') == 'RC_OK', row
    assert all(row[key] <= tol for key in ('kkt_primal', 'kkt_dual', 'kkt_complementarity', 'kkt_control')), row


scaling = run('scaling', '--quick', '--sizes', '128', '--percents', '1,10,40')
assert len(scaling['solves']) == 6
for row in scaling['solves']:
    check_certified(row, row['tol'])
    assert abs(row['area_found'] / row['area_wanted'] - 1) < 0.1, row
    assert row['bytes_per_point_in_all'] > row['bytes_per_point'] > 0 and row['product_seconds_best'] > 0, row

products = run('products', '--quick', '--sizes', '128')
for row in products['products']:
    assert row['difference'] < 1e-12 and row['single_difference'] < 1e-5, row

limits = run('limits', '--quick', '--sizes', '64', '--threads', '1')
for row in limits['products']:
    real = 4 if row['precision'] == 'single' else 8
    assert abs(row['operations_per_point'] / (30 * 7 + 4) - 1) < 0.02 and abs(row['bytes_per_point'] / (11 * real) - 1) < 0.02, row
    assert row['fraction'] > 0, row
assert limits['bandwidth'][0]['gigabytes_per_second'] > 0 and len(limits['transforms']) == 2 and len(limits['passes']) == 2

busy = run('busy', '--quick', '--points', '64', '--threads', '1', '--repeats', '1')
assert busy['busy'][0]['ratio'] > 0 and len(busy['busy'][0]['busy']) == 1

begun = run('first', '--quick')
assert min(begun['rows'][0][name] for name in ('first', 'second')) > 0

repeated = run('deterministic', '--quick', '--points', '64', '--threads', '2', '--repeats', '2')
for row in repeated['deterministic']:
    assert row['choice'] != '1' or row['same_as_one_thread'] == row['same_again'] == 'yes', row

assert len(run('goal-trial', '--kinds', 'dust,terraces', '--points', '32', '--last', '2', '--goals', '0.1', '--times')['rows']) == 3

failures = run('failures', '--quick')
assert len(failures['atlas']) > 20 and all(all(row.values()) for row in failures['atlas'])
assert all(row['dishonest'] == 0 for row in failures['data']['greedy'] + failures['data']['cmr'])
for row in failures['data']['cmr']:
    assert row['certified_status'] == 'RC_OK' and abs(row['certified_error']) < 1e-7, row

batch = run('batch', '--quick', '--surfaces', '5', '--points', '32', '--steps', '3', '--threads', '2')
for row in batch['batch']:
    assert row['status'] == 'RC_OK' and row['certified'] == 5 and row['products'] > 15, row
assert [row['threads'] for row in batch['batch']] == [1, 2] and batch['scaling'] > 0 and batch['cpu_growth'] > 0

dilute = run('dilute', '--sizes', '256', '--contacts', '1', '--threads', '1', '--budget', '0')
assert len(dilute['solves']) == 8
for row in dilute['solves']:
    for run_name in ('auto', 'fft'):
        check_certified(row[run_name], row['tol'])
    assert row['fft']['modelled'] >= row['n']**2 and row['auto']['contacts'] == row['fft']['contacts'], row
for row in dilute['dilute']:
    assert row['difference'] < 1e-10 and row['split_ms'] > 0, row

mapped = run('mapped', '--quick')['solves'][0]
assert mapped['status'] == 'OK' and mapped['residual'] <= 1e-4 and mapped['own_gigabytes'] < 0.2, mapped
assert 0.5 < mapped['contact_percent'] / mapped['percent_wanted'] < 2, mapped

histories = run('histories', '--levels', '6', '--steps', '4')
for row in histories['histories']:
    assert row['status'] == 'RC_OK' and row['load_difference'] < 1e-6, row

stiffness = run('stiffness', '--quick', '--threads', '1')
assert len(stiffness['stiffness']) == 8
for row in stiffness['stiffness']:
    assert row['residual']**2 <= 1e-8 and 2 <= row['stiffness'] <= (12 if row['step'] == 'warm' else row['contact'] / 2), row

counts = run('counts', '--quick', '--threads', '1')['counts']
assert len(counts) == 8 and all(5 <= row['products'] <= 40 and 0.5 < row['percent_found'] / row['percent'] < 2 for row in counts), counts

rows = run('rows', '--quick')['rows']
assert len(rows) == 22 and all(row['value'] > 0 for row in rows), rows
