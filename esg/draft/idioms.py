"""Verbs whose sense depends on what stands around them: "takes it out", "breaks off the cliff".

Phrases that follow a verb directly are tables of the syntax (`verbphrases`); what is read here
needs the verb's arguments.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise

from esg.draft.elements import Mention
from esg.draft.frames import Frame, Phrase

_PARTING = frozenset({"break", "snap", "crack", "chip", "split", "tear", "come", "peel", "wobble"})
_BREAKING = frozenset({"break", "shatter", "crack", "splinter", "burst", "smash"})
_SHUTTING = frozenset({"close", "shut", "snap", "slam"})
_STEPPING = frozenset({"step", "tread", "sit", "stamp"})
_JUMPING = frozenset({"jump", "leap", "hop", "spring", "climb", "dive"})
_TRAVELLING = frozenset({"person", "vehicle", "animal", "robot", "cart"})
_STEERED = _TRAVELLING | frozenset({"watercraft", "flyer", "toyvehicle", ""})
_ROUND = frozenset({"ball", "billiard", "sliding", "projectile"})
_BATTING = frozenset({"bat", "swipe", "whisk", "poke", "paw"})
_TOSSED = frozenset({"game", "tableware", "food", "ball", "billiard", "projectile", "electronics"})
_LOOSE_GROUND = frozenset({"snow", "sand", "gravel", "earth", "soil", "mud", "rubble"})
_BENDS = frozenset({"curve", "bend", "corner"})
_ALONG_BENDS = frozenset({"around", "round", "through", "along"})
_HELD = frozenset(
    {"rope", "line", "reins", "rein", "handle", "handlebar", "leash", "lead", "wheel", "string"}
)
_STANDSTILLS = frozenset({"stop", "halt", "standstill", "rest"})
_SURFACES = frozenset({"patch", "slick", "spot", "stretch"})
"""What a vehicle hits and drives over."""


def _kind(m: Mention | None) -> str:
    return m.noun.kind if m is not None and m.noun is not None else ""


def _structural(m: Mention | None) -> bool:
    return m is not None and m.noun is not None and "structural" in m.noun.traits


def _thing(m: Mention | None) -> bool:
    """Whether a phrase names something solid, pronouns included."""
    return m is not None and not m.attribute and not _structural(m) and bool(m.head or m.pronoun)


def _takes_out(f: Frame) -> str:
    """ "The second ball takes it out", "takes out the yellow one": a hit."""
    if f.verb.lemma != "take" or _kind(f.subject) == "person" or f.verb.sense != "noop":
        return ""
    out = f.phrase("out")
    if f.object is None and out is not None:
        f.object = out.mention
        f.phrases.remove(out)
        return "hit"
    return "hit" if "out" in f.adverbs and _thing(f.object) else ""


def _parts(f: Frame) -> str:
    """ "A rock breaks off the cliff": it falls from there."""
    if f.verb.lemma not in _PARTING or f.verb.sense not in ("noop", "own") or f.object is not None:
        return ""
    p = f.phrase("off")
    returns = "back" in f.adverbs  # "comes back off the cushion"
    return "fall" if p is not None and _thing(p.mention) and not returns else ""


def _breaks_it(f: Frame) -> str:
    """ "The stone breaks a pane": nobody breaks it, something moving does."""
    if f.verb.lemma not in _BREAKING or f.verb.sense != "noop" or f.verb.passive:
        return ""
    if f.verb.infinitive:
        return ""  # "throws a stone to break a window"
    moving = _thing(f.subject) and _kind(f.subject) not in ("person", "")
    pronoun = f.subject is not None and f.subject.pronoun == "it"
    return "hit" if (moving or pronoun) and _thing(f.object) and f.object is not None else ""


def _shuts_on(f: Frame) -> str:
    """ "The doors shut on a suitcase"."""
    p = f.phrase("on")
    if f.verb.lemma in _SHUTTING and f.verb.sense == "noop" and p is not None and _thing(p.mention):
        p.prep = "against"
        return "hit"
    return ""


def _steps_on(f: Frame) -> str:
    """ "steps on a rake" is a contact, "steps onto the road" a motion."""
    if f.verb.lemma not in _STEPPING or f.verb.sense not in ("noop", "own"):
        return ""
    p = f.phrase("on", "onto")
    return "hit" if p is not None and _thing(p.mention) else "own"


def _jumps_on(f: Frame) -> str:
    """ "jumps on the counter": onto it."""
    if f.verb.lemma in _JUMPING and f.verb.sense == "own":
        for p in f.phrases:
            if p.prep == "on" and _thing(p.mention) and not (p.mention and p.mention.part):
                p.prep = "onto"
    return ""


def _lets_off(f: Frame) -> str:
    """ "A taxi drops off ...": passengers, who are not named."""
    idle = f.object is None and not any(p.mention is not None for p in f.phrases)
    off = f.verb.lemma == "drop" and "off" in f.adverbs and not f.verb.passive
    return "noop" if off and idle and _kind(f.subject) == "vehicle" else ""


def _tosses(f: Frame) -> str:
    """ "A coin is flipped", "a girl flips a coin": thrown, not tipped over."""
    if f.verb.lemma != "flip" or f.verb.sense != "topple":
        return ""
    thing = f.subject if f.verb.passive else f.object
    if _kind(thing) not in _TOSSED or {"over", "upside down"} & set(f.adverbs):
        return ""
    f.verb.note = "throw"
    return "launch"


def _hits_ground(f: Frame) -> str:
    """ "hits a patch of ice": a surface that it drives over."""
    if f.verb.sense != "hit" or f.verb.passive or f.object is None:
        return ""
    flat = f.object.head.split()[-1:] and f.object.head.split()[-1] in _SURFACES
    return "own" if flat and _kind(f.subject) in _TRAVELLING else ""


def _against(f: Frame) -> str:
    """ "gets wedged against the sofa", "is dashed onto the rocks": it hits what it is against."""
    if f.verb.sense not in ("hit", "knock") or not f.verb.passive or f.phrase("by") is not None:
        return ""
    below = f.phrase("under", "beneath", "underneath")
    if below is not None and f.verb.sense == "hit" and _thing(below.mention):
        below.prep = "by"  # "is crushed under the wheels of a lorry"
        return "hit"
    met = f.phrase("against", "into", "onto")
    if met is None or not _thing(met.mention) or f.object is not None:
        return ""
    if met.prep != "against" and _kind(f.subject) in _ROUND:
        return ""  # "is hit into the pocket"
    f.verb.passive = False
    return "hit"


def _knocks_over(f: Frame) -> str:
    """ "whacks it over", "bowls a bottle over", "takes the mast down": it topples."""
    if (
        f.verb.sense not in ("hit", "launch", "tow", "noop")
        or f.verb.passive
        or not _thing(f.object)
    ):
        return ""
    moves = f.verb.sense == "noop" and f.verb.lemma not in ("take", "bring", "pull")
    if moves or "over" not in f.verb.extra or _kind(f.object) in _ROUND:
        return ""
    f.verb.extra = {**f.verb.extra, "transitive": "1", "contact": "1"}
    return "topple"


def _bats_off(f: Frame) -> str:
    """ "A cat bats a pen off the desk": a blow, not a throw."""
    if f.verb.lemma not in _BATTING or f.verb.sense != "launch" or f.verb.passive:
        return ""
    off = f.phrase("off", "from", "out of") is not None or "off" in f.adverbs
    return "knock" if off and _thing(f.object) and _thing(f.subject) else ""


def _pulled_over(f: Frame) -> str:
    """ "The bookcase gets pulled over by a toddler": it topples, where a car would stop."""
    if f.verb.lemma != "pull" or f.verb.sense != "stop" or not f.verb.passive:
        return ""
    return "topple" if _kind(f.subject) not in ("vehicle", "person", "") else ""


def _not_avoided(f: Frame) -> str:
    """ "cannot avoid the bus", "fails to miss it": hits it."""
    if f.verb.sense not in ("avoid", "miss") or not f.verb.negated or not _thing(f.object):
        return ""
    if f.verb.lemma not in ("avoid", "miss", "dodge", "evade"):
        return ""
    f.verb.negated, f.verb.modal = False, ""
    return "hit"


def _leaves_alone(f: Frame) -> str:
    """ "leaves the pin untouched": misses it."""
    if f.verb.lemma != "leave":
        return ""
    alone = {"untouched", "unscathed", "unharmed", "undisturbed"} & set(f.adverbs)
    return "miss" if alone and _thing(f.object) else ""


def _comes_down(f: Frame) -> str:
    """ "The top box comes down": it falls, where what flies or drives arrives."""
    if f.verb.lemma not in ("come", "go") or f.verb.sense != "own" or f.object is not None:
        return ""
    bare = [p for p in f.phrases if p.prep == "down" and p.mention is None]  # "goes down 1 s in"
    if (f.adverbs[-1:] != ["down"] and not bare) or any(p.mention for p in f.phrases):
        return ""
    if not _thing(f.subject) or _kind(f.subject) in _STEERED - {""} | {"watercraft"}:
        return ""
    for p in bare:
        p.prep = ""
    upright = _kind(f.subject) in ("pin", "domino") or (
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
    if agent is None or not _thing(agent.mention):
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


def _takes_along(f: Frame) -> str:
    """ "topples and takes a lamp with it": it hits the lamp."""
    own = f.phrase("with") if f.verb.lemma == "take" else None
    along = own is not None and own.mention is not None and own.mention.pronoun in ("it", "them")
    return "hit" if along and _thing(f.object) else ""


def _gets_there(f: Frame) -> str:
    """ "The girl gets there first": to where she was going."""
    there = f.verb.lemma == "get" and f.verb.sense == "noop" and "there" in f.adverbs
    return "reach" if there and f.object is None and not f.phrases else ""


def _ground_that_slides(f: Frame) -> str:
    """ "Snow slides off the roof": a heap of it, not the ground."""
    m = f.subject
    if m is None or m.head not in _LOOSE_GROUND or not _structural(m):
        return ""
    off = f.phrase("off", "from", "onto", "down") is not None
    if f.verb.sense in ("slide", "fall") and off:
        m.noun, m.known = None, False
    return ""


def _deflects(f: Frame) -> str:
    """ "A defender deflects it with his arm": it hits him."""
    deflects = f.verb.lemma == "deflect" and f.verb.sense == "bounce" and not f.verb.passive
    return "hit" if deflects and _thing(f.object) else ""


def _dribbles(f: Frame) -> str:
    """ "A striker dribbles past a defender": a way that he goes, with a ball of his own."""
    runs = f.verb.lemma == "dribble" and f.verb.sense == "launch" and not f.verb.passive
    return "own" if runs and f.object is None and _kind(f.subject) == "person" else ""


def _flies_over(f: Frame) -> str:
    """ "The ball goes over": no ball topples."""
    goes = f.verb.lemma == "go" and f.verb.sense == "topple" and f.object is None
    return "own" if goes and _kind(f.subject) in _ROUND else ""


def _buries(f: Frame) -> str:
    """ "A plough buries a bicycle": under what it moves, not by a hit."""
    buries = f.verb.lemma == "bury" and f.verb.sense == "hit" and not f.verb.extra
    slides = f.subject is not None and f.subject.head in ("snow", "sand", "mud", "rubble", "debris")
    buries = buries and not slides
    return "noop" if buries and _kind(f.subject) in ("vehicle", "person", "animal") else ""


def _swings_round(f: Frame) -> str:
    """ "The boom swings round": what hangs turns about its end, it does not change course."""
    turns = f.verb.sense == "turn" and f.verb.lemma in ("swing", "come")
    turns = turns and not set(f.verb.extra) - {"dir"}
    return "swing" if turns and f.subject is not None and _kind(f.subject) not in _STEERED else ""


def _runs_onto_the_street(f: Frame) -> str:
    """ "A child runs into the street": onto it, which nothing hits."""
    m = f.object
    runs = f.verb.lemma == "run" and f.verb.sense == "hit" and not f.verb.passive
    if not runs or m is None or not _structural(m) or f.verb.extra.get("motion") != "own":
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


def _stumbles_over(f: Frame) -> str:
    """ "stumbles over a stool into a waiter": it touches both."""
    over = f.phrase("over") if f.verb.lemma == "stumble" else None
    return "hit" if over is not None and _thing(over.mention) else ""


def _lets_the_rope_go(f: Frame) -> str:
    """ "The skier lets go of the rope": nothing falls."""
    m = f.object
    held = m is not None and m.head in _HELD and f.verb.sense == "drop" and not f.verb.passive
    nothing = m is None and f.verb.lemma == "let" and _kind(f.subject) == "person" and not f.phrases
    return "noop" if held or nothing else ""


def _jams(f: Frame) -> str:
    """ "The cable jams": nothing is hit."""
    met = f.object is not None or any(p.mention is not None for p in f.phrases)
    alone = f.verb.lemma in ("jam", "stick", "snag") and f.verb.sense == "hit"
    return "noop" if alone and not met and not f.verb.passive else ""


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
    return "fall" if wet is not None and _kind(wet.mention) == "water" else ""


_READINGS: tuple[Callable[[Frame], str], ...] = (
    _takes_out, _parts, _breaks_it, _shuts_on, _steps_on, _jumps_on, _lets_off, _tosses,
    _hits_ground, _buries, _swings_round, _against, _knocks_over,
    _comes_down, _brought_down, _speed_changes, _stands_still,
    _bats_off, _is_let_go, _gets_there, _deflects, _dribbles, _ground_that_slides,
    _flies_over, _takes_along, _pulled_over,
    _not_avoided, _leaves_alone, _runs_onto_the_street, _follows_a_bend,
    _to_a_stop, _stumbles_over, _into_the_water,
    _lets_the_rope_go, _jams, _from_one_to_the_next, _steers,
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
        alone = not f.phrases and not f.adverbs and _kind(f.subject) == "person"
        if alone and not any(g.subject is f.subject for g in frames[k + 1 :]):
            f.verb.sense = "topple"
