"""What a model is told: instructions of each stage, words generated from the tables, examples.

The instructions are files beside the code (`esg/draft/prompts`). Where one says `{events}` or the
like, the words and their meanings of `vocabulary.csv` are put in: every word that the document
allows has a row there, and no other (tested), so that the instructions cannot drift from it.
"""

from __future__ import annotations

from functools import cache
from importlib import resources
import json
from typing import Any

_PARTS = {
    "scene": ("shared", "scene", "examples:scene"),
    "timeline": ("shared", "timeline", "examples:timeline"),
    "single_shot": ("shared", "single_shot", "scene", "timeline", "examples:single_shot"),
    "small": ("small",),
    "visual": ("shared", "visual"),
}


def _file(name: str) -> str:
    return (resources.files("esg.draft") / "prompts" / name).read_text(encoding="utf-8")


@cache
def vocabulary() -> dict[str, dict[str, str]]:
    """Meanings by kind of word and word: the rows of `vocabulary.csv`."""
    out: dict[str, dict[str, str]] = {}
    for line in _file("vocabulary.csv").splitlines()[1:]:
        kind, word, meaning = line.split(";", 2)  # a meaning may hold further semicolons
        out.setdefault(kind, {})[word] = meaning
    return out


@cache
def examples() -> tuple[dict[str, Any], ...]:
    """Prompts of our own with the answers of every stage."""
    return tuple(json.loads(_file("examples.json")))


@cache
def instructions(stage: str) -> str:
    """System text of a stage: what holds everywhere, its task, its words, its examples."""
    parts = [_shown(part) for part in _PARTS[stage]]
    text = "\n\n".join(parts)
    for kind, words in vocabulary().items():
        lines = "\n".join(f"- {w}: {meaning}" for w, meaning in words.items())
        text = text.replace("{" + kind + "}", lines)
    return text.replace("{jointed}", ", ".join(_jointed()))


def _shown(part: str) -> str:
    kind, _, stage = part.partition(":")
    if not stage:
        return _file(f"{kind}.md").strip()
    told = ["Examples (leave out what is left out in them):"]
    for example in examples():
        answer = example[stage] if stage in example else _whole(example)
        if answer is None:
            continue
        settled = ""
        if stage == "timeline":
            names = (o["name"] for o in example["scene"]["assets"]["objects"])
            settled = f"\nObjects: {', '.join(names)}"
        told.append(f"<<<\n{example['prompt']}\n>>>{settled}\n{_compact(answer)}")
    return "\n\n".join(told)


def _whole(example: dict[str, Any]) -> dict[str, Any]:
    return {**example["scene"], "timeline": example["timeline"]}


def _compact(answer: Any) -> str:
    return json.dumps(answer, ensure_ascii=False, separators=(",", ":"))


def _jointed() -> list[str]:
    """Things that hang, turn or slide on a joint, each by its first name."""
    from esg.lexicon.articulations import articulations

    return list(dict.fromkeys(row.nouns[0] for row in articulations().values()))
