"""device_resources.py LOG RELEASE [DOCUMENT]: what ptxas said of every kernel (device_resources.sh), the most of any architecture of a kind; prints
it as a table, or writes it between the marks of the document."""
import collections
import pathlib
import re
import subprocess
import sys

MANY, MUCH = 32, 50  # registers of a kernel and spilled bytes of a function that are listed
BEGIN, END = '<!-- begin resources -->', '<!-- end resources -->'


def kernels(log):
    """(architecture, kernel): registers, bytes spilled, bytes of shared memory; and function that kernels call: bytes spilled."""
    found, called, architecture, name, function, spills = {}, collections.Counter(), '', '', '', 0
    for line in log.splitlines():
        if match := re.match(r'architecture (\d+)', line):
            architecture = match[1]
        elif match := re.search(r"Compiling entry function '(\w+)'", line):
            name = match[1]
        elif match := re.search(r'Function properties for (\w+)', line):
            function = match[1]
        elif match := re.search(r'(\d+) bytes spill stores, (\d+) bytes spill loads', line):
            if function == name:
                spills = int(match[1]) + int(match[2])
            else:
                called[function] = max(called[function], int(match[1]) + int(match[2]))
        elif match := re.search(r'Used (\d+) registers', line):
            shared = re.search(r'(\d+) bytes smem', line)
            found[architecture, name] = int(match[1]), spills, int(shared[1]) if shared else 0
    return found, called


def demangled(names):
    return subprocess.run(['c++filt'], input='\n'.join(names), text=True, capture_output=True, check=True).stdout.splitlines()


def plain(names):
    """each_kernel<F> and the like, with what they run."""
    result = {}
    for name, full in zip(names, demangled(names)):
        inner = re.search(r'(each|reduce|together|blocks)_kernel<(.*)>\(', full)
        kind, arguments = inner.groups()
        what = arguments.replace('rc_cuda::', '').replace(' >', '>').strip()
        result[name] = (kind, what.split(', ', 1)[1] if kind == 'reduce' else what)
    return result


def main():
    log = pathlib.Path(sys.argv[1]).read_text()
    found, called = kernels(log)
    if not found:
        sys.exit(f'ptxas said nothing of any kernel:\n{log}')
    names = plain(sorted({name for _, name in found}))
    architectures = sorted({int(architecture) for architecture, _ in found})
    rows = collections.defaultdict(dict)
    for (architecture, name), numbers in found.items():
        rows[names[name]][int(architecture)] = numbers
    spilled = sum(numbers[1] for numbers in found.values())
    text = [f'{len(rows)} kernels, nvcc {sys.argv[2]}; outside calls of functions {spilled} bytes are spilled. Those with {MANY} registers or more:', '',
            '| launch | computes | ' + ' | '.join(f'registers, sm_{each}' for each in architectures) + ' | shared memory [bytes] |',
            '|---|---|' + '---|' * (len(architectures) + 1)]
    for (kind, what), numbers in sorted(rows.items()):
        if max(each[0] for each in numbers.values()) < MANY:
            continue
        text.append(f'| {kind} | `{what}` | ' + ' | '.join(str(numbers[each][0]) for each in architectures)
                    + f' | {max(each[2] for each in numbers.values())} |')
    saving = {name: count for name, count in called.items() if count > 0}
    if called:
        text += ['', f'Kernels of `blocks` call {len(called)} functions, so that what follows the iteration takes no registers from the passes. '
                 f'{len(called) - len(saving)} of them spill nothing; the others save registers around calls. {MUCH} bytes or more, stored and loaded:', '',
                 '| function | bytes |', '|---|---|']
        for name, full in sorted(zip(saving, demangled(saving)), key=lambda each: each[1]):
            if saving[name] < MUCH:
                continue
            short = re.sub(r'^(?:void|double|[\w:]+) (?=rc)', '', re.sub(r'\(.*', '', full)).replace('rc_cuda::', '')
            text.append(f'| `{short}` | {saving[name]} |')
    table = '\n'.join(text)
    if len(sys.argv) < 4:
        print(table)
        return
    document = pathlib.Path(sys.argv[3])
    before, rest = document.read_text().split(BEGIN)
    after = rest.split(END)[1]
    document.write_text(f'{before}{BEGIN}\n{table}\n{END}{after}')


main()
