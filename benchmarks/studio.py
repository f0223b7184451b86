"""How fast the studio answers, in a headless Chromium on this machine.

    python -m benchmarks.studio --out studio.json

Words: from the last key to the first coloured word, for ten prompts typed letter by letter.
Stages: from a change of a job in the server to the page that shows it, over a whole scene.
Playing: from asking until the film plays, for a scene in the history, and for a prompt whose every
stage is in the cache; `player` and `cached_player` are the times to the 3-D player's first picture,
which here a processor draws. Ends with 1 if a median is over its limit.
"""

from __future__ import annotations

import argparse
import json
from pathlib import Path
import statistics
import sys
import tempfile
import threading
import time
from typing import Any

from esg.api.warming import warm_up
from esg.studio.jobs import Jobs
from esg.studio.playing import warm
from esg.studio.reading import read
from esg.workers import WorkerPool
from tests.report import browser as chrome
from tests.studio.serving import served

LIMITS_S = {"words": 0.2, "stages": 0.5, "history": 1.0, "cached": 1.0, "player": 1.0}
PROMPTS = (
    "A ball rolls off a table and lands in a basket.",
    "A car collides with a trashbin, knocking it into a picnic table.",
    "A bowling ball knocks down ten pins.",
    "A door is pushed open by a rolling ball.",
    "A cyclist brakes hard behind a parked van and stops.",
    "A wrecking ball swings into a stack of boxes.",
    "A red car at 10 m/s hits a bin and stops after 3 seconds.",
    "A cat jumps from a wall onto a box, and the box falls over.",
    "Two balls roll toward each other and collide after 2 seconds.",
    "A brick is thrown through a window and the window shatters.",
)
WATCH = """
window.read = 0; window.stages = []; window.key = 0;
const prompt = document.getElementById('prompt');
prompt.addEventListener('input', () => { window.key = performance.now(); window.read = 0; });
new MutationObserver(() => {
  if (!window.read && document.querySelector('#read mark')) window.read = performance.now();
}).observe(document.getElementById('read'), {childList: true});
new MutationObserver(() => window.stages.push([Date.now() / 1000,
  [...document.querySelectorAll('.stages .now, .stages .done, .stages .cached')]
    .map((e) => e.textContent.split(' ')[0] + '/' + (e.className === 'now'))]))
  .observe(document.getElementById('job'), {childList: true});
new MutationObserver(() => document.querySelector('#scene video')
  ?.addEventListener('playing', (e) => { window.film = [e.target.src, performance.now()]; }))
  .observe(document.getElementById('scene'), {childList: true});
window.film = ['', 0];
"""
PLAYER = """
const frame = document.querySelector('#scene iframe');
return Boolean(frame?.src.endsWith(arguments[0])) &&
  Boolean(frame.contentDocument?.querySelector('.stage[data-drawn] canvas'));
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--out", type=Path, help="JSON file of the figures")
    args = parser.parse_args()
    if reason := chrome.missing():
        sys.exit(reason)
    with tempfile.TemporaryDirectory() as work:
        found = measure(Path(work))
    text = json.dumps(found, indent=1)
    print(text)
    if args.out is not None:
        args.out.write_text(text + "\n", encoding="utf-8")
    slow = [name for name, limit in LIMITS_S.items() if found[name]["median_s"] > limit]
    if slow:
        sys.exit(f"slower than {LIMITS_S}: {', '.join(slow)}")


def measure(folder: Path) -> dict[str, Any]:
    """Median and worst of all delays [s]."""

    def pool() -> WorkerPool:
        made = WorkerPool(1)
        made.warm(warm_up)
        return made

    jobs = Jobs(folder, pool)
    with served(jobs) as address, chrome.browser() as driver:
        read("A ball rolls.", 0)
        warm(folder, ())
        driver.get(address)
        driver.execute_script(WATCH)
        words = [_word(driver, prompt) for prompt in PROMPTS]
        stages = _stages(driver, jobs)
        cached = [_played(driver, jobs, lambda: _go(driver)) for _ in range(3)]
        history = [
            _played(driver, jobs, lambda n=n: _choose(driver, n), n) for n in (1, 2, 3, 1, 2)
        ]
    rows = {
        "words": words, "stages": stages, "cached": [film for film, _ in cached],
        "history": [film for film, _ in history],
        "player": [drawn for _, drawn in history],
        "cached_player": [drawn for _, drawn in cached],
    }  # fmt: skip
    return {name: _summary(values) for name, values in rows.items()}


def _summary(seconds: list[float]) -> dict[str, float]:
    return {
        "median_s": round(statistics.median(seconds), 3),
        "worst_s": round(max(seconds), 3),
        "samples": len(seconds),
    }


def _word(driver: Any, prompt: str) -> float:
    from selenium.webdriver.common.action_chains import ActionChains

    driver.execute_script(
        "const p = document.getElementById('prompt'); p.value = ''; p.focus();"
        "p.dispatchEvent(new Event('input'))"
    )
    time.sleep(0.5)
    ActionChains(driver).send_keys(prompt).perform()
    _until(lambda: driver.execute_script("return window.read > window.key"))
    time.sleep(1.0)  # the one after the last key
    return driver.execute_script("return (window.read - window.key) / 1000")


def _stages(driver: Any, jobs: Jobs) -> list[float]:
    """Delays of every stage that began or ended while a scene was made."""
    changed: dict[str, float] = {}
    over = threading.Event()

    def note() -> None:
        version: int | None = -1
        while not over.is_set() and version is not None:
            version = jobs.changed_since(version, 1.0)
            for job in jobs.all():
                for name, seconds, _ in job.stages:
                    changed.setdefault(f"{name}/{str(seconds is None).lower()}", time.time())

    thread = threading.Thread(target=note, daemon=True)
    thread.start()
    _go(driver)
    _until(lambda: jobs.all() and jobs.get(1).status not in ("waiting", "running"), 300)
    time.sleep(1.0)
    over.set()
    thread.join()
    shown: dict[str, float] = {}
    for when, states in driver.execute_script("return window.stages"):
        for state in states:
            shown.setdefault(state, when)
    return [shown[state] - when for state, when in changed.items() if state in shown]


def _go(driver: Any) -> None:
    driver.execute_script("document.getElementById('go').click()")


def _choose(driver: Any, number: int) -> None:
    driver.execute_script(f"document.querySelector('[data-job=\"{number}\"] .text').click()")


def _played(driver: Any, jobs: Jobs, act: Any, number: int = 0) -> tuple[float, float]:
    """Seconds until the film of a job plays, and until its player has drawn a frame."""
    wanted = f"/scenes/{number or len(jobs.all()) + 1}/"
    start = time.perf_counter()
    asked = driver.execute_script("return performance.now()")
    act()
    _until(lambda: driver.execute_script("return window.film[0]").endswith(f"{wanted}film"))
    film = (driver.execute_script("return window.film[1]") - asked) / 1000
    _until(lambda: driver.execute_script(PLAYER, wanted))
    return film, time.perf_counter() - start


def _until(true: Any, seconds: float = 60.0) -> None:
    deadline = time.monotonic() + seconds
    while not true():
        if time.monotonic() > deadline:
            raise SystemExit("the page did not answer")
        time.sleep(0.02)


if __name__ == "__main__":
    main()
