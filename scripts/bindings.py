#!/usr/bin/env python3
"""Writes what the bindings know of the C headers: constants, structs with their initial values, and functions for Fortran and
Python, the members of rc_result for Octave.

bindings.py [--check] [--cc CC] [--include FOLDER]

--check changes no file: it prints what differs, and exits with 1 where something does. Exits with 77 without pycparser (Debian:
python3-pycparser).
"""

import argparse
import collections
import difflib
import pathlib
import re
import sys
import textwrap
from typing import Any, Dict, Iterable, List, Sequence, Tuple

try:
    from c_interface import SCALARS, Function, Interface, Struct, Type, layout, read, struct_size
except ImportError as missing:
    if missing.name != "pycparser":
        raise
    print("skipped: pycparser is missing (Debian: python3-pycparser)")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parent.parent
# The headers that a program includes to use each library. Headers that these include are read as well; the first library has them.
HEADERS = {
    "contact": [f"roughcontact/{name}.h" for name in ("roughcontact", "history", "derivatives", "direct", "product", "analysis", "law", "registry")],
    "surface": ["roughcontact/surface.h"],
    "formats": ["roughcontact/formats.h"],
    "request": ["roughcontact/request.h"],
    "flow": ["roughcontact/flow.h"],
    "mpi": ["roughcontact/mpi.h"],
}
# Functions of plugin.h that Python calls; the structs that only this header knows are handles to it.
FROM_PLUGIN = ["rc_context_register"]
# The parts of mpi.h for languages that know communicators by their Fortran handles.
FROM_MPI = ["rc_ranks_counts"]
# Arguments that Fortran may leave out: NULL in C.
OPTIONAL = {
    "rc_version": "major minor patch abi",
    **dict.fromkeys(("rc_stop_when", "rc_surface_stop_when"), "flag"),
    "rc_context_create": "config",
    "rc_conductance": "lower upper",
    "rc_punch_stiffness": "lower upper",
    "rc_law_pressure": "slope energy",
    **dict.fromkeys(("rc_greedy", "rc_polonsky_keer", "rc_nnls", "rc_gp", "rc_admm"), "w result"),
    "rc_cmr": "inner result",
    "rc_surface_psd": "q psd modes",
    "rc_surface_read": "spec",
    "rc_surface_read_memory": "name spec",
}
WIDTH = {"fortran": 132, "python": 128}


def wrapped(line: str, language: str, continued: bool = False) -> List[str]:
    """A line of Fortran or Python in lines that are not too long."""
    if len(line) <= WIDTH[language]:
        return [line]
    indent = line[: len(line) - len(line.lstrip())]
    if language == "fortran":
        code, _, remark = line.partition("  !")
        if remark:
            return [f"{indent}!{remark}", *wrapped(code, language)]
        cut = line.rindex(", ", 0, WIDTH[language] - 1) + 1
        return [line[:cut] + " &", *wrapped(indent + ("" if continued else "  ") + line[cut + 1 :], language, True)]
    head, body = line[:-1].split("[", 1)
    return [f"{head}[", f"{indent}    {body}", f"{indent}]"]


def filled(parts: Iterable[str], separator: str, width: int = 124) -> List[str]:
    """Parts joined in lines that are not too long."""
    lines: List[str] = []
    for part in parts:
        if lines and len(lines[-1]) + len(separator) + len(part) <= width:
            lines[-1] += separator + part
        else:
            lines.append(part)
    return lines


def grouped(pairs: Iterable[Tuple[Any, str]]) -> List[Tuple[Any, List[str]]]:
    """[(key, [value, ...])] of [(key, value)], neighbours of one key together."""
    groups: List[Tuple[Any, List[str]]] = []
    for key, value in pairs:
        if groups and groups[-1][0] == key:
            groups[-1][1].append(value)
        else:
            groups.append((key, [value]))
    return groups


def alike(functions: Dict[str, Function]) -> List[List[str]]:
    """[[name, ...]] of functions that have the same result and arguments, by the first of each."""
    groups: Dict[str, List[str]] = {}
    for name, function in functions.items():
        groups.setdefault(repr((function, OPTIONAL.get(name), SCALARS.get(name))), []).append(name)
    return list(groups.values())


