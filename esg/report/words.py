"""A prompt in pieces, each with what became of it."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
import itertools
from typing import Any

_FATES = ("broken", "not_represented", "not_understood", "not_judged", "kept", "ignored", "used")
"""What words may come to, the worst first: where several meet, it is what a reader must see."""


def pieces(
    prompt: str, document: Mapping[str, Any], statements: Iterable[Mapping[str, Any]]
) -> list[dict[str, Any]]:
    """The prompt in pieces, each with what became of it: text, fate and notes.

    A statement covers the words in it, so a piece ends where another fate begins; text of which
    nobody took note has no fate. Places count characters (code points).

    Args:
        prompt: The text.
        document: Its ESG, of which only the coverage is read.
        statements: Rows of its statements (esg.fidelity).
    """
    notes = [*(_item_note(i) for i in document.get("coverage", {}).get("items", []))]
    notes += [_statement_note(row) for row in statements]
    notes = [n for n in notes if 0 <= n["start"] < n["end"] <= len(prompt)]
    edges = sorted({0, len(prompt), *(n[k] for n in notes for k in ("start", "end"))})
    found: list[dict[str, Any]] = []
    for start, end in itertools.pairwise(edges):
        here = [n for n in notes if n["start"] <= start and end <= n["end"]]
        fate = min((n["fate"] for n in here), key=_FATES.index, default="")
        told = [n["note"] for n in here if n["fate"] == fate]
        last = found[-1] if found else None
        # Pieces of one statement read as one.
        if last and last["fate"] == fate and (not fate or set(told) & set(last["notes"])):
            last["text"] += prompt[start:end]
            last["notes"] = list(dict.fromkeys([*last["notes"], *told]))
        else:
            found.append({"text": prompt[start:end], "fate": fate, "notes": told})
    return found


def _item_note(item: Mapping[str, Any]) -> dict[str, Any]:
    parts = (item["kind"], item["status"].replace("_", " "), item.get("note", ""))
    place = {k: item[k] for k in ("start", "end")}
    return {**place, "fate": item["status"], "note": ": ".join(filter(None, parts))}


def _statement_note(row: Mapping[str, Any]) -> dict[str, Any]:
    measured = ", ".join(f"{k.replace('_', ' ')} {v:.3g}" for k, v in row["measured"].items())
    parts = (row["says"].replace("_", " "), row["status"].replace("_", " "), row["reason"])
    text = ": ".join(dict.fromkeys(filter(None, parts)))
    place = {k: row[k] for k in ("start", "end")}
    note = text + (f" (measured: {measured})" if measured else "")
    return {**place, "fate": row["status"], "note": note}
