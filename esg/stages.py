"""What each stage of the pipeline reads, does and writes (esg.pipeline runs and caches them)."""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
from concurrent.futures import ThreadPoolExecutor
import contextlib
from dataclasses import dataclass
from functools import partial
import json
import os
from pathlib import Path
from typing import TYPE_CHECKING, Any

from esg.fidelity import Row, lost_in, sentence, shortfalls, statement_rows, unplaced, unsettled
from esg.outcomes import Outcome

if TYPE_CHECKING:
    from esg.engines.scene import Rollout
    from esg.graph.models import EsgDocument
    from esg.metrics.models import SceneVerdict, SuiteScene
    from esg.pipeline import SceneRequest, SceneState

DOCUMENT = "esg.json"
ROLLOUT = "rollout.npz"
PICTURES = ("preview.mp4", "preview.png")
"""Of a record, what takes most of its time and no proof needs: film and contact sheet."""
REPLAY_RATE_HZ = 240
LEFT_OUT = {"resolve": ("generation",), "layout": ("global", "initial")}
"""What an ablation leaves out of a stage (`SceneRequest.without`)."""
CLOSED_ROUNDS = 3
"""Most rounds of the closed loop, where it is asked for."""


@dataclass(frozen=True)
class Spec:
    """One stage.

    Args:
        run: Writes the result into an empty folder.
        inputs: Stages whose artifacts it reads.
        options: Fields of the request that change its result.
    """

    run: Callable[[SceneState, Path], None]
    inputs: tuple[str, ...]
    options: tuple[str, ...] = ()


def configuration(stage: str, request: SceneRequest) -> dict[str, Any]:
    """The part of a request that a stage's result depends on."""
    values: dict[str, Any] = {name: getattr(request, name) for name in SPECS[stage].options}
    if request.without in LEFT_OUT.get(stage, ()):
        values["without"] = request.without
    if stage == "replay":
        values["proof"] = proof_kind(request.engine)
    if stage == "draft" and request.drafter != "rules" and not request.document:
        from esg.draft.llm.settings import identity

        values["model"] = identity()  # another model, or other recorded replies: another draft
    return values


def proof_kind(engine: str) -> str:
    """`class` if the emitted class itself is replayed, `program` if its control program is.

    The class needs PhysX (the shim's engine) and a C++ compiler.
    """
    if engine != "physx":
        return "program"
    from esg.compile import CompilerMissing
    from esg.compile.build import compiler

    try:
        compiler()
    except CompilerMissing:
        return "program"
    return "class"


def conclude(stage: str, state: SceneState) -> tuple[Outcome | None, str]:
    """The outcome a finished stage implies, None while the scene goes on.

    `solved` and `nearest_feasible` are claims of the optimizer; they stand only if the replay of
    the compiled scene completes the events of the scene's own timeline. What is `solved` but does
    not show all that its prompt says is `partial` (esg.fidelity).
    """
    if stage == "draft":
        violations = json.loads((state.artifact(stage) / "violations.json").read_bytes())
        if violations:
            first = violations[0]
            more = f" (and {len(violations) - 1} more)" if len(violations) > 1 else ""
            return Outcome.INVALID_DRAFT, f"{first['code']}: {first['message']}{more}"
        return None, ""
    if stage == "optimize":
        result = load_doc(state, stage).dynamics_result
        if result is not None and result.outcome == Outcome.INFEASIBLE.value:
            return Outcome.INFEASIBLE, result.reason
        return None, ""
    if stage != "judge":
        return None, ""
    metrics = json.loads((state.artifact(stage) / "metrics.json").read_bytes())
    return Outcome(metrics["outcome"]), metrics["reason"]


def load_doc(state: SceneState, stage: str = "optimize") -> EsgDocument:
    """The document as a stage left it."""
    from esg.graph import EsgDocument

    return EsgDocument.model_validate_json((state.artifact(stage) / DOCUMENT).read_bytes())


def load_scene(state: SceneState) -> tuple[Any, Any]:
    """Physical scene and control program of a compiled scene."""
    from esg.engines.manifest import load_manifest

    manifest = load_manifest(state.artifact("compile") / "manifest.json")
    return manifest.scene, manifest.program


def load_verdict(state: SceneState) -> SceneVerdict:
    """The judge's verdict: against the suite if there is one, else against the own timeline."""
    metrics = json.loads((state.artifact("judge") / "metrics.json").read_bytes())
    return _read_verdict(metrics["verdict"])


