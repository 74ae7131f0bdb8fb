"""Changes of single operators, and sources in which a number in the environment turns on each: tests/mutants/switches.h."""

import dataclasses
import pathlib
import re

OPPOSITE = {"<": ">=", "<=": ">", ">": "<=", ">=": "<", "==": "!=", "!=": "=="}
EDGE = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
OTHER_SIGN = {"+": "-", "-": "+", "*": "/", "/": "*"}
KINDS = {"<": "lt", "<=": "le", ">": "gt", ">=": "ge", "==": "eq", "!=": "ne", "+": "add", "-": "sub", "*": "mul", "/": "div"}
SPACED = re.compile(r"(?<= )(<=|>=|==|!=|<|>|\+|-|\*|/|&&|\|\||\+=|-=|\*=|/=)(?= )")
NUMBER = re.compile(r"(?<![\w.\"])(\d+\.?\d*(?:e-?\d+)?)(?![\w.\"])")
STATEMENT = re.compile(
    r"^\s*(?!return|const|double|auto|using|if|for|else|std::size_t|std::int64_t|constexpr|static_assert)[\w.>\-\[\]()*&:]+"
    r"(?: [-+*/]?= |\()[^{}]*;\s*$"
)
NO_FUNCTION = r"\s|namespace|class|struct|enum|return|if|for|while|switch|using|typedef|static_assert|template|//|#|[})]"
FUNCTION = re.compile(rf"^( {{0,2}})(?!{NO_FUNCTION})[^;=(]*?(\w+|operator\S+)\(")
NAME = "rc_switch::"
SWITCHES = pathlib.Path(__file__).resolve().parent.parent / "tests/mutants/switches.h"


@dataclasses.dataclass
class Change:
    """Text instead of line[begin:end]. switch: how both are written at once; None: they are not."""

    name: str
    begin: int
    end: int
    text: str
    switch: tuple | None = None

    def applied(self, line):
        return line[: self.begin] + self.text + line[self.end :]


def code_of(line):
    """The line with its comment and the insides of its strings blanked, of the same length."""
    blank = re.sub(r'"(?:[^"\\]|\\.)*"', lambda m: '"' + " " * (len(m.group()) - 2) + '"', line)
    comment = blank.find("//")
    return blank if comment < 0 else blank[:comment] + " " * (len(blank) - comment)


def end_of_term(code, start):
    """Where the factors that begin at `start` end."""
    depth, i = 0, start
    while i < len(code):
        c = code[i]
        if c in "([{":
            depth += 1
        elif c in ")]}":
            if depth == 0:
                return i
            depth -= 1
        elif depth == 0 and (
            c in ",;?:" and code[i : i + 2] != "::" and code[i - 1 : i + 1] != "::" or re.match(r" [-+<>=!&|?:]", code[i:])
        ):
            return i
        i += 1
    return i


def operands_of(code, op, begin, end):
    """Where the operands of && or || begin and end; None if a part stands on another line."""
    inside = "&&" if op == "&&" else "&&||"
    depth, left = 0, begin - 1
    while left >= 0:
        c = code[left]
        depth += (c in ")]}") - (c in "([{")
        before = code[: left + 1]
        if (
            depth < 0
            or depth == 0
            and (
                c in ",;?"
                or before.endswith((" = ", " : ", "return "))
                or before.endswith((" && ", " || "))
                and before[-3:-1] not in inside
            )
        ):
            break
        left -= 1
    depth, right = 0, end
    while right < len(code):
        c = code[right]
        depth += (c in "([{") - (c in ")]}")
        if (
            depth < 0
            or depth == 0
            and (c in ",;?" or code[right:].startswith((" : ", " || ")) or op == "&&" and code[right:].startswith(" && "))
        ):
            break
        right += 1
    return (left + 1 + (code[left + 1] == " "), right) if left >= 0 and right < len(code) else None


