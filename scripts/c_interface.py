"""What C headers declare: constants, structs with the values of their INIT macros, callbacks and functions. Needs pycparser."""

import collections
import pathlib
import re
import subprocess
import tempfile
from typing import Any, Dict, Iterable, List, NamedTuple, Optional, Set, Tuple, Union

import pycparser
from pycparser import c_ast, c_generator

# Pointers to one number, which a C prototype does not show. All others are arrays.
SCALARS = {
    "rc_version": "major minor patch abi",
    **dict.fromkeys(("rc_stop_when", "rc_surface_stop_when", "rc_flow_stop_when"), "flag"),
    "rc_options_get_number": "out",
    "rc_contact_points": "n",
    "rc_contact_creep": "time",
    "rc_crossing_find": "contact gap",
    "rc_conductance": "conductance lower upper",
    "rc_punch_stiffness": "stiffness lower upper",
    "rc_law_pressure": "p slope energy",
    "rc_law_overclosure": "x",
    "rc_law_gap_conductance": "conductance",
    "rc_surface_psd": "count",
    "rc_surface_unit": "metres",
    "rc_ranks_rows": "first count",
}
# Arguments that Fortran may leave out: NULL in C.
OPTIONAL = {
    "rc_version": "major minor patch abi",
    **dict.fromkeys(("rc_stop_when", "rc_surface_stop_when", "rc_flow_stop_when"), "flag"),
    "rc_context_create": "plugin_path",
    "rc_conductance": "lower upper",
    "rc_punch_stiffness": "lower upper",
    "rc_law_pressure": "slope energy",
    "rc_contact_creep": "time",
    **dict.fromkeys(("rc_greedy", "rc_polonsky_keer", "rc_nnls", "rc_gp", "rc_admm"), "w result"),
    "rc_cmr": "inner result",
    "rc_surface_psd": "q psd modes",
    "rc_surface_read": "spec",
    "rc_surface_read_memory": "name spec",
}


class Type(NamedTuple):
    base: str
    const: bool = False
    stars: int = 0
    array: Optional[int] = None
    function: "Optional[Function]" = None


class Function(NamedTuple):
    result: Type
    arguments: List[Tuple[str, Type]]


class Struct(NamedTuple):
    name: str
    members: List[Tuple[str, Type]]
    initial: Dict[str, str]  # expressions of the INIT macro


class Interface:
    """What headers declare, in their order. known: types of this interface and of the one before it; callbacks are Functions."""

    def __init__(self, before: "Optional[Interface]" = None) -> None:
        self.enums: List[Dict[str, int]] = []
        self.numbers: Dict[str, int] = {}  # of macros
        self.bits: Dict[str, int] = {}  # of macros without a sign
        self.strings: Dict[str, str] = {}
        self.types: Dict[str, Union[Struct, Function]] = {}
        self.functions: Dict[str, Function] = {}
        self.files: Set[str] = set(before.files) if before else set()
        self.known: Dict[str, Union[Struct, Function]] = dict(before.known) if before else {}

    def structs(self) -> List[Struct]:
        return [each for each in self.types.values() if isinstance(each, Struct)]

    def callback(self, kind: Type) -> Optional[Function]:
        """The Function that a member or argument points to, or None."""
        named = self.known.get(kind.base)
        return kind.function or (named if isinstance(named, Function) else None)


def preprocessed(headers: List[str], include: pathlib.Path, cc: str) -> Tuple[str, Dict[str, Dict[str, str]]]:
    """(text, {file: {macro: body}}), with the system's headers replaced by the few types that they are needed for."""
    types = {
        "stddef.h": "typedef unsigned long size_t;\n#define NULL 0\n",
        "stdint.h": "".join(
            f"typedef {base} {sign}int{bits}_t;\n"
            for bits, kind in ((8, "char"), (32, "int"), (64, "long"))
            for sign, base in (("", f"signed {kind}"), ("u", f"unsigned {kind}"))
        ),
    }
    types["mpi.h"] = "typedef struct mpi_comm MPI_Comm;\n#define MPI_Fint int32_t\n"
    with tempfile.TemporaryDirectory() as folder:
        for name, text in types.items():
            (pathlib.Path(folder) / name).write_text(text)
        source = "".join(f'#include "{header}"\n' for header in headers)
        command = [cc, "-E", "-dD", "-nostdinc", "-DRC_API=", "-I", folder, "-I", str(include), "-x", "c", "-"]

        def run(text: str) -> str:
            return subprocess.run(command, input=text, stdout=subprocess.PIPE, text=True, check=True).stdout

        begun = re.findall(r"^#define (RC_\w+)_INIT ", run(source), re.MULTILINE)
        expanded = run(source + "".join(f"{name.lower()} {name.lower()}_initial = {name}_INIT;\n" for name in begun))
    file, kept = "", []
    macros: Dict[str, Dict[str, str]] = collections.defaultdict(dict)
    for line in expanded.splitlines():
        marker = re.match(r'# \d+ "(.*?)"', line)
        macro = re.match(r"#define (\w+) (.+)", line)
        if marker:
            file = marker[1]
        if macro:
            macros[file][macro[1]] = macro[2]
        kept.append("" if line.startswith(("#define", "#undef")) else line)
    return "\n".join(kept), macros


