"""Words of a prompt that the rules find nothing for, and a model's document has nothing for either.

The rules own up to every word that nothing stands for (`esg.draft.statements`). A model may draw
more than they can, so each of these words is looked up in its document before it is missed there.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
import re

from esg.draft import lexicon as lex
from esg.draft.document.screening import screen
from esg.draft.statements.account import NOTHING, PASSED_OVER
from esg.draft.statements.adverbs import NO_MANNER
from esg.draft.statements.unseen import FLUIDS, NO_THING, unseen_words
from esg.draft.text.elements import Token
from esg.draft.text.tagging import pos_tags
from esg.draft.text.tokens import tokenize
from esg.graph.models import (
    CoverageItem,
    EdgeEvent,
    EsgDocument,
    NodeEvent,
    Predicate,
    RegionType,
    RelationType,
    Statement,
    TimelineEdge,
    TimelineNode,
)
from esg.lexicon.contents import contents_said
from esg.outcomes import UserError

_COURSES = lex.word_set("shapes of courses")
_SOFT = lex.word_set("soft garments")
_MANNERS = frozenset(
    {
        Predicate.SLOWER_THAN,
        Predicate.FASTER_THAN,
        Predicate.STAYS_STILL,
        Predicate.STAYS_UPRIGHT,
        Predicate.SPINS,
        Predicate.TUMBLES,
        Predicate.ROLLS,
        Predicate.SLIDES,
    }
)
"""Predicates that can say how something is done."""
_BY_WORDS = frozenset({Predicate.CLIMBS, Predicate.FILMED})
"""Predicates that nothing but a statement of the same words holds."""
_SAID = _BY_WORDS | {Predicate.MOVES}
FORGOTTEN = "the rules read it, the model's draft has nothing of it"
_ACTS = frozenset(
    {
        EdgeEvent.RELEASE,
        EdgeEvent.DRIVE,
        EdgeEvent.TURN,
        EdgeEvent.SPIN,
        EdgeEvent.GUIDE,
        EdgeEvent.BRAKE,
        EdgeEvent.ACCELERATED_MOTION,
    }
)
"""Motions that say what is done, and not only that something moves."""
_UP_OR_DOWN = {
    "down": (NodeEvent.FALL, NodeEvent.TOPPLE, NodeEvent.PLACED, NodeEvent.BOUNCE),
    "up": (NodeEvent.JUMP, NodeEvent.PICKED_UP, NodeEvent.BOUNCE),
}
"""Point events that show a direction."""
_PACES = (Predicate.SLOWER_THAN, Predicate.FASTER_THAN)
_GAITS = frozenset(
    word
    for word, forms in lex.verb_forms().items()
    if any(f.lemma in ("run", "walk") for f in forms)
)
_NO_EVENTS = (NodeEvent.SCENE_START, NodeEvent.TRIGGER)
"""Point events that show nothing by themselves."""


def unheld(doc: EsgDocument, rules: EsgDocument | None) -> tuple[Statement, ...]:
    """Statements `not_represented` that a model's document lacks.

    Args:
        doc: The model's document.
        rules: The rules drafter's, of the same prompt; None where they refuse it: then every word
            of content is looked up by itself.

    Returns:
        One for each stretch of words, about the document's own nodes; their ids mean nothing.
    """
    if rules is None:
        return _by_words(doc)
    book = _Book(doc, rules)
    return tuple(
        _lost(book, told)
        for told in rules.statements or ()
        if not book.says_so(told) and not _HOLDS[book.kind(told)](book, told)
    )


_CONTENT = frozenset({"NOUN", "PROPN", "VERB", "ADJ", "ADV"})
"""Parts of speech that say something."""


def _by_words(doc: EsgDocument) -> tuple[Statement, ...]:
    """Words of content that no thing is called or described by and no statement is about.

    Of English prompts that the rules read no further; without a timeline no verb is shown, either.
    """
    definition = doc.scene_definition
    text, things = definition.original_description, _described(doc)
    try:
        screen(text)
    except UserError:
        return ()  # in another language its words say nothing of the document's
    called = frozenset[str]().union(*heads(doc).values())
    said = [(s.start, s.end) for s in doc.statements or ()]
    why = {a: w for a, _, w in unseen_words(text, definition.scene_parameters.scene_type)}
    lost: list[Token] = []
    for token in tokenize(text, pos_tags(text)):
        shown = token.tag == "VERB" and doc.timeline_system is not None
        if token.tag not in _CONTENT or shown or token.low in PASSED_OVER:
            continue
        shows = things if token.start not in why else called
        if not _words(token.low) & shows and not any(
            a < token.end and token.start < b for a, b in said
        ):
            lost.append(token)
    return tuple(
        Statement(
            id=f"w{k}",
            predicate=Predicate.NOT_REPRESENTED,
            text=text[t.start : t.end],
            start=t.start,
            end=t.end,
            note=why.get(t.start, NOTHING),
        )
        for k, t in enumerate(lost)
    )


def _described(doc: EsgDocument) -> frozenset[str]:
    """Every word that a thing of the document is called, coloured or described by."""
    graph, assets = doc.spatial_relation_graph, doc.asset_requirement
    out = _words(" ".join(r.relation_type.value for r in graph.edges.binary_relations))
    for name, node in graph.nodes.items():
        a = assets.get(node.asset_id)
        of_asset = (a.asset_category, a.asset_description, a.color, a.material) if a else ()
        out |= _words(" ".join(filter(None, (name, node.label, *of_asset))).replace("_", " "))
    return frozenset(out)


def _lost(book: _Book, told: Statement) -> Statement:
    """What the rules own up to, or state and the model does not, as not represented."""
    about = tuple(dict.fromkeys(n for g in told.object for n in book.of_rules(g)))
    if told.predicate is Predicate.NOT_REPRESENTED:
        return told.model_copy(update={"object": about})
    if told.predicate in _OF_LIQUIDS:
        *_, (start, end) = [(0, len(told.text)), *_fluids_in(told.text)]
        told = told.model_copy(
            update={
                "text": told.text[start:end],
                "start": told.start + start,
                "end": told.start + end,
            }
        )
        return _gap(told, about, FLUIDS)
    return _gap(told, about, FORGOTTEN)


_OF_LIQUIDS = frozenset({Predicate.FILLED_WITH, Predicate.FLOATS, Predicate.SINKS})
"""What only the rules put into vessels: a model's document holds no contents."""


