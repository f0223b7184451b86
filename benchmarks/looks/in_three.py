"""Opens a GLB with three.js in headless Chromium and says what it finds there."""

from __future__ import annotations

import base64
import functools
import html
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
import json
from pathlib import Path
import subprocess
import tempfile
import threading
from typing import Any

HERE = Path(__file__).parent
THREE = HERE.parents[1] / "tests" / "compile" / "gltf" / "node_modules" / "three"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
TIMEOUT_S = 180


class _Handler(SimpleHTTPRequestHandler):
    """Serves the page, three.js, one GLB and the job."""

    def __init__(self, *args: Any, glb: Path, job: bytes, **more: Any) -> None:
        self._glb, self._job = glb, job
        super().__init__(*args, **more)

    def do_GET(self) -> None:
        if self.path == "/job.json":
            self.send_response(200)
            self.send_header("Content-Type", "application/json")
            self.end_headers()
            self.wfile.write(self._job)
        else:
            super().do_GET()

    def translate_path(self, path: str) -> str:
        if path == "/scene.glb":
            return str(self._glb)
        if path.startswith("/three/"):
            inside = (THREE / path.removeprefix("/three/")).resolve()
            return str(inside if inside.is_relative_to(THREE.resolve()) else THREE / "none")
        return str(HERE / "in_three.html")

    def log_message(self, format: str, *args: Any) -> None:
        """No line per request."""


def shown(glb: Path, job: dict[str, Any], browser: str) -> dict[str, Any]:
    """What the browser finds in a GLB; its picture goes to the job's `picture`.

    Args:
        glb: The file.
        job: Instants, size, light and place of the picture, as `in_three.html` reads them.
        browser: Chromium's path.

    Raises:
        RuntimeError: If the page could not show it.
    """
    handler = functools.partial(_Handler, glb=glb.resolve(), job=json.dumps(job).encode())
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory() as profile:
        command = [
            browser, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
            "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
            f"--user-data-dir={profile}", "--virtual-time-budget=60000", "--dump-dom",
            f"http://127.0.0.1:{server.server_port}/",
        ]  # fmt: skip
        try:
            page = subprocess.run(
                command, capture_output=True, text=True, timeout=TIMEOUT_S, check=True
            ).stdout
        finally:
            server.shutdown()
    title = page.split("<title>", 1)[1].split("</title>", 1)[0]
    if title != "done":
        raise RuntimeError(f"{glb}: {title}")
    text = page.split('id="answer">', 1)[1].split("</script>", 1)[0]
    answer = json.loads(html.unescape(text) if "&quot;" in text else text)
    Path(job["picture"]).write_bytes(base64.b64decode(answer.pop("picture").partition(",")[2]))
    return answer
