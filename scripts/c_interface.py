"""What C headers declare: constants, structs with the values of their INIT macros, callbacks and functions. Needs pycparser."""
import collections
import pathlib
import re
import subprocess
import tempfile

import pycparser
from pycparser import c_ast, c_generator

Type = collections.namedtuple('Type', 'base const stars array function', defaults=(False, 0, None, None))
Function = collections.namedtuple('Function', 'result arguments')  # arguments: [(name, Type)]
Struct = collections.namedtuple('Struct', 'name members initial')  # members: [(name, Type)], initial: {name: expression}


class Interface:
    """What headers declare, in their order: enums [{name: value}], numbers and strings of macros {name: value}, types {name: Struct,
    or Function for a callback}, functions {name: Function}. known: its types and those of the interface before it."""

    def __init__(self, before=None):
        self.enums, self.numbers, self.strings, self.types, self.functions = [], {}, {}, {}, {}
        self.files = set(before.files) if before else set()
        self.known = dict(before.known) if before else {}

    def structs(self):
        return [each for each in self.types.values() if isinstance(each, Struct)]

    def callback(self, kind):
        """The Function that a member or argument points to, or None."""
        named = self.known.get(kind.base)
        return kind.function or (named if isinstance(named, Function) else None)


def preprocessed(headers, include, cc):
    """(text, {file: {macro: body}}), with the system's headers replaced by the few types that they are needed for."""
    types = {'stddef.h': 'typedef unsigned long size_t;\n#define NULL 0\n',
             'stdint.h': ''.join(f'typedef {base} {sign}int{bits}_t;\n' for bits, kind in
                                 ((8, 'char'), (32, 'int'), (64, 'long')) for sign, base in
                                 (('', f'signed {kind}'), ('u', f'unsigned {kind}')))}
    with tempfile.TemporaryDirectory() as folder:
        for name, text in types.items():
            (pathlib.Path(folder) / name).write_text(text)
        source = ''.join(f'#include "{header}"\n' for header in headers)
        command = [cc, '-E', '-dD', '-nostdinc', '-DRC_API=', '-I', folder, '-I', str(include), '-x', 'c', '-']
        run = subprocess.run(command, input=source, stdout=subprocess.PIPE, text=True, check=True)
    file, kept, macros = '', [], collections.defaultdict(dict)
    for line in run.stdout.splitlines():
        marker = re.match(r'# \d+ "(.*?)"', line)
        macro = re.match(r'#define (\w+) (.+)', line)
        if marker:
            file = marker[1]
        if macro:
            macros[file][macro[1]] = macro[2]
        kept.append('' if line.startswith(('#define', '#undef')) else line)
    return '\n'.join(kept), macros


def read(headers, include, cc, before=None):
    """The Interface of these headers, without what the one before it has."""
    text, macros = preprocessed(headers, include, cc)
    initial = {name[:-5].lower(): body for bodies in macros.values() for name, body in bodies.items() if name.endswith('_INIT')}
    text += ''.join(f'\n{struct} {struct}_initial = {body};' for struct, body in initial.items())
    expression = c_generator.CGenerator().visit

    def type_of(node):
        if isinstance(node, c_ast.PtrDecl):
            if isinstance(node.type, c_ast.FuncDecl):
                return Type('', function=function_of(node.type))
            inner = type_of(node.type)
            return inner._replace(stars=inner.stars + 1)
        if isinstance(node, c_ast.ArrayDecl):
            return type_of(node.type)._replace(array=int(node.dim.value))
        return Type(' '.join(node.type.names), 'const' in node.quals)

    def function_of(node):
        arguments = []
        for each in node.args.params if node.args else []:
            kind = type_of(each.type)
            if kind != Type('void'):
                arguments.append((each.name or kind.base.replace('rc_', ''), kind))
        return Function(type_of(node.type), arguments)

    found = Interface(before)
    others = set(found.files)
    found.files |= set(macros)
    tree = pycparser.CParser().parse(text)
    values = {node.name: [expression(each) for each in node.init.exprs] for node in tree.ext
              if isinstance(node, c_ast.Decl) and node.init}
    for node in tree.ext:
        found.files.add(node.coord.file)
        if node.coord.file in others:
            continue
        if isinstance(node, c_ast.Typedef) and isinstance(node.type.type, c_ast.Struct) and node.type.type.decls:
            members = [(each.name, type_of(each.type)) for each in node.type.type.decls]
            names = [name for name, _ in members]
            found.types[node.name] = Struct(node.name, members, dict(zip(names, values.get(f'{node.name}_initial', []))))
        elif isinstance(node, c_ast.Typedef) and isinstance(node.type, c_ast.PtrDecl):
            found.types[node.name] = type_of(node.type).function
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.Enum):
            found.enums.append({each.name: int(expression(each.value)) for each in node.type.values.enumerators})
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl):
            found.functions[node.name] = function_of(node.type)
    for file, bodies in macros.items():
        for name, body in bodies.items():
            if name.startswith('RC_') and file not in others:
                if re.fullmatch(r'-?\d+', body):
                    found.numbers[name] = int(body)
                elif body.startswith('"'):
                    found.strings[name] = body.strip('"')
    found.known.update(found.types)
    return found


def size_of(kind):
    """(bytes, alignment) on a 64-bit (LP64) platform."""
    sizes = {'int32_t': 4, 'uint32_t': 4, 'rc_status': 4, 'uint8_t': 1, 'char': 1}
    size = 8 if kind.stars or kind.function else sizes.get(kind.base, 8)
    return size * (kind.array or 1), size


def struct_size(struct):
    end = 0
    for _, kind in struct.members:
        size, alignment = size_of(kind)
        end = -(-end // alignment) * alignment + size
    return -(-end // 8) * 8
