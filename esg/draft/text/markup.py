"""The text of a prompt without what surrounds it: markup, addresses, lists, a data format."""

from __future__ import annotations

import json
import re
from typing import cast

from esg.outcomes import UserError

MAX_WORD = 120
"""Longest word that is text and no data, in characters."""
_CODE = re.compile(r"<(script|style)\b.*?</\1\s*>", re.IGNORECASE | re.DOTALL)
_TAG = re.compile(r"</?[a-zA-Z][^<>]{0,200}>|<!--.*?-->", re.DOTALL)
_ADDRESS = re.compile(r"\b(?:https?|ftp|file)://\S+|\bwww\.\S+", re.IGNORECASE)
_HEADING = re.compile(r"^[ \t]*#{1,6}[ \t]+(.+?)[ \t:#]*$", re.MULTILINE)
_NUMBERED = re.compile(r"^([ \t]*)\d{1,3}[.)][ \t]+(?=\S)", re.MULTILINE)
_EMPHASIS = re.compile(r"(\*{1,3}|_{2,3}|`{1,3}|~~)(?=\S)(.+?)(?<=\S)\1", re.DOTALL)
_FENCE = re.compile(r"^[ \t]*```.*$", re.MULTILINE)
_LATEX = re.compile(r"\\(?:mathrm|text|textbf|textit|emph|mathbf|rm|si|SI)\s*\{([^{}]*)\}")
_LATEX_SPACE = re.compile(r"\\[,;:! ]")
_FORMULA = re.compile(r"\$([^$\n]{1,80})\$")
_SYMBOLS = {
    "m": "mass", "M": "mass", "v": "speed", "r": "radius", "R": "radius", "d": "diameter",
    "D": "diameter", "h": "height", "H": "height", "l": "length", "L": "length", "w": "width",
}  # fmt: skip
_SYMBOL = re.compile(r"(?<![\w=])([mMvrRdDhHlLw])(?:_?[0-9a-zA-Z])?\s*[=≈]\s*(?=\d)")
""" "m = 2 kg", "v0 = 3 m/s": quantities by their symbols."""
_TOLD = ("prompt", "description", "text", "scene", "caption")


def plain(prompt: str) -> str:
    """The sentences of a prompt, without markup.

    Args:
        prompt: Text as a user pastes it: HTML, Markdown, LaTeX, or a JSON object that holds it.

    Raises:
        UserError: If it is structured data without a text, or holds a word that is no word.
    """
    text = _from_json(prompt)
    text = _TAG.sub(" ", _CODE.sub(" ", text))
    text = _ADDRESS.sub(" ", _FENCE.sub("", text))
    text = _LATEX_SPACE.sub(" ", _LATEX.sub(r"\1", text))
    text = _FORMULA.sub(r"\1", text)
    text = _HEADING.sub(r"\1:", text)
    text = _NUMBERED.sub(r"\1- ", text)
    text = _EMPHASIS.sub(r"\2", text)
    text = _SYMBOL.sub(lambda m: f"{_SYMBOLS[m[1]]} ", text)
    longest = max(re.findall(r"\S+", text), key=len, default="")
    if len(longest) > MAX_WORD:
        raise UserError(
            f"The prompt holds {longest[:40]!r}..., {len(longest):,} characters without a space; "
            "write it in words."
        )
    return text


def _from_json(prompt: str) -> str:
    """The text in a JSON object, or the prompt itself if it is none."""
    if prompt.lstrip()[:1] not in ("{", "["):
        return prompt
    try:
        data: object = json.loads(prompt)
    except (ValueError, RecursionError):
        return prompt
    fields = cast(dict[str, object], data) if isinstance(data, dict) else {}
    told = next((t for k in _TOLD if isinstance(t := fields.get(k), str)), None)
    if told is None:
        raise UserError(
            f"The prompt {prompt.strip()[:40]!r}... is JSON without a "
            f"{', '.join(repr(k) for k in _TOLD[:3])} that holds a text; describe the scene in "
            "sentences."
        )
    return told
