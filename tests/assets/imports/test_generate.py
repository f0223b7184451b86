"""Generators: an HTTP service that behaves and one that does not, caching, and the fallback."""

from __future__ import annotations

import base64
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
import json
from pathlib import Path
import sys
import threading
import time
import types
from typing import Any

import numpy as np
import pytest
import trimesh

from esg.assets import build_mesh, resolve, write_meshes
from esg.assets.imports.generated import generate_asset, prompt_of
from esg.assets.imports.providers import (
    GenerationError,
    TrellisPackage,
    TrellisService,
    check_glb,
    chosen_generator,
)
from esg.assets.library.retrieve import decide
from esg.graph.models import AssetRequirement
from esg.outcomes import UserError
from tests.assets.worlds import EMPTY


def wedge_glb() -> bytes:
    """Y-up, front +Z: 2 wide (X), 1 high (Y), 3 deep (Z), high at the back."""
    points = [(x, y, z) for x in (-1, 1) for y, z in ((0, -1.5), (0, 1.5), (1, -1.5))]
    mesh = trimesh.convex.convex_hull(np.array(points, float))
    return trimesh.Scene(mesh).export(file_type="glb")


GLB = wedge_glb()


class Server(ThreadingHTTPServer):
    """Answers each request with the next behaviour; the last one repeats."""

    daemon_threads = True

    def __init__(self, *behaviours: str) -> None:
        super().__init__(("127.0.0.1", 0), Handler)
        self.behaviours = list(behaviours)
        self.requests: list[dict[str, Any]] = []
        threading.Thread(target=self.serve_forever, args=(0.01,), daemon=True).start()

    @property
    def url(self) -> str:
        return f"http://127.0.0.1:{self.server_port}/generate"


