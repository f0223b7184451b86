"""Verbs whose sense depends on what stands around them: "takes it out", "breaks off the cliff".

Phrases that follow a verb directly are tables of the syntax (`verbphrases`); what is read here
needs the verb's arguments.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from esg.draft import lexicon as lex
from esg.draft.grammar.clauses.contact_idioms import (
    ROUND,
    TRAVELLING,
    against,
    bats_off,
    breaks_it,
    buries,
    deflects,
    hits_ground,
    is_structural,
    is_thing,
    jams,
    kind_of,
    knocks_over,
    leaves_alone,
    not_avoided,
    pulled_over,
    shuts_on,
    steps_on,
    stumbles_over,
    takes_along,
    takes_out,
)
from esg.draft.grammar.clauses.frames import Frame, Phrase
from esg.draft.text.elements import Mention

_PARTING = lex.word_set("parting")
_JUMPING = lex.word_set("jumping")
_STEERED = TRAVELLING | frozenset({"watercraft", "flyer", "toyvehicle", ""})
_TOSSED = lex.word_set("tossed")
_LOOSE_GROUND = lex.word_set("loose ground")
_BENDS = lex.word_set("bends")
_ALONG_BENDS = lex.word_set("along bends")
_HELD = lex.word_set("held")
_STANDSTILLS = lex.word_set("standstills")


def _parts(f: Frame) -> str:
    """ "A rock breaks off the cliff": it falls from there."""
    if f.verb.lemma not in _PARTING or f.verb.sense not in ("noop", "own") or f.object is not None:
        return ""
    p = f.phrase("off")
    returns = "back" in f.adverbs  # "comes back off the cushion"
    return "fall" if p is not None and is_thing(p.mention) and not returns else ""


def _jumps_on(f: Frame) -> str:
    """ "jumps on the counter": onto it."""
    if f.verb.lemma in _JUMPING and f.verb.sense == "own":
        for p in f.phrases:
            if p.prep == "on" and is_thing(p.mention) and not (p.mention and p.mention.part):
                p.prep = "onto"
    return ""


def _lets_off(f: Frame) -> str:
    """ "A taxi drops off ...": passengers, who are not named."""
    idle = f.object is None and not any(p.mention is not None for p in f.phrases)
    off = f.verb.lemma == "drop" and "off" in f.adverbs and not f.verb.passive
    return "noop" if off and idle and kind_of(f.subject) == "vehicle" else ""


def _tosses(f: Frame) -> str:
    """ "A coin is flipped", "a girl flips a coin": thrown, not tipped over."""
    if f.verb.lemma != "flip" or f.verb.sense != "topple":
        return ""
    thing = f.subject if f.verb.passive else f.object
    if kind_of(thing) not in _TOSSED or {"over", "upside down"} & set(f.adverbs):
        return ""
    f.verb.note = "throw"
    return "launch"


def _comes_down(f: Frame) -> str:
    """ "The top box comes down": it falls, where what flies or drives arrives."""
    if f.verb.lemma not in ("come", "go") or f.verb.sense != "own" or f.object is not None:
        return ""
    bare = [p for p in f.phrases if p.prep == "down" and p.mention is None]  # "goes down 1 s in"
    if (f.adverbs[-1:] != ["down"] and not bare) or any(p.mention for p in f.phrases):
        return ""
    if not is_thing(f.subject) or kind_of(f.subject) in _STEERED - {""} | {"watercraft"}:
        return ""
    for p in bare:
        p.prep = ""
    upright = kind_of(f.subject) in ("pin", "domino") or (
        f.subject is not None and f.subject.noun is not None and "topples" in f.subject.noun.traits
    )
    return "topple" if upright and f.verb.lemma == "go" else "fall"


def _stands_still(f: Frame) -> str:
    """ "and stands still 3 s later": it has stopped."""
    stands = f.verb.sense == "posture" and f.verb.lemma in ("stand", "be", "sit")
    if not stands or "still" not in f.adverbs:
        return ""
    timed = any(p.amount is not None and p.amount.dimension == "time" for p in f.phrases)
    later = "later" in f.adverbs or any(p.prep in ("after", "within", "in") for p in f.phrases)
    return "stop" if timed and later else ""


def _brought_down(f: Frame) -> str:
    """ "The tower is brought down by a marble": it topples from a hit."""
    down = f.verb.lemma in ("bring", "take", "send", "fetch") and "down" in f.adverbs
    agent = f.phrase("by") if down and f.verb.passive else None
    if agent is None or not is_thing(agent.mention):
        return ""
    f.verb.extra = {**f.verb.extra, "transitive": "1", "contact": "1"}
    return "topple"


def _speed_changes(f: Frame) -> str:
    """ "Its speed drops to 4 m/s": it slows down."""
    m = f.subject
    if m is None or not m.attribute or m.head not in ("speed", "velocity", "pace"):
        return ""
    if not any(p.amount is not None and p.amount.dimension == "speed" for p in f.phrases):
        return ""
    falls = f.verb.lemma in ("drop", "fall", "decrease", "sink", "reduce", "decline", "go", "come")
    rises = f.verb.lemma in ("rise", "increase", "climb", "grow", "jump", "build")
    if not (falls or rises):
        return ""
    if m.possessor is not None:
        f.subject = m.possessor
    elif m.determiner in ("its", "his", "her", "their"):
        word = {"its": "it", "his": "he", "her": "she", "their": "they"}[m.determiner]
        f.subject = Mention(m.start, m.end, pronoun=word, text=word)
    else:
        return ""
    return "slow" if falls else "accelerate"


def _is_let_go(f: Frame) -> str:
    """ "A brick is let go": dropped."""
    return "drop" if f.verb.lemma == "let" and f.verb.passive and f.verb.sense == "noop" else ""


def _gets_there(f: Frame) -> str:
    """ "The girl gets there first": to where she was going."""
    there = f.verb.lemma == "get" and f.verb.sense == "noop" and "there" in f.adverbs
    return "reach" if there and f.object is None and not f.phrases else ""


def _ground_that_slides(f: Frame) -> str:
    """ "Snow slides off the roof": a heap of it, not the ground."""
    m = f.subject
    if m is None or m.head not in _LOOSE_GROUND or not is_structural(m):
        return ""
    off = f.phrase("off", "from", "onto", "down") is not None
    if f.verb.sense in ("slide", "fall") and off:
        m.noun, m.known = None, False
    return ""


def _dribbles(f: Frame) -> str:
    """ "A striker dribbles past a defender": a way that he goes, with a ball of his own."""
    runs = f.verb.lemma == "dribble" and f.verb.sense == "launch" and not f.verb.passive
    return "own" if runs and f.object is None and kind_of(f.subject) == "person" else ""


def _flies_over(f: Frame) -> str:
    """ "The ball goes over": no ball topples."""
    goes = f.verb.lemma == "go" and f.verb.sense == "topple" and f.object is None
    return "own" if goes and kind_of(f.subject) in ROUND else ""


def _swings_round(f: Frame) -> str:
    """ "The boom swings round": what hangs turns about its end, it does not change course."""
    turns = f.verb.sense == "turn" and f.verb.lemma in ("swing", "come")
    turns = turns and not set(f.verb.extra) - {"dir"}
    return "swing" if turns and f.subject is not None and kind_of(f.subject) not in _STEERED else ""


def _runs_onto_the_street(f: Frame) -> str:
    """ "A child runs into the street": onto it, which nothing hits."""
    m = f.object
    runs = f.verb.lemma == "run" and f.verb.sense == "hit" and not f.verb.passive
    if not runs or m is None or not is_structural(m) or f.verb.extra.get("motion") != "own":
        return ""
    f.object = None
    f.phrases.insert(0, Phrase("onto", m))
    return "own"


def _follows_a_bend(f: Frame) -> str:
    """ "goes around a curve to the left": a turn to the side that is told."""
    if f.verb.sense not in ("own", "roll", "fly") or f.object is not None:
        return ""
    bends = [
        p.mention
        for p in f.phrases
        if p.prep in _ALONG_BENDS and p.mention is not None and p.mention.head in _BENDS
    ]
    if not bends:
        return ""
    phrased = {p.mention.head for p in f.phrases if p.mention is not None}
    told = {*f.adverbs} | phrased
    told |= {a.removesuffix("-hand").removesuffix("hand") for m in bends for a in m.adjectives}
    sides = {"left", "right"} & told
    if len(sides) != 1 or not bends[0].attribute:
        return ""
    f.adverbs.extend(sides - {*f.adverbs} - phrased)
    return "turn"


def _to_a_stop(f: Frame) -> str:
    """ "slows down from 3 m/s to a stop": it stops."""
    to = f.phrase("to") if f.verb.sense in ("slow", "brake") else None
    if to is None or to.mention is None or to.mention.head not in _STANDSTILLS:
        return ""
    f.phrases.remove(to)
    f.verb.extra["via"] = "slow"
    return "stop"


def _lets_the_rope_go(f: Frame) -> str:
    """ "The skier lets go of the rope": nothing falls."""
    m = f.object
    held = m is not None and m.head in _HELD and f.verb.sense == "drop" and not f.verb.passive
    nothing = (
        m is None and f.verb.lemma == "let" and kind_of(f.subject) == "person" and not f.phrases
    )
    return "noop" if held or nothing else ""


def _from_one_to_the_next(f: Frame) -> str:
    """ "leaps from rock to rock": a way, no arrival."""
    start, end = f.phrase("from"), f.phrase("to")
    a, b = (p.mention if p is not None else None for p in (start, end))
    if a is not None and b is not None and a.head and a.head == b.head and not b.determiner:
        f.phrases = [p for p in f.phrases if p is not start and p is not end]
    return ""


def _steers(f: Frame) -> str:
    """ "Somebody steers the raft": no turn without a side."""
    if f.verb.lemma != "steer" or f.verb.sense != "turn" or f.object is None:
        return ""
    sides = {"left", "right", "round", "around", "away", "back", "clockwise"}
    named = {p.mention.head for p in f.phrases if p.mention is not None}
    return "" if sides & {*f.adverbs, *named} or "dir" in f.verb.extra else "own"


def _into_the_water(f: Frame) -> str:
    """ "comes down in the river": a descent that ends there."""
    down = f.verb.lemma == "come" and "down" in f.adverbs
    wet = f.phrase("in", "into") if down else None
    return "fall" if wet is not None and kind_of(wet.mention) == "water" else ""


_READINGS: tuple[Callable[[Frame], str], ...] = (
    takes_out, _parts, breaks_it, shuts_on, steps_on, _jumps_on, _lets_off, _tosses,
    hits_ground, buries, _swings_round, against, knocks_over,
    _comes_down, _brought_down, _speed_changes, _stands_still,
    bats_off, _is_let_go, _gets_there, deflects, _dribbles, _ground_that_slides,
    _flies_over, takes_along, pulled_over,
    not_avoided, leaves_alone, _runs_onto_the_street, _follows_a_bend,
    _to_a_stop, stumbles_over, _into_the_water,
    _lets_the_rope_go, jams, _from_one_to_the_next, _steers,
)  # fmt: skip


def read_idioms(frames: list[Frame]) -> None:
    """Gives verbs the sense that they have with their arguments.

    Args:
        frames: Frames of a prompt; their `verb.sense` and phrases may change.
    """
    for f in frames:
        for reading in _READINGS:
            sense = reading(f)
            if sense:
                f.verb.sense = sense
                break
    _slips(frames)
    _comes_back_off(frames)
    _falls_along(frames)


def _falls_along(frames: list[Frame]) -> None:
    """ "slides off the desk, taking a cup with it": the cup falls from there, too."""
    for before, f in pairwise(frames):
        along = f.phrase("with") if f.verb.lemma == "take" else None
        taken = along is not None and along.mention is not None and bool(along.mention.pronoun)
        leaves = before.verb.sense in ("fall", "slide", "roll", "drop")
        off = before.phrase("off", "from", "out of") if taken and leaves else None
        if off is None or f.object is None:
            continue
        f.subject, f.object, f.verb.sense = f.object, None, "fall"
        f.link, f.phrases = "then", [Phrase(off.prep, off.mention)]


def _comes_back_off(frames: list[Frame]) -> None:
    """ "hits the post and comes off it": it rebounds."""
    for before, f in pairwise(frames):
        off = f.verb.lemma == "come" and f.verb.extra.get("particle") == "off"
        same = before.subject is f.subject or (f.subject is not None and f.subject.pronoun == "it")
        if off and same and f.object is not None and before.verb.sense == "hit":
            f.verb.sense = "noop"


def _slips(frames: list[Frame]) -> None:
    """ "steps on it and slips": who slips and does nothing more falls."""
    for k, f in enumerate(frames):
        if f.verb.lemma != "slip" or f.verb.sense != "slide" or f.object is not None:
            continue
        alone = not f.phrases and not f.adverbs and kind_of(f.subject) == "person"
        if alone and not any(g.subject is f.subject for g in frames[k + 1 :]):
            f.verb.sense = "topple"
