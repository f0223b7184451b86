"""Malformed input of every kind: an exit code that says whose fault it is, and a message.

Every input is made from a sound one by a change that follows from its number, so that a case that
was found can be named again: `python -m benchmarks.faults malformed --only suite:17`.
"""

from __future__ import annotations

from collections.abc import Callable
import copy
import json
from pathlib import Path
import random
import shutil
from typing import Any
import zipfile

from benchmarks.faults.ground import PATIENCE_S, PROMPT, SUITE, Ended, esg, forked, scene_of

NASTY: tuple[Any, ...] = (  # every kind of value where another is wanted
    None,
    True,
    -1,
    0,
    10**30,
    1e308,
    -1e-308,
    float("nan"),
    float("inf"),
    "",
    " ",
    "\x00",
    "\x1b[31m",
    "../../x",
    "/etc/passwd",
    "猫" * 40,
    "\ud800",
    "x" * 5000,
    "1e999",
    [],
    {},
    [[]],
    [None],
    {"": {}},
    [1, 2],
    [0, 0, 0, 0],
    [1e200] * 4,
    "SELECT 1",
    "a/b",
    {"a": {"b": {"c": {}}}},
)
WORDS = (
    "car",
    "ball",
    "hits",
    "rolls",
    "at",
    "3 m/s",
    "-5",
    "1e400",
    "(",
    ")",
    '"',
    "'",
    "\\",
    "and",
    "then",
    "on top of",
    "9" * 300,
    "\t",
    "\n",
    "…",
    "猫",
    "%s",
    "{}",
    "<b>",
    "é" * 30,
    "the the",
    "no",
    ";",
    "0 kg",
)

LIBRARIES = (
    "duckdb",
    "pyarrow.parquet",
    "pydantic",
    "yaml",
    "cyclopts",
    "numpy",
    "scipy.spatial",
    "trimesh",
    "mcap.reader",
    "spacy",
    "esg.cli",
    "esg.commands.bench",
    "esg.graph.verifier",
    "esg.metrics",
    "esg.draft",
    "esg.dataset.plan",
    "esg.engines.manifest",
    "esg.store",
    "esg.report.run",
    "esg.compile.export",
)

Case = tuple[list[str], dict[str, str], tuple[int, ...]]
"""Arguments of a command, further variables, and the exit codes that are right."""
Make = Callable[[random.Random, Path, Path], Case]


def garbled(rng: random.Random, data: bytes) -> bytes:
    """Bytes with one to eight pieces cut out, doubled, overwritten or flipped."""
    out = bytearray(data)
    for _ in range(rng.randint(1, 8)):
        at = rng.randrange(len(out) + 1)
        size = rng.choice((1, 1, 2, 8, 64, 1024))
        kind = rng.randrange(6)
        if kind == 0:
            del out[at : at + size]
        elif kind == 1:
            out[at:at] = out[at : at + size]
        elif kind == 2:
            out[at : at + size] = rng.randbytes(min(size, 64))
        elif kind == 3 and out:
            out[at % len(out)] ^= 1 << rng.randrange(8)
        elif kind == 4:
            del out[at:]
        else:
            out[at:at] = rng.choice(
                (b"\x00", b"\xff", b"[" * size, b"{", b'"', b": ", b"\n", b"-" * 20)
            )
    return bytes(out)


def changed(rng: random.Random, tree: Any) -> Any:
    """A JSON value in which one to three places hold something else, or nothing."""
    for _ in range(rng.randint(1, 3)):
        places: list[tuple[Any, Any]] = []
        stack = [tree]
        while stack:
            node = stack.pop()
            items = list(node.items() if isinstance(node, dict) else enumerate(node))
            places += [(node, key) for key, _ in items]
            stack += [v for _, v in items if isinstance(v, dict | list)]
        if not places:
            return tree
        node, key = rng.choice(places)
        kind = rng.randrange(5)
        if kind == 0:
            del node[key]
        elif kind == 1 and isinstance(node, dict):
            node[rng.choice(("x", "", "id", "\x1b[31m", "a/b"))] = node.pop(key)
        elif kind == 2 and isinstance(node, list):
            node += [node[key]] * rng.choice((1, 50, 3000))
        else:
            node[key] = copy.deepcopy(rng.choice(NASTY))
    return tree


