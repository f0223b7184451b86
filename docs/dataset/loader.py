"""Clips of a dataset in PyTorch: python loader.py FOLDER trains a small network on them."""

from pathlib import Path
import sys

import av
import numpy as np
import pyarrow.parquet as pq
import torch


def frames(path):
    with av.open(str(path)) as film:
        kind = "rgb24" if path.suffix == ".mp4" else None
        return np.stack([f.to_ndarray(format=kind) for f in film.decode(video=0)])


class Clips(torch.utils.data.Dataset):
    def __init__(self, folder, split="train", length=16):
        files = sorted(Path(folder).glob(f"clips/{split}-*.parquet"))
        tables = [pq.read_table(f, columns=["prompt", "files", "n_frames"]) for f in files]
        self.rows = [row for table in tables for row in table.to_pylist()]
        self.folder, self.length = Path(folder), length

    def __len__(self):
        return len(self.rows)

    def __getitem__(self, index):
        row = self.rows[index]  # clips differ in length: as many frames of each
        at = np.linspace(0, row["n_frames"] - 1, self.length).round().astype(int)
        paths = {f["channel"]: self.folder / f["path"] for f in row["files"]}
        rgb = torch.from_numpy(frames(paths["rgb"])[at]).permute(0, 3, 1, 2).float() / 255
        ids = torch.from_numpy(frames(paths["segmentation"])[at].astype(np.int64))
        return {"rgb": rgb, "ids": ids, "prompt": row["prompt"]}


def train(batches, steps):
    """Learns to tell bodies (1) from everything else (0); returns the loss of every step."""
    first, last = torch.nn.Conv2d(3, 16, 5, padding=2), torch.nn.Conv2d(16, 1, 5, padding=2)
    net = torch.nn.Sequential(first, torch.nn.ReLU(), last)
    optimizer, losses = torch.optim.Adam(net.parameters(), 3e-3), []
    measure = torch.nn.BCEWithLogitsLoss()
    for _, (rgb, ids) in zip(range(steps), batches, strict=False):
        loss = measure(net(rgb)[:, 0], (ids > 1).float())
        optimizer.zero_grad()
        loss.backward()
        optimizer.step()
        losses.append(loss.item())
    return losses


def endless(loader):
    while True:
        for batch in loader:
            yield batch["rgb"].flatten(0, 1), batch["ids"].flatten(0, 1)


if __name__ == "__main__":
    clips = torch.utils.data.DataLoader(Clips(sys.argv[1]), batch_size=2, shuffle=True)
    losses = train(endless(clips), 100)
    print(f"loss {losses[0]:.3f} at first, {losses[-1]:.3f} after {len(losses)} steps")
