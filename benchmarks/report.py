"""How fast a large report opens, and how much memory it takes, in a headless Chromium.

    python -m benchmarks.report RUN --scenes 500 --out report.json

The scenes of RUN (a folder of scene folders) are repeated until there are enough. Memory is what
the operating system counts as private to the page's process (unique set size), before and after.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
import shutil
import sys
import tempfile
import time
from typing import Any

from esg.report import load_run, write_report
from esg.report.run import find_scenes
from tests.report import browser as chrome

MB = 1e6


def many(run: Path, count: int, folder: Path) -> Path:
    """A run of `count` scenes: links to the scenes of another, over and over."""
    found = find_scenes(run)
    for k in range(count):
        source = found[k % len(found)]
        name = source.name.rsplit("-run", 1)[0]
        (folder / f"{name}-run{k // len(found)}").symlink_to(source.resolve())
    return folder


def memory(driver: Any) -> dict[str, float]:
    """Private memory [MB] of the page's process, and of all processes of the browser."""
    import psutil

    page = total = 0.0
    for process in psutil.Process(driver.service.process.pid).children(recursive=True):
        try:
            private = process.memory_full_info().uss / MB
            if "--type=renderer" in process.cmdline():
                page = max(page, private)
        except psutil.Error:
            continue
        total += private
    return {"page_mb": round(page, 1), "browser_mb": round(total, 1)}


def measure(path: Path) -> dict[str, Any]:
    """Opens a page, scrolls, sorts, looks at ten scenes."""
    with chrome.browser() as driver:
        driver.get("about:blank")
        time.sleep(1.0)
        out: dict[str, Any] = {"file_mb": round(path.stat().st_size / MB, 2)}
        out["empty"] = memory(driver)
        start = time.perf_counter()
        chrome.open_page(driver, path)
        out["open_s"] = round(time.perf_counter() - start, 3)
        time.sleep(2.0)
        out["opened"] = memory(driver)
        heap = "return performance.memory.usedJSHeapSize"
        out["js_heap_mb"] = round(driver.execute_script(heap) / MB, 1)
        driver.execute_script("window.scrollTo(0, document.body.scrollHeight)")
        time.sleep(1.0)
        out["scrolled"] = memory(driver)
        start = time.perf_counter()
        driver.execute_script(
            "const s = document.getElementById('filter-sort'); s.value = 'seconds';"
            "s.dispatchEvent(new Event('change')); return document.body.offsetHeight"
        )
        out["sort_s"] = round(time.perf_counter() - start, 3)
        names = driver.execute_script(
            "return [...document.querySelectorAll('#cards strong')].map((e) => e.textContent)"
        )
        for name in names[:10]:
            driver.execute_script("location.hash = '#/scene/' + arguments[0]", name)
            time.sleep(2.0)
        out["after_ten_scenes"] = memory(driver)
        out["console"] = chrome.complaints(driver)
        return out


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("run", type=Path)
    parser.add_argument("--scenes", type=int, default=500)
    parser.add_argument("--out", type=Path)
    args = parser.parse_args()
    if reason := chrome.missing():
        sys.exit(reason)
    work = Path(tempfile.mkdtemp())
    try:
        start = time.process_time()
        page = write_report(load_run(many(args.run, args.scenes, work)), work / "report.html")
        written = time.process_time() - start
        result = {"scenes": args.scenes, "write_cpu_s": round(written, 1), **measure(page)}
    finally:
        shutil.rmtree(work)
    text = json.dumps(result, indent=2)
    print(text)
    if args.out:
        args.out.write_text(text + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
