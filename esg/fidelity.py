"""What a scene keeps of its prompt: every statement, verb and quantity by what became of it.

Documents, verdicts and rows are plain JSON here, as commands, tables and pages read them. A row of
a statement has id, says (its predicate), words, start and end (their place in the prompt), status,
kept (None unless it was measured), measured and reason; a shortfall has words, start, end, status
and reason.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

Row = dict[str, Any]

NOT_REPRESENTED = "not_represented"
NOT_UNDERSTOOD = "not_understood"
UNSEEN = (NOT_REPRESENTED, NOT_UNDERSTOOD)
"""Statuses of words of which no scene shows anything."""
_LOST = ("broken", NOT_REPRESENTED)
_DROPPED = {
    "event": "no event was made of this verb",
    "quantity": "nothing in the scene has this quantity",
}
"""Kinds of words that a scene must show, and what is said of one that it does not."""
_MOST = 10


def statement_rows(
    document: Mapping[str, Any], verdicts: Iterable[Mapping[str, Any]] | None = None
) -> list[Row]:
    """The rows of a document's statements, in its order; none is ever left out.

    Args:
        document: The ESG.
        verdicts: The judge's, of its statements; None if it was never judged.
    """
    found = None if verdicts is None else {v["id"]: v for v in verdicts}
    return [_row(s, found) for s in document.get("statements") or ()]


def _row(statement: Mapping[str, Any], found: Mapping[str, Mapping[str, Any]] | None) -> Row:
    row: Row = {
        "id": statement["id"],
        "says": statement["predicate"],
        "words": statement["text"],
        "start": statement["start"],
        "end": statement["end"],
        "kept": None,
        "measured": {},
    }
    if statement["predicate"] == NOT_REPRESENTED:
        return {**row, "status": NOT_REPRESENTED, "reason": statement.get("note", "")}
    if found is None:
        return {**row, "status": "not_judged", "reason": ""}
    verdict = found.get(statement["id"])
    if verdict is None:
        return {**row, "status": NOT_REPRESENTED, "reason": "nothing measures it"}
    return {**row, **judged(verdict), "words": statement["text"]}


def judged(verdict: Mapping[str, Any]) -> Row:
    """What a verdict adds to a statement's row."""
    kept = verdict["kept"]
    return {
        "id": verdict["id"],
        "says": verdict["says"],
        "status": NOT_REPRESENTED if kept is None else "kept" if kept else "broken",
        "kept": kept,
        "measured": dict(verdict.get("measured", {})),
        "reason": verdict.get("reason", ""),
    }


def shortfalls(document: Mapping[str, Any], rows: Iterable[Mapping[str, Any]]) -> list[Row]:
    """What of a prompt is not shown, in its order.

    Statements that are broken or not represented, verbs of which no event was made, and quantities
    of which nothing was made.

    Args:
        document: The ESG, of which only the coverage is read.
        rows: Of its statements.
    """
    names = ("words", "start", "end", "status", "reason")
    lost = [{k: row[k] for k in names} for row in rows if row["status"] in _LOST]
    told = [(row["start"], row["end"]) for row in lost]
    lost += [
        {
            "words": item["text"],
            "start": item["start"],
            "end": item["end"],
            "status": NOT_UNDERSTOOD,
            "reason": item.get("note") or _DROPPED[item["kind"]],
        }
        for item in _dropped(document)
        if not any(a <= item["start"] and item["end"] <= b for a, b in told)
    ]
    return sorted(lost, key=lambda row: (row["start"], row["end"]))


def unplaced(document: Mapping[str, Any]) -> list[Row]:
    """Relations between things that the layout did not satisfy, as shortfalls; they have no words.

    Args:
        document: The ESG with its layout. Where things face is the layout's own choice, and what
            the planned start moves where it belongs is held.
    """
    reports = (document.get("layout_result") or {}).get("relations", ())
    return [
        {
            "words": r["edge"].replace("_", " "),
            "start": 0,
            "end": 0,
            "status": "broken",
            "reason": r.get("note") or "the layout does not satisfy it",
        }
        for r in reports
        if not r["satisfied"]
        and r["relation_type"] != "face"
        and "held by the planned start" not in r.get("note", "")
    ]


