"""Jointed things: what a prompt names becomes one part, the part that it is joined to is added.

Which things, of what parts and how they move is `esg/lexicon/articulations.csv`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
import math
import re

from esg.draft import lexicon as lex
from esg.draft.discourse.jointed import articulation_of, behind_doors, is_flap, of_a_house
from esg.draft.discourse.referents.entities import Entity, head_of
from esg.draft.discourse.referents.parts import parts_of
from esg.draft.discourse.referents.registry import add_entity
from esg.draft.discourse.referents.sizes import dimensions_of
from esg.draft.discourse.scene import Relation, Scene
from esg.draft.document.riding import seat
from esg.graph.models import EdgeEvent, Joint, NodeEvent
from esg.lexicon.articulations import Articulation
from esg.units import GRAVITY_MPS2

_OPEN = {"open": 1.0, "opened": 1.0, "wide-open": 1.0, "half-open": 0.5, "ajar": 0.25}
"""Share of how far a thing opens at which it starts, by what it is called."""

_SHUT = frozenset({"closed", "shut"})
STANDS_OPEN = _SHUT | {*_OPEN}
"""Words of how far a door or a lid is open."""

GIVES_WAY_MPS = 1e-3
"""Change of speed that a snapped rope still bears: far less than gravity's in a step."""
JOLT_MPS = 0.3
"""A change of speed within a step after which what sits on a seesaw is held by its weight alone."""
SAG_M = 0.15
"""What hangs on a spring stretches it so far: it bobs in 0.8 s."""
ROPE_CM = (60.0, 300.0)
"""Ropes by which things hang that have no row of their own: as long as they are high."""
_HOOK = 0.96
"""Height of the hook of a crane over its own (`demolition_crane`)."""
LOWERED, ARM_CM = 0.6, 20.0
"""A post is lowered to this share of its height at most, so that arms are met so far below the top
of what runs into them."""
SWUNG_BY, LEAST_SHARE = 20.0, 0.1
"""What a blow is to set swinging has at most so many times the mass of what strikes it (at 10 m/s
it rises by 2 cm then), and at least this share of its own."""
BREAKS_BY = 0.7
"""Share of its momentum that what swings gives surely to what it is to break."""
SQUEEZED_BY_MPS, SQUEEZED = 2.0, 0.7
"""What runs into a spring bumper so fast squeezes it by this share of its way."""
BUMPERS = (0.3, 2.0)
"""Sizes of spring bumpers over the usual one: as high as what runs into them, within these."""
PLATE_SHARE = 0.3
"""Mass of a bumper's plate over that of what it throws back: a toy meets it with a hit that counts,
and loses a quarter of its energy to it."""
TOY = 0.3
"""Size of a toy over that of what it is a toy of."""
MEETS_CM = 12.0
"""What hangs reaches so far below the top of what it is told to meet, or four fifths of that."""
_ENDS = ("front end", "back end")
"""Mounts of a seesaw's board: the one that is down at the upper limit of its hinge, the other."""
_BEAM, _BEAMS, _BEAM_MOUNTS = "beam on posts", lex.word_set("beams"), ("hook", "bar")
"""What a beam that things hang from is drawn as, what it is called, and where things hang there."""
_MOST_ON_A_BEAM, _APART = 5, 1.5
"""How many things a beam has places for, and how far apart these are over the widest thing."""
_MOTIONS = (EdgeEvent.DRIVE, EdgeEvent.RELEASE)
_MODES = ("drive", "release")
_TURNS = (NodeEvent.OPEN, NodeEvent.CLOSE)


