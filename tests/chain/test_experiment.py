"""Pulses of series: closed forms, orders of sampling, and known waves."""

import numpy as np
import pytest
import xarray as xr
from chains import FREE, STRIKER, driven_scene

import granular_fronts as gf
from granular_fronts.chain.experiment import time_of_flight
from granular_fronts.errors import InputError
from granular_fronts.fronts.solitary_waves import solitary_wave

WIDTH = 2.0 * np.sqrt(np.log(2.0))


def series_of(values, times, error=0.0):
    """A series at several places, the columns of its values."""
    coordinates = {"t": times, "contact": np.arange(values.shape[1])}
    return xr.DataArray(values, coordinates, ("t", "contact"), attrs={"error_estimate": error})


def sampled(function, step, error=0.0):
    """A series of a function of time."""
    times = np.arange(0.0, 20.0 + 0.5 * step, step)
    return series_of(function(times)[:, None], times, error)


def two_pulses(t, later=0.0):
    """Gaussians of height 1 and 0.7 at 6.03 and 14.07, or later, on a base of 0.2."""
    return 0.2 + np.exp(-((t - 6.03) ** 2)) + 0.7 * np.exp(-((t - 14.07 - later) ** 2))


TRUE = {"peak": [1.2, 0.9], "width": [WIDTH, WIDTH]}
TRUE["arrival"] = [6.03 - 0.5 * WIDTH, 14.07 - 0.5 * WIDTH]


def test_pulses_have_the_order_of_the_spline_and_honest_errors():
    """A spline of degree 5 has the order 6."""
    errors = []
    for step in (0.2, 0.1, 0.05):
        found = gf.pulses(sampled(two_pulses, step))
        assert found.sizes == {"pulse": 2, "contact": 1}
        wrong = [np.abs(found[name][:, 0] - true).max().item() for name, true in TRUE.items()]
        assert (np.array(wrong) <= [found[f"{name}_error"].max() for name in TRUE]).all()
        errors.append(wrong)
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert (orders > 5.0).all()


@pytest.mark.parametrize("seed", range(5))
def test_error_of_the_series_is_in_that_of_its_pulses(seed):
    """A smooth disturbance as large as the error moves no pulse by more than is stated."""
    size, phase = 1e-4, np.random.default_rng(seed).uniform(0.0, 2.0 * np.pi)
    found = gf.pulses(
        sampled(lambda t: two_pulses(t) + size * np.sin(2.0 * t + phase), 0.05, error=size)
    )
    for name, true in TRUE.items():
        wrong, stated = np.abs(found[name][:, 0] - true), found[f"{name}_error"][:, 0]
        assert (wrong <= stated).all()
        assert wrong.max() > 0.01 * stated.max()


def test_time_of_flight_is_that_of_the_first_pulse():
    t = np.arange(0.0, 20.0, 0.05)
    values = np.stack([two_pulses(t), two_pulses(t - 1.5, later=1.0)], axis=1)
    flight = time_of_flight(series_of(values, t), 0, 1)
    assert abs(flight.value - 1.5) <= flight.error < 1e-6
    arrivals = gf.pulses(series_of(values, t))["arrival"].sel(pulse=[1, 2])
    np.testing.assert_allclose(arrivals.diff("contact"), [[1.5], [2.5]], atol=1e-6)


def test_a_passage_that_every_other_sample_does_not_reach_is_uncertain():
    t = np.arange(386) * 0.05
    found = gf.pulses(series_of(np.exp(-((t[:, None] - 18.4) ** 2)), t))
    assert found["width"].item() == pytest.approx(WIDTH, abs=1e-6)
    assert found["width_error"].item() == np.inf


def test_a_dip_next_to_a_peak_is_not_taken_for_it():
    values = np.zeros((40, 1))
    values[16:23, 0] = 0.3, 0.6, 1.0, 0.0, 0.9, 0.3, 0.1
    first, second = gf.pulses(series_of(values, np.arange(40.0)))["peak"].values[:, 0]
    assert first > 1.0
    assert second > 0.9


