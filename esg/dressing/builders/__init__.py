"""Builders of what only dressing needs; everything else comes from the parametric library.

A builder draws into a box of the wished extents: origin at the middle of its bottom, front +X.
"""

from esg.dressing.builders import furniture, grounds, outdoors, plants, walls
from esg.dressing.builders.table import BUILDERS, Wish

__all__ = ["BUILDERS", "Wish", "furniture", "grounds", "outdoors", "plants", "walls"]
