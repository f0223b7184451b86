"""Names that come from a prompt, made safe for C++ and for Unreal asset paths.

Nothing a user writes reaches emitted code except through this module: identifiers consist of ASCII
letters, digits and single underscores, string literals of printable ASCII with escapes, comments of
letters, digits and blanks.
"""

from __future__ import annotations

from collections.abc import Iterable
import re
import unicodedata

MAX_IDENTIFIER = 48
"""Longest identifier taken from a name; Unreal paths grow with it."""

RESERVED = frozenset({"none", "ground", "vehicleground", "sceneroot"})
"""Component names the class uses itself, and Unreal's empty name, in lower case.

C++ keywords, members of AActor and macros need no list: an identifier is only ever used with a
suffix (`<Name>Mesh`, `<Name>Settings`, `<Name>Launch1`) or inside a string.
"""


def identifier(text: str, fallback: str = "Object") -> str:
    """CamelCase ASCII identifier for `text`: a letter first, never a reserved name.

    Args:
        text: Any string, empty included.
        fallback: Prefix where `text` has no usable letter first.
    """
    ascii_text = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    words = re.findall(r"[A-Za-z]+|[0-9]+", ascii_text)
    out = ""
    for word in words:
        glue = "_" if out and out[-1].isdigit() and word[0].isdigit() else ""
        out += glue + word[0].upper() + word[1:]
    out = out[:MAX_IDENTIFIER].rstrip("_")
    if not out or out[0].isdigit():
        out = fallback + out
    if out.lower() in RESERVED:
        out += fallback
    return out


def unique_identifiers(
    names: Iterable[str], fallback: str = "Object", reserved: Iterable[str] = ()
) -> dict[str, str]:
    """Maps names to identifiers that differ even on case-insensitive file systems.

    Names are handled in order; a collision gets the next free number after an underscore.

    Args:
        names: What to name.
        fallback: For a name without a usable character.
        reserved: Identifiers that none may get.

    Raises:
        ValueError: If a name appears twice.
    """
    out: dict[str, str] = {}
    taken = {r.lower() for r in reserved}
    for name in names:
        if name in out:
            raise ValueError(f"name {name!r} appears twice")
        base = candidate = identifier(name, fallback)
        number = 2
        while candidate.lower() in taken:
            candidate = f"{base}_{number}"
            number += 1
        taken.add(candidate.lower())
        out[name] = candidate
    return out


def string_literal(text: str) -> str:
    """TEXT("...") of `text`: printable ASCII, everything else as `?`, no trigraph, no escape left.

    Percent signs are kept: literals are never used as format strings.
    """
    ascii_text = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    out: list[str] = []
    for char in ascii_text:
        if char in '"\\':
            out.append("\\" + char)
        elif char == "?":
            out.append("\\?")
        elif char.isprintable():
            out.append(char)
        else:
            out.append(" ")
    return f'TEXT("{"".join(out)}")'


def comment(text: str, limit: int = 160) -> str:
    """`text` reduced to what cannot end a comment, open another or continue a line."""
    ascii_text = unicodedata.normalize("NFKD", text).encode("ascii", "ignore").decode()
    return " ".join(re.sub(r"[^A-Za-z0-9 .,;:()+\-=_']", " ", ascii_text).split())[:limit].strip()
