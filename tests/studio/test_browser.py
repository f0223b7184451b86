"""The studio's page in a real browser: typing, the queue, keyboards, screen readers, and mishaps."""

from __future__ import annotations

from collections.abc import Iterator
import json
import os
from pathlib import Path
import signal
import socket
import subprocess
import sys
import time
from typing import Any

import numpy as np
import pytest

from esg.studio.jobs import LOG, Job, Jobs
from esg.view.film.encoding import write_film
from tests.report import browser as chrome
from tests.report.folders import write_scene
from tests.studio.serving import pools, served

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(bool(chrome.missing()), reason=chrome.missing() or "a browser is here"),
]

ROOT = Path(__file__).parents[2]
PROMPT = "A red ball rolls loudly into a box."
PLAYED = "A ball falls onto a box."
WIDEST = "return document.documentElement.scrollWidth"


def logged(folder: Path, *jobs: Job) -> None:
    """A history, as an earlier server left it."""
    folder.mkdir(exist_ok=True)
    rows = [{**vars(job), "stages": list(job.stages)} for job in jobs]
    (folder / LOG).write_text("".join(json.dumps(row) + "\n" for row in rows))


@pytest.fixture(scope="module")
def driver() -> Iterator[Any]:
    with chrome.browser() as found:
        yield found


@pytest.fixture
def studio(driver: Any, tmp_path: Path) -> Iterator[str]:
    """The address of a studio with a finished scene and a failed one; an empty browser."""
    folder = write_scene(tmp_path / "scene-1", PLAYED)
    grey = (np.full((64, 96, 3), 8 * k, np.uint8) for k in range(24))
    write_film(folder / "preview.mp4", grey, (96, 64))
    logged(
        tmp_path,
        Job(1, PLAYED, 0, status="done", folder="scene-1", outcome="solved"),
        Job(2, "A ball is red and is not.", 0, status="failed", outcome="infeasible",
            reason="it is red, and is not"),
    )  # fmt: skip
    jobs = Jobs(tmp_path, pools())  # type: ignore[arg-type]  # stands for a WorkerPool
    with served(jobs) as address:
        opened(driver, address)
        wait(driver, "document.querySelectorAll('#jobs li').length === 2")
        yield address
        driver.get("about:blank")
        chrome.complaints(driver)


def opened(driver: Any, address: str) -> None:
    driver.get(address)
    driver.execute_script("sessionStorage.clear(); localStorage.clear()")
    driver.get(address)


def wait(driver: Any, script: str, seconds: float = 120.0) -> Any:
    """The first true value of a script."""
    from selenium.webdriver.support.ui import WebDriverWait

    return WebDriverWait(driver, seconds, 0.02).until(
        lambda d: d.execute_script(f"return {script}")
    )


def complaints(driver: Any) -> list[str]:
    """Those of the console, but for the refusals of what was not yet a sentence when it was read."""
    return [c for c in chrome.complaints(driver) if "/api/read" not in c or "400" not in c]


def keys(driver: Any, *pressed: str) -> None:
    from selenium.webdriver.common.action_chains import ActionChains

    for key in pressed:
        ActionChains(driver).send_keys(key).perform()


def typed(driver: Any, text: str) -> None:
    """Into the prompt, letter by letter, and read."""
    driver.execute_script("document.getElementById('prompt').focus()")
    keys(driver, *text)
    wait(driver, f"document.querySelector('#read').textContent === {json.dumps(text)}")


def ask(driver: Any, prompt: str, status: str) -> None:
    """By keyboard; until the newest job of the list is so far."""
    from selenium.webdriver.common.keys import Keys

    driver.execute_script("const p = document.getElementById('prompt'); p.focus(); p.select()")
    keys(driver, Keys.DELETE)
    typed(driver, prompt)
    driver.execute_script("document.getElementById('go').focus()")
    keys(driver, Keys.ENTER)
    newest = "document.querySelector('#jobs li')"
    wait(driver, f"{newest}?.querySelector('.text').textContent === {json.dumps(prompt)}")
    wait(driver, f"{newest}.querySelector('.badge').textContent === '{status}'")


