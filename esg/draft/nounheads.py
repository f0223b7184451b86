"""Heads of noun phrases: the noun itself, what belongs to it, and individual letters."""

from __future__ import annotations

from esg.draft import lexicon as lex
from esg.draft.elements import Mention
from esg.draft.entities import BODY_PARTS, COUNTED_FROM, ORDINALS, STACKED
from esg.draft.rowphrases import RowPhrases
from esg.draft.verbphrases import verb_readings

_PIECES = frozenset({"roll", "piece", "slice", "sheet", "lump", "chunk", "coil", "reel", "spool"})
_RUNNING_GEAR = frozenset({"wheels", "castors", "casters", "rollers", "rails", "skates", "runners"})


_SINGULAR = frozenset({"a", "an", "another", "each", "every", "this", "that"})
_MOSTLY_NOUNS = frozenset(
    {"cannon", "hammer", "hook", "bank", "motor", "scoop", "jet", "paddle", "sandwich", "spiral",
     "loop", "stream", "lance", "drum"}
)  # fmt: skip
"""Words that are verbs only with an ending, or where nothing else can be one."""
_WAYS = frozenset(
    {"left", "right", "into", "round", "open", "shut", "across", "sideways", "off", "down", "over",
     "away", "along", "out", "onto", "past"}
)  # fmt: skip
"""What follows a verb of motion rather than a plural."""
_VESSELS = frozenset({"tableware", "bottle", "box", "container", "barrel"})


