"""Frames: one verb with its arguments, and the order of frames in time."""

from __future__ import annotations

from dataclasses import dataclass, field

from esg.draft import lexicon as lex
from esg.draft.text.elements import Element, Mention, Verb, Word, element_at
from esg.draft.text.quantities import Amount


@dataclass
class Phrase:
    """A preposition with what follows it."""

    prep: str
    mention: Mention | None = None
    amount: Amount | None = None

    @property
    def told(self) -> list[Amount]:
        """The quantities it tells of what it belongs to: "of 2 kg", "with a mass of 2 kg"."""
        named = self.mention.amounts if self.mention is not None and self.mention.attribute else []
        return [*named, *([self.amount] if self.amount is not None else [])]

    @property
    def mention_plural(self) -> bool:
        """Whether it names several things."""
        return self.mention is not None and (self.mention.plural or (self.mention.count or 1) > 1)


@dataclass
class Frame:
    """One verb and its arguments.

    Args:
        verb: The verb group.
        subject: Its grammatical subject; None for imperatives and passives without an agent.
        link: How it relates to the frame before it: then, cause, while, until, simultaneously.
        times: It only says how long what follows takes ("takes 2 s to stop").
        reduced: A participle that modifies its subject ("a bicycle stopped in ...").
    """

    verb: Verb
    subject: Mention | None = None
    object: Mention | None = None
    object2: Mention | None = None
    phrases: list[Phrase] = field(default_factory=list[Phrase])
    adverbs: list[str] = field(default_factory=list[str])
    amounts: list[Amount] = field(default_factory=list[Amount])
    link: str = "then"
    reduced: bool = False
    times: bool = False
    sentence: int = 0
    relative: bool = False
    resulting: bool = False
    """A relative clause that tells what happens next (", which is pushed into a wall")."""
    subordinate: str = ""
    """The conjunction it came with: when, after, because."""
    start_of_sentence: bool = False
    """Whether it is the first verb of its sentence."""
    opening: bool = False
    """A participle of the subject whose main verb is still to come."""
    causer: Frame | None = None
    parent: Frame | None = None
    main: Frame | None = None
    """The clause that one with a conjunction belongs to."""
    unreal: str = ""
    """Why the prompt names it without saying that it happens."""

    def phrase(self, *preps: str) -> Phrase | None:
        """First phrase with one of the prepositions that has a mention; objects before measures."""
        found = [p for p in self.phrases if p.prep in preps and p.mention is not None]
        if not found:
            return None
        things = (p for p in found if p.mention is not None and not p.mention.attribute)
        return next(things, found[0])


@dataclass
class State:
    subject: Mention | None = None
    frame: Frame | None = None
    main: Frame | None = None
    pending: list[Word] = field(default_factory=list[Word])
    link: str = "then"
    sub: str = ""
    loose: list[Phrase | Amount | str] = field(default_factory=list["Phrase | Amount | str"])
    boundary: bool = True
    boundary_kind: str = ""
    relative: Mention | None = None
    last: Mention | None = None
    last_after_prep: bool = False
    prep: str = ""
    relative_prep: str = ""
    """The preposition of a relative clause ("from which a box falls")."""


def finite_ahead(elements: list[Element], i: int) -> bool:
    """Whether a finite verb follows before the next boundary, so that a clause starts at i."""
    depth = 0
    relative = False
    i = _after_parenthesis(elements, i)
    for e in elements[i:]:
        if isinstance(e, Verb):
            if relative and not e.infinitive:
                relative = False
                continue
            if e.infinitive or e.form == "ing":
                if e.auxiliary and not e.infinitive:
                    return True
                depth += 1
                continue
            if e.form == "pp" and not e.passive and not e.auxiliary:
                continue
            return True
        if isinstance(e, Word):
            if e.kind == "rel":
                relative = True  # "a ball that lies there rolls": its own verb comes first
                continue
            if e.kind == "punct" and e.low in ".;,:!?":
                return False
            if e.kind in ("sub",):
                return False
            if e.kind == "conj" and depth == 0:
                continue
    return False


