"""A shape for small local models: one request, things and what happens to them, in plain words.

A model under a few billion parameters loses itself in the document's shapes. It is asked only who
is there, on what, and who does what to whom; sizes and masses come from the lexicon, and the
motions that lead to each event from the kind of the event.
"""

from __future__ import annotations

import copy
import re
from typing import Any, Literal

from pydantic import Field

from esg.draft.llm.names import slug
from esg.draft.llm.stages import Part, SceneReply, TimelineReply, WholeReply
from esg.lexicon.morphology import singular

Act = Literal[
    "hits", "falls", "topples", "stops", "enters", "reaches", "passes", "is_picked_up",
    "is_placed_on", "bounces_on", "jumps", "spins", "opens", "closes", "swings", "breaks", "moves",
]  # fmt: skip
"""What a thing can do."""


class ThingPart(Part):
    name: str = Field(description="one word or two, such as red ball")
    count: int = Field(1, ge=1, le=20)
    on: str | None = Field(None, description="the thing that carries it")


class ActPart(Part):
    who: str
    does: Act
    whom: str | None = None
    speed_m_s: float | None = Field(None, description="only if it is stated")


class SmallReply(Part):
    """Things and acts."""

    things: list[ThingPart]
    acts: list[ActPart] = Field(description="empty if nothing moves")


_EVENTS: dict[str, tuple[str, str]] = {
    "hits": ("Collision", "Toward"),
    "falls": ("Fall", "Toward"),
    "topples": ("Topple", "Toward"),
    "stops": ("Stop", "Brake"),
    "enters": ("EnterRegion", "Toward"),
    "reaches": ("Reach", "UniformMotion"),
    "passes": ("Miss", "UniformMotion"),
    "is_picked_up": ("PickedUp", "Guide"),
    "is_placed_on": ("Placed", "Guide"),
    "bounces_on": ("Bounce", "Toward"),
    "jumps": ("Jump", "Toward"),
    "spins": ("Spin", "Spin"),
    "opens": ("Open", "Drive"),
    "closes": ("Close", "Drive"),
    "swings": ("Swing", "Release"),
    "breaks": ("Break", "Toward"),
    "moves": ("Trigger", "UniformMotion"),
}
"""Point event of an act, and the motion of its own that leads to it."""
_SELF_MOVING = frozenset({"vehicle", "person", "animal", "flyer", "robot"})
"""Classes of nouns that move on their own, where others are pushed or thrown."""
UNKNOWN_CM, UNKNOWN_KG = (40.0, 40.0, 40.0), 5.0
"""Of a thing that the lexicon does not have, as the rules drafter draws it."""


def closed(schema: dict[str, Any], prompt: str) -> dict[str, Any]:
    """The schema in which things can only be called by nouns of the prompt.

    Args:
        schema: Of `SmallReply`.
        prompt: The user's text; one without a known noun leaves names open.
    """
    names = nouns_in(prompt)
    if not names:
        return schema
    out = copy.deepcopy(schema)
    parts = out["$defs"]
    parts["Name"] = {"type": "string", "enum": names}
    for part, fields in (("ThingPart", ("name", "on")), ("ActPart", ("who", "whom"))):
        for name in fields:
            parts[part]["properties"][name] = {"$ref": "#/$defs/Name"}
    return out


def nouns_in(prompt: str) -> list[str]:
    """Nouns of the lexicon that a text names, in order, each once, as singulars."""
    from esg.draft.lexicon import nouns

    table, out = nouns(), list[str]()
    words = re.findall(r"[a-z']+(?:-[a-z]+)*", prompt.lower())
    skip = 0
    for k, word in enumerate(words):
        if skip:
            skip -= 1
            continue
        pair = f"{word} {singular(words[k + 1])}" if k + 1 < len(words) else ""
        if pair in table:
            out.append(pair)
            skip = 1
        elif (one := singular(word)) in table:
            out.append(one)
    return list(dict.fromkeys(out))


