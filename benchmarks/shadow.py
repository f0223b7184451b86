"""Two checkouts side by side: for which prompts does a stage give another result?

    python -m benchmarks.shadow OLD NEW                            # drafts of all prompts
    python -m benchmarks.shadow OLD NEW --stages draft,cast,layout,plan --sample 60 --jobs 2
    python -m benchmarks.shadow main . --only fresh fresh2 --stages plan --at-least 1

OLD and NEW are folders of checkouts or git revisions. Compared are canonical JSON without
provenance (which holds versions of code) of

- draft: the document of every prompt of `data/prompts` (each wording of `rewordings.tsv` with one
  of its stories) and of every scene of `data/suites`; a refusal counts as its message;
- cast: the document with assets resolved and fitted to the timeline;
- layout: the document with every node placed;
- plan: scene, variables, and the control program at the nominal theta.

All but the draft take seconds a scene: they run for the suites and a seeded sample of the prompts.
Each side runs in processes of its own; results are kept by a hash of the side's sources, so that a
second comparison with the same OLD runs NEW only.
"""

from __future__ import annotations

import argparse
from collections.abc import Generator, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
import contextlib
from dataclasses import dataclass, fields, is_dataclass
import enum
import hashlib
import importlib
import json
import os
from pathlib import Path
import random
import sqlite3
import subprocess
import sys
import tempfile
from typing import Any
import zlib

STAGES = ("draft", "cast", "layout", "plan")
SHOWN_DIFFERENCES = 4
"""Differing places named for each prompt."""
_BIG_ARRAY = 256
"""Arrays with more entries are compared by their digest."""
MOST_KEPT = 24
"""States of the sources whose results are kept; the longest unused go first."""
_SCHEMA = "1"
"""Of what is compared: results kept under another one are not used."""


@dataclass(frozen=True)
class Prompt:
    """A prompt to compare: `name` is "file/id"; of held-out ones no text is ever shown."""

    name: str
    text: str
    suite: bool = False
    held_out: bool = False


@dataclass(frozen=True)
class Difference:
    """Where two results differ: JSON pointer, and both values as JSON ("" where absent)."""

    pointer: str
    old: str
    new: str


def difference(old: Any, new: Any, pointer: str = "") -> Iterator[Difference]:
    """Every place where two JSON values differ, in order of the keys."""
    if isinstance(old, dict) and isinstance(new, dict):
        for key in sorted({*old, *new}):
            at = f"{pointer}/{key.replace('~', '~0').replace('/', '~1')}"
            if key in old and key in new:
                yield from difference(old[key], new[key], at)
            else:
                yield Difference(at, _short(old, key), _short(new, key))
    elif isinstance(old, list) and isinstance(new, list):
        for k in range(max(len(old), len(new))):
            if k < len(old) and k < len(new):
                yield from difference(old[k], new[k], f"{pointer}/{k}")
            else:
                yield Difference(f"{pointer}/{k}", _short(old, k), _short(new, k))
    elif old != new or type(old) is not type(new):
        yield Difference(pointer or "/", _brief(old), _brief(new))


def _short(value: Any, key: Any) -> str:
    inside = key in value if isinstance(value, dict) else key < len(value)
    return _brief(value[key]) if inside else ""


def _brief(value: Any) -> str:
    text = json.dumps(value, ensure_ascii=False, sort_keys=True)
    return text if len(text) <= 100 else text[:97] + "..."


