"""Runs the commands that the pages show (blocks of `sh`) as a reader would type them, against an installation.

Usage: commands.py BUILD [--full] [PAGE...]

The blocks of a page run one after another in one shell, in a folder that has the page's own files, copies of examples/ and
integrations/ and the map `surface.gsf`, made by the command of how-to/file-to-report.md. A block after "`NAME`:" is written to that
file before. The next block of the page, if it is `text`, is what the commands print; ... in it stands for any text. A comment on the
line before a block says where that is not so:

  <!-- not run: REASON -->       it installs packages, builds the tree, takes hours
  <!-- run in full: REASON -->   it takes longer than a test of the middle tier may: with --full alone
  <!-- needs: NAME ... -->       not run where one of these programs, python:MODULE or pkg-config:NAME is missing

Blocks without a language show no commands, but for synopses, with [ and |.
"""

import argparse
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

import pages

MAP = pages.SOURCE / 'docs/how-to/file-to-report.md'
MARK = '-- block %d of the page ends --'
PROGRAMS = r'(roughcontact|roughcontact-bench|build/bin/\S+|cmake|ctest|cc|gfortran|pip|python3?|make|sudo|\S+\.sh|scripts/\S+)'


def is_here(name, environment=None):
    """environment: of the installation, which has packages of its own."""
    kind, _, module = name.partition(':')
    if kind == 'pkg-config':
        return shutil.which(kind) and subprocess.run([kind, '--exists', module], env=environment).returncode == 0
    return importlib.util.find_spec(module) if kind == 'python' else shutil.which(name)


def left_out(block, full, environment):
    """Why this block is not run here; empty: it is."""
    rule, _, stated = block.comment.partition(': ')
    if rule == 'not run':
        return stated
    if rule == 'run in full':
        return '' if full else f'with --full: {stated}'
    if rule == 'needs':
        absent = [name for name in stated.split() if not is_here(name, environment)]
        return f'there is no {", ".join(absent)}' if absent else ''
    return f'unknown comment: {block.comment}' if rule else ''


def matches(expected, printed):
    """Whether the text is as printed, ... for anything; spaces at the ends of lines do not count."""
    trim = lambda text: re.sub(r'[ \t]+$', '', text, flags=re.M).strip('\n')  # noqa: E731
    pattern = '.*?'.join(map(re.escape, trim(expected).split('...')))
    return re.fullmatch(pattern, trim(printed), re.S)


def without_language(found):
    """Blocks that show a command, not a synopsis, and would not be run."""
    return [
        block
        for block in found
        if not block.language and not re.search(r'\[|\|', block.text) and re.search(rf'^{PROGRAMS} ', block.text, re.M)
    ]


def links_badly(found):
    """Lines that link a shared library and do not say where the loader finds it, or leave module files of Fortran in the reader's folder."""
    for block in found:
        for line in block.text.replace('\\\n', ' ').splitlines() if block.language == 'sh' else ():
            linked = re.match(r'(cc|gfortran|mkoctfile) .*pkg-config .*--libs', line) and '-Wl,-rpath,' not in line
            if linked or re.match(r'gfortran .*_source', line) and ' -J ' not in line:
                yield f'{block.line}: no -Wl,-rpath or no -J in: {line}'


