"""Noun phrases that name no thing where they stand: scenes, places, instruments, the camera."""

from __future__ import annotations

from collections.abc import Callable

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.matching import same_kind
from esg.draft.discourse.referents.record import World
from esg.draft.text.elements import Mention
from esg.lexicon.hypernyms import hypernyms
from esg.lexicon.senses import no_things

_SCENES = lex.word_set("scenes")
_DURING = lex.word_set("during")
_WHERE = lex.word_set("where things are")
_WITH = lex.word_set("with a part of the body")
_FILMING = lex.word_set("filming")
_MONTHS, _SEASONS = lex.word_set("months"), lex.word_set("seasons")
_TO_PIECES = lex.word_set("to pieces")
_SHARDS = frozenset({"bit", "fragment", "piece", "shard", "smithereen", "splinter"})
_PICTURE, _THE_PICTURE = ("frame", "screen"), ("", "the")
_ACROSS = ("across", "of", "off", "on")
_ACTING_PARTS = lex.word_set("acting parts")
_RUN = lex.OWN_PARTS - {"door", "leg", "roof"}
_HAVE_PARTS = frozenset({"vehicle", "cart", "flyer", "toyvehicle"})
_SHARES = frozenset({"half", "third", "quarter"})
_RIMS = frozenset({"rim", "brim", "lip"})
_GAPS = frozenset({"gap", "opening", "space"})
_GO_INTO_GAPS = frozenset({"vehicle", "person", "animal", "cart", "toyvehicle"})
_STOOD_ON = frozenset({"wheel", "leg", "foot", "paw", "hoof"})
_MOTIONS = lex.word_set("own motions")
_LANES = lex.word_set("lanes of a road")
_UNSEEN = lex.word_set("unseen light and weather") | lex.word_set("unseen fluids")


def names_nothing(world: World, m: Mention, subject: bool) -> bool:
    """Whether a phrase names no thing here, though its noun may elsewhere.

    Args:
        world: What has been named so far.
        m: The noun phrase.
        subject: Whether it is a grammatical subject.
    """
    if _lane_of_a_road(m) or _fills_a_pond(world, m):
        return True
    if any(same_kind(m, e) for e in world.entities.values()):
        return False
    return any(test(world, m, subject) for test in _TESTS)


def _fills_a_pond(world: World, m: Mention) -> bool:
    """ "A pond filled with water": no second water."""
    bare = m.head == "water" and not m.determiner and m.after_prep in ("with", "of")
    return bare and any(e.noun.kind == "water" for e in world.entities.values())


def _lane_of_a_road(m: Mention) -> bool:
    """ "Changes to the left lane", "drives in its lane": part of the road, and no second one."""
    part = m.head == "lane" and m.noun is not None and m.noun.name == "road"
    return part and (m.determiner in lex.POSSESSIVES or bool(_LANES & {*m.adjectives}))


def _cushion(world: World, m: Mention, subject: bool) -> bool:
    """Of a billiard table."""
    return world.billiards and m.head in ("cushion", "rail")


def _scene(world: World, m: Mention, subject: bool) -> bool:
    """ "in a depot", "over a valley", "along a hallway"."""
    if m.noun is not None or not m.after_prep or m.part:
        return False  # "over the edge of a quarry"
    place = no_things().get(m.head) == "place"
    return (m.head in _SCENES and m.after_prep in _DURING) or (place and m.after_prep in _WHERE)


_LOADED = lex.word_set("load beds")
"""Words of names of vehicles that carry loads on a bed."""


def _with_a_part(world: World, m: Mention, subject: bool) -> bool:
    """ "with one hand", "in its mouth", "wags its tail", "both arms": a part of who acts."""
    part = m.head in lex.BODY_PARTS or (m.noun is None and no_things().get(m.head) == "body")
    bare = m.plural and not m.determiner and m.count is None  # "shake hands"
    whose = m.determiner in lex.POSSESSIVES or m.determiner == "both" or bare
    own = m.after_prep in _WITH or (whose and not subject)
    return part and own and m.possessor is None


def _formation(world: World, m: Mention, subject: bool) -> bool:
    """ "in a queue"."""
    if m.after_prep not in ("in", "into") or m.head not in lex.ARRANGEMENTS or m.group_word:
        return False
    if m.determiner not in ("", "a", "an", "one") or m.plural or m.letters:
        return False
    last = world.salience[-1] if world.salience else []
    return len(last) > 1 or m.head in lex.SHAPES_OF_GROUPS


def _who_films(world: World, m: Mention, subject: bool) -> bool:
    """ "shot with a static camera", "towards the camera", "static camera", "out of the frame"."""
    if m.head in ("camera", "viewer"):
        bare = not (m.determiner or m.plural or m.count or m.letters or m.possessor)
        return m.after_prep in _FILMING or bare
    if m.head == "screen" and not (m.part or m.after_prep in _ACROSS):
        return False
    return m.head in _PICTURE and m.determiner in _THE_PICTURE and not m.adjectives


def _pieces(world: World, m: Mention, subject: bool) -> bool:
    """ "smashes it into pieces", "cut in half", "shatters, with fragments flying about"."""
    if m.head in _TO_PIECES and m.after_prep in ("in", "into", "to") and not m.determiner:
        return True
    bare = not (m.determiner or m.plural or m.count or m.adjectives)
    if world.breaking and bare and m.after_prep == "of" and m.head in lex.MATERIALS:
        return bool(world.entities)  # "sending pieces of glass across the floor"
    several = m.plural and m.count is None and not m.adjectives and not m.group_word
    return several and m.head in _SHARDS and world.breaking and bool(world.entities)


