"""The words of requests, from the text of request/words.def: for the Python package, and a page of the documents."""

import re
import textwrap
from typing import Any, List, Tuple

CALLS = ("solve", "history", "batch", "law", "analyze", "ranks")


def words(table: str) -> List[Tuple[Any, ...]]:
    """The rows of the table, which reads as Python."""
    rows: List[Tuple[Any, ...]] = []
    calls = {f"RC_CALL_{name.replace('ranks', 'rows').upper()}": 1 << k for k, name in enumerate(CALLS)}
    every = sum(calls.values())
    text = re.sub(r"^//.*\n", "", table, flags=re.M)
    kinds = {name: name for name in re.findall(r"RC_WORD_\w+", text)}
    own = {"every": every, "presses": every & ~calls["RC_CALL_ANALYZE"], "steps": calls["RC_CALL_SOLVE"] | calls["RC_CALL_HISTORY"], "in_time": calls["RC_CALL_HISTORY"] | calls["RC_CALL_BATCH"] | calls["RC_CALL_ROWS"], "no_time": "one step alone, a law and an analysed surface have no time", "elastic": "", "loading": "", "most_targets": 100000, "most_terms": 2000}
    exec(text, {**calls, **kinds, **own, "nothing": "nothing presses when a surface is analysed", "whole": every & ~calls["RC_CALL_ROWS"], "alone": "a rank has some rows, and this needs others", "RC_REQUEST_WORD": lambda *row: rows.append(row)})
    return rows


def python_words(table: str) -> str:
    """The words of calls that solve; surfaces are arguments, options of the library keywords, and flows have functions."""
    taken = [row for row in words(table) if row[1] != "RC_WORD_OPTION" and row[0] not in ("surface", "gap", "closing-pressure", "leak") and row[8] & 1]
    lines = []
    for name, _, _, _, form, text, *_ in taken:
        pair = f'    "{name.replace("-", "_")}": ("{form}", "{text}"),'
        texts = textwrap.wrap(text, 110, drop_whitespace=False)
        pieces = [f'        "{line}"' for line in texts]
        lines += [pair] if len(pair) <= 128 else [f'    "{name.replace("-", "_")}": (', f'        "{form}",', *pieces[:-1], pieces[-1] + ",", "    ),"]
    return "\n".join(["#: {word: (form of its value, meaning)}", "HELP = {", *lines, "}"])


def words_page(table: str) -> str:
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
    for name, _, _, _, form, text, _, example, calls, why_not in words(table):
        without = ", ".join(call for k, call in enumerate(CALLS) if not calls >> k & 1)
        value = f"{form}, `{example}`" if example else form
        lines.append(f"| `{name}` | {value} | {text} | {f'{without}: {why_not}' if without else ''} |")
    return "\n".join(lines) + "\n"
