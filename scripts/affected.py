#!/usr/bin/env python3
"""affected.py [PATH...]: the folders below tests/ that test these files, by the table of CONTRIBUTING.md, a line each; "." is all of
them. Without a path: what differs from the last commit, or if nothing does what that commit changed."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
OF_SRC = ['scenes', 'unit']


def table():
    """{path: test folders}"""
    rows = re.findall(r'^\| (`.*`) \| (`.*`) \|$', (ROOT / 'CONTRIBUTING.md').read_text().partition('| changed |')[2].partition('\n\n')[0], re.M)
    return {path: re.findall('`(.*?)`', tests) for paths, tests in rows for path in re.findall('`(.*?)`', paths)}


def git(*arguments):
    return subprocess.run(['git', '-C', ROOT, *arguments], check=True, capture_output=True, text=True).stdout.splitlines()


def changed():
    paths = git('diff', '--name-only', 'HEAD') + git('ls-files', '--others', '--exclude-standard')
    return paths or git('diff', '--name-only', 'HEAD~1', 'HEAD')


def tests_of(path, rows):
    parents = [path, *map(str, pathlib.PurePosixPath(path).parents)]
    if parents[-2] == 'tests':  # its own family, unless families share it
        return [each.relative_to(ROOT / 'tests').as_posix() for each in map(ROOT.joinpath, parents[1:-2])
                if (each / 'CMakeLists.txt').exists()][:1] or ['.']
    found = next((rows[each] for each in parents if each in rows), None)
    if found is None:
        return ['.']
    return found + (OF_SRC if path.startswith('src/') else [])


def main():
    rows = table()
    missing = [each for tests in rows.values() for each in tests if not (ROOT / 'tests' / each / 'CMakeLists.txt').exists()]
    missing += [each for each in rows if not (ROOT / each).exists()]
    if missing or not rows:
        sys.exit(f"CONTRIBUTING.md names what is not there: {', '.join(missing) or 'no table'}")
    folders = {each for path in sys.argv[1:] or changed() for each in tests_of(path, rows)}
    print('\n'.join(['.'] if '.' in folders else sorted(folders)))


if __name__ == '__main__':
    main()
