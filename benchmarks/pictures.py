"""The pictures of the concept pages, from real runs.

    python -m benchmarks.pictures --scene runs/SCENE --sheet joints=runs/DOOR --sheet ropes=...

Plots come from the engines and tables as they are. Crops of the player's page need a Chromium and
the scene of "A car collides with a trashbin, knocking it into a picnic table."; contact sheets are
those of "A door is pushed open by a rolling ball.", "A wrecking ball swings into a stack of boxes."
and "A brick is thrown through a window and the window shatters.".
"""

from __future__ import annotations

import argparse
import csv
from dataclasses import replace
import io
import itertools
import json
from pathlib import Path
import tempfile
import time

import numpy as np
from numpy.typing import NDArray
from PIL import Image

from benchmarks.lib.diagrams import DIAGRAMS
from benchmarks.lib.svg import COLORS, Axis, Box, Line, boxes, plot
from benchmarks.lib.theta import case
from esg.dynamics.plan.planner import Plan
from esg.engines.program import batch_programs
from esg.engines.registry import get_engine
from esg.engines.scene import Rollout, SimScene, Variation
from esg.metrics.models import SuiteScene

PROMPT = "A car collides with a trashbin, knocking it into a picnic table."
BALLS = (
    "There are three balls on the ground. Ball A moves and hits ball B, then ball B hits ball C."
)
HZ = 240.0
GREY = "#b6bec6"
SHOWN_S = 2.2
"""Of the engines' picture: after the second collision every engine tumbles in its own way."""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, default=Path("docs/images/concepts"))
    parser.add_argument("--scene", type=Path, help="finished scene whose page is photographed")
    parser.add_argument("--sheet", action="append", default=[], help="NAME=FOLDER of a scene")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    car, balls = (case(SuiteScene(id="s", prompt=p), 0).plan for p in (PROMPT, BALLS))
    drawn = {
        "lexicon": lexicon(), "search": search(balls), "engines": engines(car),
        "surrogate": surrogate(balls), **DIAGRAMS,
    }  # fmt: skip
    if args.scene is not None:
        drawn["stages"] = stages(args.scene)
        for name, data in photographs(args.scene).items():
            (args.out / f"{name}.webp").write_bytes(data)
    for name, _, folder in (told.partition("=") for told in args.sheet):
        with Image.open(Path(folder) / "preview.png") as sheet:
            (args.out / f"{name}.webp").write_bytes(webp(sheet))
    for name, picture in drawn.items():
        (args.out / f"{name}.svg").write_text(picture, encoding="utf-8")


def lexicon() -> str:
    """Length and mass of every kind, by what it is made of."""
    with Path("esg/lexicon/kinds.csv").open(encoding="utf-8", newline="") as file:
        rows = [r for r in csv.DictReader(file) if r["length_cm"] and r["mass_kg"]]
    groups = {
        "wood": ("wood", "wood_panel"),
        "metal": ("steel", "aluminium", "cast_iron", "brass", "car_body"),
        "living and eaten": ("flesh", "fruit"),
        "glass and stone": ("glass", "ceramic", "stone", "concrete", "brick"),
    }
    found: dict[str, list[tuple[float, float]]] = {name: [] for name in (*groups, "others")}
    for row in rows:
        name = next((g for g, words in groups.items() if row["surface"] in words), "others")
        found[name].append((float(row["length_cm"]) / 100, float(row["mass_kg"])))
    lines: list[Line] = []
    for (name, points), color in zip(found.items(), COLORS, strict=True):
        x, y = np.array(points).T
        lines.append(Line(x, y, color, f"{name} ({len(points)})", True, 2.6, 0.65))
    return plot(lines, Axis("length [m]", log=True), Axis("mass [kg]", log=True))


def played(plan: Plan, thetas: NDArray[np.float64], engine: str) -> Rollout:
    """One world a theta."""
    names = plan.scene.names
    position = np.array([[b.position for b in plan.scene.bodies]] * len(thetas))
    quaternion = np.array([[b.quaternion for b in plan.scene.bodies]] * len(thetas))
    for world, theta in enumerate(thetas):
        for name, (p, q) in plan.starts(theta).items():
            i = plan.scene.index(name)
            position[world, i], quaternion[world, i] = p, q
    batch = batch_programs([plan.compile(theta) for theta in thetas], names)
    some = Variation(position=position, quaternion=quaternion)
    return get_engine(engine).rollout(plan.scene, batch, dt=1 / HZ, variation=some)


def _drawn(plan: Plan, count: int) -> NDArray[np.float64]:
    """The choreographed theta, then some drawn evenly between the bounds of what is free."""
    rng = np.random.default_rng(0)
    spread = rng.uniform(plan.lower(), plan.upper(), (count, len(plan.variables)))
    first = plan.initial()
    return np.vstack([first, np.where(plan.free(), spread, first)])


def _chain(scene: SimScene, rollout: Rollout, world: int) -> bool:
    """Whether the first ball meets the second, and that one the third."""
    log = rollout.contacts.select(world)
    a, b, c = (scene.index(f"ball_{letter}") for letter in "abc")
    pairs = {tuple(sorted(p)) for p in zip(log.a.tolist(), log.b.tolist(), strict=True)}
    return {(a, b), (b, c)} <= pairs


