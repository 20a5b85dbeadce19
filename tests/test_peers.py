"""The peers of the speed comparison agree with each other, and an absent one says so."""

import numpy as np
import pytest
from measure_precision import largest_error
from peers import chain as peers

SHORT = peers.ChainScene(gamma=0.3, beads=20, end=12.0)


@pytest.mark.parametrize("name", peers.PEERS)
def test_every_present_peer_finds_the_same_motion(name):
    run = peers.PEERS[name](SHORT, 1e-11, 1e-13)
    if not run.u.size:
        pytest.skip(run.message)
    expected = peers.run_scipy_dop853(SHORT, 1e-13, 1e-15)
    assert largest_error(run, expected.u, expected.velocity) < 1e-9
    assert run.velocity.sum() == pytest.approx(SHORT.pressure * SHORT.end, rel=1e-9)
    assert run.u.size == SHORT.beads
    assert run.u[-1] == 0.0
    assert run.seconds > 0
    assert run.right_hand_sides > 0


def test_an_absent_peer_says_so(monkeypatch):
    monkeypatch.setattr(peers.shutil, "which", lambda name: None)
    run = peers.run_scilab(SHORT, 1e-8, 1e-10)
    assert not run.u.size
    assert "scilab-cli" in run.message
    assert np.isnan(largest_error(run, 0.0, 0.0))


def test_an_absent_package_says_so(monkeypatch):
    monkeypatch.setattr(peers.importlib.util, "find_spec", lambda name: None)
    for run in (peers.run_numbalsoda_dop853, peers.run_scipy_odeint):
        assert "not installed" in run(SHORT, 1e-8, 1e-10).message
