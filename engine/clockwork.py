"""What drives a world: it runs the kernels tick by tick and does what only Python can do."""

from engine import collision, jit
from engine.collision import Collision, Diverged
from engine.pair_rows import mix_by_rules
from engine.settings import Laws, Rule, geometric_mean, larger
from engine.store import Store
from engine.tables import Tables
from engine.tick import FULL, LOST, UNMIXED, WAITING
from engine.travel import DONE


class Clockwork:
    """Advances the tables of a store by the kernels of a mode (see `jit.choose`)."""

    __slots__ = ("_bound_to", "_kernels", "_run", "_store")

    def __init__(self, store: Store, mode: str) -> None:
        """Choose the kernels.

        Raises:
            ValueError, ImportError: see `jit.choose`.
        """
        self._store = store
        self._kernels = jit.choose(mode)
        self._bound_to: tuple[Tables, Laws] | None = None
        self._run: jit.Run = self._kernels.bind(store.tables, Laws(0.0, 0.0, 0.0, 0.0, 0, 1))

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