def join_parts(scene: Scene) -> list[str]:
    """Makes jointed things of a scene's doors, pendulums, drawers; one reason per part added.

    What hangs on something that the prompt names, what is a part of it ("the door of a car") and
    what something else enters stays as it is.
    """
    _weigh_down(scene)
    _put_in(scene)
    reasons: list[str] = []
    for e in list(scene.world.entities.values()):
        row = articulation_of(scene, scene.text, e)
        if row is None or _stays_whole(scene, row, e):
            continue
        _light_enough(scene, row, e)
        _toy_sized(scene, row, e)
        _weak_enough(scene, row, e)
        row = _springy_enough(scene, row, e)
        ratio = _become(e, row.becomes) if row.becomes else [1.0, 1.0, 1.0]
        above = any(x.noun.kind == "ceiling" for x in scene.world.entities.values())
        if e.id in scene.loosed and row.hangs_anywhere and (above or _met(scene, e)):
            reasons += _under_a_ceiling(scene, row, e)
        if e.id in scene.attached:
            row = replace(row, kind="ball") if not row.becomes else row
            held = _joint(scene, row, e, scene.world.entities[scene.attached[e.id]], 1, ratio)
            scene.joints.append(held.model_copy(update={"parent_mount": None}))
            continue
        added = _served(scene, row, e)
        for _ in range(row.count - len(added)):
            noun = lex.part(row.with_part)
            # "A windmill blade" is the blade of a windmill.
            name = next((a for a in e.adjectives if a in row.serves), noun.name)
            part = add_entity(scene.world, noun, name, mentioned=False)
            reasons.append(f"{name} added: {e.label} is joined to it")
            added.append(part)
        for n, part in enumerate(added, start=1):
            part.dimensions_cm = [
                d * r for d, r in zip(part.noun.dimensions_cm, ratio, strict=True)
            ]
            part.dimensions_prescribed = part.dimensions_prescribed or e.dimensions_prescribed
            if not row.becomes:
                row = _hung_on(scene, row, e, part)
            _lower(scene, row, e, part)
            part.implied = not part.mentioned
            both = {e.id, part.id}
            if row.carries == "becomes":
                _at_the_whole(scene, part.id, e.id)
            scene.relations = [r for r in scene.relations if {r.source, r.target} != both]
            for places in (scene.supported_by, scene.inside_of, scene.marked):
                if places.get(part.id) == e.id:
                    del places[part.id]  # "a drawer of a cabinet" is its part, not full of it
                if places.get(e.id) == part.id:
                    del places[e.id]  # "a pendulum on a stand" hangs there
                elif e.id in places:
                    places.setdefault(part.id, places[e.id])
            scene.joints.append(_joint(scene, row, e, part, n, ratio))
            _below_its_flap(scene, e)
        if row.carries == "becomes":
            _hand_over(scene, e.id, added[0].id)
    _side_by_side(scene)
    _seat_on_seesaws(scene)
    return reasons


def _put_in(scene: Scene) -> None:
    """ "A bottle is in the fridge. A man opens it": behind the door that is told of later."""
    hollow = behind_doors(scene, scene.text)
    for node, host in scene.shut_in.items():
        if host in hollow and scene.supported_by.get(node, host) == host:
            scene.supported_by[node] = scene.inside_of[node] = host
            both = {node, host}
            scene.relations = [r for r in scene.relations if {r.source, r.target} != both]


def _below_its_flap(scene: Scene, e: Entity) -> None:
    """Puts what something lands on that a trapdoor lets through below that."""
    entities = scene.world.entities
    if not is_flap(scene, scene.text, e.id):
        return
    for node in scene.timeline.nodes:
        lands = node.event in (NodeEvent.COLLISION, NodeEvent.ENTER_REGION)
        if not lands or scene.supported_by.get(node.participants[0]) != e.id:
            continue
        named = [*node.participants[1:], str(node.extra.get("region", "")).partition("/")[0]]
        for other in (
            i for i in named if i in entities and "structural" not in entities[i].noun.traits
        ):
            scene.relations.append(Relation(other, e.id, "under"))


def _stays_whole(scene: Scene, row: Articulation, e: Entity) -> bool:
    """Whether a thing that has a row is drawn as one body all the same."""
    acting = {i for n in scene.timeline.nodes for i in n.participants}
    entered = {n.extra.get("region") for n in scene.timeline.nodes}
    moved = _told_of_joint(scene, e)
    fixed = e.id in scene.attached and e.id not in acting  # nothing happens to it
    filled = f"{e.id}/inside" in entered and not moved
    in_use = row.start and row.carries == "becomes" and not moved
    return bool(e.whole or fixed or filled or in_use) or (
        not moved and of_a_house(scene, scene.text, e)
    )


def _told_of_joint(scene: Scene, e: Entity) -> bool:
    """Whether what stands open in use is told to open, to close or to be shut: a laptop."""
    turns = (n for n in scene.timeline.nodes if n.event in _TURNS)
    said = bool({*_OPEN, *_SHUT} & {*e.adjectives}) or e.id in scene.openings
    return said or any(e.id in n.participants for n in turns)