class Handler(BaseHTTPRequestHandler):
    server: Server

    def log_message(self, *_: object) -> None:
        pass

    def _send(
        self, data: bytes, kind: str = "model/gltf-binary", length: int | None = None
    ) -> None:
        self.send_response(200)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(data) if length is None else length))
        self.end_headers()
        self.wfile.write(data)

    def do_POST(self) -> None:
        body = self.rfile.read(int(self.headers["Content-Length"]))
        self.server.requests.append(json.loads(body))
        left = self.server.behaviours
        what = left.pop(0) if len(left) > 1 else left[0]
        if what == "good":
            self._send(GLB)
        elif what == "json":
            self._send(
                json.dumps({"glb": base64.b64encode(GLB).decode()}).encode(), "application/json"
            )
        elif what.isdigit():
            self.send_error(int(what))
        elif what == "slow":
            time.sleep(0.6)
        elif what == "trickle":
            self.send_response(200)
            self.send_header("Content-Type", "model/gltf-binary")
            self.end_headers()
            try:
                for k in range(0, 200, 4):
                    self.wfile.write(GLB[k : k + 4])
                    self.wfile.flush()
                    time.sleep(0.05)
            except OSError:
                pass
        elif what == "cut":
            self._send(GLB[: len(GLB) // 2], length=len(GLB))
        elif what == "short":
            self._send(GLB[: len(GLB) // 2])
        elif what == "huge":
            self._send(b"", length=10**9)
        elif what == "html":
            self._send(b"<html>please log in to continue here</html>", "text/html")
        elif what == "odd":
            self._send(b'{"mesh": 1}', "application/json")
        elif what == "hollow":
            self._send(
                trimesh.Scene(trimesh.PointCloud([[0, 0, 0], [1, 1, 1]])).export(file_type="glb")
            )


@pytest.fixture
def serve() -> Iterator[Any]:
    running: list[Server] = []

    def start(*behaviours: str) -> Server:
        running.append(Server(*behaviours))
        return running[-1]

    yield start
    for server in running:
        server.shutdown()
        server.server_close()


@pytest.fixture(autouse=True)
def library(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ESG_ASSET_LIBRARY", str(tmp_path / "library"))
    return tmp_path / "library"


def service(server: Server, **options: Any) -> TrellisService:
    return TrellisService(server.url, **({"timeout_s": 0.3, "backoff_s": 0.01} | options))


def gizmo(**changes: Any) -> AssetRequirement:
    values: dict[str, Any] = {
        "asset_category": "flux capacitor",
        "asset_description": "a glowing flux capacitor",
        "expected_dimensions_cm": (30.0, 20.0, 10.0),
        "expected_mass_kg": 2.5,
        "color": "green",
    }
    return AssetRequirement.model_validate(values | changes)


@pytest.mark.parametrize("kind", ["good", "json"])
def test_service_gives_a_glb(serve: Any, kind: str) -> None:
    server = serve(kind)
    assert service(server, timeout_s=5).generate("a wedge", 7, b"pixels") == GLB
    sent = server.requests[0]
    assert sent["prompt"] == "a wedge" and sent["seed"] == 7
    assert base64.b64decode(sent["image"]) == b"pixels"


def test_busy_service_is_asked_again(serve: Any) -> None:
    server = serve("503", "500", "good")
    assert service(server, timeout_s=5).generate("x", 0) == GLB
    assert len(server.requests) == 3


@pytest.mark.parametrize(
    ("kind", "message", "asked"),
    [
        ("500", "answered 500", 2),
        ("400", "answered 400", 1),
        ("slow", "cannot be reached|no answer", 2),
        ("trickle", "longer than", 2),
        ("cut", "cut off|cannot be reached", 2),
        ("short", "cut off", 2),
        ("huge", "too large", 1),
        ("html", "no GLB", 2),
        ("odd", "without a base64", 2),
    ],
)
def test_misbehaving_service_is_one_error(serve: Any, kind: str, message: str, asked: int) -> None:
    server = serve(kind)
    start = time.monotonic()
    with pytest.raises(GenerationError, match=message):
        service(server, retries=1).generate("x", 0)
    assert len(server.requests) == asked
    assert time.monotonic() - start < 5


def test_nobody_listens() -> None:
    with pytest.raises(GenerationError, match="cannot be reached"):
        TrellisService("http://127.0.0.1:9/", timeout_s=0.5, retries=0).generate("x", 0)


@pytest.mark.parametrize("data", [b"", b"glTF", GLB[:-1], GLB[:4] + b"\x01\0\0\0" + GLB[8:]])
def test_damaged_container_is_refused(data: bytes) -> None:
    with pytest.raises(GenerationError):
        check_glb(data)


def test_generated_mesh_is_finished_like_an_import_and_kept(serve: Any, library: Path) -> None:
    server = serve("good", "500")
    need = gizmo()
    maker = service(server, timeout_s=5, retries=0)
    config = generate_asset("a", need, decide(need), maker, 3)
    assert config.source == "generated" and config.license == "generated"
    assert "trellis-http" in config.attribution
    assert config.mass_kg == 2.5 and config.proxies
    scene = build_mesh(config)
    np.testing.assert_allclose(scene.bounds, [[-15, -10, 0], [15, 10, 10]], atol=1e-2)
    points = np.concatenate([g.vertices for g in scene.geometry.values()])
    assert (points[points[:, 2] > 9.9][:, 0] < -14.9).all(), "the front must be +X"
    again = generate_asset("a", need, decide(need), maker, 3)
    assert again == config and len(server.requests) == 1
    with pytest.raises(GenerationError):
        generate_asset("a", need, decide(need), maker, 4)
    assert decide(need).entry is None, "a generated mesh must not enter retrieval"


def test_scene_survives_a_failing_generator(
    serve: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    server = serve("good", "hollow")
    monkeypatch.setenv("ESG_GENERATOR", "trellis")
    monkeypatch.setenv("ESG_TRELLIS_URL", server.url)
    monkeypatch.setenv("ESG_TRELLIS_RETRIES", "0")
    needs = {
        "good": gizmo(),
        "bad": gizmo(asset_category="flux snorter", asset_description="flux snorter"),
        "car": gizmo(
            asset_category="car", expected_dimensions_cm=(455, 182, 146), expected_mass_kg=1450
        ),
    }
    doc = resolve(EMPTY.model_copy(update={"asset_requirement": needs}), seed=1)
    source = {k: c.source for k, c in doc.asset_configurations.items()}
    assert source == {"good": "generated", "bad": "fallback", "car": "parametric"}
    record = doc.provenance[-1].config
    assert record["generator"] == "trellis-http"
    assert set(record["generator_failures"]) == {"bad"}
    assert len(server.requests) == 2
    assert set(write_meshes(doc, tmp_path / "scene")) == set(needs)
    text = (tmp_path / "scene" / "meshes" / "ATTRIBUTION.txt").read_text()
    assert "trellis-http" in text and text.count("\n") == 1


def test_local_package_is_loaded_and_run(monkeypatch: pytest.MonkeyPatch) -> None:
    """The calls of the real package, on a stand-in that records them."""
    calls: list[Any] = []

    class Pipeline:
        @classmethod
        def from_pretrained(cls, name: str) -> Pipeline:
            calls.append(name)
            return cls()

        def cuda(self) -> None:
            calls.append("cuda")

        def run(self, prompt: str, seed: int, formats: list[str]) -> dict[str, list[str]]:
            assert sorted(formats) == ["gaussian", "mesh"]
            calls.append((prompt, seed))
            return {"gaussian": ["splats"], "mesh": ["triangles"]}

    def to_glb(splats: str, mesh: str, simplify: float, texture_size: int) -> Any:
        calls.append((splats, mesh, simplify, texture_size))
        return trimesh.load_scene(trimesh.util.wrap_as_stream(GLB), file_type="glb")

    modules = {
        "trellis": {},
        "trellis.pipelines": {"TrellisTextTo3DPipeline": Pipeline},
        "trellis.utils": {},
        "trellis.utils.postprocessing_utils": {"to_glb": to_glb},
    }
    for name, content in modules.items():
        module = types.ModuleType(name)
        vars(module).update(content)
        monkeypatch.setitem(sys.modules, name, module)
    monkeypatch.setattr(
        sys.modules["trellis"], "pipelines", sys.modules["trellis.pipelines"], False
    )
    monkeypatch.setattr(
        sys.modules["trellis.utils"],
        "postprocessing_utils",
        sys.modules["trellis.utils.postprocessing_utils"],
        False,
    )
    monkeypatch.setattr("esg.assets.imports.providers._PIPELINES", {})
    package = TrellisPackage("some/weights")
    assert package.generate("a cup", 5)[:4] == b"glTF"
    assert package.generate("a cup", 6)[:4] == b"glTF"
    assert calls[:3] == ["some/weights", "cuda", ("a cup", 5)] and calls.count("cuda") == 1


def test_missing_package_says_what_to_do() -> None:
    with pytest.raises(GenerationError, match="ESG_TRELLIS_URL"):
        TrellisPackage().generate("a cup", 0)


def test_settings_choose_the_provider(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("ESG_GENERATOR", raising=False)
    assert chosen_generator() is None
    monkeypatch.setenv("ESG_GENERATOR", "trellis")
    assert chosen_generator() == TrellisPackage()
    monkeypatch.setenv("ESG_TRELLIS_URL", "http://gpu:8000/generate")
    monkeypatch.setenv("ESG_TRELLIS_TIMEOUT_S", "9")
    assert chosen_generator() == TrellisService("http://gpu:8000/generate", timeout_s=9.0)
    for name, value in (
        ("ESG_TRELLIS_URL", "gpu:8000"),
        ("ESG_TRELLIS_TIMEOUT_S", "soon"),
        ("ESG_TRELLIS_RETRIES", "many"),
        ("ESG_GENERATOR", "magic"),
    ):
        with monkeypatch.context() as patch:
            patch.setenv(name, value)
            with pytest.raises(UserError, match=name):
                chosen_generator()


def test_prompt_names_looks_once() -> None:
    assert prompt_of(gizmo()) == "green flux capacitor: a glowing flux capacitor"
    assert prompt_of(gizmo(asset_description="flux capacitor", color=None)) == "flux capacitor"
