"""`python -m app.cli` is the command `laws`."""

from app.cli import main

main()
