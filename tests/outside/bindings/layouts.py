#!/usr/bin/env python3
"""Structs and constants of the Fortran modules are those of C: sizes, offsets and values as the golden numbers have them, and new
structs with the values of the RC_..._INIT macros. (The Python package: tests/outside/python/test_raw.py.)

layouts.py SOURCE FC LIBDIR MODULE...
"""

import pathlib
import re
import subprocess
import sys
import tempfile

OF_C = ("rc_exchange", "rc_ranks_counts")
HEADERS = ("history", "derivatives", "direct", "analysis", "law", "registry", "surface", "formats")
PROGRAM = """program layouts
  use roughcontact
  use roughcontact_surface
  use roughcontact_formats
{uses}  implicit none
  logical :: failed = .false.
{calls}
  if (failed) stop 1
contains
  subroutine check(name, found, expected)
    character(*), intent(in) :: name
    integer(c_size_t), intent(in) :: found
    integer, intent(in) :: expected
    if (found == expected) return
    print *, name, found, ', in C', expected
    failed = .true.
  end subroutine
  integer(c_size_t) function distance(to, from)
    type(c_ptr), intent(in) :: to, from
    distance = transfer(to, 0_c_size_t) - transfer(from, 0_c_size_t)
  end function
{bodies}
end program
"""


def main() -> int:
    source, compiler, libraries, modules = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3], sys.argv[4:]
    sys.path.insert(0, str(source / "tests" / "contract" / "abi"))
    constants, sizes, offsets, _ = __import__("golden").numbers(plugin=False)
    texts = {file.stem: file.read_text() for file in (source / "include" / "roughcontact").glob("*.h")}
    flow = ["flow"] if "roughcontact_flow.f90" in modules else []  # where it is built
    headers, of_c = "".join(texts.values()), "".join(texts[name] for name in ("flow", "request", "budget") if name not in flow)
    calls, bodies, structs = [], [], 0
    begun = ["#include <string.h>", *(f"#include <roughcontact/{name}.h>" for name in (*HEADERS, *flow))]
    for name, value in constants.items():
        if not re.search(rf"\b{name}\b", of_c):
            calls.append(f"  call check('{name}', int({name}, c_size_t), {value})")
    for struct, size in sizes.items():
        members = offsets[struct].items()
        if not members or struct in OF_C or f"}} {struct};" in of_c:
            continue  # a number, or not in the modules
        structs += 1
        calls.append(f"  call check_{struct}()")
        lines = [
            f"type({struct}), target :: x",
            f"integer(c_int8_t) :: ours({size}), theirs({size})",
            f"call check('{struct}', storage_size(x, c_size_t) / 8, {size})",
        ]
        if ("struct_size", 0) in members:
            lines.append(f"call check('{struct}%struct_size', x%struct_size, {size})")
        lines += [
            f"call check('{struct}%{member}', distance(c_loc(x%{member}), c_loc(x)), {offset})" for member, offset in members
        ]
        if f"#define {struct.upper()}_INIT" in headers:
            begun.append(f"void begin_{struct}_(void *x) {{ {struct} new = {struct.upper()}_INIT; memcpy(x, &new, sizeof new); }}")
            lines += [
                "ours = transfer(x, ours)",
                f"call begin_{struct}(theirs)",
                f"call check('values of {struct}', count(ours /= theirs, kind=c_size_t), 0)",
            ]
        bodies += [f"  subroutine check_{struct}()", *(f"    {line}" for line in lines), "  end subroutine"]
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder) / "layouts.f90"
        program.write_text(PROGRAM.format(uses="".join(f"  use roughcontact_{name}\n" for name in flow), calls="\n".join(calls), bodies="\n".join(bodies)))
        program.with_suffix(".c").write_text("\n".join(begun) + "\n")
        subprocess.run(["cc", "-c", f"-I{source / 'include'}", "layouts.c", "-o", "begun.o"], check=True, cwd=folder)
        files = [str(source / "bindings" / "fortran" / module) for module in modules]
        links = [f"-L{libraries}", f"-Wl,-rpath,{libraries}", *(f"-lroughcontact-{name}" for name in (*flow, "surface", "formats")), "-lroughcontact"]
        subprocess.run([compiler, "-O0", *files, str(program), "begun.o", "-o", "layouts", *links], check=True, cwd=folder)
        status = subprocess.run([str(program.with_suffix(""))]).returncode
    print(f"{structs} structs, {len(calls) - structs} constants")
    return status


sys.exit(main())
