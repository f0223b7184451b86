"""A picture of an exported GLB in a real browser: three.js in headless Chromium.

    python -m benchmarks.glb_viewer SCENE.glb [--times 0,1,2] --out docs/images/glb_viewer.png

Needs Chromium and `npm ci --prefix tests/compile/gltf`. The page loads the file with three.js's own
loader and plays the file's own animation to three moments. Nothing of this project draws.
"""

from __future__ import annotations

import argparse
import functools
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
import shutil
import subprocess
import tempfile
import threading

HERE = Path(__file__).parent
THREE = HERE.parents[1] / "tests" / "compile" / "gltf" / "node_modules" / "three"
BROWSERS = ("chromium", "chromium-browser", "google-chrome")
SIZE = (1448, 390)
"""Pixels of the picture: three views of 480 x 360, captions, gaps."""

TIMEOUT_S = 120


class _Handler(SimpleHTTPRequestHandler):
    """Serves the page, three.js and one GLB."""

    def __init__(self, *args: object, glb: Path, **more: object) -> None:
        self._glb = glb
        super().__init__(*args, **more)  # type: ignore[arg-type]

    def translate_path(self, path: str) -> str:
        if path == "/scene.glb":
            return str(self._glb)
        if path.startswith("/three/"):
            inside = (THREE / path.removeprefix("/three/")).resolve()
            return str(inside if inside.is_relative_to(THREE.resolve()) else THREE / "none")
        return str(HERE / "glb_viewer.html")

    def log_message(self, *args: object) -> None:
        """No line per request."""


def picture(glb: Path, out: Path, browser: str, times: str = "") -> str:
    """Shows a GLB in a browser and saves what it shows.

    Args:
        glb: The file.
        out: PNG to write.
        browser: Chromium's path.
        times: Three moments [s], with commas; default start, middle and end.

    Returns:
        The page's title: what was loaded, or why not.
    """
    handler = functools.partial(_Handler, glb=glb.resolve())
    server = ThreadingHTTPServer(("127.0.0.1", 0), handler)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    with tempfile.TemporaryDirectory() as profile:
        common = [
            browser, "--headless=new", "--no-sandbox", "--disable-dev-shm-usage",
            "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars",
            f"--user-data-dir={profile}", f"--window-size={SIZE[0]},{SIZE[1]}",
            "--virtual-time-budget=30000",
        ]  # fmt: skip
        address = f"http://127.0.0.1:{server.server_port}/?times={times}"
        try:
            for more in (["--dump-dom"], [f"--screenshot={out.resolve()}"]):
                done = subprocess.run(
                    [*common, *more, address], capture_output=True, text=True, timeout=TIMEOUT_S,
                    check=True,
                )  # fmt: skip
                if more == ["--dump-dom"]:
                    title = done.stdout.split("<title>", 1)[1].split("</title>", 1)[0]
                    if not title.startswith("done"):
                        raise SystemExit(f"{glb}: {title}")
        finally:
            server.shutdown()
    return title


def main() -> None:
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.glb_viewer", description=__doc__.splitlines()[0]
    )
    parser.add_argument("glb", type=Path)
    parser.add_argument("--out", type=Path, default=Path("glb_viewer.png"))
    parser.add_argument("--times", default="", help="three moments in seconds, with commas")
    parser.add_argument("--browser", default=next(filter(shutil.which, BROWSERS), ""))
    options = parser.parse_args()
    if not options.browser or not THREE.is_dir():
        parser.error("needs Chromium and `npm ci --prefix tests/compile/gltf`")
    print(picture(options.glb, options.out, options.browser, options.times))


if __name__ == "__main__":
    main()
