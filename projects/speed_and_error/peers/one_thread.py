"""Keeps every numerical library to one thread; to be imported before any of them."""

import os

_LIMITS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS")
os.environ.update(dict.fromkeys(_LIMITS, "1"), XLA_FLAGS="--xla_cpu_multi_thread_eigen=false")
