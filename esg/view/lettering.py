"""Text on pictures: a font that ships with this package, and words where it has no glyph."""

from __future__ import annotations

from functools import lru_cache
from importlib import resources
from typing import Any
import unicodedata

FONT = "font/captions.ttf"
MISSING = "\uffff"
"""Stands for whatever the font lacks; no text holds it."""


@lru_cache
def font(size: int) -> Any:
    """The font of all pictures, on every machine the same.

    Args:
        size: Of the letters [px].
    """
    from PIL import ImageFont

    with resources.as_file(resources.files("esg.view") / FONT) as path:
        return ImageFont.truetype(str(path), size)


def lettered(text: str) -> str:
    """The text as the font can write it.

    Accents stay; letters it lacks lose their accents; a symbol becomes its name in brackets; marks
    that change their neighbour (skin tones, joiners) go; anything else is a question mark.
    """
    text = unicodedata.normalize("NFC", text)
    return "".join(_written(c) for c in text)


def wrapped(text: str, size: int, width: int) -> list[str]:
    """The text in lines of at most `width` pixels; a word that is longer than a line is cut.

    Args:
        text: Any text.
        size: Of the letters [px].
        width: Of a line [px].
    """
    face = font(size)
    lines: list[str] = []
    current = ""
    for word in lettered(text).split():
        candidate = f"{current} {word}".strip()
        if current and face.getlength(candidate) > width:
            lines.append(current)
            candidate = word
        current = candidate
        while len(current) > 1 and face.getlength(current) > width:
            cut = len(current) - 1
            while cut > 1 and face.getlength(current[:cut]) > width:
                cut -= 1
            lines.append(current[:cut])
            current = current[cut:]
    return [*lines, current]


def fitted(text: str, size: int, width: int) -> str:
    """The text in one line of at most `width` pixels, with an ellipsis where it was cut."""
    face, text = font(size), lettered(text)
    if face.getlength(text) <= width:
        return text
    while text and face.getlength(text + "\u2026") > width:
        text = text[:-1]
    return text.rstrip() + "\u2026"


@lru_cache(maxsize=4096)
def _written(character: str) -> str:
    kind = unicodedata.category(character)
    if character.isspace():
        return " "
    if kind in ("Mn", "Me", "Cf", "Cc"):
        return ""
    if _has_glyph(character):
        return character
    if kind == "Sk":  # skin tones
        return ""
    base = "".join(c for c in unicodedata.normalize("NFKD", character) if _has_glyph(c))
    if base:
        return base
    name = unicodedata.name(character, "").lower()
    return f"[{name}]" if kind.startswith("S") and name else "?"


def _has_glyph(character: str) -> bool:
    return _picture(character) != _picture(MISSING)


@lru_cache(maxsize=4096)
def _picture(character: str) -> tuple[tuple[int, int], bytes]:
    mask = font(20).getmask(character)
    return mask.size, bytes(mask)
