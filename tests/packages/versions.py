#!/usr/bin/env python3
"""One version and one set of options: what the packages of every kind say is what CMake says.

versions.py SOURCE VERSION
"""

import pathlib
import re
import sys

# The version is the first group of the first match in the file.
SAYS = {
    "CHANGELOG.md": r"^## (\S+)",
    "CITATION.cff": r"^version: (\S+)",
    "bindings/python/roughcontact/__init__.py": r'^__version__ = "(.*)"',
    "packaging/conda/recipe.yaml": r'^  version: "(.*)"',
    "packaging/spack/package.py": r'^    version\("(.*?)"',
    "tools/roughcontact.1": r'"roughcontact (\S+)"',
}
RECIPES = ["packaging/conda/recipe.yaml", "packaging/spack/package.py", "packaging/build.sh", "pyproject.toml"]


def main() -> int:
    source, version = pathlib.Path(sys.argv[1]), sys.argv[2]
    wrong = []
    says = dict(SAYS)
    for folder in ("src", "backends"):
        for file in sorted((source / folder).rglob("*.cpp")):
            if re.search(r"\.version = ", file.read_text()):
                says[str(file.relative_to(source))] = r'\.version = "(.*?)"'
    for name, pattern in says.items():
        found = re.search(pattern, (source / name).read_text(), re.M)
        if not found or found[1] != version:
            wrong.append(f"{name} says {found[1] if found else 'nothing'}, CMakeLists.txt {version}")
    declared = "".join(file.read_text() for file in [source / "CMakeLists.txt", *(source / "bindings").rglob("CMakeLists.txt")])
    options = set(re.findall(r"(?:option|set)\((RC_\w+)", declared))
    for name in RECIPES:
        for option in set(re.findall(r"\bRC_[A-Z_]+\b", (source / name).read_text())) - options:
            wrong.append(f"{name} sets {option}, which no CMakeLists.txt declares")
    print("\n".join(wrong) or f"{len(says)} files say {version}")
    return 1 if wrong else 0


sys.exit(main())
