"""`documents performance --quick` fills the page, and a second call measures nothing anew."""
from program import remade, run

first, filled = remade('performance')
assert 'measured before' not in first, first
for name in ('targets', 'machine', 'product-limits', 'pass-limits', 'scaling', 'growth', 'dilute', 'busy', 'deterministic', 'batch'):
    assert filled[name].startswith('|') and 'Not measured' not in filled[name], name
for name in ('scaling-single', 'baseline', 'profile'):
    assert filled[name].startswith('Not measured yet'), name
# Every row once.
assert filled['scaling'].count('²') == 8, filled['scaling']
assert run('documents', 'performance', '--quick').count('measured before') == 8 + 6
