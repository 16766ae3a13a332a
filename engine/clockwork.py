"""What drives a world: it runs the kernels tick by tick and does what only Python can do."""

import importlib

import numpy as np

from engine import collision, modes
from engine.collision import NONE, Collision, Collisions, Diverged
from engine.kernels.status import DONE, FULL, LOOSE, LOST, UNMIXED, WAITING
from engine.modes import Kernels
from engine.pair_rows import mix_by_rules
from engine.settings import PLAIN_RULES, Laws, Rules
from engine.store import Store
from engine.tables import RESTING, Tables

BODY, PAIR, CONTACT, JOINT = 15e-6, 40e-6, 200e-6, 500e-6
"""What an interpreted tick takes for each body, each pair, each pair that rests besides, and each
joint, roughly (s). An estimate, so that no clock has a say."""

WORTHWHILE = 2.0
"""Interpreted work (s) after which a world is taken for one that goes on for long."""

AGAIN = 0.2
"""Interpreted work (s) between two looks at whether machine code is ready."""

AT_ONCE = 30
"""Ticks between two looks at most."""


def compiled() -> Kernels:
    """The compiled kernels; worlds that start interpreted import nothing for them.

    Raises:
        ImportError: if numba is missing or broken.
    """
    kernels: Kernels = importlib.import_module("engine.jit").compiled()
    return kernels


def ready_in_background() -> Kernels | None:
    """The compiled kernels if they can be had at once; else let a process compile them."""
    kernels: Kernels | None = importlib.import_module("engine.warming").background().kernels()
    return kernels


class Clockwork:
    """Advances the tables of a store by the kernels of a mode (see `modes.resolve`)."""

    __slots__ = (
        "_at_once",
        "_counted",
        "_kernels",
        "_laws",
        "_next_look",
        "_rules",
        "_run",
        "_settled",
        "_store",
        "_tables",
        "_tick",
        "_work",
        "_written",
        "collisions",
        "mode",
    )

    def __init__(self, store: Store, mode: str) -> None:
        """Choose the kernels.

        Raises:
            ValueError: for an unknown mode.
            ImportError: if compiled kernels are asked for and numba is missing or broken.
        """
        self.mode = mode
        """As it was asked for."""
        mode = modes.resolve(mode)
        self._store = store
        self._tables: Tables | None = None
        self._laws: Laws | None = None
        self._rules: Rules | None = None
        self.collisions = 0
        """How many happened in the last `advance`."""
        self._work = 0.0
        self._counted = 0
        self._at_once = AT_ONCE
        self._next_look = WORTHWHILE
        self._settled = mode != "auto"
        self._use(compiled() if mode == "compiled" else modes.INTERPRETED)

    @property
    def compiled(self) -> bool:
        """Whether it runs machine code."""
        return self._kernels.compiled

    def tick(self, laws: Laws, rules: Rules, dt: float) -> Collisions:
        """Take one tick, as `advance` does, by the shortest way if its kernels are settled."""
        if (
            not self._settled
            or self._tables is not self._store.tables
            or self._laws is not laws
            or self._rules is not rules
        ):
            return Collisions(self.advance(laws, rules, dt))
        try:
            status = self._run(dt, 1)
            if status == DONE:
                return self._reported() if self._written[0] else NONE
            happened = list(self._reported())
            self._help(status, laws, rules)
        except BaseException:
            self._store.tables.progress.phase[0] = WAITING
            raise
        happened += self.advance(laws, rules, dt)
        return Collisions(happened)

    def advance(
        self, laws: Laws, rules: Rules, dt: float, ticks: int = 1, silent: bool = False
    ) -> list[Collision]:
        """Take so many ticks of `dt` seconds; return the collisions that happened in them.

        Args:
            laws: of the world.
            rules: what makes the coefficients of a pair.
            dt: length of a tick (s).
            ticks: how many.
            silent: whether to count the collisions only.

        Raises:
            Diverged: when a body left the range of numbers.
        """
        if (
            self._tables is not self._store.tables
            or self._laws is not laws
            or self._rules is not rules
        ):
            self._bind(laws, rules)
        self.collisions = 0
        collisions: list[Collision] = []
        end = self._tick[0] + ticks
        try:
            while True:
                left = end - self._tick[0]
                status = self._run(dt, left if left < self._at_once else self._at_once)
                if self._written[0]:
                    collisions += self._reported(silent)
                if status != DONE:
                    self._help(status, laws, rules)
                elif not self._settled:
                    self._consider_compiling(laws, rules)
                if self._tick[0] == end:
                    return collisions
        except BaseException:
            self._store.tables.progress.phase[0] = WAITING
            raise

    def _help(self, status: int, laws: Laws, rules: Rules) -> None:
        """Do what the kernel cannot, so that it can go on."""
        store = self._store
        progress = store.tables.progress
        if status == FULL:
            store.make_room_for_pairs(progress.wanted[0])
        elif status == UNMIXED:
            with store.asked():
                mix_by_rules(store.tables, *rules)
        elif status == LOOSE:
            store.order_joints()
        elif status == LOST:
            body = store.handles[progress.lost[0]]
            tick = self._tick[0] + 1  # the first is 1, as for `Divergence`
            raise Diverged(f"{body.name} left the range of numbers in tick {tick}")
        if self._tables is not store.tables:
            self._bind(laws, rules)

    def _bind(self, laws: Laws, rules: Rules) -> None:
        """Make the kernel ready to work on the tables as they are."""
        tables = self._store.tables
        self._tables, self._laws, self._rules = tables, laws, rules
        self._run = self._kernels.bind(tables, laws)
        self._tick, self._written = tables.state.tick, tables.impacts.written
        tables.progress.own_rules[0] = rules != PLAIN_RULES

    def _reported(self, silent: bool = False) -> Collisions:
        """Empty the table of impacts."""
        tables = self._store.tables
        tables.progress.told[0] = 0
        self.collisions += self._written[0]
        if silent:
            self._written[0] = 0
            return NONE
        return collision.read(tables.impacts, self._store.handles)

    def _consider_compiling(self, laws: Laws, rules: Rules) -> None:
        """Change to machine code if this world goes on for long and it is ready."""
        t, tick = self._store.tables, self._tick[0]
        ticks = tick - self._counted
        self._counted = tick
        pairs = t.counts.pairs[0]
        resting = int(np.count_nonzero(np.asarray(t.pairs.state)[:pairs] == RESTING))
        work = BODY * t.counts.bodies[0] + PAIR * pairs
        self._work += ticks * (work + CONTACT * resting + JOINT * t.counts.joints[0])
        if self._work >= self._next_look:
            self._next_look = self._work + AGAIN
            ready = ready_in_background()
            if ready is not None:
                self._use(ready)
                self._bind(laws, rules)

    def _use(self, kernels: Kernels) -> None:
        self._kernels = kernels
        if kernels.compiled:
            self._at_once, self._settled = 2**62, True