def plain(value: Any) -> Any:
    """Plain JSON of documents, records and arrays, in which equal numbers read alike.

    Names of classes do not enter: a record that moves or is renamed stays equal.
    """
    if isinstance(value, enum.Enum):
        return plain(value.value)
    if isinstance(value, float):
        if value != value or abs(value) == float("inf"):
            return str(value)
        return int(value) if value.is_integer() and abs(value) < 2.0**53 else value
    if value is None or isinstance(value, (str, int)):
        return value
    if isinstance(value, dict):
        return {str(k): plain(v) for k, v in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(v) for v in value]
    if isinstance(value, (set, frozenset)):
        return sorted((plain(v) for v in value), key=str)
    if hasattr(value, "model_dump"):
        return plain(value.model_dump(by_alias=True, exclude_none=True))
    if is_dataclass(value):
        pairs = ((f.name, getattr(value, f.name)) for f in fields(value))
        return {k: plain(v) for k, v in pairs if not callable(v) and v is not None}
    if hasattr(value, "tolist"):
        if getattr(value, "size", 0) > _BIG_ARRAY:
            return {
                "shape": list(value.shape),
                "sha256": hashlib.sha256(value.tobytes()).hexdigest(),
            }
        return plain(value.tolist())
    return str(value)


def _door(name: str, *modules: str) -> Any:
    """A function under the first module that has it: checkouts differ in where things lie."""
    for module in modules:
        try:
            return getattr(importlib.import_module(module), name)
        except (ImportError, AttributeError):
            continue
    raise ImportError(f"no {name} in any of {', '.join(modules)}; add its module to shadow's list")


def _document(doc: Any) -> Any:
    tree = plain(doc)
    tree.pop("provenance", None)
    return tree


def _run_stages(text: str, stages: tuple[str, ...], seed: int) -> Iterator[tuple[str, Any]]:
    """Results of one prompt, stage by stage; those that are not asked for are only passed through.

    What a stage refuses (or where it crashes) is its result, and the last one.
    """
    last = max(STAGES.index(s) for s in stages)
    stage = STAGES[0]
    doc: Any = None
    try:
        for stage in STAGES[: last + 1]:
            if stage == "plan":
                result = _plan(doc, seed)
            else:
                doc = _advance(stage, doc, text, seed)
                result = _document(doc)
            if stage in stages:
                yield stage, result
    except Exception as error:
        kind = "refused" if type(error).__name__ == "UserError" else type(error).__name__
        for skipped in STAGES[STAGES.index(stage) : last + 1]:
            if skipped in stages:
                yield skipped, {"stopped_at": stage, kind: str(error)}


def _advance(stage: str, doc: Any, text: str, seed: int) -> Any:
    if stage == "draft":
        return _door("draft", "esg.draft")(text, seed=seed)
    if stage == "cast":
        resolved = _door("resolve", "esg.assets")(doc, seed=seed)
        return _door("fit_assets", "esg.dynamics", "esg.assets")(resolved)
    hints = None
    if doc.timeline_system is not None:
        hints = _door("start_hints", "esg.dynamics")(doc, seed=seed)
    return _door("solve", "esg.layout")(doc, seed=seed, hints=hints)


def _plan(doc: Any, seed: int) -> Any:
    scene = _door("build_scene", "esg.dynamics")(doc)
    if doc.timeline_system is None:
        return {"scene": plain(scene)}
    homes = ("esg.dynamics.plan.plan", "esg.dynamics.plan", "esg.dynamics.planning", "esg.dynamics")
    plan = _door("make_plan", *homes)(doc, scene, seed=seed)
    theta = plan.initial()
    return {
        "scene": plain(scene),
        "variables": plain(plan.variables),
        "theta": plain(theta),
        "program": plain(plan.compile(theta)),
        "starts": plain(plan.starts(theta)),
        "duration": plain(plan.duration),
    }


def _work(root: Path) -> int:
    """Answers jobs on standard input, one JSON line each, with a line for each stage's result."""
    import esg

    home = Path(str(esg.__file__)).resolve()
    if root.resolve() not in home.parents:
        raise SystemExit(f"esg of {home.parent} was imported in place of {root}/esg")
    answers, sys.stdout = sys.stdout, sys.stderr  # whatever a stage prints is no answer
    for line in sys.stdin:
        job = json.loads(line)
        for stage, result in _run_stages(job["text"], tuple(job["stages"]), job["seed"]):
            body = json.dumps(result, sort_keys=True, ensure_ascii=False)
            print(json.dumps([job["text"], stage, body]), file=answers, flush=True)
    return 0


