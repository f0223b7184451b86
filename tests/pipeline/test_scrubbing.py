"""Keys in every form in which they come back."""

from __future__ import annotations

import base64
import json
import re
from urllib.parse import quote, quote_plus

from hypothesis import given, settings
from hypothesis import strategies as st
import pytest

from esg.commands.console import fail
from esg.outcomes import UserError
from esg.pipeline import SceneRequest, SceneState, crashed, run_stage
from esg.strangers.scrubbing import MARK, scrub, scrub_all

KEY = 'sk-"very/secret+\\0123=&x 456789'


def forms(key: str) -> list[str]:
    data = key.encode()
    return [
        key,
        json.dumps(key)[1:-1],
        json.dumps(json.dumps(key))[3:-3],
        json.dumps(key)[1:-1].replace("/", "\\/"),
        "".join(f"\\u{ord(c):04X}" for c in key),
        quote(key, safe=""),
        re.sub("%..", lambda escape: escape[0].lower(), quote(key, safe="")),
        quote_plus(key),
        quote(quote(key, safe=""), safe=""),
        "".join(f"&#{ord(c)};" for c in key),
        data.hex(),
        data.hex().upper(),
    ]


def encoded(key: str) -> list[str]:
    return [
        code(f"{before}{key}{after}".encode()).decode()
        for before in ("", "u", "me:", "Bearer ")
        for after in ("", ":", "\n more")
        for code in (base64.b64encode, base64.urlsafe_b64encode)
    ]


@pytest.mark.parametrize("form", forms(KEY))
def test_no_spelling_of_a_key_stays(form: str) -> None:
    assert scrub(f"before {form} after", KEY) == f"before {MARK} after"


@pytest.mark.parametrize("form", encoded(KEY))
def test_no_encoding_of_a_key_can_be_decoded(form: str) -> None:
    left = scrub(f"{{'auth': '{form}'}}", KEY)
    assert MARK in left
    piece = base64.b64encode(KEY.encode()).decode()[:12]
    assert piece not in left and base64.urlsafe_b64encode(KEY.encode()).decode()[8:20] not in left


@settings(deadline=None)
@given(
    st.text(min_size=12, max_size=60, alphabet=st.characters(min_codepoint=32, max_codepoint=126))
)
def test_any_key_is_found_in_any_form(key: str) -> None:
    for form in forms(key) + encoded(key):
        assert MARK in scrub(form, key)
    assert scrub("nothing here", key) in ("nothing here", MARK) or MARK in scrub(
        "nothing here", key
    )


def test_what_is_no_key_stays() -> None:
    text = "a car hits a box; " * 50
    assert scrub(text, "") == text
    assert scrub(text, KEY) == text


def test_logs_and_messages_hold_no_key_of_the_environment(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("ESG_LLM_API_KEY", KEY)
    monkeypatch.setenv("OTHER_TOKEN", "short")
    state = crashed(SceneState(SceneRequest("x")), RuntimeError(f"401 for {quote(KEY)}"), "draft")
    assert KEY not in json.dumps(state.log) and quote(KEY) not in json.dumps(state.log)
    assert MARK in state.reason and MARK in state.log[-1]["traceback"]
    assert scrub_all("short") == "short"
    fail(f"no answer from https://x/?key={quote(KEY, safe='')}", 1, True)
    told = capsys.readouterr()
    assert quote(KEY, safe="") not in told.out + told.err

    def refused(*_: object) -> str:
        raise UserError(f"the server says {KEY}")

    monkeypatch.setattr("esg.pipeline.stage_key", refused)
    ended = run_stage("draft", SceneState(SceneRequest("x")))
    assert KEY not in ended.reason + json.dumps(ended.log)
