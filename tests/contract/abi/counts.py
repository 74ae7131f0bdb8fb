#!/usr/bin/env python3
"""How much there is to learn: the functions and structs that the public headers declare, and the limits that they keep. flow.h,
request.h with budget.h, and slip (the names in law.h that begin with rc_law_slip) are counted apart, without a limit.

counts.py INCLUDE_DIR
"""
import collections
import pathlib
import re
import sys

LIMITS = {'functions': 100, 'structs': 54}
APART = {'flow.h': 'flow.h', 'request.h': 'request.h', 'budget.h': 'request.h'}

found = collections.defaultdict(lambda: {'functions': set(), 'structs': set()})
for header in sorted(pathlib.Path(sys.argv[1]).glob('**/*.h')):
    text = re.sub(r'/\*.*?\*/', ' ', header.read_text(), flags=re.S)
    text = re.sub(r'^#(.*\\\n)*.*$', '', text, flags=re.M)
    names = {
        'functions': re.findall(r'RC_API [^(;]*?(\w+)\([^;]*\);', text),
        'structs': re.findall(r'\bstruct (\w+)\s*\{', text),
    }
    for kind, each in names.items():
        for name in each:
            found['slip' if name.startswith('rc_law_slip') else APART.get(header.name, 'all others')][kind].add(name)

failed = False
for part, counts in sorted(found.items()):
    print(f'{part}: ' + ', '.join(f'{len(names)} {kind}' for kind, names in counts.items()))
for kind, limit in LIMITS.items():
    number = len(found['all others'][kind])
    if not 0 < number <= limit:
        print(f'{number} {kind}: there may be {limit}; replace one, or a family, by what there is')
        failed = True
sys.exit(failed)
