"""How a scene is filmed where its prompt says so: from `filmed` statements to a camera's way.

`esg.graph.filming` reads the words together, `subjects` measures what is filmed, `ways` plans where
the camera is: from poses of a replay alone, in closed form, so that the judge and every picture
have the same.
"""
