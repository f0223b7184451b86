"""The studio's web server: loopback only, one page, and what it asks for as JSON.

Whoever can reach the port could have scenes made: requests must name this machine as their host,
and those that change something must be JSON from the page itself, which no other page can send.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncGenerator, AsyncIterator, Awaitable, Callable, Mapping
import contextlib
import io
import json
from pathlib import Path
import tempfile
from typing import TYPE_CHECKING, Annotated, Any
import urllib.parse
import zipfile

from fastapi import Body, FastAPI, Request
from fastapi.responses import JSONResponse, Response, StreamingResponse

from esg.api.inputs import check_seed, checked, clean_prompt
from esg.outcomes import UserError
from esg.studio.jobs import Jobs
from esg.studio.playing import folder_of, page_of

if TYPE_CHECKING:
    from esg.graph import EsgDocument

HOST = "127.0.0.1"
STATIC = Path(__file__).parent / "static"
MOST_BYTES = 2_000_000
"""Of a request: a graph of a thousand nodes is a tenth of it."""
TARGETS = ("unreal", "usd", "mjcf", "glb")
_KINDS = {".html": "text/html", ".js": "text/javascript", ".css": "text/css"}
_PAGE_POLICY = (
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; "
    "connect-src 'self'; frame-src 'self'; media-src 'self'; base-uri 'none'; form-action 'none'"
)
_EVERYWHERE = {
    "X-Content-Type-Options": "nosniff",
    "Cross-Origin-Resource-Policy": "same-origin",
    "Referrer-Policy": "no-referrer",
    "X-Frame-Options": "SAMEORIGIN",
    "Cache-Control": "no-store",
}
Asked = Annotated[dict[str, Any], Body()]
BEAT_S = 15.0
"""Longest silence of the stream: a browser that is gone is noticed then."""


def build(jobs: Jobs) -> FastAPI:
    """The application.

    Args:
        jobs: What it makes scenes with; closed when the application ends.
    """

    @contextlib.asynccontextmanager
    async def lifespan(_: FastAPI) -> AsyncGenerator[None]:
        yield
        jobs.close()  # what waits for news of them ends before the threads are waited for

    app = FastAPI(
        title="esg studio", docs_url=None, redoc_url=None, openapi_url=None, lifespan=lifespan
    )

    @app.middleware("http")
    async def guard(request: Request, go_on: Callable[[Request], Awaitable[Response]]) -> Response:
        wrong = _refused(request.method, request.headers)
        if wrong:
            return JSONResponse({"error": wrong[1]}, wrong[0], headers=_EVERYWHERE)
        answer = await go_on(request)
        for key, value in _EVERYWHERE.items():
            answer.headers.setdefault(key, value)
        return answer

    @app.exception_handler(UserError)
    async def mistake(_: Request, error: UserError) -> JSONResponse:
        return JSONResponse({"error": str(error)}, 400)

    _serve_page(app)
    _serve_questions(app, jobs)
    _serve_scenes(app, jobs)
    return app


def _serve_page(app: FastAPI) -> None:
    """The page itself and its own files."""

    @app.get("/")
    def page() -> Response:
        return Response(
            (STATIC / "studio.html").read_bytes(),
            media_type="text/html; charset=utf-8",
            headers={"Content-Security-Policy": _PAGE_POLICY},
        )

    @app.get("/static/{name}")
    def static(name: str) -> Response:
        path = STATIC / name
        if path.name != name or path.suffix not in _KINDS or not path.is_file():
            return JSONResponse({"error": "there is no such file"}, 404)
        return Response(path.read_bytes(), media_type=f"{_KINDS[path.suffix]}; charset=utf-8")


def _serve_questions(app: FastAPI, jobs: Jobs) -> None:
    """What the page asks: how words are read, whether a graph holds, for scenes, and for news."""

    @app.post("/api/read")
    def read(asked: Asked) -> JSONResponse:
        from esg.studio.reading import read as told

        return JSONResponse(told(*_asked(asked)))

    @app.post("/api/check")
    def check(asked: Asked) -> JSONResponse:
        doc, violations = _parsed(_text(asked, "document"))
        return JSONResponse({"ok": doc is not None, "violations": violations})

    @app.get("/api/jobs")
    def listed() -> JSONResponse:
        return JSONResponse([job.to_json() for job in jobs.all()])

    @app.post("/api/jobs")
    def ask(asked: Asked) -> JSONResponse:
        prompt, seed = _asked(asked)
        return JSONResponse(jobs.ask(prompt, seed, _changed(asked, prompt, seed)).to_json(), 201)

    @app.delete("/api/jobs/{number}")
    def cancel(number: int) -> JSONResponse:
        return JSONResponse(jobs.cancel(number).to_json())

    @app.get("/api/stream")
    async def stream() -> StreamingResponse:
        return StreamingResponse(_stream(jobs), media_type="text/event-stream")


def _serve_scenes(app: FastAPI, jobs: Jobs) -> None:
    """Finished scenes: their player, their files, their exports."""

    @app.get("/scenes/{number}/")
    def scene(number: int) -> Response:
        page = page_of(folder_of(jobs.folder, jobs.get(number)))
        return Response(page, media_type="text/html; charset=utf-8")

    def found(number: int, name: str) -> Path | None:
        from esg.strangers.folders import file_in

        return file_in(folder_of(jobs.folder, jobs.get(number)), name)

    @app.get("/scenes/{number}/film")
    def film(number: int) -> Response:
        path = found(number, "preview.mp4")
        if path is None:
            return JSONResponse({"error": "there is no film"}, 404)
        return Response(path.read_bytes(), media_type="video/mp4")

    @app.get("/scenes/{number}/files/{name:path}")
    def file(number: int, name: str) -> Response:
        path = found(number, name)
        if path is None:
            return JSONResponse({"error": "there is no such file"}, 404)
        return _attachment(path.name, path.read_bytes())

    @app.get("/scenes/{number}/export/{to}")
    def export(number: int, to: str) -> Response:
        folder = folder_of(jobs.folder, jobs.get(number))
        return _attachment(f"{folder.name}-{to}.zip", _exported(folder, to))


def _refused(method: str, headers: Mapping[str, str]) -> tuple[int, str] | None:
    """Status and reason for a request that does not come from the page; None for one that does."""
    name = headers.get("host", "").rsplit(":", 1)[0]
    if name not in (HOST, "localhost"):
        return 421, "this server answers only to this machine"
    if method in ("GET", "HEAD"):
        return None
    origin = headers.get("origin")
    if origin is not None and urllib.parse.urlsplit(origin).netloc != headers.get("host"):
        return 403, "another page may not ask for this"
    if method == "POST" and not headers.get("content-type", "").startswith("application/json"):
        return 415, "send JSON"
    if int(headers.get("content-length") or 0) > MOST_BYTES:
        return 413, f"at most {MOST_BYTES // 1_000_000} MB are read"
    return None


def _text(asked: dict[str, Any], key: str) -> str:
    value = asked.get(key, "")
    if not isinstance(value, str):
        raise UserError(f"{key} must be text")
    return value


def _asked(asked: dict[str, Any]) -> tuple[str, int]:
    """Prompt and seed of a request.

    Raises:
        UserError: With everything that is wrong with them.
    """

    def seed() -> int:
        value = asked.get("seed", 0)
        if not isinstance(value, int) or isinstance(value, bool):
            raise UserError("seed must be a whole number")
        return check_seed(value)

    prompt, number = checked(lambda: clean_prompt(_text(asked, "prompt")), seed)
    return prompt, number


def _changed(asked: dict[str, Any], prompt: str, seed: int) -> str:
    """The scene graph that stands for the draft: one that was edited, or turned by sliders.

    Raises:
        UserError: If an edited one does not hold.
    """
    from esg.graph import canonical_json

    text, values = _text(asked, "document"), asked.get("knobs") or {}
    if not isinstance(values, dict) or not all(
        isinstance(v, int | float) and not isinstance(v, bool) for v in values.values()
    ):
        raise UserError("knobs must be numbers by id")
    if not text and not values:
        return ""
    if text:
        doc, violations = _parsed(text)
        if doc is None:
            raise UserError(f"the graph does not hold: {violations[0]['message']}")
    else:
        from esg.draft import draft

        doc = draft(prompt, seed=seed)
    if values:
        from esg.studio.knobs import turned

        doc = turned(doc, {k: float(v) for k, v in values.items()})
    return canonical_json(doc).decode()


def _parsed(text: str) -> tuple[EsgDocument | None, list[dict[str, Any]]]:
    """A document if it holds, and its violations."""
    from esg.graph import check_text

    report = check_text(text)
    return report.document, [v.to_json() for v in report.violations]


def _exported(folder: Path, to: str) -> bytes:
    from esg.compile.export import export

    if to not in TARGETS:
        raise UserError(f"cannot export to {to!r}; choose {', '.join(TARGETS)}")
    data = io.BytesIO()
    with tempfile.TemporaryDirectory() as work:
        root = Path(work)
        files = export(folder, to, root)
        with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
            for path in files:
                archive.write(path, path.relative_to(root))
    return data.getvalue()


def _attachment(name: str, data: bytes) -> Response:
    quoted = urllib.parse.quote(name)
    return Response(
        data,
        media_type="application/octet-stream",
        headers={
            "Content-Disposition": f"attachment; filename*=UTF-8''{quoted}",
            "Content-Security-Policy": "default-src 'none'; sandbox",
        },
    )


async def _stream(jobs: Jobs) -> AsyncIterator[str]:
    """All jobs whenever one changes, as server-sent events."""
    version: int | None = -1
    while True:
        version = await asyncio.to_thread(jobs.changed_since, version, BEAT_S)
        if version is None:
            return
        told = json.dumps([job.to_json() for job in jobs.all()], ensure_ascii=False)
        yield f"id: {version}\ndata: {told}\n\n"
