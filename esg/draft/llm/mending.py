"""Slips of a timeline that can mean one thing only, put right in code without a request.

A jump is led to by a launch, what is placed is guided, who drives itself is active: where a rule of
the document leaves one reading only, that is taken, and said.
"""

from __future__ import annotations

from typing import Any

from esg.draft import lexicon as lex
from esg.graph.models import EdgeEvent, ForceDirection, NodeEvent, Predicate
from esg.graph.rules_events import OWN_FIELDS, SINGLES
from esg.graph.rules_segments import GUIDED_TO, LEADS_TO, ONLY

Json = dict[str, Any]

_ALONG_JOINTS = {"Open": "Drive", "Close": "Drive", "Swing": "Release"}
_LED_BY = {e.value: m.value for e, m in LEADS_TO.items()} | _ALONG_JOINTS
"""Point events that one type of segment of their own participant brings about."""
_ON_GROUND = {NodeEvent.BOUNCE.value, NodeEvent.PLACED.value}
"""Events of two that happen on the ground where no other place is told."""
_ONE = {e.value for e in SINGLES}
_TAKES = {"elevation_deg": frozenset({EdgeEvent.TOWARD})}
"""Narrower than the rules: a model gives a car that drives up a ramp an elevation, and it flew."""
_GUIDED_TO = {e.value for e in GUIDED_TO}
_SIDES = frozenset(
    p.value
    for p in (
        Predicate.LEFT_OF,
        Predicate.RIGHT_OF,
        Predicate.IN_FRONT_OF,
        Predicate.BEHIND,
        Predicate.ABOVE,
        Predicate.UNDER,
    )
)
_ANY_3D = ForceDirection.ANY_3D.value


def mend(nodes: list[Json], edges: list[Json], actors: Json, base: str | None) -> list[str]:
    """Puts the slips of a timeline right.

    Args:
        nodes: Point events; changed in place, like the rest.
        edges: Segments.
        actors: Actors by name.
        base: The ground, on which what is said to bounce or to be put down somewhere does so.

    Returns:
        What was changed, in words.
    """
    log: list[str] = []
    for node in nodes:
        _participants(node, base, log)
        _own_fields(node, log)
    events = {n["id"]: n for n in nodes}
    for edge in edges:
        _motion(edge, events.get(edge["to"]), actors, log)
        _parameters(edge, actors, log)
    _movers(nodes, edges, log)
    _roles(nodes, edges, actors, log)
    return log


def _participants(node: Json, base: str | None, log: list[str]) -> None:
    kind, people = node["event"], node.get("participants", [])
    if kind == NodeEvent.ENTER_REGION.value and len(people) == 2:
        node["region"] = node.get("region") or f"{people[1]}/inside"
    if kind in _ONE and len(people) > 1:
        log.append(f"{kind} {node['id']!r} is of {people[0]!r} alone")
        node["participants"] = people[:1]
    if kind in _ON_GROUND and len(people) == 1 and base is not None and people[0] != base:
        log.append(f"{kind} {node['id']!r} is with {base!r}")
        node["participants"] = [people[0], base]


def _own_fields(node: Json, log: list[str]) -> None:
    for name, owners in OWN_FIELDS.items():
        if node.get(name) is not None and node["event"] not in {o.value for o in owners}:
            log.append(f"{name} of {node['event']} {node['id']!r} dropped")
            node[name] = None
    if node["event"] == NodeEvent.HEADING_REACHED.value and node.get("turn_degrees") is None:
        node["turn_degrees"] = 90.0


def _motion(edge: Json, end: Json | None, actors: Json, log: list[str]) -> None:
    """The type of a segment where its end or the role of its actor allow only one."""
    kind, role = edge["event"], actors.get(edge["actor"], {}).get("role")
    led = _LED_BY.get(end["event"], "") if end and end.get("participants") else ""
    connector = kind == EdgeEvent.INERTIAL_CONNECTOR.value
    new = kind
    if led and end is not None and edge["actor"] == end["participants"][0] and not connector:
        new = led
    elif end is not None and kind == EdgeEvent.GUIDE.value and end["event"] not in _GUIDED_TO:
        new = EdgeEvent.UNIFORM_MOTION.value
    elif connector and role == "active":
        new = EdgeEvent.TOWARD.value
    if new != kind:
        log.append(f"{kind} {edge['id']!r} read as {new}")
        edge["event"] = new
    if edge.get("target") == edge["actor"]:
        edge["target"] = None


