"""outdated.py [SOURCE]: which measured numbers in documents are older than the library in this folder (the tree of this file). A line for each
page and commit; exit status 1 if there are any that can be measured here: those of a device need one. Changed comments, messages
and scripts do not count, nor do commits whose message has a trailer "Measured-numbers: unchanged, REASON"; these are printed."""
import functools
import os
import re
import shutil
import subprocess
import sys

LIBRARY = ('src', 'backends', 'include')
DEVICE = 'docs/development/device.md'
COMMENT_OR_STRING = re.compile(rb'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"', re.DOTALL)
COMMIT = re.compile(r'(?:roughcontact [0-9.]+ \(|commit )([0-9a-f]{7,40})(-dirty)?\b')


def outdated(source, excused=None):
    """Lines on the pages with measured sections ("<!-- begin NAME -->") below docs. excused: a set, to which the commits with that trailer are added."""
    @functools.lru_cache(None)
    def git(*arguments):
        ran = subprocess.run(['git', '-C', source, *arguments], capture_output=True, text=True, check=False)
        return None if ran.returncode else ran.stdout.split()

    @functools.lru_cache(None)
    def code(commit, file):
        """What the compiler sees of a file, without space and without strings of three words or more: those are only read."""
        def kept(found):
            string = found[0].startswith(b'"') and (file.endswith('.txt') or len(found[0].split()) < 3)
            return found[0] if string else b''

        ran = subprocess.run(['git', '-C', source, 'show', f'{commit}:{file}'], capture_output=True, check=False)
        return b''.join(COMMENT_OR_STRING.sub(kept, ran.stdout).split())

    def changes(commit, file):
        """Whether a later commit changes this file's code, and does not say that numbers stay."""
        changing = {each for each in git('rev-list', f'{commit}..HEAD', '--', file) if code(f'{each}~', file) != code(each, file)}
        stay = changing & set(git('rev-list', '--grep=^Measured-numbers: unchanged, ', f'{commit}..HEAD'))
        if excused is not None:
            excused.update(stay)
        return changing != stay and code(commit, file) != code('HEAD', file)

    if not shutil.which('git') or git('rev-parse', '--show-prefix') != []:
        return [f'{source}: no history of git, so the age of the numbers is unknown']
    found = []
    for folder, _, names in sorted(os.walk(os.path.join(source, 'docs'))):
        for name in sorted(name for name in names if name.endswith('.md')):
            with open(os.path.join(folder, name), encoding='utf-8') as page:
                text = page.read()
            if not re.search('^<!-- begin ', text, re.MULTILINE):
                continue
            page = os.path.relpath(os.path.join(folder, name), source)
            commits = list(dict.fromkeys(COMMIT.findall(text)))
            if not commits:
                found.append(f'{page}: names no commit of the library')
            for commit, dirty in commits:
                if git('merge-base', '--is-ancestor', commit, 'HEAD') is None:
                    found.append(f'{page}: {commit}{dirty} is not in this history')
                    continue
                files = [file for file in git('diff', '--name-only', '--no-renames', commit, 'HEAD', '--', *LIBRARY)
                         if not file.endswith(('.md', '.py', '.sh')) and changes(commit, file)]
                since = git('rev-list', '--count', f'{commit}..HEAD', '--', *LIBRARY)[0]
                words = [f'{len(files)} files of {", ".join(LIBRARY)} differ, by {since} commits'] if files else []
                words += ['measured with changes that no commit has'] if dirty else []
                if words:
                    found.append(f'{page}: {commit}{dirty}: {"; ".join(words)}')
    return found


def check(source=os.path.dirname(os.path.dirname(os.path.abspath(__file__)))):
    excused = set()
    lines = outdated(source, excused)
    for commit in sorted(excused):
        subprocess.run(['git', '-C', source, 'log', '-1', '--format=%h, %s: %(trailers:key=Measured-numbers,separator= )', commit], check=True)
    here = [line for line in lines if shutil.which('nvidia-smi') or not line.startswith(DEVICE)]
    print('\n'.join(lines + ([] if here else ['all numbers that can be measured here are of this library'])))
    sys.exit(bool(here))


if __name__ == '__main__':
    check(*sys.argv[1:])
