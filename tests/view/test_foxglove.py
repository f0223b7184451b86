"""The shipped Foxglove layout asks only for what the log has."""

from __future__ import annotations

import json
from pathlib import Path
import re

from mcap.reader import make_reader

from esg.engines.program import Program
from esg.store.mcap_log import EVENT_SCHEMA, write_mcap
from tests.report.folders import rollout, scene

LAYOUT = json.loads((Path(__file__).parents[2] / "data/foxglove/layout.json").read_bytes())


def panels(node: object) -> list[str]:
    if isinstance(node, str):
        return [node]
    assert isinstance(node, dict)
    return panels(node["first"]) + panels(node["second"])


def test_every_panel_is_configured_and_shown() -> None:
    """Panels that stand in the layout are those that have settings."""
    assert sorted(panels(LAYOUT["layout"])) == sorted(LAYOUT["configById"])


def test_topics_and_fields_exist_in_a_log(tmp_path: Path) -> None:
    """Every topic is a channel, every field one of the event schema, the frame is the world's."""
    path = tmp_path / "rollout.mcap"
    write_mcap(path, scene(), Program((), 1.0), rollout())
    with path.open("rb") as file:
        reader = make_reader(file)
        topics = {c.topic for c in reader.get_summary().channels.values()}
    text = json.dumps(LAYOUT["configById"])
    used = set(re.findall(r"/[a-z]+(?=[\"{.\\])", text))
    assert {"/events", "/log", "/scene"} <= used
    assert used <= topics
    fields = set(re.findall(r"\}\.([a-z_]+)", text)) | set(re.findall(r"\{([a-z_]+)==", text))
    assert fields == {"impulse_ns", "id", "kind"}
    assert fields <= set(EVENT_SCHEMA["properties"])
    assert LAYOUT["configById"]["3D!scene"]["followTf"] == "world"
