"""Modules of the Python package that say what C headers declare, and where an elastic answer stops making sense."""

import re
from typing import Dict, Iterable, List, Sequence, Tuple

from c_interface import Function, Interface, Struct, Type, same_prototypes, grouped

WIDTH = 128  # the longest line


def wrapped(line: str) -> List[str]:
    """A line that ends in a bracket, in lines that are not too long."""
    if len(line) <= WIDTH:
        return [line]
    indent = line[: len(line) - len(line.lstrip())]
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
        for names in same_prototypes(functions):
            function = functions[names[0]]
            arguments = ", ".join(python_argument(kind, interface) for _, kind in function.arguments)
            signature = f"Callable[[{arguments}], {python_type(function.result, interface)}]"
            if len(names) > 1 and len(signature) > 80:
                signatures += wrapped(f"{names[0]}_like = {signature}")
                signature = f"{names[0]}_like"
            classes += [line for name in names for line in wrapped(f"    {name}: {signature}")]
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


def python_limits(table: str) -> str:
    """table: the text of tools/solve/elastic_limits.def"""
    bodies = re.findall(r'^RC_HARDNESS\((\S+), "(.*)"\)$', table, re.M)
    (strain,) = re.findall(r"^RC_SMALL_STRAIN\((\S+)\)$", table, re.M)
    pairs = ", ".join(f'({hardness}, "{body}")' for hardness, body in bodies)
    return f"HARDNESSES = ({pairs})  # [Pa], the hardest first\nSMALL_STRAIN = {strain}  # largest pressure over E*"


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
