"""Builds and runs the programs of docs/tutorial.md against an installation, with nothing but PATH in the environment: all programs
of a section print the text that stands below them. Python programs run where the installation has the Python package.

Usage: tutorial.py SOURCE BUILD CC FC [--update]
FC may be empty. --update writes what the C programs print into the document.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def run(arguments, environment, folder):
    done = subprocess.run(arguments, env=environment, cwd=folder, capture_output=True, text=True)
    if done.returncode:
        sys.exit(f'FAILED: {" ".join(map(str, arguments))}\n{done.stdout}{done.stderr}')
    return done.stdout


class Installation:
    def __init__(self, prefix, cc, fc):
        self.prefix, self.cc, self.fc = prefix, cc, fc
        self.pkgconfig = next(prefix.rglob('roughcontact.pc')).parent
        self.environment = {'PATH': os.environ['PATH'], 'PKG_CONFIG_PATH': str(self.pkgconfig)}
        self.python = next(iter(prefix.rglob('roughcontact/__init__.py')), None)

    def flags(self, *arguments):
        return run(['pkg-config', *arguments], self.environment, self.prefix).split()

    def output(self, language, program, folder):
        """What the program prints; None where the language is not here."""
        libraries = [*self.flags('--cflags', '--libs', 'roughcontact'), f'-Wl,-rpath,{self.pkgconfig.parent}', '-lm']
        if language == 'c':
            (folder / 'program.c').write_text(program)
            strict = ['-std=c99', '-Wall', '-Wextra', '-pedantic', '-Werror']
            run([self.cc, *strict, 'program.c', '-o', 'program', *libraries], self.environment, folder)
        elif language == 'fortran' and self.fc:
            (folder / 'program.f90').write_text(program)
            module = self.flags('--variable=fortran_source', 'roughcontact-fortran')
            run([self.fc, *module, 'program.f90', '-o', 'program', *libraries], self.environment, folder)
        elif language == 'python' and self.python:
            (folder / 'program.py').write_text(program)
            paths = {'PYTHONPATH': str(self.python.parent.parent), 'LD_LIBRARY_PATH': str(self.pkgconfig.parent)}
            return run([sys.executable, 'program.py'], {**self.environment, **paths}, folder)
        else:
            return None
        return run([folder / 'program'], self.environment, folder)


def main():
    source, build = map(pathlib.Path, sys.argv[1:3])
    document = source / 'docs/tutorial.md'
    text = document.read_text()
    compared = 0
    with tempfile.TemporaryDirectory() as scratch:
        prefix = pathlib.Path(scratch) / 'prefix'
        subprocess.run(['cmake', '--install', build, '--prefix', prefix], check=True, stdout=subprocess.DEVNULL)
        installation = Installation(prefix, *sys.argv[3:5])
        for title, section in re.findall(r'^## (\d[^\n]*)\n(.*?)(?=^## )', text, re.M | re.S):
            *programs, (kind, expected) = re.findall(r'^```(\w+)\n(.*?)^```$', section, re.M | re.S)
            assert kind == 'text' and programs, f'{title}: programs, then what they print'
            for language, program in programs:
                with tempfile.TemporaryDirectory(dir=scratch) as folder:
                    printed = installation.output(language, program, pathlib.Path(folder))
                if printed is None:
                    print(f'{title}: {language} is not here, left out')
                elif '--update' in sys.argv and language == 'c':
                    text = text.replace(expected, printed)
                    expected = printed
                elif printed != expected:
                    sys.exit(f'FAILED: {title}, {language} prints\n{printed}instead of\n{expected}')
                else:
                    print(f'{title}: {language} ok')
                    compared += 1
    if '--update' in sys.argv:
        document.write_text(text)
    elif not compared:
        sys.exit('FAILED: no program was found')


if __name__ == '__main__':
    main()
