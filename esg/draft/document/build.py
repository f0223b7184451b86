"""From the interpreted scene to the ESG document: assets, nodes, regions, relations, faces."""

from __future__ import annotations

from dataclasses import dataclass, field
import hashlib
import re
from typing import Any

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity, slug
from esg.draft.discourse.scene import Relation, Scene
from esg.draft.document.requirements import (
    GROUND,
    GROUND_SIZE_CM,
    environment,
    opened,
    requirement,
)
from esg.draft.document.tints import tints
from esg.graph.models import (
    AssetRequirement,
    BinaryRelation,
    Breaking,
    Coverage,
    EsgDocument,
    MultiRelation,
    MultiRelationType,
    Node,
    NodeEvent,
    Provenance,
    RegionType,
    RelationEdges,
    RelationType,
    SceneDefinition,
    SceneParameters,
    SemanticRegion,
    SpatialRelationGraph,
    Statement,
    TimelineSystem,
)
from esg.graph.relations import conflict

_NEAR = frozenset({"by", "beside", "near", "next to", "alongside", "along", "at"})
_RESTRICTED = re.compile(
    r"\bno (?:other|more|additional|extra) (?:objects?|things?|items?|elements?|props?)\b"
    r"|\bnothing else\b|(?:^|[.;,]\s*)(?:there (?:is|are) )?only (?:an?|one|two|three|the|\d)"
    r"|\b(?:with|contains?|has|and|is|are) only\b"
    r"|\bwithout (?:any )?(?:other|additional|extra) (?:objects?|things?|items?)\b",
    re.IGNORECASE,
)


_STREETS = ("road", "sidewalk")
"""Grounds on or beside which things stay, whatever comes to hit them."""
_CARDINALS = {0.0: "+X", 90.0: "+Y", 180.0: "-X", 270.0: "-Y"}
"""Directions by heading [degrees]."""


@dataclass
class _Graph:
    """The parts of a document that name each other."""

    scene: Scene
    assets: dict[str, AssetRequirement] = field(default_factory=dict[str, AssetRequirement])
    regions: dict[str, SemanticRegion] = field(default_factory=dict[str, SemanticRegion])
    nodes: dict[str, Node] = field(default_factory=dict[str, Node])
    relations: list[BinaryRelation] = field(default_factory=list[BinaryRelation])
    multi: list[MultiRelation] = field(default_factory=list[MultiRelation])

    @property
    def entities(self) -> dict[str, Entity]:
        return self.scene.world.entities


def is_restricted(prompt: str) -> bool:
    """Whether the prompt forbids further objects ("only A", "no other objects")."""
    return _RESTRICTED.search(prompt) is not None


def build(
    scene: Scene,
    prompt: str,
    seed: int,
    timeline: TimelineSystem | None,
    coverage: Coverage,
    statements: tuple[Statement, ...] | None,
    expanded: str,
) -> EsgDocument:
    """Writes a scene as a document.

    Args:
        scene: The interpreted scene.
        prompt: What was typed.
        seed: Enters the scene id and the provenance.
        timeline: Its events; None if nothing moves.
        coverage: What became of the prompt's words.
        statements: What it states beyond objects, relations and events.
        expanded: The prompt with what was added.
    """
    scene_type, preset = environment(scene)
    graph = _Graph(scene)
    _lay_ground(scene, scene_type)
    _hang(scene)
    tint = tints(scene)
    assets = {e.id: _asset(e, graph, tint.get(e.id)) for e in graph.entities.values()}
    for e in graph.entities.values():
        graph.nodes[e.id] = _node(e, assets[e.id], graph)
    _relate(graph)
    _face(graph)
    digest = hashlib.sha256(f"{prompt}\0{seed}".encode()).hexdigest()[:8]
    return EsgDocument(
        scene_definition=SceneDefinition(
            scene_id=f"{slug(prompt)[:40].strip('_') or 'scene'}-{digest}",
            original_description=prompt,
            expanded_description=expanded,
            scene_parameters=SceneParameters(
                is_dynamic=timeline is not None,
                scene_type="indoor" if scene_type == "indoor" else "outdoor",
                environment=preset,
                allow_supplementary=not is_restricted(scene.text),
            ),
        ),
        asset_requirement=graph.assets,
        spatial_relation_graph=SpatialRelationGraph(
            semantic_regions=graph.regions,
            nodes=graph.nodes,
            edges=RelationEdges(
                binary_relations=tuple(graph.relations), multi_relations=tuple(graph.multi)
            ),
            joints=tuple(scene.joints) or None,
        ),
        timeline_system=timeline,
        coverage=coverage,
        statements=statements,
        provenance=(
            Provenance(
                stage="draft",
                version="1",
                seed=seed,
                config={"drafter": "rules"},
                input_hash=hashlib.sha256(prompt.encode()).hexdigest(),
            ),
        ),
    )


