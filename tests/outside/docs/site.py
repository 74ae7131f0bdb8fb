"""The site builds without a warning, has every page, loads nothing from a network, and its index finds words of all parts.

Usage: site.py BUILD; exit code 77 where what scripts/site.sh needs cannot be had.
"""

import pathlib
import re
import subprocess
import sys

import pages

build = pathlib.Path(sys.argv[1])
status = subprocess.run([pages.SOURCE / 'scripts/site.sh', build]).returncode
if status:
    sys.exit(status)
site = build / 'site/html'
wrong = [
    f'{page} is missing'
    for page in pages.pages()
    if page.parts[len(pages.SOURCE.parts)] not in ('tests', 'paper')
    and not (site / page.relative_to(pages.SOURCE)).with_suffix('.html').exists()
]
for page in site.rglob('*.html'):
    wrong += [
        f'{page.relative_to(site)} loads {found}'
        for found in re.findall(
            r'<(?:script|img|iframe)[^>]* src="(https?:[^"]*)"|<link[^>]* rel="stylesheet"[^>]* href="(https?:[^"]*)"',
            page.read_text(),
        )
    ]
index = (site / 'searchindex.js').read_text()
for name in 'rc_contact_solve_history', 'rcf_solve', 'roughcontact.HalfSpace', 'plasticity', 'thermal', 'leak', 'abaqus', 'calculix':
    if name.rpartition('.')[2].lower() not in index.lower():
        wrong.append(f'{name} is not found by the search')
print('\n'.join(wrong))
print(f'{len(list(site.rglob("*.html")))} pages, {len(wrong)} wrong')
sys.exit(1 if wrong else 0)
