"""For all tests: what they find may not depend on how busy the machine is."""

import os

from hypothesis import settings

settings.register_profile("laws", deadline=None)
settings.load_profile("laws")

# Tests that are about compiled kernels ask for them; no other starts a compiler.
os.environ.setdefault("LAWS_KERNELS", "interpreted")