def json_text(tree: Any) -> bytes:
    return json.dumps(tree).encode("utf-8", "replace")


def mistaken(rng: random.Random, data: bytes) -> bytes:
    """A JSON document with a mistake: half of them in its meaning, half in its bytes."""
    return json_text(changed(rng, json.loads(data))) if rng.random() < 0.6 else garbled(rng, data)


def _suite(rng: random.Random, ground: Path, place: Path) -> Case:
    import yaml

    text = SUITE.encode()
    choice = rng.random()
    if choice < 0.45:
        text = yaml.safe_dump(changed(rng, yaml.safe_load(SUITE)), allow_unicode=True).encode(
            "utf-8", "replace"
        )
    elif choice < 0.6:
        text += b"more: [" + b"*a," * rng.randint(1, 2000) + b"]"
    else:
        text = garbled(rng, text)
    (place / "x.yaml").write_bytes(text)
    # Nothing runs: the number of runs is a mistake, too, and both are told at once.
    return ["bench", "x.yaml", "--runs", "0"], {}, (2,)


def _document(rng: random.Random, ground: Path, place: Path) -> Case:
    (place / "x.json").write_bytes(mistaken(rng, (scene_of(ground) / "esg.json").read_bytes()))
    return ["check", "x.json", *rng.choice(([], ["--json"]))], {}, (0, 2)


def _prompt(rng: random.Random, ground: Path, place: Path) -> Case:
    words = PROMPT.split() + rng.choices(WORDS, k=rng.randint(1, 60))
    rng.shuffle(words)
    text = " ".join(words)[: rng.choice((10, 200, 2000))].replace("\x00", "")
    return ["draft", *rng.choice(([], ["--json"])), "--", text], {}, (0, 2, 3)


def _prompts(rng: random.Random, ground: Path, place: Path) -> Case:
    rows = [{"prompt": PROMPT, "seed": k, "family": "f"} for k in range(3)]
    data = b"\n".join(json_text(changed(rng, row)) for row in rows)
    name = rng.choice(("x.jsonl", "x.txt", "x.yaml", "x.jsonl"))
    (place / name).write_bytes(data if rng.random() < 0.5 else garbled(rng, data))
    return ["dataset", "--prompts", name, "--out", "d", "--shard", "3/2"], {}, (2,)


def _distribution(rng: random.Random, ground: Path, place: Path) -> Case:
    import yaml

    sound = {
        "levels": {"single": 1, "chain": 2},
        "quantified": 0.5,
        "speeds": {"slow": 1},
        "movers": [],
    }
    text = yaml.safe_dump(changed(rng, sound), allow_unicode=True).encode("utf-8", "replace")
    (place / "x.yaml").write_bytes(text if rng.random() < 0.6 else garbled(rng, text))
    arguments = ["dataset", "--sample", "2", "--distribution", "x.yaml", "--out", "d"]
    return [*arguments, "--shard", "3/2"], {}, (2,)


def _scene(*names: str, ask: Callable[[random.Random], list[str]]) -> Make:
    """A scene folder of which one file is malformed."""

    def make(rng: random.Random, ground: Path, place: Path) -> Case:
        shutil.copytree(scene_of(ground), place / "scene")
        found = [p for n in names for p in sorted((place / "scene").glob(n))]
        path = rng.choice(found)
        data = path.read_bytes()
        path.write_bytes(mistaken(rng, data) if path.suffix == ".json" else garbled(rng, data))
        return ask(rng), {}, (0, 1, 2, 3)

    return make


def _parquet(rng: random.Random, ground: Path, place: Path) -> Case:
    path = rng.choice(sorted((ground / "runs" / "parts").glob("*/*.parquet")))
    (place / "x.parquet").write_bytes(garbled(rng, path.read_bytes()))
    return ["db", "ingest", "x.parquet"], {}, (0, 2)