def test_words_are_coloured_while_one_types(driver: Any, studio: str) -> None:
    """What becomes of each, told in text as well as in colour."""
    typed(driver, PROMPT)
    marks = driver.execute_script(
        "return [...document.querySelectorAll('#read mark')].map((m) => [m.textContent, m.className])"
    )
    assert ["loudly", "not_represented"] in marks
    assert ["red ball", "used"] in [[t.removeprefix("A "), c] for t, c in marks]
    assert driver.execute_script("return document.getElementById('read').textContent") == PROMPT
    notes = driver.execute_script("return document.getElementById('notes').textContent")
    assert "“loudly” will not be shown" in notes and "red ball" in notes
    assert complaints(driver) == []


def test_a_finished_scene_plays_and_can_be_taken_along(driver: Any, studio: str) -> None:
    """The film at once, then the player in its place."""
    driver.execute_script(
        "new MutationObserver(() => document.querySelector('#scene video')"
        "?.addEventListener('playing', () => (window.filmed = true)))"
        ".observe(document.getElementById('scene'), {childList: true});"
        "document.querySelector('[data-job=\"1\"] .text').click()"
    )
    driver.execute_script("document.getElementById('prompt').focus()")
    assert wait(driver, "window.filmed")
    ready = (
        "document.querySelector('#scene iframe')?.contentDocument?.documentElement?.dataset.ready"
    )
    assert wait(driver, ready) == "yes"
    inside = (
        "document.querySelector('#scene iframe').contentDocument.querySelector('.stage canvas')"
    )
    assert wait(driver, f"{inside} !== null")
    wait(driver, "document.querySelector('#scene video') === null")
    assert driver.execute_script("return document.activeElement.id") == "prompt"  # not the player's
    links = driver.execute_script(
        "return [...document.querySelectorAll('.downloads a[download]')].map((a) => a.textContent)"
    )
    assert {"usd", "glb", "mjcf", "unreal", "scene graph"} <= set(links)
    assert complaints(driver) == []


def test_why_it_failed_comes_with_advice(driver: Any, studio: str) -> None:
    driver.execute_script("document.querySelector('[data-job=\"2\"] .text').click()")
    text = wait(driver, "document.getElementById('job').textContent")
    assert "it is red, and is not" in text
    assert "change what it names" in text


def test_stages_queue_and_cancelling_by_keyboard(driver: Any, studio: str) -> None:
    """Focus stays at a row's button while its scene is solved, and a screen reader hears of it."""
    from selenium.webdriver.common.keys import Keys

    ask(driver, "A ball rolls; wait.", "running")
    ask(driver, "A box falls.", "waiting")
    wait(driver, "document.getElementById('job').textContent.includes('1 before it')")
    driver.execute_script("document.querySelector('[data-job=\"3\"] .text').focus()")
    keys(driver, Keys.ENTER)
    stages = "[...document.querySelectorAll('.stages .now, .stages .done')].map((e) => e.innerText)"
    assert wait(driver, f"{stages}.length > 1 && {stages}") == ["draft 0.5 s", "optimize …"]
    assert driver.execute_script("return document.getElementById('told').textContent") == (
        "running: optimize"
    )
    keys(driver, Keys.TAB)
    assert driver.execute_script("return document.activeElement.textContent") == "cancel"
    driver.execute_script("window.held = document.activeElement")
    ask_elsewhere = "fetch('/api/jobs', {method: 'POST', headers: {'Content-Type': 'application/json'}, body: JSON.stringify({prompt: 'A cup falls.'})})"
    driver.execute_script(ask_elsewhere)
    wait(driver, "document.querySelectorAll('#jobs li').length === 5")
    assert driver.execute_script("return document.activeElement === window.held")
    keys(driver, Keys.ENTER)
    badge = "document.querySelector('[data-job=\"3\"] .badge').textContent"
    wait(driver, f"{badge} === 'cancelled'")
    inside = "document.querySelector('[data-job=\"3\"]').contains(document.activeElement)"
    assert driver.execute_script(f"return {inside}")
    wait(driver, "document.querySelector('[data-job=\"5\"] .badge').textContent === 'solved'")
    assert complaints(driver) == []


