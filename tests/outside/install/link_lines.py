"""Runs the lines of the documents that compile or link a program, as they are written, in an installation that no loader knows, with
nothing but PATH and PKG_CONFIG_PATH in the environment. Programs are those of the document, or of examples/. Each must then run.

Usage: link_lines.py SOURCE BUILD FC MKOCTFILE
FC and MKOCTFILE may be empty: then their lines are left out.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

DOCUMENTS = ['README.md', 'docs/install.md', 'docs/fem.md', 'docs/fortran.md', 'docs/octave.md', 'docs/tutorial.md', 'examples/README.md']
ENDINGS = {'c': 'c', 'fortran': 'f90'}
COMMANDS = {'cc': True, 'gfortran': None, 'mkoctfile': None, 'src=$(pkg-config': True}


def check_as_written(source):
    """Every line that links a shared library says where the loader finds it, and module files of Fortran have a folder of their own."""
    for document in sorted(source.glob('**/*.md')):
        if any(part.startswith('build') for part in document.relative_to(source).parts):
            continue
        for block in re.findall(r'^```sh\n(.*?)^```$', document.read_text(), re.M | re.S):
            for line in lines_of(block):
                if re.match(r'(cc|gfortran|mkoctfile) ', line) and re.search(r'pkg-config .*--libs', line) and '-Wl,-rpath,' not in line:
                    sys.exit(f'FAILED: {document}: no -Wl,-rpath in: {line}')
                if line.startswith('gfortran ') and '_source' in line and ' -J ' not in line:
                    sys.exit(f'FAILED: {document}: no -J in: {line}')


def lines_of(block):
    return block.replace('\\\n', ' ').splitlines()


def program_for(name, latest, source):
    """The text of a program that a line compiles: the example of that name, or the document's program before the line."""
    example = source / 'examples' / name
    if example.exists():
        return example.read_text()
    return latest.get(name.rsplit('.')[-1], 'int main(void) { return 0; }\n')


def main():
    source, build = map(pathlib.Path, sys.argv[1:3])
    COMMANDS['gfortran'], COMMANDS['mkoctfile'] = sys.argv[3:5]
    check_as_written(source)
    ran = 0
    with tempfile.TemporaryDirectory() as scratch:
        prefix = pathlib.Path(scratch) / 'prefix'
        subprocess.run(['cmake', '--install', build, '--prefix', prefix], check=True, stdout=subprocess.DEVNULL)
        pkgconfig = next(prefix.rglob('roughcontact.pc')).parent
        environment = {'PATH': os.environ['PATH'], 'PKG_CONFIG_PATH': str(pkgconfig), 'HOME': scratch}

        def run(line, folder):
            done = subprocess.run(['bash', '-euc', line], env=environment, cwd=folder, capture_output=True, text=True)
            if done.returncode:
                sys.exit(f'FAILED: {document}: {line}\n{done.stdout}{done.stderr}')

        for document in DOCUMENTS:
            text = (source / document).read_text()
            if re.search(r'^\s*sudo ', text, re.M):
                sys.exit(f'FAILED: {document} has a sudo')
            folder = pathlib.Path(scratch) / document.replace('/', '-')
            folder.mkdir()
            (folder / 'map.txt').write_text('0 1 2\n3 4 5\n')
            latest, variables = {}, ''
            for language, block in re.findall(r'^```(\w+)\n(.*?)^```$', text, re.M | re.S):
                if language in ENDINGS and ('main' in block or 'end program' in block):
                    latest[ENDINGS[language]] = block
                if language != 'sh':
                    continue
                for line in lines_of(block):
                    if 'pkg-config --' not in line or not COMMANDS.get(line.split()[0]):
                        continue
                    if line.startswith('src='):
                        variables = line + '; '
                        continue
                    for name in re.findall(r'(?<= )(\w+\.(?:c|f90))\b', line):
                        (folder / name).write_text(program_for(name, latest, source))
                    run(variables + line, folder)
                    made = folder / re.search(r'-o (\S+)', line)[1]
                    if not made.name.endswith('.mex'):
                        run(f'./{made.name}' + (' map.txt 1e-6' if made.name == 'read_surface' else ''), folder)
                    print(f'{document}: {made.name}')
                    ran += 1
    if ran < 8:
        sys.exit(f'FAILED: only {ran} lines were found')


if __name__ == '__main__':
    main()
