"""One scene from prompt to recorded result: ten stages, each cached by content.

    draft -> resolve -> cast -> layout -> optimize -> compile -> replay -> judge -> dress -> record

A stage's result is a folder in the artifact store under a key made of its input's content, its
configuration and the version of its code. A `SceneState` carries only keys, so that it can travel
between processes and through a scheduler; the data stays in the store. Nothing here knows about
schedulers: `tasks/` calls `run_stage` for batches of scenes.
"""

from __future__ import annotations

from collections.abc import Callable, Generator, Sequence
import contextlib
from dataclasses import dataclass, field, replace
import errno
import hashlib
import json
from pathlib import Path
import time
import traceback
from typing import TYPE_CHECKING, Any, TypeVar

from esg.costs.spent import core_time
from esg.machine.companion import spent_s
from esg.outcomes import Outcome, UserError
from esg.paths import cache_dir
from esg.progress import StageEvent, emit
from esg.strangers.scrubbing import scrub_all

if TYPE_CHECKING:
    from esg.store.artifacts import ArtifactStore

_Result = TypeVar("_Result")
STAGES = (
    "draft",
    "resolve",
    "cast",
    "layout",
    "optimize",
    "compile",
    "replay",
    "judge",
    "dress",
    "record",
)

_PASSING = {
    errno.EAGAIN,
    errno.EBUSY,
    errno.EINTR,
    errno.EIO,
    errno.EMFILE,
    errno.ENFILE,
    errno.ESTALE,
    errno.ETIMEDOUT,
}


@dataclass(frozen=True)
class SceneRequest:
    """What to make and how; everything a result depends on besides code.

    Args:
        prompt: English text.
        seed: Of every random choice.
        drafter: rules or llm.
        strategy: Search strategy of the optimize stage.
        device: cpu or cuda:N.
        engine: Engine of the replay: physx (the emitted class), rapier or newton (the program).
        suite_scene: JSON of the suite's scene to judge against; empty judges against the scene's
            own timeline.
        name: Folder name of the scene; empty takes the document's scene id.
        close_loop: Whether the verify engine's outcome error is fed back to the search.
        collision: What bodies collide with during the search: exact, proxy or sdf.
        traffic: Side of the road that vehicles keep to: right or left.
        document: A scene graph (JSON) of `prompt` that somebody has changed, in place of a draft.
        without: What is left out for an ablation: global, initial or generation; empty: nothing.
    """

    prompt: str
    seed: int = 0
    drafter: str = "rules"
    strategy: str = "batched"
    device: str = "cpu"
    engine: str = "physx"
    suite_scene: str = ""
    name: str = ""
    close_loop: bool = False
    collision: str = "exact"
    traffic: str = "right"
    document: str = ""
    without: str = ""

    @property
    def choreographed(self) -> bool:
        """Whether planned motion asks the layout for starts; `none` leaves all of stage 4 out."""
        return self.strategy != "none"


@dataclass(frozen=True)
class SceneState:
    """How far a scene has come: artifact keys by stage, and what happened on the way.

    Args:
        request: What was asked.
        artifacts: Stage name to artifact key, in stage order.
        log: One entry a stage: stage, cached, seconds, and what went wrong.
        outcome: Set when the scene has ended, early or not.
        reason: One sentence with the outcome.
        user_error: Whether the reason is a mistake the user can repair.
    """

    request: SceneRequest
    artifacts: dict[str, str] = field(default_factory=dict)
    log: tuple[dict[str, Any], ...] = ()
    outcome: Outcome | None = None
    reason: str = ""
    user_error: bool = False

    @property
    def ended(self) -> bool:
        """Whether no further stage can run."""
        return self.outcome in (Outcome.INVALID_DRAFT, Outcome.CRASHED, Outcome.INFEASIBLE)

    @property
    def cached_stages(self) -> int:
        """Number of stages whose result came from the store."""
        return sum(bool(e.get("cached")) for e in self.log)

    @property
    def seconds(self) -> float:
        """Time spent in stages [s]."""
        return sum(float(e["seconds"]) for e in self.log)

    def artifact(self, stage: str) -> Path:
        """Folder of a finished stage.

        Raises:
            KeyError: If the stage has not run.
        """
        found = artifact_store().find(self.artifacts[stage])
        if found is None:
            raise FileNotFoundError(
                errno.ENOENT, f"the {stage} artifact vanished", self.artifacts[stage]
            )
        return found