def test_a_slider_is_turned_by_keys_and_asks_once(driver: Any, studio: str) -> None:
    from selenium.webdriver.common.keys import Keys

    typed(driver, "A car hits a box.")
    driver.execute_script("document.getElementById('knobs-box').open = true")
    driver.execute_script("document.querySelector('[data-knob^=\"speed/\"]').focus()")
    keys(driver, *[Keys.ARROW_RIGHT] * 5)
    said = driver.execute_script("return document.activeElement.getAttribute('aria-valuetext')")
    assert said.endswith(" m/s") and not said.startswith("about")
    wait(driver, "document.querySelector('[data-job=\"3\"] .badge')?.textContent === 'solved'")
    assert "changed" in driver.execute_script(
        "return document.querySelector('[data-job=\"3\"] .small').textContent"
    )
    time.sleep(1.0)
    assert driver.execute_script("return document.querySelectorAll('#jobs li').length") == 3


def test_a_bad_graph_is_told_and_a_good_one_goes_on(driver: Any, studio: str) -> None:
    typed(driver, "A ball rolls into a box.")
    driver.execute_script("document.getElementById('graph-box').open = true")
    edit = (
        "const g = document.getElementById('graph'); g.value = arguments[0](g.value);"
        "g.dispatchEvent(new Event('input'))"
    )
    driver.execute_script(edit.replace("arguments[0]", "((t) => t.replace('\"ball_1\"', '\"x\"'))"))
    told = wait(driver, "document.querySelector('#violations li:not(.fine)')?.textContent")
    assert "ball_1" in told
    assert driver.execute_script("return document.getElementById('graph-go').disabled")
    driver.refresh()
    assert wait(driver, "document.querySelector('#violations li:not(.fine)')?.textContent") == told
    driver.execute_script("document.getElementById('graph-reset').click()")
    wait(driver, "document.querySelector('#violations .fine')")
    assert not driver.execute_script("return document.getElementById('graph-go').disabled")
    driver.execute_script(edit.replace("arguments[0]", "((t) => '{')"))
    wait(driver, "document.getElementById('graph-go').disabled")
    assert complaints(driver) == []


def test_tabs_keep_their_own_prompt_over_reloads_and_see_one_queue(
    driver: Any, studio: str
) -> None:
    first = driver.current_window_handle
    typed(driver, "A ball rolls.")
    driver.switch_to.new_window("tab")
    driver.get(studio)
    prompt = "document.getElementById('prompt').value"
    assert driver.execute_script(f"return {prompt}") == "A ball rolls."  # as one left off
    ask(driver, "A cup falls.", "solved")
    second = driver.current_window_handle
    driver.switch_to.window(first)
    wait(driver, "document.querySelectorAll('#jobs li').length === 3")
    driver.refresh()
    assert driver.execute_script(f"return {prompt}") == "A ball rolls."
    wait(driver, "document.querySelectorAll('#read mark').length > 0")
    driver.switch_to.window(second)
    driver.refresh()
    assert driver.execute_script(f"return {prompt}") == "A cup falls."
    assert driver.execute_script("return location.hash") == "#3"
    assert "A cup falls." in wait(driver, "document.querySelector('#job strong')?.textContent")
    driver.close()
    driver.switch_to.window(first)


def test_a_prompt_of_twenty_thousand_characters_is_told(driver: Any, studio: str) -> None:
    long = ("A ball rolls. " * 1500)[:20_000]
    driver.execute_script(
        "const p = document.getElementById('prompt'); p.value = arguments[0];"
        "p.dispatchEvent(new Event('input'))",
        long,
    )
    mistake = "document.getElementById('mistake').textContent"
    assert "20000 characters; at most" in wait(driver, mistake)
    driver.refresh()
    kept = "return document.getElementById('prompt').value.length"
    assert driver.execute_script(kept) == 20_000
    assert "20000 characters" in wait(driver, mistake)


