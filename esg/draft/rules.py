"""The rules drafter: prompt -> ESG document, from lexicon and shallow syntax alone."""

from __future__ import annotations

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
from esg.draft.grammar.rewrites.absolutes import absolutes
from esg.draft.grammar.rewrites.appositions import appose
from esg.draft.grammar.rewrites.coordination import coordinate
from esg.draft.grammar.rewrites.ellipsis import elide
from esg.draft.grammar.rewrites.garments import undress
from esg.draft.grammar.rewrites.headlines import spelled_out
from esg.draft.grammar.rewrites.light_verbs import lighten
from esg.draft.grammar.rewrites.nominals import verbalize
from esg.draft.grammar.rewrites.persons import mark_persons
from esg.draft.grammar.rewrites.positions import positioned
from esg.draft.grammar.rewrites.reorder import reorder
from esg.draft.grammar.rewrites.reports import drop_reports
from esg.draft.grammar.rewrites.shares import count, own_nouns
from esg.draft.grammar.rewrites.sheets import from_sheet
from esg.draft.grammar.rewrites.similes import drop_similes
from esg.draft.text.tokens import pos_tags, tokenize
from esg.graph.models import EsgDocument

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
    text = spelled_out(screen(prompt))
    tokens = join_modifiers(tokenize(text, pos_tags(text)), text)
    elements = drop_reports(drop_similes(chunk(text, tokens)))
    elements = from_sheet(lighten(positioned(appose(coordinate(own_nouns(elements))))))
    elements = undress(mark_persons(absolutes(elide(verbalize(reorder(elements, text))))))
    clauses = build_clauses(elements)
    count(clauses.attachments)
    mark_unreal(clauses.frames, text)
    world = new_world()
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
