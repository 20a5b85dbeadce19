"""Steps of two lengths: exact at the cut, of the order of the pair, and true to one length."""

import numpy as np
import pytest
from chains import TIGHT, driven_scene, given
from rings import slope_and_residual

from granular_fronts.chain.recording import collect
from granular_fronts.chain.run import integrate, integrate_in_halves, prepare
from granular_fronts.chain.simulate import simulate_chain, solve
from granular_fronts.chain.state import D, U
from granular_fronts.chain.two_rates import FEWEST_BEADS, WIDTH, takes_two_rates
from granular_fronts.numerics.runge_kutta import STAGES

USUAL = {"relative": 1.0e-9, "absolute": 1.0e-11}
CUT = FEWEST_BEADS - WIDTH


def long_scene(gamma=0.06, end_time=2200.0, **changes):
    """A front that passes some thousand beads, in a chain that takes steps of two lengths."""
    record = {"snapshots": [0.7 * end_time, end_time], "arrival_level": 0.05}
    scene = driven_scene(gamma, FEWEST_BEADS, end_time, tolerance=USUAL, record=record)
    return scene | changes


def smooth_scene():
    """A compressed chain that carries a wave of ten beads everywhere, also across the cut."""
    n = np.arange(FEWEST_BEADS)
    u, velocity = 1.0 + 0.3 * np.cos(np.pi * n[:-1] / 5.0), 0.2 * np.sin(np.pi * n / 5.0)
    start, record = given(u, velocity), {"snapshots": [4.0]}
    held = {"kind": "pressure", "left": 1.3, "right": 1.0}
    return long_scene(0.1, 4.0, start=start, record=record, boundary=held)


def follow(scene, ends, overlap=STAGES):
    """u and d of all beads after two steps for each of the given ones, of one length or two."""
    run = prepare(scene)
    behind = run.behind._replace(overlap=overlap) if len(ends) == 2 else None
    run = run._replace(behind=behind)
    integrate_in_halves(run, [np.asarray(times) for times in ends])
    return np.array([run.row(U), run.row(D)])


# Their halves end together at 4 alone.
SHORT, LONG = [1.5, 4.0], [4.0]


def by_one_length_each(scene):
    """What two lengths make of a chain, by two chains that take steps of one length."""
    short, long = follow(scene, [SHORT]), follow(scene, [LONG])
    return np.concatenate([long[:, :CUT], short[:, CUT:]], axis=1)


def test_each_bead_is_the_same_to_the_bit_as_if_all_took_its_steps():
    scene = smooth_scene()
    both, short = follow(scene, [SHORT, LONG]), follow(scene, [SHORT])
    np.testing.assert_array_equal(both, by_one_length_each(scene))
    assert np.abs(both - short)[:, :CUT].max() > 1.0e-6, "the lengths must differ in effect"


@pytest.mark.parametrize("overlap", [2, 6])
def test_an_overlap_too_short_is_noticed(overlap):
    scene = smooth_scene()
    spoilt = follow(scene, [SHORT, LONG], overlap)
    assert np.abs(spoilt - by_one_length_each(scene)).max() > 1.0e-14


def test_a_run_goes_on_after_a_long_step_as_if_it_had_not_been_left():
    """A step that all beads take follows; it needs slopes that long steps do not leave behind."""
    scene = smooth_scene()
    ends = [np.array([*times, 4.5]) for times in (SHORT, LONG)]
    states = []
    for parts in ([[4.0, 4.5]], [[4.0], [4.5]]):
        run = prepare(scene)
        for stops in parts:
            run.recording.next.stop = 0
            recording = run.recording._replace(stops=np.array(stops))
            integrate_in_halves(run._replace(recording=recording), ends)
        states.append(np.array([run.row(U), run.row(D)]))
    np.testing.assert_array_equal(*states)


def test_the_order_is_that_of_the_pair_across_the_cut():
    scene = smooth_scene()
    near = np.s_[:, CUT - 40 : CUT + 40]
    exact = follow(scene, [np.linspace(0.0, 4.0, 81)[1:]])[near]
    counts, errors = [4, 5, 6, 7, 8], []
    for count in counts:
        short, long = (np.linspace(0.0, 4.0, k * count + 1)[1:] for k in (3, 1))
        # Common times agree to the last bit.
        short[2::3] = long
        errors.append(np.abs(follow(scene, [short, long])[near] - exact).max())
    slope, scatter = slope_and_residual(counts, errors)
    assert 7.9 < slope < 8.6, errors
    assert scatter < 0.02
    assert errors[-1] > 1.0e-12, "the errors must stand above round-off"