_store_root: Path | None = None
_durable = True


def artifact_store() -> ArtifactStore:
    """The store that stages read and write."""
    from esg.store.artifacts import ArtifactStore

    return ArtifactStore(_store_root, durable=_durable)


@contextlib.contextmanager
def scratch_store(root: Path, *, durable: bool = True) -> Generator[None]:
    """Makes this process use another store for the body: nothing of the usual one is found.

    What is known of its artifacts is forgotten: their folder goes with the batch.

    Args:
        root: Folder of the store.
        durable: As of `esg.store.artifacts.ArtifactStore`.
    """
    from esg.store.artifacts import forget

    global _store_root, _durable
    before = _store_root, _durable
    _store_root, _durable = root, durable
    try:
        yield
    finally:
        _store_root, _durable = before
        forget(root)


def content_hash(folder: Path) -> str:
    """Hash of an artifact's files: equal results are one, whichever code version made them."""
    from esg.store.artifacts import MARK

    files = json.loads((folder.parent / MARK).read_bytes())["files"]
    return hashlib.sha256(json.dumps(files, sort_keys=True).encode()).hexdigest()


def stage_key(stage: str, state: SceneState) -> str:
    """Artifact key of a stage: its inputs, its configuration and its code version."""
    from esg.codeversion import code_version
    from esg.stages import SPECS, configuration
    from esg.store.artifacts import artifact_key

    inputs = {s: content_hash(state.artifact(s)) for s in SPECS[stage].inputs}
    return artifact_key(
        stage,
        inputs=inputs,
        config=configuration(stage, state.request),
        code_version=code_version(stage),
    )


def run_stage(stage: str, state: SceneState) -> SceneState:
    """Runs one stage of one scene, or finds its finished result.

    Returns:
        The next state. Mistakes in the input end the scene as `invalid_draft`, defects as
        `crashed`; neither raises.

    Raises:
        OSError: One that may pass (see `may_pass`): try the stage again; or the remedy for a disk
            that cannot be written: no fault of the scene, which therefore does not end.
    """
    from esg.stages import SPECS, conclude

    if state.ended or stage in state.artifacts:
        return state
    this = _begun(stage, state)
    try:
        key = this.look_up(state)
        if not this.entry["cached"]:
            artifact_store().create(key, lambda folder: SPECS[stage].run(state, folder))
        state = replace(state, artifacts={**state.artifacts, stage: key})
        outcome, reason = conclude(stage, state)
        if outcome is not None:
            state = replace(state, outcome=outcome, reason=reason)
    except Exception as error:
        state = this.failed(state, error)
    return this.ended(state)


