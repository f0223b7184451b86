"""The page in a real browser: filters, keys, player, colours, escaping, no complaints."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from esg.report.page import write_report
from esg.report.run import load_run
from tests.report import browser as chrome
from tests.report.folders import statement, write_scene

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(bool(chrome.missing()), reason=chrome.missing() or "a browser is here"),
]

EVIL = "</script><script>document.title='owned'</script><b onclick=\"x\">'bold'</b>"


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run of four scenes: good, failed, hostile, and one without a draft."""
    run = tmp_path_factory.mktemp("run")
    write_scene(run / "S1-run0", seconds=9.0)
    missing = "A ball misses a box."
    fates = {"A ball": "kept", "misses": "broken", "a box": "not_represented"}
    write_scene(
        run / "S2-run0",
        missing,
        outcome="not_converged",
        reason="the replay disagrees",
        completed=False,
        said=[statement(missing, words, status) for words, status in fates.items()],
    )
    write_scene(run / "S10-run0", EVIL, reason=EVIL, label=EVIL, seconds=1.0)
    write_scene(run / "S11-run0", "", outcome="invalid_draft", reason="E_EMPTY: no objects")
    return write_report(load_run(run), run / "report.html", title=EVIL)


@pytest.fixture(scope="module")
def driver() -> Iterator[Any]:
    with chrome.browser() as found:
        yield found


@pytest.fixture
def opened(driver: Any, page: Path) -> Any:
    driver.get("about:blank")
    chrome.open_page(driver, page)
    return driver


def shown(driver: Any) -> list[str]:
    """Names of the visible cards, in order."""
    return driver.execute_script(
        "return [...document.querySelectorAll('#cards li:not([hidden]) strong')]"
        ".map((e) => e.textContent)"
    )


def choose(driver: Any, element: str, value: str) -> None:
    from selenium.webdriver.common.by import By
    from selenium.webdriver.support.ui import Select

    Select(driver.find_element(By.ID, element)).select_by_value(value)


def keys(driver: Any, *pressed: str) -> None:
    from selenium.webdriver.common.action_chains import ActionChains

    for key in pressed:
        ActionChains(driver).send_keys(key).perform()


def wait(driver: Any, script: str) -> Any:
    """The first true value of a script."""
    from selenium.webdriver.support.ui import WebDriverWait

    return WebDriverWait(driver, 60).until(lambda d: d.execute_script(script))


def open_scene(driver: Any, name: str) -> None:
    driver.execute_script("location.hash = '#/scene/' + arguments[0]", name)
    wait(driver, f"return document.querySelector('h1')?.textContent.startsWith('{name}')")


PAINTED = """
const canvas = document.querySelector('.stage canvas');
if (!canvas) return 0;
const copy = document.createElement('canvas');
copy.width = 720; copy.height = 480;
const draw = copy.getContext('2d', {willReadFrequently: true});
draw.drawImage(canvas, 0, 0, 720, 480);
const data = draw.getImageData(0, 0, 720, 480).data;
let red = 0;
for (let i = 0; i < data.length; i += 4)
  if (data[i] > 1.6 * data[i + 1] && data[i] > 1.6 * data[i + 2] && data[i] > 60) red++;
return red;
"""


MARKS = PAINTED.replace(
    "data[i] > 1.6 * data[i + 1] && data[i] > 1.6 * data[i + 2] && data[i] > 60",
    "data[i] > 240 && Math.abs(data[i + 1] - 59) < 24 && Math.abs(data[i + 2] - 31) < 24",
)
"""Pixels in the colour of a contact mark, which no light changes."""