def plausibility(state: SceneState) -> dict[str, Any] | None:
    """What the judge wrote of a scene's plausibility; None if it did not come to that."""
    if "judge" not in state.artifacts:
        return None
    return json.loads((state.artifact("judge") / "metrics.json").read_bytes()).get("plausibility")


def not_kept(state: SceneState) -> list[Row]:
    """What of its prompt a scene does not show, as far as it came (esg.fidelity)."""
    if "judge" in state.artifacts:
        metrics = json.loads((state.artifact("judge") / "metrics.json").read_bytes())
        return lost_in({}, metrics)
    if "draft" in state.artifacts:
        return lost_in(json.loads((state.artifact("draft") / DOCUMENT).read_bytes()), None)
    return []


def _read_verdict(data: dict[str, Any]) -> SceneVerdict:
    from esg.metrics import SceneVerdict

    return SceneVerdict.from_json(data)


def load_suite_scene(request: SceneRequest, doc: EsgDocument) -> tuple[SuiteScene, bool]:
    """What to judge against, and whether it is a suite's (else the scene's own timeline)."""
    from esg.metrics import SuiteScene, expectations_from_timeline

    if request.suite_scene:
        return SuiteScene.model_validate_json(request.suite_scene), True
    return expectations_from_timeline(doc), False


def _draft(state: SceneState, folder: Path) -> None:
    from esg.draft import draft
    from esg.graph import EsgDocument, verify

    request = state.request
    if request.document:
        doc = EsgDocument.model_validate_json(request.document)
    else:
        doc = draft(request.prompt, seed=request.seed, drafter=request.drafter)
    if request.traffic != "right":
        scene = doc.scene_definition.model_copy(update={"traffic": request.traffic})
        doc = doc.model_copy(update={"scene_definition": scene})
    write_doc(doc, folder)
    _write_json([v.to_json() for v in verify(doc)], folder / "violations.json")


def _resolve(state: SceneState, folder: Path) -> None:
    from esg.assets import resolve

    request = state.request
    doc = resolve(
        load_doc(state, "draft"), seed=request.seed, retrieval_only=request.without == "generation"
    )
    write_doc(doc, folder)


def _cast(state: SceneState, folder: Path) -> None:
    from esg.dynamics import cast

    write_doc(cast(load_doc(state, "resolve"), seed=state.request.seed), folder)


def _layout(state: SceneState, folder: Path) -> None:
    from esg.layout import LayoutConfig, solve, stored_hints

    without = state.request.without
    config = LayoutConfig()
    if without == "global":
        # Greedy: what was placed first stays where it is, and nobody starts again.
        config = LayoutConfig(refine=False, rounds=1)
    elif without == "initial":
        config = LayoutConfig(sample_init=False, preference=False, rounds=1)
    doc = load_doc(state, "cast")
    told = doc.choreography if state.request.choreographed else None
    hints = None if told is None else stored_hints(told)
    write_doc(solve(doc, seed=state.request.seed, hints=hints, config=config), folder)


def _optimize(state: SceneState, folder: Path) -> None:
    from esg.machine.companion import done_elsewhere

    done_elsewhere(partial(_search, state, folder))


def _search(state: SceneState, folder: Path) -> None:
    from esg.dynamics import optimize
    from esg.engines.newton import quiet_warp

    quiet_warp()
    doc = load_doc(state, "layout")
    request = state.request
    if doc.timeline_system is not None:
        doc = optimize(
            doc,
            seed=request.seed,
            strategy=request.strategy,
            device=request.device,
            rounds_closed=CLOSED_ROUNDS if request.close_loop else 0,
            collision=request.collision,
        )
    write_doc(doc, folder)


def _compile(state: SceneState, folder: Path) -> None:
    from esg.compile import compile_scene

    compile_scene(load_doc(state), folder)


def _replay(state: SceneState, folder: Path) -> None:
    from esg.engines.rollout_file import save_rollout

    proof = proof_kind(state.request.engine)
    log: list[str] = []
    if proof == "class":
        from esg.compile import replay_class

        _beside_compiler(state)
        replay = replay_class(
            state.artifact("compile"), dt=1.0 / REPLAY_RATE_HZ, document=partial(load_doc, state)
        )
        rollout, log = replay.rollout, replay.log
    else:
        rollout = _replay_program(state)
    save_rollout(rollout, folder / ROLLOUT)
    facts = {"engine": rollout.engine, "dt_s": rollout.dt, "proof": proof, "log": log}
    _write_json(facts, folder / "replay.json")


