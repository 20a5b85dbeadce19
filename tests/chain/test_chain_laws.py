"""One engine for every law: windows, kinks, a user's functions, vector code."""

import numba
import numpy as np
import pytest
from chains import TIGHT, driven_scene, given, last_state, ring_scene, smooth_ring
from kernels import fastest
from potentials import cosh

import granular_fronts as gf
from granular_fronts.chain import run as chain_run
from granular_fronts.chain.run import compile_law, integrate, prepare
from granular_fronts.chain.simulate import solve
from granular_fronts.chain.stage_passes import call_stage_pass, stage_pass, sum_rows
from granular_fronts.chain.state import ELASTIC_SLOPES, ROWS_OF_PAIR, VALUE, D, U, make_table
from granular_fronts.errors import InputError, SolveError
from granular_fronts.model.passes import row_parameters
from granular_fronts.numerics.runge_kutta import LONG

FASTEST_SCALAR_CODE = 3.0
"""Over the time of a vectorised square root; a stage takes 1.0 to 1.7 times as long with a root,
and two to three times as long in code for one number after the other."""

HERTZ = {"alpha": 1.5, "beta": 1.5, "gamma": 0.06}
TWO_POWERS = {"alpha": 1.5, "beta": 1.0, "gamma": 0.2}
TODA = {"elastic": {"kind": "toda", "strength": 0.7, "rate": 1.3}}


def pulse(law, held=0.3, **changes):
    """A compressed pulse with a moving end, precompressed on both sides."""
    n = np.arange(40)
    start = given(held + 0.4 * np.exp(-((n[:-1] / 3.0) ** 2)), 0.1 * np.cos(n))
    boundary = {"kind": "pressure", "left": held + 0.2, "right": held}
    scene = driven_scene(beads=40, end_time=12.0, start=start, boundary=boundary)
    return scene | {"law": law} | changes


@pytest.mark.parametrize("right", [0.0, 0.2])
@pytest.mark.parametrize("law", [HERTZ, TWO_POWERS, TODA])
def test_contacts_ahead_of_the_wave_need_no_visit(law, right, monkeypatch):
    """The same steps, states and arrivals where the window is the whole chain."""
    scene = driven_scene(
        beads=120,
        end_time=25.0,
        start=given([right] * 119, [0.0] * 120),
        law=law,
        boundary={"kind": "pressure", "left": 0.6, "right": right},
        record={"snapshots": [25.0], "arrival_level": 0.4},
        tolerance={"relative": 1e-9, "absolute": 1e-11},
    )
    windowed = solve(scene)
    assert prepare(scene).clock.reach < 40
    monkeypatch.setattr(chain_run, "end_of_window", lambda chain, table, start: chain.beads)
    whole = solve(scene)
    assert windowed.counts == whole.counts
    for name in whole.dataset:
        np.testing.assert_allclose(windowed.dataset[name], whole.dataset[name], rtol=0, atol=5e-16)


def hardening(kinks):
    """V'' jumps from 1 to 9 where a contact is compressed by 0.5."""
    elastic = gf.Potential(
        lambda r: 0.5 * r * r + 4.0 * np.minimum(r + 0.5, 0.0) ** 2,
        lambda r: r + 8.0 * np.minimum(r + 0.5, 0.0),
        lambda r: np.where(r < -0.5, 9.0, 1.0),
        interval=(-3.0, 3.0),
        kinks=kinks,
    )
    return gf.make_law(elastic=elastic, viscous={"kind": "proportional", "gamma": 0.1})


def test_declared_kinks_are_located():
    """The error follows the tolerance; of steps that are blind to the kink it does not."""
    worst, cuts = {}, {}
    exact = last_state(pulse(hardening((-0.5,)), 0.35, end_time=20.0))
    for kinks in ((), (-0.5,)):
        scene, ratios = pulse(hardening(kinks), 0.35, end_time=20.0), []
        for relative in (1e-7, 1e-9):
            tolerance = {"relative": relative, "absolute": 1.0e-2 * relative}
            found = last_state(scene | {"tolerance": tolerance})
            ratios.append(np.abs(found - exact).max() / relative)
        worst[kinks] = max(ratios)
        cuts[kinks] = solve(scene, TIGHT).counts["steps_cut_at_contacts"]
    assert cuts[()] == 0
    assert cuts[(-0.5,)] > 0
    assert worst[(-0.5,)] < 0.3
    assert worst[()] > 5.0 * worst[(-0.5,)]