def _list_prompts(root: Path) -> int:
    """Prints the prompts of a checkout's data, one JSON line each; rewordings need its code."""
    for prompt in [*_written(root), *_reworded(), *_suites(root)]:
        print(json.dumps(prompt.__dict__))
    return 0


def _written(root: Path) -> Iterator[Prompt]:
    for path in sorted((root / "data" / "prompts").glob("*.jsonl")):
        for line in path.read_text(encoding="utf-8").splitlines():
            row = json.loads(line)
            yield Prompt(f"{path.stem}/{row['id']}", row["prompt"], held_out=row["split"] != "dev")


def _reworded() -> Iterator[Prompt]:
    from benchmarks.metamorphic import rows

    told: dict[str, list[dict[str, Any]]] = {}
    for wording, row in rows():
        told.setdefault(f"{row['band']} {wording}", []).append(row)
    for n, stories in enumerate(told.values()):
        row = stories[n % len(stories)]
        yield Prompt(f"rewordings/{row['id']}-{n:04}", row["prompt"])


def _suites(root: Path) -> Iterator[Prompt]:
    import yaml

    for path in sorted((root / "data" / "suites").glob("*.yaml")):
        for scene in yaml.safe_load(path.read_text(encoding="utf-8"))["scenes"]:
            yield Prompt(f"{path.stem}/{scene['id']}", scene["prompt"], suite=True)


class Kept:
    """Results of one state of the sources by prompt, stage and seed, in one SQLite file."""

    def __init__(self, folder: Path, root: Path) -> None:
        folder.mkdir(parents=True, exist_ok=True)
        self.path = folder / f"{source_digest(root)}.sqlite"
        self.path.touch()
        by_age = sorted(folder.glob("*.sqlite"), key=lambda p: p.stat().st_mtime)
        for path in by_age[:-MOST_KEPT]:
            path.unlink()
        with self._open() as db:
            db.execute("PRAGMA journal_mode=WAL")
            db.execute(
                "CREATE TABLE IF NOT EXISTS results (prompt TEXT, stage TEXT, seed INTEGER, "
                "body BLOB, PRIMARY KEY (prompt, stage, seed))"
            )

    @contextlib.contextmanager
    def _open(self) -> Generator[sqlite3.Connection]:
        db = sqlite3.connect(self.path, timeout=60)
        try:
            with db:
                yield db
        finally:
            db.close()

    def write(self, answers: Iterable[tuple[str, str, str]], seed: int) -> None:
        """Stores (prompt, stage, canonical JSON)."""
        rows = [(p, s, seed, zlib.compress(body.encode())) for p, s, body in answers]
        with self._open() as db:
            db.executemany("INSERT OR REPLACE INTO results VALUES (?, ?, ?, ?)", rows)

    def read(self, stage: str, seed: int) -> dict[str, bytes]:
        """Compressed canonical JSON by prompt."""
        with self._open() as db:
            query = "SELECT prompt, body FROM results WHERE stage = ? AND seed = ?"
            return dict(db.execute(query, (stage, seed)).fetchall())


