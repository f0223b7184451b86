"""The page of a study: one HTML file that asks, and a key that tells what was shown.

The page holds films and prompts but no names of variants, so that neither a participant nor whoever
sits beside one knows how a clip was made. A content security policy allows its own script, style
and films and no address at all.
"""

from __future__ import annotations

import base64
from collections.abc import Sequence
import hashlib
import itertools
import json
from pathlib import Path
import re
from typing import Any

from esg.files import atomic_file, refused, write_json
from esg.study.clips import Clip

STATIC = Path(__file__).parent / "static"
KEY_FORMAT, VERSION = "esg-study-key", 1
CONSENT = (
    "You will see short films of scenes that a computer made from a sentence, and rate each of "
    "them. This takes about {minutes} minutes. Taking part is voluntary, and you may stop at any "
    "time by closing the page. The page asks for no name and sends nothing: at the end it offers "
    "you a file with your ratings, a random number and the seconds that each rating took, which "
    "you hand to the person who asked you. That file will be used to compare the ways the films "
    "were made, and may be published."
)
"""What a participant agrees to; --consent replaces it."""
SECONDS_A_CLIP, SECONDS_A_PAIR = 25, 30


def write_study(
    clips: Sequence[Clip], path: Path, *, seed: int, pairs: str | None, consent: str = ""
) -> tuple[Path, Path]:
    """Writes page and key.

    Args:
        clips: All of them.
        path: Of the page; the key is beside it.
        seed: Of the study; a participant's own number is mixed in by the page.
        pairs: Variant that every other one is compared with side by side; None: no pairs.
        consent: Instead of `CONSENT`.

    Returns:
        Paths of the page and of the key.

    Raises:
        UserError: If they cannot be written.
    """
    compared = pairs_of(clips, pairs)
    seconds = SECONDS_A_CLIP * len(clips) + SECONDS_A_PAIR * len(compared)
    text = consent or CONSENT.format(minutes=max(1, round(seconds / 60)))
    about = [[c.id, c.scene, c.variant] for c in clips]
    ident = hashlib.sha256(json.dumps([seed, about, compared, text]).encode()).hexdigest()[:16]
    data = {
        "study": ident,
        "seed": seed,
        "consent": text,
        # In the order of their ids: neither place nor side tells a variant.
        "clips": [
            {"id": c.id, "prompt": c.prompt, "film": _film(c.film)}
            for c in sorted(clips, key=lambda c: c.id)
        ],
        "pairs": sorted(sorted(pair) for pair in compared),
    }
    key = path.with_name(f"{path.stem}.key.json")
    with refused(path.parent):
        path.parent.mkdir(parents=True, exist_ok=True)
        with atomic_file(path) as file:
            file.write(page(data).encode())
        write_json(key, key_of(ident, seed, clips, compared))
    return path, key


def key_of(
    ident: str, seed: int, clips: Sequence[Clip], compared: Sequence[Sequence[str]]
) -> dict[str, Any]:
    """What the analysis needs beside the answers."""
    return {
        "format": KEY_FORMAT,
        "version": VERSION,
        "study": ident,
        "seed": seed,
        "variants": list(dict.fromkeys(c.variant for c in clips)),
        "clips": {c.id: {"scene": c.scene, "variant": c.variant} for c in clips},
        "pairs": [list(pair) for pair in compared],
    }


def pairs_of(clips: Sequence[Clip], against: str | None) -> list[list[str]]:
    """Ids of clips to be seen side by side: a scene's own by every variant, and by one."""
    if against is None:
        return []
    scenes = itertools.groupby(clips, key=lambda c: c.scene)
    return [
        [one.id, other.id]
        for _, group in scenes
        for own in [list(group)]
        for one in own
        if one.variant == against
        for other in own
        if other is not one
    ]


def page(data: dict[str, Any]) -> str:
    """The HTML of a study.

    Args:
        data: What its script reads; nothing of it becomes markup.
    """
    script = (STATIC / "study.js").read_text("utf-8")
    style = (STATIC / "study.css").read_text("utf-8")
    # A closing tag inside the data would end it.
    held = json.dumps(data, ensure_ascii=True, separators=(",", ":")).replace("<", "\\u003c")
    policy = (
        f"default-src 'none'; media-src data: blob:; script-src '{_hash(script)}'; "
        f"style-src '{_hash(style)}'; base-uri 'none'; form-action 'none'"
    )
    parts = {"policy": policy, "style": style, "data": held, "script": script}
    template = (STATIC / "study.html").read_text("utf-8")
    return re.sub(r"\{\{(\w+)\}\}", lambda found: parts[found[1]], template)


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()


def _film(path: Path) -> str:
    return base64.b64encode(path.read_bytes()).decode()
