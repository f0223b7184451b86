"""What a scene keeps of its prompt: every statement, verb and quantity by what became of it.

Documents, verdicts and rows are plain JSON here, as commands, tables and pages read them. A row of
a statement has id, says (its predicate), words, start and end (their place in the prompt), status,
kept (None unless it was measured), measured and reason; a shortfall has words, start, end, status
and reason.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
import math
from typing import Any

from esg.thresholds import NEAR_END_M

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
_CLOSE = ("near", "adjacent")
_ORDER = {"behind": -1.0, "in_front_of": 1.0}
NEAR_CM = 100.0 * NEAR_END_M
"""How much farther away than the layout wants it something is still near by the planned start."""


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
    """Relations and arrangements that the prompt states and the layout did not satisfy.

    Args:
        document: The ESG with its layout, of which only the coverage, the layout and the nodes are
            read. What nobody named is related by the drafter's own choice; so is where things
            face. What the planned start keeps near is near within `NEAR_CM`; of two that move, one
            is behind the other along the way on which that one starts, wherever the viewer stands.

    Returns:
        A shortfall each, with the words from the mention of the one to the mention of the other, or
        those that tell the arrangement.
    """
    layout = document.get("layout_result") or {}
    read = _Read(document)
    rows: dict[tuple[int, int], Row] = {}
    for r in (*layout.get("relations", ()), *(layout.get("patterns") or ())):
        if r["satisfied"] or r["relation_type"] == "face":
            continue
        planned = "held by the planned start" in r.get("note", "")
        if planned and r["relation_type"] in _CLOSE and r["violation"] <= NEAR_CM:
            continue
        if planned and r["relation_type"] in _ORDER and _in_their_way(document, r["edge"]):
            continue
        words = read.words_of(r["edge"])
        if words is not None:
            why = r.get("note") or "the layout does not satisfy it"
            row: Row = {**words, "status": "broken", "reason": why}
            rows.setdefault((row["start"], row["end"]), row)
    return list(rows.values())


def _in_their_way(document: Mapping[str, Any], edge: str) -> bool:
    """Whether two that move start in the order that an edge tells, along the way of its target."""
    one, kind, other = edge.split(" ")
    graph = (document.get("timeline_system") or {}).get("sequence_graph") or {}
    movers = {e["actor"] for e in graph.get("edges", ()) if e["params"].get("speed") != 0.0}
    poses = (document.get("layout_result") or {}).get("poses", {})
    if not {one, other} <= movers & poses.keys():
        return False
    yaw = math.radians(poses[other]["yaw_deg"])
    (x, y, _), (x0, y0, _) = (poses[name]["position_cm"] for name in (one, other))
    ahead = (x - x0) * math.cos(yaw) + (y - y0) * math.sin(yaw)
    aside = (y - y0) * math.cos(yaw) - (x - x0) * math.sin(yaw)
    return _ORDER[kind] * ahead > abs(aside)


def unsettled(document: Mapping[str, Any], checks: Iterable[Mapping[str, Any]]) -> list[Row]:
    """What a scene in which nothing is told to move puts where it does not stay.

    Args:
        document: The ESG, of which only the coverage and the nodes are read.
        checks: Of the replay's plausibility: what moves with nothing that touches it.

    Returns:
        A shortfall with the words for that thing, or none.
    """
    read = _Read(document)
    rows: list[Row] = []
    for check in checks:
        if check["name"] != "motion_before" or check["ok"] or not check["body"]:
            continue
        row = read.mention(check["body"])
        if row is not None:
            why = f"it does not stay where it is put: it moves by {check['measured']:.2f} m"
            rows.append({**row, "status": "broken", "reason": why})
    return rows


class _Read:
    """Where the nodes and arrangements of a document stand in its prompt."""

    def __init__(self, document: Mapping[str, Any]) -> None:
        nodes = (document.get("spatial_relation_graph") or {}).get("nodes") or {}
        self.text: str = (document.get("scene_definition") or {}).get("original_description", "")
        self.group = {n: node.get("group") or n for n, node in nodes.items()}
        self.ways = {
            (a, b)
            for s in document.get("statements") or ()
            if s["predicate"] == "moves" and s.get("direction") in ("up", "down")
            for a in s["object"]
            for b in s["target"]
        }
        """Who goes up or down what: nearness at the start is the drafter's, the replay shows it."""
        self.spans: dict[str, list[tuple[int, int]]] = {}
        for item in (document.get("coverage") or {}).get("items", ()):
            _, _, place = item["pointer"].partition("/nodes/")
            node, _, field = place.partition("/")
            if node in self.group:
                for name in {node, self.group[node], *([f"{node}/{field}"] if field else [])}:
                    self.spans.setdefault(name, []).append((item["start"], item["end"]))

    def words_of(self, edge: str) -> Row | None:
        """The words that state an edge ("a,b between c,d", "a,b row"); None if none do."""
        names, kind, *rest = edge.split(" ")
        if not rest:
            told = (self.spans.get(f"{n}/group_pattern", []) for n in names.split(","))
            return self._row(next((spans[0] for spans in told if spans), None))
        if kind == "near" and (names, rest[0]) in self.ways:
            return None
        ends = [[s for n in side.split(",") for s in self._of(n)] for side in (names, rest[0])]
        pairs = ((min(a, b)[0], max(a[1], b[1])) for a in ends[0] for b in ends[1])
        return self._row(min(pairs, key=lambda at: at[1] - at[0], default=None))

    def mention(self, node: str) -> Row | None:
        """The words that first name a node; None if none do."""
        return self._row(min(self._of(node), default=None))

    def _of(self, node: str) -> list[tuple[int, int]]:
        return self.spans.get(node) or self.spans.get(self.group.get(node, node), [])

    def _row(self, at: tuple[int, int] | None) -> Row | None:
        return at and {"words": self.text[at[0] : at[1]], "start": at[0], "end": at[1]}


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
