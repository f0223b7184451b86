"""What a distribution may ask for besides the action: where, in what light, what things look like,
who stands around, and how it is filmed (docs/dataset/variety.md).

All of it but the camera is said in the sentence, so that text, picture and physics agree.
"""
