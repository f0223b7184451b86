"""The timeline read as a story, and the everyday physics that planning it draws on."""
