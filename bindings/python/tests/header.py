"""What the C headers declare, in the words of the Python package, and how a C compiler lays it out."""

import re
import subprocess


def without_comments(text):
    return re.sub(r"/\*.*?\*/", " ", text, flags=re.S)


class Header:
    """constants, functions: {name: declaration}, structs: {name: [(member, declaration)]}"""

    def __init__(self, text):
        text = without_comments(text)
        self.constants = {
            k: int(v) for k, v in re.findall(r"^#define (RC_(?:VERSION_\w+|ABI|SURFACE_PEAKS)) (\d+)", text, re.M)
        }
        self.constants.update(re.findall(r'^#define (RC_OPT_\w+) "(.*)"', text, re.M))
        text = re.sub(r"^#(.*\\\n)*.*$", "", text, flags=re.M)
        for body in re.findall(r"enum \{(.*?)\}", text, re.S):
            self.constants.update((k, int(v)) for k, v in re.findall(r"(\w+)\s*=\s*(-?\d+)", body))
        self.callbacks = {
            name: " ".join(f"{result} ({arguments})".split())
            for result, name, arguments in re.findall(r"typedef ([^;()]*)\(\*(\w+)\)\(([^;]*)\);", text)
        }
        self.structs = {name: list(self.members(body)) for name, body in re.findall(r"struct (rc_\w+) \{(.*?)\n\}", text, re.S)}
        self.functions = {
            name: " ".join(declaration.split())
            for declaration, name in re.findall(r"RC_API ([^;]*?(\brc_\w+)\([^;]*\));", text)
        }

    @staticmethod
    def members(body):
        for declaration in body.split(";"):
            declaration = " ".join(declaration.split())
            function = re.search(r"\(\*(\w+)\)", declaration)
            if function:
                yield function[1], declaration
            elif declaration:
                base, names = re.match(r"((?:const )?\w+) (.*)", declaration).groups()
                for name in names.split(","):
                    name = name.strip()
                    yield re.search(r"\w+", name)[0], f"{base} {name}"


def c_layout(folder, compiler, headers, structs):
    """{(struct, member): (offset, size)}; ("rc_step", "") has the size of the struct itself."""
    lines = []
    for name, members in structs.items():
        lines.append(f'printf("{name} . 0 %zu\\n", sizeof(struct {name}));')
        lines += [
            f'printf("{name} {m} %zu %zu\\n", offsetof(struct {name}, {m}), sizeof(((struct {name} *)0)->{m}));'
            for m, _ in members
        ]
    includes = "".join(f'#include "{header}"\n' for header in headers)
    (folder / "probe.c").write_text(
        f"#include <stdio.h>\n{includes}int main(void) {{\n" + "\n".join(lines) + "\nreturn 0;\n}\n"
    )
    subprocess.run([compiler, str(folder / "probe.c"), "-o", str(folder / "probe")], check=True, cwd=folder)
    found = {}
    for line in subprocess.check_output([str(folder / "probe")], text=True).splitlines():
        struct, member, offset, size = line.split()
        found[struct, member.strip(".")] = int(offset), int(size)
    return found