def _database(rng: random.Random, ground: Path, place: Path) -> Case:
    (place / "runs").mkdir()
    data = (ground / "runs" / "esg.duckdb").read_bytes()
    (place / "runs" / "esg.duckdb").write_bytes(garbled(rng, data))
    return ["sql", "SELECT * FROM scenes JOIN metrics USING (scene_key)"], {}, (0, 1, 2)


def _sql(rng: random.Random, ground: Path, place: Path) -> Case:
    text = "SELECT outcome, count(*) FROM scenes WHERE seed < 3 GROUP BY outcome ORDER BY 1"
    if rng.random() < 0.5:
        words = text.split() + rng.choices(
            (*WORDS, "JOIN", "runs", "UNION", "range(100000000)"), k=4
        )
        rng.shuffle(words)
        text = " ".join(words)
    else:
        text = garbled(rng, text.encode()).replace(b"\x00", b"").decode("utf-8", "replace")
    database = str(ground / "runs" / "esg.duckdb")
    return ["sql", "--db", database, "--", text], {"ESG_SQL_SECONDS": "5"}, (0, 1, 2)


def _catalogue(rng: random.Random, ground: Path, place: Path) -> Case:
    record = {
        "key": "mug_1",
        "name": "mug",
        "parents": ["cup"],
        "dimensions_cm": [8, 8, 10],
        "mass_kg": 0.3,
        "material": "ceramic",
        "color_rgb": [1, 1, 1],
        "flags": [],
        "tags": [],
        "description": "a mug",
        "mesh_sha256": "0" * 64,
        "license": "CC0-1.0",
        "attribution": "",
        "source": "x",
    }
    folder = place / "library" / "own" / "assets"
    folder.mkdir(parents=True)
    (folder / "mug_1.json").write_bytes(mistaken(rng, json_text(record)))
    (folder.parent / "index.npz").write_bytes(rng.randbytes(200))
    (folder.parent / "meshes").mkdir()
    ask = rng.choice((["list"], ["list", "--json"], ["show", "own/mug_1"]))
    return ["assets", *ask], {"ESG_ASSET_LIBRARY": str(place / "library")}, (0, 1, 2)


def _mesh(rng: random.Random, ground: Path, place: Path) -> Case:
    source = rng.choice(sorted((scene_of(ground) / "meshes").glob("*.glb")))
    (place / "own").mkdir()
    (place / "own" / "thing.glb").write_bytes(garbled(rng, source.read_bytes()))
    variables = {"ESG_ASSET_LIBRARY": str(place / "library")}
    return ["assets", "import", "own"], variables, (0, 1, 2, 3)


def _listing(rng: random.Random, ground: Path, place: Path) -> Case:
    """A folder of models with a malformed catalogue, or a library of Sweet Home 3D."""
    mesh = sorted((scene_of(ground) / "meshes").glob("*.glb"))[0]
    variables = {"ESG_ASSET_LIBRARY": str(place / "library")}
    (place / "own").mkdir()
    if rng.random() < 0.5:
        lines = [
            "id=own",
            "name=Own",
            "id#1=own#thing",
            "name#1=Thing",
            "model#1=thing.glb",
            "width#1=20",
            "depth#1=20",
            "height#1=10",
            "modelRotation#1=1 0 0 0 1 0 0 0 1",
            "license#1=CC0",
        ]
        at = rng.randrange(len(lines))
        nasty = rng.choice(
            ("nan", "1e400", "x y", "", "9" * 5000, "1 0 0", "9 9 9 9 9 9 9 9 9", "-3")
        )
        lines[at] = f"{lines[at].partition('=')[0]}={nasty}"
        text = "\n".join(lines).encode()
        with zipfile.ZipFile(place / "own" / "own.sh3f", "w") as bundle:
            bundle.writestr(
                "PluginFurnitureCatalog.properties", rng.choice((text, garbled(rng, text)))
            )
            bundle.write(mesh, "thing.glb")
        if rng.random() < 0.3:
            data = (place / "own" / "own.sh3f").read_bytes()
            (place / "own" / "own.sh3f").write_bytes(garbled(rng, data))
    else:
        shutil.copyfile(mesh, place / "own" / "thing.glb")
        row = {"file": "thing.glb", "name": "thing", "length_cm": 20, "mass_kg": 1, "up": "y"}
        (place / "own" / "catalogue.json").write_bytes(mistaken(rng, json_text([row])))
    return ["assets", "import", "own"], variables, (0, 1, 2, 3)


