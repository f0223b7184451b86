"""A small image tower in the space of the frozen MiniLM text tower, and whether it helps.

    python -m benchmarks.clip_train prepare DATA.npz     # renders of the library, text embeddings
    python clip_train.py train DATA.npz OUT              # plain torch and numpy, on a GPU machine
    python -m benchmarks.clip_train report OUT           # what came of it

`prepare` renders every parametric and imported asset from eight sides at 80 x 80 and embeds its
texts and the queries of `data/retrieval_queries.csv`. `train` needs torch and this file alone:
a convolutional tower (2.3 M parameters) is trained by contrast (InfoNCE, texts of the same kind
count as right) so that a render lies near the texts of its asset. One asset in five is held out.
Measured on the held-out assets: retrieval by text alone, by image alone (an asset without a name)
and by both, with the weight of the image chosen on the training assets.
"""

from __future__ import annotations

import argparse
import hashlib
import itertools
import json
import math
from pathlib import Path
import time
from typing import Any

import numpy as np

ROOT = Path(__file__).parents[1]
SIZE, VIEWS, DIMENSION = 80, 8, 384
HELD_OUT = 5
"""One asset in so many is never shown in training."""


def prepare(target: Path, part: Path, seconds: float) -> bool:
    """Renders what is missing for at most so long; True when the data set is written."""
    from PIL import Image

    from esg.assets.imports.store import active_index
    from esg.assets.library.catalogue import Entry
    from esg.assets.library.retrieve import Decision
    from esg.assets.sheet import render_views
    from esg.assets.stage import build_configuration
    from esg.graph.models import AssetRequirement

    part.mkdir(parents=True, exist_ok=True)
    start = time.monotonic()
    angles = np.arange(VIEWS) * 2 * math.pi / VIEWS + 0.3
    eyes = [(math.cos(a), math.sin(a), 0.25 + 0.35 * (k % 2)) for k, a in enumerate(angles)]
    entries: list[Entry] = list(active_index().entries)
    for entry in entries:
        file = part / f"{_key(entry)}.npy"
        if file.is_file():
            continue
        if time.monotonic() - start > seconds:
            return False
        need = AssetRequirement(
            asset_category=entry.name,
            asset_description=entry.name,
            expected_dimensions_cm=entry.dimensions_cm,
            expected_mass_kg=entry.mass_kg,
            linear_damping=0.0,
        )
        config = build_configuration("asset", need, Decision(entry, 1.0, ()))
        views = render_views(config, eyes, 2 * SIZE)
        small = [
            np.asarray(Image.fromarray(v).resize((SIZE, SIZE), Image.Resampling.BOX)) for v in views
        ]
        np.save(file, np.stack(small))
    _pack(entries, part, target)
    return True


def _key(entry: Any) -> str:
    return hashlib.sha256(f"{entry.library}/{entry.name}/{entry.mesh_file}".encode()).hexdigest()[
        :20
    ]


def _pack(entries: list[Any], part: Path, target: Path) -> None:
    from benchmarks.retrieval import load
    from esg.assets.imports.store import active_index
    from esg.assets.library.catalogue import normalize
    from esg.assets.library.embed import embed

    index = active_index()
    kinds = sorted({k for e in entries for k in _kinds(e)})
    number = {k: i for i, k in enumerate(kinds)}
    label = np.zeros((len(entries), len(kinds)), bool)
    for i, e in enumerate(entries):
        label[i, [number[k] for k in _kinds(e)]] = True
    queries = [(t, e) for t, e in load(ROOT / "data" / "retrieval_queries.csv") if e]
    expected = np.zeros((len(queries), len(kinds)), bool)
    for i, (_, names) in enumerate(queries):
        expected[i, [number[n] for n in names if n in number]] = True
    held = np.array([int(_key(e), 16) % HELD_OUT == 0 for e in entries])
    np.savez_compressed(
        target,
        images=np.stack([np.load(part / f"{_key(e)}.npy") for e in entries]),
        texts=index.vectors.astype(np.float16),
        owner=index.owner,
        label=label,
        kinds=np.array(kinds),
        held=held,
        queries=embed([normalize(t) for t, _ in queries]).astype(np.float16),
        expected=expected,
    )
    print(f"{len(entries)} assets, {held.sum()} held out, {target.stat().st_size / 1e6:.1f} MB")


def _kinds(entry: Any) -> set[str]:
    return {entry.name} if entry.library == "parametric" else set(entry.parents[:1])


