"""Parts of things that turn, slide or swing on a joint; their mounts agree with each other."""