def _fluids_in(text: str) -> list[tuple[int, int]]:
    words = "|".join(sorted(map(re.escape, contents_said()), key=lambda w: (-len(w), w)))
    return [m.span() for m in re.finditer(rf"\b(?:{words})\b", text, re.IGNORECASE)]


def _gap(told: Statement, about: tuple[str, ...], why: str) -> Statement:
    return Statement(
        id=told.id,
        predicate=Predicate.NOT_REPRESENTED,
        text=told.text,
        start=told.start,
        end=told.end,
        object=about,
        note=why,
    )


def with_unheld(doc: EsgDocument, rules: EsgDocument | None) -> tuple[Statement, ...] | None:
    """The document's statements and what `unheld` adds to them, with ids of their own.

    Args:
        doc: The model's document.
        rules: The rules drafter's; None if they refuse the prompt.
    """
    stated, more = doc.statements or (), unheld(doc, rules)
    taken = {s.id for s in stated}
    free = (name for k in range(1, 2 + len(stated) + len(more)) if (name := f"s{k}") not in taken)
    named = (s.model_copy(update={"id": name}) for s, name in zip(more, free, strict=False))
    return (*stated, *named) or None


def head(text: str) -> str:
    """The noun that a label is about, in the singular: "bucket" of "tin buckets of water"."""
    words = re.findall(r"[a-z][a-z'-]*", text.lower().partition(" of ")[0])
    return lex.singular(words[-1])[0] if words else ""


def heads(doc: EsgDocument) -> dict[str, frozenset[str]]:
    """What each node of a document may be called, in one word: by its label, name or category."""
    out: dict[str, frozenset[str]] = {}
    for name, node in doc.spatial_relation_graph.nodes.items():
        asset = doc.asset_requirement.get(node.asset_id)
        texts = (node.label, re.sub(r"_\d+$", "", name), asset.asset_category if asset else "")
        out[name] = frozenset(head(t.replace("_", " ")) for t in texts if t)
    return out