def stand_ins(document: Mapping[str, Any]) -> list[str]:
    """Warnings of what is drawn as something else, because the library has nothing for it.

    What the drafter warned of already is left out.

    Args:
        document: The ESG with its assets.
    """
    configs = document.get("asset_configurations") or {}
    told = " ".join((document.get("coverage") or {}).get("warnings", ()))
    nodes = (document.get("spatial_relation_graph") or {}).get("nodes") or {}
    out: list[str] = []
    for node in nodes.values():
        config = configs.get(node["asset_id"]) or {}
        label = node.get("label") or node["asset_id"]
        if not node.get("mentioned") or config.get("source") != "fallback" or f'"{label}"' in told:
            continue
        size = " x ".join(f"{d:.3g}" for d in config["dimensions_cm"])
        drawn = config["asset_name"].rpartition("/")[2].replace("_", " ")
        out.append(f'The library has nothing for "{label}": drawn as a {drawn} of {size} cm.')
    return list(dict.fromkeys(out))


def lost_in(document: Mapping[str, Any], metrics: Mapping[str, Any] | None) -> list[Row]:
    """The shortfalls of a scene, as far as it came.

    Args:
        document: Its last ESG; empty if it has none.
        metrics: What its judge wrote, None if it was never judged.
    """
    if metrics is not None:
        return list(metrics.get("not_kept", ()))
    return shortfalls(document, statement_rows(document))


def fully_understood(document: Mapping[str, Any]) -> bool:
    """Whether every statement is represented and something was made of every verb and quantity."""
    rows = statement_rows(document)
    represented = all(row["status"] != NOT_REPRESENTED for row in rows)
    return represented and not _dropped(document)


def share_kept(rows: Sequence[Mapping[str, Any]]) -> float | None:
    """Kept statements among all, those never judged included; None without statements."""
    return sum(row["kept"] is True for row in rows) / len(rows) if rows else None


def sentence(lost: Iterable[Mapping[str, Any]]) -> str:
    """Shortfalls in one sentence that names their words; of what is broken, what was measured."""
    parts: dict[str, list[str]] = {}
    for row in lost:
        why = f": {row['reason']}" if row["status"] == "broken" and row["reason"] else ""
        parts.setdefault(row["status"], []).append(f'"{row["words"]}"{why}')
    order = (NOT_REPRESENTED, "broken", NOT_UNDERSTOOD)
    return "; ".join(
        f"{status.replace('_', ' ')}: {', '.join(parts[status])}"
        for status in order
        if status in parts
    )


def most_unseen(lost: Iterable[Sequence[Mapping[str, Any]]]) -> list[Row]:
    """The words that most often are not shown at all, with the number of scenes.

    Args:
        lost: The shortfalls of every scene.
    """
    scenes = Counter(
        pair
        for rows in lost
        for pair in {(r["words"].lower(), r["status"]) for r in rows if r["status"] in UNSEEN}
    )
    ordered = sorted(scenes.items(), key=lambda item: (-item[1], item[0]))
    return [{"words": w, "status": s, "scenes": n} for (w, s), n in ordered[:_MOST]]


def block(lost: Sequence[Mapping[str, Any]], where: str) -> list[str]:
    """Lines that cannot be overlooked: the words of a prompt that a result does not show.

    Args:
        lost: Shortfalls; without any there is no line.
        where: In what they are missing: scene or draft.
    """
    if not lost:
        return []
    width = 2 + max(len(row["words"]) for row in lost)
    lines = [f"NOT ALL OF THE PROMPT IS IN THIS {where.upper()}:"]
    for row in lost:
        why = ": ".join(filter(None, (row["status"].replace("_", " "), row["reason"])))
        quoted = f'"{row["words"]}"'
        lines.append(f"  {quoted:{width}}  {why}")
    return [f"  !! {line}" for line in lines]


def counted(rows: Iterable[Mapping[str, Any]]) -> str:
    """The words of `most_unseen`, each with the number of its scenes."""
    return ", ".join(f'"{row["words"]}" ({row["scenes"]})' for row in rows)


def _dropped(document: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    items = (document.get("coverage") or {}).get("items", ())
    return [i for i in items if i["kind"] in _DROPPED and i["status"] == NOT_UNDERSTOOD]