KINDS = {
    "int32_t": "integer(c_int32_t)",
    "uint32_t": "integer(c_int32_t)",
    "int64_t": "integer(c_int64_t)",
    "uint64_t": "integer(c_int64_t)",
    "uint8_t": "integer(c_int8_t)",
    "size_t": "integer(c_size_t)",
    "double": "real(c_double)",
    "rc_status": "integer(rc_status)",
    "char": "character(kind=c_char)",
}


def c_words(kind: Type) -> str:
    return f"{'const ' if kind.const else ''}{kind.base} {'*' * kind.stars}"


def fortran_number(expression: str, kind: Type) -> str:
    expression = re.sub(r"\.0$", "", expression)
    return f"{expression}_c_double" if "." in expression and kind.base == "double" else expression


def fortran_signature(name: str, function: Function) -> str:
    """The interface of a callback, for a comment."""
    result = KINDS[function.result.base] + " function" if function.result.base != "void" else "subroutine"
    return f"{result} {name}({', '.join(argument for argument, _ in function.arguments)}) bind(c)"


def fortran_member(name: str, kind: Type, struct: Struct, interface: Interface) -> Tuple[Tuple[str, str], str]:
    """((declaration, remark), text)"""
    function, known = interface.callback(kind), interface.known
    if name == "struct_size":
        return ("integer(c_size_t)", ""), f"struct_size = merge({struct_size(struct, known)}, {struct_size(struct, known, 4)}, c_intptr_t == 8)"
    if function:
        return ("type(c_funptr)", fortran_signature(name, function)), f"{name} = c_null_funptr"
    if kind.stars:
        return ("type(c_ptr)", c_words(kind)), f"{name} = c_null_ptr"
    if kind.base in known:
        return (f"type({kind.base})", ""), f"{name} = {kind.base}()"
    extent, value = f"({kind.array})" if kind.array else "", fortran_number(struct.initial.get(name, "0"), kind)
    return (KINDS[kind.base], ""), f"{name}{extent} = {'c_null_char' if kind.base == 'char' else value}"


def fortran_structs(interface: Interface) -> List[str]:
    lines = []
    for struct in interface.structs():
        lines += ["", f"  type, bind(c) :: {struct.name}"]
        members = (fortran_member(name, kind, struct, interface) for name, kind in struct.members)
        for (declaration, remark), names in grouped(members):
            lines.append(f"    {declaration} :: {', '.join(names)}{'  ! ' * bool(remark)}{remark}")
        lines.append("  end type")
    return lines


def fortran_argument(function: str, name: str, kind: Type, interface: Interface) -> Tuple[str, str]:
    """(declaration, name)"""
    optional = ", optional" * (name in OPTIONAL.get(function, "").split())
    intent = f", intent({'in' if kind.const else 'inout'}){optional}"
    if interface.callback(kind):
        return "type(c_funptr), value", name
    if kind.base in interface.known:
        return f"type({kind.base}){intent if kind.stars else ', value'}", name
    if kind.stars == 2:
        return "type(c_ptr), intent(inout)", name
    if kind.stars == 0:
        return f"{KINDS[kind.base]}, value", name
    if kind.base not in KINDS or kind.base == "uint8_t":  # an object, or a mask
        return "type(c_ptr), value", name
    return f"{KINDS[kind.base]}{intent}", name if name in SCALARS.get(function, "").split() else f"{name}(*)"


def fortran_functions(interface: Interface) -> List[str]:
    given = {f"{struct.name}_init" for struct in interface.structs() if struct.initial}  # by the type itself
    functions = {name: function for name, function in interface.functions.items() if name not in given}
    lines = ["", "  interface"]
    for name, *_ in alike(functions):
        function = interface.functions[name]
        pointer = function.result.stars
        result = (
            "subroutine"
            if function.result == Type("void")
            else f"{'type(c_ptr)' if pointer else KINDS[function.result.base]} function"
        )
        lines.append(f"    {result} {name}({', '.join(argument for argument, _ in function.arguments)}) bind(c); import")
        declared = collections.defaultdict(list)
        for declaration, argument in (fortran_argument(name, *each, interface) for each in function.arguments):
            declared[declaration].append(argument)
        lines += [f"      {declaration} :: {', '.join(names)}" for declaration, names in declared.items()]
        lines.append(f"    end {result.split()[-1]}")
    lines.append("  end interface")
    return lines + [
        f"  procedure({first}), bind(c) :: {', '.join(others)}" for first, *others in alike(functions) if others
    ]