def _under_a_ceiling(scene: Scene, row: Articulation, e: Entity) -> list[str]:
    """Hangs what comes down on something below a ceiling: gallows would stand in its way."""
    entities = scene.world.entities.values()
    if e.id in scene.attached or any(head_of(x) in row.serves for x in entities):
        return []
    noun = lex.nouns()["ceiling"]
    ceiling = next((x for x in entities if x.noun.name == noun.name), None)
    if ceiling is None:
        ceiling = add_entity(scene.world, noun, noun.name, mentioned=False)
    scene.attached[e.id] = ceiling.id
    return [f"{noun.name} added: {e.label} hangs from it"]


def _hung_on(scene: Scene, row: Articulation, e: Entity, part: Entity) -> Articulation:
    """The row of what hangs as it is drawn, by a rope that suits it and what it hangs on.

    Gallows are made as large as it takes; from a crane it hangs lower.
    """
    length, width, height = dimensions_of(e)
    rope = min(max(height, ROPE_CM[0]), ROPE_CM[1])
    if row.kind == "spring":
        rope = row.upper or 0.0
    elif part.mentioned:
        hook = _HOOK * dimensions_of(part)[2]
        return replace(row, upper=max(hook - height - row.above_cm, rope))
    post, arm, _ = part.noun.dimensions_cm
    reach = max(length, width) / 1.6 + 20.0
    above = row.above_cm + _tallest_below(scene, e)
    if e.id not in scene.loosed:
        above = min(row.above_cm, _clears(scene, e))
    part.dimensions_cm = [post, max(arm, reach), height + rope + above]
    return replace(row, upper=rope)


def _lower(scene: Scene, row: Articulation, e: Entity, part: Entity) -> None:
    """Lowers what carries a thing that would swing over what it is told to meet: dominoes."""
    over = row.above_cm - _clears(scene, e)
    if row.turns:
        over = row.above_cm - _reached(scene, row, e)
    at = _hung_at(scene, e)
    others = [scene.world.entities.get(i) for i in _strikers(scene, e)]
    hung = [h for x in others if x is not None and (h := _hung_at(scene, x)) is not None]
    if at is not None and hung:
        over = at - min(hung)  # a log on ropes swings against a bell
    sweeps = row.opened is not None and (row.lower or 0.0) < 0.0  # a boom, over what it is to meet
    swings = (
        (row.drawn is not None or row.turns or sweeps) and row.carries == "with" and row.becomes
    )
    if swings and part.dimensions_cm is not None and over > 0.0:
        part.dimensions_prescribed = True
        pivot = row.above_cm + (0.0 if row.turns or sweeps else e.noun.dimensions_cm[2])
        pivot += (row.upper or 0.0) if row.kind == "rope" else 0.0
        part.dimensions_cm[2] *= 1.0 - over / pivot


def lowers(row: Articulation, height: float) -> bool:
    """Whether what turns on its post stands lower for what runs into its arms, so high [cm]."""
    return row.turns and row.carries == "with" and LOWERED * row.above_cm < height < row.above_cm


def _reached(scene: Scene, row: Articulation, e: Entity) -> float:
    """How high above the ground arms may be that something on the ground is to run into [cm]."""
    entities = scene.world.entities
    low = [dimensions_of(entities[i])[2] for i in _strikers(scene, e) if i in entities]
    low = [h for h in low if lowers(row, h + ARM_CM)]
    return min(low, default=math.inf) - ARM_CM


def _strikers(scene: Scene, e: Entity) -> list[str]:
    """What is told to run into a thing, once for every time."""
    hits = (n for n in scene.timeline.nodes if n.event is NodeEvent.COLLISION)
    return [n.participants[0] for n in hits if e.id in n.participants[1:]]


def _light_enough(scene: Scene, row: Articulation, e: Entity) -> None:
    """Makes what a blow is to set swinging small enough for what strikes it: a bell for a ball."""
    entities = scene.world.entities
    swings = any(
        n.event is NodeEvent.SWING and n.participants[0] == e.id for n in scene.timeline.nodes
    )
    movers = [entities[i] for i in _strikers(scene, e) if i in entities]
    struck = [m.mass_kg or m.noun.mass_kg for m in movers]
    told = e.mass_prescribed or e.dimensions_prescribed or e.dimensions_cm is not None
    if not struck or not swings or told or not row.hangs or not row.becomes:
        return
    share = SWUNG_BY * min(struck) / lex.part(row.becomes).mass_kg
    if share < 1.0:
        scale = max(share, LEAST_SHARE) ** (1.0 / 3.0)
        e.dimensions_cm = [d * scale for d in e.noun.dimensions_cm]
        e.dimensions_prescribed = True


