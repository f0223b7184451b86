"""The generators, by what they show."""

from esg.assets.textures.drawers import masonry

__all__ = ["masonry"]
