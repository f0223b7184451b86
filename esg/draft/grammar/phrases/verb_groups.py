"""Verb groups: auxiliaries, negation, main verb, and the phrase it is the head of."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.nouns import low_at, match_noun
from esg.draft.grammar.phrases.reader import is_adjective, noun_soon, participle
from esg.draft.text.elements import Verb
from esg.draft.verbphrases import PHRASES, verb_readings

_NEGATED_MODALS = lex.word_set("negated modals")
_MOODS = lex.word_set("moods")
_FOLLOWING = lex.word_set("following")
_NEGATED_BE = lex.word_set("negated be")


def _determiner_at(c: Chunks, offset: int) -> bool:
    """Whether an article follows at this place of the text."""
    after = c.text[offset : offset + 8].lower().split()
    return bool(after) and after[0] in ("a", "an", "the", "its", "his", "her", "their")


def verb_group(c: Chunks, i: int) -> int | None:
    start = c.tokens[i].start
    j = i
    be = have = modal = negated = False
    aux = mood = ""
    while j < len(c.tokens):
        low = low_at(c, j)
        if low in ("is", "are", "was", "were", "be", "been", "being", "am", "'s") or (
            low in ("gets", "get", "got", "getting") and participle(c, j + 1)
        ):
            be, aux = True, low
        elif low in ("has", "have", "had", "having") and participle(c, j + 1, also_been=True):
            have, aux = True, low
        elif low in (
            "will",
            "would",
            "can",
            "could",
            "should",
            "may",
            "might",
            "must",
            "does",
            "do",
            "did",
            "shall",
        ):
            modal, aux = True, low
            mood = low if low in _MOODS else mood
        elif low in ("cannot", "can't", "couldn't", "can’t"):
            modal, aux, negated = True, low, True
        elif low in (
            "not",
            "never",
            "n't",
        ):
            negated = True
        elif low in _NEGATED_MODALS:
            modal, aux, negated = True, low, True
        elif low in _NEGATED_BE:
            be, aux, negated = True, low, True
        elif (
            low in lex.ADVERBS
            and (be or have or modal)
            and low
            not in (
                "left",
                "right",
                "in",
                "on",
                "over",
                "off",
                "up",
                "down",
                "out",
                "along",
                "around",
                "there",
                "here",
                "away",
                "together",
                "apart",
                "ahead",
                "aside",
                "side",
                "back",
                "forward",
                "backward",
            )
        ) or (low.endswith("ly") and (be or have or modal) and not match_noun(c, j)):
            pass
        else:
            break
        j += 1
    readings = verb_readings(low_at(c, j)) if j < len(c.tokens) else ()
    main = None
    if readings:
        forms = {r.form: r for r in readings}
        if be:
            main = forms.get("pp") or forms.get("ing")
            if (
                main is not None
                and low_at(c, j) not in _FOLLOWING
                and is_adjective(c, j)
                and noun_soon(c, j + 1)
                and aux in ("is", "are", "was", "were")
            ):
                main = None
        elif have:
            main = forms.get("pp")
        elif modal:
            main = forms.get("base") or readings[0]
        elif j == i:
            main = forms.get("s") or forms.get("past") or forms.get("ing") or readings[0]
            if "base" in forms and "past" not in forms:
                main = forms["base"]
    if main is None:
        if not (be or have or modal):
            return None
        if j < len(c.tokens) and not be and not have and modal and readings:
            main = readings[0]
        if main is None and modal and low_at(c, j) == "like":
            end = c.tokens[j].end  # "I would like a ball to hit a box"
            c.elements.append(Verb(start, end, "like", "noop", "base", auxiliary=aux))
            return j + 1
        if main is None:
            lemma = "be" if be or modal else "have"
            sense = "be" if be or modal else "have"
            c.elements.append(
                Verb(
                    start,
                    c.tokens[j - 1].end,
                    lemma,
                    sense,
                    "s",
                    negated=negated,
                    auxiliary=aux,
                )
            )
            return j
    passive = be and main.form == "pp" and not (main.form == "pp" and "ing" in main.form)
    end = c.tokens[j].end
    verb = Verb(start, end, main.lemma, main.sense, main.form, main.note, passive, negated, aux)
    verb.modal = mood
    k = j + 1
    for pattern, sense, extra in PHRASES.get(main.lemma, []):
        m = pattern.match(c.text, end)
        over = passive and extra.get("transitive") and sense == "topple"
        if m and over and _determiner_at(c, m.end()):
            continue  # "is dragged over the sand": a path
        if m and extra.get("only_passive"):
            if passive:
                break  # a path, no particle
            continue
        if m:
            verb.sense = sense
            verb.extra = dict(extra)
            direction = m.groupdict().get("dir")
            if direction:
                verb.extra["dir"] = direction.lower()
            verb.end = m.end()
            while k < len(c.tokens) and c.tokens[k].start < m.end():
                k += 1
            if extra.get("passive"):
                verb.passive = True
            break
    if have and aux == "having" and verb.form == "pp":
        verb.form, verb.extra["perfect"] = "ing", "1"
    if verb.sense == "reach" and verb.lemma in ("end", "wind"):
        inner = verb_readings(low_at(c, k))
        if any(r.form == "ing" for r in inner):
            n = verb_group(c, k)  # "ends up hitting a tent"
            if n is not None:
                main2 = c.elements[-1]
                assert isinstance(main2, Verb)
                main2.start, main2.form = start, verb.form
                return n
    if verb.sense == "start":
        follow = k + (1 if low_at(c, k) == "to" else 0)
        inner = verb_readings(low_at(c, follow))
        if inner and any(r.form in ("ing", "base") for r in inner):
            size = len(c.elements)
            n = verb_group(c, follow)
            if n is not None and len(c.elements) > size:
                main2 = c.elements[-1]
                assert isinstance(main2, Verb)
                main2.start = start
                main2.negated = main2.negated or negated
                main2.form = verb.form if verb.form != "ing" else "ing"
                main2.passive = False
                main2.modal = mood
                main2.extra = {**main2.extra, "start": "1"}
                if verb.lemma in ("try", "attempt"):
                    main2.extra["tried"] = "1"
                return n
    if verb.lemma in ("keep", "continue"):
        follow = k + (1 if low_at(c, k) == "to" else 0)
        inner = verb_readings(low_at(c, follow))
        if inner and any(r.form in ("ing", "base") for r in inner):
            n = verb_group(c, follow)
            if n is not None:
                main2 = c.elements[-1]
                assert isinstance(main2, Verb)
                main2.start, main2.form = start, verb.form
                main2.extra = {**main2.extra, "continue": "1"}
                return n
    c.elements.append(verb)
    return k
