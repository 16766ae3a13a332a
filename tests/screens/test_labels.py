"""Labels cover nothing, stay inside, and stand before the heads of arrows."""

from hypothesis import given
from hypothesis import strategies as st

from screens.kit.geometry import Point, Rect, Size
from screens.kit.labels import Labels

BOUNDS = Rect(10, 100, 336, 366)
places = st.builds(Point, st.floats(10, 346), st.floats(100, 466))
blocks = st.builds(
    Rect, st.floats(0, 350), st.floats(90, 470), st.floats(1, 120), st.floats(1, 120)
)
sizes = st.builds(Size, st.floats(10, 160), st.floats(10, 40))


@given(st.lists(blocks, max_size=12), st.lists(st.tuples(sizes, places), max_size=6))
def test_labels_cover_neither_blocks_nor_each_other(taken, wanted):
    labels = Labels(BOUNDS)
    for rect in taken:
        labels.block(rect)
    standing = list(taken)
    for size, anchor in wanted:
        place = labels.place(size, anchor)
        if place is None:
            continue
        assert not any(place.overlaps(other) for other in standing)
        assert place.x >= BOUNDS.x
        assert place.y >= BOUNDS.y
        assert place.right <= BOUNDS.right
        assert place.bottom <= BOUNDS.bottom
        assert (place.width, place.height) == size
        standing.append(place)


@given(places, st.floats(5, 60), sizes, places)
def test_labels_stay_off_a_disc(center, radius, size, anchor):
    labels = Labels(BOUNDS)
    labels.block_circle(center, radius)
    place = labels.place(size, anchor)
    if place is not None:
        x = min(max(center.x, place.x), place.right)
        y = min(max(center.y, place.y), place.bottom)
        assert (x - center.x) ** 2 + (y - center.y) ** 2 >= (0.95 * radius) ** 2


@given(places, places, sizes, places)
def test_labels_stay_off_a_line(a, b, size, anchor):
    labels = Labels(BOUNDS)
    labels.block_line(a, b, 4)
    place = labels.place(size, anchor)
    if place is not None:
        for i in range(101):
            at = Point(a.x + (b.x - a.x) * i / 100, a.y + (b.y - a.y) * i / 100)
            assert not place.holds(at)


def test_the_first_choice_is_above_the_anchor():
    place = Labels(BOUNDS).place(Size(80, 20), Point(150, 300), gap=6)
    assert place == Rect(110, 274, 80, 20)


def test_a_label_stands_before_an_arrow_while_that_is_free():
    ahead = Labels(BOUNDS).place(Size(80, 20), Point(150, 300), gap=6, ahead=Point(5, 0))
    assert ahead == Rect(156, 290, 80, 20)
    labels = Labels(BOUNDS)
    labels.block(Rect(210, 295, 5, 5))
    elsewhere = labels.place(Size(80, 20), Point(150, 300), gap=6, ahead=Point(5, 0))
    assert elsewhere == Rect(110, 274, 80, 20)


def test_a_label_moves_as_little_as_its_arrow():
    before = Labels(BOUNDS).place(Size(80, 20), Point(150, 300), ahead=Point(40, 9.5))
    after = Labels(BOUNDS).place(Size(80, 20), Point(150.3, 300), ahead=Point(40.3, 10.5))
    assert abs(after.x - before.x) < 2
    assert abs(after.y - before.y) < 2


def test_there_may_be_no_place():
    labels = Labels(BOUNDS)
    assert labels.place(Size(400, 20), Point(150, 300)) is None
    labels.block(BOUNDS)
    assert labels.place(Size(20, 20), Point(150, 300)) is None


def test_a_label_beside_the_border_is_pushed_inside():
    place = Labels(BOUNDS).place(Size(120, 20), Point(344, 300), gap=6)
    assert place == Rect(226, 274, 120, 20)
