#!/usr/bin/env python3
"""Compares Fortran modules with a C header: functions and their arguments, constants, struct members in order, and, where
compilers are given, sizes, offsets and default values as the compilers see them.

drift.py HEADER MODULE... [--after MODULE...] [--cc CC] [--fc FC] [--self-test]
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

C_SCALARS = {'char': 'char', 'int32_t': 'i32', 'uint32_t': 'i32', 'rc_status': 'i32', 'int64_t': 'i64', 'uint64_t': 'i64', 'size_t': 'size', 'double': 'f64'}
F_SCALARS = {'integer(c_int32_t)': 'i32', 'integer(rc_status)': 'i32', 'integer(c_int64_t)': 'i64',
             'integer(c_size_t)': 'size', 'real(c_double)': 'f64', 'type(c_ptr)': 'ptr', 'type(c_funptr)': 'function'}


def split_outside_parentheses(text):
    return [part.strip() for part in re.split(r',(?![^()]*\))', text) if part.strip()]


class Header:
    """What the C header declares, in words that both languages share."""

    def __init__(self, text):
        text = re.sub(r'/\*.*?\*/', ' ', text, flags=re.S)
        self.strings = dict(re.findall(r'^#define (RC_OPT_\w+) "(.*)"', text, re.M))
        self.constants = {k: int(v) for k, v in re.findall(r'^#define (RC_\w+) (\d+)', text, re.M)}
        self.with_init = set(re.findall(r'^#define RC_(\w+)_INIT\b', text, re.M))
        text = re.sub(r'^#(.*\\\n)*.*$', '', text, flags=re.M)
        for body in re.findall(r'enum \{(.*?)\}', text, re.S):
            self.constants.update((k, int(v)) for k, v in re.findall(r'(\w+)\s*=\s*(-?\d+)', body))
        self.callbacks = set(re.findall(r'typedef [^;]*?\(\*(\w+)\)', text))
        structs = re.findall(r'struct (rc_\w+) \{(.*?)\n\}', text, re.S)
        self.struct_names = {name for name, _ in structs}
        self.structs = {name: self.members(body) for name, body in structs}
        self.functions = {}
        for result, name, arguments in re.findall(r'RC_API ([^(;]*?)(\w+)\(([^;]*)\);', text):
            result = '' if result.strip() == 'void' else self.kind(result + ' x', False)[1].split()[0]
            arguments = [] if arguments.strip() == 'void' else [self.kind(a, True) for a in split_outside_parentheses(arguments)]
            self.functions[name] = (result, arguments)

    def kind(self, declaration, argument):
        """(name, kind) of "const double *out" and the like; an argument's kind also says how it is passed."""
        callback = re.search(r'\(\*(\w+)\)', declaration)
        if callback:
            return callback[1], 'function'
        const, base, stars, name, size = re.fullmatch(r'\s*(const )?\s*(\w+)\s*(\**)\s*(\w+)(?:\[(\w+)\])?\s*', declaration).groups()
        if base in self.callbacks:
            return name, 'function value' if argument else 'function'
        if not stars:
            scalar = C_SCALARS[base] + (f'[{self.constants.get(size, size)}]' if size else '')
            return name, scalar + ' value' if argument else scalar
        if not argument:
            return name, 'ptr'
        if stars == '**':
            return name, 'ptr out'
        if base == 'char':
            return name, 'char in'
        if base in self.struct_names:
            return name, f'{base} {"in" if const else "out"}'
        return name, f'{C_SCALARS[base]} {"in" if const else "out"}' if base in C_SCALARS else 'ptr value'

    def members(self, body):
        found = []
        for declaration in body.split(';'):
            declaration = ' '.join(declaration.split())
            if '(*' in declaration:
                found.append(self.kind(declaration, False))
            elif declaration:
                first, *rest = split_outside_parentheses(declaration)
                base = re.match(r'(?:const )?\w+', first)[0]
                found += [self.kind(d, False) for d in [first] + [f'{base} {r}' for r in rest]]
        return found


