"""Pages whose numbers are older than the library are found; others are not."""
import os
import shutil
import subprocess
import sys
import tempfile

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', '..', '..', 'bench'))

from outdated import outdated


def git(*arguments):
    return subprocess.run(['git', '-C', folder, '-c', 'user.name=test', '-c', 'user.email=test@example.invalid', *arguments], check=True,
                          capture_output=True, text=True).stdout.strip()


def write(name, text):
    os.makedirs(os.path.dirname(os.path.join(folder, name)), exist_ok=True)
    with open(os.path.join(folder, name), 'w') as file:
        file.write(text)


def commit(*files, message='change'):
    for name, text in files:
        write(name, text)
    git('add', '.')
    git('commit', '-qm', message)
    return git('rev-parse', '--short=12', 'HEAD')


def page(words, name='docs/page.md'):
    return name, f'Words.\n\n<!-- begin provenance -->\n{words}\n<!-- end provenance -->\n'


if not shutil.which('git'):
    sys.exit(77)
with tempfile.TemporaryDirectory() as folder:
    assert 'no history' in outdated(folder)[0], outdated(folder)
    git('init', '-q')
    first = commit(('src/a.cpp', 'int a; auto help = "a limit of " "all the residuals";\n'), ('docs/other.md', 'No numbers.\n'))
    commit(page(f'roughcontact 0.1.0 ({first}); 2026-01-01.'), page(f'On a device, commit {first}; more.', 'docs/development/device.md'))
    assert outdated(folder) == [], outdated(folder)
    commit(('src/a.cpp', '/* why\n*/ int a;  // "one"\nauto help = "the most that residuals may be";\n'), ('backends/README.md', 'Words.\n'))
    assert outdated(folder) == [], outdated(folder)
    stays = commit(('src/a.cpp', 'int a = 0;\n'), message='change\n\nMeasured-numbers: unchanged, it was 0')
    excused = set()
    assert outdated(folder, excused) == [] and [each[:12] for each in excused] == [stays], (outdated(folder), excused)
    commit(('include/b.h', 'int b;\n'), ('backends/c.cpp', 'auto c = "// ";\n'))
    commit(('src/a.cpp', 'int b;\n'))
    assert outdated(folder) == [f'{name}: {first}: 3 files of src, backends, include differ, by 4 commits'
                                for name in ('docs/page.md', 'docs/development/device.md')], outdated(folder)
    now = git('rev-parse', '--short=12', 'HEAD')
    commit(page(f'roughcontact 0.1.0 ({now}-dirty)'), page('commit 0123456789ab', 'docs/development/device.md'), page('Of some day.', 'docs/third.md'))
    assert outdated(folder) == [f'docs/page.md: {now}-dirty: measured with changes that no commit has', 'docs/third.md: names no commit of the library',
                                'docs/development/device.md: 0123456789ab is not in this history'], outdated(folder)
