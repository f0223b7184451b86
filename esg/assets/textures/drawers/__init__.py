"""The generators, by what they show."""

from esg.assets.textures.drawers import fabric, ground, hides, masonry, mineral, sheets, wood
from esg.assets.textures.recipe import RECIPES

__all__ = ["RECIPES", "fabric", "ground", "hides", "masonry", "mineral", "sheets", "wood"]