def _toy_sized(scene: Scene, row: Articulation, e: Entity) -> None:
    """What a toy is to push open is a toy, too: a gate for a toy car."""
    entities = scene.world.entities
    movers = [entities.get(i) for i in _strikers(scene, e)]
    toys = [m is not None and m.noun.kind == "toyvehicle" for m in movers]
    if toys and all(toys) and row.opened is not None and e.dimensions_cm is None:
        e.dimensions_cm = [d * TOY for d in e.noun.dimensions_cm]
        e.dimensions_prescribed = True


def _weak_enough(scene: Scene, row: Articulation, e: Entity) -> None:
    """Makes what a swinging thing of a stated mass is to break small enough for its blow."""
    if row.drawn is None or row.carries != "with" or not e.mass_prescribed or e.mass_kg is None:
        return
    entities = scene.world.entities
    length = ((row.upper or 0.0) if row.kind == "rope" else e.noun.dimensions_cm[2]) / 100.0
    fall = length * (1.0 - math.cos(math.radians(row.drawn)))
    blow = BREAKS_BY * e.mass_kg * math.sqrt(2.0 * GRAVITY_MPS2 * fall)
    hits = (n for n in scene.timeline.nodes if n.event is NodeEvent.COLLISION)
    met = {i for n in hits if n.participants[0] == e.id for i in n.participants[1:]}
    for body in (entities[i] for i in sorted(met & {*scene.breaking} & {*entities})):
        bears = scene.breaking[body.id].at_mps * (body.mass_kg or body.noun.mass_kg)
        if bears > blow and body.dimensions_cm is None and not body.mass_prescribed:
            scale = max(blow / bears, LEAST_SHARE) ** (1.0 / 3.0)
            body.dimensions_cm = [d * scale for d in body.noun.dimensions_cm]
            body.dimensions_prescribed = True


def _springy_enough(scene: Scene, row: Articulation, e: Entity) -> Articulation:
    """The row of what springs back, as large, light and stiff as what runs into it asks."""
    entities = scene.world.entities
    movers = [entities[i] for i in _strikers(scene, e) if i in entities]
    if not row.rebounds or not movers:
        return row
    part, heavy = lex.part(row.becomes), max(m.mass_kg or m.noun.mass_kg for m in movers)
    scale = max(dimensions_of(m)[2] for m in movers) / part.dimensions_cm[2]
    scale = min(max(scale, BUMPERS[0]), BUMPERS[1])
    if e.dimensions_cm is None:
        e.dimensions_cm = [d * scale for d in e.noun.dimensions_cm]
        e.dimensions_prescribed = True
    if not e.mass_prescribed:
        e.mass_kg, e.mass_prescribed = round(PLATE_SHARE * heavy, 4), True
    way = SQUEEZED * scale * abs(row.lower or 0.0) / 100.0
    return replace(row, stiffness=float(f"{heavy * (SQUEEZED_BY_MPS / way) ** 2:.6g}"))


def _met(scene: Scene, e: Entity) -> list[float]:
    """Heights of what stands on the ground and something is told to meet [cm]."""
    entities = scene.world.entities
    hits = (n for n in scene.timeline.nodes if n.event is NodeEvent.COLLISION)
    met = {i for n in hits if n.participants[0] == e.id for i in n.participants[1:]}
    stand = met & {*entities} - {*scene.supported_by}
    return [dimensions_of(entities[i])[2] for i in stand if _hung_at(scene, entities[i]) is None]


def _hung_at(scene: Scene, e: Entity) -> float | None:
    """How high above the ground the middle of what hangs is, as usual [cm]; None if nothing holds
    it up."""
    row = articulation_of(scene, scene.text, e)
    hangs = row is not None and row.carries == "with" and (row.hangs or row.kind == "rope")
    return row.above_cm + 0.5 * dimensions_of(e)[2] if row is not None and hangs else None


def _clears(scene: Scene, e: Entity) -> float:
    """How high above the ground something may hang that is to meet what stands there [cm]."""
    low = min(_met(scene, e), default=math.inf)
    return math.inf if e.id in scene.loosed else low - min(0.8 * low, MEETS_CM)


def _tallest_below(scene: Scene, e: Entity) -> float:
    return max(_met(scene, e), default=0.0)


