"""`esg report`: a run as one page that opens from disk."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter


def report(
    run: Path,
    *,
    out: Path | None = None,
    engines: str = "",
    against: Path | None = None,
    title: str = "",
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Write one self-contained page about a run: figures, scenes, players.

    Args:
        run: Output folder of a bench or generate, or one scene folder.
        out: The HTML file; default report.html in the run's folder.
        engines: Further engines to replay and overlay, with commas, or all.
        against: Earlier run to compare with (folder or results file); default the last run of the
            same suite, strategy and engine in the database.
        title: Of the page; default the name of the folder.
        json: Print one JSON document: the file and what is in it.

    Returns:
        0, or 3 if files of the run are damaged: the page names them and shows the rest.
    """
    from esg.api.inputs import check_target, checked
    from esg.commands.console import emit, progress
    from esg.notices import warn
    from esg.report import load_run, write_report
    from esg.runs import database_path

    path = out or run / "report.html"
    chosen, _, loaded = checked(
        lambda: engine_names(engines),
        lambda: check_target("--out", path, "an HTML file") if out or run.is_dir() else None,
        lambda: load_run(run, against=against, database=database_path()),
    )
    problems: list[str] = []
    with progress(len(loaded.scenes), "reading scenes") as bar:
        write_report(
            loaded,
            path,
            engines=chosen,
            title=title,
            on_scene=lambda s: bar.step(s.name),
            on_problem=problems.append,
        )
    if json:
        size = path.stat().st_size
        found = {"scenes": len(loaded.scenes), "problems": problems}
        emit({"report": str(path), "bytes": size, **found})
    else:
        warn(problems)
        count = len(loaded.scenes)
        scenes = f"{count} scene" if count == 1 else f"{count} scenes"
        print(f"{path}: {scenes}, {path.stat().st_size / 1e6:.1f} MB")
    return 3 if problems else 0


def engine_names(text: str) -> tuple[str, ...]:
    """Engines of a comma-separated list, `all` for all of them.

    Raises:
        UserError: If one is unknown.
    """
    from esg.outcomes import UserError
    from esg.report.replays import ENGINES

    if text.strip() == "all":
        return ENGINES
    names = tuple(dict.fromkeys(n.strip() for n in text.split(",") if n.strip()))
    unknown = [n for n in names if n not in ENGINES]
    if unknown:
        raise UserError(f"--engines {', '.join(unknown)}: choose from {', '.join(ENGINES)} or all")
    return names
