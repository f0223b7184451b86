"""`esg assets`: the asset library."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated, Any

from cyclopts import App, Parameter

app = App(name="assets", help="List, search, show and import assets; list materials.")
MAX_COUNT = 1000
Json = Annotated[bool, Parameter(negative="")]


@app.command(name="list")
def list_(*, library: str | None = None, json: Json = False) -> int:
    """List all assets.

    Args:
        library: Only this library, e.g. parametric.
        json: Print one JSON document.
    """
    from esg.assets.commands import list_assets
    from esg.commands.console import emit, table
    from esg.outcomes import UserError

    rows = list_assets(library)
    if not rows:
        names = ", ".join(sorted({str(r["library"]) for r in list_assets()}))
        raise UserError(f"--library {library}: there is none of that name; choose one of {names}")
    if json:
        emit(rows)
        return 0
    cells = [
        [r["name"], r["category"], _size(r["dimensions_cm"]), f"{r['mass_kg']:g}", r["license"]]
        for r in rows
    ]
    print(table(["name", "category", "size cm", "mass kg", "licence"], cells))
    return 0


@app.command
def search(text: str, *, count: int = 5, json: Json = False) -> int:
    """Find the assets nearest in meaning to a text.

    Args:
        text: What is wanted, e.g. "thing to sit on".
        count: How many to show.
        json: Print one JSON document.
    """
    from esg.api.inputs import checked, in_range
    from esg.assets.commands import search_assets
    from esg.commands.console import emit, table

    checked(lambda: _said(text), lambda: in_range("--count", count, 1, MAX_COUNT))
    found = search_assets(text, count)
    if json:
        emit(found)
        return 0
    rows = [
        [
            r["name"],
            r["category"],
            _size(r["dimensions_cm"]),
            f"{r['mass_kg']:g}",
            f"{r['score']:.2f}",
            r["description"][:56],
        ]
        for r in found["results"]
    ]
    print(table(["asset", "kind", "size cm", "mass kg", "score", "what it is"], rows))
    print(f"\n{found['verdict']}")
    return 0


@app.command
def show(name: str, *, json: Json = False) -> int:
    """Show everything known about one asset.

    Args:
        name: Its name as `esg assets list` gives it.
        json: Print one JSON document.
    """
    from esg.assets.commands import show as run
    from esg.commands.console import emit

    facts = run(name)
    if json:
        emit(facts)
        return 0
    for key, value in facts.items():
        if key != "configuration":
            text = ", ".join(map(str, value)) if isinstance(value, list) else value
            print(f"{key}: {text}")
    config: dict[str, Any] = facts["configuration"]
    for key in ("dimensions_cm", "mass_kg", "friction", "restitution", "is_movable"):
        print(f"{key}: {config[key]}")
    print("proxies: " + ", ".join(p["kind"] for p in config["proxies"]))
    return 0


@app.command
def materials(*, sheet: Path | None = None, json: Json = False) -> int:
    """List all materials: how they slide, bounce, weigh and look.

    Args:
        sheet: Draw a picture of them into this file (.png, .jpg or .webp).
        json: Print one JSON document.
    """
    from esg.assets.commands import draw_materials, list_materials
    from esg.commands.console import emit, table

    if sheet is not None:
        draw_materials(sheet)
    rows = list_materials()
    if json:
        emit(rows)
        return 0
    keys = ("density", "friction", "restitution", "roughness", "metalness")
    cells = [
        [r["name"], *(f"{r[k]:g}" for k in keys), r["color"], r["texture"] or "-"] for r in rows
    ]
    print(table(["material", "kg/m3", *keys[1:], "colour", "texture"], cells))
    return 0


@app.command(name="import")
def import_(
    path: Path,
    *,
    library: str | None = None,
    json: Json = False,
) -> int:
    """Import meshes (a folder, or a Sweet Home 3D library) or a model with joints (URDF, MJCF).

    Args:
        path: Folder, .sh3f, .urdf or .xml.
        library: Name of the new library; default the file's.
        json: Print one JSON document.
    """
    from esg.assets.commands import import_assets
    from esg.commands.console import emit
    from esg.outcomes import UserError

    if not path.exists():
        raise UserError(f"{path} does not exist")
    report = import_assets(path, library)
    if json:
        emit(report)
    else:
        print(
            f"library {report['library']} in {report['folder']}: {report['imported']} imported, "
            f"{report['unchanged']} unchanged, {len(report['problems'])} problems"
        )
        for item in report["problems"]:
            print(f"  {item['asset']}: {item['problem']}")
    return 3 if any(not p["problem"].startswith("warning") for p in report["problems"]) else 0


def _said(text: str) -> None:
    from esg.outcomes import UserError

    if not text.strip():
        raise UserError('TEXT is empty; say what to search for, e.g. "thing to sit on"')


def _size(dimensions: list[float]) -> str:
    return " x ".join(f"{d:g}" for d in dimensions)
