"""A part of a tick in which nothing but hinges of trees acts: they change velocities directly."""

from engine.linkage.limb_guesses import keep_limb_impulses
from engine.linkage.limb_motion import bind_limbs, brace_limbs
from engine.linkage.limb_velocities import ease_limbs, keep_limb_ends, prepare_limbs
from engine.tables import Tables


def swing(t: Tables, count: int, part: float) -> None:
    """Let hinges jolt bodies as a part (s) begins; then forces alone bend their paths."""
    bodies = t.bodies
    for row in range(count):
        if bodies.held[row] > 0:
            bodies.path_x[row] = bodies.ax[row]
            bodies.path_y[row] = bodies.ay[row]
            bodies.path_spin[row] = bodies.aspin[row]
    t.lanes.sizes[2] = 0
    t.state.restless[0] = 0
    brace_limbs(t, part)
    bind_limbs(t, part)
    keep_limb_impulses(t, part)


def obey(t: Tables, part: float, done: float) -> None:
    """Let velocities obey the hinges at the end of a part (s), of which the share `done` passed."""
    prepare_limbs(t)
    ease_limbs(t, True)
    keep_limb_ends(t, part, done, False)
