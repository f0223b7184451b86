"""What the words of a prompt say of its physics beside objects, relations and events.

Whether something happens on ice, whether what moves keeps to the ground, whether a size is stated
without a number: casting needs to know, and nobody but the drafter reads the prompt. Recorded for
whichever drafter made the document; absent where nothing is said.
"""

from __future__ import annotations

import re

from esg.graph.models import EsgDocument, Wording

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


def wording(prompt: str) -> Wording | None:
    """What a prompt says of its physics; None if nothing."""
    ice = "ice" if ICE.search(prompt) else None
    ground = True if ON_THE_GROUND.search(prompt) else None
    return Wording(surface=ice, keeps_to_ground=ground) if ice or ground else None


def recorded(doc: EsgDocument) -> EsgDocument:
    """The draft with what its prompt and the words of its objects say.

    Args:
        doc: A draft; its prompt and its descriptions are what is read.
    """
    definition, graph = doc.scene_definition, doc.spatial_relation_graph
    said = wording(definition.original_description)
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
