"""A class that brings what plays it: the shared class and the scene's own in one pair of files."""

from __future__ import annotations

from dataclasses import replace
import re

from esg.compile.build import ClassFiles, shared_texts
from esg.compile.lint import PLAYER

_INCLUDE = re.compile(r'^#include "[^"]+"\n', re.M)


def is_self_contained(files: ClassFiles) -> bool:
    """Whether a class does without the one that plays all scenes."""
    return f'#include "{PLAYER}.h"\n' not in files.header


def self_contained(files: ClassFiles) -> ClassFiles:
    """The same class without another file: names of what it shares become its own.

    Args:
        files: A class, which comes back as it is if it brings everything already.
    """
    if is_self_contained(files):
        return files
    texts = shared_texts()
    own = f'#include "{files.name}.generated.h"\n'
    includes, shared = _parted(texts[f"{PLAYER}.h"])
    comment, scene = files.header.split(f'#include "{PLAYER}.h"\n')
    header = comment + "".join(includes[:-1]) + own + shared + scene.replace(own, "")
    first, played = _parted(texts[f"{PLAYER}.cpp"])
    second, stated = _parted(files.source)
    rest = "".join(sorted({*first[1:], *second[1:]}))
    source = f"{second[0]}\n{rest}{played}{stated}"
    return replace(files, header=_renamed(header, files.name), source=_renamed(source, files.name))


def _parted(text: str) -> tuple[list[str], str]:
    """The includes of a file, and what comes after the last of them."""
    found = list(_INCLUDE.finditer(text))
    return [m.group() for m in found], text[found[-1].end() :]


def _renamed(text: str, name: str) -> str:
    for pattern, own in (
        (rf"\bA{PLAYER}\b", f"A{name}Player"),
        (r"\bFEsg(\w+)\b", rf"F{name}\1"),
        (rf"\bLog{PLAYER}\b", f"Log{name}"),
        (rf"\b{PLAYER}Detail\b", f"{name}Detail"),
    ):
        text = re.sub(pattern, own, text)
    return text
