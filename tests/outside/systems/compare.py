#!/usr/bin/env python3
"""compare.py HERE THERE: two files of answers.c. Cases, statuses and messages must be the same, numbers to 1e-10 of the largest of
their name in the case; says how many cases are the same bit for bit."""
import collections
import re
import struct
import sys

TOLERANCE = 1e-10
NUMBER = re.compile(r'(p|w|gap|load|approach|energy) ([0-9a-f]{16})')


def cases_of(file):
    """The text of each case, and its numbers by name."""
    cases, text, numbers = [], [], {}
    for line in open(file, encoding='utf-8', newline=''):
        assert line.endswith('\n') and not line.endswith('\r\n'), f'{file}: {line!r}'
        if line.startswith('case '):
            text, numbers = [], collections.defaultdict(list)
            cases.append((text, numbers))
        found = NUMBER.fullmatch(line[:-1])
        if found:
            numbers[found[1]].append(struct.unpack('>d', bytes.fromhex(found[2]))[0])
        else:
            # The backends that are built, counts of iterations, and how many points addresses can count may differ.
            text.append(re.sub('; available: .*|after [0-9]+ iterations|[0-9]+ points$', '', line))
    return cases


def main():
    here, there = (cases_of(file) for file in sys.argv[1:3])
    wrong, same, worst = [], 0, 0.0
    if not here or len(here) != len(there):
        wrong.append(f'{len(here)} and {len(there)} cases')
    for (text, numbers), (other_text, other_numbers) in zip(here, there):
        same += text == other_text and numbers == other_numbers
        if text != other_text:
            wrong.append(f'{"".join(text)}there:\n{"".join(other_text)}')
            continue
        for name, values in numbers.items():
            scale = max(map(abs, values))
            apart = max(abs(a - b) for a, b in zip(values, other_numbers[name])) / (scale or 1)
            worst = max(worst, apart)
            if apart > TOLERANCE or len(values) != len(other_numbers[name]):
                wrong.append(f'{text[0]}{name} differs by {apart:.1e}\n')
    print(*wrong[:20], f'{len(here)} cases, {same} of them the same bit for bit; the same statuses and messages unless shown above; '
          f'numbers differ by at most {worst:.1e}, {TOLERANCE:g} is allowed', sep='\n')
    return 1 if wrong else 0


sys.exit(main())
