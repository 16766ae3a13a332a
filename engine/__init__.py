"""A standalone 2D rigid-body engine: SI units, float64, +y up, angles counter-clockwise."""
