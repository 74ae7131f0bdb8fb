"""The manual page has what the command says of itself: its version, every subcommand with its options, and the library's options.

Usage: manual.py COMMAND
"""
import re
import subprocess
import sys


def run(*arguments):
    return subprocess.run([sys.argv[1], *arguments], check=True, capture_output=True, text=True).stdout


def expected(*path):
    """(the heading, the options) of the commands at and below path."""
    said = run(*path, '--help')
    options = re.findall(r'^  (--[a-zA-Z0-9-]+)', said, re.M)
    _, _, below = said.partition('\nSubcommands:\n')
    names = re.findall(r'^  (\w+)', below, re.M)
    if path and (options or names):
        yield ' '.join(path), options
    for name in names:
        yield from expected(*path, name)


def main():
    page = run('manual').replace('\\-', '-')
    _, *sections = re.split(r'^\.S[SH] ', page, flags=re.M)
    found = {}
    for section in sections:
        head, _, text = section.partition('\n')
        found[head.strip('"')] = re.findall(r'^\.B (\S+)', text, re.M)
    wanted = list(expected())
    assert {'solve', 'generate rmd', 'analyze'} <= {name for name, _ in wanted}
    for name, options in wanted:
        missing = set(options) - set(found[name])
        assert not missing, f'{name}: {sorted(missing)}'
    assert set(found['What the library has']) == {'backends', 'solvers', 'kernels', 'options', 'formats'}
    keys = [line.split()[0] for line in run('options').splitlines()[1:]]
    assert re.findall(r'^\.BR (\S+) "', page, re.M) == keys, keys
    assert f'"roughcontact {run("--version").split()[1]}"' in page
    lines = [line for line in page.splitlines() if line.startswith(('.', "'"))]
    assert all(re.match(r'\.(TH|SH|SS|PP|TP|B|BR|I)\b', line) for line in lines), lines
    print(f'{len(wanted)} commands and {len(keys)} options are in the page')


if __name__ == '__main__':
    main()