def source_digest(root: Path) -> str:
    """Hash of all sources and data of a checkout's package."""
    digest = hashlib.sha256(_SCHEMA.encode())
    for path in sorted((root / "esg").rglob("*")):
        if path.is_file() and "__pycache__" not in path.parts:
            digest.update(path.relative_to(root).as_posix().encode())
            digest.update(hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()[:20]


def _command(root: Path, mode: str) -> tuple[list[str], dict[str, str]]:
    # -P: the folder of this script is no place to import from
    command = [sys.executable, "-P", str(Path(__file__).resolve()), mode, str(root)]
    return command, {**os.environ, "PYTHONPATH": str(root), "PYTHONDONTWRITEBYTECODE": "1"}


def list_prompts(root: Path) -> list[Prompt]:
    """All prompts of a checkout's data, those of suites last."""
    command, env = _command(root, "--list")
    done = subprocess.run(command, env=env, cwd=root, check=True, capture_output=True, text=True)
    return [Prompt(**json.loads(line)) for line in done.stdout.splitlines()]


def run_side(
    root: Path, kept: Kept, wanted: dict[str, tuple[str, ...]], seed: int, jobs: int
) -> None:
    """Computes what is wanted (stages by prompt) and not yet kept, in `jobs` processes."""
    have = {s: kept.read(s, seed).keys() for s in STAGES}
    missing = {p: tuple(s for s in stages if p not in have[s]) for p, stages in wanted.items()}
    todo = [
        json.dumps({"text": p, "stages": stages, "seed": seed})
        for p, stages in missing.items()
        if stages
    ]
    if todo:
        with ThreadPoolExecutor(jobs) as pool:
            parts = [pool.submit(_run_jobs, root, kept, todo[k::jobs], seed) for k in range(jobs)]
            for part in parts:
                part.result()


def _run_jobs(root: Path, kept: Kept, todo: list[str], seed: int, batch: int = 50) -> None:
    if not todo:
        return
    command, env = _command(root, "--worker")
    with tempfile.TemporaryFile("w+", encoding="utf-8") as jobs:
        jobs.write("\n".join(todo) + "\n")
        jobs.seek(0)
        worker = subprocess.Popen(
            command, env=env, cwd=root, stdin=jobs, stdout=subprocess.PIPE, text=True
        )
        assert worker.stdout is not None
        answers: list[tuple[str, str, str]] = []
        for line in worker.stdout:
            prompt, stage, body = json.loads(line)
            answers.append((prompt, stage, body))
            if len(answers) >= batch:
                kept.write(answers, seed)
                answers.clear()
        kept.write(answers, seed)
    if worker.wait():
        raise SystemExit(f"the worker of {root} ended with {worker.returncode}; see above")


@dataclass
class Result:
    """How many prompts give equal results in a stage, and which do not."""

    stage: str
    equal: int
    different: dict[str, list[Difference]]

    @property
    def share(self) -> float:
        return self.equal / max(1, self.equal + len(self.different))


def compare(
    stage: str, prompts: list[Prompt], old: dict[str, bytes], new: dict[str, bytes]
) -> Result:
    """Compares one stage's results (compressed canonical JSON by prompt text)."""
    result = Result(stage, 0, {})
    for prompt in prompts:
        a, b = zlib.decompress(old[prompt.text]), zlib.decompress(new[prompt.text])
        if a == b:
            result.equal += 1
        else:
            result.different[prompt.name] = list(difference(json.loads(a), json.loads(b)))
    return result


def describe(
    result: Result, prompts: dict[str, Prompt], most: int, held_out: bool
) -> Iterator[str]:
    """Lines for people: the first prompts that differ, each with its first differing places."""
    for name, places in list(result.different.items())[:most]:
        prompt = prompts[name]
        if prompt.held_out and not held_out:
            yield f"{result.stage} {name}: differs at {len(places)} places (held out: not shown)"
            continue
        yield f"{result.stage} {name}: {prompt.text!r} differs at {len(places)} places"
        for place in places[:SHOWN_DIFFERENCES]:
            yield f"    {place.pointer}: {place.old or 'absent'} -> {place.new or 'absent'}"


@contextlib.contextmanager
def checkout(name: str) -> Generator[Path]:
    """The folder of a checkout, or a temporary worktree of a git revision."""
    if (Path(name) / "esg" / "__init__.py").is_file():
        yield Path(name).resolve()
        return
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder) / "tree"
        add = ["git", "worktree", "add", "--detach", str(root), name]
        done = subprocess.run(add, capture_output=True, text=True)
        if done.returncode:
            raise SystemExit(f"{name!r} is no checkout and no revision: {done.stderr.strip()}")
        try:
            yield root
        finally:
            subprocess.run(["git", "worktree", "remove", "--force", str(root)], check=False)


