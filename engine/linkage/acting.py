"""Which trees of hinges take part in the present part of a tick: all loops over them ask here."""

from engine.linkage.limb_sweeps import find_even
from engine.linkage.limbs import find_runs
from engine.tables import Tables


def list_acting(t: Tables, waits: int) -> None:
    """Let those trees act whose bodies wait as said (see `Bodies.waits`), and no others."""
    bones = t.bones
    acting = bones.acting
    if bones.sizes[3] == 0:
        return
    listed = 0
    for bone in range(bones.sizes[0]):
        if t.bodies.waits[bones.body[bone]] == waits:
            acting[listed] = bone
            listed += 1
    bones.sizes[8] = listed
    find_runs(t)
    for bone in range(bones.sizes[0], bones.sizes[1]):
        if t.bodies.waits[bones.body[bone]] == waits:
            acting[listed] = bone
            listed += 1
    bones.sizes[9] = listed
    for bone in range(bones.sizes[1], bones.sizes[2]):
        acting[listed] = bone
        listed += 1
    bones.sizes[11] = listed
    listed = 0
    for tree in range(bones.sizes[3]):
        body = bones.body[t.limbs.member[t.trees.first[tree]]]
        if t.bodies.waits[body] == waits:
            t.trees.acting[listed] = tree
            listed += 1
    bones.sizes[10] = listed
    find_even(t)