class Module:
    """The same of Fortran modules."""

    def __init__(self, text):
        self.names = re.findall(r'^module (\w+)', text, re.M)
        text = re.sub(r'!.*', '', text)
        text = re.sub(r'&\s*\n\s*', ' ', text)
        parameters = [p for line in re.findall(r'^.*\bparameter :: (.*)$', text, re.M) for p in line.split(',')]
        pairs = [[side.strip() for side in p.split('=')] for p in parameters]
        self.strings = {k: v.strip("'") for k, v in pairs if v.startswith("'")}
        self.constants = {k: int(v) for k, v in pairs if re.fullmatch(r'-?\d+', v)}
        self.structs = {}
        for name, body in re.findall(r'type, bind\(c\) :: (\w+)\n(.*?)end type', text, re.S):
            self.structs[name] = [m for line in body.splitlines() if line.strip() for m in self.declaration(line)]
        self.functions = {}
        pattern = r'^ {4}(subroutine|[^\n]* function) (rc_\w+)\(([^)]*)\) bind\(c\); import\n(.*?)end (?:subroutine|function)'
        for kind, name, arguments, body in re.findall(pattern, text, re.M | re.S):
            declared = dict(d for line in body.splitlines() if line.strip() for d in self.declaration(line))
            result = '' if kind == 'subroutine' else F_SCALARS[kind.split()[0]]
            self.functions[name] = (result, [(a.strip(), declared.get(a.strip())) for a in arguments.split(',') if a.strip()])

    def declaration(self, line):
        head, names = line.split('::')
        base, *attributes = split_outside_parentheses(head)
        kind = 'char' if base.startswith('character') else F_SCALARS.get(base) or base[5:-1]
        passed = {'value': ' value', 'intent(in)': ' in', 'intent(out)': ' out', 'intent(inout)': ' out'}
        how = ''.join(passed.get(a, '') for a in attributes)
        for name in split_outside_parentheses(names):
            name, size = re.match(r'(\w+)(?:\((\w+)\))?', name).groups()
            yield name, kind + how if how or not size else f'{kind}[{self.constants.get(size, size)}]'


def differences(header, module):
    for what in ('functions', 'structs', 'constants', 'strings'):
        ours, theirs = getattr(header, what), getattr(module, what)
        for name in sorted(ours.keys() | theirs.keys()):
            if ours.get(name) != theirs.get(name):
                yield f'{what}: {name}: header {ours.get(name)}, Fortran {theirs.get(name)}'


def run_probe(folder, compiler, flags, file, source):
    (folder / file).write_text(source)
    subprocess.run([compiler, *flags, str(folder / file), '-o', str(folder / 'probe')], check=True, cwd=folder)
    return sorted(' '.join(line.split()) for line in subprocess.check_output(folder / 'probe', text=True).splitlines())


def c_layout(folder, header, path, cc):
    lines = []
    for name, members in header.structs.items():
        macro = name[3:].upper()
        initial = f'RC_{macro}_INIT' if macro in header.with_init else f'{{ sizeof({name}) }}'
        lines.append(f'{{ union {{ {name} s; unsigned char b[sizeof({name})]; }} x = {{ {initial} }}; size_t i;')
        lines.append(f'printf("{name} size %zu\\n{name} default ", sizeof x.s);')
        lines.append('for (i = 0; i < sizeof x.b; ++i) printf("%02x", x.b[i]); printf("\\n");')
        lines += [f'printf("{name} {m} %zu\\n", offsetof({name}, {m}));' for m, _ in members]
        lines.append('}')
    source = f'#include <stdio.h>\n#include "{path.resolve()}"\nint main(void) {{\n' + '\n'.join(lines) + '\nreturn 0; }\n'
    return run_probe(folder, cc, [], 'probe.c', source)


def fortran_layout(folder, module, files, fc):
    declarations, lines = [], []
    for name, members in module.structs.items():
        declarations.append(f'type({name}), target :: v_{name}')
        lines.append(f"print '(a, i0)', '{name} size ', c_sizeof(v_{name})")
        lines.append(f"print '(a, *(z2.2))', '{name} default ', transfer(v_{name}, [0_c_int8_t])")
        for m, kind in members:
            first = f'{m}(1)' if '[' in kind else m
            lines.append(f"print '(a, i0)', '{name} {m} ', &\naddress(c_loc(v_{name}%{first})) - address(c_loc(v_{name}))")
    uses = [f'use {name}' for name in module.names]
    source = '\n'.join(['program probe', *uses, 'implicit none', *declarations, *lines]) + '''
contains
  integer(c_intptr_t) function address(p)
    type(c_ptr), intent(in) :: p
    address = transfer(p, address)
  end function
end program
'''
    return [line.lower() for line in run_probe(folder, fc, [str(file.resolve()) for file in files], 'probe.f90', source)]


