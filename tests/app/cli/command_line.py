"""Runs the real command in a process of its own."""

import os
import signal
import subprocess
import sys
from pathlib import Path

LAWS = (sys.executable, "-m", "app.cli")

PUSH = """\
laws: 1
screen: inertia
title: Push
alt: A push.
seed: 3
size: 180x320
fps: 10
set: {body.mass: 2, force.x: 3, force.y: 0}
steps:
  - caption: A push.
  - tap: force.toggle
  - wait: 0.5s
  - tap: force.toggle
  - expect: {probe: body.speed, near: 0.75, tol: 1e-9}
  - wait: 0.5s
"""
"""A second of film: 3 N on 2 kg for half a second."""


def laws(*arguments, folder, interpreter=(), stdout=subprocess.PIPE, **environment):
    """Run `laws` in a folder; its exit code, stdout (unless it goes elsewhere) and stderr."""
    done = subprocess.run(
        [sys.executable, *interpreter, "-m", "app.cli", *map(str, arguments)],
        cwd=folder,
        stdout=stdout,
        stderr=subprocess.PIPE,
        env=surroundings(**environment),
        timeout=120,
        check=False,
    )
    return done.returncode, (done.stdout or b"").decode(), done.stderr.decode()


def start(*arguments, folder):
    """Start `laws` in a folder and do not wait for it. It heeds a closed terminal, though these
    tests may not, as under nohup.
    """
    return subprocess.Popen(
        [*LAWS, *map(str, arguments)],
        cwd=folder,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        env=surroundings(),
        preexec_fn=heed_hangups if hasattr(signal, "SIGHUP") else None,
    )


def heed_hangups():
    signal.signal(signal.SIGHUP, signal.SIG_DFL)


def surroundings(**changes):
    """The environment of this process with changes; None takes a variable away."""
    merged = os.environ | {"PYTHONPATH": ""} | changes
    return {name: value for name, value in merged.items() if value is not None}


def files(folder):
    """Every file below a folder, hidden ones too."""
    return sorted(str(p.relative_to(folder)) for p in Path(folder).rglob("*") if p.is_file())