def _arguments(rng: random.Random, ground: Path, place: Path) -> Case:
    names = (
        "generate",
        "bench",
        "dataset",
        "serve",
        "replay",
        "export",
        "report",
        "render",
        "sql",
        "db",
    )
    options = (
        "--seed",
        "--runs",
        "--out",
        "--json",
        "--dt",
        "--hz",
        "--cron",
        "--shard",
        "--device",
    )
    values = (
        "-1",
        "1.5",
        "nan",
        "1e999",
        "",
        "cuda:99",
        "* * * *",
        "0/0",
        "x" * 300,
        "猫",
        "--",
        "\x1b[31m",
    )
    tokens = [rng.choice(names), "--nothing-like-it"]
    for _ in range(rng.randint(0, 5)):
        tokens += [rng.choice(options), rng.choice(values)]
    return tokens, {}, (2,)


def _replayed(rng: random.Random) -> list[str]:
    return ["replay", "scene", "--engine", rng.choice(("physx", "rapier"))]


def _exported(rng: random.Random) -> list[str]:
    return [
        "export",
        "scene",
        "--to",
        rng.choice(("glb", "mjcf", "usd", "unreal", "mcap")),
        "--out",
        "o",
    ]


def _reported(rng: random.Random) -> list[str]:
    return ["report", "scene", "--out", "o.html"]


KINDS: dict[str, tuple[Make, float]] = {
    "suite": (_suite, 1.0),
    "document": (_document, 1.0),
    "prompt": (_prompt, 1.0),
    "prompts": (_prompts, 1.0),
    "distribution": (_distribution, 1.0),
    "manifest": (_scene("manifest.json", ask=_exported), 1.0),
    "replayed manifest": (_scene("manifest.json", ask=_replayed), 0.5),
    "metrics and logs": (
        _scene("metrics.json", "log.jsonl", "esg.json", "prompt.txt", ask=_reported),
        1.0,
    ),
    "recording": (_scene("rollout.npz", "rollout.mcap", "meshes/*.glb", ask=_reported), 0.5),
    "class": (_scene("unreal/*", ask=_replayed), 0.1),
    "parquet": (_parquet, 1.0),
    "database": (_database, 1.0),
    "sql": (_sql, 1.0),
    "catalogue": (_catalogue, 1.0),
    "listing": (_listing, 0.5),
    "mesh": (_mesh, 0.5),
    "arguments": (_arguments, 0.5),
}
"""Kinds of input, and how many there are of each for every hundred."""


def case(kind: str, number: int, ground: Path, place: Path) -> tuple[Case, Ended, str]:
    """Runs one malformed input; returns it, how it ended and what is wrong with that."""
    shutil.rmtree(place, ignore_errors=True)
    place.mkdir(parents=True)
    made = KINDS[kind][0](random.Random(f"{kind}:{number}"), ground, place)
    arguments, variables, allowed = made
    ended = forked(arguments, place, ground / "cache", **variables)
    if ended.code is None:
        # Threads of a library may not survive a fork, and what is still sound is replayed, which
        # takes its time on a busy machine: only what hangs by itself counts.
        ended = esg(arguments, place, ground / "cache", 6 * PATIENCE_S, **variables)
    return made, ended, ended.wrong(allowed)


def load_libraries() -> None:
    """Imports what commands need, once for all forks."""
    import importlib

    for name in LIBRARIES:
        importlib.import_module(name)
    from esg.draft import draft

    draft(PROMPT)