def _parameters(edge: Json, actors: Json, log: list[str]) -> None:
    params, kind = edge["params"], edge["event"]
    for name in list(params):
        kinds = _TAKES.get(name) or ONLY.get(name)
        if kinds is not None and params[name] is not None and kind not in {k.value for k in kinds}:
            log.append(f"{name} of {kind} {edge['id']!r} dropped")
            del params[name]
    actor = actors.get(edge["actor"], {})
    steep = params.get("elevation_deg") not in (None, 0.0, [0.0, 0.0])
    if steep and actor.get("role") == "active" and actor.get("force_direction") != _ANY_3D:
        log.append(f"{edge['actor']!r} leaves the ground: its force direction is {_ANY_3D}")
        actor["force_direction"] = _ANY_3D


def _movers(nodes: list[Json], edges: list[Json], log: list[str]) -> None:
    """Names first who is led to a collision, where the other is not."""
    for node in nodes:
        people = node.get("participants", [])
        if node["event"] != NodeEvent.COLLISION.value or len(people) != 2:
            continue
        led = {e["actor"] for e in edges if e["to"] == node["id"]}
        if people[1] in led and people[0] not in led:
            log.append(f"{people[1]!r} is the mover of {node['id']!r}")
            node["participants"] = people[::-1]


def at_sides(raw: Json) -> list[str]:
    """Ends at no event who is said to go to a side of something: "to the back of the car".

    That it arrives there is what the statement says; the thing itself is not reached.

    Args:
        raw: Document as JSON, with its statements; changed in place.

    Returns:
        What was changed, in words.
    """
    log: list[str] = []
    timeline: Json = raw.get("timeline_system") or {}
    graph: Json = timeline.get("sequence_graph", {})
    nodes: list[Json] = graph.get("nodes", [])
    edges: list[Json] = graph.get("edges", [])
    for node in nodes:
        people: list[str] = node.get("participants") or []
        if node["event"] != NodeEvent.REACH.value or len(people) != 2:
            continue
        mover, other = people
        if not any(_to_a_side(s, mover, other, node["id"]) for s in raw.get("statements", ())):
            continue
        log.append(f"{mover!r} goes to a side of {other!r}: {node['id']!r} is no arrival at it")
        node["event"], node["participants"] = NodeEvent.TRIGGER.value, [mover]
        for edge in edges:
            if edge["to"] == node["id"] and edge["actor"] == mover and edge["target"] == other:
                edge["target"] = None
    return log


def _to_a_side(statement: Json, mover: str, other: str, event: str) -> bool:
    return (
        statement["predicate"] in _SIDES
        and statement["when"] in ("end", event)
        and mover in statement["object"]
        and other in statement["target"]
        and statement["text"].lower().startswith("to ")
    )


def plain_labels(raw: Json) -> list[str]:
    """Takes the part off a label where the asset is the whole: "rock surface" of a rock.

    Args:
        raw: Document as JSON; its nodes are changed in place.

    Returns:
        What was changed, in words.
    """
    log: list[str] = []
    for name, node in raw["spatial_relation_graph"]["nodes"].items():
        whole, _, last = (node.get("label") or "").rpartition(" ")
        asset: Json = raw["asset_requirement"].get(node["asset_id"]) or {}
        category = str(asset.get("asset_category", "")).replace("_", " ").split()
        if last.lower() in lex.PARTS and category and whole.lower().split()[-1:] == category[-1:]:
            node["label"] = whole
            log.append(f"label of {name!r} read as {whole!r}")
    return log


def _roles(nodes: list[Json], edges: list[Json], actors: Json, log: list[str]) -> None:
    """Who is driven is active, who has no motion of its own is not."""
    connector = EdgeEvent.INERTIAL_CONNECTOR.value
    movers = {e["actor"] for e in edges}
    own = {e["actor"] for e in edges if e["event"] != connector}
    acting = {
        p for n in nodes if n["event"] == NodeEvent.TRIGGER.value for p in n.get("participants", ())
    }
    for name, actor in actors.items():
        if actor["role"] == "passive" and name in own:
            jointed = any(
                e["actor"] == name and e["event"] in ("Guide", "Drive", "Release") for e in edges
            )
            way = _ANY_3D if jointed else ForceDirection.HORIZONTAL_PLANE.value
            actors[name] = {"role": "active", "force_direction": way}
            log.append(f"{name!r} moves on its own: active")
        elif actor["role"] == "active" and name not in movers and name not in acting:
            actors[name] = {"role": "passive", "force_direction": None}
            log.append(f"{name!r} has no motion of its own: passive")
