"""Robot descriptions (URDF, MJCF) as assets with joints.

`admitted` refuses what may not be read or cannot be held, `compiled` lets MuJoCo read the rest and
measures its parts, `importer` writes them, `joining` gives them to a document.
"""
