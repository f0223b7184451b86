"""The rules drafter: prompt -> ESG document, from lexicon and shallow syntax alone."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from esg.draft.audit import owned_up
from esg.draft.discourse.record import Discourse
from esg.draft.discourse.referents.resolution import new_world
from esg.draft.document.build import build, is_restricted
from esg.draft.document.comparisons import compare, contrast
from esg.draft.document.coverage import account, in_prompt, stated_in_prompt
from esg.draft.document.expand import expand
from esg.draft.document.fitting import fit
from esg.draft.document.screening import contradictions, nothing_to_draw, screen, too_long, too_much
from esg.draft.document.spacing import space
from esg.draft.events.crossing import take_time
from esg.draft.events.interpret import begin, interpret
from esg.draft.events.senses.postures import get_up_first
from esg.draft.grammar.clauses.builder import build_clauses
from esg.draft.grammar.clauses.modality import mark_unreal
from esg.draft.grammar.phrases.chunker import chunk
from esg.draft.grammar.phrases.compounds import join_compounds
from esg.draft.grammar.phrases.contact import name_relatives, some_of_them
from esg.draft.grammar.phrases.inverted import straight_verbs
from esg.draft.grammar.phrases.modifiers import join_modifiers
from esg.draft.grammar.questions import ask
from esg.draft.grammar.rewrites.clothing import put_on
from esg.draft.grammar.rewrites.companions import set_apart
from esg.draft.grammar.rewrites.denials import deny
from esg.draft.grammar.rewrites.gapping import fill_gaps
from esg.draft.grammar.rewrites.headings import headings
from esg.draft.grammar.rewrites.inversions import straighten
from esg.draft.grammar.rewrites.ones import name_ones
from esg.draft.grammar.rewrites.openings import join_results
from esg.draft.grammar.rewrites.opposites import oppose
from esg.draft.grammar.rewrites.patterns import rewrite
from esg.draft.grammar.rewrites.shares import count
from esg.draft.statements import state
from esg.draft.statements.filmed import how_filmed, set_filming_apart, with_filming
from esg.draft.statements.looks.contents import as_told, fill
from esg.draft.statements.looks.drawn import drawn_otherwise
from esg.draft.text.elements import Element, Token
from esg.draft.text.fillings import take_out
from esg.draft.text.filming import without_heading
from esg.draft.text.misspelt import spelled
from esg.draft.text.tagging import parsed, pos_tags
from esg.draft.text.tokens import tokenize
from esg.draft.text.topics import comes_apart, is_billiards, is_cricket, is_net_sport
from esg.graph.models import EsgDocument

_REWRITES: tuple[tuple[str, Callable[[list[Element]], list[Element]]], ...] = (
    ("who tells it, and similes", partial(rewrite, reading="reports")),
    ("quantities and words that stand for a noun", partial(rewrite, reading="shares")),
    ("contacts with none", deny),
    ("clauses of which only a noun is told", fill_gaps),
    ("a second one", name_ones),
    ("the one in front", partial(rewrite, reading="places")),
    ("titles and headings", headings),
    ("light verbs and ways of telling around it", partial(rewrite, reading="tellings")),
    ("clefts", partial(rewrite, reading="order")),
    ("verbs before their subjects", straighten),
    ("things beside one", set_apart),
    ("the other way", oppose),
    ("asides", partial(rewrite, reading="asides")),
    ("clauses without a verb", partial(rewrite, reading="gaps")),
    ("nouns of events", partial(rewrite, reading="nominals")),
    ("verbs left out", partial(rewrite, reading="ellipsis")),
    ("participles with a subject of their own", partial(rewrite, reading="absolutes")),
    ("unknown nouns of persons", partial(rewrite, reading="persons")),
    ("clothes that are drawn", put_on),
    ("clothes", partial(rewrite, reading="worn")),
)
"""What puts phrases into plain order before clauses are built, in this order."""


def _fit_what_is_climbed(d: Discourse) -> None:
    """Sizes of what is leapt or climbed onto, and of what is climbed."""
    climbs = d.moves.climbs
    onto = {c.actor: c.thing for c in climbs if c.course == "onto"}
    climbed = {c.actor: c.thing for c in climbs if c.course in ("up", "down")}
    fit(d.scene, d.moves.upon | onto, climbed)


def _told_plainly(written: list[Token], text: str) -> list[Token]:
    tokens = join_compounds(join_modifiers(written, text))
    return straight_verbs(name_relatives(some_of_them(tokens)))


def _put_plainly(elements: list[Element], text: str) -> list[Element]:
    for _, plainer in _REWRITES:
        elements = plainer(elements)
    return join_results(elements, text)


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
    tags = pos_tags(text)
    fillings = take_out(text, [at for at, part in tags if part in ("NOUN", "PROPN")])
    meant = without_heading(fillings.text)
    if meant != text:
        text, tags = meant, pos_tags(meant)
    written, respelled = spelled(tokenize(text, tags))
    tokens = _told_plainly(written, text)
    elements = _put_plainly(chunk(text, tokens), text)
    clauses = build_clauses(elements)
    count(clauses.attachments)
    mark_unreal(clauses.frames, text)
    set_filming_apart(clauses, text)
    asked = ask(clauses, text)
    world = new_world()
    world.net_sport, world.billiards = is_net_sport(text), is_billiards(text)
    world.cricket, world.filled = is_cricket(text), fillings.meant
    world.breaking = comes_apart(text)
    discourse = begin(world, text, clauses.mentions)
    discourse.scene.fillings = fillings
    scene = interpret(discourse, clauses.frames, clauses.attachments)
    scene.text = text
    fill(discourse, fillings)
    scene.asked = asked
    scene.ignored.update({(v.start, v.end): "gerund" for v in clauses.nominal})
    compare(text, clauses.mentions, scene)
    contrast(scene)
    space(text, clauses.mentions, scene)
    _fit_what_is_climbed(discourse)
    get_up_first(discourse)
    contradictions(scene)
    nothing_to_draw(scene)
    too_much(scene)
    restricted = is_restricted(text)
    reasons = expand(scene, text, restricted)
    reasons += [f'"{wrong}" read as "{right}"' for wrong, right in respelled]
    told = scene.relations
    gaps = {frozenset((r.source, r.target)): r.distance for r in told if r.distance is not None}
    timeline = scene.timeline.build(gaps)
    too_long(timeline)
    statements = state(discourse, clauses.frames, elements, tokens)
    timeline = take_time(timeline, statements or (), scene)
    shown = how_filmed(discourse, elements)
    read = account(text, elements, clauses.mentions, scene, tokens)
    expanded = fillings.told + ("" if not reasons else " [" + "; ".join(reasons) + "]")
    placed = stated_in_prompt(statements, text, prompt)
    doc = build(scene, prompt, seed, timeline, in_prompt(read, text, prompt), placed, expanded)
    if parsed(text) is None:
        unaudited = {"config": {**doc.provenance[0].config, "audit": "absent"}}
        doc = doc.model_copy(
            update={"provenance": (doc.provenance[0].model_copy(update=unaudited),)}
        )
    found = tuple(
        s for s in owned_up(text, doc, read, statements)
        if not any(q.start <= s.start < q.end for q in asked)
    )  # fmt: skip
    found += drawn_otherwise(discourse, (*(statements or ()), *found))
    doc = as_told(doc, fillings, prompt)
    if shown:
        everything = with_filming(fillings.told, (*(statements or ()), *found), shown)
        return doc.model_copy(update={"statements": stated_in_prompt(everything, text, prompt)})
    missed = stated_in_prompt(found, text, prompt)
    if not missed:
        return doc
    said = sorted((*(placed or ()), *missed), key=lambda s: s.start)
    return doc.model_copy(update={"statements": tuple(said)})
