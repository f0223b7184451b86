"""What the words of a prompt say of its physics beside objects, relations and events.

What the ground is like, whether what moves keeps to the ground, whether a size is stated
without a number: casting needs to know, and nobody but the drafter reads the prompt. Recorded for
whichever drafter made the document; absent where nothing is said.
"""

from __future__ import annotations

import re
from typing import Literal

from esg.graph.models import EsgDocument, Wording
from esg.lexicon.grounds import ground_said, grounds, weather_said

ICE = re.compile(
    r"\b(on|over|across|along|onto)\s+(the\s+|an?\s+)?(\w+\s+)?(ice|rink|ice[- ]rink)\b"
    r"(?!\s*-?(cream|cube|bucket|chest|box))"
    r"|\b(icy|frozen)\s+(ground|surface|lake|pond|river|floor|road|street|slope|field)\b",
    re.IGNORECASE,
)
"""Motion on ice, which neither cream nor cubes are."""
ON_THE_GROUND = re.compile(
    r"\b(roll|slid|slide|push|shov|bowl(s|ed)\b|putt|dribbl|skid)", re.IGNORECASE
)
"""Words that keep what moves on the ground."""
STATED_SIZE = re.compile(
    r"\b(tall|large|big|huge|giant|enormous|massive|full[- ]size[d]?)\b", re.IGNORECASE
)
"""Words after which a thing is not made smaller."""


def wording(prompt: str, scene_type: Literal["indoor", "outdoor"] = "outdoor") -> Wording | None:
    """What a prompt says of its physics; None if nothing.

    Args:
        prompt: As it was typed.
        scene_type: Indoors no weather is felt.
    """
    surface = _surface(prompt, scene_type)
    ground = True if ON_THE_GROUND.search(prompt) else None
    if surface is None and ground is None:
        return None
    return Wording.model_validate({"surface": surface, "keeps_to_ground": ground})


def _surface(prompt: str, scene_type: str) -> str | None:
    """The row of the table of grounds that is said; of several the slickest."""
    told = ground_said(prompt) + (weather_said(prompt) if scene_type == "outdoor" else [])
    names = {name for name, _, _ in told} | ({"ice"} if ICE.search(prompt) else set[str]())
    return min(names, key=lambda name: grounds()[name].grip, default=None)


def recorded(doc: EsgDocument) -> EsgDocument:
    """The draft with what its prompt and the words of its objects say.

    Args:
        doc: A draft; its prompt and its descriptions are what is read.
    """
    definition, graph = doc.scene_definition, doc.spatial_relation_graph
    said = wording(definition.original_description, definition.scene_parameters.scene_type)
    if said is not None:
        definition = definition.model_copy(update={"wording": said})
        doc = doc.model_copy(update={"scene_definition": definition})
    stated = {
        name: node.model_copy(update={"size_is_stated": True})
        for name, node in graph.nodes.items()
        if (wanted := doc.asset_requirement.get(node.asset_id)) is not None
        and STATED_SIZE.search(f"{wanted.asset_description} {node.label}")
    }
    if stated:
        graph = graph.model_copy(update={"nodes": {**graph.nodes, **stated}})
        doc = doc.model_copy(update={"spatial_relation_graph": graph})
    return doc
