"""The rules drafter: prompt -> ESG document, from lexicon and shallow syntax alone."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
import re

from esg.draft.discourse.referents.resolution import new_world
from esg.draft.document.build import DocumentBuilder, is_restricted
from esg.draft.document.comparisons import compare, compare_speeds
from esg.draft.document.coverage import account, in_prompt
from esg.draft.document.expand import expand
from esg.draft.document.screening import contradictions, nothing_to_draw, screen, too_long, too_much
from esg.draft.document.spacing import space
from esg.draft.events.interpret import begin, interpret
from esg.draft.grammar.clauses.builder import build_clauses
from esg.draft.grammar.clauses.modality import mark_unreal
from esg.draft.grammar.phrases.chunker import chunk
from esg.draft.grammar.phrases.modifiers import join_modifiers
from esg.draft.grammar.rewrites.headings import headings
from esg.draft.grammar.rewrites.inversions import straighten
from esg.draft.grammar.rewrites.ones import name_ones
from esg.draft.grammar.rewrites.patterns import rewrite
from esg.draft.grammar.rewrites.shares import count
from esg.draft.text.elements import Element
from esg.draft.text.tokens import pos_tags, tokenize
from esg.graph.models import EsgDocument

_REWRITES: tuple[tuple[str, Callable[[list[Element]], list[Element]]], ...] = (
    ("who tells it, and similes", partial(rewrite, reading="reports")),
    ("quantities and words that stand for a noun", partial(rewrite, reading="shares")),
    ("a second one", name_ones),
    ("the one in front", partial(rewrite, reading="places")),
    ("titles and headings", headings),
    ("light verbs and ways of telling around it", partial(rewrite, reading="tellings")),
    ("clefts", partial(rewrite, reading="order")),
    ("verbs before their subjects", straighten),
    ("asides", partial(rewrite, reading="asides")),
    ("clauses without a verb", partial(rewrite, reading="gaps")),
    ("nouns of events", partial(rewrite, reading="nominals")),
    ("verbs left out", partial(rewrite, reading="ellipsis")),
    ("participles with a subject of their own", partial(rewrite, reading="absolutes")),
    ("unknown nouns of persons", partial(rewrite, reading="persons")),
    ("clothes", partial(rewrite, reading="worn")),
)
"""What puts phrases into plain order before clauses are built, in this order."""

_ONE_AFTER_OTHER = re.compile(
    r"\bone\s+(?:\w+\s+)?(?:in front of|behind|ahead of|following|after|trailing|leading)\s+"
    r"(?:the other|another)\b",
    re.IGNORECASE,
)


_NET_SPORTS = re.compile(
    r"\b(?:volleyball|tennis|badminton|shuttlecock|ping[- ]pong|serves?|spiked)\b", re.IGNORECASE
)
_BILLIARDS = re.compile(
    r"\b(?:snooker|billiards?|pool (?:table|ball|player|cue)|cue ball|pots|potted|pocket)\b",
    re.IGNORECASE,
)


_OFF_A_CUSHION = re.compile(
    r"\bballs?\b.*\b(?:off|hits) (?:the|one|two|three|its) (?:\w+ ){0,2}(?:cushions?|rails?)\b",
    re.IGNORECASE | re.DOTALL,
)
_FURNISHED = re.compile(r"\b(?:sofa|couch|(?:arm)?chair|bed|bench|train|tram|pillow)s?\b", re.I)


def draft_rules(prompt: str, *, seed: int = 0) -> EsgDocument:
    """Drafts a document from a prompt (the paper's stage 1, without a language model).

    Args:
        prompt: English description of a scene.
        seed: Enters the scene id and the provenance; the draft itself is deterministic.

    Returns:
        The document with requirements, graph, timeline (None if nothing moves) and coverage.

    Raises:
        UserError: If the prompt is empty, too long, not English, or names no object.
    """
    text = screen(prompt)
    tokens = join_modifiers(tokenize(text, pos_tags(text)), text)
    elements = chunk(text, tokens)
    for _, put_plainly in _REWRITES:
        elements = put_plainly(elements)
    clauses = build_clauses(elements)
    count(clauses.attachments)
    mark_unreal(clauses.frames, text)
    world = new_world()
    world.file_of_two = _ONE_AFTER_OTHER.search(text) is not None
    world.net_sport = _NET_SPORTS.search(text) is not None
    cushion = _OFF_A_CUSHION.search(text) is not None and _FURNISHED.search(text) is None
    world.billiards = _BILLIARDS.search(text) is not None or cushion
    discourse = begin(world, text, clauses.mentions)
    scene = interpret(discourse, clauses.frames, clauses.attachments)
    scene.text = text
    scene.ignored.update({(v.start, v.end): "gerund" for v in clauses.nominal})
    compare(text, clauses.mentions, scene)
    compare_speeds(text, clauses.mentions, scene)
    space(text, clauses.mentions, scene)
    contradictions(text, scene)
    nothing_to_draw(scene)
    too_much(scene)
    restricted = is_restricted(text)
    reasons = expand(scene, text, restricted)
    stated = [r for r in scene.relations if r.distance is not None]
    gaps = {frozenset((r.source, r.target)): r.distance for r in stated if r.distance is not None}
    timeline = scene.timeline.build(gaps)
    too_long(timeline)
    coverage = in_prompt(account(text, elements, clauses.mentions, scene, tokens), text, prompt)
    expanded = text + ("" if not reasons else " [" + "; ".join(reasons) + "]")
    document = DocumentBuilder(scene, prompt, seed).build(timeline, coverage, restricted, expanded)
    return document