CHANGES = {
    'roughcontact.h': {
        'function added': ('RC_API void rc_system_init(', 'RC_API void rc_new(rc_context *context);\nRC_API void rc_system_init('),
        'function renamed': ('rc_contact_reset(', 'rc_contact_clear('),
        'argument added': ('rc_contact_reset(rc_contact *contact)', 'rc_contact_reset(rc_contact *contact, int32_t deep)'),
        'argument widened': ('int32_t control, const rc_options', 'int64_t control, const rc_options'),
        'argument made an output': ('const double *heights', 'double *heights'),
        'return type changed': ('RC_API int64_t rc_backend_count', 'RC_API rc_status rc_backend_count'),
        'constant renumbered': ('RC_STOP_STALLED = 4', 'RC_STOP_STALLED = 7'),
        'constant added': ('RC_LOG_WARNING = 2', 'RC_LOG_WARNING = 2, RC_LOG_DEBUG = 3'),
        'key respelled': ('"max_iter"', '"maxiter"'),
        'members swapped': ('double hx, hy;', 'double hy, hx;'),
        'member removed': ('double energy;', ''),
        'member retyped': ('int32_t control;     /*', 'double control;     /*'),
        'text shortened': ('char note[160]', 'char note[128]'),
        'member appended': ('} rc_result;', 'int64_t more;\n} rc_result;'),
        'member inserted': ('  int64_t completed; ', '  double progress;\n  int64_t completed; '),
    },
    'surface.h': {
        'function renamed': ('rc_surface_fit(', 'rc_surface_match('),
        'argument added': ('int32_t stage, int32_t crop', 'int32_t stage, int32_t crop, int32_t more'),
        'argument widened': ('int32_t levels, double approach', 'int64_t levels, double approach'),
        'constant renumbered': ('RC_SURFACE_WAVES = 3', 'RC_SURFACE_WAVES = 6'),
        'array lengthened': ('#define RC_SURFACE_PEAKS 4', '#define RC_SURFACE_PEAKS 8'),
        'members swapped': ('skewness, kurtosis', 'kurtosis, skewness'),
        'member retyped': ('uint64_t seed;       /* any', 'int32_t seed;       /* any'),
        'text shortened': ('char reason[400]', 'char reason[256]'),
        'member appended': ('} rc_surface_cmr;', 'double more;\n} rc_surface_cmr;'),
    },
}


def self_test(path, module):
    """Every one of these changes to the header must be noticed."""
    text, changes = path.read_text(), CHANGES[path.name]
    missed = []
    today = list(differences(Header(text), module))
    for name, (old, new) in changes.items():
        assert old in text, f'the header no longer has "{old}"'
        if list(differences(Header(text.replace(old, new, 1)), module)) == today:
            missed.append(name)
    print(f'{len(changes) - len(missed)} of {len(changes)} changes noticed')
    return [f'not noticed: {name}' for name in missed]


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('header', type=pathlib.Path)
    arguments.add_argument('module', type=pathlib.Path, nargs='+')
    arguments.add_argument('--after', type=pathlib.Path, nargs='+', default=[], help='modules that those need')
    arguments.add_argument('--cc')
    arguments.add_argument('--fc')
    arguments.add_argument('--self-test', action='store_true')
    a = arguments.parse_args()
    header, module = Header(a.header.read_text()), Module(''.join(file.read_text() for file in a.module))
    if a.self_test:
        problems = self_test(a.header, module)
    else:
        problems = list(differences(header, module))
        if not problems and a.cc and a.fc:
            with tempfile.TemporaryDirectory() as folder:
                folder = pathlib.Path(folder)
                c, f = c_layout(folder, header, a.header, a.cc), fortran_layout(folder, module, a.after + a.module, a.fc)
            problems = [f'layout: header {x}' for x in c if x not in f] + [f'layout: Fortran {x}' for x in f if x not in c]
            print(f'{len(c)} sizes, offsets and default values compared')
        print(f'{len(header.functions)} functions, {len(header.structs)} structs, '
              f'{len(header.constants) + len(header.strings)} constants compared')
    print('\n'.join(problems) or 'no difference')
    return 1 if problems else 0


if __name__ == '__main__':
    sys.exit(main())
