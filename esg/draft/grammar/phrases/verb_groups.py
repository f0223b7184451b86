"""Verb groups: auxiliaries, negation, main verb, and the phrase it is the head of."""

from __future__ import annotations

from dataclasses import dataclass

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.nouns import low_at, match_noun
from esg.draft.grammar.phrases.reader import is_adjective, noun_soon, participle
from esg.draft.text.elements import Verb
from esg.draft.text.multiwords import MULTIWORDS
from esg.draft.verbphrases import PHRASES, verb_readings

_BE = lex.word_set("be")
_MODALS = lex.word_set("modals of verb groups")
_CANNOT = lex.word_set("negated modals") | {"cannot", "can't", "couldn't", "can’t"}
_IS_NOT = lex.word_set("negated be")
_MOODS = lex.word_set("moods")
_FOLLOWING = lex.word_set("following")
_AFTER_VERBS = lex.word_set("adverbs that end an auxiliary")


@dataclass
class _Auxiliaries:
    """What stands before the main verb."""

    be: bool = False
    have: bool = False
    modal: bool = False
    negated: bool = False
    word: str = ""
    """The last auxiliary."""
    mood: str = ""
    """would, can, should ..."""


def _read_auxiliary(c: Chunks, j: int, aux: _Auxiliaries) -> bool:
    """Reads one word in front of a main verb; False where none stands there."""
    low = low_at(c, j)
    some = aux.be or aux.have or aux.modal
    if low in _BE or (low in ("gets", "get", "got", "getting") and participle(c, j + 1)):
        aux.be, aux.word = True, low
    elif low in ("has", "have", "had", "having") and participle(c, j + 1, also_been=True):
        aux.have, aux.word = True, low
    elif low in _MODALS:
        aux.modal, aux.word = True, low
        aux.mood = low if low in _MOODS else aux.mood
    elif low in ("not", "never", "n't"):
        aux.negated = True
    elif low in _CANNOT:
        aux.modal, aux.word, aux.negated = True, low, True
    elif low in _IS_NOT:
        aux.be, aux.word, aux.negated = True, low, True
    else:
        adverb = low in lex.ADVERBS and low not in _AFTER_VERBS and not _opens_a_phrase(c, j)
        return some and (adverb or (low.endswith("ly") and not match_noun(c, j)))
    return True


def _opens_a_phrase(c: Chunks, j: int) -> bool:
    """ "Is next to a box": the preposition's first word is no adverb of the verb."""
    return any(
        kind == "prep" and c.lows[j : j + len(words)] == words
        for words, kind, _ in MULTIWORDS.get(low_at(c, j), ())
    )


def verb_group(c: Chunks, i: int) -> int | None:
    """Reads the verb group at token i; returns the next index, None where there is none."""
    start, j, aux = c.tokens[i].start, i, _Auxiliaries()
    while j < len(c.tokens) and _read_auxiliary(c, j, aux):
        j += 1
    main = _main_verb(c, j, aux, bare=j == i)
    if main is None:
        return _auxiliary_alone(c, start, j, aux)
    passive = aux.be and main.form == "pp"
    end = c.tokens[j].end
    verb = Verb(
        start, end, main.lemma, main.sense, main.form, main.note, passive, aux.negated, aux.word
    )
    verb.modal = aux.mood
    k = _phrase(c, verb, j + 1)
    if aux.have and aux.word == "having" and verb.form == "pp":
        verb.form, verb.extra["perfect"] = "ing", "1"
    after = _inner(c, verb, k)
    if after is not None:
        return after
    c.elements.append(verb)
    return k


def _main_verb(c: Chunks, j: int, aux: _Auxiliaries, bare: bool) -> lex.VerbForm | None:
    """The reading of the word after the auxiliaries that goes with them."""
    readings = verb_readings(low_at(c, j)) if j < len(c.tokens) else ()
    if not readings:
        return None
    forms = {r.form: r for r in readings}
    if aux.be:
        main = forms.get("pp") or forms.get("ing")
        adjective = low_at(c, j) not in _FOLLOWING and is_adjective(c, j) and noun_soon(c, j + 1)
        return None if adjective and aux.word in ("is", "are", "was", "were") else main
    if aux.have:
        return forms.get("pp")
    if aux.modal:
        return forms.get("base") or readings[0]
    if not bare:
        return None
    if "base" in forms and "past" not in forms:
        return forms["base"]
    return forms.get("s") or forms.get("past") or forms.get("ing") or readings[0]


def _auxiliary_alone(c: Chunks, start: int, j: int, aux: _Auxiliaries) -> int | None:
    """An auxiliary that is the verb: "is", "has", "would like"."""
    if not (aux.be or aux.have or aux.modal):
        return None
    if aux.modal and low_at(c, j) == "like":
        end = c.tokens[j].end  # "I would like a ball to hit a box"
        c.elements.append(Verb(start, end, "like", "noop", "base", auxiliary=aux.word))
        return j + 1
    lemma = "be" if aux.be or aux.modal else "have"
    end = c.tokens[j - 1].end
    c.elements.append(Verb(start, end, lemma, lemma, "s", negated=aux.negated, auxiliary=aux.word))
    return j


def _phrase(c: Chunks, verb: Verb, k: int) -> int:
    """Gives the verb the sense of the phrase it is the head of; the token after the phrase."""
    for pattern, sense, notes in PHRASES.get(verb.lemma, []):
        m = pattern.match(c.text, verb.end)
        if m is None:
            continue
        path = verb.passive and notes.get("transitive") and sense == "topple"
        if path and _determiner_at(c, m.end()):
            continue  # "is dragged over the sand"
        if notes.get("active") and verb.passive and verb.auxiliary in _BE:
            continue  # "is stuck in a tree": a state
        if notes.get("only_passive"):
            if verb.passive:
                break  # a path, no particle
            continue
        verb.sense, verb.extra = sense, dict(notes)
        direction = m.groupdict().get("dir")
        if direction:
            verb.extra["dir"] = direction.lower()
        verb.end = m.end()
        verb.passive = verb.passive or bool(notes.get("passive"))
        while k < len(c.tokens) and c.tokens[k].start < m.end():
            k += 1
        break
    return k


def _determiner_at(c: Chunks, offset: int) -> bool:
    """Whether an article follows at this place of the text."""
    after = c.text[offset : offset + 8].lower().split()
    return bool(after) and after[0] in ("a", "an", "the", "its", "his", "her", "their")


def _inner(c: Chunks, verb: Verb, k: int) -> int | None:
    """Reads the verb that this one begins, goes on with or ends in: "starts to roll"."""
    ends = verb.sense == "reach" and verb.lemma in ("end", "wind")
    starts = verb.sense == "start"
    goes_on = verb.lemma in ("keep", "continue")
    if not (ends or starts or goes_on):
        return None
    k += low_at(c, k) == "to" and not ends
    forms = {r.form for r in verb_readings(low_at(c, k))}
    after = verb_group(c, k) if forms & ({"ing"} if ends else {"ing", "base"}) else None
    if after is None:
        return None
    inner = c.elements[-1]
    assert isinstance(inner, Verb)
    inner.start, inner.form = verb.start, verb.form
    if starts:
        inner.negated, inner.passive = inner.negated or verb.negated, False
        inner.modal, inner.extra = verb.modal, {**inner.extra, "start": "1"}
        if verb.lemma in ("try", "attempt"):
            inner.extra["tried"] = "1"
    elif goes_on:
        inner.extra = {**inner.extra, "continue": "1"}
    return after
