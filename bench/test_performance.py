#!/usr/bin/env python3
"""test_performance.py BUILD: `performance.sh --quick` fills the page, and a second call measures nothing anew. Times decide nothing."""
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
FOLDER = os.path.join(sys.argv[1], 'performance-quick')


def run():
    return subprocess.run([os.path.join(HERE, 'performance.sh'), sys.argv[1], '--quick'], check=True, env=dict(os.environ, PYTHON=sys.executable),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout


def sections(text):
    return dict(re.findall('<!-- begin (.*?) -->\n(.*?)<!-- end .*? -->', text, re.DOTALL))


if os.path.isdir(FOLDER):
    for name in os.listdir(FOLDER):
        os.remove(os.path.join(FOLDER, name))
first = run()
assert 'measured before' not in first, first
with open(os.path.join(FOLDER, 'performance.md'), encoding='utf-8') as file:
    filled = sections(file.read())
for name in ('targets', 'machine', 'product-limits', 'pass-limits', 'scaling', 'growth', 'dilute', 'busy', 'deterministic', 'batch'):
    assert filled[name].startswith('|') and 'Not measured' not in filled[name], name
for name in ('scaling-single', 'baseline', 'profile'):
    assert filled[name].startswith('Not measured yet'), name
# Every row once.
assert filled['scaling'].count('²') == 8, filled['scaling']
assert run().count('measured before') == 8 + 6
