"""Long chains of balls: of what is open, balls that still pass something on at the last hit.

Every hit passes on (1 + e) / 2 of the speed among equals, and of what is left the struck ball loses
two fifths until it rolls: a usual ball arrives at the sixth hit with less than a twentieth of what
the first one had. Started so fast that the last hit is felt, balls that meet no sooner than a tenth
of a second lie many diameters apart, and each of these multiplies an error of the aim. Heavy balls
of ivory may go slowly.
"""

from __future__ import annotations

from dataclasses import replace
import itertools
import math

from esg.dynamics.casting.changes import scaled
from esg.dynamics.casting.hits import hits
from esg.dynamics.casting.toppling import comes_in_all_sizes
from esg.dynamics.choreography.demands import felt, rolls_on
from esg.dynamics.story.stagecraft import Prop, default_speed, prop, support_of
from esg.dynamics.story.story import Story
from esg.graph.models import AssetConfiguration, EsgDocument
from esg.thresholds import SAFE_IMPULSE_NS

LONG = 4
"""Number of hits from which on a chain of balls is long."""
LIVELIEST, POLISHED = 0.95, 0.06
"""Restitution of ivory or glass, and its friction (ball on ball, Alciatore, Pool and Billiards
Physics Principles: 0.92 to 0.98 and 0.03 to 0.08)."""
SMOOTH, SPRINGY = 0.15, 0.6
"""Friction of a smooth underside and restitution of hard wood."""
HEAVIEST, SOLID_KG_M3 = 2.5, 1200.0
"""Largest share of the usual mass: a solid ball against a hollow one. What comes in all sizes may be
as heavy as solid rubber or ebony."""
DIAMETERS_A_S = 10.0
"""Speed at which the hits of a chain lie little more than a diameter apart."""


def ball_chains(doc: EsgDocument, story: Story) -> list[list[str]]:
    """Long chains of balls, each as the names of its balls in the order of their hits."""
    follows: dict[str, str] = {}
    for _, a, b in hits(doc, story):
        if prop(doc, a).rolls and prop(doc, b).rolls and not story.is_active(b):
            follows.setdefault(a, b)
    chains: list[list[str]] = []
    for first in (a for a in follows if a not in follows.values()):
        chain = [first]
        while chain[-1] in follows and follows[chain[-1]] not in chain:
            chain.append(follows[chain[-1]])
        if len(chain) > LONG:
            chains.append(chain)
    return chains


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
        factor = SAFE_IMPULSE_NS / max(_last_impulse([prop(doc, n) for n in chain]), 1e-9)
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
    for name in sorted(carried):
        body = prop(doc, name)
        if body.rolls or body.wheeled or body.fixed or support_of(doc, name) is not None:
            continue
        onto = [b for b in follows.get(name, ()) if not story.is_active(b)]
        struck = any(name in follows.get(a, ()) for a in carried)
        key = nodes[name].asset_id
        config = doc.asset_configurations[key]
        if onto and (struck or any(follows.get(b) for b in onto)) and config.friction > SMOOTH:
            lively = max(config.restitution, SPRINGY)
            out[key] = config.model_copy(update={"friction": SMOOTH, "restitution": lively})
    return out


def _last_impulse(balls: list[Prop]) -> float:
    """Impulse of the last hit [N s] of polished balls, where the first one rolls slowly enough."""
    speed = min(default_speed(balls[0]), DIAMETERS_A_S * balls[0].width)
    polished = [replace(b, restitution=LIVELIEST, friction=POLISHED) for b in balls]
    for mover, target in itertools.pairwise(polished[:-1]):
        speed *= rolls_on(mover, target)
    return felt(polished[-2], polished[-1]) * speed
