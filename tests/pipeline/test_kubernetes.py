"""The examples for Kubernetes: manifests whose names fit together and whose commands are ours."""

from __future__ import annotations

from pathlib import Path
import re
import shlex
from typing import Any

import pytest
import yaml

from esg.cli import build_app
from esg.commands.parsing import parse

ROOT = Path(__file__).parents[2]
MANIFESTS = sorted((ROOT / "deploy" / "kubernetes").glob("*.yaml"))


def documents(path: Path) -> list[dict[str, Any]]:
    return list(yaml.safe_load_all(path.read_text("utf-8")))


def containers(path: Path) -> list[dict[str, Any]]:
    templates = [d["spec"]["template"]["spec"] for d in documents(path) if "template" in d["spec"]]
    return [container for spec in templates for container in spec["containers"]]


def shell(container: dict[str, Any]) -> str:
    """What a container runs in a shell, as a pod of index 0 reads it; empty if none."""
    if container["command"] != ["sh", "-c"]:
        return ""
    (text,) = container["args"]
    return text.replace("$((JOB_COMPLETION_INDEX + 1))", "1")


@pytest.mark.parametrize("path", MANIFESTS, ids=lambda p: p.stem)
def test_their_commands_are_ours(path: Path) -> None:
    """Read by the parser of the command line; the exit code of failed scenes is no failure."""
    shown = [text for container in containers(path) if (text := shell(container))]
    assert shown
    for text in shown:
        command, _, otherwise = text.partition(" || ")
        words = shlex.split(command)
        assert words[:2] == ["esg", "dataset"] and "--resume" in words
        assert "$" not in command
        assert otherwise == "[ $? -eq 3 ]"
        parse(build_app(), words[1:])


@pytest.mark.parametrize("path", MANIFESTS, ids=lambda p: p.stem)
def test_their_names_fit_together(path: Path) -> None:
    found = documents(path)
    assert all(d["apiVersion"] and d["kind"] and d["metadata"]["name"] for d in found)
    named = {(d["kind"], d["metadata"]["name"]) for d in found}
    assert len(named) == len(found)
    for document in found:
        spec = document["spec"]
        if document["kind"] == "Deployment":
            labels = spec["template"]["metadata"]["labels"]
            assert spec["selector"]["matchLabels"] == labels
        if document["kind"] == "HorizontalPodAutoscaler":
            assert (spec["scaleTargetRef"]["kind"], spec["scaleTargetRef"]["name"]) in named
        if document["kind"] == "Service":
            served = [d for d in found if d["kind"] == "Deployment"
                      and d["spec"]["selector"]["matchLabels"] == spec["selector"]]  # fmt: skip
            (pods,) = (d["spec"]["template"]["spec"]["containers"] for d in served)
            open_ = {p["containerPort"] for c in pods for p in c["ports"]}
            assert {p["port"] for p in spec["ports"]} == open_


@pytest.mark.parametrize("path", MANIFESTS, ids=lambda p: p.stem)
def test_addresses_lead_to_their_services(path: Path) -> None:
    served = {
        (d["metadata"]["name"], str(p["port"]))
        for d in documents(path) if d["kind"] == "Service" for p in d["spec"]["ports"]
    }  # fmt: skip
    asked = {
        pair
        for c in containers(path)
        for text in [*c["command"], *(e["value"] for e in c.get("env", ()))]
        for pair in re.findall(r"(?:tcp|http)://([\w-]+):(\d+)", text)
    }
    assert asked == served


def test_there_are_shards_one_a_pod() -> None:
    (job,) = documents(ROOT / "deploy" / "kubernetes" / "shards.yaml")
    (text,) = (shell(c) for c in containers(ROOT / "deploy" / "kubernetes" / "shards.yaml"))
    assert f"--shard 1/{job['spec']['completions']} " in text