@dataclass(frozen=True)
class _Book:
    """The two documents, and what words are about in each."""

    doc: EsgDocument
    rules: EsgDocument

    @cached_property
    def _heads(self) -> dict[str, frozenset[str]]:
        return heads(self.doc)

    @cached_property
    def categories(self) -> frozenset[str]:
        """What the things are, whatever they are called."""
        graph, assets = self.doc.spatial_relation_graph, self.doc.asset_requirement
        used = (assets.get(node.asset_id) for node in graph.nodes.values())
        return frozenset(head(a.asset_category.replace("_", " ")) for a in used if a is not None)

    @cached_property
    def _verbs(self) -> frozenset[tuple[int, int]]:
        items: tuple[CoverageItem, ...] = self.rules.coverage.items
        return frozenset((i.start, i.end) for i in items if i.kind == "event")

    @cached_property
    def _surplus(self) -> tuple[tuple[str, ...], ...]:
        """Of whom the events and acts are that the model has more of than the rules."""
        more = _counted(self.doc) - _counted(self.rules)
        out = [n.participants for n in _points(self.doc) if n.event in more]
        read = {e.event for e in _edges(self.rules)}
        acts = (e for e in _edges(self.doc) if e.event in _ACTS - read)
        return (*out, *((e.actor,) for e in acts))

    def kind(self, gap: Statement) -> str:
        """What sort of words a statement of the rules is about: a key of `_HOLDS`."""
        if gap.predicate in _OF_LIQUIDS:
            return "liquid"
        if gap.predicate is not Predicate.NOT_REPRESENTED:
            if gap.predicate in _PACES and gap.text.lower() in _GAITS:
                return "elsewhere"  # a motion of its own tells that somebody walks
            if gap.predicate in (Predicate.WEARS, Predicate.LOOKS):
                return "worn"
            said = gap.predicate in _MANNERS or gap.predicate in _SAID
            return "stated" if said else "elsewhere"
        if (gap.start, gap.end) in self._verbs:
            return "verb"
        return {FLUIDS: "fluid", NO_THING: "no_thing", NO_MANNER: "manner"}.get(gap.note, "other")

    def about(self, gap: Statement) -> tuple[Statement, ...]:
        """The document's statements of a gap's words, but for those of stiff bodies for clothes."""
        return tuple(
            s
            for s in self.doc.statements or ()
            if s.start < gap.end and gap.start < s.end and not any(self.soft(n) for n in s.object)
        )

    def soft(self, name: str) -> bool:
        """Whether a node is a garment that bends."""
        return bool(self._heads.get(name, frozenset()) & _SOFT)

    def says_so(self, gap: Statement) -> bool:
        """Whether the document owns up to a gap's words itself."""
        return any(s.predicate is Predicate.NOT_REPRESENTED for s in self.about(gap))

    def named(self, text: str) -> tuple[str, ...]:
        """The nodes that one of the words names."""
        words = _words(text)
        return tuple(n for n, heads in self._heads.items() if heads & words)

    def of_rules(self, name: str) -> tuple[str, ...]:
        """The nodes that are called like one of the rules' document."""
        node = self.rules.spatial_relation_graph.nodes.get(name)
        called = {head(node.label if node is not None else ""), head(re.sub(r"_\d+$", "", name))}
        return tuple(n for n, heads in self._heads.items() if heads & called)

    @cached_property
    def _only_here(self) -> frozenset[str]:
        """Who moves in the document and not in the rules'."""
        there = {n for g in _movers(self.rules) for n in self.of_rules(g)}
        return frozenset(_movers(self.doc) - there)

    def happens(self, gap: Statement) -> bool:
        """Whether the document has an event or a motion that the rules lack, of who is told of."""
        about = {n for g in gap.object for n in self.of_rules(g)}
        if about & self._only_here:
            return True
        return any(not about or about & {*who} for who in self._surplus)

    def contained(self, name: str) -> bool:
        """Whether a node is in another one that the prompt names: its contents."""
        graph = self.doc.spatial_relation_graph
        node = graph.nodes[name]
        region = graph.semantic_regions.get(node.semantic_region or "")
        hosts = {region.parent_object} if region and region.region_type is _STORAGE else set[str]()
        hosts |= {
            r.to
            for r in graph.edges.binary_relations
            if r.from_ == name and r.relation_type is RelationType.INSIDE_OF
        }
        return any(h in graph.nodes and graph.nodes[h].mentioned for h in hosts)