def _lay_ground(scene: Scene, scene_type: str) -> None:
    """Exactly one ground, first among the nodes."""
    ground = scene.world.entities.pop(GROUND, None)
    if ground is None:
        noun = lex.nouns()["floor" if scene_type == "indoor" else "ground"]
        ground = Entity(GROUND, noun, noun.name, noun.name, mentioned=False)
    scene.world.entities = {GROUND: ground, **scene.world.entities}


def _hang(scene: Scene) -> None:
    """What hangs at first and then moves is no fixture; circles go round their support."""
    moved = {a for a, track in scene.timeline.tracks.items() if track.motion or track.hit}
    for e in scene.world.entities.values():
        e.static = e.id in scene.attached and e.id not in moved and not e.part
        host = scene.supported_by.get(e.id)
        if e.pattern == "ring" and host is not None and e.id not in scene.inside_of:
            scene.relations.append(Relation(e.id, host, "surround"))


def _asset(e: Entity, graph: _Graph, tint: str | None) -> str:
    """Name of what an entity needs; alike entities of one colour share it."""
    required = requirement(e)
    if tint is not None:
        required = required.model_copy(update={"color": tint})
    inside = f"{e.id}/inside"
    jointed = any(e.id in (j.parent, j.child) for j in graph.scene.joints)  # "a chest with a lid"
    contents = graph.scene.contents.get(e.id)
    if not jointed and any(n.extra.get("region") == inside for n in graph.scene.timeline.nodes):
        names = {x.noun.name for x in graph.entities.values()}
        required = opened(e, required, bool(names & {"golf ball", "golf club"}))
    if contents is not None:
        required = required.model_copy(update={"contents": contents})
    if e.id == GROUND:
        size = (2000.0, 2000.0, 2.0) if "indoor" in e.noun.traits else GROUND_SIZE_CM
        required = required.model_copy(
            update={"expected_dimensions_cm": size, "asset_category": slug(e.noun.name)}
        )
    stem = slug(" ".join([*([e.color] if e.color else []), required.asset_category]))
    n = 1
    while graph.assets.setdefault(name := f"{stem}_{n:02d}", required) != required:
        n += 1
    return name


def _region(e: Entity, graph: _Graph) -> str:
    """The region that an entity is in, which it adds to the graph."""
    scene, entities = graph.scene, graph.entities
    wall, host = scene.attached.get(e.id, ""), scene.supported_by.get(e.id, "")
    host = _top_of_stack(entities[host], e, entities) if host in entities else host
    parent, kind = GROUND, RegionType.SUPPORT_SURFACE
    name, text = "ground_area_1", "open ground"
    if wall in entities:
        below = entities[wall].noun.kind == "ceiling"
        kind = RegionType.ATTACHED_HORIZONTAL if below else RegionType.ATTACHED_VERTICAL
        parent, name, text = wall, f"{wall}_face", f"face of the {entities[wall].head}"
    elif host in entities and host != GROUND and e.id in scene.inside_of:
        parent, kind = host, RegionType.STORAGE
        name, text = f"{host}_inside", f"inside of the {entities[host].head}"
    else:
        host = host if host in entities else _road_under(e, graph)
        if host and host != GROUND:
            parent, name, text = host, f"{host}_surface", f"top of the {entities[host].head}"
    at = scene.at_part.get(e.id)
    part = at[1] if at is not None and at[0] == host == parent else None
    if part is not None:
        name, text = f"{host}_{part.replace(' ', '_')}", f"{part} of the {entities[host].head}"
    region = SemanticRegion(
        region_description=text, region_type=kind, parent_object=parent, part=part
    )
    graph.regions.setdefault(name, region)
    return name