def test_a_killed_server_loses_nothing(driver: Any, tmp_path: Path) -> None:
    """The page says so, keeps what is written, and goes on by itself with the next server."""
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"http://127.0.0.1:{port}/"

    def start() -> subprocess.Popen[bytes]:
        server = subprocess.Popen(
            [sys.executable, "-m", "tests.studio.serving", str(tmp_path), str(port)],
            cwd=ROOT, env={**os.environ, "PYTHONPATH": str(ROOT)},
        )  # fmt: skip
        for _ in range(600):
            with socket.socket() as probe:
                if probe.connect_ex(("127.0.0.1", port)) == 0:
                    return server
            time.sleep(0.05)
        raise AssertionError("the server did not start")

    server = start()
    try:
        opened(driver, address)
        ask(driver, "A box falls.", "solved")
        ask(driver, "A ball rolls; wait.", "running")
        typed_more = "A cup stands."
        driver.execute_script("document.getElementById('prompt').value = ''")
        typed(driver, typed_more)
        server.send_signal(signal.SIGKILL)
        server.wait()
        wait(driver, "!document.getElementById('offline').hidden")
        driver.execute_script("document.getElementById('go').click()")
        mistake = wait(driver, "document.getElementById('mistake').textContent")
        assert "does not answer" in mistake
        server = start()
        wait(driver, "document.getElementById('offline').hidden")
        badges = "[...document.querySelectorAll('#jobs .badge')].map((b) => b.textContent)"
        wait(driver, f"{badges}[0] === 'interrupted'")
        assert driver.execute_script(f"return {badges}") == ["interrupted", "solved"]
        assert driver.execute_script("return document.getElementById('prompt').value") == typed_more
    finally:
        server.kill()
        server.wait()
    expected = ("ERR_CONNECTION", "INCOMPLETE", "/film - ", "/scenes/1/ - ")  # a scene of nothing
    assert [c for c in complaints(driver) if not any(e in c for e in expected)] == []


NAMELESS = """
return [...document.querySelectorAll('button, input, textarea, select, a, iframe, summary')]
  .filter((e) => e.checkVisibility())
  .filter((e) => !(e.labels?.length || e.textContent.trim() || e.title || e.ariaLabel))
  .map((e) => e.outerHTML);
"""


def test_everything_has_a_name_and_is_reached_by_tab(driver: Any, studio: str) -> None:
    from selenium.webdriver.common.keys import Keys

    typed(driver, PROMPT)
    driver.execute_script("document.querySelectorAll('details').forEach((d) => (d.open = true))")
    assert driver.execute_script(NAMELESS) == []
    assert driver.execute_script("return document.documentElement.lang") == "en"
    driver.execute_script("document.activeElement.blur()")
    reached = set[str]()
    for _ in range(40):
        keys(driver, Keys.TAB)
        reached.add(
            driver.execute_script(
                "return document.activeElement.id || document.activeElement.className"
            )
        )
    assert {"skip", "prompt", "seed", "go", "graph", "graph-go", "text"} <= reached


@pytest.mark.parametrize("dark", [False, True])
def test_text_is_readable_in_light_and_dark_and_on_a_phone(tmp_path: Path, dark: bool) -> None:
    """Contrast as WCAG AA asks, nothing wider than the screen."""
    from tests.report.test_browser import CONTRAST

    jobs = Jobs(tmp_path, pools())  # type: ignore[arg-type]  # stands for a WorkerPool
    with served(jobs) as address, chrome.browser(dark=dark) as driver:
        opened(driver, address)
        ask(driver, PROMPT, "solved")
        driver.execute_script(
            "document.querySelectorAll('details').forEach((d) => (d.open = true))"
        )
        assert driver.execute_script(CONTRAST) >= 4.5
        phone = {"width": 390, "height": 844, "deviceScaleFactor": 2, "mobile": True}
        driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", phone)
        assert driver.execute_script(WIDEST) <= 390
        assert driver.execute_script(CONTRAST) >= 4.5
