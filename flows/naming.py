"""What runs are called in Prefect's UI, and the tags by which they are found."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from esg.pipeline import SceneState

MAX_NAME = 80
"""Characters of a name: prompts are long, and the UI shows names in one line."""
MAX_SCENE = 30
SHOWN = 3
"""Scenes that a task names."""


def run_name(flow: str, parameters: Mapping[str, Any]) -> str:
    """The name of a run: what it makes, and how much of it.

    Args:
        flow: Name of the flow.
        parameters: That it was called with.
    """
    parts: list[str] = []
    if suites := _suites(parameters):
        parts.append(", ".join(suites))
    if "prompts" in parameters:
        prompts = list(parameters["prompts"])
        parts.append(prompts[0] if len(prompts) == 1 else f"{len(prompts)} prompts")
    if "scenes" in parameters:
        parts += [Path(str(parameters["out"])).name, f"{parameters['scenes']} scenes"]
    if "runs" in parameters:
        parts.append(f"{parameters['runs']} runs a scene")
    if "seed" in parameters:
        parts.append(f"seed {parameters['seed']}")
    name = f"{flow}: {', '.join(parts)}" if parts else flow
    return name if len(name) <= MAX_NAME else f"{name[: MAX_NAME - 1]}…"


def run_tags(flow: str, parameters: Mapping[str, Any]) -> list[str]:
    """Tags of a run: the project, the flow, its suites, and how it ran.

    Args:
        flow: Name of the flow.
        parameters: That it was called with.
    """
    how = [str(parameters[k]) for k in ("strategy", "engine", "device") if parameters.get(k)]
    return list(dict.fromkeys(["esg", flow, *_suites(parameters), *how]))


def scene_names(states: Sequence[SceneState]) -> str:
    """Names of a batch's scenes, for its tasks: the first ones, and how many more there are."""
    names = list(dict.fromkeys(s.request.name or s.request.prompt for s in states))
    shown = [n if len(n) <= MAX_SCENE else f"{n[: MAX_SCENE - 1]}…" for n in names[:SHOWN]]
    more = f" and {len(names) - SHOWN} more" if len(names) > SHOWN else ""
    return ", ".join(shown) + more


def current_name() -> str:
    """The name of the run in progress; for `flow_run_name`."""
    from prefect.runtime import flow_run

    return run_name(flow_run.flow_name or "run", flow_run.parameters or {})


def _suites(parameters: Mapping[str, Any]) -> list[str]:
    if "suite" in parameters:
        return [Path(str(parameters["suite"])).stem]
    return [Path(str(suite)).stem for suite in parameters.get("suites", ())]