def _tower() -> Any:
    """The image tower: four stages of residual blocks, global pooling, a linear map to 384."""
    from torch import nn

    class Block(nn.Module):
        def __init__(self, width: int) -> None:
            super().__init__()
            self.body = nn.Sequential(
                nn.Conv2d(width, width, 3, padding=1, bias=False),
                nn.BatchNorm2d(width),
                nn.GELU(),
                nn.Conv2d(width, width, 3, padding=1, bias=False),
                nn.BatchNorm2d(width),
            )
            self.act = nn.GELU()

        def forward(self, x: Any) -> Any:
            return self.act(x + self.body(x))

    def stage(before: int, after: int) -> list[Any]:
        down = nn.Conv2d(before, after, 3, stride=2, padding=1, bias=False)
        return [down, nn.BatchNorm2d(after), nn.GELU(), Block(after)]

    widths = (3, 48, 96, 160, 240)
    layers: list[Any] = []
    for before, after in itertools.pairwise(widths):
        layers += stage(before, after)
    head = [
        nn.AdaptiveAvgPool2d(1),
        nn.Flatten(),
        nn.Dropout(0.3),
        nn.Linear(widths[-1], DIMENSION),
    ]
    return nn.Sequential(*layers, *head)


def _augment(x: Any, torch: Any) -> Any:
    """Random mirror, scale and shift, brightness and colour, noise."""
    n = len(x)
    angle = (torch.rand(n, device=x.device) - 0.5) * 0.5
    scale = 0.75 + 0.5 * torch.rand(n, device=x.device)
    mirror = torch.where(torch.rand(n, device=x.device) < 0.5, -1.0, 1.0)
    theta = torch.zeros(n, 2, 3, device=x.device)
    theta[:, 0, 0] = mirror * scale * angle.cos()
    theta[:, 0, 1] = -scale * angle.sin()
    theta[:, 1, 0] = mirror * scale * angle.sin()
    theta[:, 1, 1] = scale * angle.cos()
    theta[:, :, 2] = (torch.rand(n, 2, device=x.device) - 0.5) * 0.3
    grid = torch.nn.functional.affine_grid(theta, list(x.shape), align_corners=False)
    x = torch.nn.functional.grid_sample(x, grid, padding_mode="border", align_corners=False)
    x = x * (0.7 + 0.6 * torch.rand(n, 3, 1, 1, device=x.device))
    order = torch.stack([torch.randperm(3, device=x.device) for _ in range(n)])
    swap = (torch.rand(n, device=x.device) < 0.5)[:, None]
    order = torch.where(swap, order, torch.arange(3, device=x.device)[None])
    x = x.gather(1, order[:, :, None, None].expand_as(x))
    return x + 0.02 * torch.randn_like(x)