@dataclass
class _Attempt:
    """A stage that is being run: its line of the log, and when it began."""

    entry: dict[str, Any]
    start: float
    core_start: float

    def look_up(self, state: SceneState) -> str:
        """The key of the stage's result; notes it, and whether the result is in the store."""
        stage = self.entry["stage"]
        key = self.entry["key"] = stage_key(stage, state)
        self.entry["cached"] = artifact_store().find(key) is not None
        if not self.entry["cached"]:
            _quiet_libraries(stage)
        return key

    def failed(self, state: SceneState, error: Exception) -> SceneState:
        """The state after an error; raises one that ends no scene."""
        from esg.files import explained, unwritable

        if isinstance(error, UserError):
            reason = self.entry["error"] = scrub_all(str(error))
            return replace(state, outcome=Outcome.INVALID_DRAFT, reason=reason, user_error=True)
        if may_pass(error):
            raise error
        if unwritable(error):
            assert isinstance(error, OSError)
            raise explained(error, Path(error.filename or cache_dir())) from error
        state = crashed(state, error)
        self.entry["error"] = state.reason
        self.entry["traceback"] = scrub_all("".join(traceback.format_exception(error)))
        return state

    def ended(self, state: SceneState) -> SceneState:
        """The state with the stage's line in its log; whoever listens is told."""
        self.entry["seconds"] = round(time.perf_counter() - self.start, 4)
        self.entry["core_seconds"] = round(core_time() + spent_s() - self.core_start, 4)
        if state.outcome is not None:
            self.entry["outcome"] = state.outcome.value
        state = replace(state, log=(*state.log, dict(self.entry)))
        emit(finished_event(state))
        return state


def _begun(stage: str, state: SceneState) -> _Attempt:
    emit(StageEvent(state.request.name or state.request.prompt, stage, "started",
                    state.request.seed))  # fmt: skip
    entry: dict[str, Any] = {"stage": stage, "cached": False}
    return _Attempt(entry, time.perf_counter(), core_time() + spent_s())


@dataclass
class Unfinished:
    """A record that lacks its pictures.

    Args:
        state: The scene with all of its log but what the pictures take; the key of its record is
            there, the artifact is not.
        folder: What there is of the record, beside pictures that are being drawn.
    """

    state: SceneState
    folder: Path
    _draw: Callable[[], object]
    _held: contextlib.ExitStack

    def finish(self) -> SceneState:
        """Draws the pictures and stores the record.

        Returns:
            The final state; only times in its log differ from that of `run_stage`.

        Raises:
            Exception: Whatever keeps them from being drawn; nothing is stored then.
        """
        start, core_start = time.perf_counter(), core_time() + spent_s()
        with self._held:
            self._draw()
        *before, entry = self.state.log
        took = {
            "seconds": time.perf_counter() - start,
            "core_seconds": core_time() + spent_s() - core_start,
        }
        entry = entry | {name: round(entry[name] + value, 4) for name, value in took.items()}
        return replace(self.state, log=(*before, entry))

    def drop(self) -> None:
        """Draws no pictures and leaves nothing of the record."""
        error = RuntimeError("dropped")
        with contextlib.suppress(RuntimeError):
            self._held.__exit__(RuntimeError, error, None)


def begin_record(state: SceneState) -> tuple[SceneState, Unfinished | None]:
    """Runs the last stage but for its pictures, which are left to be drawn.

    Args:
        state: A scene that is dressed, or has ended.

    Returns:
        The state after the stage, and what is left of it; None if nothing is: the record was in
        the store, or the scene has ended.

    Raises:
        OSError: As of `run_stage`.
    """
    from esg.stages import recording

    stage = STAGES[-1]
    if state.ended or stage in state.artifacts:
        return state, None
    this = _begun(stage, state)
    rest = None
    try:
        with contextlib.ExitStack() as held:
            key = this.look_up(state)
            if not this.entry["cached"]:
                folder = held.enter_context(artifact_store().making(key))
                draw = held.enter_context(recording(state, folder, later=True))
                rest = Unfinished(state, folder, draw, held.pop_all())
        state = replace(state, artifacts={**state.artifacts, stage: key})
    except Exception as error:
        state = this.failed(state, error)
    state = this.ended(state)
    if rest is not None:
        rest.state = state
    return state, rest


def finished_event(state: SceneState) -> StageEvent:
    """The event of the last stage in a scene's log."""
    entry = state.log[-1]
    return StageEvent(
        scene=state.request.name or state.request.prompt,
        stage=entry["stage"],
        status="finished",
        seed=state.request.seed,
        seconds=float(entry["seconds"]),
        cached=bool(entry["cached"]),
        outcome=state.outcome.value if state.outcome else "",
        reason=state.reason,
    )


