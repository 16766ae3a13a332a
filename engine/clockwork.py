"""What drives a world: it runs the kernels tick by tick and does what only Python can do."""

from engine import collision, jit, warming
from engine.collision import Collision, Diverged
from engine.pair_rows import mix_by_rules
from engine.settings import Laws, Rule, geometric_mean, larger
from engine.store import Store
from engine.tables import Tables
from engine.tick import FULL, LOOSE, LOST, UNMIXED, WAITING
from engine.travel import DONE

BODY, PAIR = 15e-6, 40e-6
"""What an interpreted tick takes for each body and for each pair, roughly (s). An estimate, so that
no clock has a say."""

WORTHWHILE = 2.0
"""Interpreted work (s) after which a world is taken for one that goes on for long."""

AGAIN = 0.2
"""Interpreted work (s) between two looks at whether machine code is ready."""

AT_ONCE = 30
"""Ticks between two looks at most."""


class Clockwork:
    """Advances the tables of a store by the kernels of a mode (see `jit.resolve`)."""

    __slots__ = ("_bound_to", "_kernels", "_next_look", "_run", "_store", "_work")

    def __init__(self, store: Store, mode: str) -> None:
        """Choose the kernels.

        Raises:
            ValueError: for an unknown mode.
            ImportError: if compiled kernels are asked for and numba is missing or broken.
        """
        mode = jit.resolve(mode)
        self._store = store
        self._kernels = jit.compiled() if mode == "compiled" else jit.INTERPRETED
        self._bound_to: tuple[Tables, Laws] | None = None
        self._work = 0.0
        self._next_look = WORTHWHILE if mode == "auto" else float("inf")

    @property
    def compiled(self) -> bool:
        """Whether it runs machine code."""
        return self._kernels.compiled

    def advance(
        self, laws: Laws, rules: tuple[Rule, Rule], dt: float, ticks: int = 1
    ) -> list[Collision]:
        """Take so many ticks of `dt` seconds; return the collisions that happened in them.

        Args:
            laws: of the world.
            rules: what makes restitution and friction of a pair.
            dt: length of a tick (s).
            ticks: how many.

        Raises:
            Diverged: when a body left the range of numbers.
        """
        if self._kernels.compiled:
            return self._advance(laws, rules, dt, ticks)
        collisions: list[Collision] = []
        for done in range(0, ticks, AT_ONCE):
            part = min(AT_ONCE, ticks - done)
            collisions += self._advance(laws, rules, dt, part)
            self._consider_compiling(part)
        return collisions

    def _advance(
        self, laws: Laws, rules: tuple[Rule, Rule], dt: float, ticks: int
    ) -> list[Collision]:
        store = self._store
        progress, state = store.tables.progress, store.tables.state
        progress.phase[0] = WAITING
        progress.own_rules[0] = rules != (larger, geometric_mean)
        end = state.tick[0] + ticks
        status = self._bound(laws)(dt, ticks)
        collisions = self._reported()
        while status != DONE:
            if status == FULL:
                store.make_room_for_pairs(progress.wanted[0])
            elif status == UNMIXED:
                mix_by_rules(store.tables, *rules)
            elif status == LOOSE:
                store.order_joints()
            elif status == LOST:
                body = store.handles[progress.lost[0]]
                raise Diverged(f"{body.name} left the range of numbers in tick {state.tick[0]}")
            status = self._bound(laws)(dt, end - state.tick[0])
            collisions += self._reported()
        return collisions

    def _reported(self) -> list[Collision]:
        tables = self._store.tables
        if tables.impacts.written[0] == 0:
            return []
        tables.progress.told[0] = 0
        return collision.read(tables.impacts, self._store.handles)

    def _bound(self, laws: Laws) -> jit.Run:
        """The kernel, ready to work on the tables as they are."""
        tables = self._store.tables
        bound_to = self._bound_to
        if bound_to is None or bound_to[0] is not tables or bound_to[1] is not laws:
            self._bound_to = (tables, laws)
            self._run = self._kernels.bind(tables, laws)
        return self._run

    def _consider_compiling(self, ticks: int) -> None:
        """Change to machine code if this world goes on for long and it is ready."""
        counts = self._store.tables.counts
        self._work += ticks * (BODY * counts.bodies[0] + PAIR * counts.pairs[0])
        if self._work >= self._next_look:
            self._next_look = self._work + AGAIN
            ready = warming.background().kernels()
            if ready is not None:
                self._kernels, self._bound_to = ready, None
