"""The program under test: BUILD is the first argument of every test here. Times decide nothing."""
import csv
import os
import re
import shutil
import subprocess
import sys

BUILD = sys.argv[1]
PROGRAM = os.path.join(BUILD, 'bin', 'roughcontact-bench')
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..', 'bench'))

if 'RC_BENCH_BUILD' not in os.environ:  # the test runs in the program's environment
    with open(PROGRAM) as launcher:
        start = launcher.read().split('\nexec ')[0]
    os.execvp('sh', ['sh', '-c', f'{start}\nexec {sys.executable} -B {os.path.abspath(sys.argv[0])} {" ".join(sys.argv[1:])}'])

from json_tables import load
from tables import table


def run(*arguments):
    """What the program printed."""
    return subprocess.run([PROGRAM, *arguments], check=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout


def counts(output):
    """(measured, failed, measured before)"""
    return [int(count) for count in re.search(r'(\d+) measured, (\d+) of them failed; (\d+) measured before', output).groups()]


def sections(folder, page):
    """What stands between the markers of a page, with the tables of its files."""
    with open(os.path.join(folder, page + '.md'), encoding='utf-8') as file:
        found = re.findall(r'<!-- begin (\S+)(?: as \S+)? -->\n(.*?)<!-- end .*? -->', file.read(), re.DOTALL)

    def shown(match):
        with open(os.path.join(folder, match[1]), encoding='utf-8', newline='') as file:
            titles, *lines = csv.reader(file)
        return table(titles, lines)

    return {name: re.sub(r'\[.*?\]\((\S+\.csv)\)', shown, text) for name, text in found}


def remade(page, *options):
    """(output, sections) of `documents PAGE --quick`, with nothing measured before."""
    folder = os.path.join(BUILD, f'{page}-quick')
    shutil.rmtree(folder, ignore_errors=True)
    output = run('documents', page, '--quick', *options)
    return output, sections(folder, page)


def check_pictures(folder, *names):
    for name in names if shutil.which('gnuplot') else ():
        assert os.path.getsize(os.path.join(folder, name + '.png')) > 5000, name
