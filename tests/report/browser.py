"""A headless Chromium for tests, or the reason why there is none."""

from __future__ import annotations

from collections.abc import Iterator
import contextlib
import os
from pathlib import Path
import shutil
import tempfile
from typing import Any

FLAGS = (
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-dev-shm-usage",
    "--use-gl=angle",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--enable-precise-memory-info",
    "--hide-scrollbars",
    "--window-size=1400,1000",
)


def missing() -> str:
    """Why no browser can be driven here; empty if one can."""
    if chromium() is None:
        return "no Chromium on this machine (Debian: apt-get install chromium chromium-driver)"
    if shutil.which("chromedriver") is None:
        return "no chromedriver on this machine (Debian: apt-get install chromium-driver)"
    try:
        import selenium  # noqa: F401
    except ImportError:
        return "selenium is not installed (pip install -e '.[dev]')"
    return ""


def chromium() -> str | None:
    """Path of a Chromium."""
    names = ("chromium", "chromium-browser", "google-chrome")
    return next((path for n in names if (path := shutil.which(n))), None)


@contextlib.contextmanager
def browser(*, dark: bool = False, network: bool = False) -> Iterator[Any]:
    """A fresh browser with an empty profile.

    Args:
        dark: Prefer dark colours.
        network: Let it reach anything but this machine; without, every address is refused.
    """
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = chromium() or ""
    for flag in FLAGS:
        options.add_argument(flag)
    if not network:
        options.add_argument("--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1")
    if dark:
        options.add_argument("--force-dark-mode")
        options.add_argument("--blink-settings=preferredColorScheme=0")
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    with tempfile.TemporaryDirectory() as profile:
        options.add_argument(f"--user-data-dir={profile}")
        driver = webdriver.Chrome(options, Service(shutil.which("chromedriver"), env=_quiet()))
        try:
            driver.set_page_load_timeout(120)
            yield driver
        finally:
            driver.quit()


def _quiet() -> dict[str, str]:
    return {k: v for k, v in os.environ.items() if not k.lower().endswith("_proxy")}


def open_page(driver: Any, path: Path | str, fragment: str = "") -> None:
    """Opens a file or address and waits until the page's script is ready."""
    from selenium.webdriver.support.ui import WebDriverWait

    address = path if isinstance(path, str) else path.resolve().as_uri()
    driver.get(address + fragment)
    WebDriverWait(driver, 120).until(
        lambda d: d.execute_script("return document.documentElement.dataset.ready") == "yes"
    )


def complaints(driver: Any) -> list[str]:
    """Errors and warnings of the console since the last call, drawing hints left out."""
    return [
        entry["message"]
        for entry in driver.get_log("browser")
        if entry["level"] in ("SEVERE", "WARNING") and "GPU stall" not in entry["message"]
    ]
