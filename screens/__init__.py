"""The three lessons: Inertia, Forces, Reactions, and the kit they are drawn with."""