def _top_of_stack(host: Entity, e: Entity, entities: dict[str, Entity]) -> str:
    """Of a stack its last member, which lies on top; others carry what they are said to."""
    members = [x for x in entities.values() if x.group == host.group and x.in_group]
    stacked = host.pattern == "stack" and e not in members and members[:1] == [host]
    return members[-1].id if stacked else host.id


def _road_under(e: Entity, graph: _Graph) -> str:
    """The road or lane that something waits on, if nothing of its plural takes part in events.

    What moves is placed by its motion; the road then lies under it wherever that is. Of a street or
    a pavement it matters on which of them something is met, too.
    """
    road, timeline = graph.scene.marked.get(e.id, ""), graph.scene.timeline
    acting = {a for a, track in timeline.tracks.items() if track.motion}
    streets = [lex.nouns()[name] for name in _STREETS]  # not a pier, which is as flat
    if road not in graph.entities or graph.entities[road].noun not in streets:
        acting |= {i for n in timeline.nodes for i in n.participants}
    members = graph.scene.world.groups.get(e.group or "", [e.id])
    return road if road in graph.entities and not acting & set(members) else ""


def _node(e: Entity, asset: str, graph: _Graph) -> Node:
    structural = "structural" in e.noun.traits
    members = sum(x.group == e.group and x.in_group for x in graph.entities.values())
    pattern: Any = e.pattern if e.in_group and members > 1 else None
    return Node(
        asset_id=asset,
        semantic_region=None if structural else _region(e, graph),
        is_structural=structural,
        label=e.label,
        mentioned=e.mentioned,
        group=e.group if e.in_group else None,
        # The circle is a relation to what carries it.
        group_pattern="scatter" if e.pattern == "ring" and e.in_group else pattern,
        is_static=("fixed" in e.noun.traits or e.static) and not e.freed,
        breaking=_breaking(e, graph.scene),
    )


def _breaking(e: Entity, scene: Scene) -> Breaking | None:
    row = scene.breaking.get(e.id)
    if row is None:
        return None
    return Breaking(speed=100.0 * row.at_mps, pieces=row.pieces)


def _add(graph: _Graph, source: str, target: str, kind: RelationType, **extra: Any) -> None:
    """Adds a relation between two nodes unless it is there or contradicts another one."""
    if source == target or source not in graph.nodes or target not in graph.nodes:
        return
    for r in graph.relations:
        if {r.from_, r.to} != {source, target}:
            continue
        same = r.from_ == source
        if r.relation_type is kind and (same or kind in (RelationType.NEAR, RelationType.ADJACENT)):
            return
        if conflict(kind, r.relation_type, same_way=same):
            graph.scene.warnings.append(
                f'Left out "{source} {kind.value} {target}": it contradicts '
                f'"{r.from_} {r.relation_type.value} {r.to}".'
            )
            return
    graph.relations.append(BinaryRelation(from_=source, to=target, relation_type=kind, **extra))


