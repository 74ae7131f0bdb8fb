#!/usr/bin/env python3
"""One version, one set of options and of Debian packages: what the packages of every kind and docs/python.md say is what CMake and
scripts/packages*.txt say.

versions.py SOURCE VERSION
"""

import pathlib
import re
import sys

# The version is in the groups of the first match in the file.
SAYS = {
    "CHANGELOG.md": r"^## (\S+)",
    "CITATION.cff": r"^version: (\S+)",
    "bindings/python/roughcontact/__init__.py": r'^__version__ = "(.*)"',
    "bindings/python/gpl/pyproject.toml": r'"roughcontact==(.*?)"',
    "packaging/debian/changelog": r"^roughcontact \((.*)-1\)",
    "docs/how-to/cite.md": r"solved with roughcontact (\S+)",
    "include/roughcontact/roughcontact.h": r"MAJOR (\d+)\n.*MINOR (\d+)\n.*PATCH (\d+)",
    "packaging/conda/recipe.yaml": r'^  version: "(.*)"',
    "packaging/spack/package.py": r'^    version\("(.*?)"',
}
RECIPES = ["packaging/conda/recipe.yaml", "packaging/spack/package.py", "packaging/conan/conanfile.py", "packaging/vcpkg/portfile.cmake",
           "packaging/debian/rules", "packaging/build.sh", "pyproject.toml", "bindings/python/gpl/pyproject.toml"]


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
        says_version = ".".join(found.groups()) if found else "nothing"
        if says_version != version:
            wrong.append(f"{name} says {says_version}, CMakeLists.txt {version}")
    declared = "".join(file.read_text() for file in [source / "CMakeLists.txt", source / "tools/CMakeLists.txt", source / "formats/CMakeLists.txt", *(source / "bindings").rglob("CMakeLists.txt")])
    options = set(re.findall(r"(?:option|set)\((RC_\w+)", declared))
    for name in RECIPES:
        for option in set(re.findall(r"\bRC_[A-Z_]+\b", (source / name).read_text())) - options:
            wrong.append(f"{name} sets {option}, which no CMakeLists.txt declares")
    packaging = source / "packaging"
    ours = {name: parts.split() for name, parts in re.findall(r"^rc_package\((\S+) COMPONENTS ([a-z -]+)", (packaging / "packages.cmake").read_text(), re.M)}
    rules = {name: parts.split() for name, parts in re.findall(r"^PARTS_(\S+) = (.*)$", (packaging / "debian/rules").read_text(), re.M)}
    control = set(re.findall(r"^Package: (\S+)", (packaging / "debian/control").read_text(), re.M))
    for name in sorted(ours.keys() | rules.keys() | control):
        if name not in control or ours.get(name) != rules.get(name):
            wrong.append(f"{name}: {ours.get(name)} in packaging/packages.cmake, {rules.get(name)} in debian/rules, in debian/control: {name in control}")
    known = {"g++"}  # of build-essential
    for file in (source / "scripts").glob("packages*.txt"):
        known |= set(file.read_text().split())
    document = re.search(r"^apt-get install (.*)$", (source / "docs" / "python.md").read_text(), re.M)
    assert document, "docs/python.md names no packages"
    wrong += [f"docs/python.md names {name}, which scripts/packages*.txt do not" for name in set(document[1].split()) - known]
    print("\n".join(wrong) or f"{len(says)} files say {version}")
    return 1 if wrong else 0


sys.exit(main())