def test_small_bumps_and_noise_are_no_pulses_and_a_front_has_no_width():
    """By default a pulse rises by a tenth of the largest deviation, and always above the error."""

    def front(height):
        def value(t):
            return 5.5 + 0.5 * np.tanh(t - 5.0) + height * np.exp(-((t - 10.0) ** 2))

        return sampled(value, 0.05)

    found = gf.pulses(front(0.05), prominence=0.01)
    assert found["peak"].item() == pytest.approx(6.05, abs=1e-4)
    assert found["width"].isnull().all()
    for none in (
        gf.pulses(front(0.09)),
        gf.pulses(sampled(np.zeros_like, 0.05)),
        gf.pulses(sampled(lambda t: 1e-3 * np.sin(t), 0.05, error=1e-3)),
    ):
        assert none["peak"].isnull().all()
    assert gf.pulses(front(0.13))["peak"].notnull().all()


def struck(velocity=1.0, gamma=0.0, relative=1e-10, beads=40, end=45.0):
    """A striker on equal Hertz beads, felt at every fourth contact."""
    sensor = {"contacts": list(range(12, 33, 4)), "beads": [20]}
    scale = velocity**-0.2
    sensor |= {"start": 0.0, "stop": end * scale, "step": 0.05 * scale}
    record = {"snapshots": [], "sensors": {"far": sensor}}
    scene = driven_scene(gamma, beads, end * scale, boundary=FREE, record=record)
    tolerance = {"relative": relative, "absolute": 1e-2 * relative * velocity}
    return scene | {"start": STRIKER | {"velocity": velocity}, "tolerance": tolerance}


def test_pulse_of_a_striker_is_the_solitary_wave_whatever_its_force():
    """Its length is that of the wave from its own equation, and its speed grows as force^(1/6)."""
    wave = solitary_wave(1.5)
    force = xr.DataArray(
        np.maximum(wave.u, 0.0) ** 1.5, {"xi": wave.xi}, ("xi",), attrs={"error_estimate": 1e-12}
    )
    exact = gf.pulses(force).squeeze()
    lengths, speeds = [], []
    for velocity in (0.01, 1.0):
        series = gf.simulate_chain(struck(velocity))["contact_force_far"]
        speeds.append(12.0 / time_of_flight(series, 20, 32).value)
        measured = gf.pulses(series).isel(pulse=0, contact_far=-1)
        lengths.append(measured["width"].item() * speeds[-1])
        assert measured["peak"].item() == pytest.approx(
            exact["peak"].item() * speeds[-1] ** 6, rel=1e-6
        )
    assert lengths[0] == pytest.approx(lengths[1], rel=1e-7)
    assert lengths[0] == pytest.approx(exact["width"].item(), rel=1e-6)


def test_errors_of_pulses_in_a_chain_bound_the_true_ones():
    """Against the motion at a fifth of the step of the sensor, and at a small tolerance."""
    fine = struck(relative=1e-12, gamma=0.05)
    fine["record"]["sensors"]["far"]["step"] /= 5.0
    true = gf.pulses(gf.simulate_chain(fine)["contact_force_far"])
    for relative in (1e-4, 1e-6):
        coarse = gf.simulate_chain(struck(relative=relative, gamma=0.05))
        found = gf.pulses(coarse["contact_force_far"])
        for name in ("arrival", "peak", "width"):
            wrong, stated = np.abs(found[name] - true[name])[0], found[f"{name}_error"][0]
            assert (wrong < 2.0 * stated).all()
            assert (stated < 1e-3).all()


@pytest.mark.parametrize(
    ("change", "words"),
    [
        (lambda one: one.isel(t=slice(10)), "series has 10 samples.* 24"),
        (lambda one: one.isel(t=[0, *range(5, 60)]), "steps of 0.05 to 0.25.* equal"),
        (lambda one: one.drop_attrs(), "error_estimate"),
    ],
)
def test_series_that_cannot_be_measured_are_refused(change, words):
    with pytest.raises(InputError, match=words):
        gf.pulses(change(sampled(two_pulses, 0.05)))


@pytest.mark.parametrize("step", [0.5, 0.7, 0.8])
def test_errors_of_coarse_pulses_hold_at_every_phase(step):
    """Two passages may agree by chance; then the change of the peak says how wrong both are."""
    t, phases = np.arange(-20.0, 20.0, step), np.linspace(0.0, step, 40)
    values = np.exp(-((t[:, None] - phases) ** 2))
    found = gf.pulses(series_of(values, t)).isel(pulse=0)
    half = np.sqrt(np.log(2.0))
    for name, exact in (("arrival", phases - half), ("width", 2.0 * half)):
        assert (np.abs(found[name] - exact) < 2.0 * found[f"{name}_error"]).all()