def _words(text: str) -> set[str]:
    return {lex.singular(w)[0] for w in re.findall(r"[a-z][a-z'-]*", text.lower())}


_STORAGE = RegionType.STORAGE


def _points(doc: EsgDocument) -> tuple[TimelineNode, ...]:
    return doc.timeline_system.sequence_graph.nodes if doc.timeline_system is not None else ()


def _edges(doc: EsgDocument) -> tuple[TimelineEdge, ...]:
    return doc.timeline_system.sequence_graph.edges if doc.timeline_system is not None else ()


def _movers(doc: EsgDocument) -> set[str]:
    return {e.actor for e in _edges(doc)}


def _counted(doc: EsgDocument) -> Counter[NodeEvent]:
    return Counter(n.event for n in _points(doc) if n.event not in _NO_EVENTS)


def _verb(book: _Book, gap: Statement) -> bool:
    return bool(book.about(gap)) or book.happens(gap)


def _fluid(book: _Book, gap: Statement) -> bool:
    """A lake is there when it is drawn; water in a bucket would have to flow."""
    drawn = book.named(gap.text)
    return bool(drawn) and not any(book.contained(n) for n in drawn)


def _no_thing(book: _Book, gap: Statement) -> bool:
    """A motion holds the noun of its course ("in circles"), and no other that is no thing.

    A thing that is only called so does not ("a herd of its kind" is drawn as zebras).
    """
    words = _words(gap.text)
    stated = book.about(gap)
    if any(s.predicate is not Predicate.MOVES for s in stated) or words & book.categories:
        return True
    return bool(stated) and bool(words & _COURSES)


def _manner(book: _Book, gap: Statement) -> bool:
    return any(s.predicate in _MANNERS for s in book.about(gap))


def _other(book: _Book, gap: Statement) -> bool:
    return book.happens(gap) or _worn(book, gap)


def _worn(book: _Book, gap: Statement) -> bool:
    """Whether a statement is about the words, or a stiff body that they name is tied to it."""
    if book.about(gap):
        return True
    about = {n for g in gap.object for n in book.of_rules(g)}
    others = [n for n in book.named(gap.text) if n not in about and not book.soft(n)]
    return any(_tied(book.doc, n, about) for n in others)


def _stated(book: _Book, told: Statement) -> bool:
    """Whether the document says the same, by words or by who goes where."""
    if any(s.predicate is told.predicate for s in book.doc.statements or ()) or book.about(told):
        return True
    if told.predicate in _BY_WORDS:
        return False
    if any(n.event in _UP_OR_DOWN.get(told.direction or "", ()) for n in _points(book.doc)):
        return True
    if told.direction == "backward" and any(e.params.backward for e in _edges(book.doc)):
        return True
    about = {n for g in told.object for n in book.of_rules(g)}
    targets = {n for g in told.target for n in book.of_rules(g)}
    return any(_tied(book.doc, n, about) for n in targets - about)


def _tied(doc: EsgDocument, name: str, others: set[str]) -> bool:
    """Whether a relation, a place, a statement, a motion or an event joins a node to others.

    Args:
        doc: The document.
        name: The node.
        others: The others; empty: anything that moves or takes part in an event.
    """
    graph = doc.spatial_relation_graph
    pairs = [{r.from_, r.to} for r in graph.edges.binary_relations]
    pairs += [{*m.subjects, *m.targets} for m in graph.edges.multi_relations]
    for n, node in graph.nodes.items():
        region = graph.semantic_regions.get(node.semantic_region or "")
        pairs += [{n, region.parent_object}] if region is not None else []
    pairs += [{*s.object, *s.target} for s in doc.statements or ()]
    pairs += [{*n.participants} for n in _points(doc)]
    pairs += [{e.actor, e.target or e.actor} for e in _edges(doc)]
    return any(name in pair and (pair & others if others else len(pair) > 1) for pair in pairs)


_HOLDS: dict[str, Callable[[_Book, Statement], bool]] = {
    "stated": _stated,
    "elsewhere": lambda book, told: True,  # places and contacts are relations or events, too
    "verb": _verb,
    "fluid": _fluid,
    "liquid": lambda book, told: False,
    "no_thing": _no_thing,
    "manner": _manner,
    "worn": _worn,
    "other": _other,
}
"""Whether a document holds what the rules could not, by the sort of its words."""
