"""The numbers behind a film: one row of comma-separated values per moving body and tick."""

import csv
from pathlib import Path

from app.frames import Film, Frame, Moment
from engine import World

HEADER = ("t", "body", "x", "y", "angle", "vx", "vy", "omega", "fx", "fy", "torque")
"""s, name, m, m, rad, m/s, m/s, rad/s, N, N, N m; forces acted during the tick that ended at t."""


class Tracks:
    """Writes `.csv`, in order of time, then of bodies. Pictures are not its business."""

    def __init__(self, part: Path, film: Film) -> None:
        self._file = part.open("w", encoding="utf-8", newline="")
        self._rows = csv.writer(self._file, lineterminator="\n")
        self._rows.writerow(HEADER)
        self._last: tuple[World, int] | None = None

    def frame(self, frame: Frame) -> None:
        """Nothing to see here."""

    def moment(self, moment: Moment) -> None:
        """One row for each moving body, unless the world stood still since the last moment."""
        world = moment.world
        if self._last is not None and self._last[0] is world and self._last[1] == world.tick:
            return
        self._last = (world, world.tick)
        time = _number(moment.time)
        for body in world:
            if body.is_wall:
                continue
            force = body.force
            values = (body.x, body.y, body.angle, body.vx, body.vy, body.spin)
            acted = (force.x, force.y, body.torque)
            name = body.name or f"body.{body.id}"
            self._rows.writerow((time, name, *map(_number, values), *map(_number, acted)))

    def finish(self) -> None:
        """Flush and close."""
        self._file.close()

    def abandon(self) -> None:
        """Close."""
        self._file.close()


def _number(value: float) -> str:
    return repr(float(value) + 0.0)  # adding zero turns -0.0 into 0.0