CHAINS = {
    "underdamped": {},
    "overdamped": {"gamma": 0.3},
    "two functions": {"law": {"alpha": 1.5, "beta": 1.0, "gamma": 0.1}},
    "undamped": {"gamma": 0.0, "end_time": 1700.0},
    "pushed": {"boundary": {"kind": "piston", "velocity": 0.05, "ramp": 20.0, "right": 0.0}},
    "pressed more and more": {
        "boundary": {
            "kind": "force",
            "force": {"table": {"times": [0, 1500, 1800], "values": [0.03, 0.03, 0.05]}},
            "right": 0.0,
        }
    },
    "unlike beads": {
        "beads": {"count": FEWEST_BEADS, "mass": {"cell": [1.0, 0.9]}},
        "contacts": {"elastic": {"cell": [1.0, 1.1, 1.0]}},
    },
}


@pytest.mark.parametrize("chain", CHAINS)
def test_two_lengths_are_true_within_their_stated_errors(chain):
    scene = long_scene(**CHAINS[chain])
    motion = simulate_chain(scene)
    tight = prepare(scene)._replace(behind=None)
    integrate(tight, TIGHT)
    exact = collect(scene, tight)
    for name in ("relative_displacement", "velocity", "arrival_time"):
        error = np.nanmax(np.abs(motion[name].values - exact.values(name)))
        assert error < 2.0 * motion[name].attrs["error_estimate"], name


def test_contacts_that_open_behind_a_front_have_steps_of_their_own():
    """A hammer of beads rebounds from the left end, which is free, and flies apart."""
    start = {"kind": "striker", "beads": 60, "velocity": 0.1}
    free = {"kind": "pressure", "left": 0.0, "right": 0.0}
    scene = long_scene(0.05, start=start, boundary=free)
    scene["record"]["arrival_level"] = 1.0e-3
    motion = simulate_chain(scene)
    assert motion["relative_displacement"].min() < -1.0, "beads must have flown apart"
    tight = prepare(scene)._replace(behind=None)
    integrate(tight, TIGHT)
    error = np.abs(motion["velocity"].values - collect(scene, tight).values("velocity")).max()
    assert error < 2.0 * motion["velocity"].attrs["error_estimate"]


@pytest.mark.parametrize("gamma", [0.06, 0.3])
def test_steps_behind_a_damped_front_are_fewer(gamma):
    counts = solve(long_scene(gamma), USUAL).counts
    before = solve(long_scene(gamma, 1700.0), USUAL).counts
    behind, front = (counts[name] - before[name] for name in ("steps_behind", "steps_accepted"))
    assert 5 * behind < front


def test_momentum_is_kept_to_rounding_by_one_length_and_to_the_tolerance_by_two():
    scene = long_scene()
    assert solve(scene, USUAL).drifts["momentum_drift"] < USUAL["relative"]
    scene["record"]["balances"] = True
    assert solve(scene, USUAL).drifts["momentum_drift"] < 1.0e-13
    assert solve(scene, USUAL).drifts["energy_drift"] < USUAL["relative"]


@pytest.mark.parametrize(
    ("place", "change"),
    [
        ("record", {"grid": {"step": 1.0}}),
        ("record", {"probes": {"first": {"beads": [1], "start": 0, "stop": 9, "step": 1}}}),
        ("record", {"sensors": {"one": {"contacts": [1], "start": 0, "stop": 9, "step": 1}}}),
        ("record", {"extremes": True}),
        ("record", {"balances": True}),
        ("boundary", {"kind": "ring"}),
        ("contacts", {"alpha": {"impurity": {"contact": 5, "exponent": 2.0}}}),
    ],
)
def test_one_length_serves_what_two_cannot(place, change):
    scene = long_scene(contacts={})
    assert takes_two_rates(scene)
    scene[place] |= change
    assert not takes_two_rates(scene)


def test_short_chains_take_one_length():
    assert not takes_two_rates(long_scene(beads=FEWEST_BEADS - 1))


def test_the_start_is_recorded_as_it_is_given():
    scene = smooth_scene() | {"record": {"snapshots": [0.0, 0.05]}}
    assert takes_two_rates(scene)
    first = solve(scene, USUAL).dataset["relative_displacement"].sel(t=0.0).values[:-1]
    np.testing.assert_array_equal(first, scene["start"]["relative_displacement"])
