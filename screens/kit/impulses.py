"""What is seen of collisions between balls: the arrows of both impulses, and words beside them."""

from collections.abc import Callable, Sequence
from typing import NamedTuple

from engine import Body, Collision, Particle, Vector, Wall
from screens.kit import arrows, hits, theme
from screens.kit.bodies import SHORTEST, beside, fitting
from screens.kit.canvas import GAP_TO_BORDER, Canvas, bar_room
from screens.kit.geometry import Point, Rect, Size
from screens.kit.labels import Labels
from screens.kit.view import View

PER_IMPULSE, LONGEST = 32.0, 72.0
"""Length of the arrow of an impulse (dp per N s), and how long it can get (dp)."""
ARROWS, LABELS = 5, 3
"""How many hits at once show their impulses, and how many say how great they are."""
FAINTEST = 0.02
"""The least impulse that gets words (N s)."""
STRONGER = 1.5
"""By so many times a hit must be stronger than one with words to take these over."""
LANE = 14.0
"""From one arrow to the other if both lie beside a ball (dp)."""
AHEAD = 0.15
"""Words keep off the ways of the balls in this time (s)."""
CHARACTER, PILL = 5.8, Size(20.0, 22.0)
"""Room that words are given: for each character and around them (dp)."""


class Mark(NamedTuple):
    """A collision that is still shown."""

    hit: Collision
    words: str = ""
    place: Rect | None = None
    """Where the words stand (dp), chosen once: they stay there while they fade."""


def remember(
    marks: Sequence[Mark],
    news: Sequence[Collision],
    now: float,
    words: Callable[[Collision], str],
    place: Callable[[Collision, str, Sequence[Mark]], Rect | None],
) -> tuple[Mark, ...]:
    """Those of `marks` and `news` that are still shown at `now` (s).

    `words` says what is written beside a hit, and `place` where, given the other marks.
    """
    kept = [mark for mark in marks if hits.is_fresh(mark.hit, now)]
    news = hits.fresh(news, now)
    kept += [Mark(hit) for hit in news]
    for hit in hits.strongest(news, LABELS):
        labelled = [i for i, mark in enumerate(kept) if mark.place]
        size = hits.size(hit.impulse)
        if size < FAINTEST:
            continue
        others = kept
        if len(labelled) >= LABELS:
            weakest = min(labelled, key=lambda i: hits.size(kept[i].hit.impulse))
            if size < STRONGER * hits.size(kept[weakest].hit.impulse):
                continue
            others = [*kept]
            others[weakest] = kept[weakest]._replace(place=None)
        said = words(hit)
        found = place(hit, said, others)
        if found is None:
            break  # Where one finds no room, the next will hardly find any.
        kept = others
        kept[len(kept) - len(news) + news.index(hit)] = Mark(hit, said, found)
    return tuple(kept)


def find_place(
    view: View,
    walls: Sequence[Wall],
    balls: Sequence[Body],
    marks: Sequence[Mark],
    hit: Collision,
    words: str,
) -> Rect | None:
    """Where words about a hit may stand, near it (dp): not over walls, balls, arrows, other words.

    Nor over where the balls will be soon, if there is such a place; in a crowd the arrows of other
    hits may cross them.
    """
    size = Size(CHARACTER * len(words) + PILL.width, PILL.height)
    ways = [_way(view, ball) for ball in balls]
    for looks_ahead, others in ((True, marks), (False, marks), (False, ())):
        labels = Labels(view.rect.inset(GAP_TO_BORDER))
        labels.block(bar_room(view.rect))
        for wall in walls:
            ends = view.to_screen(wall.start), view.to_screen(wall.end)
            labels.block_line(*ends, theme.WALL_WIDTH)
        for here, soon, radius in ways:
            labels.block_circle(here, radius)
            if looks_ahead:
                labels.block_line(here, soon, 1.6 * radius)
        for mark in marks:
            if mark.place:
                labels.block(mark.place)
        for other in others:
            if other.place:
                _block_arrows(labels, view, other.hit)
        _block_arrows(labels, view, hit)
        found = labels.place(size, view.to_screen(hit.point), gap=10)
        if found:
            return found
    return None