def search(plan: Plan) -> str:
    """Ways of the second ball in Newton, from above, for candidates of theta."""
    rollout = played(plan, _drawn(plan, 60), "newton")
    found: list[tuple[bool, Line]] = []
    for world in range(len(rollout.position)):
        happens = _chain(plan.scene, rollout, world)
        x, y = rollout.position[world, ::16, plan.scene.index("ball_b"), :2].T
        found.append((happens, Line(x, y, COLORS[2] if happens else GREY, width=1.3)))
    done = sum(happens for happens, _ in found)
    lines = [line for _, line in sorted(found, key=lambda row: row[0])]
    lines[0] = replace(lines[0], name=f"ball B misses ball C, or is missed ({len(lines) - done})")
    lines[-1] = replace(lines[-1], name=f"both collisions happen ({done})")
    return plot(lines, Axis("x [m]"), Axis("y [m]"), equal=True)


def surrogate(plan: Plan) -> str:
    """Which thetas bring both collisions about, one launch of the surrogate."""
    thetas = _drawn(plan, 1535)
    rollout = played(plan, thetas, "surrogate")
    happens = np.array([_chain(plan.scene, rollout, w) for w in range(len(thetas))])
    aim, speed = np.degrees(thetas[:, 0]), thetas[:, 1]
    lines = [
        Line(aim[~happens], speed[~happens], GREY, f"a collision is missing ({(~happens).sum()})"),
        Line(aim[happens], speed[happens], COLORS[2], f"both happen ({happens.sum()})"),
        Line(aim[:1], speed[:1], COLORS[1], "where the search starts"),
    ]
    dots = [replace(line, dots=True, width=2.0 + 2 * (k == 2)) for k, line in enumerate(lines)]
    return plot(dots, Axis("aim of ball A [degrees]"), Axis("speed of ball A [m/s]"))


def engines(plan: Plan) -> str:
    """How fast car, bin and table are in each engine, for the choreographed theta."""
    lines: list[Line] = []
    styles = {"physx": ("", 2.2), "newton": ("6 3", 1.6), "rapier": ("2 3", 1.6)}
    for engine, (dash, width) in styles.items():
        rollout = played(plan, plan.initial()[None], engine)
        shown = slice(0, int(SHOWN_S * HZ), 2)
        for name, color in zip(("car_1", "trashbin_1", "picnic_table_1"), COLORS, strict=False):
            fast = np.linalg.norm(rollout.linear_velocity[0, :, plan.scene.index(name)], axis=1)
            told = name[:-2].replace("_", " ") if engine == "physx" else ""
            lines.append(
                Line(rollout.time[shown], fast[shown], color, told, width=width, dash=dash)
            )
    return plot(
        lines,
        Axis("time [s]; solid PhysX, dashed Newton, dotted Rapier"), Axis("speed [m/s]"),
    )  # fmt: skip


def stages(folder: Path) -> str:
    """The stages of a scene, what each writes, and its seconds."""
    writes = {
        "draft": "objects, relations, events", "resolve": "meshes, masses, materials",
        "cast": "what words leave open", "layout": "where everything stands",
        "optimize": "the control program", "compile": "an Unreal class",
        "replay": "its motion in PhysX",
        "judge": "what happened", "dress": "the place around", "record": "films, exports, tables",
    }  # fmt: skip
    entries = [json.loads(line) for line in (folder / "log.jsonl").read_text().splitlines()]
    seconds = {e["stage"]: e["seconds"] for e in entries if "stage" in e}
    found = [
        Box(
            name,
            4 - k % 5 if k > 4 else k,
            k // 5,
            (name, what, f"{seconds[name]:.1f} s"),
            COLORS[k // 5 * 2],
        )
        for k, (name, what) in enumerate(writes.items())
    ]
    names = list(writes)
    return boxes(found, list(itertools.pairwise(names)))


def webp(picture: Image.Image) -> bytes:
    data = io.BytesIO()
    picture.convert("RGB").save(data, "WEBP", quality=80)
    return data.getvalue()


OPEN = "document.querySelectorAll('details.section').forEach((d) => (d.open = true))"
CROPS = {
    "graph": "return [...document.querySelectorAll('details.section')]"
    ".find((d) => d.firstChild.textContent === 'Scene graph').lastChild",
    "metrics": "return document.querySelector('.plots')",
}


def photographs(scene: Path) -> dict[str, bytes]:
    """Crops of a scene's page as WebP."""
    from esg.report import load_run, write_report
    from tests.report import browser as chrome

    out: dict[str, bytes] = {}
    with tempfile.TemporaryDirectory() as work, chrome.browser() as driver:
        page = write_report(load_run(scene), Path(work) / "page.html")
        chrome.open_page(driver, page)
        driver.execute_script(OPEN)
        time.sleep(2.0)
        for name, element in CROPS.items():
            shot = Image.open(io.BytesIO(driver.execute_script(element).screenshot_as_png))
            out[name] = webp(shot)
    return out


if __name__ == "__main__":
    main()
