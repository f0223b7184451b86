"""The page itself: one HTML file with data, styles and scripts inside.

Nothing of a scene is ever written as markup: data travel as JSON with `<` escaped, or as base64,
and the script only sets text. A content security policy allows the page's own script and style and
no address at all.
"""

from __future__ import annotations

import base64
from collections.abc import Callable, Iterable, Iterator, Sequence
import hashlib
import html
import json
from pathlib import Path
from typing import Any

from esg.files import atomic_file, refused
from esg.outcomes import UserError
from esg.report.meshes import MeshLibrary
from esg.report.payload import index_entry, scene_chunk, thumbnail
from esg.report.replays import replays_of
from esg.report.run import Run, SceneEntry
from esg.scenereading import collected, first_line

STATIC = Path(__file__).parent / "static"


def write_report(
    run: Run,
    path: Path,
    *,
    engines: Sequence[str] = (),
    title: str = "",
    files: str | None = None,
    on_scene: Callable[[SceneEntry], None] = lambda _: None,
    on_problem: Callable[[str], None] = lambda _: None,
) -> Path:
    """Writes the report of a run.

    Damaged files are named on the page and to `on_problem`; the others are shown.

    Args:
        run: The run.
        path: Of the HTML file; it appears complete or not at all.
        engines: Engines whose replays are set beside the recorded ones.
        title: Of the page; default the name of the folder.
        files: Where the scene folders are, seen from the page; default found out.
        on_scene: Called after every scene.
        on_problem: Called with every damaged file, its reason and its remedy.

    Raises:
        UserError: If the file cannot be written.
    """
    from esg import __version__

    title = title or run.folder.resolve().name
    problems: list[list[str]] = [[] for _ in run.scenes]
    for problem in run.problems:
        on_problem(problem)

    def index() -> dict[str, Any]:
        scenes = [
            index_entry(s, n, _key(run, s), [_short(s.folder, p) for p in problems[n]])
            for n, s in enumerate(run.scenes)
        ]
        return {**facts, "scenes": scenes}

    def after(number: int) -> None:
        for problem in problems[number]:
            on_problem(problem)
        on_scene(run.scenes[number])

    facts = {
        "title": title,
        "single": run.single,
        "version": __version__,
        "facts": run.facts,
        "totals": run.totals,
        "rows": run.rows,
        "before": _plain(run.before),
        "paper": run.paper,
        "files": _relative(run, path) if files is None else files,
        "problems": [_short(run.folder, p) for p in run.problems],
    }
    with refused(path), atomic_file(path) as file:
        for piece in page(title, index, _chunks(run.scenes, engines, problems, after)):
            file.write(piece.encode())
    return path


def page(
    title: str, index: Callable[[], dict[str, Any]], chunks: Iterable[tuple[str, str]]
) -> Iterator[str]:
    """The pieces of the HTML file.

    Args:
        title: Plain text.
        index: Gives what the list needs, JSON; asked after the chunks, whose making may find
            something to tell.
        chunks: Element ids and base64 texts.
    """
    script = (STATIC / "report.js").read_text(encoding="utf-8")
    style = (STATIC / "report.css").read_text(encoding="utf-8")
    notices = (STATIC / "LICENSES.txt").read_text(encoding="utf-8")
    policy = (
        f"default-src 'none'; script-src '{_digest(script)}'; style-src 'unsafe-inline'; "
        "img-src blob: data:; media-src blob:; base-uri 'none'; form-action 'none'"
    )
    yield (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{html.escape(policy)}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        '<meta name="color-scheme" content="light dark">\n'
        '<link rel="icon" href="data:,">\n'
        f"<title>{html.escape(title)}</title>\n<style>{style}</style>\n</head>\n<body>\n"
        '<div id="app"><noscript>This page needs JavaScript to show its data.</noscript></div>\n'
    )
    for key, text in chunks:
        yield f'<script type="text/plain" id="{html.escape(key)}">{text}</script>\n'
    yield (
        f'<script type="application/json" id="index">{embed_json(index())}</script>\n'
        f'<script type="text/plain" id="licenses">{embed_json(notices)}</script>\n'
        f"<script>{script}</script>\n</body>\n</html>\n"
    )


def embed_json(value: Any) -> str:
    """JSON that is safe between script tags."""
    text = json.dumps(value, separators=(",", ":"), ensure_ascii=True, allow_nan=False)
    return text.replace("<", "\\u003c").replace(">", "\\u003e").replace("&", "\\u0026")


def _digest(script: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()


def _chunks(
    scenes: Sequence[SceneEntry],
    engines: Sequence[str],
    problems: Sequence[list[str]],
    on_scene: Callable[[int], None],
) -> Iterator[tuple[str, str]]:
    meshes = MeshLibrary()
    for number, scene in enumerate(scenes):
        told: list[str] = []
        thumb = "" if scene.refused else collected(told, lambda s=scene: thumbnail(s.folder), "")
        if thumb:
            yield f"thumb-{number}", thumb
        yield f"scene-{number}", _chunk(scene, engines, meshes, told)
        problems[number].extend(dict.fromkeys([*scene.problems, *told]))
        on_scene(number)
    for key, text in meshes.chunks.items():
        yield f"mesh-{key}", text
    for key, text in meshes.pictures.items():
        if text:
            yield f"picture-{key}", text


def _chunk(scene: SceneEntry, engines: Sequence[str], meshes: MeshLibrary, told: list[str]) -> str:
    """A scene's part of the page; without its motion if that is too much or makes no sense."""
    try:
        replays = replays_of(scene.folder, scene.metrics, engines, told)
        return scene_chunk(scene, replays, meshes, told)
    except (ArithmeticError, AttributeError, LookupError, MemoryError, RecursionError, TypeError,
            UserError, ValueError) as error:  # fmt: skip
        # One scene that cannot be shown must not cost the page of all others.
        told.append(f"{scene.folder} cannot be played: {first_line(error)}")
        return scene_chunk(scene, [], meshes, told)


def _key(run: Run, scene: SceneEntry) -> str:
    """Name of a scene in the page: where its folder is in the run's."""
    return scene.name if run.single else scene.folder.relative_to(run.folder).as_posix()


def _short(folder: Path, problem: str) -> str:
    """A problem with its path as seen from `folder`: the page may lie on another machine."""
    return problem.replace(f"{folder}/", "")


def _plain(row: dict[str, Any]) -> dict[str, Any]:
    return {k: v for k, v in row.items() if isinstance(v, (int, float, str)) or v is None}


def _relative(run: Run, path: Path) -> str:
    """Where the scene folders are, seen from the page; empty if it lies elsewhere."""
    here, there = path.resolve().parent, run.folder.resolve()
    return there.relative_to(here).as_posix() if there.is_relative_to(here) else ""
