"""Where two bodies touch: one file per pair of forms, all normals from a to b.

Round bodies are one point, walls two, polygons three and more; walls are hulls with two sides, so
that three files serve every pair of shapes.
"""
