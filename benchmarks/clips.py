"""What writing clips costs beside drawing them, and how large and slow codecs are.

    python -m benchmarks.clips SCENE [SCENE ...] [--size 256x256] [--render rgb,depth,...]
        [--device cpu] [--cameras 1] [--seconds 4] [--codecs] [--json FILE]

Every scene folder is drawn twice from the same cameras: all its channels once thrown away, once
coded and written, with boxes and tracks. The share of writing is the time of the second over the
first, less one: neither counts the directing of cameras. Frames an hour are those of the
second. `--codecs` compares FFV1 with 16-bit PNG in zip on the first scene's channels.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
import io
import json
from pathlib import Path
import tempfile
import time
from typing import Any
import zipfile

import numpy as np

from esg.commands.datasets.clips import even_size, parse_channels
from esg.dataset.clips.encoding import PICTURES, ChannelFile, codec_of, decoded
from esg.dataset.clips.rendering import VALUES, Replay, draw_scene, settings_of
from esg.dataset.clips.writing import CODED
from esg.dataset.plan import RenderSpec
from esg.graph import load_document
from esg.metrics import SceneVerdict
from esg.report.replays import replays_of
from esg.report.run import read_scene
from esg.view import png16
from esg.view.seeing.witness import Sight, shots, sight_of


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("scenes", nargs="+", type=Path)
    parser.add_argument("--size", type=even_size, default=(256, 256))
    parser.add_argument("--render", type=parse_channels, default=("rgb", "depth", "segmentation"))
    parser.add_argument("--device", default="cpu")
    parser.add_argument("--cameras", type=int, default=1)
    parser.add_argument("--camera", default="auto")
    parser.add_argument("--seconds", type=float, default=4.0, help="of every scene at most")
    parser.add_argument("--repeat", type=int, default=1, help="times, the fastest counts")
    parser.add_argument("--codecs", action="store_true")
    parser.add_argument("--json", type=Path)
    args = parser.parse_args()
    spec = RenderSpec(
        channels=args.render,
        size=args.size,
        device=args.device,
        cameras=args.cameras,
        camera=args.camera,
    )
    out: dict[str, Any] = {"size": args.size, "channels": args.render, "device": args.device}
    out["scenes"] = [measured(folder, spec, args.seconds, args.repeat) for folder in args.scenes]
    names = ("draw_s", "write_s", "draw_cpu_s", "write_cpu_s", "frames")
    drawn, written, drawn_cpu, written_cpu, frames = (
        sum(s[name] for s in out["scenes"]) for name in names
    )
    out["writing_share"] = round(written / drawn - 1, 4)
    out["writing_share_cpu"] = round(written_cpu / drawn_cpu - 1, 4)
    out["frames_an_hour"] = round(frames / written * 3600)
    if args.codecs:
        out["codecs"] = codecs(args.scenes, spec, args.seconds)
    text = json.dumps(out, indent=2)
    print(text)
    if args.json:
        args.json.write_text(text + "\n")


def measured(folder: Path, spec: RenderSpec, seconds: float, repeat: int) -> dict[str, Any]:
    """Seconds to direct, to draw, and to draw and write one scene."""
    start = time.perf_counter()
    sight = sight_of_folder(folder, spec, seconds)
    directed = time.perf_counter() - start
    discard(sight, spec)  # compiles kernels, loads textures
    draws: list[tuple[float, float]] = []
    writes: list[tuple[float, float]] = []
    for _ in range(repeat):
        draws.append(_timed(lambda: discard(sight, spec)))
        with tempfile.TemporaryDirectory() as place:
            written = partial(draw_scene, sight, _common(folder), spec, Path(place))
            writes.append(_timed(written))
    (draw, draw_cpu), (write, write_cpu) = min(draws), min(writes)
    return {
        "scene": folder.name,
        "frames": len(sight.frames) * spec.cameras,
        "direct_s": round(directed, 3),
        "draw_s": round(draw, 3),
        "write_s": round(write, 3),
        "draw_cpu_s": round(draw_cpu, 3),
        "write_cpu_s": round(write_cpu, 3),
    }


def _timed(run: Callable[[], object]) -> tuple[float, float]:
    """Wall and processor time [s]."""
    wall, processor = time.perf_counter(), time.process_time()
    run()
    return time.perf_counter() - wall, time.process_time() - processor


def sight_of_folder(folder: Path, spec: RenderSpec, seconds: float) -> Sight:
    """What cameras see of a scene folder, of its first seconds."""
    entry = read_scene(folder)
    replay = replays_of(folder, entry.metrics)[0]
    doc = load_document(folder / "esg.json")
    verdict = SceneVerdict.from_json(entry.verdict)
    made = Replay(replay.scene, replay.rollout, verdict, doc)
    sight = sight_of(made.scene, made.rollout, made.verdict, made.doc, settings_of(spec, 0))
    last = int(np.searchsorted(sight.time_s, seconds))
    return replace(
        sight,
        frames=sight.frames[:last],
        takes=[take.at(take.time_s[:last]) for take in sight.takes],
        moved=(sight.moved[0][:last], sight.moved[1][:last]),
    )


def discard(sight: Sight, spec: RenderSpec) -> None:
    """Draws all pictures, flow and places on bodies as well, and writes none."""
    for shot in shots(sight):
        for numbers, views in shot.drawn():
            for channel in (c for c in PICTURES if c in spec.channels):
                VALUES[channel](shot, numbers, views)


def _common(folder: Path) -> dict[str, Any]:
    """Columns of a scene that belongs to no dataset."""
    names = ("run_id", "scene_key", "suite", "split", "prompt", "place", "sky")
    return {**dict.fromkeys(names, ""), "scene_id": folder.name, "seed": 0}


def codecs(folders: Sequence[Path], spec: RenderSpec, seconds: float) -> dict[str, Any]:
    """Bytes and milliseconds of one core a frame, of FFV1 and of PNG in zip."""
    channels = ("depth", "segmentation", "normal", "flow", "object_coordinates")
    total: dict[str, np.ndarray] = {c: np.zeros(6) for c in channels}
    for folder in folders:
        sight = sight_of_folder(folder, spec, seconds)
        (shot, *_) = shots(sight)
        for channel in channels:
            values = (value for n, v in shot.drawn() for value in VALUES[channel](shot, n, v))
            frames = np.stack([CODED[channel](value)[0] for value in values])
            total[channel] += (*_ffv1(channel, frames, spec), *_png(frames), len(frames))
    names = ("ffv1_kb", "ffv1_encode_ms", "ffv1_decode_ms", "png_kb", "png_encode_ms")
    return {
        c: {n: round(float(v), 2) for n, v in zip(names, values[:5] / values[5], strict=True)}
        for c, values in total.items()
    }


def _ffv1(channel: str, frames: Any, spec: RenderSpec) -> tuple[float, float, float]:
    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / "x.mkv"
        start = time.process_time()
        file = ChannelFile(path, codec_of(channel), spec.size, spec.fps)
        for frame in frames:
            file.add(frame)
        file.close()
        middle = time.process_time()
        assert np.array_equal(decoded(path), frames)
        end = time.process_time()
        return path.stat().st_size / 1e3, (middle - start) * 1e3, (end - middle) * 1e3


def _png(frames: Any) -> tuple[float, float]:
    start = time.process_time()
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, "w") as archive:
        for k, frame in enumerate(frames):
            archive.writestr(f"{k:05d}.png", png16.encode(frame))
    return len(packed.getvalue()) / 1e3, (time.process_time() - start) * 1e3


if __name__ == "__main__":
    main()