def changes(line):
    """Every change of one line."""
    code = code_of(line)
    for m in SPACED.finditer(code):
        op, begin, end = m.group(), m.start(), m.end()
        others = [OPPOSITE.get(op)]
        if op in EDGE and re.match(r" [01]\b(?!\.)", code[end:]):
            others.append(EDGE[op])
        for other in [*others, OTHER_SIGN.get(op)]:
            if other:
                yield Change(f"{op} to {other}", begin, end, other, ("operator", op, KINDS[other]))
        if op in ("+", "-") and (last := end_of_term(code, end + 1)) <= len(code.rstrip()):
            yield Change(f"{op} skipped", begin, last, "", ("operator", op, "first"))
        if op in ("&&", "||"):
            other = "||" if op == "&&" else "&&"
            operands = operands_of(code, op, begin, end)
            yield Change(
                f"{op} to {other}", begin, end, other, operands and ("condition", "both" if op == "&&" else "any", *operands)
            )
        if op in ("+=", "-=", "*=", "/="):
            other = OTHER_SIGN[op[0]] + "="
            yield Change(f"{op} to {other}", begin, end, other, ("text", f"{op} {NAME}At<{{0}}>{{{{}}}} {op}"))
    for m in re.finditer(r"std::(min|max)\b(<)?", code):
        other, both = ("max", "least") if m.group(1) == "min" else ("min", "most")
        yield Change(
            f"{m.group(1)} to {other}",
            m.start(),
            m.end(),
            f"std::{other}{m.group(2) or ''}",
            ("text", f"{NAME}{both}<{{0}}{', ' if m.group(2) else '>'}"),
        )
    for m in re.finditer(
        r"(?<=[(,=] )-(?=\w)|(?<=\()-(?=\w)|(?<=[({])!(?=[\w(])|(?<=&& )!(?=[\w(])|(?<=\|\| )!(?=[\w(])", code
    ):
        yield Change(
            f"{m.group()} dropped",
            m.start(),
            m.end(),
            "",
            ("text", f"{NAME}{'minus' if m.group() == '-' else 'negation'}<{{0}}>{{{{}}}}->*"),
        )
    for m in NUMBER.finditer(code):
        if re.match(r"\s*>", code[m.end() :]) and "<" in code[: m.start()][-12:]:
            continue
        value = m.group(1)
        other = str(int(value) + 1) if value.isdigit() else "1.0" if float(value) == 0 else f"(2 * {value})"
        yield Change(f"{value} to {other}", m.start(), m.end(), other, ("text", f"{NAME}either<{{0}}>({value}, {other})"))
    for m in re.finditer(r"\b(true|false)\b", code):
        other = "false" if m.group() == "true" else "true"
        yield Change(
            f"{m.group()} to {other}", m.start(), m.end(), other, ("text", f"{NAME}either<{{0}}>({m.group()}, {other})")
        )
    for m in re.finditer(r"\bstd::(sqrt|abs)\(", code):
        both = "root" if m.group(1) == "sqrt" else "size"
        yield Change(f"{m.group(1)} skipped", m.start(), m.end() - 1, "", ("text", f"{NAME}{both}<{{0}}>"))
    if STATEMENT.match(code):
        yield Change("statement skipped", 0, len(line), ";", ("statement",))


def function_names(lines):
    """The function that each line stands in; outside of functions the last name before a parenthesis, an = or a semicolon."""
    names, indent, name = [], None, ""
    for line in lines:
        code = code_of(line).rstrip()
        if indent is None:
            found = FUNCTION.match(code)
            if found and not code.endswith(";"):
                indent, name = found.group(1), found.group(2)
            else:
                outside = re.search(r"(\w+)(?:\[.*?\])?(?: =|;|\{)", code)
                names.append(outside.group(1) if outside else "")
                continue
        names.append(name)
        if (
            code == indent + "}"
            or code.startswith(indent)
            and code[len(indent) : len(indent) + 1].strip()
            and code.endswith("}")
        ):
            indent = None
    return names


def can_switch(lines, i, change):
    if change.switch is None or code_of(lines[i]).lstrip().startswith(
        ("constexpr", "static constexpr", "static_assert", "#", "case")
    ):
        return False
    before = next((code for line in reversed(lines[:i]) if (code := code_of(line).strip())), ";")
    return change.switch[0] != "statement" or before.endswith((";", "{", "}", ")", "else"))


def switched(line, numbered):
    """The line with all these changes, each of which its number turns on. numbered: (number, change)."""
    pieces, operators, skipped = [], {}, None
    for number, change in numbered:
        if change.switch[0] == "operator":
            _, op, kind = change.switch
            operators.setdefault((change.begin, op), []).append(f"{number}, {NAME}{kind}")
        elif change.switch[0] == "statement":
            skipped = number
        elif change.switch[0] == "condition":
            _, both, left, right = change.switch
            pieces += [(left, left, f"{NAME}{both}<{number}>("), (right, right, "); })")]
            pieces.append((change.begin - 1, change.end, ", [&] { return static_cast<bool>("))
        else:
            pieces.append((change.begin, change.end, change.switch[1].format(number)))
    for (begin, op), kinds in operators.items():
        pieces.append((begin, begin + len(op), f"{op} {NAME}At<{', '.join(kinds)}>{{}} {op}"))
    code = line[: len(code_of(line).rstrip())]
    for begin, end, text in sorted(pieces, key=lambda piece: piece[:2], reverse=True):
        code = code[:begin] + text + code[end:]
    return code if skipped is None else f"{{ if (!{NAME}on({skipped})) {code.strip()} }}"


def text_of(lines, numbered):
    """The file's text with all changes of its lines. numbered: {index of the line: [(number, change)]}."""
    return "\n".join(switched(line, numbered[i]) if i in numbered else line for i, line in enumerate(lines))


def built(sources, build):
    """Writes the files with those of their changes that can be switched, and with fewer until they compile: the numbers of the changes
    in them, or None if they never compile. sources: {path: (name in messages, text, {index of a line: [(number, change)]})}.
    build(): what each compilation that fails says."""
    left = {}
    for path, (name, text, numbered) in sources.items():
        lines = text.split("\n")
        switchable = {i: [pair for pair in each if can_switch(lines, i, pair[1])] for i, each in numbered.items()}
        left[path] = name, lines, {i: each for i, each in switchable.items() if each}
    for _ in range(60):
        for path, (_, lines, numbered) in left.items():
            text = f'#include "{SWITCHES}"\n#line 1\n{text_of(lines, numbered)}'
            if not path.exists() or path.read_text() != text:
                path.write_text(text)
        failed = build()
        if not failed:
            return [number for _, _, numbered in left.values() for each in numbered.values() for number, _ in each]
        bad = False
        for said in failed:
            first = said.partition("error: ")[0]  # the others may follow from it
            for name, _, numbered in left.values():
                for line in re.findall(rf"{re.escape(name)}:(\d+):", first):
                    bad |= numbered.pop(int(line) - 1, None) is not None
        if not bad:
            return None
    return None