def test_cards_filter_sort_and_search(opened: Any) -> None:
    """By outcome, by problem, by text; sorted either way."""
    every = ["S1-run0", "S2-run0", "S10-run0", "S11-run0"]
    assert shown(opened) == every
    choose(opened, "filter-outcome", "not_converged")
    assert shown(opened) == ["S2-run0"]
    choose(opened, "filter-outcome", "")
    choose(opened, "filter-problem", "events")
    assert shown(opened) == ["S2-run0"]
    choose(opened, "filter-problem", "")
    choose(opened, "filter-problem", "said")
    assert shown(opened) == ["S2-run0"]
    choose(opened, "filter-problem", "")
    choose(opened, "filter-event", "collision")
    assert shown(opened) == every[:3]
    choose(opened, "filter-event", "")
    choose(opened, "filter-sort", "seconds")
    assert shown(opened)[0] == "S10-run0"
    opened.execute_script("document.getElementById('direction').click()")
    assert shown(opened)[0] == "S1-run0"
    opened.execute_script("document.getElementById('direction').click()")
    choose(opened, "filter-sort", "order")
    keys(opened, "/", *"misses")
    assert shown(opened) == ["S2-run0"]
    count = opened.execute_script("return document.getElementById('count').textContent")
    assert count == "1 of 4 scenes"
    assert chrome.complaints(opened) == []


def test_everything_can_be_reached_with_the_keyboard(opened: Any) -> None:
    """Tab to a card, Enter opens it, keys play and step, brackets go on, Escape returns."""
    from selenium.webdriver.common.keys import Keys

    opened.execute_script("document.querySelector('#cards a').focus()")
    keys(opened, Keys.ENTER)
    wait(opened, "return document.querySelector('h1')?.textContent.startsWith('S1-run0')")
    wait(opened, "return document.querySelector('.stage canvas') !== null")
    clock = "return parseFloat(document.getElementById('clock').textContent)"
    keys(opened, "n")
    assert opened.execute_script(clock) == 0.5
    keys(opened, ".", ".")
    assert opened.execute_script(clock) == pytest.approx(0.53, abs=0.011)
    keys(opened, "p", "p")
    assert opened.execute_script(clock) == 0.0
    keys(opened, " ")
    wait(opened, clock + " > 0.2")
    keys(opened, " ")
    keys(opened, "]")
    wait(opened, "return document.querySelector('h1')?.textContent.startsWith('S2-run0')")
    keys(opened, Keys.ESCAPE)
    wait(opened, "return document.getElementById('cards') !== null")
    assert chrome.complaints(opened) == []


def test_the_player_draws_what_the_replay_says(opened: Any) -> None:
    """The red ball is in the picture; contacts add red marks at the time of the hit only."""
    open_scene(opened, "S1-run0")
    wait(opened, PAINTED.replace("return red;", "return red > 300;"))
    seek = (
        "const r = document.getElementById('scrub'); r.value = arguments[0];"
        "r.dispatchEvent(new Event('input'));"
    )
    settle = "return await new Promise((r) => setTimeout(() => r(true), 400))"
    opened.execute_script(seek, 0.51)
    opened.execute_script(settle)
    assert opened.execute_script(MARKS) > 20
    opened.execute_script("document.getElementById('show-contacts').click()")
    opened.execute_script(settle)
    assert opened.execute_script(MARKS) == 0
    assert opened.execute_script(PAINTED) > 300
    assert chrome.complaints(opened) == []


def test_plots_graph_history_class_and_downloads_are_there(opened: Any) -> None:
    """Every part of the scene's page has its content."""
    open_scene(opened, "S1-run0")
    counts = opened.execute_script(
        "document.querySelectorAll('details').forEach((d) => d.open = true);"
        "const n = (q) => document.querySelectorAll(q).length;"
        "return {lines: n('.plot path.line'), bands: n('.plot .band'), nodes: n('g.node'),"
        " edges: n('path.edge'), code: n('pre.code'), links: n('a[download]')}"
    )
    assert counts["lines"] == 3  # speed, distance, loss
    assert counts["bands"] == 5  # the prescribed speed, and two windows of time in both plots
    assert counts["nodes"] == 4
    assert counts["edges"] == 2
    assert counts["code"] == 1
    assert counts["links"] >= 5
    text = opened.execute_script("return document.querySelector('.detail').textContent")
    for words in (
        "Events: 1 of 1",
        "4.9 N s",
        "speed ball @hit = 5 m/s",
        "class AScene",
        "64 roll",
    ):
        assert words in text
    link = "return document.querySelector('a[download=\"esg.json\"]').href"
    assert opened.execute_script(link).startswith("blob:")
    assert chrome.complaints(opened) == []


