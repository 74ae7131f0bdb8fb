"""Where the processor time of a cold solve goes, by Linux' perf. Samples are sorted by the names of libraries and functions."""
import os
import re
import subprocess
import sys
import tempfile

from options import Question
from store import Store

# The first that matches "library function" counts.
PARTS = (('products: columns', r'rcb_fft\S* .*multiply_columns'),
         ('products: rows (FFTW)', r'libfftw3'),
         ('products: copies, eigenvalues, plans', r'rcb_fft'),
         ('products: split', r'rcb_split'),
         ('products: dense', r'rcb_dense|Eigen::'),
         ('trees', r'libroughcontact\S* .*(HaarTree|haar_tree)'),
         ('vector passes of the solver', r'libroughcontact\S* .*(::(baseline|sse2|avx2|avx512)::|Haar|Iteration<|reduce<)'),
         ('coarser grids', r'libroughcontact\S* .*(downsample|start_nested)'),
         ('trial sets, certificate, bounds, kernel', r'libroughcontact'),
         ('system: memory, threads, copies', r'kernel|libc\.|libstdc|libm\.|ld-linux|\[vdso\]|\[unknown\]'))
OTHERS = re.compile('python|numpy|_ctypes|openblas')  # the scene is made there
SCENES = ((1024, 10), (2048, 10), (2048, 0.1))
QUICK = ((128, 10),)


def part_of(line):
    return next((name for name, pattern in PARTS if re.search(pattern, line)), 'else')


def samples(n, percent, repeats, folder):
    data = os.path.join(folder, 'perf.data')
    command = ['perf', 'record', '-q', '-F', '997', '-o', data, os.path.join(os.environ['RC_BENCH_BUILD'], 'bin', 'roughcontact-bench'), 'busy', '--others', '0',
               '--points', str(n), '--percent', str(percent), '--threads', '2', '--repeats', str(repeats)]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return subprocess.run(['perf', 'report', '-i', data, '--stdio', '-q', '--no-children', '--sort', 'dso,symbol', '-F', 'period,dso,symbol'],
                          check=True, capture_output=True, text=True).stdout


def shares(text):
    found = dict.fromkeys([name for name, _ in PARTS] + ['else'], 0)
    for line in text.splitlines():
        match = re.match(r'\s*(\d+)\s+(\S+)\s+\[.\]\s+(.*)', line)
        if match and not OTHERS.search(match[2]):
            found[part_of(f'{match[2]} {match[3]}')] += int(match[1])
    whole = sum(found.values()) or 1
    return {name: count / whole for name, count in found.items() if count}


def run(request):
    rows = []
    try:
        for n, percent in QUICK if request.quick else SCENES:
            with tempfile.TemporaryDirectory() as folder:
                found = shares(samples(n, percent, 2 if request.quick else 10, folder))
            for name, share in sorted(found.items(), key=lambda item: -item[1]):
                rows.append({'scene': f'{n}², {percent:g} %', 'part': name, 'share': share})
                print(f'{n:6} {percent:5g} %  {100 * share:5.1f} %  {name}')
    except (FileNotFoundError, subprocess.CalledProcessError) as error:
        print(f'profile: perf is not there or may not be used: {error}', file=sys.stderr)
        return
    store = Store(request.json, 'profile', 2)
    store.document['rows'] = rows
    store.save()


QUESTION = Question('profile', "where the processor time of a cold solve goes, by Linux' perf", run, {}, {}, 'one small solve')
