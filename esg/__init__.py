"""Text to physically consistent dynamic 3D scenes, at dataset scale."""

__version__ = "0.2.0"
