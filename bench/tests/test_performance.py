"""`documents performance --quick` fills the page, and a second call measures nothing anew."""
import os
import shutil

from program import BUILD, run, sections

FOLDER, CALL = os.path.join(BUILD, 'performance-quick'), ('documents', 'performance', '--quick')
shutil.rmtree(FOLDER, ignore_errors=True)
first = run(*CALL)
assert 'measured before' not in first, first
filled = sections(FOLDER, 'performance')
for name in ('targets', 'machine', 'product-limits', 'pass-limits', 'scaling', 'growth', 'dilute', 'busy', 'deterministic', 'batch'):
    assert filled[name].startswith('|') and 'Not measured' not in filled[name], name
for name in ('scaling-single', 'baseline', 'profile'):
    assert filled[name].startswith('Not measured yet'), name
# Every row once.
assert filled['scaling'].count('²') == 8, filled['scaling']
assert run(*CALL).count('measured before') == 8 + 6
