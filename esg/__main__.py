"""`python -m esg`: the command line, where the console script is not on the path."""

from esg.cli import run

if __name__ == "__main__":
    run()
