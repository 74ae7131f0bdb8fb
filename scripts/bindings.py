#!/usr/bin/env python3
"""Writes what the bindings know of the C headers: constants, structs with their initial values, and functions for Fortran and
Python, the members of rc_result for Octave.

bindings.py [--check] [--cc CC] [--include FOLDER]

--check changes no file: it prints what differs, and exits with 1 where something does. Exits with 77 without pycparser (Debian:
python3-pycparser).
"""

import argparse
import difflib
import pathlib
import sys
import textwrap
from typing import Dict, List, Sequence

try:
    from c_interface import OPTIONAL, SCALARS, Interface, layout, read
except ImportError as missing:
    if missing.name != "pycparser":
        raise
    print("skipped: pycparser is missing (Debian: python3-pycparser)")
    sys.exit(77)

from fortran_interface import fortran_constants, fortran_functions, fortran_module, fortran_structs
from python_interface import python_constants, python_functions, python_limits, python_module, python_status, python_structs
from request_words import python_words, words_page

ROOT = pathlib.Path(__file__).resolve().parent.parent
# The headers that a program includes to use each library. Headers that these include are read as well; the first library has them.
HEADERS = {
    "contact": [f"roughcontact/{name}.h" for name in ("roughcontact", "history", "derivatives", "direct", "product", "analysis", "law", "registry")],
    "surface": ["roughcontact/surface.h"],
    "formats": ["roughcontact/formats.h"],
    "request": ["roughcontact/request.h", "roughcontact/budget.h"],
    "flow": ["roughcontact/flow.h"],
    "mpi": ["roughcontact/mpi.h"],
}
# Functions of plugin.h that Python calls; the structs that only this header knows are handles to it.
FROM_PLUGIN = ["rc_context_register"]
# The structs of mpi.h that languages need which know communicators by their Fortran handles.
FROM_MPI = ["rc_exchange", "rc_ranks_counts"]


def filled(words: Sequence[str]) -> str:
    """Words in lines of at most 132 characters, all but the first indented."""
    return textwrap.fill(" ".join(words), 132, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)


def golden(found: Interface) -> List[str]:
    """The numbers of headers: a paragraph for the constants of each enum, one for those of macros, one for each struct."""
    paragraphs = []
    for constants in (*found.enums, found.numbers, found.bits):
        words = [f"{name}={value}" for name, value in constants.items() if not name.startswith("RC_VERSION_")]
        paragraphs += [filled(words)] if words else []
    for struct in found.structs():
        size, offsets = layout(struct, found.known)
        paragraphs.append(filled([f"{struct.name}={size}", *(f"{name}:{at}" for name, at in offsets.items())]))
    return paragraphs


def generated(include: pathlib.Path, cc: str) -> Dict[str, str]:
    """{path: text}"""
    contact = read(HEADERS["contact"], include, cc)
    surface, formats, flow, mpi = (read(HEADERS[name], include, cc, contact) for name in ("surface", "formats", "flow", "mpi"))
    request = read(HEADERS["request"], include, cc, formats)
    with_communicators = mpi.functions.keys()
    mpi.types = {name: mpi.types[name] for name in FROM_MPI}
    mpi.functions = {
        name: each for name, each in mpi.functions.items() if all(kind.base != "MPI_Comm" for _, kind in each.arguments)
    }
    words = (ROOT / "request/words.def").read_text()
    plugin = read(["roughcontact/plugin.h"], include, cc, contact)
    ranks = read(["roughcontact/ranks.h"], include, cc, contact)
    every = [*HEADERS["contact"], *HEADERS["surface"], *HEADERS["formats"], *HEADERS["flow"], *HEADERS["request"], "roughcontact/ranks.h"]
    added = {name: plugin.functions[name] for name in FROM_PLUGIN}
    known = set(with_communicators).union(*(each.functions for each in (contact, ranks, surface, formats, flow)))
    unknown = (SCALARS.keys() | OPTIONAL.keys()) - known
    if unknown:
        sys.exit(f"SCALARS and OPTIONAL name functions that the headers do not have: {', '.join(sorted(unknown))}")
    own, fortran, python = (
        "the headers but surface.h, formats.h, flow.h, ranks.h, mpi.h and plugin.h",
        "bindings/fortran/roughcontact",
        "bindings/python/roughcontact",
    )
    use_c = "  use, intrinsic :: iso_c_binding"
    members = [
        f"{'TEXT' if kind.array else 'NUMBER'}({name})"
        for struct in contact.structs()
        if struct.name == "rc_result"
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
        f"{fortran}_flow_interface.f90": fortran_module(
            "roughcontact_flow_interface",
            [
                "The C interface of <roughcontact/flow.h>, name for name; units, rules and errors are described there. A program",
                "that uses it links libroughcontact-flow, and is then under the GPL because of CHOLMOD.",
            ],
            ["  use roughcontact_structs"],
            [""],
            fortran_constants(flow),
            fortran_structs(flow),
            fortran_functions(flow),
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
            "The constants of the headers, under their names there.", python_constants([contact, surface, formats, flow, request])
        ),
        f"{python}/_limits.py": python_module("Where an elastic answer stops making sense.", python_limits((ROOT / "tools/solve/elastic_limits.def").read_text())),
        f"{python}/_words.py": python_module("The words of request/words.def.", python_words(words)),
        "docs/words.md": words_page(words),
        f"{python}/_status.py": python_module("How a call ended.", python_status(contact)),
        f"{python}/_structs.py": python_module(
            "The structs of the headers, member by member, with the values of the RC_..._INIT macros.",
            "\n\n\n".join(map(python_structs, (contact, surface, formats, flow, request, mpi))),
            after=["_c", "_constants"],
        ),
        f"{python}/_functions.py": python_module(
            "The functions of the headers.",
            python_functions(
                {
                    "ContactFunctions": ("libroughcontact", contact, {**contact.functions, **added}),
                    "SurfaceFunctions": ("libroughcontact-surface", surface, surface.functions),
                    "FormatsFunctions": ("libroughcontact-formats", formats, formats.functions),
                    "FlowFunctions": ("libroughcontact-flow", flow, flow.functions),
                    "RequestFunctions": ("libroughcontact-request", request, request.functions),
                    "MpiFunctions": ("libroughcontact-mpi", mpi, mpi.functions),
                }
            ),
            after=["_c", "_structs"],
        ),
        "tests/contract/abi/golden.txt": "\n".join(
            [
                "# Numbers of the binary interface, written by scripts/bindings.py: constant=value, struct=size, member:offset, functions.",
                *golden(read(every, include, cc)),
                "# plugin.h",
                *golden(plugin),
                "# functions",
                filled(sorted({**contact.functions, **ranks.functions, **plugin.functions})),
                "",
            ]
        ),
        "bindings/octave/result_fields.def": "/* Members of rc_result that rc_solve returns in info, under their names. Written by "
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
