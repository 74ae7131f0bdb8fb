"""The page: figures and words put into the template, in one file."""

import base64
import gzip
import importlib.util
import json
import pathlib
from typing import Any, Dict, Tuple

from .._paths import shown
from . import wording
from .content import Content
from .figures import figures_of

NEEDED = ("jinja2", "plotly")


def missing_packages() -> Tuple[str, ...]:
    """Which of the packages that a page is made with are absent."""
    return tuple(name for name in NEEDED if importlib.util.find_spec(name) is None)


def _packed(text: str) -> str:
    """Compressed, so that the page stays small; the browser unpacks it. The same text gives the same bytes."""
    return base64.b64encode(gzip.compress(text.encode(), mtime=0)).decode()


def page(content: Content) -> str:
    """The page's HTML."""
    figures, plotly = figures_of(content)
    drawn = ",".join(f"{json.dumps(each.name)}:{each.figure.to_json()}" for each in figures)
    words: Dict[str, Any] = {
        "name": shown(pathlib.Path(content.input["file"]).name),
        "facts": wording.facts(content),
        "conclusion": wording.conclusion(content),
        "certificate": wording.certificate(content),
        "doubts": wording.doubts(content),
        "step_head": wording.step_head(content),
        "steps": wording.step_rows(content),
        "leak_head": wording.LEAK_HEAD,
        "leaks": wording.leak_rows(content),
        "fluid": content.words.get("leak"),
        "sure": wording.sentences(content),
        "budget_head": wording.budget_head(content),
        "budget": wording.budget_rows(content),
        "proof_head": wording.PROOF_HEAD,
        "proofs": wording.proof_rows(content),
        "surface": wording.surface_rows(content),
        "assumptions": wording.assumptions(content),
        "citation": wording.CITATION,
        "persson": wording.PERSSON if content.persson else None,
        "command": shown(content.command),
        "version": content.version,
        "figures": {each.name: each for each in figures},
        "plotly": _packed(plotly),
        "drawn": _packed("{" + drawn + "}"),
    }
    jinja = importlib.import_module("jinja2")
    text = (pathlib.Path(__file__).parent / "page.html.j2").read_text(encoding="utf-8")
    made = jinja.Environment(autoescape=True, undefined=jinja.StrictUndefined, trim_blocks=True, lstrip_blocks=True)
    rendered: str = made.from_string(text).render(words)
    return rendered