def _running_water(world: World, m: Mention, subject: bool) -> bool:
    """ "Water drips from a tap", "filled with water": no pool of it."""
    bare = m.head == "water" and not m.determiner
    return bare and (subject or m.after_prep in ("of", "off", "with"))


def _date(world: World, m: Mention, subject: bool) -> bool:
    """ "12 december 2019", "in the spring of 1999": a time and no number of things."""
    year = m.count is not None and 1900 <= m.count < 2100 and not m.plural
    season = m.head in _SEASONS and m.after_prep in ("in", "during", "of") and not m.adjectives
    return year or m.head in _MONTHS or season


def _of_a_machine(world: World, m: Mention, subject: bool) -> bool:
    """ "Raises its forks": what who acts has, and is no thing of its own."""
    own = m.head in _ACTING_PARTS and m.determiner == "its" and not subject
    return own and (not m.after_prep or m.plural)  # "slips off its forks"


def _its_parts(world: World, m: Mention, subject: bool) -> bool:
    """ "A car brakes, tires screeching": the parts of what is named, drawn with it."""
    whose = m.determiner in ("", "the", "its", "their")
    all_of_them = m.plural and m.count is None and not m.group_word and m.possessor is None
    has = m.after_prep == "with" and not m.plural and m.determiner in ("a", "an", "one")
    wholes = {e.noun.kind for e in world.entities.values()}
    has = has and m.noun is None  # "a truck with a broken headlight"
    return ((whose and all_of_them) or has) and m.head in _RUN and bool(wholes & _HAVE_PARTS)


def _load_bed(world: World, m: Mention, subject: bool) -> bool:
    """ "Three logs in its bed", "the truck bed": where a truck that was named has its load."""
    wholes = {w for e in world.entities.values() for w in e.noun.name.split()}
    return m.head == "bed" and m.determiner in ("", "the", "its") and bool(wholes & _LOADED)


def _share(world: World, m: Mention, subject: bool) -> bool:
    """ "One half drops": what something was cut into is no thing of its own."""
    return m.noun is None and m.head in _SHARES and not m.part


def _opening(world: World, m: Mention, subject: bool) -> bool:
    """ "Backs into a gap", "slips through an opening": where nothing stands."""
    movers = [world.entities[i] for i in world.movers if i in world.entities]
    goes = any(e.noun.kind in _GO_INTO_GAPS for e in movers)
    at = m.after_prep in ("in", "into", "through") or (not m.after_prep and m.determiner == "a")
    return m.head in _GAPS and goes and at and not subject


def _rim_of_a_vessel(world: World, m: Mention, subject: bool) -> bool:
    """ "Fills the glass to the rim": no hoop."""
    vessel = any("container" in e.noun.traits for e in world.entities.values())
    return m.head in _RIMS and m.determiner in ("the", "its", "each") and vessel and not subject


def _unseen(world: World, m: Mention, subject: bool) -> bool:
    """ "Clouds move", "rides a wave": light, weather and water, which are no bodies."""
    return m.noun is None and {m.head, m.head + "s"} <= _UNSEEN


def _stands_on(world: World, m: Mention, subject: bool) -> bool:
    """ "Tips onto two wheels", "hops on one leg": as many of its own as are named."""
    few = m.count is not None and m.count <= 3 and m.after_prep in ("on", "onto")
    return few and m.head in _STOOD_ON and not (m.determiner or m.adjectives or m.group_word)


def _own_motion(world: World, m: Mention, subject: bool) -> bool:
    """ "Stops at the top of its swing": what it does, and no swing to sit on."""
    return m.determiner in lex.POSSESSIVES and m.head in _MOTIONS and bool(m.after_prep)


_WITH_STUFF = frozenset({"amid", "at", "for", "in", "of", "with", "without"})
"""Prepositions after which a bare noun that nobody knows is a place, a stuff or a quality."""


def _place_name(world: World, m: Mention, subject: bool) -> bool:
    """ "at cambodia", "in Los Angeles", "with sustenance": nouns that nobody knows."""
    words = m.text.split()
    named = m.noun is None or (m.noun.name == "person" and m.head != "person")
    capital = named and not m.determiner and all(w[:1].isupper() for w in words)
    if capital and words and m.after_prep in ("in", "at", "of"):
        return True
    bare = not (m.determiner or m.plural or m.adjectives or m.count or m.letters or m.amounts)
    named = bare and m.noun is None and m.head not in hypernyms()
    return named and m.after_prep in _WITH_STUFF and m.possessor is None


_TESTS: tuple[Callable[[World, Mention, bool], bool], ...] = (
    _cushion,
    _scene,
    _with_a_part,
    _formation,
    _who_films,
    _pieces,
    _running_water,
    _date,
    _of_a_machine,
    _opening,
    _rim_of_a_vessel,
    _unseen,
    _its_parts,
    _load_bed,
    _share,
    _own_motion,
    _stands_on,
    _place_name,
)


def without(m: Mention, text: str) -> bool:
    """ "Without a driver": nothing of the kind is there; "without wheels" is about a part."""
    told = text[: m.start].lower().endswith("without ")
    word = lex.singular(m.head)[0]
    part = word in lex.PARTS | lex.OWN_PARTS or (m.noun is not None and m.noun.kind == "part")
    return told and not part and m.noun is not None and m.determiner in ("", "a", "an", "any")