def read(headers: List[str], include: pathlib.Path, cc: str, before: Optional[Interface] = None) -> Interface:
    """The Interface of these headers, without what the one before it has."""
    text, macros = preprocessed(headers, include, cc)
    expression = c_generator.CGenerator().visit

    def type_of(node: Any) -> Type:
        if isinstance(node, c_ast.PtrDecl):
            if isinstance(node.type, c_ast.FuncDecl):
                return Type("", function=function_of(node.type))
            inner = type_of(node.type)
            return inner._replace(stars=inner.stars + 1)
        if isinstance(node, c_ast.ArrayDecl):
            return type_of(node.type)._replace(array=int(node.dim.value))
        return Type(" ".join(node.type.names), "const" in node.quals)

    def function_of(node: Any) -> Function:
        arguments: List[Tuple[str, Type]] = []
        for each in node.args.params if node.args else []:
            kind = type_of(each.type)
            if kind != Type("void"):
                arguments.append((each.name or kind.base.replace("rc_", ""), kind))
        return Function(type_of(node.type), arguments)

    found = Interface(before)
    others = set(found.files)
    found.files |= set(macros)
    tree = pycparser.CParser().parse(text)
    values = {node.name: node.init.exprs for node in tree.ext if isinstance(node, c_ast.Decl) and node.init}
    for node in tree.ext:
        found.files.add(node.coord.file)
        if node.coord.file in others:
            continue
        body = node.type.type if isinstance(node, c_ast.Typedef) else node.type if isinstance(node, c_ast.Decl) else None
        if isinstance(body, c_ast.Struct) and body.decls:
            members = [(each.name, type_of(each.type)) for each in body.decls]
            names = [name for name, _ in members]
            numbers = {}  # of arrays: zeros
            for name, value in zip(names, values.get(f"{body.name}_initial", [])):
                if isinstance(value, c_ast.NamedInitializer):
                    name, value = value.name[0].name, value.expr
                if not expression(value).startswith(('"', "{")):
                    numbers[name] = expression(value)
            found.types[body.name] = Struct(body.name, members, numbers)
        elif isinstance(node, c_ast.Typedef) and isinstance(node.type, c_ast.PtrDecl):
            found.types[node.name] = function_of(node.type.type)
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.Enum):
            found.enums.append({each.name: int(expression(each.value)) for each in node.type.values.enumerators})
        elif isinstance(node, c_ast.Decl) and isinstance(node.type, c_ast.FuncDecl):
            found.functions[node.name] = function_of(node.type)
    for file, bodies in macros.items():
        for name, body in bodies.items():
            if name.startswith("RC_") and file not in others:
                if re.fullmatch(r"-?\d+", body):
                    found.numbers[name] = int(body)
                elif re.fullmatch(r"\(UINT64_C\(1\) << \d+\)|\d+u", body):
                    found.bits[name] = 1 << int(body.split()[-1][:-1]) if "<<" in body else int(body[:-1])
                elif body.startswith('"'):
                    found.strings[name] = body.strip('"')
    found.known.update(found.types)
    return found


def size_of(kind: Type, address: int, known: Dict[str, Union[Struct, Function]]) -> Tuple[int, int]:
    """(bytes, alignment) where addresses have so many bytes: 8, or 4, to which i686 aligns longer numbers, too."""
    inner = known.get(kind.base)
    if isinstance(inner, Struct) and not kind.stars:
        return struct_size(inner, known, address), address
    sizes = {"int64_t": 8, "uint64_t": 8, "double": 8, "int32_t": 4, "uint32_t": 4, "float": 4}
    sizes.update({"rc_status": 4, "uint8_t": 1, "char": 1})  # others are size_t and names of functions
    size = address if kind.stars or kind.function else sizes.get(kind.base, address)
    return size * (kind.array or 1), min(size, address)


def layout(struct: Struct, known: Dict[str, Union[Struct, Function]], address: int = 8) -> Tuple[int, Dict[str, int]]:
    """(bytes, {member: offset})"""
    end, offsets = 0, {}
    for name, kind in struct.members:
        size, alignment = size_of(kind, address, known)
        offsets[name] = -(-end // alignment) * alignment
        end = offsets[name] + size
    return -(-end // address) * address, offsets


def struct_size(struct: Struct, known: Dict[str, Union[Struct, Function]], address: int = 8) -> int:
    return layout(struct, known, address)[0]


def grouped(pairs: Iterable[Tuple[Any, str]]) -> List[Tuple[Any, List[str]]]:
    """[(key, [value, ...])] of [(key, value)], neighbours of one key together."""
    groups: List[Tuple[Any, List[str]]] = []
    for key, value in pairs:
        if groups and groups[-1][0] == key:
            groups[-1][1].append(value)
        else:
            groups.append((key, [value]))
    return groups


def same_prototypes(functions: Dict[str, Function]) -> List[List[str]]:
    """[[name, ...]] of functions that have the same result and arguments, by the first of each."""
    groups: Dict[str, List[str]] = {}
    for name, function in functions.items():
        groups.setdefault(repr((function, OPTIONAL.get(name), SCALARS.get(name))), []).append(name)
    return list(groups.values())