def train(data: Path, out: Path, steps: int, seconds: float, seed: int = 0) -> dict[str, Any]:
    """Trains and measures; writes `tower.npz` (float16) and `clip.json`."""
    import torch
    from torch.nn.functional import normalize

    torch.manual_seed(seed)
    device = "cuda" if torch.cuda.is_available() else "cpu"
    d = dict(np.load(data))
    images = torch.from_numpy(d["images"]).to(device).permute(0, 1, 4, 2, 3).contiguous()
    texts = torch.from_numpy(d["texts"].astype(np.float32)).to(device)
    owner = torch.from_numpy(d["owner"].astype(np.int64)).to(device)
    label = torch.from_numpy(d["label"]).to(device).float()
    held = torch.from_numpy(d["held"]).to(device)
    seen = torch.nonzero(~held).flatten()
    counts = torch.bincount(owner, minlength=len(images))
    first = torch.cumsum(counts, 0) - counts
    tower = _tower().to(device).to(memory_format=torch.channels_last)
    size = sum(p.numel() for p in tower.parameters())
    scale = torch.nn.Parameter(torch.tensor(math.log(20.0), device=device))
    optimizer = torch.optim.AdamW([*tower.parameters(), scale], lr=1.5e-3, weight_decay=0.1)
    batch = min(512, len(seen))
    start = time.monotonic()
    history: list[tuple[int, float]] = []
    for step in range(steps):
        if time.monotonic() - start > seconds:
            break
        warm = min(1.0, (step + 1) / 200)
        done = max(step / steps, (time.monotonic() - start) / seconds)
        for group in optimizer.param_groups:
            group["lr"] = 1.5e-3 * warm * 0.5 * (1 + math.cos(math.pi * min(done, 1.0)))
        i = seen[torch.randperm(len(seen), device=device)[:batch]]
        view = torch.randint(0, images.shape[1], (batch,), device=device)
        x = _augment(images[i, view].float() / 255.0, torch)
        t = texts[first[i] + (torch.rand(batch, device=device) * counts[i]).long()]
        t = normalize(t + 0.02 * torch.randn_like(t), dim=1)
        with torch.autocast(device, torch.bfloat16):
            z = tower((x - 0.5).to(memory_format=torch.channels_last))
        z = normalize(z.float(), dim=1)
        logits = scale.exp().clamp(max=60.0) * z @ t.T
        right = label[i] @ label[i].T
        right = right / right.sum(1, keepdim=True)
        loss = -(right * logits.log_softmax(1)).sum(1).mean() / 2
        loss = loss - (right.T * logits.T.log_softmax(1)).sum(1).mean() / 2
        optimizer.zero_grad(set_to_none=True)
        loss.backward()
        optimizer.step()
        if step % 250 == 0:
            history.append((step, round(float(loss), 4)))
            print(step, round(float(loss), 4), f"{time.monotonic() - start:.0f} s", flush=True)
    tower.eval()
    with torch.no_grad():
        views = torch.stack(
            [normalize(tower(images[:, k].float() / 255.0 - 0.5), dim=1) for k in range(VIEWS)], 1
        )
    pictures = normalize(views.mean(1), dim=1).cpu().numpy()
    result = measure(pictures, d)
    result["training"] = {
        "parameters": size,
        "steps": step + 1,
        "seconds": round(time.monotonic() - start, 1),
        "device": torch.cuda.get_device_name() if device == "cuda" else "cpu",
        "loss": history[:: max(1, len(history) // 12)],
        "assets": len(images),
        "held_out": int(held.sum()),
    }
    out.mkdir(parents=True, exist_ok=True)
    state = {k: v.cpu().numpy().astype(np.float16) for k, v in tower.state_dict().items()}
    np.savez_compressed(out / "tower.npz", **state)
    np.savez_compressed(out / "pictures.npz", pictures=pictures.astype(np.float16))
    (out / "clip.json").write_text(json.dumps(result, indent=1) + "\n")
    return result


def _text_scores(d: dict[str, Any], queries: np.ndarray) -> np.ndarray:
    cosine = queries.astype(np.float32) @ d["texts"].astype(np.float32).T
    best = np.full((len(queries), len(d["label"])), -1.0, np.float32)
    np.maximum.at(best.T, d["owner"], cosine.T)
    return best


def _ranks(scores: np.ndarray, right: np.ndarray) -> dict[str, float]:
    order = np.argsort(-scores, axis=1, kind="stable")
    hit = np.take_along_axis(right, order, 1)
    return {
        "top1": round(float(hit[:, 0].mean()), 4),
        "top3": round(float(hit[:, :3].any(1).mean()), 4),
        "queries": len(scores),
    }


def measure(pictures: np.ndarray, d: dict[str, Any]) -> dict[str, Any]:
    """Retrieval among held-out assets: by text, by image and by both."""
    right = d["expected"].astype(np.float32) @ d["label"].astype(np.float32).T > 0
    queries = d["queries"].astype(np.float32)
    text, image = _text_scores(d, queries), queries @ pictures.T
    result: dict[str, Any] = {}
    weights = np.linspace(0, 0.5, 11)
    chosen = 0.0
    for name, group in (("seen", ~d["held"]), ("held_out", d["held"])):
        use = right[:, group].any(1)
        s, p, r = text[use][:, group], image[use][:, group], right[use][:, group]
        mixes = {round(float(w), 2): _ranks((1 - w) * s + w * p, r) for w in weights}
        if name == "seen":
            # On pictures the tower was trained on, the best weight is an optimistic one.
            chosen = max(weights, key=lambda w: (mixes[round(float(w), 2)]["top1"], -w))
        # An unnamed asset is named by the nearest kind; candidates are all kinds' texts.
        result[name] = {
            "text": _ranks(s, r),
            "image": _ranks(p, r),
            "both": _ranks((1 - chosen) * s + chosen * p, r),
            "by_weight": mixes,
        }
    result["weight"] = round(float(chosen), 2)
    owner_kind = d["label"][d["owner"]]
    cosine = pictures[d["held"]] @ d["texts"].astype(np.float32).T
    parts = np.argsort(-cosine, axis=1)[:, :25]
    own = d["label"][d["held"]]
    hit = (owner_kind[parts] & own[:, None, :]).any(2)
    frequent = d["label"][~d["held"]].sum(0).argmax()
    result["naming"] = {
        "top1": round(float(hit[:, 0].mean()), 4),
        "top5": round(float(hit[:, :5].any(1).mean()), 4),
        "always_the_commonest_kind": round(float(own[:, frequent].mean()), 4),
        "assets": len(own),
    }
    return result


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("mode", choices=("prepare", "train", "report"))
    parser.add_argument("paths", nargs="+", type=Path)
    parser.add_argument("--steps", type=int, default=20000)
    parser.add_argument("--seconds", type=float, default=420.0)
    a = parser.parse_args()
    if a.mode == "prepare":
        folder = a.paths[1] if len(a.paths) > 1 else a.paths[0].with_suffix(".parts")
        print("written" if prepare(a.paths[0], folder, a.seconds) else "not finished: run again")
    elif a.mode == "train":
        print(json.dumps(train(a.paths[0], a.paths[1], a.steps, a.seconds), indent=1))
    else:
        print((a.paths[0] / "clip.json").read_text())


if __name__ == "__main__":
    main()