def test_hostile_text_stays_text(opened: Any) -> None:
    """A prompt made of markup is shown letter by letter and runs nothing."""
    assert opened.title == EVIL
    open_scene(opened, "S10-run0")
    wait(opened, "return document.querySelector('.stage canvas') !== null")
    opened.execute_script("document.querySelectorAll('details').forEach((d) => d.open = true)")
    opened.execute_script("document.getElementById('show-names').click()")
    prompt = "return document.querySelector('.prompt.large').textContent"
    assert opened.execute_script(prompt) == EVIL
    assert opened.execute_script("return document.querySelectorAll('b, [onclick]').length") == 0
    assert "owned" not in opened.title.replace(EVIL, "")
    assert chrome.complaints(opened) == []


def test_a_scene_without_a_replay_says_so(opened: Any) -> None:
    """No player, no error."""
    open_scene(opened, "S11-run0")
    text = opened.execute_script("return document.querySelector('.detail').textContent")
    assert "never replayed" in text
    assert "E_EMPTY" in text
    assert chrome.complaints(opened) == []


CONTRAST = """
const lum = (c) => {
  const v = c.match(/[\\d.]+/g).slice(0, 3).map((x) => x / 255)
    .map((x) => (x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4));
  return 0.2126 * v[0] + 0.7152 * v[1] + 0.0722 * v[2];
};
const back = (e) => {
  for (; e; e = e.parentElement) {
    const c = getComputedStyle(e).backgroundColor;
    if (!c.endsWith(', 0)')) return c;
  }
  return 'rgb(255, 255, 255)';
};
let worst = 99;
for (const e of document.querySelectorAll('h1, h2, p, td, th, a, label, button, select, .badge')) {
  if (!e.textContent.trim() || !e.checkVisibility()) continue;
  const a = lum(getComputedStyle(e).color), b = lum(back(e));
  worst = Math.min(worst, (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05));
}
return worst;
"""


@pytest.mark.parametrize("dark", [False, True])
def test_text_is_readable_in_light_and_dark(page: Path, dark: bool) -> None:
    """Contrast of all text is at least 4.5 to 1 (WCAG AA), and the page follows the system."""
    with chrome.browser(dark=dark) as driver:
        chrome.open_page(driver, page)
        matches = "return matchMedia('(prefers-color-scheme: dark)').matches"
        assert driver.execute_script(matches) is dark
        assert driver.execute_script(CONTRAST) >= 4.5
        open_scene(driver, "S2-run0")
        assert driver.execute_script(CONTRAST) >= 4.5
        assert chrome.complaints(driver) == []


def test_view_plays_the_scene_and_offers_its_files(driver: Any, tmp_path: Path) -> None:
    """The served page is the scene's own, and its download links answer."""
    import threading

    from esg.report.serve import serve

    folder = write_scene(tmp_path / "drop")
    run = load_run(folder)
    path = write_report(run, tmp_path / "view.html", files="files")
    found: list[str] = []
    there = threading.Event()

    def ready(address: str) -> None:
        found.append(address)
        there.set()

    arguments = (path.read_bytes(), folder, 0, ready)
    server = threading.Thread(target=serve, args=arguments, kwargs={"seconds": 30.0}, daemon=True)
    server.start()
    assert there.wait(10)
    chrome.open_page(driver, found[0])
    wait(driver, PAINTED.replace("return red;", "return red > 300;"))
    links = driver.execute_script(
        "return [...document.querySelectorAll('a[download]')].map((a) => a.href)"
    )
    wanted = [link for link in links if link.endswith("rollout.npz")]
    assert wanted == [found[0] + "files/rollout.npz"]
    import urllib.request

    opener = urllib.request.build_opener(urllib.request.ProxyHandler({}))
    with opener.open(wanted[0], timeout=10) as answer:
        assert answer.read() == (folder / "rollout.npz").read_bytes()
    assert chrome.complaints(driver) == []


