"""Word order and gaps: clauses that English turns round or leaves without a verb, made plain.

"Down comes the lamp", "over it goes", "so hard does the gate hit it", "pigeon into windscreen",
"the first hits the second, the second the third": the elements come out in the order subject,
verb, rest, with the verb that is understood. `clauses` then reads them like any others.
"""

from __future__ import annotations

from dataclasses import replace

from esg.draft import lexicon as lex
from esg.draft.grammar.rewrites.asides import set_apart
from esg.draft.grammar.rewrites.gaps import fill_gaps, finite, is_prep, word_at
from esg.draft.text.elements import Element, Mention, Verb, Word
from esg.draft.verbphrases import particle_sense

_MOVING = lex.word_set("moving (reorder)")
_INTRANSITIVE = lex.word_set("intransitive")
_PARTICLES = lex.word_set("particles (reorder)")
_DIRECTIONS = _PARTICLES | frozenset(
    {"into", "onto", "out of", "from", "across", "towards", "toward", "between", "behind", "to"}
)
_PLACES = lex.word_set("places (reorder)")
_NEGATIVE = lex.word_set("negative")
_JUST = lex.word_set("just")
_HELPERS = lex.word_set("helpers")
_BANGS = lex.word_set("bangs")
_SPLASHES = lex.word_set("splashes")
_STOPS = ".;:!?\n"


def reorder(elements: list[Element], text: str) -> list[Element]:
    """Makes subjects precede their verbs, and gives clauses without a verb the one understood.

    Args:
        elements: Noun phrases, verbs and small words in the order of the text.
        text: The prompt.

    Returns:
        The elements, clause by clause; nothing is left out but expletives.
    """
    out: list[Element] = []
    i = 0
    while i < len(elements):
        if _starts_clause(out):
            used = (
                _heading(elements, i, out)
                or _cleft(elements, i, out)
                or _with_helper(elements, i, out)
                or _noise_goes(elements, i, out, text)
                or _inverted(elements, i, out, text)
                or _particle_first(elements, i, out, text)
            )
            if used:
                i += used
                continue
        out.append(elements[i])
        i += 1
    return fill_gaps(set_apart(out))


def _starts_clause(out: list[Element]) -> bool:
    last = out[-1] if out else None
    if last is None:
        return True
    if isinstance(last, Word) and last.kind == "adv" and last.low in ("heading", "then"):
        return True
    return isinstance(last, Word) and (
        last.kind in ("conj", "sub") or (last.kind == "punct" and last.low in '.;:,!?\n—–-)"”')
    )


def _small(e: Element | None) -> bool:
    return isinstance(e, Word) and e.kind in ("prep", "adv", "to")


def _lead(elements: list[Element], i: int) -> int:
    """End of the adverbs and prepositional phrases that open a clause at i."""
    j = i
    while j < len(elements):
        e = elements[j]
        if isinstance(e, Word) and (e.kind in ("adv", "prep", "to") or e.low == "-"):
            j += 1
        elif isinstance(e, Word) and e.kind == "qty" and _small(word_at(elements, j + 1)):
            j += 1  # "six inches from the edge stands a mug"
        elif isinstance(e, Mention) and j > i and is_prep(elements[j - 1]):
            j += 1
        else:
            break
    return j


