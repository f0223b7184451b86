"""What the asset stage costs: resolving twenty objects, and importing a folder of libraries.

    python -m benchmarks.assets resolve [--json FILE]
    python -m benchmarks.assets import FOLDER [--seconds S] [--json FILE]

`resolve` times twenty warm objects (ten named by the library, ten by other words) in CPU time.
`import` imports FOLDER into `$ESG_ASSET_LIBRARY`, stopping after S seconds as if it were killed;
run it again to resume, and the file adds up the runs: CPU and wall time, peak memory, problems.
"""

from __future__ import annotations

import argparse
from collections import Counter
import json
from pathlib import Path
import resource
import time
from typing import Any

NAMED = ("car", "wheelie bin", "picnic table", "bowling pin", "desk", "dog", "laptop", "oak tree",
         "traffic cone", "brick")  # fmt: skip
FREE = ("rusty oil drum", "office swivel chair", "supermarket trolley", "bottle of wine",
        "kids scooter", "wooden rowing boat", "grey wolf", "park bench made of iron",
        "old steam engine", "unknown gizmo")  # fmt: skip


def resolve_twenty() -> dict[str, Any]:
    """CPU time of resolving twenty objects: first and median of nine warm repetitions [s]."""
    from esg.assets.library.embed import _embed_one
    from esg.assets.stage import configure
    from esg.graph.models import AssetRequirement

    needs = [
        AssetRequirement(
            asset_category=name,
            asset_description=name,
            expected_dimensions_cm=(60.0, 60.0, 60.0),
            expected_mass_kg=8.0,
        )
        for name in (*NAMED, *FREE)
    ]
    times = []
    for _ in range(10):
        # Texts embedded before would come from the cache: a fresh scene brings fresh words.
        _embed_one.cache_clear()
        start = time.process_time()
        for k, need in enumerate(needs):
            configure(f"a{k}", need)
        times.append(time.process_time() - start)
    warm = sorted(times[1:])
    return {"objects": len(needs), "first_s": round(times[0], 3), "warm_s": round(warm[4], 4)}


class _Stopped(Exception):
    """Stands for the kill signal."""


def import_run(folder: Path, seconds: float | None, record: Path | None) -> dict[str, Any]:
    """One run of an import, added to the figures of the earlier ones."""
    from esg.assets.imports.importer import import_folder

    earlier = json.loads(record.read_text()) if record and record.is_file() else {"runs": []}
    start, cpu = time.monotonic(), time.process_time()
    seen = 0

    def progress(count: int, name: str) -> None:
        nonlocal seen
        seen = count
        if seconds is not None and time.monotonic() - start > seconds:
            raise _Stopped

    run: dict[str, Any] = {}
    try:
        report = import_folder(folder, progress=progress, library="sweethome")
        kinds = Counter(
            p.split(":")[0] if p.startswith("warning") else "left out" for _, p in report.problems
        )
        run |= {
            "finished": True,
            "imported": len(report.imported),
            "unchanged": len(report.unchanged),
        }
        earlier["problems_of_last_run"] = dict(kinds)
        earlier["notes"] = Counter(
            p.split(":")[-1].strip().split(" from ")[0] for _, p in report.problems
        )
    except _Stopped:
        run |= {"finished": False, "reached": seen - 1}
    run |= {
        "wall_s": round(time.monotonic() - start, 1),
        "cpu_s": round(time.process_time() - cpu, 1),
        "peak_mb": round(resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024),
    }
    earlier["runs"].append(run)
    earlier["cpu_s"] = round(sum(r["cpu_s"] for r in earlier["runs"]), 1)
    earlier["wall_s"] = round(sum(r["wall_s"] for r in earlier["runs"]), 1)
    earlier["peak_mb"] = max(r["peak_mb"] for r in earlier["runs"])
    return earlier


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=("resolve", "import"))
    parser.add_argument("folder", nargs="?", type=Path)
    parser.add_argument("--seconds", type=float)
    parser.add_argument("--json", type=Path)
    a = parser.parse_args()
    if a.what == "import" and a.folder is None:
        parser.error("import needs FOLDER")
    result = resolve_twenty() if a.what == "resolve" else import_run(a.folder, a.seconds, a.json)
    text = json.dumps(result, indent=1)
    print(text)
    if a.json:
        a.json.write_text(text + "\n")


if __name__ == "__main__":
    main()