def _seat_on_seesaws(scene: Scene) -> None:
    """Holds what sits on the ends of a seesaw there until the board jolts it."""
    taken: dict[str, int] = {}
    for node, board in scene.supported_by.items():
        row = articulation_of(scene, scene.text, scene.world.entities[board])
        seated = scene.openings.get(board) or node in scene.at_ends
        if row is None or not row.tips or not seated:
            continue
        e = scene.world.entities[node]
        mass = e.mass_kg or e.noun.mass_kg
        taken[board] = taken.get(board, -1) + 1
        end = _ENDS[min(taken[board], len(_ENDS) - 1)]
        scene.joints.append(seat(node, board, end, round(JOLT_MPS * mass, 4)))


def _weigh_down(scene: Scene) -> None:
    """Lowers the end of a seesaw on which something sits alone."""
    boards = [scene.supported_by[i] for i in scene.at_ends if i in scene.supported_by]
    for board in boards:
        row = articulation_of(scene, scene.text, scene.world.entities[board])
        if row is not None and boards.count(board) == 1:
            scene.openings.setdefault(board, row.upper or 0.0)


def _hand_over(scene: Scene, named: str, part: str) -> None:
    """Lets the part that turns do what is told of the whole: a chest opens, a cradle swings."""
    moves = any(x.actor == named and x.event in _MOTIONS for x in scene.timeline.edges)
    track = scene.timeline.tracks.get(named)
    going = track is not None and track.motion is not None and track.motion.mode in _MODES
    turns = any(x.event in _TURNS and named in x.participants for x in scene.timeline.nodes)
    if moves or going or turns:
        scene.timeline.hand_over(named, part)


def _become(e: Entity, name: str) -> list[float]:
    """Makes a part of an entity; returns its size over that part's usual one, by axis."""
    usual, part = e.noun.dimensions_cm, lex.part(name)
    if e.dimensions_cm is not None:
        told = zip(e.dimensions_cm, usual, part.dimensions_cm, strict=True)
        e.dimensions_cm = [d / was * now for d, was, now in told]
    kept = e.noun.traits - {"fixed", "structural"}
    e.noun = replace(
        part,
        kind=e.noun.kind,
        material=e.noun.material,
        shape=e.noun.shape,
        traits=kept | part.traits,
    )
    e.part = True
    return [d / u for d, u in zip(dimensions_of(e), part.dimensions_cm, strict=True)]


def _served(scene: Scene, row: Articulation, named: Entity) -> list[Entity]:
    """What of the prompt serves as the other part, made that; empty if there is nothing."""
    parts = parts_of(scene.world, named)
    for part in parts:
        _become(part, row.with_part)
        # "Ball" is rubber and "steel ball" mild steel; a cradle's rebound as its drawing says.
        part.noun = replace(part.noun, material=lex.part(row.with_part).material)
        part.group = part.pattern = None
        _not_placed(scene, part.id)
    if parts:
        return parts
    taken = {name for j in scene.joints for name in (j.child, j.parent)}
    for e in scene.world.entities.values():
        if head_of(e) not in row.serves or row.count != 1:
            continue
        if e.id not in taken:
            _become(e, _BEAM if _lies_on_posts(row, e) else row.with_part)
            return [e]
        if e.noun.name == _BEAM and _lies_on_posts(row, e):
            return [e]  # beside what hangs there already
    return []


def _lies_on_posts(row: Articulation, e: Entity) -> bool:
    """Whether something hangs from a beam, and not from the arm of a post."""
    return head_of(e) in _BEAMS and row.parent_mount in _BEAM_MOUNTS


def _side_by_side(scene: Scene) -> None:
    """Spreads what hangs from one beam along it; the beam is as high and wide as it takes."""
    entities = scene.world.entities
    for beam in [e for e in entities.values() if e.part and e.noun.name == _BEAM]:
        hung = [j for j in scene.joints if j.parent == beam.id][:_MOST_ON_A_BEAM]
        if not hung or beam.dimensions_prescribed:
            continue
        bodies = [entities[j.child] for j in hung]
        length, width, _ = lex.part(_BEAM).dimensions_cm
        room = _APART * max(max(dimensions_of(e)[:2]) for e in bodies)
        wide = max(width, (len(hung) + 1) * room)
        beam.dimensions_cm = [length, wide, max(_hook_height(scene, e) for e in bodies)]
        for k, joint in enumerate(hung, start=1):
            if len(hung) > 1:
                told = {"parent_mount": f"{joint.parent_mount} {k} of {len(hung)}"}
                scene.joints[scene.joints.index(joint)] = joint.model_copy(update=told)


