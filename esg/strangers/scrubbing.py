"""Keys kept out of whatever is written or shown, in every form in which a server may echo them."""

from __future__ import annotations

import base64
from functools import lru_cache
import os
import re

MARK = "[secret]"
_NAMES = ("API_KEY", "TOKEN", "SECRET", "PASSWORD", "ACCESS_KEY")
"""Endings of environment variables that hold keys."""
_LEAST = 8
"""Characters: a shorter value of such a variable is no key, and stands in any text by chance."""


def scrub(text: str, secret: str) -> str:
    """The text without the secret: plain, escaped for JSON, URLs or HTML, as hex or base64.

    Args:
        text: Any text.
        secret: The secret; empty leaves the text as it is.
    """
    return _pattern(secret).sub(MARK, text) if secret else text


def scrub_all(text: str) -> str:
    """The text without any key that an environment variable holds."""
    for name, value in os.environ.items():
        if name.upper().endswith(_NAMES) and len(value) >= _LEAST:
            text = scrub(text, value)
    return text


@lru_cache(maxsize=32)
def _pattern(secret: str) -> re.Pattern[str]:
    whole = "".join(_character(c) for c in secret)
    data = secret.encode("utf-8", "surrogatepass")
    digits = "".join(f"[{c.lower()}{c.upper()}]" if c.isalpha() else c for c in data.hex())
    return re.compile("|".join([whole, digits, *_base64(data)]))


def _character(c: str) -> str:
    """A character in every spelling: one text may mix them."""
    code = ord(c)
    escaped = "".join(f"%{b:02x}" for b in c.encode("utf-8", "surrogatepass"))
    spellings = [
        re.escape(c),
        rf"\\{{1,8}}u(?i:{code:04x})",
        rf"\\x(?i:{code:02x})",
        rf"\\{{1,8}}{re.escape(c)}",
        f"(?i:{escaped})",
        f"(?i:{escaped.replace('%', '%25')})",
        f"&#0*{code};",
        f"&#[xX]0*(?i:{code:x});",
    ]
    if c == " ":
        spellings.append(r"\+")
    return f"(?:{'|'.join(spellings)})"


def _base64(data: bytes) -> list[str]:
    """The data as it looks inside longer data that was encoded, at each of three places."""
    out: list[str] = []
    for before in range(3):
        text = base64.b64encode(bytes(before) + data).decode()
        first, last = -(-before * 8 // 6), (before + len(data)) * 8 // 6
        core = text[first:last]
        if len(core) >= _LEAST:
            either = core.replace("+", "[+-]").replace("/", "[/_]")
            out.append(f"{either}[A-Za-z0-9+/=_-]{{0,4}}")
    return out
