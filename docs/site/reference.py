"""Writes the pages of the reference from the sources: reference.py SOURCE FOLDER."""

import pathlib
import re
import sys

MODULES = {
    'roughcontact': 'All that solves: `use roughcontact`.',
    'roughcontact_surface': 'Makes and judges surfaces: `use roughcontact_surface`.',
    'roughcontact_formats': 'Reads surface files: `use roughcontact_formats`.',
    'roughcontact_flow': 'Flow through gaps: `use roughcontact_flow`.',
}
SHOWN = 'briefdescription detaileddescription innerclass public-attrib enum define typedef func var user-defined'
SOLVING = ('contacts', 'histories', 'derivatives', 'direct', 'laws', 'products', 'analysis', 'options', 'arrays', 'errors', 'strings')
PYTHON = ('roughcontact', 'roughcontact.surface', 'roughcontact.analysis', 'roughcontact.direct', 'roughcontact.plot')
BEGINS = re.compile(
    r'^  (?:(?:pure|elemental|recursive|impure) )*(?:[a-z][\w()*:=, ]* )?(?:subroutine|function) (rcf?_\w+)', re.I
)


def section(title, directive, *options):
    lines = [f'.. {directive}', *(f'   :{option}' for option in options)]
    return '\n'.join(['', f'## {title}', '', '```{eval-rst}', *lines, '```', ''])


def c_page(headers):
    """One section a header, by Doxygen's XML."""
    text = '# C\n\nEvery function, struct and constant of the public headers, from their comments.\n'
    for header in sorted(headers.glob('*.h'), key=lambda each: (each.stem != 'roughcontact', each.stem)):
        text += section(header.name, f'doxygenfile:: {header.name}', f'sections: {SHOWN}')
    return text


def procedures(source):
    """(name, comment, signature with the arguments' declarations) of each public procedure of a Fortran module."""
    lines = source.split('\n')
    public = set(re.findall(r'rcf?_\w+', ' '.join(re.findall(r'public :: ((?:.*&\n)*.*)', source))))
    for k, line in enumerate(lines):
        begin = BEGINS.match(line)
        if not begin or begin[1] not in public:
            continue
        first = k
        while lines[first - 1].startswith('  ! '):
            first -= 1
        last = k
        while lines[last].rstrip().endswith('&'):
            last += 1
        signature = lines[k : last + 1]
        while re.match(r'^    ([a-z]\w*(\(.*?\))?.*::|use |import|!)', lines[last + 1]):
            last += 1
            if 'intent(' in lines[last] or 'optional' in lines[last]:
                signature.append(lines[last])
        yield begin[1], ' '.join(each[4:] for each in lines[first:k]), '\n'.join(each[2:] for each in signature)


def fortran_page(folder):
    text = (
        '# Fortran\n\n[Fortran](../docs/fortran.md) has examples and rules. Below are the procedures `rcf_...`, from their sources; '
        'the layer `rc_...` has the functions of [C](c.md) name for name.\n'
    )
    files = [('roughcontact', folder / f'roughcontact_{name}.f90') for name in SOLVING]
    files += [(name, folder / f'{name}.f90') for name in MODULES if name != 'roughcontact']
    seen = set()
    for module, file in files:
        source = file.read_text()
        if module not in seen:
            text += f'\n## {module}\n\n{MODULES[module]}\n'
            seen.add(module)
        found = list(procedures(source))
        if found:
            head = ' '.join(line[2:] for line in source.split('\nmodule ')[0].split('\n') if line.startswith('! '))
            text += f'\n{head}\n'
        for name, comment, signature in found:
            text += f'\n### {name}\n\n```fortran\n{signature}\n```\n\n{comment}\n'
    return text


def python_page():
    text = '# Python\n\n[Python](../docs/python.md) has examples and conventions. Below is every public name, from its docstring.\n'
    for name in PYTHON:
        text += section(name, f'automodule:: {name}', *(['imported-members:'] if name == 'roughcontact' else []))
    return text


def main():
    source, folder = map(pathlib.Path, sys.argv[1:3])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / 'c.md').write_text(c_page(source / 'include/roughcontact'))
    (folder / 'fortran.md').write_text(fortran_page(source / 'bindings/fortran'))
    (folder / 'python.md').write_text(python_page())


if __name__ == '__main__':
    main()
