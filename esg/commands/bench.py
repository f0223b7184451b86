"""`esg bench`: a suite over several seeds, judged against the suite."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from esg.commands.comparing.ablating import NOTHING, Ablating, ablate
from esg.commands.drafting import RULES, Drafting

if TYPE_CHECKING:
    from esg.pipeline import SceneState

MAX_RUNS = 1000
MISSED_LINES = 30


def bench(
    suite: Path,
    *,
    runs: int = 5,
    seed: int = 0,
    drafting: Drafting = RULES,
    strategy: Literal["batched", "hybrid", "fd", "ad", "none"] = "batched",
    engine: Literal["physx", "rapier", "newton"] = "physx",
    device: str = "cpu",
    close_loop: Annotated[bool, Parameter(negative="")] = False,
    collision: Literal["exact", "proxy", "sdf"] = "exact",
    out: Path | None = None,
    strict: Annotated[bool, Parameter(negative="")] = False,
    json: Annotated[Path | None, Parameter(help="Write the results to this JSON file.")] = None,
    workers: int | None = None,
    ablating: Ablating = NOTHING,
) -> int:
    """Run every scene of a suite with several seeds and report SLR, ECR and PPA.

    Args:
        suite: Suite file (YAML), or name of one that comes with the package: paper.
        runs: Seeds a scene: seed, seed + 1, ...
        seed: First seed.
        strategy: How the physics is searched; none keeps the first guess.
        engine: Engine of the replay: physx runs the emitted class.
        device: cpu or cuda:N.
        close_loop: Feed the verify engine's outcome error back to the search, three rounds at most;
            the figures of the open loop are reported too.
        collision: What bodies collide with during the search: exact (their parts), proxy (one
            sphere or box each), or sdf (that first, then signed distance fields).
        out: Folder of the scene folders; default runs/bench-SUITE-STRATEGY-ENGINE.
        strict: Count scenes as failed that are partial or not plausible.
        workers: Worker processes; default one a core.
    """
    if ablating.ablations is not None:
        return ablate(suite, ablating.ablations, (runs, seed, engine, device), out, json, workers)
    from esg.api import inputs
    from esg.commands.drafting import from_answers, tell_waiting
    from esg.commands.live import live
    from esg.files import write_json
    from esg.metrics import load_suite
    from esg.report.run import RUN_FILE
    from esg.runs import exit_code, record_run, results
    from esg.scenefolder import check_writable
    from esg.workers import default_processes

    loaded, device, *_ = inputs.checked(
        lambda: load_suite(suite),
        lambda: inputs.check_device(device),
        lambda: inputs.in_range("--runs", runs, 1, MAX_RUNS),
        lambda: inputs.check_seed(seed),
        lambda: inputs.check_workers(workers),
        lambda: None if out is None else check_writable(out),
        lambda: None if json is None else inputs.check_target("--json", json, "a JSON file"),
        drafting.check,
        inputs.check_cache,
    )
    kind = (loaded.suite, strategy, engine, close_loop, collision, drafting.drafter)
    out = _usual_folder(*kind) if out is None else out
    total = len(loaded.scenes) * runs
    processes = default_processes(total) if workers is None else workers
    asked = [scene.prompt for scene in loaded.scenes for _ in range(runs)]
    found = drafting.gathered(asked, [*range(seed, seed + runs)] * len(loaded.scenes))
    if found is not None and found.waiting:
        return tell_waiting(found, False)
    with from_answers(found), live(total) as bar:
        arguments = (str(suite), runs, seed, strategy, engine, device, close_loop, collision)
        states = _states(total, processes, (*arguments, drafting.drafter))
        bar.show("writing")
        _published(states, out, strict)
        bar.show("ingesting")
        run_id = record_run(states, "bench", suite=loaded.suite, seeds=runs)
        result = results(loaded, states, runs, seed, strategy, engine)
        result |= _beside(states, drafting.drafter, close_loop)
        # What `esg report` shows beside the scenes.
        write_json(out / RUN_FILE, {"run_id": run_id, **result})
    if json is not None:
        write_json(json, result)
    _tell(result, states, out)
    return exit_code(states, run_id is not None, strict=strict)


def _published(states: list[SceneState], out: Path, strict: bool) -> None:
    """Writes the scene folders, and which scenes failed."""
    from esg.failures import report_failures
    from esg.scenefolder import publish

    folders = [publish(state, out) for state in states]
    report_failures(states, folders, out, strict=strict)


def _beside(states: list[SceneState], drafter: str, close_loop: bool) -> dict[str, Any]:
    """What a run tells beside its figures."""
    from esg.costs.spent import spent

    out: dict[str, Any] = {
        "missed": missed(states),
        "not_kept": not_kept(states),
        "implausible": implausible(states),
        "cost": spent(s.log for s in states).to_json(),
    }
    if drafter != "rules":
        out["drafter"] = drafter
    return out | ({"closed_loop": closed_loop(states)} if close_loop else {})


def _states(total: int, processes: int, arguments: tuple[Any, ...]) -> list[SceneState]:
    """Final states of all runs: of the cache where it has all of them, else made in a flow."""
    from esg.pipeline import recall
    from esg.requests import bench_requests

    known = [recall(request) for request in bench_requests(*arguments)]
    states = [state for state in known if state is not None]
    if len(states) == total:
        return states
    from esg.commands.console import note_first_use
    from flows.session import session

    note_first_use()
    with session(processes) as call:
        from flows.benchmark import benchmark as flow

        return call(flow, *arguments)


def _tell(result: dict[str, Any], states: list[SceneState], out: Path) -> None:
    """Prints the results: the table, what was missed, what the closed loop changed."""
    from esg.costs.spent import line
    from esg.metrics import comparison_table
    from esg.pipeline import STAGES

    print(comparison_table(result), end="")
    for word in ("missed", "not_kept", "implausible"):
        print("".join(f"{line}\n" for line in missed_lines(result[word], word)), end="")
    if "closed_loop" in result:
        before, after = result["closed_loop"]["open"], result["closed_loop"]["closed"]
        print(
            f"closed loop: own events {before['completed']:.1%} -> {after['completed']:.1%}, "
            f"largest error {before['largest_error']:.2f} -> {after['largest_error']:.2f} "
            "tolerances"
        )
    cached = sum(s.cached_stages for s in states)
    print(line(result["cost"]))
    print(f"{cached} of {len(states) * len(STAGES)} stages from cache; scenes in {out}")


def _usual_folder(
    suite: str, strategy: str, engine: str, close_loop: bool, collision: str, drafter: str = "rules"
) -> Path:
    """Where scenes go that are sent nowhere else; it can be written."""
    from esg.files import safe_name
    from esg.scenefolder import check_writable

    name = f"bench-{safe_name(suite) or 'suite'}-{strategy}-{engine}" + (
        "-closed" if close_loop else ""
    )
    name = name if collision == "exact" else f"{name}-{collision}"
    folder = Path("runs") / (name if drafter == "rules" else f"{name}-{drafter}")
    check_writable(folder)
    return folder


def closed_loop(states: list[SceneState]) -> dict[str, Any]:
    """What the closed loop changed in the verify engine, by the scenes' own timelines.

    Mean share of completed events and largest error (in tolerances) of any prescribed quantity,
    for theta before (`open`) and after (`closed`).
    """
    from esg.stages import load_doc

    loops = [
        r.closed_loop
        for s in states
        if "optimize" in s.artifacts
        and (r := load_doc(s).dynamics_result) is not None
        and r.closed_loop is not None
    ]
    out: dict[str, Any] = {"scenes": len(loops), "rounds": [x.rounds for x in loops]}
    for name in ("open", "closed"):
        values = [getattr(x, name) for x in loops]
        out[name] = {
            "completed": sum(v["completed"] for v in values) / max(len(values), 1),
            "largest_error": max((v["largest_error"] for v in values), default=0.0),
        }
    return out


def missed(states: list[SceneState]) -> list[dict[str, Any]]:
    """What of the suite did not happen, with the judge's reason, whatever a scene's outcome.

    A scene can be `solved` by its own timeline and miss what the suite asks for.
    """
    from esg.runs import verdict_of

    rows: list[dict[str, Any]] = []
    for state in states:
        verdict = verdict_of(state)
        where = {"scene": state.request.name, "seed": state.request.seed}
        if verdict is None:
            rows.append({**where, "what": "all events", "reason": state.reason})
            continue
        rows += [
            {**where, "what": f"{event.id} ({event.type})", "reason": event.reason}
            for event in verdict.events
            if not event.completed
        ]
        rows += [
            {**where, "what": c.constraint, "reason": c.reason or _off(c.measured, c.target)}
            for c in verdict.constraints
            if c.score == 0.0
        ]
        rows += [
            {**where, "what": f"{s.id} ({s.says})", "reason": s.reason}
            for s in verdict.statements
            if s.kept is not True
        ]
        if not verdict.slr:
            reason = "; ".join(verdict.layout.faults)
            rows.append({**where, "what": "layout", "reason": reason})
    return rows


def not_kept(states: list[SceneState]) -> list[dict[str, Any]]:
    """What of their own prompts the scenes do not show (esg.fidelity), whatever the suite asks."""
    from esg.stages import not_kept as lost

    return [
        {
            "scene": state.request.name,
            "seed": state.request.seed,
            "what": f'"{row["words"]}"',
            **{k: row[k] for k in ("status", "reason")},
        }
        for state in states
        for row in lost(state)
    ]


def implausible(states: list[SceneState]) -> list[dict[str, Any]]:
    """Every check of plausibility that a replay does not pass."""
    from esg.metrics.plausibility import Check
    from esg.stages import plausibility

    return [
        {
            "scene": state.request.name,
            "seed": state.request.seed,
            "what": check["name"].replace("_", " "),
            "reason": Check.model_validate(check).text,
        }
        for state in states
        for check in (plausibility(state) or {}).get("checks", ())
        if not check["ok"]
    ]


def _off(measured: float | None, target: float | tuple[float, float]) -> str:
    asked = f"{target[0]:g} to {target[1]:g}" if isinstance(target, tuple) else f"{target:g}"
    return f"asked {asked}, " + ("not measured" if measured is None else f"measured {measured:.3g}")


def missed_lines(rows: list[dict[str, Any]], word: str = "missed") -> list[str]:
    """The same for people: one line for what several runs of a scene have in common.

    Args:
        rows: Of `missed`, `not_kept` or `implausible`.
        word: Which of them, for the beginning of every line.
    """
    common: dict[tuple[str, str, str], list[str]] = {}
    for row in rows:
        scene, _, run = row["scene"].rpartition("-run")
        parts = (row.get("status", "").replace("_", " "), row["reason"])
        common.setdefault((scene, row["what"], ": ".join(filter(None, parts))), []).append(run)
    begin = word.replace("_", " ")
    lines = [
        f"{begin}  {scene} run {', '.join(found)}: {what}: {why or 'no reason given'}"
        for (scene, what, why), found in common.items()
    ]
    if len(lines) > MISSED_LINES:
        rest = len(lines) - MISSED_LINES
        lines = [*lines[:MISSED_LINES], f"{begin}  {rest} more; --json FILE lists all"]
    return lines