def fortran_constants(interface: Interface) -> List[str]:
    lines = []
    for values in filter(None, [interface.numbers, *interface.enums]):
        pairs = ", ".join(f"{name} = {value}" for name, value in values.items())
        lines.append(f"  integer(c_int32_t), parameter :: {pairs}")
    if interface.strings:
        pairs = ", ".join(f"{name} = '{value}'" for name, value in interface.strings.items())
        lines.append(f"  character(*), parameter :: {pairs}")
    return lines


def fortran_module(name: str, head: List[str], uses: List[str], *parts: List[str]) -> str:
    lines = [
        *(f"! {line}".rstrip() for line in head),
        "! Written by scripts/bindings.py.",
        f"module {name}",
        *uses,
        "  implicit none",
    ]
    lines += [line for part in parts for line in part] + ["end module"]
    return "\n".join(each for line in lines for each in wrapped(line, "fortran")) + "\n"


ARRAYS = {"rc_const_array": "array_in", "rc_array": "array_out"}  # structs that functions take by value
POINTERS = {"double": "doubles", "float": "singles", "int64_t": "integers", "int32_t": "statuses", "rc_status": "statuses", "uint8_t": "bytes_"}


def python_type(kind: Type, interface: Interface) -> str:
    """Its name in _c.py or a struct, of an array with its extent."""
    if interface.callback(kind):
        return f"Annotated[Any, {kind.base}]"
    if kind.array:
        return f"{kind.base}*{kind.array}"
    if kind.base in interface.known or not kind.stars:
        return "None" if kind.base == "void" else kind.base
    if kind.base in POINTERS:
        return POINTERS[kind.base]
    return ("text" if kind.base == "char" else "handle") + "s" * (kind.stars - 1)


def python_argument(kind: Type, interface: Interface) -> str:
    """Its name in _functions.py, where structs are passed by their address unless C takes them by value."""
    by_value = kind.base in interface.known and not kind.stars and not interface.callback(kind)
    return ARRAYS[kind.base] if by_value else python_type(kind, interface)


def python_callback(name: str, function: Function, interface: Interface) -> str:
    kinds = [python_type(each, interface) for each in (function.result, *(kind for _, kind in function.arguments))]
    return f"{name} = callback({', '.join(kinds)})"


def python_structs(interface: Interface) -> str:
    lines = []
    for name, declared in interface.types.items():
        if isinstance(declared, Function):
            lines += ["", "", python_callback(name, declared, interface)]
            continue
        members = []
        for member, kind in declared.members:
            if kind.function:
                lines += ["", "", python_callback(f"rc_{member}_fn", kind.function, interface)]
                kind = kind._replace(base=f"rc_{member}_fn")
            value = declared.initial.get(member, "0")
            begins = "" if member == "struct_size" or value in ("0", "0.0", "NULL") else f"={value}"
            address = kind.stars and isinstance(interface.known.get(kind.base), Struct)
            base = kind.base if interface.callback(kind) else "handle" if address else python_type(kind, interface)
            members.append((base, member + begins))
        groups = [f"{kind} {line}" for kind, names in grouped(members) for line in filled(names, " ", 100)]
        text = filled(groups, "; ", 108)
        quote = '"' * (1 if len(text) == 1 else 3)
        lines += ["", "", "@struct", f"class {name}(Sized):", f"    members = {quote}{(';' + chr(10) + '    ').join(text)}{quote}"]
    return "\n".join(lines).strip("\n")


def python_functions(libraries: Dict[str, Tuple[str, Interface, Dict[str, Function]]]) -> str:
    """libraries: {class: (summary, Interface, its functions and those of others that belong to this library)}"""
    signatures, classes = [f"{name} = Annotated[Any, {kind}]" for kind, name in ARRAYS.items()], []
    for title, (summary, interface, functions) in libraries.items():
        classes += ["", "", f"class {title}(Protocol):", f'    """{summary}"""', ""]
        for names in alike(functions):
            function = functions[names[0]]
            arguments = ", ".join(python_argument(kind, interface) for _, kind in function.arguments)
            signature = f"Callable[[{arguments}], {python_type(function.result, interface)}]"
            if len(names) > 1 and len(signature) > 80:
                signatures += wrapped(f"{names[0]}_like = {signature}", "python")
                signature = f"{names[0]}_like"
            classes += [line for name in names for line in wrapped(f"    {name}: {signature}", "python")]
    return "\n".join(signatures + classes)