def _beside_compiler(state: SceneState) -> None:
    """Has the class compiled and does here meanwhile what need not wait for its replay.

    Where one scene is made by itself; a batch keeps all cores busy without.
    """
    from esg.machine.beside import may_fork
    from esg.machine.companion import handed, load_rest

    if not may_fork():
        return
    drawn = partial(_draw_assets, state)
    with ThreadPoolExecutor(1) as pool, handed(drawn):
        compiled = pool.submit(_compile_class, state)  # what it complains of the replay tells
        with contextlib.suppress(Exception):  # told by the stage that needs it
            drawn()
        load_rest(compiled.done)


def _compile_class(state: SceneState) -> None:
    from esg.compile.replay import compile_ours

    compile_ours(state.artifact("compile"), partial(load_doc, state))


def _draw_assets(state: SceneState) -> None:
    """Draws what the record will ask for into this process's memory: assets and their textures."""
    from esg.assets.geometry.mesh import meshes_of

    for _ in meshes_of(load_doc(state)):
        pass


def _replay_program(state: SceneState) -> Rollout:
    from esg.engines.program import batch_programs
    from esg.engines.registry import get_engine

    scene, program = load_scene(state)
    engine = get_engine(state.request.engine, state.request.device)
    batch = batch_programs([program], scene.names)
    return engine.rollout(scene, batch, dt=1.0 / REPLAY_RATE_HZ)


_READ = {
    "coverage": True,
    "statements": True,
    "layout_result": {"relations", "patterns", "poses"},
    "timeline_system": {"sequence_graph": {"edges"}},
    "spatial_relation_graph": {"nodes"},
    "scene_definition": {"original_description"},
}
"""Of a document, what says what became of the prompt, and where who starts."""


def _judge(state: SceneState, folder: Path) -> None:
    from esg.engines.rollout_file import load_rollout
    from esg.metrics import expectations_from_timeline, judge
    from esg.metrics.plausibility import assess, told_of

    doc = load_doc(state)
    played = *load_scene(state), load_rollout(state.artifact("replay") / ROLLOUT)
    expected, from_suite = load_suite_scene(state.request, doc)
    verdict = judge(*played, expected)
    own = judge(*played, expectations_from_timeline(doc)) if from_suite else verdict
    said = doc.model_dump(mode="json", include=_READ)
    statements = statement_rows(said, [s.model_dump(mode="json") for s in own.statements])
    plausibility = assess(*played, told_of(doc)).to_json()
    lost = [*unplaced(said), *shortfalls(said, statements)]
    if doc.timeline_system is None:
        lost += unsettled(said, plausibility["checks"])
    outcome, reason = _outcome(doc, own, lost)
    facts = json.loads((state.artifact("replay") / "replay.json").read_bytes())
    metrics = {
        "outcome": outcome.value,
        "reason": reason,
        "advice": outcome.advice,
        "proof": facts["proof"],
        "judged_against": "suite" if from_suite else "timeline",
        "verified": own.verified,
        "verdict": verdict.to_json(),
        "plausibility": plausibility,
    }
    if from_suite:
        metrics["own_timeline"] = own.to_json()
    # The prompt's own statements, whatever a suite asks for; without any nothing is written.
    metrics |= {k: v for k, v in (("statements", statements), ("not_kept", lost)) if v}
    _write_json(metrics, folder / "metrics.json")


def _outcome(doc: EsgDocument, own: SceneVerdict, lost: Sequence[Row] = ()) -> tuple[Outcome, str]:
    """How a replayed scene ended.

    Args:
        doc: With the optimizer's claim.
        own: The verdict by the scene's own timeline.
        lost: What of the prompt is not shown.
    """
    from esg.draft.document.coverage import NOTHING_HAPPENS

    failures = [f"{e.id} ({e.type}): {e.reason}" for e in own.events if not e.completed]
    if not own.slr:
        failures = [*own.layout.faults, *failures]
    result = doc.dynamics_result
    claimed = Outcome(result.outcome) if result is not None else Outcome.SOLVED
    reason = result.reason if result is not None else ""
    layout = doc.layout_result
    if layout is not None and not layout.feasible and own.layout.faults:
        return Outcome.NOT_CONVERGED, "no layout was found: " + "; ".join(own.layout.faults)
    if claimed in (Outcome.SOLVED, Outcome.NEAREST_FEASIBLE) and failures:
        return Outcome.NOT_CONVERGED, "the replay disagrees: " + "; ".join(failures)
    unread = [w for w in doc.coverage.warnings if w.startswith(NOTHING_HAPPENS)]
    if claimed is Outcome.SOLVED and unread:
        return Outcome.NOT_CONVERGED, unread[0]
    if claimed is Outcome.SOLVED and lost:
        return Outcome.PARTIAL, sentence(lost)
    return claimed, reason


