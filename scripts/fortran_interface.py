"""Fortran modules of what C headers declare: constants, structs with their initial values, and functions."""

import collections
import re
from typing import List, Tuple

from c_interface import OPTIONAL, SCALARS, Function, Interface, Struct, Type, same_prototypes, grouped, struct_size

WIDTH = 132  # the longest line


def wrapped(line: str, continued: bool = False) -> List[str]:
    """A line in lines that are not too long."""
    if len(line) <= WIDTH:
        return [line]
    indent = line[: len(line) - len(line.lstrip())]
    code, _, remark = line.partition("  !")
    if remark:
        return [f"{indent}!{remark}", *wrapped(code)]
    cut = line.rindex(", ", 0, WIDTH - 1) + 1
    return [line[:cut] + " &", *wrapped(indent + ("" if continued else "  ") + line[cut + 1 :], True)]


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
    result = "subroutine"
    if function.result != Type("void"):
        result = f"{'type(c_ptr)' if function.result.stars else KINDS[function.result.base]} function"
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
    for name, *_ in same_prototypes(functions):
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
        f"  procedure({first}), bind(c) :: {', '.join(others)}" for first, *others in same_prototypes(functions) if others
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
    return "\n".join(each for line in lines for each in wrapped(line)) + "\n"