def _relate(graph: _Graph) -> None:
    """The relations of the scene; what carries a thing is its region, and no relation."""
    groups: dict[tuple[MultiRelationType, tuple[str, ...]], list[str]] = {}
    going = {e.actor for e in graph.scene.timeline.edges}
    for r in graph.scene.relations:
        if r.kind in ("between", "surround"):
            targets = (r.target, r.text) if r.kind == "between" else (r.target,)
            groups.setdefault((MultiRelationType(r.kind), targets), []).append(r.source)
            continue
        if r.target not in graph.nodes or r.source not in graph.nodes:
            continue
        a, b = graph.entities[r.source], graph.entities[r.target]
        if r.kind == "structural":  # where it stands, not what carries it
            goes_along = r.text == "along" and r.source in going  # it is on it, not beside it
            if r.text in _NEAR and r.target != GROUND and not goes_along:
                text = f"{a.label} {r.text} the {b.label}"
                _add(graph, r.source, r.target, RelationType.NEAR, confidence=0.7,
                     semantic_description=text)  # fmt: skip
        elif r.kind not in ("on", "inside_of") and not graph.nodes[r.source].is_structural:
            extra: dict[str, Any] = {} if r.distance is None else {"distance_cm": r.distance}
            text = f"{a.label} {r.kind.replace('_', ' ')} {b.label}"
            _add(graph, r.source, r.target, RelationType(r.kind), confidence=0.9,
                 semantic_description=text, **extra)  # fmt: skip
    for (kind, targets), sources in groups.items():
        subjects = tuple(dict.fromkeys(s for s in sources if s not in targets))
        if subjects and len(set(targets) & graph.nodes.keys()) == len(targets):
            graph.multi.append(
                MultiRelation(subjects=subjects, targets=targets, relation_type=kind)
            )


def _courses(graph: _Graph) -> dict[str, str]:
    """Where those who go in one of the viewer's directions face: that way, or back to front."""
    out: dict[str, str] = {}
    for edge in graph.scene.timeline.edges:
        heading = edge.params.heading_deg
        if isinstance(heading, int | float):
            turned = heading + (180.0 if edge.params.backward else 0.0)
            out.setdefault(edge.actor, _CARDINALS[turned % 360.0])
    return out


def _struck_across(graph: _Graph, courses: dict[str, str]) -> dict[str, str]:
    """Where hinged things face that swing from a blow out of a stated side: they swing that way."""
    out: dict[str, str] = {}
    nodes = graph.scene.timeline.nodes
    swung = {n.participants[0] for n in nodes if n.event is NodeEvent.SWING}
    for joint in (j for j in graph.scene.joints if j.kind == "hinge" and j.child in swung):
        hits = (n for n in nodes if n.event is NodeEvent.COLLISION)
        by = (n.participants[0] for n in hits if joint.child in n.participants[1:])
        way = next((courses[b] for b in by if b in courses), None)
        if way is not None:
            out |= {n: way for n in (joint.child, joint.parent) if n is not None}
    return out


def _face(graph: _Graph) -> None:
    """Exactly one `face` per regular object that is not round."""
    aims: dict[str, str] = {}
    courses = _courses(graph)
    swings = _struck_across(graph, courses)
    for edge in graph.scene.timeline.edges:
        if edge.target is not None and edge.event.value != "InertialConnector":
            aims.setdefault(edge.actor, edge.target)
    for name, node in graph.nodes.items():
        e = graph.entities[name]
        if (
            e.implied
            or node.is_structural
            or ("round" in e.noun.traits and e.noun.shape == "sphere")
        ):
            continue
        if name in courses or name in swings:
            text = f"{e.label} faces the way that it {'goes' if name in courses else 'swings'}"
            way = courses.get(name) or swings[name]
            _add(graph, name, GROUND, RelationType.FACE, cardinal=way, confidence=0.9,
                 semantic_description=text)  # fmt: skip
            continue
        target = graph.scene.facing.get(name) or aims.get(name, "")
        if target != name and target in graph.nodes and not graph.nodes[target].is_structural:
            text = f"{e.label} faces {graph.entities[target].label}"
            _add(graph, name, target, RelationType.FACE, confidence=0.8, semantic_description=text)
        else:
            text = f"{e.label} faces the front"
            _add(graph, name, GROUND, RelationType.FACE, cardinal="+Y", confidence=0.5,
                 semantic_description=text)  # fmt: skip
