"""Files of compiled kernels that say themselves whether they are whole.

Numba takes whatever lies in its cache for machine code.  Here each file ends with a digest of its
contents, and a kernel whose file is damaged is compiled again.
"""

import hashlib
import pickle
from contextlib import contextmanager
from pathlib import Path

from numba.core import caching

DIGEST_SIZE = hashlib.sha256().digest_size


class CheckedFiles(caching.IndexDataCacheFile):
    """The index and the data files of a kernel; what follows the pickled object is its digest."""

    def _dump(self, obj):
        content = super()._dump(obj)
        return content + hashlib.sha256(content).digest()

    def _load_index(self):
        return super()._load_index() if self._is_whole(self._index_path) else {}

    def _load_data(self, name):
        if not self._is_whole(self._data_path(name)):
            raise OSError(f"{name} is damaged")  # Numba then compiles.
        return super()._load_data(name)

    def _is_whole(self, path):
        try:
            content = Path(path).read_bytes()
        except FileNotFoundError:
            return False
        # In an index the version of numba stands before what is dumped.
        content = content.removeprefix(pickle.dumps(self._version, protocol=-1))
        return hashlib.sha256(content[:-DIGEST_SIZE]).digest() == content[-DIGEST_SIZE:]

    @contextmanager
    def _open_for_write(self, filepath):
        try:
            with super()._open_for_write(filepath) as file:
                yield file
        except OSError as error:
            error.filename = filepath  # A write to a full disk names no file.
            raise


def check_kernel_files() -> None:
    """Let numba keep all kernels of this process in such files."""
    caching.IndexDataCacheFile = CheckedFiles
