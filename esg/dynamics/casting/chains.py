"""Long chains of balls: of what is open, balls that still pass something on at the last hit.

Every hit passes on (1 + e) / 2 of the speed among equals, and of what is left the struck ball loses
two fifths until it rolls: a usual ball arrives at the sixth hit with less than a twentieth of what
the first one had, and the search would have to start it so fast that hits follow each other within
a tenth of a second.
"""

from __future__ import annotations

import itertools

from esg.dynamics.casting.changes import scaled
from esg.dynamics.casting.hits import hits
from esg.dynamics.choreography.demands import ROLLS_AT, passed_on
from esg.dynamics.story.stagecraft import Prop, default_speed, prop, support_of
from esg.dynamics.story.story import Story
from esg.graph.models import AssetConfiguration, EsgDocument
from esg.thresholds import SAFE_IMPULSE_NS

LONG = 4
"""Number of hits from which on a chain of balls is long."""
LIVELIEST = 0.95
"""Restitution of ivory or glass."""
SMOOTH, SPRINGY = 0.15, 0.6
"""Friction of a smooth underside and restitution of hard wood."""
HEAVIEST = 2.5
"""Largest share of the usual mass: a solid ball against a hollow one."""


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
            out[key] = config.model_copy(update={"restitution": lively})
        if any(doc.asset_requirement[k].mass_is_prescribed for k in keys):
            continue
        factor = SAFE_IMPULSE_NS / max(_last_impulse([prop(doc, n) for n in chain]), 1e-9)
        for key in keys if factor > 1.0 else ():
            out[key] = scaled(out[key], min(factor, HEAVIEST))
    return out


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
    """Impulse of the last hit [N s] where the first ball rolls at a usual speed."""
    speed, impulse = default_speed(balls[0]), 0.0
    for mover, target in itertools.pairwise(balls):
        after = (1.0 + LIVELIEST) / (1.0 + 0.5 * (mover.restitution + target.restitution))
        speed *= passed_on(mover, target) * after
        impulse = target.mass * speed
        speed *= ROLLS_AT
    return impulse
