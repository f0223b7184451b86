"""A slope whose foot lies on the ground, raised where what comes down it shall end up in a vessel.

A marble that rolls down a chute into a cup cannot get over the cup's rim from the ground: the chute
stands on legs, and its lip is over the rim.
"""

from __future__ import annotations

import math

from esg.dynamics.casting.changes import Configs, resized
from esg.dynamics.casting.containers import down_a_slope, entries
from esg.dynamics.casting.motion import LETS_GO
from esg.dynamics.choreography.courses.chutes import drop_needed
from esg.dynamics.choreography.falling.throws import opens_upwards
from esg.dynamics.choreography.slopes import ride_of
from esg.dynamics.story.stagecraft import Prop, prop, support_of
from esg.dynamics.story.story import Story
from esg.graph.models import EsgDocument
from esg.units import GRAVITY_MPS2

KIND = "raised_chute"
LIP = 0.6
"""Height of a raised chute's lip over that of its landing, as it is drawn."""
LANDING = 0.22
"""Length of its landing over its own, as it is drawn."""
LONG = 1.15
"""Its usual length over its height: it falls by 24 degrees."""
ROOM = 1.3
"""Length of its landing and width of its trough over those of what goes down it, at least."""
INNER = 0.84
"""Width of its trough over its own, as it is drawn."""
CLEAR_M = 0.03
"""Gap between its lip and what stands before it."""
ROUNDS = 8
"""Its height and the speed at its lip depend on each other."""


def fit_chutes(doc: EsgDocument, story: Story) -> Configs:
    """Configurations of slopes that lead into a vessel on the ground, and of what slides down."""
    out: Configs = {}
    nodes = doc.spatial_relation_graph.nodes
    for _, thing, owner, mouth in entries(doc, story):
        support = support_of(doc, thing)
        if support is None or not down_a_slope(doc, story, thing, owner):
            continue
        key, vessel = nodes[support].asset_id, doc.asset_configurations[nodes[owner].asset_id]
        if not opens_upwards(vessel.regions, mouth.name):
            continue
        if doc.asset_requirement[key].dimensions_are_prescribed:
            continue
        body, holder = prop(doc, thing), prop(doc, owner)
        length, width, height = _size(body, holder)
        kind = doc.asset_requirement[key].model_copy(
            update={"asset_category": KIND, "asset_description": "raised chute"}
        )
        size = (100.0 * length, 100.0 * width, 100.0 * height)
        made = resized(doc, key, doc.asset_configurations[key], 1.0, kind, dimensions=size)
        if body.rolls:
            out[key] = made
            continue
        friction = LETS_GO * _fall(length, height)
        for name, config in ((key, made), (nodes[thing].asset_id, body.config)):
            if config is not None:
                slick = min(config.friction, friction)
                out[name] = config.model_copy(update={"friction": slick})
    return out


def _size(body: Prop, holder: Prop) -> tuple[float, float, float]:
    """Length, width and height [m] of a chute whose lip is high enough over a rim."""
    reach = holder.half_length + CLEAR_M
    kept = 1.0 - LETS_GO if not body.rolls else 1.0 / (1.0 + ride_of(body, body).roll)
    lip = holder.height + CLEAR_M
    length = height = 0.0
    for _ in range(ROUNDS):
        height = lip / LIP
        length = max(LONG * height, ROOM * body.length / LANDING)
        speed = math.sqrt(2.0 * GRAVITY_MPS2 * kept * (height - lip))
        lip = holder.height + drop_needed(speed, _fall(length, height), reach)
    return length, ROOM * body.width / INNER, height


def _fall(length: float, height: float) -> float:
    """Fall per way of a chute of some length and height."""
    return (1.0 - LIP) * height / ((1.0 - LANDING) * length)
