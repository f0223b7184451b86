"""How a dataset was made, in words: the command, the proof, the prompts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from esg.dataset.card.markdown import share
from esg.dataset.distribution import Distribution
from esg.dataset.plan import DatasetSpec

_PROOFS = {
    "physx": "the emitted class, compiled and run in PhysX 5 at 240 Hz",
    "rapier": "the control program, run in Rapier at 240 Hz",
    "newton": "the control program, run in Newton at 240 Hz",
}


def about(spec: DatasetSpec, facts: Mapping[str, Any]) -> str:
    """What the dataset is."""
    n, good = facts["scenes"], facts["verified"]
    return (
        f"{n} scenes, {good} of them ({share(good, n)}) *verified*: solved, all that the prompt "
        "says shown, a valid layout, and every expected event happens in the replay "
        f"({_PROOFS[spec.engine]}). Scenes that are not verified are kept and say why "
        "(`verified`, `outcome`, `reason`): filter them as you need. Of sampled scenes, the "
        "expectation is what their sentence says (`expectation`), not what was read into it."
    )


def command(spec: DatasetSpec) -> str:
    """The command that makes this dataset, without what is default."""
    usual = DatasetSpec(source=spec.source, n=spec.n)
    if spec.source == "sample":
        parts = [f"esg dataset --sample {spec.n}"]
        if spec.distribution is not None and spec.distribution != Distribution():
            parts.append("--distribution distribution.yaml")
    else:
        parts = ["esg dataset --prompts meta/prompts.jsonl"]
    for name in ("seed", "drafter", "strategy", "engine", "device", "mcap", "previews", "batch"):
        if (value := getattr(spec, name)) != getattr(usual, name):
            parts.append(f"--{name} {value}")
    beside = {"what-if": spec.what_if, "engines": spec.engines}
    parts += [f"--{name} {','.join(asked)}" for name, asked in beside.items() if asked]
    parts += [f"--annotations {spec.annotations}"] if spec.annotations != "all" else []
    parts += [f"--{name}" for name in ("counterfactual", "strict", "thin") if getattr(spec, name)]
    parts += [] if spec.meshes else ["--no-meshes"]
    if spec.render is not None:
        parts += spec.render.options()
    return " ".join([*parts, "--out FOLDER"])


def made(spec: DatasetSpec, facts: Mapping[str, Any]) -> str:
    """With what, how it was proven, and from how many prompts."""
    from esg import __version__

    text = f"with esg-scenes {__version__}"
    if "--distribution" in command(spec):
        text += "; `distribution` in `meta/plan.json` holds the shares (JSON is YAML)"
    proofs = ", ".join(f"{n} by the {kind}" for kind, n in facts["proofs"].items())
    return (
        f"{text}. Replayed: {proofs or 'none'}. {facts['distinct_prompts']} distinct prompts in "
        f"{facts['families']} families."
    )