class Reader:
    """An installation, and somebody who types what pages say."""

    def __init__(self, build, scratch):
        self.scratch = scratch
        prefix = scratch / 'prefix'
        subprocess.run(['cmake', '--install', build, '--prefix', prefix], check=True, stdout=subprocess.DEVNULL)
        packages = next(prefix.rglob('roughcontact.pc')).parent
        (scratch / 'bin').mkdir()
        for program in ('sudo', 'apt-get', 'pip'):
            (scratch / 'bin' / program).write_text(f'#!/bin/sh\necho "{program}: mark this block as not run" >&2\nexit 1\n')
            (scratch / 'bin' / program).chmod(0o755)
        python = next(iter(prefix.rglob('roughcontact/__init__.py')), None)
        self.environment = {
            'PATH': f'{scratch}/bin:{prefix}/bin:{pathlib.Path(sys.executable).parent}:{os.environ["PATH"]}',
            'PKG_CONFIG_PATH': str(packages),
            'CMAKE_PREFIX_PATH': str(prefix),
            'LC_ALL': 'C.UTF-8',
            'PYTHONPATH': str(python.parent.parent) if python else '',
            'MPLBACKEND': 'agg',
        }
        making = re.search(r'^roughcontact (generate .* --output surface\.gsf)$', MAP.read_text(encoding='utf-8'), re.M)
        command = [prefix / 'bin/roughcontact', *making[1].split()]
        subprocess.run(command, cwd=scratch, env=self.environment, check=True, stdout=subprocess.DEVNULL)

    def run(self, page, found):
        """What each block printed, and what the shell said where one failed."""
        home = self.scratch / '-'.join(page.relative_to(pages.SOURCE).with_suffix('').parts)
        for folder in ('examples', 'integrations'):
            shutil.copytree(pages.SOURCE / folder, home / folder)
        shutil.copy(self.scratch / 'surface.gsf', home)
        for block in found:
            if block.name and block.language not in ('sh', 'text'):
                (home / block.name).write_text(block.text)
        folder = home / 'examples' if page.parent.name == 'examples' else home
        commands = [(k, block) for k, block in enumerate(found) if block.language == 'sh']
        script = '\n'.join(f'{block.text}echo "{MARK % k}" | tee /dev/stderr' for k, block in commands)
        done = subprocess.run(
            ['bash', '-euo', 'pipefail', '-c', script],
            cwd=folder,
            env={**self.environment, 'HOME': str(home)},
            text=True,
            capture_output=True,
            timeout=1500,
            stdin=subprocess.DEVNULL,
        )
        printed, rest, said = {}, done.stdout, done.stderr
        for k, block in commands:
            mark = MARK % k + '\n'
            if mark not in rest:
                return printed, f'{page}:{block.line}: exit code {done.returncode}\n{block.text}{rest}{said}'
            printed[k], _, rest = rest.partition(mark)
            said = said.partition(mark)[2]
        return printed, ''


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument('build', type=pathlib.Path)
    parser.add_argument('--full', action='store_true')
    parser.add_argument('pages', type=pathlib.Path, nargs='*')
    arguments = parser.parse_args()
    if not is_here('python:numpy'):
        print('skipped: no module named numpy')
        sys.exit(77)
    ran, excluded, compared, wrong = 0, [], 0, []
    with tempfile.TemporaryDirectory() as scratch:
        reader = Reader(arguments.build, pathlib.Path(scratch))
        for page in [page.resolve() for page in arguments.pages] or pages.pages():
            found = pages.blocks(page.read_text(encoding='utf-8'))
            wrong += [
                f'{page}:{block.line}: a command in a block without a language\n{block.text}'
                for block in without_language(found)
            ]
            wrong += [f'{page}:{each}' for each in links_badly(found)]
            reasons = {k: left_out(block, arguments.full, reader.environment) for k, block in enumerate(found) if block.language == 'sh'}
            excluded += [f'{page.relative_to(pages.SOURCE)}:{found[k].line}: {why}' for k, why in reasons.items() if why]
            kept = [block for k, block in enumerate(found) if not reasons.get(k)]
            if all(block.language != 'sh' for block in kept):
                continue
            printed, failure = reader.run(page, kept)
            wrong += [failure] if failure else []
            ran += len(printed)
            for k, text in printed.items():
                if k + 1 < len(kept) and kept[k + 1].language == 'text':
                    compared += 1
                    if not matches(kept[k + 1].text, text):
                        wrong.append(f'{page}:{kept[k].line}:\n{kept[k].text}prints\n{text}instead of\n{kept[k + 1].text}')
    print('\n'.join(wrong + excluded))
    print(f'{ran} blocks of commands were run, the output of {compared} compared, {len(excluded)} left out, {len(wrong)} wrong')
    return 1 if wrong or not ran else 0


if __name__ == '__main__':
    sys.exit(main())