def _quiet_libraries(stage: str) -> None:
    """Initializes warp without its banner before a stage does so with it."""
    if stage not in ("draft", "resolve", "cast", "optimize"):
        from esg.engines.newton import quiet_warp

        quiet_warp()


def crashed(state: SceneState, error: BaseException, stage: str = "") -> SceneState:
    """The state of a scene ended by a defect; with `stage`, also logs it there."""
    reason = scrub_all(f"{type(error).__name__}: {error}")
    state = replace(state, outcome=Outcome.CRASHED, reason=reason)
    if stage:
        lines = scrub_all("".join(traceback.format_exception(error)))
        entry = {
            "stage": stage,
            "cached": False,
            "seconds": 0.0,
            "error": reason,
            "traceback": lines,
            "outcome": Outcome.CRASHED.value,
        }
        state = replace(state, log=(*state.log, entry))
    return state


def may_pass(error: BaseException) -> bool:
    """Whether trying again can help: connections, timeouts and busy files, nothing else."""
    if isinstance(error, (ConnectionError, TimeoutError)):
        return True
    return isinstance(error, OSError) and error.errno in _PASSING


def retried(run: Callable[[], _Result], pauses: Sequence[float]) -> _Result:
    """What a function returns; after an error that may pass it is called again.

    Args:
        run: Takes nothing.
        pauses: Before each further call [s].

    Raises:
        OSError: One that does not pass, or the last.
    """
    for pause in pauses:
        try:
            return run()
        except OSError as error:
            if not may_pass(error):
                raise
        time.sleep(pause)
    return run()


def recall(request: SceneRequest) -> SceneState | None:
    """The final state of a scene whose every stage is in the store; None if one would compute."""
    state = SceneState(request)
    for stage in STAGES:
        try:
            if artifact_store().find(stage_key(stage, state)) is None:
                return None
        except OSError:
            return None
        state = run_stage(stage, state)
        if state.ended:
            return state if state.outcome is not Outcome.CRASHED else None
    return state


def run_scene(request: SceneRequest) -> SceneState:
    """All stages of one scene, in this process and without a scheduler."""
    state = SceneState(request)
    for stage in STAGES:
        state = run_stage(stage, state)
    return state


def failures(states: Sequence[SceneState], *, strict: bool = False) -> list[dict[str, Any]]:
    """One row for every scene that did not end well: the lines of `failures.jsonl`.

    Args:
        states: Scenes that have ended.
        strict: Whether what is `partial` or not plausible counts as a failure.
    """
    return [
        {
            "scene": s.request.name or s.request.prompt,
            "prompt": s.request.prompt,
            "seed": s.request.seed,
            "outcome": s.outcome.value if s.outcome else "unfinished",
            "reason": s.reason or (f"implausible: {implausible(s)}" if implausible(s) else ""),
            "stage": failed_stage(s),
        }
        for s in states
        if not good(s, strict=strict)
    ]


def failed_stage(state: SceneState) -> str:
    """The stage that decided how a scene ended: later ones only carry its outcome on."""
    ended = state.outcome.value if state.outcome else None
    for entry in state.log:
        if ended is not None and entry.get("outcome") == ended:
            return str(entry["stage"])
    return str(state.log[-1]["stage"]) if state.log else ""


def good(state: SceneState, *, strict: bool = False) -> bool:
    """Whether a scene ended with a compiled scene that does what it claims.

    Args:
        state: The scene.
        strict: Whether it must also show all that its prompt says, and be plausible.
    """
    if state.outcome is None:
        return False
    if strict and (state.outcome is Outcome.PARTIAL or implausible(state)):
        return False
    return state.outcome.is_good


def implausible(state: SceneState) -> str:
    """The worst that a scene's replay shows and nature does not; empty if it is plausible."""
    from esg.stages import plausibility

    found = plausibility(state)
    return found["worst"] if found else ""
