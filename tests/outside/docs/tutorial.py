"""Builds and runs the programs of docs/tutorial.md against an installation, as the page says: all programs of a section print the text that
stands below them. Languages whose compiler is missing, and Python where the installation has no package, are left out.

Usage: tutorial.py BUILD [--update]
--update writes what the C programs print into the document.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

import commands
import pages

PATH = '-Wl,-rpath,$(pkg-config --variable=libdir roughcontact)'
WAYS = {  # what it needs, the program's file, and how it runs
    'c': ('cc', 'program.c', 'cc -std=c99 -Wall -Wextra -pedantic -Werror program.c -o program '
          f'$(pkg-config --cflags --libs roughcontact) {PATH} -lm; ./program'),
    'fortran': ('gfortran', 'program.f90', 'gfortran -J . $(pkg-config --variable=fortran_source roughcontact-fortran) program.f90 -o program '
                f'$(pkg-config --libs roughcontact) {PATH}; ./program'),
    'python': ('python3', 'program.py', f'[ -z "$PYTHONPATH" ] || {sys.executable} program.py'),
}


def main():
    document, compared = pages.SOURCE / 'docs/tutorial.md', 0
    text = document.read_text(encoding='utf-8')
    with tempfile.TemporaryDirectory() as scratch:
        reader = commands.Reader(pathlib.Path(sys.argv[1]), pathlib.Path(scratch))
        for title, section in re.findall(r'^## (\d[^\n]*)\n(.*?)(?=^## )', text, re.M | re.S):
            *programs, expected = pages.blocks(section)
            assert expected.language == 'text' and programs, f'{title}: programs, then what they print'
            for program in programs:
                needs, name, way = WAYS[program.language]
                (reader.scratch / name).write_text(program.text)
                done = subprocess.run(['bash', '-euc', way], cwd=scratch, env=reader.environment, capture_output=True, text=True)
                if not commands.is_here(needs) or not done.returncode and not done.stdout:
                    print(f'{title}: {program.language} is not here, left out')
                elif '--update' in sys.argv and program.language == 'c':
                    text = text.replace(expected.text, done.stdout)
                    expected.text = done.stdout
                elif done.returncode or done.stdout != expected.text:
                    sys.exit(f'FAILED: {title}, {program.language} prints\n{done.stdout}{done.stderr}instead of\n{expected.text}')
                else:
                    compared += 1
    if '--update' in sys.argv:
        document.write_text(text, encoding='utf-8')
    print(f'{compared} programs print what the tutorial says')
    return not compared and '--update' not in sys.argv


if __name__ == '__main__':
    sys.exit(main())