class NounHeads(RowPhrases):
    """Reads the head of a noun phrase whose modifiers have been read."""

    def _head(self, i: int, j: int, m: Mention) -> int | None:
        tokens = self.tokens
        low = self._low(j)
        noun = self._match_noun(j) if j < len(tokens) else None
        if noun is not None and noun[3] == "corner" and self._low(j + 1) == "of":
            noun = None  # of a room or a table, not of the street
        if noun is not None and noun[3] == "path" and m.determiner and self._low(j + 1) == "of":
            noun = None  # "into the path of a tram": no footpath
        if noun is not None and m.determiner in ("both", "all") and self._many_do(j, m):
            noun = None  # "and both slide into a bale"
        phrase_start = tokens[j].start if j < len(tokens) else m.end
        if noun is not None:
            entry, n, plural, phrase = noun
            # an adjective that is also a noun ends a compound ("steel ball", "office desk")
            k = j + n
            first = j
            while True:
                following = self._match_noun(k) if k < len(tokens) else None
                if following is None or plural or self._low(k) in lex.ADVERBS:
                    break
                readings = verb_readings(self._low(k))
                if self._let_do(k, readings):
                    break  # "make a ball bowl over a pin"
                acts = self._low(k + 1) in lex.DETERMINERS | lex.PRONOUNS
                if following[2] and (m.determiner in _SINGULAR or (readings and acts)):
                    break  # "a door swings shut", "a cyclist signals": no plural after "a"
                swings = following[2] and not plural and any(r.form == "s" for r in readings)
                if swings and self._low(k + 1) in _WAYS:
                    break  # "the quad bike swings left"
                named = following[0].kind in _VESSELS or self._low(k) in _MOSTLY_NOUNS
                vessel = m.determiner and named and self._ends_phrase(k)
                if readings and following[1] == 1 and not (vessel or self._compound_noun(k, m)):
                    break
                modifier = " ".join(t.low for t in tokens[first:k])
                m.adjectives.extend(modifier.split())
                entry, n, plural, phrase = following
                first = k
                k += n
            j = first
            m.noun, m.head, m.plural = entry, phrase, plural or m.plural
            k += self._piled(k, m)
            following_qty = self._tok(k + 1)
            if phrase in ("weight", "mass") and (
                (
                    self._low(k) in ("of", "is")
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
                self._low(j) == "of"
                and self._low(j + 1) in lex.SUBSTANCES
                and self._match_noun(j + 1) is None
            ):
                m.adjectives.append(self._low(j + 1))
                j += 2
            if self._low(j) == "on" and self._low(j + 1) in _RUNNING_GEAR:
                m.adjectives.append("wheeled")  # "an armchair on wheels": no objects of their own
                j += 2
            if self._low(j) in ("behind", "following") and self._low(j + 1) in (
                "it",
                "him",
                "her",
                "them",
            ):
                m.adjectives.append("rear")
                j += 2
            elif (
                self._low(j) == "behind"
                and m.determiner == "the"
                and (
                    verb_readings(self._low(j + 1))
                    or self._tok(j + 1) is None
                    or self.tokens[j + 1].kind == "punct"
                )
            ):
                m.adjectives.append("rear")
                j += 1
            elif (
                self._low(j) == "in"
                and self._low(j + 1) == "front"
                and m.determiner == "the"
                and (self._low(j + 2) != "of" or self._low(j + 3) in ("it", "him", "her", "them"))
            ):
                m.adjectives.append("front")
                j += 4 if self._low(j + 2) == "of" else 2
            on_top = 2 if self._low(j + 1) == "top" else 3 if self._low(j + 2) == "top" else 0
            if (
                on_top
                and self._low(j) in ("on", "at")
                and self._low(j + 1) in ("top", "the")
                and m.determiner == "the"
                and not plural
                and (
                    self._low(j + on_top) != "of"
                    or self._low(j + on_top + 2) in ("stack", "pile", "tower", "heap")
                )
            ):
                m.adjectives.append("top")  # "the crate on top falls off"
                j += on_top
            if (
                set(m.adjectives) & STACKED.keys()
                and self._low(j) == "of"
                and self._low(j + 1) in ("the", "a", "this", "that")
                and self._low(j + 2) in ("stack", "pile", "tower", "heap")
                and self._low(j + 3) != "of"
            ):
                m.stacked = True
                j += 3
            if (m.role or m.head == "net") and self._low(j) == "of":
                size = len(self.elements)
                inner = self._noun_phrase(j + 1)
                if inner is not None:
                    owner = self.elements.pop()
                    assert isinstance(owner, Mention) and len(self.elements) == size
                    owner.start = m.start
                    self.elements.append(owner)
                    return inner
            # unknown nouns after a known modifier: "car horn"
            token = self._tok(j)
            if (
                token is not None
                and token.kind == "word"
                and token.tag in ("NOUN", "PROPN")
                and not (self._looks_like_verb(j, m) or self._numbers(j))
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
            j = self._the_rest(j, m)
        elif low in _PIECES and self._low(j + 1) == "of" and (inner := self._inner(j + 2, m)):
            return inner
        elif low in BODY_PARTS and (
            self._low(i - 1) == "'s" or m.determiner in ("his", "her", "its", "their")
        ):
            m.head = low
            m.attribute = False
            j += 1
        elif (
            low
            and (low in lex.PARTS or lex.singular(low)[0] in lex.PARTS)
            and (m.determiner or m.adjectives or self._low(j + 1) == "of")
            and not self._part_alone(j, m)
        ):
            after = self._match_noun(j + 1)
            if after is not None and not verb_readings(self._low(j + 1)):
                m.adjectives.append(low)  # "the head pin"
                return self._head(i, j + 1, m)
            m.part = lex.singular(low)[0]
            m.head = m.part
            m.attribute = True
            j += 1
            if m.part in ("edge", "side") and self._low(j) in ("length", "lengths"):
                m.part, m.head = "", "size"  # "with an edge length of 10 cm"
                j += 1
            if self._low(j) == "of":
                size = len(self.elements)
                inner = self._noun_phrase(j + 1)
                if inner is not None:
                    owner = self.elements.pop()
                    assert isinstance(owner, Mention) and len(self.elements) == size
                    owner.part = m.part
                    owner.adjectives = owner.adjectives
                    if m.adjectives:
                        owner.part = f"{' '.join(m.adjectives)} {m.part}"
                    owner.start = m.start
                    self.elements.append(owner)
                    return inner
        elif low == "stop" and self._waiting_place(i, j, m):
            m.noun, m.head = lex.nouns()["bus stop"], "stop"
            j += 1
        elif low and self._does_next(j, m):
            m.head, m.known = low, False  # "a steel hook is hit"
            j += 1
        elif (
            low
            and {low, lex.singular(low)[0]} & lex.ATTRIBUTES
            and not self._many_do(j, m)
            and not self._color_acts(j, m)
            and not self._one_does(j, m)
            and (m.determiner or m.adjectives or m.count is not None or self._is_attribute_start(j))
        ):
            after = self._match_noun(j + 1)
            acts = verb_readings(self._low(j + 1)) and not self._noun_not_verb(j + 1, m)
            if after is not None and self._names_it(m, low) and not acts:
                m.adjectives.append(low)  # "the space station", "a storm lantern"
                return self._head(i, j + 1, m)
            if self._names_it(m, low) and self._plain_noun(j + 1):
                m.adjectives.append(low)  # "a weather vane"
                return self._head(i, j + 1, m)
            m.attribute = True
            m.head = low if low in lex.ATTRIBUTES else lex.singular(low)[0]
            j += 1
            if self._low(j) in ("speed", "velocity", "distance", "height"):
                m.head = self._low(j)
                j += 1
        elif (
            low in lex.PRONOUNS
            and not m.adjectives
            and (low not in ("that", "this", "one", "both") or self._pronoun_here(j))
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
            and not (m.determiner == "another" and self._unknown_noun(j))
        ):
            m.pronoun = m.determiner
            if m.determiner in ("his", "her", "my", "our", "your", "its", "their"):
                return None
        elif (
            not (m.determiner == "another" and self._unknown_noun(j))
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
            if low == "one" and picked and self._low(j) == "of":
                size = len(self.elements)
                inner = self._noun_phrase(j + 1)
                owner = self.elements[-1] if len(self.elements) == size + 1 else None
                if inner is not None and isinstance(owner, Mention) and (owner.count or 1) > 1:
                    owner.pick, owner.start = picked[-1], m.start  # "the blue one of three balls"
                    return inner
                del self.elements[size:]
        elif (
            m.adjectives
            and (m.determiner or self._bare_color(i, j, m))
            and (j >= len(tokens) or not self._unknown_noun(j))
        ):
            # "the other", "the second", "the black", "the last two"
            last = m.adjectives[-1]
            if not self._known_adjective(last) and not last.startswith("@"):
                m.adjectives.pop()  # the tagger took an unknown noun for an adjective
                m.head, m.plural = lex.singular(last)
                m.known = False
            else:
                m.pronoun = "one"
                if m.count and m.count > 1:
                    m.pronoun = "ones"
                if self._low(j) == "of" and m.pronoun == "one":
                    size = len(self.elements)
                    inner = self._noun_phrase(j + 1)
                    if inner is not None:
                        owner = self.elements.pop()
                        assert isinstance(owner, Mention) and len(self.elements) == size
                        owner.pick, owner.start = last, m.start
                        self.elements.append(owner)
                        return inner
        elif (
            low
            and self._unknown_noun(j)
            and (
                m.determiner
                or m.adjectives
                or m.count is not None
                or m.pattern
                or tokens[j].tag in ("NOUN", "PROPN")
                or self._named_before(j)
            )
        ):
            # unknown head, possibly a compound
            k = j
            while (
                k + 1 < len(tokens)
                and self._match_noun(k + 1) is None
                and self._unknown_noun(k + 1)
                and tokens[k + 1].tag in ("NOUN", "PROPN", "")
                and tokens[k].tag != ""
            ) or self._noun_then_verb(k + 1, m):
                m.adjectives.append(self._low(k))
                k += 1
            nxt = self._match_noun(k + 1) if k + 1 < len(tokens) else None
            clear = nxt is not None and (
                not verb_readings(self._low(k + 1)) or self._noun_not_verb(k + 1, m)
            )
            if clear and tokens[k].text != "'s":
                m.adjectives.append(self._low(k))
                return self._head(i, k + 1, m)
            m.head, m.plural = lex.singular(self._low(k))
            if k == j and self._is_name(j, m):
                m.head, m.plural, m.noun = self._low(k), False, lex.nouns()["person"]
            titled = k == j and k + 1 < len(tokens) and tokens[k + 1].text == ":"
            m.attribute = m.head in lex.ATTRIBUTES and not titled  # "Night has fallen."
            m.known = m.attribute or m.noun is not None
            j = k + 1
        elif m.count is not None and m.count != 0 and (j > i):
            if m.determiner in ("the", "this", "that") or j == i + 1:
                m.pronoun = "ones" if m.count > 1 else "one"
            else:
                return None
        elif self._like_a_verb(j, m):
            m.head, m.known = low, False
            j += 1
        else:
            return None
        j = self._member_of_row(j, m) or self._letters(j, m)
        if set(m.adjectives) & ORDINALS.keys() and self._low(j + 1) in ("the", "top", "bottom"):
            k = j + 2 if self._low(j + 1) == "the" else j + 1
            if self._low(j) == "from" and self._low(k) in COUNTED_FROM:
                m.counted_from, j = self._low(k), k + 1  # "the second crate from the left"
        m.end = tokens[j - 1].end
        first_word = i + (1 if m.determiner and self._low(i) == m.determiner else 0)
        label_start = tokens[min(first_word, j - 1)].start
        m.text = self.text[label_start : m.end]
        if (noun is not None and m.pattern is not None) or m.vague:
            m.text = self.text[phrase_start : m.end]
        # possessive: "ball A's speed"
        if self._low(j) == "'s" or (
            self._tok(j) is not None and tokens[j].text in ("'", "’") and m.plural
        ):
            size = len(self.elements)
            inner = self._noun_phrase(j + 1)
            if inner is not None:
                owned = self.elements.pop()
                assert isinstance(owned, Mention) and len(self.elements) == size
                owned.possessor = m
                owned.start = m.start
                owned.determiner = owned.determiner or "the"
                self.elements.append(owned)
                return inner
            if self._low(j) == "'s" and verb_readings(self._low(j + 1)):
                pass
        self.elements.append(m)
        return j
