"""`esg cost`: what a run will take, from runs that were measured."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

if TYPE_CHECKING:
    from esg.costs.predicted import Predicted

MOST_SCENES = 10**12


def cost(
    *,
    scenes: int = 1000,
    on: str = "",
    render: str = "",
    json: Annotated[bool, Parameter(negative="")] = False,
) -> int:
    """Predict core-hours and time of a dataset from measured runs, and say how far off that may be.

    Args:
        scenes: How many.
        on: Kind of machine; default all kinds that were measured.
        render: What is rendered of each scene, as it was measured; default nothing.
        json: Print one JSON document.
    """
    from esg.api.inputs import checked, in_range
    from esg.commands.console import emit
    from esg.costs.predicted import kinds, predict

    checked(lambda: in_range("--scenes", scenes, 1, MOST_SCENES))
    found = [predict(scenes, kind, render) for kind in ([on] if on else kinds())]
    if json:
        emit([p.to_json() for p in found])
    else:
        print("\n".join(described(p) for p in found))
    return 0


def described(found: Predicted) -> str:
    """A prediction for people."""
    rendered = f", {found.render} rendered" if found.render else ""
    lines = [
        f"{found.scenes} scenes{rendered} on {found.kind} ({found.cores} cores): "
        f"{found.core_hours:.4g} core-hours, {found.hours:.3g} h "
        f"({found.core_seconds:.2f} core-seconds a scene, cores {found.busy:.0%} busy)"
    ]
    lines += [
        f"  from {r.scenes} scenes, {r.date}, commit {r.commit}: {r.about}" for r in found.sources
    ]
    told = ", ".join(f"{error:+.0%}" for error in found.errors)
    lines.append(f"  held-out runs took {told}" if told else "  checked on no other run")
    return "\n".join(lines)
