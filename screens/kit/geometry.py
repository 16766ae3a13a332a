"""Points, sizes and rectangles of the screen, in dp: x to the right, y downwards."""

from typing import NamedTuple


class Point(NamedTuple):
    """A place on the screen (dp)."""

    x: float
    y: float


class Size(NamedTuple):
    """A width and a height (dp)."""

    width: float
    height: float


class Rect(NamedTuple):
    """An upright rectangle (dp): its top left corner and its size."""

    x: float
    y: float
    width: float
    height: float

    @property
    def right(self) -> float:
        """The x just past its right side."""
        return self.x + self.width

    @property
    def bottom(self) -> float:
        """The y just below its lower side."""
        return self.y + self.height

    @property
    def center(self) -> Point:
        """Its middle."""
        return Point(self.x + self.width / 2, self.y + self.height / 2)

    def holds(self, at: Point) -> bool:
        """Whether `at` lies inside (left and upper sides belong to it)."""
        return self.x <= at.x < self.right and self.y <= at.y < self.bottom

    def inset(self, by: float) -> "Rect":
        """The same rectangle, smaller by `by` on each side (larger if negative)."""
        return Rect(self.x + by, self.y + by, self.width - 2 * by, self.height - 2 * by)

    def overlaps(self, other: "Rect") -> bool:
        """Whether the two share any area."""
        return (
            self.x < other.right
            and other.x < self.right
            and self.y < other.bottom
            and other.y < self.bottom
        )
