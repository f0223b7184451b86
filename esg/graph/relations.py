"""What spatial relations say of a pair: its order along an axis, closeness, support."""

from __future__ import annotations

from esg.graph.models import RelationType

R = RelationType

AXES: dict[str, dict[RelationType, int]] = {
    "left-right": {R.LEFT_OF: 1, R.RIGHT_OF: -1},
    "front-back": {R.IN_FRONT_OF: 1, R.BEHIND: -1},
    "up-down": {
        R.ON: 1,
        R.ABOVE: 1,
        R.HIGHER_THAN: 1,
        R.UNDER: -1,
        R.LOWER_THAN: -1,
        R.SAME_LEVEL_AS: 0,
    },
}
"""Sign of the displacement of `from` relative to `to` along an axis."""

CLOSE = frozenset({R.NEAR, R.ADJACENT, R.ON, R.INSIDE_OF, R.CENTER_OF, R.ATTACHED_VERTICAL,
                   R.ATTACHED_HORIZONTAL})  # fmt: skip
"""Relations of objects that are close to each other."""
SUPPORTS = frozenset({R.ON, R.INSIDE_OF, R.ATTACHED_VERTICAL, R.ATTACHED_HORIZONTAL})
"""Relations by which `to` holds `from`."""


def conflict(first: RelationType, second: RelationType, *, same_way: bool) -> str:
    """Why two relations of one pair exclude each other; "" when they do not.

    Args:
        first, second: Types of the relations.
        same_way: Whether both go from the same object to the other.
    """
    for axis, signs in AXES.items():
        if first in signs and second in signs:
            a, b = signs[first], signs[second] if same_way else -signs[second]
            if a != b:
                return f"both fix the {axis} order"
    if (first in CLOSE and second is R.FAR_FROM) or (second in CLOSE and first is R.FAR_FROM):
        return "one asks for closeness, the other for distance"
    if first in SUPPORTS and second in SUPPORTS:
        if not same_way:
            return "each would hold the other"
        if first is not second:
            return "an object is held in one way"
    return ""