def _heading(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "Curling:", "Rodeo:": what the scene is about, no object and no verb."""
    last = out[-1] if out else None
    if last is not None and not (isinstance(last, Word) and last.low in ".;!?\n"):
        return 0
    colon = word_at(elements, i + 1)
    if colon is None or colon.low != ":" or i + 2 >= len(elements):
        return 0
    e = elements[i]
    if isinstance(e, Verb):
        topic = e.form == "ing" and not e.auxiliary
    else:
        topic = isinstance(e, Mention) and not (
            e.determiner or e.count or e.letters or e.amounts or e.pronoun or e.coordinated
        )
        topic = topic and isinstance(e, Mention) and not e.plural and not (e.noun and e.known)
        topic = topic and isinstance(e, Mention) and not (e.attribute and e.head in _STATED)
    if not topic or not any(isinstance(x, (Mention, Verb)) for x in elements[i + 2 : i + 5]):
        return 0
    out.append(Word(e.start, colon.end, "adv", "heading"))
    return 2


_STATED = lex.word_set("stated")


def _cleft(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "What knocks the lamp over is a ball": a ball knocks the lamp over."""
    what = elements[i]
    if isinstance(what, Mention) and what.pronoun in ("it", "this", "that"):
        was, thing, that, verb = (elements[i + 1 : i + 5] + [None] * 4)[:4]
        is_it = isinstance(was, Verb) and was.sense == "be" and not was.negated
        told = isinstance(thing, Mention) and isinstance(that, Word) and that.kind == "rel"
        if is_it and told and isinstance(verb, Verb) and thing is not None:
            out.append(thing)  # "it was the bin that stopped the kart"
            return 4
    if getattr(what, "low", getattr(what, "pronoun", "")) not in ("what",):
        return 0
    verb = elements[i + 1] if i + 1 < len(elements) else None
    if not isinstance(verb, Verb) or verb.sense in ("be", "start") or verb.auxiliary:
        return 0
    for k in range(i + 2, min(i + 10, len(elements))):
        e = elements[k]
        if isinstance(e, Word) and e.low in _STOPS + ",":
            return 0
        if isinstance(e, Verb):
            subject = elements[k + 1] if k + 1 < len(elements) else None
            if e.sense != "be" or e.auxiliary == "" or not isinstance(subject, Mention):
                return 0
            out += [subject, verb, *elements[i + 2 : k]]
            return k + 2 - i
    return 0


def _with_helper(elements: list[Element], i: int, out: list[Element]) -> int:
    """ "So hard does the gate hit it that", "never did it touch the rim"."""
    j = i
    while j < len(elements) and _small(elements[j]):
        j += 1
    helper = elements[j] if j < len(elements) else None
    if j == i or not isinstance(helper, Verb) or helper.sense not in ("be", "have"):
        return 0
    subject = elements[j + 1] if j + 1 < len(elements) else None
    k = j + 2
    while k < len(elements) and isinstance(elements[k], Word) and elements[k].low not in ",":
        if not _small(elements[k]):
            return 0
        k += 1
    verb = elements[k] if k < len(elements) else None
    has = helper.sense == "have" and not helper.auxiliary
    if not (has or helper.auxiliary in _HELPERS) or not isinstance(subject, Mention):
        return 0
    if not isinstance(verb, Verb) or verb.form not in ("base", "pp", "past") or verb.auxiliary:
        return 0
    lead = [e for e in elements[i:j] if isinstance(e, Word)]
    no = bool(_NEGATIVE & {w for e in lead for w in e.low.split()})
    no = no and not any(e.low == "only" for e in lead)  # "not only does it miss the pin"
    soon = bool({e.low for e in lead} & _JUST)
    verb.negated = verb.negated or (no and not soon) or helper.negated
    verb.form = "s"
    out += [*[e for e in lead if e.low not in _NEGATIVE | _JUST | {"so"}], subject, verb]
    following = elements[k + 1 : k + 8]
    for n, e in enumerate(following):
        if isinstance(e, Word) and e.low in _STOPS:
            break
        if isinstance(e, Word) and soon and e.low in ("than", "when"):
            out += [*following[:n], Word(e.start, e.end, "adv", "then")]
            return k + 2 + n - i
        if isinstance(e, Word) and e.low == "that" and e.kind == "unknown":
            out += [*following[:n], Word(e.start, e.end, "sub", "so")]
            return k + 2 + n - i
    return k + 1 - i


def _noise_goes(elements: list[Element], i: int, out: list[Element], text: str) -> int:
    """ "Bang goes the hammer on the anvil", "there goes the cake, off the trolley"."""
    noise, verb = elements[i], elements[i + 1] if i + 1 < len(elements) else None
    if isinstance(verb, Word) and verb.kind == "unknown" and verb.low in ("goes", "went", "go"):
        verb = Verb(verb.start, verb.end, "go", "own", "s")
    thing = elements[i + 2] if i + 2 < len(elements) else None
    if not isinstance(verb, Verb) or verb.lemma not in ("go", "come") or verb.passive:
        return 0
    if not isinstance(thing, Mention) or thing.attribute or not finite(verb):
        return 0
    word = text[noise.start : noise.end].lower()
    if isinstance(noise, Mention) and (noise.determiner or noise.count):
        return 0
    if word not in _BANGS | _SPLASHES:
        return 0
    verb = replace(verb, start=noise.start)
    met = word_at(elements, i + 3)
    if word in _BANGS and met is not None and met.low in ("on", "against", "into", "onto"):
        verb = replace(verb, lemma="hit", sense="hit")
    out += [thing, verb]
    comma, on = word_at(elements, i + 3), word_at(elements, i + 4)
    if comma is not None and comma.low == "," and on is not None and on.low in _DIRECTIONS:
        return 4
    return 3


def _inverted(elements: list[Element], i: int, out: list[Element], text: str) -> int:
    """ "Down comes the lamp", "into the net flies the ball", "on the shelf stands a mug"."""
    j = _lead(elements, i)
    verb = finite(elements[j]) if j < len(elements) else None
    if j == i or verb is None:
        return 0
    k = j + 1
    while k < len(elements) and isinstance(elements[k], Word) and elements[k].kind == "adv":
        k += 1
    subject = elements[k] if k < len(elements) else None
    if not isinstance(subject, Mention) or subject.attribute or subject.pronoun in _REFLEXIVE:
        return 0
    if verb.form == "base" and not (subject.plural or subject.coordinated or subject.count):
        return 0
    lows = [e.low for e in elements[i:j] if isinstance(e, Word)]
    stands = verb.sense == "posture" and bool(set(lows) & _PLACES)
    goes = verb.sense in _MOVING or verb.lemma in _INTRANSITIVE
    goes = goes and bool(set(lows) & _DIRECTIONS)
    joined = bool(out) and isinstance(out[-1], Word) and out[-1].kind == "conj"
    if not (stands or goes) or (joined and verb.form == "base"):
        return 0
    if verb.lemma in _INTRANSITIVE:
        verb = replace(verb, sense="own")
    lead = elements[i:j]
    particles = [e for e in lead if isinstance(e, Word) and e.low in _PARTICLES]
    if particles and not any(isinstance(e, Mention) for e in lead):
        verb, lead = _with_particle(verb, particles[-1], lead, elements, k + 1)
    if joined or not any(isinstance(e, Mention) for e in lead):
        out += [subject, verb, *elements[j + 1 : k], *lead]
    else:
        out += [*lead, subject, verb, *elements[j + 1 : k]]  # "..., who" is about the subject
    return k + 1 - i


_REFLEXIVE = lex.word_set("reflexive")


def _with_particle(
    verb: Verb, particle: Word, lead: list[Element], elements: list[Element], following: int
) -> tuple[Verb, list[Element]]:
    """The verb as its particle makes it ("down comes": falls), and what is left of the lead."""
    rest = word_at(elements, following)
    tail = f"{particle.low} {rest.low if rest is not None else ''}".rstrip()
    found = particle_sense(verb.lemma, tail) or particle_sense(verb.lemma, particle.low)
    if found is None and verb.lemma == "come" and particle.low == "down":
        found = "fall", {"particle": "down"}
    if found is None:
        return verb, lead
    sense, extra = found
    changed = replace(verb, sense=sense, extra={**verb.extra, **extra})
    return changed, [e for e in lead if e is not particle]


def _particle_first(elements: list[Element], i: int, out: list[Element], text: str) -> int:
    """ "Over it goes", "down he went", "off the barrel rolls": particle, subject, verb."""
    j = i
    while (small := word_at(elements, j)) is not None and small.kind == "adv":
        j += 1
    if j > i and getattr(word_at(elements, j), "low", "") not in _PARTICLES:
        j -= 1  # the adverb itself may be the particle
    particle = word_at(elements, j)
    if particle is None or particle.low not in _PARTICLES:
        return 0
    subject = elements[j + 1] if j + 1 < len(elements) else None
    verb = finite(elements[j + 2]) if j + 2 < len(elements) else None
    if not isinstance(subject, Mention) or verb is None or subject.attribute:
        return 0
    goes = verb.sense in _MOVING or verb.lemma in _INTRANSITIVE or verb.lemma in ("go", "come")
    after = elements[j + 3] if j + 3 < len(elements) else None
    many = subject.plural or bool(subject.coordinated) or subject.pronoun in ("they", "we")
    if not goes or isinstance(after, Mention) or (verb.form == "base" and not many):
        return 0
    joined = bool(out) and isinstance(out[-1], Word) and out[-1].kind in ("conj", "sub")
    if not subject.pronoun and joined:
        return 0
    changed, rest = _with_particle(verb, particle, [particle], elements, j + 3)
    out += [*elements[i:j], subject, changed, *rest]
    return j + 3 - i
