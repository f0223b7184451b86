"""Memory and CPU time of very many drafts in one process.

Half of the prompts come from the dataset's scene grammar, half are one to three development prompts
of the corpus with other nouns and other numbers; no two are alike. All texts exist before the first
draft, so that resident memory grows only by what drafting keeps.
"""

from __future__ import annotations

from dataclasses import asdict, dataclass
from pathlib import Path
import random
import re
import sys
import time
from typing import Any

import numpy as np

from esg.draft import draft
from esg.lexicon import kinds
from esg.outcomes import UserError

MARK_EVERY = 1000
_NUMBER = re.compile(r"(?<![\w.,])\d+(?:\.\d+)?(?![\w.,]*\d)")


@dataclass(frozen=True)
class Soak:
    """Memory and CPU time of many drafts in one process.

    Args:
        prompts: Drafts made, each of another text.
        refused: Of them, refused with a message.
        crashed: Of them, ended by any other exception; its kinds in `crashes`.
        crashes: Up to ten of the texts that crashed, with the exception's name.
        cpu_ms: CPU time of a draft, mean [ms].
        cpu_ms_slowest: Mean of the slowest block of `MARK_EVERY` drafts [ms].
        rss_mib: Resident memory before the first and after every 1,000 drafts [MiB].
        growth_kib: Slope of resident memory over the last three quarters [KiB per 1,000 prompts].
    """

    prompts: int
    refused: int
    crashed: int
    crashes: tuple[str, ...]
    cpu_ms: float
    cpu_ms_slowest: float
    rss_mib: tuple[float, ...]
    growth_kib: float

    def text(self) -> str:
        """The figures in lines."""
        shown = self.rss_mib[:: max(1, len(self.rss_mib) // 20)]
        return "\n".join(
            [
                f"{self.prompts:,} different prompts, {self.refused} refused, "
                f"{self.crashed} crashed",
                *(f"  {c}" for c in self.crashes),
                f"{self.cpu_ms:.2f} ms CPU a prompt; slowest thousand {self.cpu_ms_slowest:.2f} ms",
                "resident memory [MiB]: " + " ".join(f"{m:.0f}" for m in shown),
                f"{self.growth_kib:+.1f} KiB per 1,000 prompts over the last three quarters",
            ]
        )

    def data(self) -> dict[str, Any]:
        """The figures as JSON."""
        return asdict(self)


def resident_mib() -> float:
    """Resident memory of this process [MiB] (Linux; elsewhere its maximum so far)."""
    try:
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    except OSError:
        import resource

        return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024.0
    return pages * 4096 / 2**20


def nouns() -> list[str]:
    """Names of objects that the drafter knows."""
    return [kind.name for kind in kinds() if kind.kind]


def varied(row: dict[str, Any], known: list[str], rng: random.Random) -> str:
    """A corpus prompt with about half of its objects and all of its numbers changed."""
    text = row["prompt"]
    for item in row["objects"]:
        if rng.random() < 0.5:
            text = re.sub(rf"\b{re.escape(item['phrase'])}\b", rng.choice(known), text)

    def other(match: re.Match[str]) -> str:
        value = float(match.group()) * rng.uniform(0.6, 1.6)
        return f"{value:.2g}" if "." in match.group() else str(max(1, round(value)))

    return _NUMBER.sub(other, text)


def texts(count: int, rows: list[dict[str, Any]], seed: int = 0) -> list[str]:
    """Different prompts in random order.

    Args:
        count: How many.
        rows: Corpus prompts to vary.
        seed: Decides which.
    """
    from esg.dataset import sample_scenes

    rng = random.Random(seed)
    known = nouns()
    found: dict[str, None] = {}
    for scene in sample_scenes(count, seed):
        if len(found) >= count // 2:
            break
        found[scene.prompt] = None
    while len(found) < count:
        parts = rng.choices(rows, k=rng.choice((1, 1, 1, 2, 3)))
        found[" ".join(varied(r, known, rng) for r in parts)] = None
    out = list(found)
    rng.shuffle(out)
    return out


def soak(count: int, rows: list[dict[str, Any]], seed: int = 0) -> Soak:
    """Drafts `count` different prompts (see `texts`) and watches resident memory."""
    prompts = texts(count, rows, seed)
    draft(prompts[0])
    marks = [(0, resident_mib())]
    refused = crashed = 0
    crashes: list[str] = []
    blocks: list[float] = []
    began = last = time.process_time()
    for k, prompt in enumerate(prompts, 1):
        try:
            draft(prompt, seed=k)
        except UserError:
            refused += 1
        except Exception as error:  # the run goes on; a crash is reported with its text
            crashed += 1
            if len(crashes) < 10:
                crashes.append(f"{type(error).__name__}: {prompt}")
        if k % MARK_EVERY == 0 or k == count:
            now = time.process_time()
            blocks.append(1000.0 * (now - last) / (k - marks[-1][0]))
            last = now
            marks.append((k, resident_mib()))
            if k % (10 * MARK_EVERY) == 0:
                ms = 1000.0 * (now - began) / k
                print(f"{k:,}: {marks[-1][1]:.1f} MiB, {ms:.2f} ms", file=sys.stderr, flush=True)
    cpu = last - began
    late = marks[len(marks) // 4 :]
    x, y = np.array(late, dtype=float).T
    slope = float(np.polyfit(x / 1000.0, 1024.0 * y, 1)[0]) if len(late) > 1 else 0.0
    return Soak(
        prompts=count,
        refused=refused,
        crashed=crashed,
        crashes=tuple(crashes),
        cpu_ms=round(1000.0 * cpu / count, 3),
        cpu_ms_slowest=round(max(blocks), 3),
        rss_mib=tuple(round(m, 1) for _, m in marks),
        growth_kib=round(slope, 2),
    )
