"""`esg studio`: a page on this machine to write, solve and play scenes."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter


def studio(
    *,
    port: int = 8766,
    out: Path = Path("runs") / "studio",
    once: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Serve the studio on this machine, until interrupted.

    Args:
        port: Of the address; 0 takes a free one.
        out: Folder of its scenes and its history.
        once: Start, answer, and stop at once: a test that everything is in place.
    """
    from esg.api.inputs import check_cache, checked, in_range
    from esg.scenefolder import check_writable
    from esg.studio.running import run

    checked(
        lambda: in_range("--port", port, 0, 65535),
        lambda: check_writable(out),
        check_cache,
    )
    run(out, port, lambda address: print(address, flush=True), once=once)
    return 0