def test_nothing_is_written_beyond_the_chain():
    """The row ends behind entry N + 1."""
    for beads in (37, 38):
        scene = driven_scene(0.1, beads, 60.0, record={"snapshots": [60.0], "balances": True})
        run = prepare(scene)
        run.table[:, beads + 2 :] = 12345.0
        integrate(run, {"relative": 1e-8, "absolute": 1e-10})
        assert (run.table[:, beads + 2 :] == 12345.0).all()


@numba.njit
def roots(u, result, times):
    for _ in range(times):
        for n in range(numba.uint64(u.size)):
            result[n] = u[n] * np.sqrt(u[n])


@numba.njit
def passes(address, table, terms, last, weights, parameters, times):
    for _ in range(times):
        call_stage_pass(address, table, (ELASTIC_SLOPES, terms), last, 0.1, weights, parameters)


@numba.njit
def sums(table, terms, last, weights, times):
    for _ in range(times):
        sum_rows(table, VALUE, U, D, 0.1, (ELASTIC_SLOPES, terms), weights, last)


def test_a_users_functions_are_as_good_as_a_name_and_no_run_mixes_two_laws():
    """A constant of the functions is changed between two potentials and during the second."""
    functions = (
        lambda r: 0.7 / rate * (np.exp(-rate * r) - 1.0 + rate * r),
        lambda r: 0.7 * (1.0 - np.exp(-rate * r)),
        lambda r: 0.7 * rate * np.exp(-rate * r),
    )

    def final(elastic):
        viscous = {"kind": "linear", "gamma": 0.3}
        return last_state(pulse(gf.make_law(elastic=elastic, viscous=viscous)))

    for rate in (1.3, 2.6):
        mine = gf.Potential(*functions, interval=(-3.0, 3.0))
        named = final({"kind": "toda", "strength": 0.7, "rate": rate})
        np.testing.assert_allclose(final(mine), named, rtol=0, atol=2e-13)
    rate = 1.3
    with pytest.raises(InputError, match="in compiled code"):
        final(mine)


def test_a_record_has_room_for_eight_kinks():
    def law(count):
        kinks, functions = tuple(np.linspace(-1, 1, count)), (np.cosh, np.sinh, np.cosh)
        return gf.make_law(elastic=gf.Potential(*functions, interval=(-3, 3), kinks=kinks))

    assert compile_law(law(8), None).kink_count == 8
    with pytest.raises(InputError, match="has 9 kinks, but a chain has room for 8"):
        compile_law(law(9), None)


COMPRESSIONS, VELOCITIES = smooth_ring()
# After a flight of duration 10⁶ the beads collide faster than double precision resolves t.
FAR = {"start": given([-1.0e55], [1.0e49, 0.0]), "end_time": 2.0e6}
FAR |= {"tolerance": {"relative": 1e-9, "absolute": 1e35}}
FAST = [{"start": given([0.0], [v, -v]), "law": {"elastic": cosh()}} for v in (10.0, -10.0)]
LEAVES = r"strain of contact 1 leaves the interval from -3 to 3"


@pytest.mark.parametrize(
    ("scene", "sentence"),
    [
        (
            ring_scene(COMPRESSIONS, 20.0 * VELOCITIES, alpha=0.7, beta=1.0),
            r"scene one.*At t = .* contact of beads \d+ and \d+ opens.*alpha < 1",
        ),
        *[(driven_scene(beads=2, delta=0.0, **one), LEAVES) for one in FAST],
        (driven_scene(beads=2, delta=0.0, **FAR), r"At t = 1e\+06 the step size.*bead 1"),
    ],
)
def test_a_solve_that_cannot_go_on_says_when_where_and_why(scene, sentence):
    with pytest.raises(SolveError, match=sentence):
        gf.simulate_chain(scene, "one")


# It measures processor time, and wants the machine for itself.
@pytest.mark.nightly
@pytest.mark.parametrize("terms", [5, 10])
def test_inner_loops_are_vector_code(terms):
    beads, rng = 4000, np.random.default_rng(0)
    table = make_table(ROWS_OF_PAIR, beads)
    table[:] = rng.uniform(0.5, 1.0, table.shape)
    u, result, weights = table[U].copy(), np.zeros_like(table[U]), rng.uniform(0, 1, LONG)
    root = fastest(lambda: roots(u, result, 400), 7)
    hertz = gf.make_law(alpha=1.5).elastic
    parameters, address = row_parameters(hertz, 1), stage_pass(hertz)
    fused = fastest(lambda: passes(address, table, terms, beads, weights, parameters, 400), 7)
    summed = fastest(lambda: sums(table, terms, beads, weights, 400), 7)
    assert fused < FASTEST_SCALAR_CODE * root
    assert summed < FASTEST_SCALAR_CODE * root