def python_constants(interfaces: List[Interface]) -> str:
    lines = []
    for interface in interfaces:
        for values in [interface.numbers, *interface.enums]:
            if not values:
                continue
            for names in filled(values, ", ", 88):
                lines.append(f"{names} = {', '.join(str(values[name]) for name in names.split(', '))}")
        for names in filled(interface.strings, ", ", 64):
            texts = ", ".join(f'"{interface.strings[name]}"' for name in names.split(", "))
            lines.append(f"{names} = {texts}")
    return "\n".join(lines)


def python_limits() -> str:
    table = (ROOT / "tools/solve/elastic_limits.def").read_text()
    bodies = re.findall(r'^RC_HARDNESS\((\S+), "(.*)"\)$', table, re.M)
    (strain,) = re.findall(r"^RC_SMALL_STRAIN\((\S+)\)$", table, re.M)
    pairs = ", ".join(f'({hardness}, "{body}")' for hardness, body in bodies)
    return f"HARDNESSES = ({pairs})  # [Pa], the hardest first\nSMALL_STRAIN = {strain}  # largest pressure over E*"


CALLS = ("solve", "history", "batch", "law", "analyze", "ranks")


def words() -> List[Tuple[Any, ...]]:
    """The rows of request/words.def, which reads as Python."""
    rows: List[Tuple[Any, ...]] = []
    calls = {f"RC_CALL_{name.replace('ranks', 'rows').upper()}": 1 << k for k, name in enumerate(CALLS)}
    every = sum(calls.values())
    text = re.sub(r"^//.*\n", "", (ROOT / "request/words.def").read_text(), flags=re.M)
    kinds = {name: name for name in re.findall(r"RC_WORD_\w+", text)}
    own = {"every": every, "presses": every & ~calls["RC_CALL_ANALYZE"], "elastic": "", "loading": "", "most_targets": 100000}
    exec(text, {**calls, **kinds, **own, "nothing": "nothing presses when a surface is analysed", "whole": every & ~calls["RC_CALL_ROWS"], "alone": "a rank has some rows, and this needs others", "RC_REQUEST_WORD": lambda *row: rows.append(row)})
    return rows


def python_words() -> str:
    """The words of calls that solve; surfaces are arguments, and options of the library keywords."""
    taken = [row for row in words() if row[1] != "RC_WORD_OPTION" and row[0] not in ("surface", "gap") and row[8] & 1]
    lines = []
    for name, _, _, _, form, text, *_ in taken:
        pair = f'    "{name.replace("-", "_")}": ("{form}", "{text}"),'
        texts = textwrap.wrap(text, 110, drop_whitespace=False)
        pieces = [f'        "{line}"' for line in texts]
        lines += [pair] if len(pair) <= 128 else [f'    "{name}": (', f'        "{form}",', *pieces[:-1], pieces[-1] + ",", "    ),"]
    return "\n".join(["#: {word: (form of its value, meaning)}", "HELP = {", *lines, "}"])


def words_page() -> str:
    """docs/words.md: each word, its value, and where it is not taken and why."""
    lines = [
        "# Words",
        "",
        "After this page you know every word by which a surface, its bodies and its loading are described. They are the same in the",
        "command (`--pitch 39nm`), in Python (`pitch=\"39nm\"`), in Octave (`opts.pitch = '39nm'`) and in C (`rc_given`).",
        "",
        "| word | value | meaning | not for |",
        "|---|---|---|---|",
    ]
    for name, _, _, _, form, text, _, example, calls, why_not in words():
        without = ", ".join(call for k, call in enumerate(CALLS) if not calls >> k & 1)
        value = f"{form}, `{example}`" if example else form
        lines.append(f"| `{name}` | {value} | {text} | {f'{without}: {why_not}' if without else ''} |")
    return "\n".join(lines) + "\n"


def python_status(interface: Interface) -> str:
    members = next(values for values in interface.enums if "RC_OK" in values)
    return "\n".join(
        [
            "import enum",
            "",
            "",
            "class Status(enum.IntEnum):",
            '    """0 certified, 100 and above usable but not certified, < 0 failed."""',
            "",
            *(f"    {name.replace('RC_', '', 1)} = {value}" for name, value in members.items()),
        ]
    )