def _arguments(argv: list[str] | None) -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("old", help="folder of a checkout, or a git revision")
    parser.add_argument("new", help="folder of a checkout, or a git revision")
    parser.add_argument("--stages", default="draft", help="of " + ",".join(STAGES))
    parser.add_argument(
        "--sample",
        type=int,
        default=0,
        metavar="K",
        help="prompts beside the suites after the draft stage",
    )
    parser.add_argument("--only", nargs="+", metavar="FILE", help="these prompt files and suites")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="processes a side")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--at-least",
        type=float,
        default=1.0,
        metavar="SHARE",
        help="of equal results in every stage; else exit code 1",
    )
    parser.add_argument("--show", type=int, default=20, metavar="N", help="differing prompts shown")
    parser.add_argument("--open-held-out", action="store_true", help="show held-out prompts, too")
    parser.add_argument("--out", metavar="FILE", help="write everything that differs here (JSON)")
    parser.add_argument(
        "--kept",
        default=str(Path(tempfile.gettempdir()) / "esg-shadow"),
        metavar="FOLDER",
        help="where results are kept",
    )
    args = parser.parse_args(argv)
    args.stages = tuple(s for s in STAGES if s in args.stages.split(","))
    if not args.stages:
        parser.error(f"--stages: choose from {', '.join(STAGES)}")
    return args


def main(argv: list[str] | None = None) -> int:
    """Prints equal and different results of each stage; returns the exit code."""
    argv = sys.argv[1:] if argv is None else argv
    if argv[:1] == ["--worker"]:
        return _work(Path(argv[1]))
    if argv[:1] == ["--list"]:
        return _list_prompts(Path(argv[1]))
    args = _arguments(argv)
    with checkout(args.old) as old, checkout(args.new) as new:
        prompts = list_prompts(new)
        if args.only:
            prompts = [p for p in prompts if p.name.split("/")[0] in args.only]
        asked = _asked(prompts, args.stages, args.sample, args.seed)
        wanted: dict[str, tuple[str, ...]] = {}
        for stage, chosen in asked.items():
            for p in chosen:
                wanted[p.text] = (*wanted.get(p.text, ()), stage)
        sides = [(root, Kept(Path(args.kept), root)) for root in (old, new)]
        with ThreadPoolExecutor(2) as pool:
            running = [
                pool.submit(run_side, root, kept, wanted, args.seed, args.jobs)
                for root, kept in sides
            ]
            for side in running:
                side.result()
        results = [
            compare(stage, chosen, *(kept.read(stage, args.seed) for _, kept in sides))
            for stage, chosen in asked.items()
        ]
    by_name = {p.name: p for p in prompts}
    for result in results:
        for line in describe(result, by_name, args.show, args.open_held_out):
            print(line)
    print(f"{'stage':<8}{'equal':>7}{'different':>11}{'equal [%]':>11}")
    for r in results:
        print(f"{r.stage:<8}{r.equal:>7}{len(r.different):>11}{100 * r.share:>11.2f}")
    if args.out:
        _write(Path(args.out), results, by_name, args.open_held_out)
    return int(any(r.share < args.at_least for r in results))


def _asked(
    prompts: list[Prompt], stages: tuple[str, ...], sample: int, seed: int
) -> dict[str, list[Prompt]]:
    """Prompts by stage: all for the draft, else those of suites and a sample of the others."""
    others = [p for p in prompts if not p.suite]
    chosen = random.Random(seed).sample(others, min(sample, len(others)))
    dear = [*(p for p in prompts if p.suite), *chosen]
    return {s: prompts if s == "draft" else dear for s in stages}


def _write(path: Path, results: list[Result], prompts: dict[str, Prompt], held_out: bool) -> None:
    data = {
        r.stage: {
            "equal": r.equal,
            "different": {
                name: [p.__dict__ for p in places]
                for name, places in r.different.items()
                if held_out or not prompts[name].held_out
            },
        }
        for r in results
    }
    path.write_text(json.dumps(data, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


if __name__ == "__main__":
    sys.exit(main())
