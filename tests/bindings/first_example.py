#!/usr/bin/env python3
"""The first example of a page of documentation works as printed: the file is put into an empty folder, the commands below it
are run there with an empty environment but for the prefix the library is installed to, and print what the page says.

first_example.py BUILD [--alone FOLDER PROGRAM] PAGE...
A page has `NAME`: and a code block, then a block of sh, then a block of text. --alone: an example with a CMakeLists.txt of
its own builds and runs in the same way.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def first_example(page):
    """(name, contents, commands, expected output)"""
    found = re.search(r'`([\w.]+)`:\n\n```\w+\n(.*?)^```\n.*?^```sh\n(.*?)^```\n.*?^```text\n(.*?)^```\n', page, re.S | re.M)
    if not found:
        sys.exit('no example of this form')
    return found.groups()


def run_alone(source, program, prefix, folder, environment):
    for command in (['cmake', '-S', source, '-B', str(folder), f'-DCMAKE_PREFIX_PATH={prefix}'],
                    ['cmake', '--build', str(folder)], [str(folder / program)]):
        run = subprocess.run(command, env={**environment, 'HOME': str(folder)}, text=True, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)
        if run.returncode:
            return [f'{" ".join(command)} ended with {run.returncode}:\n{run.stdout}']
    print(f'{program}, built alone:\n{run.stdout}')
    return []


def main():
    build, alone, pages = sys.argv[1], None, sys.argv[2:]
    if pages[0] == '--alone':
        alone, pages = pages[1:3], pages[3:]
    failures = []
    with tempfile.TemporaryDirectory() as scratch:
        prefix = pathlib.Path(scratch) / 'prefix'
        subprocess.run(['cmake', '--install', build, '--prefix', str(prefix)], check=True, stdout=subprocess.DEVNULL)
        packages = next(prefix.rglob('roughcontact.pc')).parent
        environment = {'PATH': os.environ['PATH'], 'PKG_CONFIG_PATH': str(packages), 'LD_LIBRARY_PATH': str(packages.parent)}
        if alone:
            failures += run_alone(*alone, prefix, pathlib.Path(scratch) / 'alone', environment)
        for page in map(pathlib.Path, pages):
            name, contents, commands, expected = first_example(page.read_text())
            folder = pathlib.Path(scratch) / page.stem
            folder.mkdir()
            (folder / name).write_text(contents)
            run = subprocess.run(['bash', '-euc', commands], cwd=folder, env={**environment, 'HOME': str(folder)}, text=True,
                                 stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            print(f'{page.name}: {name}\n{run.stdout}{run.stderr}')
            if run.returncode or run.stdout != expected:
                failures.append(f'{page.name}: ended with {run.returncode}; expected\n{expected}')
    print('\n'.join(failures) or 'as printed')
    return 1 if failures else 0


sys.exit(main())
