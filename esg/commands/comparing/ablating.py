"""`esg bench --ablations`: the paper's ablations in one command, its tables beside ours."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.ablations.tables import Table
    from esg.ablations.variants import Variant
    from esg.pipeline import SceneState


@Parameter(name="*")
@dataclass(frozen=True)
class Ablating:
    """Which ablations to run instead of the suite alone.

    Args:
        ablations: Run the paper's ablations, all or those named: draft, assets, initial, global,
            gradients, collision, optimization; each prints its table (docs/results/ablations.md).
    """

    ablations: Annotated[list[str] | None, Parameter(consume_multiple=True, negative="")] = None


NOTHING = Ablating()


def ablate(
    suite: Path,
    names: list[str],
    asked: tuple[int, int, str, str],
    out: Path | None,
    json: Path | None,
    workers: int | None,
) -> int:
    """Runs what the ablations compare and prints a table each.

    Args:
        suite: Suite file, or name of one that comes with the package.
        names: Ablations; none for all.
        asked: Runs a scene, first seed, engine of the replays, device.
        out: Folder of a folder a variant, for `esg study`; default runs/ablations-SUITE.
        json: File for the tables.
        workers: Worker processes; default one a core.
    """
    from esg import __version__
    from esg.ablations.drafts import draft_table
    from esg.ablations.tables import table_of
    from esg.ablations.variants import chosen, variants_of
    from esg.api import inputs
    from esg.codeversion import code_version
    from esg.files import safe_name, write_json
    from esg.metrics import load_suite
    from esg.pipeline import STAGES
    from esg.scenefolder import check_writable, publish

    runs, seed, engine, device = asked
    loaded, ablations, device, *_ = inputs.checked(
        lambda: load_suite(suite),
        lambda: chosen(names),
        lambda: inputs.check_device(device),
        lambda: inputs.in_range("--runs", runs, 1, 1000),
        lambda: inputs.check_seed(seed),
        lambda: inputs.check_workers(workers),
        lambda: None if json is None else inputs.check_target("--json", json, "a JSON file"),
        inputs.check_cache,
    )
    have = {scene.id for scene in loaded.scenes}
    skipped = [a for a in ablations if a.scenes and not have & set(a.scenes)]
    ablations = tuple(a for a in ablations if a not in skipped)
    out = out or Path("runs") / f"ablations-{safe_name(loaded.suite) or 'suite'}"
    check_writable(out)
    done: dict[Variant, list[SceneState]] = {}
    for variant, scenes in variants_of(ablations).items():
        done[variant] = _played(str(suite), variant, scenes, (runs, seed, engine, device), workers)
        for state in done[variant]:
            publish(state, out / variant.key)
    tables = [
        draft_table(a, loaded, seed) if a.key == "draft" else table_of(a, done, loaded)
        for a in ablations
    ]
    print("\n\n".join(_told(table) for table in tables))
    for ablation in skipped:
        print(f"{ablation.key}: {loaded.suite} has no {', '.join(ablation.scenes)}")
    code = {stage: code_version(stage) for stage in STAGES}
    print(f"\n{runs} runs from seed {seed}, esg {__version__}; scenes in {out}, a folder a variant")
    if json is not None:
        about = {"suite": loaded.suite, "runs": runs, "seed": seed, "version": __version__}
        write_json(json, {**about, "code": code, "tables": [t.to_json() for t in tables]})
    return 0


def _played(
    suite: str,
    variant: Variant,
    scenes: Sequence[str],
    asked: tuple[int, int, str, str],
    workers: int | None,
) -> list[SceneState]:
    """Final states of all runs of a variant: of the cache where it has all of them."""
    from esg.commands.live import live
    from esg.pipeline import recall
    from esg.requests import bench_requests
    from esg.workers import default_processes

    runs, seed, engine, device = asked
    arguments: tuple[Any, ...] = (
        suite, runs, seed, variant.strategy, engine, device, False, variant.collision, "rules",
        variant.without, tuple(scenes),
    )  # fmt: skip
    requests = bench_requests(*arguments)
    known = [state for request in requests if (state := recall(request)) is not None]
    if len(known) == len(requests):
        return known
    processes = default_processes(len(requests)) if workers is None else workers
    from flows.session import session

    with live(len(requests)) as bar, session(processes) as call:
        from flows.benchmark import benchmark as flow

        bar.show(variant.title)
        return call(flow, *arguments)


def _told(table: Table) -> str:
    from esg.commands.console import table as drawn

    text = drawn(list(table.columns), [list(row) for row in table.rows], table.title)
    return f"{text}\n{table.note}" if table.note else text
