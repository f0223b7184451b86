"""Whether films show what happens: every event in view, unobscured and large enough.

    python -m benchmarks.framing RUN... [--size 320x180] [--seed 0] [--json FILE] [--frames FOLDER]

RUN is a folder of finished scene folders, or one of them. Of every event it prints the kind of
camera, the share of the rectangle around who acts that is in the picture, the share of its
participants' pixels that nothing else hides, the same of the participant that is seen least, and
the fill, as docs/view/cameras.md defines them. With --frames, pictures of every film are written
beside each other.
"""

from __future__ import annotations

import argparse
from dataclasses import asdict
import json
from pathlib import Path
import time
from typing import Any

import numpy as np

from esg.graph import load_document
from esg.metrics import SceneVerdict
from esg.report.replays import replays_of
from esg.report.run import find_scenes, read_scene
from esg.view.director.acting import Action
from esg.view.director.lens import FILL_LEAST, FILL_MOST
from esg.view.director.paths import is_smooth
from esg.view.director.review import IN_VIEW, UNOBSCURED, Viewfinder
from esg.view.director.told import told_of
from esg.view.film.inserts import with_inserts
from esg.view.film.shooting import SIZE_PX, frames_of, shots_of, viewfinder
from esg.view.parts import scene_parts


def measure(folder: Path, size: tuple[int, int], seed: int, frames: Path | None) -> Any:
    """Rows of one scene, an event each, and what its film costs; None if it was never replayed."""
    entry = read_scene(folder)
    replays = replays_of(folder, entry.metrics)
    if not replays:
        return None
    verdict = SceneVerdict.from_json(entry.verdict)
    doc = load_document(folder / "esg.json")
    action = Action(replays[0].scene, replays[0].rollout, verdict, doc)
    parts = scene_parts(replays[0].scene, replays[0].rollout, doc)
    began = time.process_time()
    finder = viewfinder(action, doc, parts)
    told = told_of(replays[0].scene, replays[0].rollout, verdict, doc)
    shots, lacking = with_inserts(finder, shots_of(finder, seed), told, seed)
    directed = time.process_time()
    images = list(frames_of(finder, shots))
    drawn = time.process_time()
    judge = Viewfinder(action, finder.scan, size, finder.around)
    rows = []
    for number, shot in enumerate(shots):
        if shot.action is not action:
            continue  # an insert: no event is about it
        clear, smooth = judge.clear(shot.take, 12), is_smooth(shot.take)
        for seen in judge.review(shot.take):
            row = {k: v for k, v in asdict(seen).items() if k != "beat"}
            row = {k: round(float(v), 3) for k, v in row.items()}
            kept = seen.good and clear and smooth
            rows.append(
                {
                    "scene": folder.name,
                    "event": seen.beat.event,
                    "type": seen.beat.type,
                    "time_s": round(seen.beat.time_s, 3),
                    "shot": number,
                    "camera": shot.take.kind,
                    **row,
                    "clear": clear,
                    "smooth": smooth,
                    "good": kept,
                }
            )
    if frames is not None:
        _strip(images, frames / f"{folder.name}.png")
    return rows, {
        "scene": folder.name,
        "frames": len(images),
        "inserts": sum(shot.action is not action for shot in shots),
        "too_small": [replays[0].scene.names[one.body] for one in lacking],
        "direct_cpu_s": round(directed - began, 2),
        "draw_cpu_s": round(drawn - directed, 2),
    }


def _strip(images: list[Any], path: Path) -> None:
    from PIL import Image

    picked = [images[int(k)] for k in np.linspace(0, len(images) - 1, 5)]
    path.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(np.concatenate(picked, axis=1)).save(path)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", type=Path, nargs="+")
    parser.add_argument("--size", default="320x180")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--json", type=Path)
    parser.add_argument("--frames", type=Path)
    args = parser.parse_args()
    width, height = (int(v) for v in args.size.split("x"))
    rows: list[dict[str, Any]] = []
    films: list[dict[str, Any]] = []
    for folder in (s for run in args.runs for s in find_scenes(run)):
        found = measure(folder, (width, height), args.seed, args.frames)
        if found is None:
            print(f"{folder.name}: never replayed")
            continue
        rows += found[0]
        films.append(found[1])
        for r in found[0]:
            figures = " ".join(f"{k} {r[k]:.2f}" for k in ("inside", "unobscured", "least", "fill"))
            flags = "" if r["good"] else "  <-- " + ", ".join(_broken(r))
            print(f"{r['scene']:12} {r['event']:4} {r['type']:10} {r['camera']:9} {figures}{flags}")
    events = max(1, len(rows))
    total = {
        "events": len(rows),
        "in_view": sum(r["inside"] >= IN_VIEW for r in rows),
        "unobscured": sum(r["unobscured"] >= UNOBSCURED for r in rows),
        "filled": sum(FILL_LEAST <= r["fill"] <= FILL_MOST for r in rows),
        "clear": sum(r["clear"] for r in rows),
        "smooth": sum(r["smooth"] for r in rows),
        "good": sum(r["good"] for r in rows),
        "mean_fill": round(sum(r["fill"] for r in rows) / events, 3),
        "frames": round(sum(f["frames"] for f in films) / max(1, len(films)), 1),
        "direct_cpu_s": round(sum(f["direct_cpu_s"] for f in films) / max(1, len(films)), 3),
        "draw_cpu_s": round(sum(f["draw_cpu_s"] for f in films) / max(1, len(films)), 3),
        "size_px": list(SIZE_PX),
    }
    print(json.dumps(total, indent=2))
    if args.json:
        args.json.write_text(json.dumps({"total": total, "events": rows, "films": films}, indent=1))


def _broken(row: dict[str, Any]) -> list[str]:
    """Names of the rules that a shot breaks at an event."""
    rules = {
        "out of view": row["inside"] < IN_VIEW,
        "hidden": row["unobscured"] < UNOBSCURED,
        "too small or large": not FILL_LEAST <= row["fill"] <= FILL_MOST,
        "too close or through a thing": not row["clear"],
        "rough": not row["smooth"],
    }
    return [name for name, broken in rules.items() if broken]


if __name__ == "__main__":
    main()
