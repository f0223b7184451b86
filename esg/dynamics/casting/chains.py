"""Long chains of balls: of what is open, balls that still pass something on at the last hit.

Every hit passes on (1 + e) / 2 of the speed among equals, and of what is left the struck ball loses
two fifths until it rolls: a usual ball arrives at the sixth hit with less than a twentieth of what
the first one had. Started so fast that the last hit is felt, balls that meet no sooner than a tenth
of a second lie many diameters apart, and each of these multiplies an error of the aim. Heavy balls
of ivory may go slowly.
"""

from __future__ import annotations

from dataclasses import replace
import math

from esg.dynamics.casting.changes import scaled
from esg.dynamics.casting.toppling import comes_in_all_sizes
from esg.dynamics.choreography.hits.rows import asked_of_first, rows
from esg.dynamics.story.stagecraft import Prop, default_speed, prop, support_of
from esg.dynamics.story.story import Story, hits
from esg.graph.models import AssetConfiguration, EsgDocument

LIVELIEST, POLISHED = 0.95, 0.06
"""Restitution of ivory or glass, and its friction (ball on ball, Alciatore, Pool and Billiards
Physics Principles: 0.92 to 0.98 and 0.03 to 0.08)."""
SMOOTH, SPRINGY = 0.15, 0.6
"""Friction of a smooth underside and restitution of hard wood."""
HEAVIEST, SOLID_KG_M3 = 2.5, 1200.0
"""Largest share of the usual mass: a solid ball against a hollow one. What comes in all sizes may
be as heavy as solid rubber or ebony."""
ROUNDS = 12
"""Made heavier by as much as its first ball is too fast, a row is calm after so many."""
DIAMETERS_A_S = 10.0
"""Speed at which the hits of a chain lie little more than a diameter apart."""


def ball_chains(doc: EsgDocument, story: Story) -> list[list[str]]:
    """Long chains of balls, each as the names of its balls in the order of their hits."""
    return [r for r in rows(doc, story) if all(prop(doc, n).rolls for n in r)]


def fit_chains(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """Livelier and, where that is open, heavier balls of long chains."""
    nodes = doc.spatial_relation_graph.nodes
    out: dict[str, AssetConfiguration] = {}
    for chain in ball_chains(doc, story):
        keys = list(dict.fromkeys(nodes[n].asset_id for n in chain))
        for key in keys:
            config = doc.asset_configurations[key]
            lively = max(config.restitution, LIVELIEST)
            smooth = min(config.friction, POLISHED)
            out[key] = config.model_copy(update={"restitution": lively, "friction": smooth})
        if any(doc.asset_requirement[k].mass_is_prescribed for k in keys):
            continue
        factor = _heavier([prop(doc, n) for n in chain])
        for key in keys if factor > 1.0 else ():
            out[key] = scaled(out[key], min(factor, _heaviest(doc, key)))
    return out


def _heaviest(doc: EsgDocument, key: str) -> float:
    """Largest factor on the mass of a ball."""
    config = doc.asset_configurations[key]
    if not comes_in_all_sizes(doc, key):
        return HEAVIEST
    solid = SOLID_KG_M3 * math.pi / 6.0 * (0.01 * config.dimensions_cm[0]) ** 3
    return max(HEAVIEST, solid / config.mass_kg)


def fit_sliding(doc: EsgDocument, story: Story) -> dict[str, AssetConfiguration]:
    """What slides on from hit to hit, the middle of a row of crates, is of smooth hard wood.

    Two hits lie a tenth of a second apart, in which friction takes a slider most of what the hit
    before left it: of a rough crate one engine's has stopped where another's arrives.
    """
    nodes = doc.spatial_relation_graph.nodes
    follows: dict[str, tuple[str, ...]] = {}
    for _, a, b in hits(doc, story):
        follows[a] = (*follows.get(a, ()), b)
    carried = {
        b
        for _, _, b in hits(doc, story)
        if not (story.is_active(b) or story.topples(b) or story.falls(b))
    }
    out: dict[str, AssetConfiguration] = {}
    long = {n for row in rows(doc, story) for n in row}
    for name in sorted(carried):
        body = prop(doc, name)
        if body.rolls or body.wheeled or body.fixed or support_of(doc, name) is not None:
            continue
        onto = [b for b in follows.get(name, ()) if not story.is_active(b)]
        struck = any(name in follows.get(a, ()) for a in carried)
        key = nodes[name].asset_id
        config = doc.asset_configurations[key]
        if onto and (struck or any(follows.get(b) for b in onto)) and config.friction > SMOOTH:
            # A long row would have to start too fast to stay on the ground.
            lively = max(config.restitution, LIVELIEST if name in long else SPRINGY)
            out[key] = config.model_copy(update={"friction": SMOOTH, "restitution": lively})
    return out


def _heavier(balls: list[Prop]) -> float:
    """Factor on the masses of polished balls at which the first one may go calmly."""
    calm = min(default_speed(balls[0]), DIAMETERS_A_S * balls[0].width)
    polished = [replace(b, restitution=LIVELIEST, friction=POLISHED) for b in balls]
    factor = 1.0
    for _ in range(ROUNDS):
        heavy = [replace(b, mass=factor * b.mass) for b in polished]
        factor *= max(1.0, asked_of_first(heavy) / calm)
    return factor