def whole_of(reply: SmallReply) -> WholeReply:
    """The scene and its timeline in the shapes of the other stages."""
    things = {slug(t.name): t for t in reply.things}
    # Small models repeat themselves.
    told = {(a.who, a.does, a.whom): a for a in reversed(reply.acts) if slug(a.who) in things}
    acts = [*reversed(told.values())]
    timeline = _timeline(acts, things) if acts else None
    scene = {
        "expansion": {
            "expanded_description": "",
            "is_dynamic": timeline is not None,
            "scene_type": "outdoor",
        },
        "assets": {
            "assets": [_asset(name, thing.name) for name, thing in things.items()],
            "objects": [
                {"name": name, "asset_id": name, "label": thing.name, "count": thing.count}
                for name, thing in things.items()
            ],
        },
        "spatial": {
            "relations": [
                {"subject": name, "relation": "on", "object": carrier}
                for name, carrier in _carriers(things).items()
            ]
        },
    }
    return WholeReply.model_validate({**scene, "timeline": timeline})


def _carriers(things: dict[str, ThingPart]) -> dict[str, str]:
    """What carries each thing; none that would end up carrying itself."""
    out: dict[str, str] = {}
    for name, thing in things.items():
        carrier = slug(thing.on) if thing.on is not None else name
        below: str | None = carrier
        while below is not None and below != name:
            below = out.get(below)
        if carrier in things and below is None:
            out[name] = carrier
    return out


def parts_of(reply: SmallReply) -> tuple[SceneReply, TimelineReply | None]:
    """The same as answers of the two stages."""
    whole = whole_of(reply)
    scene = SceneReply(expansion=whole.expansion, assets=whole.assets, spatial=whole.spatial)
    return scene, whole.timeline


def _asset(name: str, called: str) -> dict[str, Any]:
    noun = _noun(called)
    size = noun.dimensions_cm if noun is not None else UNKNOWN_CM
    return {
        "asset_id": name,
        "category": noun.category if noun is not None else name,
        "description": called,
        "length_cm": size[0],
        "width_cm": size[1],
        "height_cm": size[2],
        "mass_kg": noun.mass_kg if noun is not None else UNKNOWN_KG,
        "movable": noun is None or not noun.traits & {"fixed", "structural"},
        "shape": noun.shape if noun is not None and noun.shape != "compound" else None,
    }


def _noun(called: str) -> Any:
    """The noun of a phrase: its last word, or the last two."""
    from esg.draft.lexicon import nouns

    words = called.lower().split()
    table = nouns()
    for head in (" ".join(words[-2:]), *(singular(w) for w in words[-1:])):
        if head in table:
            return table[head]
    return None


def _timeline(acts: list[ActPart], things: dict[str, ThingPart]) -> dict[str, Any]:
    """Acts in the order in which they are told; who was hit goes on by itself."""
    events: list[dict[str, Any]] = []
    segments: list[dict[str, Any]] = []
    roles: dict[str, str] = {}
    last: dict[str, str] = {}
    for k, act in enumerate(acts, 1):
        who, whom = slug(act.who), slug(act.whom or "")
        kind, motion = _EVENTS[act.does]
        people = [who, whom] if whom in things and whom != who else [who]
        event = {"id": f"e{k}", "event": kind, "participants": people}
        hit_before = who in last and who not in roles
        begin = last.get(who, "scene_start")
        if hit_before:
            roles[who], motion = "passive", "InertialConnector"
        elif roles.get(who) == "passive":
            motion = "InertialConnector"
        else:
            roles[who] = "active"
            noun = _noun(things[who].name)
            if motion == "Toward" and noun is not None and noun.kind in _SELF_MOVING:
                motion = "UniformMotion"
        segment: dict[str, Any] = {
            "id": f"m{k}", "start": begin, "end": f"e{k}", "motion": motion, "actor": who,
            "target": whom if len(people) == 2 else None,
        }  # fmt: skip
        if act.speed_m_s is not None and motion != "InertialConnector":
            speed = act.speed_m_s * 100.0
            segment["parameters"] = [{"name": "speed", "low": speed, "high": speed}]
            segment["speed_is_prescribed"] = True
        events.append(event)
        segments.append(segment)
        for name in people:
            last[name] = f"e{k}"
    return {
        "actors": [_actor(name, role, segments) for name, role in roles.items()],
        "events": events,
        "segments": segments,
    }


def _actor(name: str, role: str, segments: list[dict[str, Any]]) -> dict[str, Any]:
    held = {"Guide", "Drive", "Release"}
    free = any(s["actor"] == name and s["motion"] in held for s in segments)
    way = None if role == "passive" else "ANY_3D" if free else "HORIZONTAL_PLANE"
    return {"object": name, "role": role, "force_direction": way}
