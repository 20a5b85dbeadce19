"""Configurations that tests change, and the sentences that refuse them."""

import copy
import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
DEFAULT = ROOT / "config" / "default.yaml"
SMOKE = ROOT / "config" / "smoke.yaml"
SCENE = "initiation_underdamped"


def change(configuration, family="chain", scene=SCENE, **changes):
    """Set `record__grid__step=…` in the scene; an ellipsis takes the key away."""
    changed = copy.deepcopy(configuration)
    for path, value in changes.items():
        *parents, last = path.split("__")
        node = changed["scenes"][family][scene]
        for parent in parents:
            node = node[parent]
        if value is ...:
            del node[last]
        else:
            node[last] = value
    return changed


def assert_refused(sentences, words):
    """A sentence for each fault, a line each: keys, values, limits (between bars), the way out."""
    for sentence, named in zip(sentences.splitlines(), words.splitlines(), strict=True):
        assert re.fullmatch(r".+: .+[.?]", sentence)
        for word in named.split(" | "):
            assert word in sentence
