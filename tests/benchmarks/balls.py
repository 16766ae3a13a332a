"""A film of any length for the memory benchmark: a lesson-like dark screen, drawn with numpy.

Balls bounce between walls, a bar fades after each hit, readouts change.
"""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

from app.frames import Pixels

SIZE = (720, 1280)
COLOURS = (0x80CBC4, 0xF0E442, 0xBB86FC)
ORANGE = 0xFF8A65


def frames(size: tuple[int, int] = SIZE, fps: int = 30, seconds: float = 4.0) -> Iterator[Pixels]:
    """Pictures of `size` (width, height) in pixels, each an array of its own."""
    width, height = size
    scale = width / 720
    back = _backdrop(size, scale)
    room = (24 * scale, 292 * scale, width - 24 * scale, height - 256 * scale)
    radius = 30 * scale
    dice = np.random.default_rng(7)
    low = np.array(room[:2]) + radius
    high = np.array(room[2:]) - radius
    at = low + dice.random((12, 2)) * (high - low)
    speed = (dice.random((12, 2)) - 0.5) * 400 * scale
    hits: list[tuple[float, NDArray[np.float64]]] = []
    for number in range(round(seconds * fps)):
        at += speed / fps
        outside = (at < low) | (at > high)
        hits += [(number / fps, at[i].copy()) for i in np.flatnonzero(outside.any(axis=1))]
        hits = [hit for hit in hits if number / fps - hit[0] < 0.5]
        speed[outside] *= -1
        at = np.clip(at, low, high)
        picture = back.copy()
        for i, (x, y) in enumerate(at):
            _disc(picture, x, y, radius, COLOURS[i % 3], 0.4 + 0.05 * i)
        for when, (x, y) in hits:
            fade = 1 - (number / fps - when) * 2
            _bar(picture, x - 100 * scale, y, 200 * scale, 6 * scale, ORANGE, fade)
        readout = f"{number / fps:5.2f} s   {1.13 + 0.01 * (number % 17):.2f} N s"
        _paste(picture, _words(readout, round(26 * scale)), 412 * scale, height - 210 * scale)
        yield picture


def _backdrop(size: tuple[int, int], scale: float) -> Pixels:
    width, height = size
    picture = np.full((height, width), 0x121212, np.uint32)
    top, bottom = round(292 * scale), round(height - 256 * scale)
    left, right = round(24 * scale), round(width - 24 * scale)
    picture[top:bottom, left:right] = 0x181818
    cell = max(round(56 * scale), 4)
    picture[top:bottom:cell, left:right] = 0x242424
    picture[top:bottom, left:right:cell] = 0x242424
    picture[height - round(112 * scale) :] = 0x1E1E1E
    texts = (
        ("Reactions", 44, 34),
        ("When A pushes B, B pushes A just as hard,", 28, 94),
        ("in the opposite direction.", 28, 130),
        ("Tap to add a ball, tilt to push them all with the same", 24, 182),
        ("force. Each hit shows both impulses.", 24, 214),
        ("Inertia          Forces          Reactions", 24, height / scale - 50),
    )
    for text, points, y in texts:
        _paste(picture, _words(text, max(round(points * scale), 6)), 32 * scale, y * scale)
    return picture


def _words(text: str, points: int) -> NDArray[np.float64]:
    font = ImageFont.load_default(points)
    box = font.getbbox(text)
    image = Image.new("L", (int(box[2]) + 2, int(box[3]) + 2))
    ImageDraw.Draw(image).text((0, 0), text, fill=255, font=font)
    return np.asarray(image) * (0.87 / 255)


def _paste(picture: Pixels, cover: NDArray[np.float64], x: float, y: float) -> None:
    _blend(picture, round(x), round(y), cover, 0xFFFFFF)


def _disc(picture: Pixels, x: float, y: float, radius: float, colour: int, opacity: float) -> None:
    left, top = int(x - radius) - 2, int(y - radius) - 2
    side = int(2 * radius) + 5
    rows, columns = np.mgrid[top : top + side, left : left + side] + 0.5
    far = np.sqrt((columns - x) ** 2 + (rows - y) ** 2)
    _blend(picture, left, top, opacity * np.clip(radius - far + 0.5, 0, 1), colour)
    _blend(picture, left, top, np.clip(2 - np.abs(far - radius + 1.5), 0, 1), colour)


def _bar(
    picture: Pixels, x: float, y: float, width: float, thick: float, colour: int, opacity: float
) -> None:
    _blend(picture, int(x), int(y), np.full((max(int(thick), 1), int(width)), opacity), colour)


def _blend(picture: Pixels, left: int, top: int, cover: NDArray[np.float64], colour: int) -> None:
    height, width = picture.shape
    bottom, right = min(top + cover.shape[0], height), min(left + cover.shape[1], width)
    cover = cover[max(-top, 0) : bottom - top, max(-left, 0) : right - left]
    box = picture[max(top, 0) : bottom, max(left, 0) : right]
    if box.size == 0:
        return
    mixed = np.zeros_like(box)
    for shift in (16, 8, 0):
        below = (box >> shift) & 0xFF
        value = below + (((colour >> shift) & 0xFF) - below.astype(np.float64)) * cover
        mixed |= np.rint(value).astype(np.uint32) << np.uint32(shift)
    box[:] = mixed
