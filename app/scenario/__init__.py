"""A scenario file becomes a Scenario for the player, or a list of mistakes with their places.

The way of a file: `reading` (bytes to a tree of nodes), `format` with `header`, `steps` and `kinds`
(nodes to values), `limits` and `paths` (the whole of it), all called by `load`; then `rehearse`
(do its taps find what they touch?).
"""
