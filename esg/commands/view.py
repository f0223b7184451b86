"""`esg view`: the player of one scene, served on this machine."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter


def view(
    scene: str,
    *,
    port: int = 8765,
    engines: str = "",
    once: Annotated[bool, Parameter(negative="")] = False,
    seconds: float | None = None,
) -> int:
    """Serve the player of a finished scene on this machine, until interrupted.

    Args:
        scene: Scene folder, or id of one below ./runs.
        port: Of the address; 0 takes a free one.
        engines: Further engines to replay and overlay, with commas, or all.
        once: Start, answer, and stop at once: a test that everything is in place.
        seconds: Stop after so many seconds.

    Returns:
        0, or 3 if files of the scene are damaged: the page names them and shows the rest.
    """
    from esg.api.inputs import checked, find_scene, in_range
    from esg.commands.report import engine_names
    from esg.notices import warn
    from esg.report.run import load_run
    from esg.report.serve import serve

    folder, names, *_ = checked(
        lambda: find_scene(scene, whole=False),  # the page's run waits for it
        lambda: engine_names(engines),
        lambda: in_range("--port", port, 0, 65535),
        lambda: None if seconds is None else in_range("--seconds", seconds, 0.001, 1e7),
    )
    problems: list[str] = []
    page = _page(load_run(folder), names, problems.append)
    warn(problems)

    def ready(address: str) -> None:
        print(address, flush=True)
        if once:
            import urllib.request

            opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
            with opener.open(address, timeout=30) as answer:
                assert answer.read() == page

    try:
        serve(page, folder, port, ready, seconds=0.0 if once else seconds)
    except KeyboardInterrupt:
        print()
    return 3 if problems else 0


def _page(run: object, engines: tuple[str, ...], on_problem: Callable[[str], None]) -> bytes:
    import tempfile

    from esg.report import Run, write_report

    assert isinstance(run, Run)
    with tempfile.TemporaryDirectory() as work:
        path = Path(work) / "view.html"
        write_report(run, path, engines=engines, files="files", on_problem=on_problem)
        return path.read_bytes()