def _dress(state: SceneState, folder: Path) -> None:
    from esg.dressing import dress
    from esg.engines.rollout_file import load_rollout

    scene, _ = load_scene(state)
    rollout = load_rollout(state.artifact("replay") / ROLLOUT)
    write_doc(dress(load_doc(state), scene, rollout, seed=state.request.seed), folder)


def _record(state: SceneState, folder: Path) -> None:
    with recording(state, folder) as draw:
        draw()


@contextlib.contextmanager
def recording(
    state: SceneState, folder: Path, *, later: bool = False
) -> Generator[Callable[[], object]]:
    """Writes what is cheap of a record: meshes, exports, the log of the replay.

    Args:
        state: A scene that is dressed.
        folder: Receives the files.
        later: Whether nobody waits for the pictures (`PICTURES`): what draws them beside the body
            has low priority.

    Yields:
        A function that draws what is left of the pictures; to be called in the body.
    """
    from esg.assets import write_meshes
    from esg.compile.export import export, thinned
    from esg.engines.rollout_file import load_rollout
    from esg.machine.answering import lowly
    from esg.machine.beside import beside
    from esg.machine.companion import handed
    from esg.store.mcap_log import write_mcap
    from esg.view.preview import film, preview
    from esg.view.setting import setting_of

    doc = load_doc(state, "dress")
    scene, program = load_scene(state)
    rollout = load_rollout(state.artifact("replay") / ROLLOUT)
    metrics = json.loads((state.artifact("judge") / "metrics.json").read_bytes())
    verdict = load_verdict(state)
    shown = verdict
    if not verdict.events and "own_timeline" in metrics:
        shown = _read_verdict(metrics["own_timeline"])  # a suite that asks for nothing
    played = thinned(rollout)
    filming = partial(film, scene, rollout, shown, doc, folder)
    if later:
        filming = partial(lowly, filming, os.getpid())
    with (
        handed(filming) as there,
        beside(filming) if there is None else contextlib.nullcontext(there) as filmed,
    ):
        setting = setting_of(scene, played, shown, doc)
        write_meshes(doc, folder)
        # Exports read a scene folder: lend them the manifest, which belongs to another stage.
        manifest = folder / "manifest.json"
        manifest.write_bytes((state.artifact("compile") / manifest.name).read_bytes())

        def usd() -> None:
            export(folder, "usd", rollout=played, setting=setting)

        # The film is drawn meanwhile; it makes way for the dearest export if nobody waits for it.
        with beside(usd) if later else contextlib.nullcontext(usd) as written:
            export(folder, "glb", rollout=played, setting=setting)
            written()
        manifest.unlink()
        write_mcap(folder / "rollout.mcap", scene, program, rollout, verdict, doc)
        note = f"{metrics['outcome']}  |  replayed in {rollout.engine} at {1 / rollout.dt:.0f} Hz"
        yield partial(preview, scene, rollout, shown, doc, folder, note=note, lost=filmed)


def write_doc(doc: EsgDocument, folder: Path) -> None:
    """Writes a document as a stage leaves it."""
    from esg.graph import canonical_json

    (folder / DOCUMENT).write_bytes(canonical_json(doc))


def _write_json(value: Any, path: Path) -> None:
    text = json.dumps(value, indent=2, sort_keys=True, ensure_ascii=False, allow_nan=False)
    path.write_text(text + "\n", encoding="utf-8")


SPECS: dict[str, Spec] = {
    "draft": Spec(_draft, (), ("prompt", "seed", "drafter", "traffic", "document")),
    "resolve": Spec(_resolve, ("draft",), ("seed",)),
    "cast": Spec(_cast, ("resolve",), ("seed",)),
    "layout": Spec(_layout, ("cast",), ("seed", "choreographed")),
    "optimize": Spec(
        _optimize, ("layout",), ("seed", "strategy", "device", "close_loop", "collision")
    ),
    "compile": Spec(_compile, ("optimize",)),
    "replay": Spec(_replay, ("compile",), ("engine",)),
    "judge": Spec(_judge, ("optimize", "compile", "replay"), ("suite_scene",)),
    "dress": Spec(_dress, ("optimize", "compile", "replay"), ("seed",)),
    "record": Spec(_record, ("dress", "compile", "replay", "judge")),
}
