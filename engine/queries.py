"""Questions to a world: what is here, what lies along this line, what is nearest.

They are exact and change nothing. Bodies are taken where they stand now; bounding circles, one look
at a table, leave few of them to be examined one by one.
"""

import math
from collections.abc import Iterable, Iterator
from typing import Any

import numpy as np

from engine import filters, validate
from engine.body import Body
from engine.hits import Hit, Nearest
from engine.hulls import (
    Hull,
    difference,
    nearest_on_hull,
    ray_to_hull,
    touching_point,
)
from engine.kernels.elementary import cos_sin
from engine.shapes import Barrier, Piece, Shape
from engine.store import Store
from engine.validate import shown
from engine.vector import Vector

SLACK = 1e-9
"""By which bounding circles are larger than need be, as a share of the lengths compared."""


class Choice:
    """Bodies of some categories, without sensors, and what can be asked about them."""

    def __init__(self, store: Store, mask: Any, leave_out: Any) -> None:
        """Check what was given.

        Raises:
            TypeError, ValueError: in one sentence that names the value.
        """
        self.store = store
        bits = filters.mask_bits(mask)
        if isinstance(leave_out, Body) or not isinstance(leave_out, Iterable):
            raise TypeError(f"leave_out must be a list of bodies, not {shown(leave_out)}")
        left_out = list(leave_out)
        for body in left_out:
            if not isinstance(body, Body):
                raise TypeError(f"leave_out must be a list of bodies, not one of {shown(body)}")
        bodies, count = store.tables.bodies, store.count("bodies")
        self.rows = (np.asarray(bodies.category)[:count] & bits) != 0
        self.rows &= np.asarray(bodies.sensor)[:count] == 0
        for body in left_out:
            self.rows[store.row(body)] = False

    def pieces_near(self, a: Vector, b: Vector, within: float) -> Iterator[int]:
        """Rows of the pieces whose bounding circles come so near (m) to the line from a to b."""
        t, count = self.store.tables, self.store.count("pieces")
        p, bodies = t.pieces, t.bodies
        with np.errstate(over="ignore", invalid="ignore"):  # what is beyond all squares is far
            row = np.asarray(p.body)[:count]
            angle = np.asarray(bodies.angle)[row]
            cos, sin = np.cos(angle), np.sin(angle)
            x, y = np.asarray(p.x)[:count], np.asarray(p.y)[:count]
            at_x = np.asarray(bodies.x)[row] + cos * x - sin * y
            at_y = np.asarray(bodies.y)[row] + sin * x + cos * y
            way_x, way_y = b.x - a.x, b.y - a.y
            square = way_x * way_x + way_y * way_y
            along = ((at_x - a.x) * way_x + (at_y - a.y) * way_y) / (
                square if square > 0.0 else 1.0
            )
            share = np.clip(along, 0.0, 1.0)
            off_x, off_y = at_x - a.x - share * way_x, at_y - a.y - share * way_y
            size = abs(a.x) + abs(a.y) + abs(b.x) + abs(b.y) + np.abs(at_x) + np.abs(at_y)
            far = np.asarray(p.reach)[:count] + within + SLACK * size
            near = self.rows[row] & (off_x**2 + off_y**2 <= far**2)
        yield from map(int, np.flatnonzero(near))

    def pieces(self) -> Iterator[int]:
        """Rows of all pieces of the bodies in question."""
        row = np.asarray(self.store.tables.pieces.body)[: self.store.count("pieces")]
        yield from map(int, np.flatnonzero(self.rows[row]))

    def body(self, piece: int) -> Body:
        """Whose piece it is."""
        return self.store.handles[self.store.tables.pieces.body[piece]]

    def hull(self, piece: int) -> tuple[Hull, float]:
        """Corners of a piece in the world and its radius (m)."""
        t = self.store.tables
        row, first = t.pieces.body[piece], t.pieces.first[piece]
        at = Vector(t.bodies.x[row], t.bodies.y[row])
        local = [
            Vector(t.corners.x[i], t.corners.y[i])
            for i in range(first, first + t.pieces.corners[piece])
        ]
        return placed(local, at, t.bodies.angle[row]), t.pieces.radius[piece]

    def at_point(self, point: Any) -> list[Body]:
        """Bodies that contain a point, the surface included, in the order of ids."""
        p = validate.vector(point, "point")
        found = set()
        for piece in self.pieces_near(p, p, 0.0):
            hull, radius = self.hull(piece)
            if nearest_on_hull(hull, p)[0] <= radius:
                found.add(self.store.tables.pieces.body[piece])
        return [self.store.handles[row] for row in sorted(found)]

    def in_box(self, low: Any, high: Any) -> list[Body]:
        """Bodies that touch an upright box, in the order of ids."""
        first, last = validate.vector(low, "low"), validate.vector(high, "high")
        if first.x > last.x or first.y > last.y:
            raise ValueError(
                f"low must not be beyond high, but {tuple(first)} is beyond {tuple(last)}"
            )
        box = [first, Vector(last.x, first.y), last, Vector(first.x, last.y)]
        middle = Vector((first.x + last.x) / 2.0, (first.y + last.y) / 2.0)
        found = set()
        for piece in self.pieces_near(middle, middle, math.dist(first, last) / 2.0):
            hull, radius = self.hull(piece)
            if nearest_on_hull(difference(hull, box), Vector(0.0, 0.0))[0] <= radius:
                found.add(self.store.tables.pieces.body[piece])
        return [self.store.handles[row] for row in sorted(found)]

    def along_ray(self, start: Any, end: Any) -> list[Hit]:
        """What a ray enters on its way, in order: each body once, where it is first entered."""
        a, b = validate.vector(start, "start"), validate.vector(end, "end")
        way = Vector(b.x - a.x, b.y - a.y)
        hits = []
        for piece in self.pieces_near(a, b, 0.0):
            hull, radius = self.hull(piece)
            if comes_from_behind(self.store, piece, hull, way):
                continue
            fraction, normal = ray_to_hull(hull, radius, a, way)
            if fraction <= 1.0:
                point = Vector(a.x + fraction * way.x, a.y + fraction * way.y)
                hits.append(Hit(self.body(piece), point, normal, fraction))
        return in_order(hits)

    def along_sweep(self, shape: Shape, start: Any, end: Any, angle: Any) -> list[Hit]:
        """What a shape touches that moves from start to end without turning, in order."""
        if not isinstance(shape, Shape):
            raise TypeError(f"only a shape can be cast, not {shown(shape)}")
        if isinstance(shape, Barrier):
            raise ValueError(f"a wall is immovable: {shape} cannot be cast")
        a, b = validate.vector(start, "start"), validate.vector(end, "end")
        turned = validate.finite(angle, "angle")
        hits = []
        for cast in shape.pieces:
            hits += self.sweep_piece(cast, a, b, turned)
        return in_order(hits)

    def sweep_piece(self, cast: Piece, a: Vector, b: Vector, angle: float) -> list[Hit]:
        """What a convex piece touches that moves with its body's centre from a to b."""
        way = Vector(b.x - a.x, b.y - a.y)
        own = placed(cast.corners, Vector(0.0, 0.0), angle)
        swing = cast.radius + max(math.dist(corner, (0.0, 0.0)) for corner in own)
        hits = []
        for piece in self.pieces_near(a, b, swing):
            hull, radius = self.hull(piece)
            if comes_from_behind(self.store, piece, hull, way):
                continue
            fraction, normal = ray_to_hull(difference(hull, own), radius + cast.radius, a, way)
            if fraction <= 1.0:
                at = Vector(a.x + fraction * way.x, a.y + fraction * way.y)
                there = [Vector(at.x + corner.x, at.y + corner.y) for corner in own]
                point = touching_point(hull, radius, there, normal)
                hits.append(Hit(self.body(piece), point, normal, fraction))
        return hits

    def nearest_to(self, point: Any, within: Any) -> Nearest | None:
        """The body whose surface is nearest to a point; None if none is `within` (m) reach."""
        p = validate.vector(point, "point")
        endless = validate.is_endless(within)
        far = math.inf if endless else validate.not_negative(within, "within")
        best: Nearest | None = None
        pieces = self.pieces() if far == math.inf else self.pieces_near(p, p, far)
        for piece in pieces:
            hull, radius = self.hull(piece)
            distance, normal = nearest_on_hull(hull, p)
            distance -= radius
            if distance <= far and (best is None or distance < best.distance):
                surface = Vector(p.x - distance * normal.x, p.y - distance * normal.y)
                best = Nearest(self.body(piece), surface, normal, distance)
        return best


def placed(corners: Iterable[Vector], at: Vector, angle: float) -> Hull:
    """Corners of a body's frame, in the world."""
    cos, sin = cos_sin(angle)
    return [Vector(at.x + cos * p.x - sin * p.y, at.y + sin * p.x + cos * p.y) for p in corners]


def comes_from_behind(store: Store, piece: int, hull: Hull, way: Vector) -> bool:
    """Whether a piece is a one-sided wall that lets through what moves this way."""
    if not store.tables.pieces.one_sided[piece]:
        return False
    x, y = hull[1].x - hull[0].x, hull[1].y - hull[0].y
    return way.y * x - way.x * y >= 0.0


def in_order(hits: list[Hit]) -> list[Hit]:
    """Hits by fraction, then by ids; the first of each body."""
    first: dict[int, Hit] = {}
    for hit in sorted(hits, key=lambda hit: (hit.fraction, hit.body.id)):
        first.setdefault(hit.body.id, hit)
    return list(first.values())