def python_module(summary: str, body: str, after: Sequence[str] = ()) -> str:
    """after: modules of the package that it needs."""
    lines = [f'"""{summary}', "", "Written by scripts/bindings.py.", '"""', ""]
    for module, names in {"typing": "Annotated Any Callable Protocol"}.items():
        used = [name for name in names.split() if re.search(rf"\b{name}\b", body)]
        lines += [f"from {module} import {', '.join(used)}"] if used else []
    lines += [""] * (len(lines) > 5) + [f"from .{module} import *  # noqa: F403" for module in after]
    return "\n".join([*lines, *[""] * (bool(after) + body.startswith("@")), body]) + "\n"


def golden(headers: Sequence[str], found: Interface) -> str:
    """The numbers of headers, as C that does not compile if they differ."""
    lines = ["/* Written by scripts/bindings.py, see golden.h. */", "/* clang-format off */", '#include "golden.h"', "", *[f"#include <{each}>" for each in sorted(headers)], ""]
    constants = {name: value for each in (*found.enums, found.numbers, found.bits) for name, value in each.items()}
    for name, value in constants.items():
        if not name.startswith("RC_VERSION_"):
            lines.append(f"VALUE({name}, {value if value < 1 << 31 else f'INT64_C({value})'});")
    for struct in found.structs():
        size, offsets = layout(struct, found.known)
        lines += ["", f"SIZE({struct.name}, {size});", *[f"AT({struct.name}, {name}, {at});" for name, at in offsets.items()]]
    return "\n".join([*lines, ""])


