"""The page of a study in a real browser, by keyboard alone, and its answers analysed."""

from __future__ import annotations

from collections.abc import Iterator
import contextlib
import json
from pathlib import Path
from typing import Any

import pytest

from esg.study.analysis import read_answers, read_key
from esg.study.clips import find_clips
from esg.study.page import write_study
from tests.report import browser as chrome
from tests.study.samples import VARIANTS, write_run

pytestmark = [
    pytest.mark.browser,
    pytest.mark.skipif(bool(chrome.missing()), reason=chrome.missing() or "a browser is here"),
]


@pytest.fixture(scope="module")
def driver() -> Iterator[Any]:
    with chrome.browser() as found:
        yield found


def press(driver: Any, *keys: str) -> None:
    from selenium.webdriver.common.action_chains import ActionChains

    for key in keys:
        ActionChains(driver).send_keys(key).perform()


def focus(driver: Any, selector: str) -> None:
    driver.execute_script(f"document.querySelector({json.dumps(selector)}).focus()")


def test_a_participant_gets_through_by_keyboard_and_saves_answers(
    driver: Any, tmp_path: Path
) -> None:
    from selenium.webdriver.common.keys import Keys

    clips = find_clips(write_run(tmp_path / "run"), VARIANTS, 0, 3)
    page, key = write_study(clips, tmp_path / "study.html", seed=3, pairs="full")
    driver.get(page.as_uri())
    assert driver.execute_script("return document.getElementById('begin').disabled")
    driver.execute_script(
        "const Own = Blob; window.Blob = class extends Own {"
        " constructor(parts, more) { super(parts, more); window.saved = parts.join(''); } };"
    )
    focus(driver, "#agree")
    press(driver, Keys.SPACE, Keys.TAB, Keys.ENTER)
    for step in range(6):
        part = "rate" if step < 4 else "pair"
        heading = driver.execute_script("return document.activeElement.textContent")
        assert f"{step + 1} of 6" in heading
        fields = ["#quality", "#alignment"] if part == "rate" else [
            "#better-quality", "#better-alignment"]  # fmt: skip
        legends = driver.execute_script(
            "return arguments[0].map((s) => document.querySelector(s + ' legend').textContent)",
            fields,
        )
        assert all(text.endswith("?") for text in legends)
        for field in fields:
            focus(driver, f"{field} input")
            press(driver, Keys.SPACE, Keys.ARROW_DOWN)
        press(driver, Keys.ENTER)
    link = driver.execute_script("return document.getElementById('save').href")
    assert link.startswith("blob:")
    name = driver.execute_script("return document.getElementById('save').download")
    assert name.startswith("answers-") and name.endswith(".json")
    saved = driver.execute_script("return window.saved")
    answers = tmp_path / name
    answers.write_text(saved)
    assert not [c for c in chrome.complaints(driver) if "ontent" in c and "olicy" in c]
    (found,) = read_answers([answers], read_key(key))
    assert [row["quality"] for row in found["ratings"]] == [2, 2, 2, 2]
    assert len(found["pairs"]) == 2 and found["pairs"][0]["quality"] == found["pairs"][0]["second"]


def test_the_order_differs_between_participants(driver: Any, tmp_path: Path) -> None:
    from selenium.common.exceptions import NoAlertPresentException

    clips = find_clips(write_run(tmp_path / "run"), VARIANTS, 0, 3)
    page, _ = write_study(clips, tmp_path / "study.html", seed=3, pairs=None)
    orders = set()
    for _ in range(6):
        driver.get(page.as_uri())
        driver.execute_script(
            "document.getElementById('agree').click(); document.getElementById('begin').click();"
        )
        orders.add(driver.execute_script("return document.getElementById('rate-film').src"))
        driver.execute_script("window.onbeforeunload = null")
        driver.get("about:blank")
        with contextlib.suppress(NoAlertPresentException):
            driver.switch_to.alert.accept()
    assert len(orders) > 1
