"""`esg generate`: a prompt to a proven scene folder."""

from __future__ import annotations

from collections.abc import Sequence
import contextlib
from functools import partial
from pathlib import Path
import re
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from esg.commands.drafting import RULES, Drafting

if TYPE_CHECKING:
    from esg.pipeline import SceneRequest, SceneState, Unfinished
    from esg.view.seeing.wanted import Settings

Strategy = Literal["batched", "hybrid", "fd", "ad", "none"]
Collision = Literal["exact", "proxy", "sdf"]
ASSUMED = 0.5
"""Confidence up to which a drafted heading is a default and no wish."""


def generate(
    prompt: str,
    *,
    out: Path = Path("runs"),
    seed: int = 0,
    drafting: Drafting = RULES,
    strategy: Strategy = "batched",
    device: str = "cpu",
    close_loop: Annotated[bool, Parameter(negative="")] = False,
    collision: Collision = "exact",
    traffic: Literal["right", "left"] = "right",
    render: str = "",
    wait: bool | None = None,
    strict: Annotated[bool, Parameter(negative="")] = False,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Generate one scene and prove it by replaying what was emitted.

    With a warm worker (esg up) or --no-wait, the outcome is told as soon as it is proven: film and
    contact sheet follow in the scene folder, which is complete once it has its SHA256SUMS.

    Args:
        prompt: English description of the scene.
        out: Folder that receives the scene folder.
        seed: Of every random choice.
        strategy: How the physics is searched; none keeps the first guess.
        device: cpu or cuda:N.
        close_loop: Feed the verify engine's outcome error back to the search, three rounds at most.
        collision: What bodies collide with during the search: exact (their parts), proxy (one
            sphere or box each), or sdf (that first, then signed distance fields).
        traffic: Side of the road that vehicles keep to.
        render: Ground-truth channels to render into the scene folder at 256x256 and 24 frames a
            second, with commas, or all; esg render has further options.
        wait: Whether the command ends with the whole folder written, pictures included; default so
            without a warm worker. With --render it always does.
        strict: Count a scene as failed that is partial (not all is shown) or not plausible.
        json: Print one JSON document with outcome, metrics and paths.
    """
    from esg.api.inputs import check_cache, check_device, check_seed, checked, clean_prompt
    from esg.commands.console import emit
    from esg.commands.drafting import from_answers, tell_waiting
    from esg.runs import exit_code
    from esg.scenefolder import check_writable

    prompt, _, device, seed, pictures, *_ = checked(
        lambda: clean_prompt(prompt),
        lambda: check_writable(out),
        lambda: check_device(device),
        lambda: check_seed(seed),
        lambda: _pictures(render) if render else None,
        drafting.check,
        check_cache,
    )
    found = drafting.gathered([prompt], [seed])
    if found is not None and found.waiting:
        return tell_waiting(found, json)
    arguments = ([prompt], seed, drafting.drafter, strategy, device, close_loop, collision, traffic)
    waits = bool(wait) or pictures is not None or device != "cpu"
    with from_answers(found):
        state, folder, recorded, finishing = _made(arguments, out, waits=waits, strict=strict)
    summary = summarize(state, folder, finishing)
    if pictures is not None and summary["metrics"] is not None:
        summary["render"] = _rendered(folder, pictures, device, seed)
    if json:
        emit(summary)
    else:
        print(describe(summary))
    return exit_code([state], recorded, strict=strict)


def _made(
    arguments: tuple[Any, ...], out: Path, *, waits: bool, strict: bool
) -> tuple[SceneState, Path, bool, tuple[str, ...]]:
    """Makes a scene, writes its folder and records its run; pictures may be left for afterwards.

    Args:
        arguments: As of `generate_requests`.
        out: Folder that receives the scene's.
        waits: Whether nothing may be left.
        strict: As of `generate`.

    Returns:
        The scene, its folder, whether the run is in the database, and the files that follow.
    """
    from esg.commands.live import live
    from esg.failures import report_failures
    from esg.outcomes import UserError
    from esg.runs import record_run
    from esg.scenefolder import publish, publish_unfinished
    from esg.stages import PICTURES

    with contextlib.ExitStack() as held:
        with live(1) as bar:
            state, rest = _state(arguments, None if waits else out, held)
            if state.user_error:
                raise UserError(state.reason)
            bar.show("writing")
            owed = None if rest is None else publish_unfinished(rest, out)
            folder = publish(state, out) if owed is None else owed.folder
            report_failures([state], [folder], out, adding=True, strict=strict)
            bar.show("ingesting")
            recorded = record_run([state], "generate") is not None
        if rest is None or owed is None:
            return state, folder, recorded, ()
        from esg.alone.finishing import finish
        from esg.machine.answering import afterwards

        afterwards(partial(finish, rest, owed, held.pop_all()))
    return state, folder, recorded, PICTURES


def _state(
    arguments: tuple[Any, ...], follow: Path | None, held: contextlib.ExitStack
) -> tuple[SceneState, Unfinished | None]:
    """The final state of the scene, as of `flows.generate`, and what is left of its record.

    It is made on the user's Prefect server if there is one, else without a scheduler. One that is
    already in the store is found there.

    Args:
        arguments: As of `generate_requests`.
        follow: Folder that receives the scene's, if its pictures may follow.
        held: What the record needs until it is finished.
    """
    import os

    from esg.requests import generate_requests

    request = generate_requests(*arguments)[0]
    if os.environ.get("PREFECT_API_URL"):
        return _recalled(request) or _on_server(arguments), None
    from esg.alone.finishing import may_follow
    from esg.alone.guarded import alongside, begin_guarded, run_guarded
    from esg.limits import stage_limits
    from esg.settings import check_limits

    held.enter_context(alongside(request))
    state = _recalled(request)
    if state is not None:
        return state, None
    stage_limits()  # a mistake in them is told before anything starts
    check_limits()
    if follow is None:
        return run_guarded(request), None
    state, rest = begin_guarded(request, lambda state: may_follow(state, follow, held))
    if rest is not None:
        held.callback(rest.drop)
    return state, rest


def _recalled(request: SceneRequest) -> SceneState | None:
    """The scene as it is in the store; a note where the first one takes longer."""
    from esg.commands.console import note_first_use
    from esg.pipeline import recall

    state = recall(request)
    if state is None:
        note_first_use()
    return state


def _on_server(arguments: tuple[Any, ...]) -> SceneState:
    from flows.session import session

    with session(processes=0) as call:
        from flows.generate import generate as flow

        return call(flow, *arguments)[0]


def _pictures(channels: str) -> Settings:
    from esg.api.rendering import Asked, settings_of

    return settings_of(Asked(channels))


def _rendered(folder: Path, pictures: Settings, device: str, seed: int) -> dict[str, Any]:
    from dataclasses import replace

    from esg.commands.render import run

    return run(folder, folder / "render", replace(pictures, device=device, seed=seed))


def summarize(state: SceneState, folder: Path, finishing: Sequence[str] = ()) -> dict[str, Any]:
    """What `--json` prints about one scene.

    Args:
        state: The scene.
        folder: Its folder.
        finishing: Files that follow there.
    """
    import json

    from esg.fidelity import lost_in, stand_ins, statement_rows

    path = folder / "metrics.json"
    metrics = json.loads(path.read_bytes()) if path.exists() else None
    document = folder / "esg.json"
    doc = json.loads(document.read_bytes()) if document.exists() else {}
    coverage = doc.get("coverage") or {}
    relations = (doc.get("layout_result") or {}).get("relations", [])
    assert state.outcome is not None
    return {
        "scene_id": folder.name,
        "folder": str(folder),
        "prompt": state.request.prompt,
        "seed": state.request.seed,
        "outcome": state.outcome.value,
        "reason": state.reason,
        "advice": state.outcome.advice,
        "verified": bool(metrics and metrics["verified"]),
        "proof": metrics["proof"] if metrics else None,
        "metrics": metrics["verdict"] if metrics else None,
        "statements": metrics.get("statements", []) if metrics else statement_rows(doc),
        "not_kept": lost_in(doc, metrics),
        "plausibility": metrics.get("plausibility") if metrics else None,
        "coverage": {
            "warnings": [*coverage.get("warnings", []), *stand_ins(doc)],
            "not_understood": [
                i["text"] for i in coverage.get("items", []) if i["status"] == "not_understood"
            ],
        },
        "relations_not_met": [
            r["edge"] for r in relations if not r["satisfied"] and r["edge"] not in _assumed(doc)
        ],
        "cached_stages": state.cached_stages,
        "stages": [
            {k: e[k] for k in ("stage", "cached", "seconds", "error") if k in e} for e in state.log
        ],
        "seconds": round(state.seconds, 3),
        "finishing": list(finishing),
    }


def _told(row: dict[str, Any]) -> str:
    """A statement with its verdict, in a line."""
    mark = "kept" if row["kept"] else row["status"].replace("_", " ").upper()
    found = ", ".join(f"{k} {v:.3g}" for k, v in row["measured"].items())
    says = f'"{row["words"]}" ({row["says"].replace("_", " ")})'
    return f"  {mark:8} {says}" + (f": {found}" if found else "")


def _plausible(found: dict[str, Any] | None) -> list[str]:
    """Whether a replay is plausible, in lines: every check that it does not pass."""
    from esg.metrics.plausibility import Check

    if found is None:
        return []
    if found["plausible"]:
        return ["  plausible"]
    checks = [Check.model_validate(c) for c in found["checks"] if not c["ok"]]
    worst = [f"  implausible: {found['worst']}"]
    return worst + [f"    also {c.text}" for c in checks if c.text != found["worst"]]


def _assumed(doc: dict[str, Any]) -> set[str]:
    """Headings that nobody asked for: what nothing turns is drafted to face the front."""
    edges = doc["spatial_relation_graph"]["edges"]["binary_relations"]
    return {
        f"{e['from']} face {e['to']}"
        for e in edges
        if e["relation_type"] == "face" and e["confidence"] <= ASSUMED
    }


def describe(summary: dict[str, Any]) -> str:
    """The same for people."""
    from esg.fidelity import block
    from esg.pipeline import STAGES

    lines = [f"{summary['outcome']}: {summary['folder']}"]
    lines += block(summary["not_kept"], "scene")
    # The reason of what is partial is that block in one sentence.
    if summary["reason"] and summary["outcome"] != "partial":
        lines.append(f"  {summary['reason']}")
    if summary["outcome"] != "solved":
        lines.append(f"  {summary['advice']}")
    lines += [f"  warning: {w}" for w in summary["coverage"]["warnings"]]
    lines += [f"  warning: not met: {r}" for r in summary["relations_not_met"]]
    metrics = summary["metrics"]
    if metrics:
        for event in metrics["events"]:
            mark = "done" if event["completed"] else "NOT DONE"
            when = f"at {event['time_s']:.2f} s" if event["time_s"] is not None else ""
            parts = [event["id"], event["type"], ", ".join(event["bodies"]), when, event["reason"]]
            lines.append(f"  {mark:8} {' '.join(p for p in parts if p)}")
        for item in metrics["constraints"]:
            measured = "not measured" if item["measured"] is None else f"{item['measured']:.3g}"
            # The sign that tells a name from a word means nothing to a reader.
            asked = re.sub(r"(?<!\S)=(?=\S)", "", item["constraint"])
            lines.append(f"  score {item['score']:.2f} {asked}: {measured}")
        lines += [_told(row) for row in summary["statements"]]
        lines += _plausible(summary["plausibility"])
        layout = "valid" if metrics["slr"] else "INVALID"
        proof = {
            "class": "the emitted class, compiled and run in PhysX",
            "program": "the control program (no C++ compiler found, or another engine)",
        }[summary["proof"]]
        rate = round(1 / metrics["dt_s"])
        lines.append(f"  layout {layout}; proof: {proof}, {rate} steps a second")
    if "render" in summary:
        rendered = summary["render"]
        lines.append(f"  {rendered['pictures']} pictures in {rendered['folder']}")
    ran = [f"{s['stage']} {s['seconds']:.1f}" for s in summary["stages"] if not s["cached"]]
    if ran:
        lines.append(f"  seconds: {', '.join(ran)}")
    lines.append(f"  {summary['cached_stages']} of {len(STAGES)} stages from cache")
    if summary["finishing"]:
        follow = " and ".join(summary["finishing"])
        lines.append(f"  {follow} follow (--wait waits for them)")
    return "\n".join(lines)
