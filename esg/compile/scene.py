"""Stage 5: a finished document becomes a folder that an engine can load."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
import os
from pathlib import Path

from esg.compile.emit import EmittedClass, emit_class
from esg.compile.model import WatchedEvent
from esg.compile.trust.written import remember
from esg.engines.base import VERIFY_DT_S
from esg.engines.manifest import manifest_bytes, manifest_to_json
from esg.engines.program import Program, program_from_json
from esg.engines.scene import SimScene
from esg.graph.models import EsgDocument, NodeEvent, TimelineNode
from esg.lexicon.gestures import SEEN_S

STATIC_DURATION_S = 2.0
"""How long a scene without a timeline plays: long enough to see that nothing moves."""


@dataclass(frozen=True)
class EmittedScene:
    """What a document says once it is compiled, before anything is written.

    Args:
        scene: The physical scene.
        program: Its control program.
        watch: The collisions that the class reports.
        emitted: The class.
    """

    scene: SimScene
    program: Program
    watch: tuple[WatchedEvent, ...]
    emitted: EmittedClass


@dataclass(frozen=True)
class CompiledScene:
    """What compile_scene wrote.

    Args:
        class_name: Name of the Unreal class without the leading A.
        files: Written files, relative to the scene folder, sorted.
    """

    class_name: str
    files: tuple[str, ...]


def compile_scene(
    doc: EsgDocument,
    folder: str | Path,
    *,
    scene: SimScene | None = None,
    program: Program | None = None,
    dt: float = VERIFY_DT_S,
) -> CompiledScene:
    """Writes `unreal/<Class>.h`, `.cpp`, `imports.json` and `manifest.json` into a scene folder.

    The same document gives the same bytes. Classes of an earlier run of the same folder are
    replaced.

    Args:
        doc: Document with layout and, for a dynamic scene, dynamics result.
        folder: Scene folder, created if missing.
        scene: Its physical scene; default built from the document.
        program: Its control program; default the document's.
        dt: Step the class pins and the manifest states [s].

    Raises:
        ValueError: For what the class or the manifest cannot say.
    """
    made = emit_document(doc, scene=scene, program=program, dt=dt)
    pairs = sorted({(a, b) for w in made.watch for a in w.a for b in w.b})
    events = [{"id": w.id, "a": w.a, "b": w.b, "after": w.after} for w in made.watch]
    manifest = manifest_to_json(
        made.scene,
        made.program,
        watch=pairs,
        dt=dt,
        extra={"unreal_class": made.emitted.name, "events": events},
    )
    files = write_class(made.emitted, Path(folder))
    (Path(folder) / "manifest.json").write_bytes(manifest_bytes(manifest))
    return CompiledScene(made.emitted.name, tuple(sorted([*files, "manifest.json"])))


def emit_document(
    doc: EsgDocument,
    *,
    scene: SimScene | None = None,
    program: Program | None = None,
    dt: float = VERIFY_DT_S,
) -> EmittedScene:
    """The class of a document, as text; arguments and errors as of `compile_scene`."""
    if scene is None:
        from esg.dynamics import build_scene

        scene = build_scene(doc)
    if program is None:
        program = document_program(doc, scene)
    watch = watch_list(doc, scene)
    return EmittedScene(scene, program, watch, emit_class(scene, program, watch=watch, dt=dt))


def write_class(emitted: EmittedClass, folder: Path) -> list[str]:
    """Writes a class into `folder`/unreal; returns the paths relative to `folder`."""
    target = folder / "unreal"
    target.mkdir(parents=True, exist_ok=True)
    for old in (*target.glob("EsgScene_*.h"), *target.glob("EsgScene_*.cpp")):
        if old.stem != emitted.name:
            old.unlink()
    texts = {
        f"{emitted.name}.h": emitted.header,
        f"{emitted.name}.cpp": emitted.source,
        "imports.json": emitted.imports_json,
    }
    for name, text in texts.items():
        temporary = target / f".{name}.{os.getpid()}.tmp"
        temporary.write_text(text, "utf-8", newline="\n")
        os.replace(temporary, target / name)
    remember(emitted.name, emitted.header, emitted.source, emitted.imports_json)
    return [f"unreal/{name}" for name in texts]


def document_program(doc: EsgDocument, scene: SimScene | None = None) -> Program:
    """The control program of a document; of a static scene only what its liquids do.

    Args:
        doc: A document with layout.
        scene: Its physical scene; without one, liquids of a static scene do nothing.
    """
    if doc.dynamics_result is None or not doc.dynamics_result.program:
        from esg.dynamics.plan.liquids import liquids
        from esg.dynamics.plan.postures import first_postures

        if scene is None:
            return Program((), STATIC_DURATION_S)
        primitives = (*first_postures(doc, scene), *liquids(doc, scene))
        made = any(b.gestures for b in scene.bodies)
        return Program(primitives, SEEN_S if made else STATIC_DURATION_S)
    return program_from_json(doc.dynamics_result.program)


def watch_list(doc: EsgDocument, scene: SimScene) -> tuple[WatchedEvent, ...]:
    """The collisions of a document's timeline, in causal order.

    A participant that is one of several with the same label ("bowling pins") stands for all of
    them. An event comes after the nearest collisions that lead to it.
    """
    if doc.timeline_system is None:
        return ()
    graph = doc.timeline_system.sequence_graph
    nodes = {n.id: n for n in graph.nodes}
    parents: dict[str, list[str]] = {n: [] for n in nodes}
    for edge in graph.edges:
        if edge.to in parents and edge.from_ in nodes:
            parents[edge.to].append(edge.from_)
    out: list[WatchedEvent] = []
    watched = {n.id for n in graph.nodes if _is_watched(n, scene)}
    for node in _causal_order(nodes, parents):
        if node.id not in watched:
            continue
        a, b = (_members(doc, scene, p) for p in node.participants[:2])
        after = tuple(sorted(_nearest(node.id, parents, watched)))
        out.append(WatchedEvent(node.id, a, tuple(n for n in b if n not in a), after))
    return tuple(out)


def _is_watched(node: TimelineNode, scene: SimScene) -> bool:
    names = {b.name for b in scene.bodies if b.collides}
    return (
        node.event is NodeEvent.COLLISION
        and len(node.participants) >= 2
        and node.participants[0] != node.participants[1]
        and all(p in names for p in node.participants[:2])
    )


def _members(doc: EsgDocument, scene: SimScene, name: str) -> tuple[str, ...]:
    """`name` and the bodies that the prompt does not tell apart from it."""
    nodes = doc.spatial_relation_graph.nodes
    node = nodes.get(name)
    if node is None or node.group is None:
        return (name,)
    same = tuple(
        b.name
        for b in scene.bodies
        if b.collides
        and b.name in nodes
        and nodes[b.name].group == node.group
        and nodes[b.name].label == node.label
    )
    return same if name in same else (name,)


def _causal_order(
    nodes: dict[str, TimelineNode], parents: dict[str, list[str]]
) -> Iterable[TimelineNode]:
    """Nodes after their parents; a cycle (no valid document has one) ends the walk."""
    done: set[str] = set()
    left = list(nodes)
    while left:
        ready = [n for n in left if all(p in done for p in parents[n])]
        if not ready:
            return
        for name in ready:
            yield nodes[name]
        done.update(ready)
        left = [n for n in left if n not in done]


def _nearest(name: str, parents: dict[str, list[str]], watched: set[str]) -> set[str]:
    out: set[str] = set()
    seen: set[str] = set()
    stack = list(parents[name])
    while stack:
        current = stack.pop()
        if current in seen:
            continue
        seen.add(current)
        if current in watched:
            out.add(current)
        else:
            stack += parents[current]
    return out
