"""Heads of noun phrases: the noun itself, what belongs to it, and individual letters."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.grammar.phrases.chunks import Chunks
from esg.draft.grammar.phrases.letters import letters
from esg.draft.grammar.phrases.noun_questions import (
    bare_color,
    color_acts,
    does_next,
    ends_phrase,
    is_attribute_start,
    is_name,
    let_do,
    like_a_verb,
    many_do,
    names_it,
    noun_then_verb,
    numbers,
    one_does,
    part_alone,
    piled,
    plain_noun,
    pronoun_here,
    waiting_place,
)
from esg.draft.grammar.phrases.nouns import low_at, match_noun, token_at
from esg.draft.grammar.phrases.reader import (
    compound_noun,
    known_adjective,
    looks_like_verb,
    named_before,
    noun_not_verb,
    unknown_noun,
)
from esg.draft.grammar.phrases.rows import inner_phrase, member_of_row, the_rest
from esg.draft.text.elements import Mention
from esg.draft.verbphrases import verb_readings

_PIECES = lex.word_set("pieces")
_RUNNING_GEAR = lex.word_set("running gear")


_SINGULAR = lex.word_set("singular")
_MOSTLY_NOUNS = lex.word_set("mostly nouns")
_WAYS = lex.word_set("ways (noun heads)")
_VESSELS = lex.word_set("vessels (noun heads)")


def read_head(c: Chunks, i: int, j: int, m: Mention) -> int | None:
    tokens = c.tokens
    low = low_at(c, j)
    noun = match_noun(c, j) if j < len(tokens) else None
    if noun is not None and noun[3] == "corner" and low_at(c, j + 1) == "of":
        noun = None  # of a room or a table, not of the street
    if noun is not None and noun[3] == "path" and m.determiner and low_at(c, j + 1) == "of":
        noun = None  # "into the path of a tram": no footpath
    if noun is not None and m.determiner in ("both", "all") and many_do(c, j, m):
        noun = None  # "and both slide into a bale"
    phrase_start = tokens[j].start if j < len(tokens) else m.end
    if noun is not None:
        entry, n, plural, phrase = noun
        # an adjective that is also a noun ends a compound ("steel ball", "office desk")
        k = j + n
        first = j
        while True:
            following = match_noun(c, k) if k < len(tokens) else None
            if following is None or plural or low_at(c, k) in lex.ADVERBS:
                break
            readings = verb_readings(low_at(c, k))
            if let_do(c, k, readings):
                break  # "make a ball bowl over a pin"
            acts = low_at(c, k + 1) in lex.DETERMINERS | lex.PRONOUNS
            if following[2] and (m.determiner in _SINGULAR or (readings and acts)):
                break  # "a door swings shut", "a cyclist signals": no plural after "a"
            swings = following[2] and not plural and any(r.form == "s" for r in readings)
            if swings and low_at(c, k + 1) in _WAYS:
                break  # "the quad bike swings left"
            named = following[0].kind in _VESSELS or low_at(c, k) in _MOSTLY_NOUNS
            vessel = m.determiner and named and ends_phrase(c, k)
            if readings and following[1] == 1 and not (vessel or compound_noun(c, k, m)):
                break
            modifier = " ".join(t.low for t in tokens[first:k])
            m.adjectives.extend(modifier.split())
            entry, n, plural, phrase = following
            first = k
            k += n
        j = first
        m.noun, m.head, m.plural = entry, phrase, plural or m.plural
        k += piled(c, k, m)
        following_qty = token_at(c, k + 1)
        if phrase in ("weight", "mass") and (
            (
                low_at(c, k) in ("of", "is")
                and following_qty is not None
                and following_qty.kind == "qty"
            )
            or m.determiner == "its"
        ):
            m.noun, m.attribute = None, True
        if phrase in lex.PERSON_ROLES or phrase in ("cyclist", "rider"):
            m.role = phrase if phrase in lex.PERSON_ROLES else ""
        if phrase in ("row", "line"):
            m.noun = None
        j = k
        if (
            low_at(c, j) == "of"
            and low_at(c, j + 1) in lex.SUBSTANCES
            and match_noun(c, j + 1) is None
        ):
            m.adjectives.append(low_at(c, j + 1))
            j += 2
        if low_at(c, j) == "on" and low_at(c, j + 1) in _RUNNING_GEAR:
            m.adjectives.append("wheeled")  # "an armchair on wheels": no objects of their own
            j += 2
        if low_at(c, j) in ("behind", "following") and low_at(c, j + 1) in (
            "it",
            "him",
            "her",
            "them",
        ):
            m.adjectives.append("rear")
            j += 2
        elif (
            low_at(c, j) == "behind"
            and m.determiner == "the"
            and (
                verb_readings(low_at(c, j + 1))
                or token_at(c, j + 1) is None
                or c.tokens[j + 1].kind == "punct"
            )
        ):
            m.adjectives.append("rear")
            j += 1
        elif (
            low_at(c, j) == "in"
            and low_at(c, j + 1) == "front"
            and m.determiner == "the"
            and (low_at(c, j + 2) != "of" or low_at(c, j + 3) in ("it", "him", "her", "them"))
        ):
            m.adjectives.append("front")
            j += 4 if low_at(c, j + 2) == "of" else 2
        on_top = 2 if low_at(c, j + 1) == "top" else 3 if low_at(c, j + 2) == "top" else 0
        if (
            on_top
            and low_at(c, j) in ("on", "at")
            and low_at(c, j + 1) in ("top", "the")
            and m.determiner == "the"
            and not plural
            and (
                low_at(c, j + on_top) != "of"
                or low_at(c, j + on_top + 2) in ("stack", "pile", "tower", "heap")
            )
        ):
            m.adjectives.append("top")  # "the crate on top falls off"
            j += on_top
        if (
            set(m.adjectives) & lex.STACKED.keys()
            and low_at(c, j) == "of"
            and low_at(c, j + 1) in ("the", "a", "this", "that")
            and low_at(c, j + 2) in ("stack", "pile", "tower", "heap")
            and low_at(c, j + 3) != "of"
        ):
            m.stacked = True
            j += 3
        if (m.role or m.head == "net") and low_at(c, j) == "of":
            size = len(c.elements)
            inner = c.noun_phrase(j + 1)
            if inner is not None:
                owner = c.elements.pop()
                assert isinstance(owner, Mention) and len(c.elements) == size
                owner.start = m.start
                c.elements.append(owner)
                return inner
        # unknown nouns after a known modifier: "car horn"
        token = token_at(c, j)
        if (
            token is not None
            and token.kind == "word"
            and token.tag in ("NOUN", "PROPN")
            and not (looks_like_verb(c, j, m) or numbers(c, j))
            and not plural
            and len(token.text) > 1
            and token.low not in lex.ADVERBS
            and token.low not in lex.PREPOSITIONS
            and not verb_readings(token.low)
            and token.low not in lex.DETERMINERS
            and token.low not in lex.SUBORDINATORS
        ):
            single, is_plural = lex.singular(token.low)
            if single in lex.ATTRIBUTES:
                m.attribute = True
                m.head, m.noun = single, None
                j += 1
            elif single in lex.PARTS:
                m.part = single
                j += 1
            elif single not in ("other", "one"):
                m.adjectives.append(m.head)
                m.head, m.noun, m.plural, m.known = single, None, is_plural, False
                j += 1
    elif low == "rest" and m.determiner == "the" and not m.adjectives:
        j = the_rest(c, j, m)
    elif low in _PIECES and low_at(c, j + 1) == "of" and (inner := inner_phrase(c, j + 2, m)):
        return inner
    elif low in lex.BODY_PARTS and (
        low_at(c, i - 1) == "'s" or m.determiner in ("his", "her", "its", "their")
    ):
        m.head = low
        m.attribute = False
        j += 1
    elif (
        low
        and (low in lex.PARTS or lex.singular(low)[0] in lex.PARTS)
        and (m.determiner or m.adjectives or low_at(c, j + 1) == "of")
        and not part_alone(c, j, m)
    ):
        after = match_noun(c, j + 1)
        if after is not None and not verb_readings(low_at(c, j + 1)):
            m.adjectives.append(low)  # "the head pin"
            return read_head(c, i, j + 1, m)
        m.part = lex.singular(low)[0]
        m.head = m.part
        m.attribute = True
        j += 1
        if m.part in ("edge", "side") and low_at(c, j) in ("length", "lengths"):
            m.part, m.head = "", "size"  # "with an edge length of 10 cm"
            j += 1
        if low_at(c, j) == "of":
            size = len(c.elements)
            inner = c.noun_phrase(j + 1)
            if inner is not None:
                owner = c.elements.pop()
                assert isinstance(owner, Mention) and len(c.elements) == size
                owner.part = m.part
                owner.adjectives = owner.adjectives
                if m.adjectives:
                    owner.part = f"{' '.join(m.adjectives)} {m.part}"
                owner.start = m.start
                c.elements.append(owner)
                return inner
    elif low == "stop" and waiting_place(c, i, j, m):
        m.noun, m.head = lex.nouns()["bus stop"], "stop"
        j += 1
    elif low and does_next(c, j, m):
        m.head, m.known = low, False  # "a steel hook is hit"
        j += 1
    elif (
        low
        and {low, lex.singular(low)[0]} & lex.ATTRIBUTES
        and not many_do(c, j, m)
        and not color_acts(c, j, m)
        and not one_does(c, j, m)
        and (m.determiner or m.adjectives or m.count is not None or is_attribute_start(c, j))
    ):
        after = match_noun(c, j + 1)
        acts = verb_readings(low_at(c, j + 1)) and not noun_not_verb(c, j + 1, m)
        if after is not None and names_it(m, low) and not acts:
            m.adjectives.append(low)  # "the space station", "a storm lantern"
            return read_head(c, i, j + 1, m)
        if names_it(m, low) and plain_noun(c, j + 1):
            m.adjectives.append(low)  # "a weather vane"
            return read_head(c, i, j + 1, m)
        m.attribute = True
        m.head = low if low in lex.ATTRIBUTES else lex.singular(low)[0]
        j += 1
        if low_at(c, j) in ("speed", "velocity", "distance", "height"):
            m.head = low_at(c, j)
            j += 1
    elif (
        low in lex.PRONOUNS
        and not m.adjectives
        and (low not in ("that", "this", "one", "both") or pronoun_here(c, j))
    ):
        if m.determiner and low not in ("one", "other"):
            return None
        m.pronoun = low
        if m.determiner or m.count:
            m.pronoun = low
        j += 1
    elif (
        m.determiner in lex.PRONOUNS
        and not m.adjectives
        and j == i + 1
        and m.count is None
        and not (m.determiner == "another" and unknown_noun(c, j))
    ):
        m.pronoun = m.determiner
        if m.determiner in ("his", "her", "my", "our", "your", "its", "their"):
            return None
    elif (
        not (m.determiner == "another" and unknown_noun(c, j))
        and m.determiner in ("both", "each", "all", "some", "many", "several", "another")
        and j == i + 1
    ):
        m.pronoun = m.determiner
    elif low in ("one", "ones", "other", "others") and (
        m.determiner or m.adjectives or (m.count is not None and low == "others")
    ):
        m.pronoun = "ones" if low in ("ones", "others") else "one"
        if low.startswith("other"):
            m.adjectives.append("other")
        j += 1
        picked = [a for a in m.adjectives if a in lex.COLORS]
        if low == "one" and picked and low_at(c, j) == "of":
            size = len(c.elements)
            inner = c.noun_phrase(j + 1)
            owner = c.elements[-1] if len(c.elements) == size + 1 else None
            if inner is not None and isinstance(owner, Mention) and (owner.count or 1) > 1:
                owner.pick, owner.start = picked[-1], m.start  # "the blue one of three balls"
                return inner
            del c.elements[size:]
    elif (
        m.adjectives
        and (m.determiner or bare_color(c, i, j, m))
        and (j >= len(tokens) or not unknown_noun(c, j))
    ):
        # "the other", "the second", "the black", "the last two"
        last = m.adjectives[-1]
        if not known_adjective(last) and not last.startswith("@"):
            m.adjectives.pop()  # the tagger took an unknown noun for an adjective
            m.head, m.plural = lex.singular(last)
            m.known = False
        else:
            m.pronoun = "one"
            if m.count and m.count > 1:
                m.pronoun = "ones"
            if low_at(c, j) == "of" and m.pronoun == "one":
                size = len(c.elements)
                inner = c.noun_phrase(j + 1)
                if inner is not None:
                    owner = c.elements.pop()
                    assert isinstance(owner, Mention) and len(c.elements) == size
                    owner.pick, owner.start = last, m.start
                    c.elements.append(owner)
                    return inner
    elif (
        low
        and unknown_noun(c, j)
        and (
            m.determiner
            or m.adjectives
            or m.count is not None
            or m.pattern
            or tokens[j].tag in ("NOUN", "PROPN")
            or named_before(c, j)
        )
    ):
        # unknown head, possibly a compound
        k = j
        while (
            k + 1 < len(tokens)
            and match_noun(c, k + 1) is None
            and unknown_noun(c, k + 1)
            and tokens[k + 1].tag in ("NOUN", "PROPN", "")
            and tokens[k].tag != ""
        ) or noun_then_verb(c, k + 1, m):
            m.adjectives.append(low_at(c, k))
            k += 1
        nxt = match_noun(c, k + 1) if k + 1 < len(tokens) else None
        clear = nxt is not None and (
            not verb_readings(low_at(c, k + 1)) or noun_not_verb(c, k + 1, m)
        )
        if clear and tokens[k].text != "'s":
            m.adjectives.append(low_at(c, k))
            return read_head(c, i, k + 1, m)
        m.head, m.plural = lex.singular(low_at(c, k))
        if k == j and is_name(c, j, m):
            m.head, m.plural, m.noun = low_at(c, k), False, lex.nouns()["person"]
        titled = k == j and k + 1 < len(tokens) and tokens[k + 1].text == ":"
        m.attribute = m.head in lex.ATTRIBUTES and not titled  # "Night has fallen."
        m.known = m.attribute or m.noun is not None
        j = k + 1
    elif m.count is not None and m.count != 0 and (j > i):
        if m.determiner in ("the", "this", "that") or j == i + 1:
            m.pronoun = "ones" if m.count > 1 else "one"
        else:
            return None
    elif like_a_verb(c, j, m):
        m.head, m.known = low, False
        j += 1
    else:
        return None
    j = member_of_row(c, j, m) or letters(c, j, m)
    if set(m.adjectives) & lex.ORDINALS.keys() and low_at(c, j + 1) in ("the", "top", "bottom"):
        k = j + 2 if low_at(c, j + 1) == "the" else j + 1
        if low_at(c, j) == "from" and low_at(c, k) in lex.COUNTED_FROM:
            m.counted_from, j = low_at(c, k), k + 1  # "the second crate from the left"
    m.end = tokens[j - 1].end
    first_word = i + (1 if m.determiner and low_at(c, i) == m.determiner else 0)
    label_start = tokens[min(first_word, j - 1)].start
    m.text = c.text[label_start : m.end]
    if (noun is not None and m.pattern is not None) or m.vague:
        m.text = c.text[phrase_start : m.end]
    # possessive: "ball A's speed"
    if low_at(c, j) == "'s" or (
        token_at(c, j) is not None and tokens[j].text in ("'", "’") and m.plural
    ):
        size = len(c.elements)
        inner = c.noun_phrase(j + 1)
        if inner is not None:
            owned = c.elements.pop()
            assert isinstance(owned, Mention) and len(c.elements) == size
            owned.possessor = m
            owned.start = m.start
            owned.determiner = owned.determiner or "the"
            c.elements.append(owned)
            return inner
        if low_at(c, j) == "'s" and verb_readings(low_at(c, j + 1)):
            pass
    c.elements.append(m)
    return j