def generated(include: pathlib.Path, cc: str) -> Dict[str, str]:
    """{path: text}"""
    contact = read(HEADERS["contact"], include, cc)
    surface, formats, flow, mpi = (read(HEADERS[name], include, cc, contact) for name in ("surface", "formats", "flow", "mpi"))
    request = read(HEADERS["request"], include, cc, formats)
    with_communicators = mpi.functions.keys()
    mpi.types = {name: mpi.types[name] for name in FROM_MPI}
    mpi.functions = {
        name: each
        for name, each in mpi.functions.items()
        if name.startswith("rc_mpi_") and all(kind.base != "MPI_Comm" for _, kind in each.arguments)
    }
    plugin = read(["roughcontact/plugin.h"], include, cc, contact)
    ranks = read(["roughcontact/ranks.h"], include, cc, contact)
    every = [*HEADERS["contact"], *HEADERS["surface"], *HEADERS["formats"], *HEADERS["flow"], *HEADERS["request"], "roughcontact/ranks.h"]
    added = {name: plugin.functions[name] for name in FROM_PLUGIN}
    known = set(with_communicators).union(*(each.functions for each in (contact, ranks, surface, formats, flow)))
    unknown = (SCALARS.keys() | OPTIONAL.keys()) - known
    if unknown:
        sys.exit(f"SCALARS and OPTIONAL name functions that the headers do not have: {', '.join(sorted(unknown))}")
    own, fortran, python = (
        "the headers but surface.h, formats.h, ranks.h, mpi.h and plugin.h",
        "bindings/fortran/roughcontact",
        "bindings/python/roughcontact",
    )
    use_c = "  use, intrinsic :: iso_c_binding"
    members = [
        f"{'TEXT' if kind.array else 'NUMBER'}({struct.name.replace('rc_', '')}, {name})"
        for struct in contact.structs()
        if struct.name in ("rc_result", "rc_accuracy")
        for name, kind in struct.members
        if kind.base not in contact.known and not kind.stars and name not in ("struct_size", "reserved")
    ]
    return {
        f"{fortran}_constants.f90": fortran_module(
            "roughcontact_constants",
            [f"The constants of {own}, name for name."],
            [use_c],
            ["", "  integer, parameter :: rc_status = c_int32_t  ! the kind of a status"],
            fortran_constants(contact),
        ),
        f"{fortran}_structs.f90": fortran_module(
            "roughcontact_structs",
            [
                f"The structs of {own}, member for member,",
                "with the values of the RC_..._INIT macros.",
                "",
                "Arrays are rc_const_array(c_loc(x)) and rc_array(c_loc(x)) of contiguous target arrays, x fastest: a Fortran array",
                "p(nx, ny) has the order of the library; rc_array() is none. A remark after a pointer is its type in C. Callbacks",
                "are c_funloc(f) of bind(c) procedures. Logical masks of Fortran are no masks of C: integer(c_int8_t), 0 or 1.",
            ],
            ["  use roughcontact_constants"],
            fortran_structs(contact),
        ),
        f"{fortran}_functions.f90": fortran_module(
            "roughcontact_functions",
            [
                f"The functions of {own}, name for name;",
                "units, rules and errors are described there.",
                "",
                "Objects (context, options, contact) are type(c_ptr); c_null_ptr where C takes NULL. Names and keys are passed",
                "as rc_to_c('fft'). Points and components are numbered from 0, as in C.",
            ],
            ["  use roughcontact_structs"],
            fortran_functions(contact),
        ),
        f"{fortran}_surface_interface.f90": fortran_module(
            "roughcontact_surface_interface",
            [
                "The C interface of <roughcontact/surface.h>, name for name; units, rules and errors are described there. A",
                "program that uses it links libroughcontact-surface, and is then under the GPL because of GSL.",
            ],
            ["  use roughcontact_constants, only: rc_status", use_c],
            [""],
            fortran_constants(surface),
            fortran_structs(surface),
            fortran_functions(surface),
        ),
        f"{fortran}_formats_interface.f90": fortran_module(
            "roughcontact_formats_interface",
            ["The C interface of <roughcontact/formats.h>, name for name; units, rules and errors are described there."],
            ["  use roughcontact_constants, only: rc_status", use_c],
            [""],
            fortran_constants(formats),
            fortran_structs(formats),
            fortran_functions(formats),
        ),
        f"{fortran}_mpi_interface.f90": fortran_module(
            "roughcontact_mpi_interface",
            [
                "The C interface of <roughcontact/mpi.h>, name for name, where it takes Fortran's communicators: comm%MPI_VAL.",
                "Units, rules and errors are described there.",
            ],
            ["  use roughcontact_structs"],
            fortran_structs(mpi),
            fortran_functions(mpi),
        ),
        f"{python}/_constants.py": python_module(
            "The constants of the headers, under their names there.", python_constants([contact, surface, formats, request])
        ),
        f"{python}/_limits.py": python_module("Where an elastic answer stops making sense.", python_limits()),
        f"{python}/_words.py": python_module("The words of request/words.def.", python_words()),
        "docs/words.md": words_page(),
        f"{python}/_status.py": python_module("How a call ended.", python_status(contact)),
        f"{python}/_structs.py": python_module(
            "The structs of the headers, member by member, with the values of the RC_..._INIT macros.",
            "\n\n\n".join(map(python_structs, (contact, surface, formats, request, mpi))),
            after=["_c", "_constants"],
        ),
        f"{python}/_functions.py": python_module(
            "The functions of the headers.",
            python_functions(
                {
                    "ContactFunctions": ("libroughcontact", contact, {**contact.functions, **added}),
                    "SurfaceFunctions": ("libroughcontact-surface", surface, surface.functions),
                    "FormatsFunctions": ("libroughcontact-formats", formats, formats.functions),
                    "RequestFunctions": ("libroughcontact-request", request, request.functions),
                    "MpiFunctions": ("libroughcontact-mpi", mpi, mpi.functions),
                }
            ),
            after=["_c", "_structs"],
        ),
        "tests/contract/abi/golden.c": golden(every, read(every, include, cc)) + "\nint main(void) { return 0; }\n",
        "tests/contract/abi/golden_plugin.c": golden(["roughcontact/plugin.h"], plugin),
        "tests/contract/abi/symbols.txt": "".join(f"{name}\n" for name in sorted({**contact.functions, **ranks.functions, **plugin.functions})),
        "bindings/octave/result_fields.def": "/* Members of rc_result and rc_accuracy that rc_solve returns in info, under their names. Written by "
        "scripts/bindings.py. */\n" + "\n".join(members) + "\n",
    }


def main() -> int:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--check", action="store_true", help="compare, change nothing")
    arguments.add_argument("--cc", default="cc", help="C compiler, used as preprocessor")
    arguments.add_argument("--include", type=pathlib.Path, default=ROOT / "include", help="folder of the headers")
    given = arguments.parse_args()
    differing = 0
    for name, text in generated(given.include, given.cc).items():
        path = ROOT / name
        present = path.read_text() if path.exists() else ""
        if present == text:
            continue
        differing += 1
        if given.check:
            sys.stdout.writelines(difflib.unified_diff(present.splitlines(True), text.splitlines(True), name, "the headers"))
        else:
            path.write_text(text)
            print(f"wrote {name}")
    if given.check:
        print(f"{differing} files differ; scripts/bindings.py renews them" if differing else "as the headers say")
    return 1 if given.check and differing else 0


sys.exit(main())
