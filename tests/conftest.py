"""For all tests: what they find may not depend on how busy the machine is."""

import os
import signal

from hypothesis import settings

settings.register_profile("laws", deadline=None)
settings.load_profile("laws")

# Tests that are about compiled kernels ask for them; no other starts a compiler.
os.environ.setdefault("LAWS_KERNELS", "interpreted")

# Who starts the tests in the background may have told them to ignore Ctrl-C, and so their children.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
