#!/usr/bin/env python3
"""Writes a C file that defines every function of the given public headers, doing nothing. Compiled with debug information it is
the binary interface that the headers declare, whatever the library itself was built with.

interface.py HEADER... >interface.c
"""
import pathlib
import re
import sys

names = []
for name in sys.argv[1:]:
    print(f'#include "{pathlib.Path(name).resolve()}"')
for name in sys.argv[1:]:
    text = re.sub(r'/\*.*?\*/', ' ', pathlib.Path(name).read_text(), flags=re.S)
    text = re.sub(r'^#(.*\\\n)*.*$', '', text, flags=re.M)
    for result, function, arguments in re.findall(r'RC_API ([^(;]*?)(\w+)\(([^;]*)\);', text):
        result = ' '.join(result.split())
        names.append(function)
        body = 'return 0;' if result != 'void' else ''
        print(f'{result} ({function})({" ".join(arguments.split())}) {{ {body} }}')
sys.exit(0 if names else 'no function marked RC_API found')
