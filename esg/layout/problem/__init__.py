"""A scene as the planar problem that the layout search solves."""
