"""The table in which resting contacts of a crowd are packed; see `kernels.crowds`."""

from typing import NamedTuple

from engine.tables.columns import Floats, Ints

LANES = 8
"""Rows of a block, which are solved side by side."""


class Lanes(NamedTuple):
    """One row a resting pair as sweeps need it, `LANES` rows a block; no two pairs of a block move
    the same body. The two points of a pair are 0 and 1; one that is missing bears nothing.

    Most columns are those of `Pairs`, `Contacts` and `Bodies` of the same names.
    """

    filled: Ints
    """By blocks (not by row): how many of its rows are in use, the first ones."""
    points: Ints
    """By blocks: how many points its pairs may have, 1 or 2."""
    sizes: Ints
    """First rows: number of blocks; of pairs that are not packed; 1 while a crowd is packed; of
    `listed`, 0 if there are others than those."""
    listed: Ints
    """Pairs that were packed, as they were listed (not by row)."""
    pair: Ints
    """Row of `Pairs`."""
    a: Ints
    """Rows of `Bodies`."""
    b: Ints
    normal_x: Floats
    normal_y: Floats
    mass_a: Floats
    """Inverse masses and moments of inertia of the two bodies."""
    mass_b: Floats
    turn_a: Floats
    turn_b: Floats
    size: Floats
    static_friction: Floats
    belt_speed: Floats
    normal_arm_a_0: Floats
    normal_arm_b_0: Floats
    tangent_arm_a_0: Floats
    tangent_arm_b_0: Floats
    normal_arm_a_1: Floats
    normal_arm_b_1: Floats
    tangent_arm_a_1: Floats
    tangent_arm_b_1: Floats
    tangent_mass_0: Floats
    tangent_mass_1: Floats
    target_0: Floats
    target_1: Floats
    hardness_0: Floats
    hardness_1: Floats
    softness_0: Floats
    softness_1: Floats
    normal_impulse_0: Floats
    normal_impulse_1: Floats
    tangent_impulse_0: Floats
    tangent_impulse_1: Floats
    vx_a: Floats
    """Velocities of the bodies of the block in hand (m/s, rad/s), and how far the changes in this
    sweep were beyond what is calm, at most (N s): the first `LANES` rows."""
    vy_a: Floats
    spin_a: Floats
    vx_b: Floats
    vy_b: Floats
    spin_b: Floats
    excess: Floats
