"""Captions and questions of a scene, made from what its replay shows (docs/dataset/annotations.md).

`motion` measures a trajectory, `nouns` names its bodies, `clauses` says what happened, `captions`
and `questions` put it into English from rows of data.
"""