def test_engines_are_laid_over_each_other(
    driver: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A second engine has a switch, a column of its own, and its bodies are drawn when asked."""
    from esg.report.replays import Replayed
    from tests.report import folders

    def fake(_: Path, manifest: Any, engine: str) -> Replayed:
        moved = folders.rollout(engine=engine)
        moved.position[0, :, 0, 0] += 0.6
        return Replayed(manifest.scene, moved, "program", [folders.event()])

    monkeypatch.setattr("esg.report.replays._replay", fake)
    monkeypatch.setattr("esg.report.replays._judged", lambda _, replay: replay)
    write_scene(tmp_path / "run" / "drop")
    page = write_report(load_run(tmp_path / "run"), tmp_path / "e.html", engines=("rapier",))
    chrome.open_page(driver, page)
    wait(driver, PAINTED.replace("return red;", "return red > 300;"))
    text = driver.execute_script("return document.querySelector('.detail').textContent")
    assert "rapier (program)" in text
    blue = PAINTED.replace(
        "data[i] > 1.6 * data[i + 1] && data[i] > 1.6 * data[i + 2] && data[i] > 60",
        "data[i + 2] > data[i] + 30",
    )
    before = driver.execute_script(blue)
    driver.execute_script("document.getElementById('engine-rapier').click()")
    wait(driver, blue.replace("return red;", f"return red > {before} + 100;"))
    assert chrome.complaints(driver) == []


@pytest.mark.parametrize("width", [420, 1400])
def test_words_are_marked_by_what_became_of_them(driver: Any, tmp_path: Path, width: int) -> None:
    """By colour, by a sign, by a legend, by a table, and with what was measured on the mark."""
    prompt = "A ball on the table flies straight up."
    said = [
        statement(prompt, "on the table", "kept", share=1.0),
        statement(prompt, "straight up", "not_represented", EVIL),
    ]
    write_scene(tmp_path / "a", prompt, outcome="partial", reason="not represented", said=said)
    path = write_report(load_run(tmp_path), tmp_path / "report.html")
    size = {"width": width, "height": 900, "deviceScaleFactor": 1, "mobile": width < 1000}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)
    try:
        chrome.open_page(driver, path)
        marks = driver.execute_script(
            "return [...document.querySelectorAll('.prompt.large mark')].map((e) => "
            "[e.textContent, e.className, e.dataset.sign, e.title, e.tabIndex])"
        )
        assert [m[:3] for m in marks] == [
            ["on the table", "cover kept", "✓"],
            ["straight up", "cover not_represented", "∅"],
        ]
        assert "measured: share 1" in marks[0][3] and EVIL in marks[1][3]
        assert [m[4] for m in marks] == [0, 0]
        legend = driver.execute_script(
            "return [...document.querySelectorAll('.fates li')].map((e) => e.textContent)"
        )
        assert [text.split()[0] for text in legend] == ["kept", "not"]
        table = driver.execute_script("return document.querySelector('#statements').textContent")
        assert "Statements: 1 of 2 kept" in table and EVIL in table
        assert driver.execute_script("return document.title") != "owned"
        assert driver.execute_script("return document.documentElement.scrollWidth") <= width
        assert chrome.complaints(driver) == []
    finally:
        driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})


def test_a_long_name_fits_a_telephone(driver: Any, tmp_path: Path) -> None:
    """Scenes of `esg generate` are called by their prompt: nothing may reach beyond 420 pixels."""
    name = "a_chef_pushes_a_shopping_cart_past_a_fruit_stall-448326a4"
    write_scene(tmp_path / name, reason="x" * 200)
    write_scene(tmp_path / "other", outcome="crashed", completed=False)
    path = write_report(load_run(tmp_path), tmp_path / "report.html")
    narrow = {"width": 420, "height": 900, "deviceScaleFactor": 1, "mobile": True}
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", narrow)
    try:
        chrome.open_page(driver, path)
        widest = "return document.documentElement.scrollWidth"
        assert driver.execute_script(widest) <= 420
        told = driver.execute_script("return document.querySelector('#outcomes').textContent")
        assert told == "1 crashed1 solved"
        open_scene(driver, name)
        unfold = "document.querySelectorAll('details').forEach((e) => (e.open = true))"
        driver.execute_script(unfold)
        assert driver.execute_script(widest) <= 420
        event = driver.execute_script("return document.querySelector('.events strong').textContent")
        assert event and "ball_1" not in event
    finally:
        driver.execute_cdp_cmd("Emulation.clearDeviceMetricsOverride", {})