def _after_parenthesis(elements: list[Element], i: int) -> int:
    """Past ", unable to stop," or ", frightened," between a subject and its verb; else i itself."""
    if getattr(element_at(elements, i), "low", "") != ",":
        return i
    which = getattr(element_at(elements, i + 1), "kind", "") == "rel"
    for k in range(i + 1 + which, min(i + 8 + 6 * which, len(elements))):
        e = elements[k]
        if which and not (isinstance(e, Word) and e.low in (",", ".", ";", "!", "?", ":")):
            continue  # ", which follows it at 10 m/s,"
        if isinstance(e, Word) and (e.kind in ("conj", "sub", "rel") or e.low in ".;!?:"):
            return i
        if isinstance(e, Verb) and not e.infinitive and (e.auxiliary or e.form in ("s", "base")):
            return i
        if isinstance(e, Word) and e.low == ",":
            rest = [x for x in elements[k + 1 : k + 3] if getattr(x, "kind", "") != "adv"]
            verb = rest[0] if rest else None
            if not isinstance(verb, Verb) or verb.infinitive:
                return i
            now = verb.form in ("s", "past") or verb.auxiliary  # "is tipped over"
            return k + 1 if now else i
    return i


_MANOEUVRES = lex.word_set("manoeuvres")
_MOVING = lex.word_set("moving (frames)")


def _manoeuvre_before_the_hit(f: Frame) -> bool:
    """ "collides with a car that turns left": the turn that leads to it, not what comes of it."""
    if not f.relative or f.resulting or f.verb.passive or f.verb.sense not in _MANOEUVRES:
        return False
    return f.parent is not None and f.parent.verb.sense == "hit" and not f.parent.verb.passive


def background_first(frames: list[Frame]) -> list[Frame]:
    """What a noun is already doing ("hit by a van moving at 12 m/s") precedes its clause."""
    out: list[Frame] = []
    for f in frames:
        progressive = f.verb.form == "ing"
        parent = f.parent
        if (
            f.reduced
            and (
                (progressive and (f.verb.sense in _MOVING or f.verb.lemma == "do"))
                or (f.verb.passive and f.verb.sense in ("launch", "drop") and not f.resulting)
                or _manoeuvre_before_the_hit(f)
            )
            and out
            and out[-1].sentence == f.sentence
            and out[-1].subject is not f.subject
            and f.link in ("while", "then")
        ):
            at = out.index(parent) if parent in out else len(out) - 1
            f.link, out[at].link = out[at].link, "then" if out[at].link == "then" else out[at].link
            out.insert(at, f)
        else:
            out.append(f)
    return out


def _of_its_subject(out: list[Frame], f: Frame) -> list[Frame]:
    """The frames at the end that tell of the subject of a clause between it and its verb."""
    k = len(out)
    while k and out[k - 1].relative and out[k - 1].subject is f.subject:
        k -= 1
    return out[k:]


def in_order(frames: list[Frame]) -> list[Frame]:
    """Puts frames in order of time."""
    out: list[Frame] = []
    i = 0
    while i < len(frames):
        f = frames[i]
        link = f.link
        if link in (
            "sub:after",
            "sub:once",
            "sub:when",
            "sub:as",
            "sub:whenever",
            "sub:because",
            "sub:since",
        ):
            own = _of_its_subject(out, f)  # "When a ball that was thrown hits it"
            del out[len(out) - len(own) :]
            previous = out[-1] if out else None
            same_sentence = previous is not None and previous.sentence == f.sentence
            if same_sentence and link != "sub:as":
                # "Y after X": X goes before the main clause and what depends on it
                k = len(out) - 1
                while k > 0 and out[k].sentence == f.sentence and out[k].link in ("while",):
                    k -= 1
                out[k:k] = [*own, f]
                after = k + len(own) + 1
                f.link = out[after].link if after < len(out) else "then"
            else:
                out += [*own, f]
                f.link = "then" if link != "sub:as" else "while"
        elif link == "sub:before" and (not out or out[-1].sentence != f.sentence):
            # fronted "Before X, Y": Y first
            if i + 1 < len(frames) and frames[i + 1].sentence == f.sentence:
                out.append(frames[i + 1])
                i += 1
            out.append(f)
            f.link = "then"
        elif link == "sub:simultaneously":
            f.link = "simultaneously"
            out.append(f)
        elif link == "sub:while":
            f.link = "while"
            out.append(f)
        elif link in (
            "sub:until",
            "sub:till",
            "sub:before",
            "sub:so",
            "sub:if",
            "sub:where",
            "sub:whereas",
        ):
            f.link = {"sub:until": "until", "sub:till": "until", "sub:so": "cause"}.get(
                link, "then"
            )
            out.append(f)
        else:
            out.append(f)
        i += 1
    return out
