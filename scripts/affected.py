#!/usr/bin/env python3
"""affected.py [PATH...]: the folders below tests/ that test these files, by the table of CONTRIBUTING.md, a line each; "." is all of
them. Behind `contract/pairs` stands the solver if one alone has changed, behind `outside/docs` the pages if nothing else has changed that
is tested there. Without a path: what differs from the last commit, or if nothing does what that commit changed."""
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


def solver_of(path):
    """The solver whose own file this is; None: others have it too."""
    found = re.match(r'src/solvers/(\w+)', path)
    names = dict(re.findall(r'^RC_SOLVER(?:_IN_PLACE)?\((\w+), "([\w-]+)"', (ROOT / 'src/solvers/solvers.def').read_text(), re.M))
    return names.get(found[1]) if found else None


def detail(folder, paths):
    """What of a folder is enough for these paths, which are all that lead to it; empty: all of it."""
    if folder == 'contract/pairs' and len({solver_of(path) for path in paths}) == 1:
        return [solver_of(paths[0]) or '']
    if folder == 'outside/docs' and all(path.endswith('.md') for path in paths):
        return [path for path in paths if (ROOT / path).exists()]
    return []


def main():
    rows = table()
    missing = [each for tests in rows.values() for each in tests if not (ROOT / 'tests' / each / 'CMakeLists.txt').exists()]
    missing += [each for each in rows if not (ROOT / each).exists()]
    if missing or not rows:
        sys.exit(f"CONTRIBUTING.md names what is not there: {', '.join(missing) or 'no table'}")
    leads = {}
    for path in sys.argv[1:] or changed():
        for folder in tests_of(path, rows):
            leads.setdefault(folder, []).append(path)
    for folder in ['.'] if '.' in leads else sorted(leads):
        print(' '.join([folder, *detail(folder, leads[folder])]).strip())


if __name__ == '__main__':
    main()
