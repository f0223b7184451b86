"""Doors, pendulums, riders and what breaks: parts, joints and blows from the tables.

A model names the thing and what happens to it; of which parts it is and how they move is a row of
`esg/lexicon/articulations.csv`, what it bears one of `breakables.csv`, as for the rules drafter.
"""

from __future__ import annotations

import re
from typing import Any

from esg.draft import lexicon as lex
from esg.draft.discourse.scene import LIMBED
from esg.draft.document.riding import THROWN_OFF_MPS
from esg.draft.llm.names import slug
from esg.draft.llm.prune import drop_event
from esg.graph.joints import FOOT, SEAT
from esg.lexicon.articulations import Articulation, articulations
from esg.lexicon.breakables import breakables

Json = dict[str, Any]

_OPEN = {"open": 1.0, "opened": 1.0, "half": 0.5, "ajar": 0.25}
"""Share of how far a thing opens at which it starts, by a word of its name."""
_FREED = ("Release", "Drive")
_JOINTED = ("Open", "Close", "Swing")
_LEAVES = ("Fall", "Jump", "Topple")
"""Events of a rider after which he is not on it."""
ANY_BLOW = (250.0, 10)
"""Speed [cm/s] and pieces of what is said to break and has no row: as stoneware."""


def join_parts(raw: Json) -> list[str]:
    """Joins what opens, closes, swings or hangs to the part that carries it, which is added.

    Args:
        raw: Document as JSON; changed in place.

    Returns:
        What was added, in words.
    """
    log: list[str] = []
    graph = raw["spatial_relation_graph"]
    joints: list[Json] = []
    for name in list(graph["nodes"]):
        moved = _events(raw, name) & {*_JOINTED, *_FREED}
        held = any(name in (j["child"], j["parent"]) for j in joints)
        found = _thing(raw, name) if moved and not held else None
        if found is not None:
            joints += _joined(raw, *found, joints, log)
    if joints:
        graph["joints"] = joints
    return log


def _thing(raw: Json, name: str) -> tuple[str, Articulation] | None:
    """The jointed thing that a moving node is, or the moving part of, with its row."""
    row = _row(raw, name)
    if row is not None:
        return name, row
    called = _called(raw, name)
    for other in raw["spatial_relation_graph"]["nodes"]:
        row = _row(raw, other) if other != name else None
        if row is not None and row.carries == "becomes" and called & {*row.serves, row.with_part}:
            return other, row
    return None


def _row(raw: Json, name: str) -> Articulation | None:
    """The row of a node by what it is called, the most precise name first."""
    node = raw["spatial_relation_graph"]["nodes"][name]
    asset = raw["asset_requirement"].get(node["asset_id"], {})
    table = articulations()
    for text in (node.get("label", ""), asset.get("asset_category", ""), name):
        words = re.sub(r"_\d+$", "", text.strip().lower()).replace("_", " ").split()
        for k in range(len(words)):
            if (row := table.get(" ".join(words[k:]))) is not None:
                return row
    return None


def _called(raw: Json, name: str) -> set[str]:
    node = raw["spatial_relation_graph"]["nodes"][name]
    asset = raw["asset_requirement"].get(node["asset_id"], {})
    names = (slug(node.get("label", "")), asset.get("asset_category", ""))
    return {n.replace("_", " ") for n in names}


def _events(raw: Json, name: str) -> set[str]:
    """Kinds of point events and segments of a node."""
    graph = _graph(raw)
    told = {n["event"] for n in graph.get("nodes", ()) if name in n.get("participants", ())}
    return told | {e["event"] for e in graph.get("edges", ()) if e["actor"] == name}


def _graph(raw: Json) -> Json:
    timeline: Json = raw.get("timeline_system") or {}
    return timeline.get("sequence_graph", {})


def _joined(
    raw: Json, name: str, row: Articulation, known: list[Json], log: list[str]
) -> list[Json]:
    nodes = raw["spatial_relation_graph"]["nodes"]
    node = nodes[name]
    ratio = _become(raw, name, row.becomes)
    taken = {name} | {j[end] for j in known for end in ("child", "parent")}
    parts: list[str] = []
    for _ in range(row.count):
        parts.append(_part(raw, name, row, ratio, taken, log))
        taken.add(parts[-1])
    joints: list[Json] = []
    for n, part in enumerate(parts, start=1):
        parent, child = (name, part) if row.carries == "becomes" else (part, name)
        joints.append(
            {
                "id": f"{child}_{row.kind}",
                "kind": row.kind,
                "child": child,
                "child_mount": row.child_mount,
                "parent": parent,
                "parent_mount": row.parent_mount.format(n=n),
                "lower": row.lower,
                "upper": row.upper,
                "position": _start(raw, (name, part), node, row) if n == 1 else row.start,
                "stiffness": row.stiffness,
                "damping": row.damping,
                "friction": row.friction,
            }
        )
    if row.carries == "becomes":
        _hand_over(raw, name, parts[0])
    return joints


