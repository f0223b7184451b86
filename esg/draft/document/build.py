"""From the interpreted scene to the ESG document: assets, nodes, regions, relations, faces."""

from __future__ import annotations

import hashlib
import re
from typing import Any

from esg.draft import lexicon as lex
from esg.draft.discourse.referents.entities import Entity, slug
from esg.draft.discourse.scene import Relation, Scene
from esg.draft.document.openings import opened
from esg.draft.document.requirements import GROUND, GROUND_SIZE_CM, environment, requirement
from esg.graph.models import (
    AssetRequirement,
    BinaryRelation,
    Coverage,
    EsgDocument,
    MultiRelation,
    MultiRelationType,
    Node,
    Provenance,
    RegionType,
    RelationEdges,
    RelationType,
    SceneDefinition,
    SceneParameters,
    SemanticRegion,
    SpatialRelationGraph,
    TimelineSystem,
)


class DocumentBuilder:
    """Writes a Scene as a document."""

    def __init__(self, scene: Scene, prompt: str, seed: int) -> None:
        self.scene = scene
        self.world = scene.world
        self.prompt = prompt
        self.seed = seed
        self.assets: dict[str, AssetRequirement] = {}
        self.asset_of: dict[str, str] = {}
        self.regions: dict[str, SemanticRegion] = {}
        self.nodes: dict[str, Node] = {}
        self.relations: list[BinaryRelation] = []
        self.multi: list[MultiRelation] = []
        self._pairs: set[tuple[str, str, str]] = set()

    def build(
        self, timeline: TimelineSystem | None, coverage: Coverage, restricted: bool, expanded: str
    ) -> EsgDocument:
        """The document; `restricted` suppresses objects that the prompt does not need."""
        scene_type, preset = environment(self.scene)
        self._base(scene_type)
        self._hung()
        for e in self.world.entities.values():
            self._asset(e)
        self._regions_and_nodes()
        self._relations()
        self._faces()
        digest = hashlib.sha256(f"{self.prompt}\0{self.seed}".encode()).hexdigest()[:8]
        name = slug(self.prompt)[:40].strip("_") or "scene"
        return EsgDocument(
            scene_definition=SceneDefinition(
                scene_id=f"{name}-{digest}",
                original_description=self.prompt,
                expanded_description=expanded,
                scene_parameters=SceneParameters(
                    is_dynamic=timeline is not None,
                    scene_type="indoor" if scene_type == "indoor" else "outdoor",
                    environment=preset,
                    allow_supplementary=not restricted,
                ),
            ),
            asset_requirement=self.assets,
            spatial_relation_graph=SpatialRelationGraph(
                semantic_regions=self.regions,
                nodes=self.nodes,
                edges=RelationEdges(
                    binary_relations=tuple(self.relations), multi_relations=tuple(self.multi)
                ),
            ),
            timeline_system=timeline,
            coverage=coverage,
            provenance=(
                Provenance(
                    stage="draft",
                    version="1",
                    seed=self.seed,
                    config={"drafter": "rules"},
                    input_hash=hashlib.sha256(self.prompt.encode()).hexdigest(),
                ),
            ),
        )

    def _base(self, scene_type: str) -> None:
        """Exactly one ground, first among the nodes."""
        ground = self.world.entities.pop(GROUND, None)
        if ground is None:
            table = lex.nouns()
            noun = table["floor"] if scene_type == "indoor" else table["ground"]
            ground = Entity(GROUND, noun, noun.name, noun.name, mentioned=False)
        self.world.entities = {GROUND: ground, **self.world.entities}

    def _hung(self) -> None:
        """What hangs at first and then moves is no fixture; circles go round their support."""
        moved = {a for a, track in self.scene.timeline.tracks.items() if track.motion or track.hit}
        for e in self.world.entities.values():
            e.static = e.id in self.scene.attached and e.id not in moved
            host = self.scene.supported_by.get(e.id)
            if e.pattern == "ring" and host is not None and e.id not in self.scene.inside_of:
                self.scene.relations.append(Relation(e.id, host, "surround"))

    def _entered(self) -> set[str]:
        """Nodes whose inside something enters."""
        regions = (n.extra.get("region") for n in self.scene.timeline.nodes)
        return {r.split("/")[0] for r in regions if isinstance(r, str) and r.endswith("/inside")}

    def _asset(self, e: Entity) -> None:
        required = requirement(e)
        if e.id in self._entered():
            required = opened(e, required, self._golf())
        if e.id == GROUND:
            size = (2000.0, 2000.0, 2.0) if "indoor" in e.noun.traits else GROUND_SIZE_CM
            required = required.model_copy(
                update={"expected_dimensions_cm": size, "asset_category": slug(e.noun.name)}
            )
        stem = slug(" ".join([*([e.color] if e.color else []), required.asset_category]))
        for n in range(1, 1000):
            name = f"{stem}_{n:02d}"
            if name not in self.assets:
                self.assets[name] = required
            if self.assets[name] == required:
                self.asset_of[e.id] = name
                return

    def _golf(self) -> bool:
        return any(x.noun.name in ("golf ball", "golf club") for x in self.world.entities.values())

    # -- regions and nodes -----------------------------------------------------------------------

    def _region(self, parent: str, storage: bool = False) -> str:
        if parent == GROUND:
            name, text = "ground_area_1", "open ground"
        else:
            name = f"{parent}_inside" if storage else f"{parent}_surface"
            text = f"{'inside' if storage else 'top'} of the {self.world.entities[parent].head}"
        if name not in self.regions:
            self.regions[name] = SemanticRegion(
                region_description=text,
                region_type=RegionType.STORAGE if storage else RegionType.SUPPORT_SURFACE,
                parent_object=parent,
            )
        return name

    def _face_of(self, wall: str) -> str:
        """The face that pictures or lamps hang on."""
        name = f"{wall}_face"
        below = self.world.entities[wall].noun.kind == "ceiling"
        self.regions.setdefault(
            name,
            SemanticRegion(
                region_description=f"face of the {self.world.entities[wall].head}",
                region_type=RegionType.ATTACHED_HORIZONTAL
                if below
                else RegionType.ATTACHED_VERTICAL,
                parent_object=wall,
            ),
        )
        return name

    def _regions_and_nodes(self) -> None:
        fixed = {"fixed"}
        for e in self.world.entities.values():
            structural = "structural" in e.noun.traits
            region = None
            if not structural:
                host = self.scene.supported_by.get(e.id)
                wall = self.scene.attached.get(e.id)
                if wall is not None and wall in self.world.entities:
                    region = self._face_of(wall)
                elif host is not None and host in self.world.entities:
                    region = self._region(self._top_of_stack(host, e), e.id in self.scene.inside_of)
                elif (road := self._road_under(e)) is not None:
                    region = self._region(road)
                else:
                    region = self._region(GROUND)
            self.nodes[e.id] = Node(
                asset_id=self.asset_of[e.id],
                semantic_region=region,
                is_structural=structural,
                label=e.label,
                mentioned=e.mentioned,
                group=e.group if e.in_group else None,
                group_pattern=self._pattern(e),
                is_static=(bool(fixed & e.noun.traits) or e.static) and not e.freed,
            )

    def _top_of_stack(self, host: str, e: Entity) -> str:
        """Of a stack its last member, which lies on top; others carry what they are said to."""
        below = self.world.entities[host]
        members = [x for x in self.world.entities.values() if x.group == below.group and x.in_group]
        stacked = self._pattern(below) == "stack" and e not in members
        return members[-1].id if stacked and members[0] is below else host

    def _road_under(self, e: Entity) -> str | None:
        """The road or lane that something waits on, if nothing of its plural takes part in events.

        What moves is placed by its motion; the road then lies under it wherever that is.
        """
        road = self.scene.marked.get(e.id)
        if road is None or road not in self.world.entities or road == GROUND:
            return None
        members = self.world.groups.get(e.group or "", [e.id])
        acting = {i for n in self.scene.timeline.nodes for i in n.participants}
        acting |= {a for a, track in self.scene.timeline.tracks.items() if track.motion}
        if acting & set(members) or any(self.scene.marked.get(i) != road for i in members):
            return None
        length = 1.5 * sum(
            requirement(self.world.entities[i]).expected_dimensions_cm[0] for i in members
        )
        fits = length < requirement(self.world.entities[road]).expected_dimensions_cm[0]
        return road if fits else None

    def _pattern(self, e: Entity) -> Any:
        if not e.in_group:
            return None
        if e.pattern == "ring":
            return "scatter"  # the circle is a relation to what carries it
        members = [x for x in self.world.entities.values() if x.group == e.group and x.in_group]
        return e.pattern if len(members) > 1 else None

    # -- relations -------------------------------------------------------------------------------

    def _add(self, source: str, target: str, kind: RelationType, **extra: Any) -> None:
        if source == target or source not in self.nodes or target not in self.nodes:
            return
        from esg.graph.relations import conflict

        for r in self.relations:
            if {r.from_, r.to} != {source, target}:
                continue
            same = r.from_ == source
            if r.relation_type is kind and (
                same or kind in (RelationType.NEAR, RelationType.ADJACENT)
            ):
                return
            if conflict(kind, r.relation_type, same_way=same):
                self.scene.warnings.append(
                    f'Left out "{source} {kind.value} {target}": it contradicts '
                    f'"{r.from_} {r.relation_type.value} {r.to}".'
                )
                return
        self.relations.append(BinaryRelation(from_=source, to=target, relation_type=kind, **extra))

    def _relations(self) -> None:
        groups: dict[tuple[str, str], list[str]] = {}
        for r in self.scene.relations:
            if r.kind in ("between", "surround"):
                groups.setdefault((r.kind, f"{r.target}|{r.text}"), []).append(r.source)
                continue
            if r.kind == "structural" or r.target not in self.nodes or r.source not in self.nodes:
                self._structural(r)
                continue
            if self.nodes[r.source].is_structural:
                continue
            kind = RelationType(r.kind)
            if kind in (RelationType.ON, RelationType.INSIDE_OF):
                continue
            a, b = self.world.entities[r.source], self.world.entities[r.target]
            extra: dict[str, Any] = {
                "confidence": 0.9,
                "semantic_description": f"{a.label} {r.kind.replace('_', ' ')} {b.label}",
            }
            if r.distance is not None:
                extra["distance_cm"] = r.distance
            self._add(r.source, r.target, kind, **extra)
        for (kind, key), sources in groups.items():
            target, other = key.split("|")
            targets = [target] if kind == "surround" else [target, other]
            subjects = tuple(dict.fromkeys(s for s in sources if s not in targets))
            if (
                not subjects
                or any(t not in self.nodes for t in targets)
                or len(set(targets)) < len(targets)
            ):
                continue
            self.multi.append(
                MultiRelation(
                    subjects=subjects, targets=tuple(targets), relation_type=MultiRelationType(kind)
                )
            )

    def _structural(self, r: Relation) -> None:
        """Relations to roads and the like say where things stand, not what carries them."""
        if r.target not in self.nodes or r.source not in self.nodes or r.target == GROUND:
            return
        source, target = (self.world.entities[n].label for n in (r.source, r.target))
        if r.text in ("by", "beside", "near", "next to", "alongside", "along", "at"):
            self._add(
                r.source,
                r.target,
                RelationType.NEAR,
                confidence=0.7,
                semantic_description=f"{source} {r.text} the {target}",
            )
        elif r.text in ("in the middle of",):
            self._add(
                r.source,
                r.target,
                RelationType.CENTER_OF,
                confidence=0.7,
                semantic_description=f"{source} in the middle of the {target}",
            )

    def _faces(self) -> None:
        """Exactly one `face` per regular object that is not round."""
        aims: dict[str, str] = {}
        for edge in self.scene.timeline.edges:
            if edge.target is not None and edge.event.value != "InertialConnector":
                aims.setdefault(edge.actor, edge.target)
        for name, node in self.nodes.items():
            if node.is_structural:
                continue
            e = self.world.entities[name]
            if "round" in e.noun.traits and e.noun.shape == "sphere":
                continue
            target = self.scene.facing.get(name) or aims.get(name)
            if (
                target is not None
                and target in self.nodes
                and target != name
                and not self.nodes[target].is_structural
            ):
                self._add(
                    name,
                    target,
                    RelationType.FACE,
                    confidence=0.8,
                    semantic_description=f"{e.label} faces {self.world.entities[target].label}",
                )
            else:
                self._add(
                    name,
                    GROUND,
                    RelationType.FACE,
                    cardinal="+Y",
                    confidence=0.5,
                    semantic_description=f"{e.label} faces the front",
                )


def is_restricted(prompt: str) -> bool:
    """Whether the prompt forbids further objects ("only A", "no other objects")."""
    t = prompt.lower()
    return bool(
        re.search(
            r"\bno (?:other|more|additional|extra) (?:objects?|things?|items?|elements?|props?)\b",
            t,
        )
        or re.search(r"\bnothing else\b", t)
        or re.search(r"(?:^|[.;,]\s*)(?:there (?:is|are) )?only (?:an?|one|two|three|the|\d)", t)
        or re.search(r"\b(?:with|contains?|has|and|is|are) only\b", t)
        or re.search(
            r"\bwithout (?:any )?(?:other|additional|extra) (?:objects?|things?|items?)\b", t
        )
    )
