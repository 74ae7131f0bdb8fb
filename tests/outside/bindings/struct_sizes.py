#!/usr/bin/env python3
"""struct_sizes.py INCLUDE FORTRAN CC...: the sizes of structs in the Fortran modules in the folder FORTRAN are those of each compiler that is
installed, whether its addresses have 8 bytes or 4."""
import pathlib
import re
import shutil
import subprocess
import sys

HEADERS = ("roughcontact", "history", "derivatives", "direct", "product", "analysis", "law", "ranks", "registry", "formats", "surface", "flow", "request")


def main():
    include, fortran, compilers = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3:]
    text = "\n".join(file.read_text() for file in sorted(fortran.glob("roughcontact*.f90")))
    sizes = re.findall(r"type, bind\(c\) :: (\w+)\n\s*integer\(c_size_t\) :: struct_size = merge\((\d+), (\d+), c_intptr_t == 8\)", text)
    assert len(sizes) == text.count(":: struct_size = ") > 20, sizes
    source = "".join(f"#include <roughcontact/{header}.h>\n" for header in HEADERS)
    source += "".join(
        f'_Static_assert(sizeof({name}) == (sizeof(void*) == 8 ? {eight} : {four}), "{name}");\n' for name, eight, four in sizes
    )
    for compiler in filter(shutil.which, compilers):
        subprocess.run([compiler, "-std=c11", "-fsyntax-only", "-I", include, "-x", "c", "-"], input=source, text=True, check=True)
        print(f"{len(sizes)} structs as {compiler} has them")


main()
