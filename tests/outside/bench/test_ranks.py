"""`ranks --quick`, and `documents scale-out --quick`: the same pressures on every number of ranks, bytes as the formula has them, simulated
solves where SMPI is installed, tables that are filled. Times decide nothing."""
import os
import sys

from program import BUILD, load, remade

from ranks_tables import transposed

if not os.environ['RC_BENCH_RANK_SOLVER']:
    print('skipped: this build has no MPI')
    sys.exit(77)

output, sections = remade('scale-out')
document = load(os.path.join(BUILD, 'scale-out-quick'), 'ranks')
simulates = bool(os.environ['RC_BENCH_RANK_SIMULATION'])

measured = document['measured']
assert len(measured) == 4 and all(row['status'] == 'RC_OK' for row in measured), measured
for row in document['counted']:
    products = row['transposed'] / row['products'] / transposed(row['n'], row['ranks'], 8)
    assert row['status'] == 'RC_OK' and 1 <= products < 1.15, row
if simulates:
    solved = document['simulated']
    assert len(solved) == 4 and all(row['status'] == 'RC_OK' for row in solved), solved
    ranks = {row['n']: row['bits'] for row in measured if row['way'] == 'ranks'}
    assert {row['bits'] for row in solved} == {ranks[256]}, 'pressures depend on the number of ranks'
    four = {row['network']: row['seconds'] for row in solved if row['ranks'] == 4}
    assert len(four) == 2 and min(four.values()) > 0
for name in 'measured', 'counted', 'strong', 'failed':
    kinds = {line.split('|')[1].strip() for line in sections[name].splitlines()[2:] if line.startswith('|')}
    assert kinds <= {'measured', 'simulated', 'counted'}, (name, kinds)
assert '256²' in sections['measured']