def _hook_height(scene: Scene, e: Entity) -> float:
    """Height [cm] of the gallows that something usually hangs from."""
    row = articulation_of(scene, scene.text, e)
    return 0.0 if row is None else lex.part(row.with_part).dimensions_cm[2]


def _not_placed(scene: Scene, node: str) -> None:
    """Forgets where a part is said to be: its joint says so."""
    scene.relations = [r for r in scene.relations if node not in (r.source, r.target)]
    for places in (scene.supported_by, scene.inside_of, scene.marked):
        places.pop(node, None)


def _at_the_whole(scene: Scene, part: str, whole: str) -> None:
    """What is said to be by a part that moves is by what carries it: a rock by a catapult."""
    scene.relations = [
        replace(
            r,
            source=whole if r.source == part else r.source,
            target=whole if r.target == part else r.target,
        )
        for r in scene.relations
    ]


def _joint(
    scene: Scene, row: Articulation, named: Entity, added: Entity, n: int, ratio: list[float]
) -> Joint:
    parent, child = (named, added) if row.carries == "becomes" else (added, named)
    size = math.prod(ratio) ** (1.0 / 3.0)
    turns = row.kind in ("hinge", "ball")
    long = 1.0 if turns else size
    words = (*named.adjectives, *named.head.lower().split(), *_left(scene, named))
    words = (*words, *_gone_through(scene, named, words))
    start = max((_OPEN.get(a, 0.0) for a in words), default=0.0)
    start = (row.opened or 0.0) * start or (0.0 if _SHUT & {*words} else row.start)

    # of several, the first is let go and meets the others, unless the prompt says which
    opening = scene.openings.get(named.id, start) if n == 1 else row.start
    opening = scene.openings.get(added.id, opening)

    # what hangs and falls: whatever held it gives way under its weight as the scene starts
    comes_down = row.hangs or (row.kind == "rope" and row.carries == "with")
    loosed = child.id in scene.loosed
    falls = loosed or (
        comes_down
        and any(
            n.event is NodeEvent.FALL and child.id in n.participants for n in scene.timeline.nodes
        )
    )
    opening = 0.0 if loosed else opening
    gives_way = GIVES_WAY_MPS * (child.mass_kg or child.noun.mass_kg)

    if falls and row.kind == "hinge":  # what gives way at once swings between no limits
        row = replace(row, lower=None, upper=None, stiffness=None)

    def sized(value: float | None) -> float | None:
        return None if value is None else round(value * long, 3)

    return Joint(
        id=f"{child.id}_{row.kind}",
        kind=row.kind,
        child=child.id,
        child_mount=row.child_mount,
        parent=parent.id,
        parent_mount=row.parent_mount.format(n=n),
        lower=sized(row.lower),
        upper=sized(row.upper),
        position=opening if row.kind == "rope" else sized(opening) or 0.0,
        stiffness=_stiff(row, child),
        damping=_grown(row.damping, size ** (5 if turns else 3)),
        friction=_grown(row.friction, size ** (4 if turns else 3)),
        break_impulse=float(f"{gives_way:.6g}") if falls else None,
    )


def _left(scene: Scene, e: Entity) -> list[str]:
    """ "Left the gate ajar", "the door stands ajar": how it is as the scene starts."""
    told = re.search(rf"\b{re.escape(e.head)}\b[^.;]*?\b(ajar)\b", scene.text, re.IGNORECASE)
    return [] if told is None else [told[1].lower()]


def _gone_through(scene: Scene, e: Entity, words: Sequence[str]) -> list[str]:
    """ "The sheep walk through a gate": it stands open, if nothing happens to it."""
    acting = {i for n in scene.timeline.nodes for i in n.participants}
    head = re.escape(e.head)
    told = re.search(rf"\bthrough (?:\w+ ){{1,3}}{head}\b", scene.text, re.IGNORECASE)
    return [] if told is None or e.id in acting or _SHUT & {*words} else ["open"]


def _stiff(row: Articulation, child: Entity) -> float | None:
    """Stiffness of a joint; that of a spring bears what hangs on it [N/m]."""
    if row.kind != "spring":
        return row.stiffness
    return round((child.mass_kg or child.noun.mass_kg) * GRAVITY_MPS2 / SAG_M, 3)


def _grown(value: float | None, factor: float) -> float | None:
    """What resists a thing of another size: friction as its weight grows, damping its inertia."""
    return None if value is None else float(f"{value * factor:.6g}")