def _way(view: View, ball: Body) -> tuple[Point, Point, float]:
    """Where a ball is, where it will be `AHEAD`, and its radius (dp)."""
    (x, y), (vx, vy) = ball.position, ball.velocity
    soon = view.to_screen((x + vx * AHEAD, y + vy * AHEAD))
    return view.to_screen((x, y)), soon, radius_of(ball) * view.scale


def _block_arrows(labels: Labels, view: View, hit: Collision) -> None:
    """Keep words off the arrows of a hit; those that end at a wall lie beside the ball."""
    reach = hits.reach(hit.impulse, PER_IMPULSE, LONGEST)
    for body, sign in ((hit.b, 1.0), (hit.a, -1.0)):
        if not body.is_wall:
            center, radius = view.to_screen(body.position), radius_of(body) * view.scale
            long = sign * (1.0 + radius / hits.size(Vector(*reach)))
            tip = Point(center.x + long * reach[0], center.y - long * reach[1])
            is_beside = hit.a.is_wall or hit.b.is_wall or not view.rect.holds(tip)
            labels.block_line(center, tip, 2 * radius + 28.0 if is_beside else 14.0)


def draw_words(canvas: Canvas, marks: Sequence[Mark], now: float) -> list[Rect]:
    """Draw what is said of hits, faded by age; returns the rectangles it lies in (dp).

    Balls are to be drawn over it.
    """
    under = []
    for mark in marks:
        if mark.place:
            size, middle = canvas.pill_size(mark.words), mark.place.center
            rect = Rect(middle.x - size.width / 2, middle.y - size.height / 2, *size)
            canvas.pill(mark.words, rect, theme.ORANGE, hits.fading(mark.hit, now))
            under.append(rect)
    return under


def draw_arrows(canvas: Canvas, marks: Sequence[Mark], now: float) -> None:
    """Draw the impulses of hits, faded by age, over the balls: in a crowd heads must be seen."""
    for hit in _pointed(marks):
        _draw_arrows(canvas, hit, hits.fading(hit, now))


def _pointed(marks: Sequence[Mark]) -> list[Collision]:
    """The hits that have arrows: all that have words, and of the others the strongest."""
    said = [mark.hit for mark in marks if mark.place]
    silent = [mark.hit for mark in marks if not mark.place]
    return hits.strongest(silent, ARROWS - len(said)) + said


def _draw_arrows(canvas: Canvas, hit: Collision, faded: float) -> None:
    """What b received, with a solid head, and what a received, with a hollow one."""
    x, y = hits.reach(hit.impulse, PER_IMPULSE, LONGEST)
    ends = (
        (hit.b, hit.a, (x, y), arrows.FORCE),
        (hit.a, hit.b, (-x, -y), arrows.REACTION),
    )
    edges = [canvas.edge(body, reach) for body, _, reach, _ in ends]
    room = [
        0.0 if body.is_wall else fitting(canvas, edge, reach)
        for edge, (body, _, reach, _) in zip(edges, ends, strict=True)
    ]
    # Both are shortened alike, so that they are seen to be equal.
    part = min((free for free in room if free >= SHORTEST), default=1.0)
    lane = 0.0
    for (body, other, (dx, dy), kind), edge, free in zip(ends, edges, room, strict=True):
        reach, ball = (dx * part, dy * part), other if body.is_wall else body
        if free >= SHORTEST:
            start = Vector(*edge)
        else:
            # Beside the ball; if that of the wall lies there too, one beside the other.
            start = beside(canvas, ball.position, reach, radius_of(ball) + lane)
            lane = LANE / canvas.view.scale if hit.a.is_wall or hit.b.is_wall else 0.0
        canvas.arrow(start, reach, kind, faded)


def radius_of(ball: Body) -> float:
    """Of a ball (m)."""
    return ball.shape.radius if isinstance(ball.shape, Particle) else 0.0
