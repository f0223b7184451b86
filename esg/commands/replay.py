"""`esg replay`: a finished scene again, in an engine of choice or in all of them."""

from __future__ import annotations

import contextlib
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.api.scene import Replay
    from esg.compile.transfer import TransferRun, Trust
    from esg.graph import EsgDocument
    from esg.metrics.models import SuiteScene

MIN_RATE_HZ, MAX_RATE_HZ = 30, 4000
DEFAULT_RATE_HZ = 240


def replay(
    scene: str,
    *,
    engine: Literal["physx", "rapier", "newton"] | None = None,
    hz: int | None = None,
    dt: float | None = None,
    compare: Annotated[bool, Parameter(negative="")] = False,
    suite: Path | None = None,
    trust: Annotated[bool, Parameter(negative="")] = False,
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Replay a stored scene and judge it.

    The class of the scene runs in a child process, and only if it is what this version emits from
    the scene's esg.json; otherwise its control program is replayed and the result says so.

    Args:
        scene: Scene folder, id of one below ./runs, or key of a scene in the run database.
        engine: physx (default) runs the emitted class; rapier and newton run its control program.
        hz: Physics steps a second; default 240.
        dt: Physics step in seconds, instead of --hz.
        compare: Replay in every engine at 120, 240 and 480 Hz and compare with PhysX at 240 Hz.
        suite: Suite to judge against (file or name), its scene found by prompt; default the
            scene's own timeline.
        trust: Run the class whatever it is: you vouch for who made it.
        json: Print one JSON document: the verdict, or the matrix.
    """
    from esg.api.inputs import checked
    from esg.api.scene import document_of, expectation, replayed
    from esg.commands.console import emit
    from esg.commands.stored import open_scene
    from esg.metrics import load_suite
    from esg.outcomes import UserError

    if compare and not (engine is None and hz is None and dt is None):
        raise UserError("--compare runs every engine and step: leave out --engine, --hz and --dt")
    vouched: Trust = "anything" if trust else "equal"
    with contextlib.ExitStack() as stack:
        step, loaded, folder = checked(
            lambda: step_of(hz, dt),
            lambda: None if suite is None else load_suite(suite),
            lambda: stack.enter_context(open_scene(scene, whole=False)),
        )
        doc = document_of(folder)
        expected, against = expectation(folder, doc, loaded)
        if compare:
            result = matrix(folder, doc, expected, against, vouched) | {"scene": scene}
        else:
            found = replayed(folder, doc, engine or "physx", step, expected, against, vouched)
            result = told(scene, found)
    if json:
        emit(result)
    elif compare:
        print(matrix_table(result))
    else:
        print(verdict_table(result))
    return 0 if result["verified"] else 3


def step_of(hz: int | None, dt: float | None) -> float:
    """The physics step [s] of --hz or --dt, default 1/240.

    Raises:
        UserError: If the two contradict each other or the step is out of range.
    """
    from esg.outcomes import UserError

    if dt is not None and hz is not None and abs(dt * hz - 1.0) > 1e-3:
        raise UserError(f"--hz {hz} and --dt {dt} contradict each other; give one of them")
    if hz is not None and not MIN_RATE_HZ <= hz <= MAX_RATE_HZ:
        raise UserError(f"--hz {hz}: choose {MIN_RATE_HZ} to {MAX_RATE_HZ} steps a second")
    if dt is not None and not 1 / MAX_RATE_HZ <= dt <= 1 / MIN_RATE_HZ:
        raise UserError(
            f"--dt {dt}: choose {1 / MAX_RATE_HZ} to {1 / MIN_RATE_HZ:.4f} seconds a step"
        )
    if hz is not None:
        return 1.0 / hz
    return 1.0 / DEFAULT_RATE_HZ if dt is None else dt


def told(scene: str, found: Replay) -> dict[str, Any]:
    """What `--json` prints of one replay.

    Args:
        scene: As it was asked for.
        found: The replay.
    """
    return {
        "scene": scene,
        "engine": found.engine,
        "dt": found.dt_s,
        "proof": found.proof,
        "proof_note": found.note,
        "judged_against": found.judged_against,
        "verified": found.verdict.verified,
        "verdict": found.verdict.to_json(),
        "plausibility": found.plausibility,
    }


def matrix(
    folder: Path, doc: EsgDocument, expected: SuiteScene, against: str, trust: Trust = "equal"
) -> dict[str, Any]:
    """The engine x step matrix of one scene folder (`--compare --json`).

    Args:
        folder: Scene folder.
        doc: Its document.
        expected: What must happen.
        against: Where that is written.
        trust: Which classes are run.
    """
    from esg.compile.transfer import REFERENCE, transfer_matrix

    runs: list[TransferRun] = transfer_matrix(folder, expected, trust=trust, document=doc)
    return {
        "scene": str(folder),
        "judged_against": against,
        "reference": {"engine": REFERENCE[0], "hz": REFERENCE[1]},
        "verified": all(r.verdict.verified for r in runs),
        "runs": [r.to_json() for r in runs],
    }


def verdict_table(result: dict[str, Any]) -> str:
    """The judge's table of one replay."""
    from esg.commands.comparing.verdicts import completed, event_rows
    from esg.commands.console import table
    from esg.fidelity import judged

    verdict = result["verdict"]
    rows = event_rows(verdict)
    rows += [
        ["kept" if row["kept"] else row["status"].replace("_", " ").upper(), row["id"],
         row["says"], said["words"], "", row["reason"]]
        for said in verdict["statements"]
        for row in [judged(said)]
    ]  # fmt: skip
    head = (
        f"{result['scene']}: {result['engine']} at {1 / result['dt']:.0f} Hz, "
        f"proof: {result['proof']}, judged against {_source(result)}"
    )
    head += _not_run(result.get("proof_note", ""))
    tail = completed(verdict)
    if verdict["statements"]:
        kept = sum(bool(said["kept"]) for said in verdict["statements"])
        tail += f", {kept} of {len(verdict['statements'])} statements kept"
    if verdict["ppa"]["standard"] is not None:
        tail += f", PPA {100 * verdict['ppa']['standard']:.0f}%"
    worst = result["plausibility"]["worst"]
    tail += f"\nimplausible: {worst}" if worst else ", plausible"
    if not rows:
        return f"{head}\n{tail}"
    columns = ["", "event", "type", "bodies", "time", "reason"]
    return f"{table(columns, rows, head)}\n{tail}"


def matrix_table(result: dict[str, Any]) -> str:
    """The matrix as text: one line per engine and rate."""
    from esg.commands.console import table

    events = [e["id"] for e in result["runs"][0]["events"]]
    scored = any(r["ppa"]["standard"] is not None for r in result["runs"])
    columns = ["engine", "Hz", "proof", "SLR", "events", *(["PPA"] if scored else [])]
    columns += [*events, "apart at end"]
    rows = []
    for r in result["runs"]:
        row = [r["engine"], str(r["hz"]), r["proof"], "valid" if r["slr"] else "INVALID"]
        row.append(f"{r['completed']}/{r['n_events']}")
        if scored:
            ppa = r["ppa"]["standard"]
            row.append("" if ppa is None else f"{100 * ppa:.0f}%")
        row += [_event(e) for e in r["events"]]
        row.append(f"{r['apart_m']:.3f} m" if r["sound"] else "diverged")
        rows.append(row)
    reference = result["reference"]
    title = (
        f"{result['scene']}: judged against {_source(result)}; differences to "
        f"{reference['engine']} at {reference['hz']} Hz"
    )
    title += _not_run(next((r["proof_note"] for r in result["runs"] if r["proof_note"]), ""))
    return table(columns, rows, title)


def _not_run(note: str) -> str:
    """That the class was not run, and how it would be; nothing without a reason."""
    if not note:
        return ""
    return (
        f"\nthe class was not run: {note}; its program was. --trust runs it if you know its maker"
    )


def _event(event: dict[str, Any]) -> str:
    if not event["completed"]:
        return "NOT DONE"
    late = "" if not event["late_s"] else f" ({1000 * event['late_s']:+.0f} ms)"
    return f"{event['time_s']:.3f} s{late}" if event["time_s"] is not None else "done"


def _source(result: dict[str, Any]) -> str:
    against = result["judged_against"]
    return "its own timeline" if against == "timeline" else str(against)