def _start(raw: Json, names: tuple[str, str], node: Json, row: Articulation) -> float:
    """Where it is at the start: open, closed, or drawn back to be let go."""
    events = _events(raw, names[0]) | _events(raw, names[1])
    if "Close" in events and "Open" not in events and row.opened is not None:
        return row.opened
    if events & {"Swing", "Release"} and row.drawn is not None:
        return row.drawn
    words = slug(node.get("label", "")).split("_")
    share = max((_OPEN.get(w, 0.0) for w in words), default=0.0)
    return (row.opened or 0.0) * share or row.start


def _become(raw: Json, name: str, part: str) -> float:
    """Makes a node the part that the row says; returns its size over the usual."""
    node, assets = raw["spatial_relation_graph"]["nodes"][name], raw["asset_requirement"]
    usual = lex.part(part)
    old = assets[node["asset_id"]]
    shared = any(
        n is not node and n["asset_id"] == node["asset_id"]
        for n in raw["spatial_relation_graph"]["nodes"].values()
    )
    told = old.get("dimensions_are_prescribed")
    ratio = 1.0
    if told:
        longest = max(range(3), key=lambda k: usual.dimensions_cm[k])
        ratio = max(old["expected_dimensions_cm"]) / usual.dimensions_cm[longest]
    wanted = slug(part)
    key = f"{node['asset_id']}_{name}"[:64] if shared else node["asset_id"]
    assets[key] = {
        **old,
        "asset_category": wanted,
        "expected_dimensions_cm": [round(d * ratio, 3) for d in usual.dimensions_cm],
        "expected_mass_kg": old["expected_mass_kg"]
        if old.get("mass_is_prescribed")
        else round(usual.mass_kg * ratio**3, 4),
        "is_movable": "fixed" not in usual.traits,
        "shape": None,
    }
    node["asset_id"] = key
    return ratio


def _part(
    raw: Json, name: str, row: Articulation, ratio: float, taken: set[str], log: list[str]
) -> str:
    """The other part: a thing of the scene that serves as it and is not taken, or a new node."""
    nodes, assets = raw["spatial_relation_graph"]["nodes"], raw["asset_requirement"]
    serves = {row.with_part} | ({*row.serves} if row.count == 1 else set[str]())
    for other in nodes:
        if other not in taken and _called(raw, other) & serves:
            _become(raw, other, row.with_part)
            return other
    usual = lex.part(row.with_part)
    base = slug(row.with_part)
    new = next(f"{base}_{k}" for k in range(1, 999) if f"{base}_{k}" not in nodes)
    assets.setdefault(
        f"{base}_of_{name}"[:64],
        {
            "asset_category": base,
            "asset_description": usual.description or usual.name,
            "expected_dimensions_cm": [round(d * ratio, 3) for d in usual.dimensions_cm],
            "expected_mass_kg": round(usual.mass_kg * ratio**3, 4),
            "is_movable": "fixed" not in usual.traits,
        },
    )  # fmt: skip
    nodes[new] = {
        "asset_id": f"{base}_of_{name}"[:64],
        "semantic_region": nodes[name].get("semantic_region"),
        "mentioned": False,
    }
    log.append(f"{new} added: {name} is joined to it")
    return new


def _hand_over(raw: Json, named: str, part: str) -> None:
    """Lets the part that turns do what is told of the whole: a chest opens, a cradle swings."""
    timeline = raw["timeline_system"]
    graph = timeline["sequence_graph"]
    if named in timeline["actors"]:
        timeline["actors"][part] = timeline["actors"].pop(named)
    for edge in graph["edges"]:
        if edge["actor"] == named and edge["event"] in _FREED:
            edge["actor"] = part
    for node in graph["nodes"]:
        if node["event"] in _JOINTED:
            node["participants"] = [part if p == named else p for p in node["participants"]]


def seat_riders(raw: Json) -> list[str]:
    """Joins who is on what is ridden, and has no motion of his own, to it until a jolt.

    Args:
        raw: Document as JSON, with the regions that carry things; changed in place.

    Returns:
        What was joined, in words.
    """
    graph = raw["spatial_relation_graph"]
    timeline = _graph(raw)
    ridden = lex.word_set("straddled or stood on")
    joints: list[Json] = list(graph.get("joints") or ())
    edges: list[Json] = timeline.get("edges", [])
    left: list[Json] = [n for n in timeline.get("nodes", ()) if n["event"] in _LEAVES]
    busy: set[str] = {j["child"] for j in joints} | {e["actor"] for e in edges}
    for node in left:
        busy |= {*node.get("participants", ())}
    log: list[str] = []
    for name in graph["nodes"]:
        mount = _carrier(raw, name)
        if mount is None or name in busy:
            continue
        kind, steed = _noun(raw, name), _noun(raw, mount)
        if kind is None or kind.kind not in LIMBED or steed is None or steed.name not in ridden:
            continue
        mass: float = raw["asset_requirement"][graph["nodes"][name]["asset_id"]]["expected_mass_kg"]
        joints.append(
            {
                "id": f"{name}_seat",
                "kind": "fixed",
                "child": name,
                "child_mount": FOOT,
                "parent": mount,
                "parent_mount": SEAT,
                "break_impulse": round(THROWN_OFF_MPS * mass, 1),
            }
        )
        log.append(f"{name} seated on {mount}")
    if joints:
        graph["joints"] = joints
    return log


