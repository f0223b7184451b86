"""The rules of casting in their order: what each chooses, and why."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from esg.dynamics.casting.bodies import (
    fit_freed,
    fit_grown,
    fit_landed,
    fit_movable,
    fit_solid,
    fit_springy,
)
from esg.dynamics.casting.chains import fit_chains, fit_sliding
from esg.dynamics.casting.changes import Configs, with_assets
from esg.dynamics.casting.chutes import fit_chutes
from esg.dynamics.casting.containers import fit_containers, fit_holders
from esg.dynamics.casting.dominoes import fit_falling
from esg.dynamics.casting.fragile import fit_fragile
from esg.dynamics.casting.lengths import fit_along
from esg.dynamics.casting.loads import fit_fallen, fit_loads
from esg.dynamics.casting.masses import fit_pushes, fit_slow, fit_transfer
from esg.dynamics.casting.motion import (
    fit_bouncy,
    fit_felt,
    fit_pushed_on,
    fit_roomy,
    fit_slippery,
    fit_sloped,
    fit_steady,
)
from esg.dynamics.casting.openings import fit_openings
from esg.dynamics.casting.passages import fit_passages
from esg.dynamics.casting.reach import fit_reach
from esg.dynamics.casting.surfaces import fit_ground, fit_ice, fit_snow
from esg.dynamics.casting.toppling import fit_toppled
from esg.dynamics.casting.tops import fit_tops
from esg.dynamics.casting.upright import fit_upright
from esg.dynamics.casting.walkers import fit_balanced
from esg.dynamics.choreography.bounces import let_go_sideways, lively_tops
from esg.dynamics.story.story import Story
from esg.graph.models import EsgDocument


@dataclass(frozen=True)
class Rule:
    """One rule.

    Args:
        why: What the choice is good for, for the reader of a document.
        choose: The document with the choice made, from the document so far and its story.
    """

    why: str
    choose: Callable[[EsgDocument, Story], EsgDocument]


def _of_assets(why: str, fit: Callable[[EsgDocument, Story], Configs]) -> Rule:
    """A rule that only changes configurations, and says which."""
    return Rule(why, lambda doc, story: with_assets(doc, fit(doc, story)))


def _upright(doc: EsgDocument, story: Story) -> EsgDocument:
    """Boards on their ends, and the room that a row of them needs where they took less flat."""
    boards = fit_upright(doc, story)
    return with_assets(with_assets(doc, boards), fit_loads(doc)) if boards else doc


LOADS = _of_assets("what stands on it, side by side, has room", lambda doc, _: fit_loads(doc))
HOLDERS = _of_assets("there is something in it", lambda doc, _: fit_holders(doc))
STANDING = (HOLDERS, LOADS)
"""The rules for scenes without a timeline, too."""

RULES = (
    *STANDING,
    Rule("rolling it would not reach what it shall hit", fit_reach),
    Rule("it drifts on to the next thing", lambda doc, _: let_go_sideways(doc)),
    _of_assets("coming off what it stands on is a fall", fit_fallen),
    Rule("it is knocked over", fit_freed),
    Rule("lying flat it could not fall over", _upright),
    _of_assets("the timeline moves it", fit_movable),
    _of_assets("something lands on it", fit_solid),
    _of_assets("it stays where it lands", fit_landed),
    _of_assets("the hit of one on the next counts", fit_grown),
    _of_assets("it is down before it hits the next one", fit_falling),
    _of_assets("something enters it", fit_openings),
    _of_assets("what goes through it has room", fit_passages),
    _of_assets("what ends up inside fits through the opening and stays", fit_containers),
    _of_assets("the ground is said to be so", lambda doc, _: fit_ground(doc)),
    _of_assets("it slides on ice", fit_ice),
    _of_assets("it glides on snow", fit_snow),
    _of_assets("there is room on top for what goes down it", fit_roomy),
    _of_assets("what is on the slope is let go and arrives as stated", fit_sloped),
    _of_assets("it ends over the rim of what is to be got into", fit_chutes),
    _of_assets("its hits are felt at the speed it may have", fit_felt),
    _of_assets("its hit is felt as slowly as it goes", fit_slow),
    _of_assets("what slides is still on its way when it is to arrive", fit_slippery),
    _of_assets("a hit at one stated speed gives the other", fit_bouncy),
    _of_assets("the last hit of the chain is still felt", fit_chains),
    _of_assets("it slides on from hit to hit", fit_sliding),
    _of_assets("the hit sends it into the next thing", fit_pushed_on),
    _of_assets("it does not slip from under the hit that tips it over", fit_steady),
    _of_assets("what bounces off it goes on to the next thing", fit_springy),
    _of_assets("what comes down on it bounces on to the next thing", lively_tops),
    _of_assets("a hit at the stated speed gives the stated speed", fit_transfer),
    _of_assets("what is run into goes on to the next thing", fit_pushes),
    _of_assets("the blow breaks it", fit_fragile),
    _of_assets("it is as long as the way along it", fit_along),
    _of_assets("what goes about on it has room", fit_tops),
    _of_assets("it walks about, and keeps its balance", fit_balanced),
    Rule("the hit knocks over or off what it shall", fit_toppled),
)
