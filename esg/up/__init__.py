"""`esg up`: a warm worker on this machine that runs one scene's commands for its user (docs/up.md).

The worker loads what scenes need once and forks for every command. Whoever asks it hands over
arguments, folder, environment and its three streams; what comes back is an exit code.
"""