def _carrier(raw: Json, name: str) -> str | None:
    """The node in whose region another one is."""
    graph = raw["spatial_relation_graph"]
    region: Json | None = graph["semantic_regions"].get(
        graph["nodes"][name].get("semantic_region") or ""
    )
    if region is None or region["region_type"] != "SUPPORT_SURFACE":
        return None
    carrier: str = region["parent_object"]
    return carrier if carrier in graph["nodes"] and carrier != name else None


def _noun(raw: Json, name: str) -> lex.Noun | None:
    """The lexicon's noun of a node, by its category or its label."""
    node = raw["spatial_relation_graph"]["nodes"][name]
    asset: Json = raw["asset_requirement"].get(node["asset_id"], {})
    table = lex.nouns()
    texts: tuple[str, str] = (asset.get("asset_category", ""), node.get("label") or "")
    for text in texts:
        words = text.lower().replace("_", " ").split()
        for k in range(len(words)):
            if (found := table.get(" ".join(words[k:]))) is not None:
                return found
    return None


def leave_out_unjointed(raw: Json, prompt: str) -> list[str]:
    """Leaves out what opens, closes or swings on no joint that a table knows, and owns up to it.

    Nothing that a model could answer would mend it. A timeline of nothing else stays as it is.

    Args:
        raw: Document as JSON; changed in place.
        prompt: The user's text, in which the thing is named.

    Returns:
        What was left out, in words.
    """
    graph, log = _graph(raw), list[str]()
    held = {j[end] for j in raw["spatial_relation_graph"].get("joints") or ()
            for end in ("child", "parent")}  # fmt: skip
    gone = [
        n
        for n in graph.get("nodes", ())
        if n["event"] in _JOINTED and not held & {*n.get("participants", ())}
    ]
    if not gone or len(graph["nodes"]) - len(gone) < 2:
        return log
    for node in gone:
        drop_event(raw, node)
        name = (node.get("participants") or ["it"])[0]
        words = raw["spatial_relation_graph"]["nodes"].get(name, {}).get("label") or name
        start = max(prompt.lower().find(words.lower()), 0)
        note = f"what it is joined to is not known: no {node['event'].lower()}"
        found = raw.setdefault("statements", [])
        found.append(
            {"id": f"s{len(found) + 1}", "predicate": "not_represented", "note": note,
             "text": prompt[start : start + len(words)], "start": start, "end": start + len(words)}
        )  # fmt: skip
        log.append(f"{node['event']} of {name!r} left out: no table joins it to anything")
    acting = {e["actor"] for e in graph["edges"]} | {
        p for n in graph["nodes"] for p in n.get("participants", ())
    }
    actors = raw["timeline_system"]["actors"]
    for name in [a for a in actors if a not in acting]:
        del actors[name]
    return log


def let_break(raw: Json) -> list[str]:
    """Says of everything that breaks in the timeline at which blow, and into how many pieces.

    Args:
        raw: Document as JSON; changed in place.

    Returns:
        What was set, in words.
    """
    log: list[str] = []
    nodes = raw["spatial_relation_graph"]["nodes"]
    points: list[Json] = _graph(raw).get("nodes", [])
    broken: list[str] = [p for n in points if n["event"] == "Break" for p in n["participants"]]
    table = breakables()
    for name in dict.fromkeys(broken):
        if name not in nodes or nodes[name].get("breaking"):
            continue
        node = nodes[name]
        asset: Json = raw["asset_requirement"].get(node["asset_id"], {})
        category: str = asset.get("asset_category", "")
        heads: list[str] = [
            node.get("label", "").lower(),
            category.replace("_", " "),
            name.rpartition("_")[0],
        ]
        heads += [h.split()[-1] for h in heads if h.split()]
        row = next((table[h] for h in heads if h in table and table[h].pieces), None)
        speed, pieces = (row.at_mps * 100.0, row.pieces) if row else ANY_BLOW
        node["breaking"] = {"speed": speed, "pieces": pieces}
        if row is None:
            log.append(f"{name} breaks as stoneware does: no table has it")
    return log
