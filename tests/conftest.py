"""What every test may count on."""

from __future__ import annotations

import os
import signal

from hypothesis import settings

from esg.paths import kernel_cache_dir

# A first call imports and compiles, and a busy machine is no failure.
settings.register_profile("no deadline", deadline=None)
settings.load_profile("no deadline")

# Kernels take minutes to compile: a test with a cache folder of its own uses the machine's.
os.environ.setdefault("WARP_CACHE_PATH", str(kernel_cache_dir().parent))

# A job that a shell starts in the background ignores Ctrl-C, and so would its children.
if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
    signal.signal(signal.SIGINT, signal.default_int_handler)
