"""Pictures of shapes sampled at 16 x 16 points a pixel: what anti-aliasing ought to give."""

import numpy as np
from numpy.typing import NDArray

FINE = 16


def sample_points(width: int, height: int) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """x as a row and y as a column of all sample points (px)."""
    x = (np.arange(width * FINE) + 0.5) / FINE
    y = (np.arange(height * FINE) + 0.5) / FINE
    return x[None, :], y[:, None]


def coverage(inside: NDArray[np.bool_]) -> NDArray[np.float64]:
    """Share of the samples of each pixel that are inside, times 255."""
    rows, columns = inside.shape
    return inside.reshape(rows // FINE, FINE, columns // FINE, FINE).mean(axis=(1, 3)) * 255


def disc(width: int, height: int, cx: float, cy: float, radius: float) -> NDArray[np.float64]:
    """Coverage of a circle."""
    x, y = sample_points(width, height)
    return coverage((x - cx) ** 2 + (y - cy) ** 2 <= radius * radius)


def hull(width: int, height: int, corners: list[tuple[float, float]]) -> NDArray[np.float64]:
    """Coverage of a convex polygon whose corners turn clockwise on the screen."""
    x, y = sample_points(width, height)
    inside = np.ones((height * FINE, width * FINE), bool)
    for i, (bx, by) in enumerate(corners):
        ax, ay = corners[i - 1]
        inside &= (bx - ax) * (y - ay) - (by - ay) * (x - ax) >= 0
    return coverage(inside)


def edge_error(picture: NDArray[np.uint32], truth: NDArray[np.float64]) -> float:
    """Mean difference, 0..255, over the pixels that an edge runs through."""
    edge = (truth > 0) & (truth < 255)
    return float(np.abs((picture & 255).astype(float) - truth)[edge].mean())
