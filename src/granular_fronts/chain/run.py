"""One integration of a scene: its arrays at t = 0, and the loop that advances them.

Rest means ẋ = 0, James (2021), section 3.3: where a boundary holds a contact compressed at t = 0,
the generalised velocity starts at w_1(0) = −γ δ^β.

A chain with a drive is integrated from one of its break points to the next.  A step lands on each,
so that no step has a jump of the force, or of the piston's acceleration, inside.
"""

import functools
from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np

from granular_fronts.chain import equations, integrator, state
from granular_fronts.chain.drives import make_drive
from granular_fronts.chain.equations import EQUAL, Beads, Boundary
from granular_fronts.chain.patterns import values_along
from granular_fronts.chain.recorder import STEEPNESS, TIME, VALUE, Recording
from granular_fronts.chain.recording import make_recording
from granular_fronts.chain.stage_passes import stage_pass
from granular_fronts.chain.state import D, U
from granular_fronts.chain.strain import end_of_window
from granular_fronts.errors import InputError, SolveError
from granular_fronts.model import kinds
from granular_fronts.model.laws import Law
from granular_fronts.model.passes import NEGLIGIBLE, row_map, row_parameters
from granular_fronts.numerics.records import make_record
from granular_fronts.numerics.runge_kutta import STAGES
from granular_fronts.scenes.chain import Chain, Given, Striker, Tolerance
from granular_fronts.scenes.sentences import read_part

FIRST_STEP = 1.0e-6
STEPS_PER_BLOCK = 2000
# By so much halved steps lessen an error of truncation of order 8.
GAIN_OF_HALVES = 2.0**-8
# Beads of the active window ahead of the last one that moves.  Where small disturbances exert a
# force to first order, every stage carries them one bead further.
MARGIN_WITHOUT_STIFFNESS = 4
# So long after a drive has set in its sign is that of the motion that it starts.
JUST_AFTER = 1.0e-9
# How close to an end of the law's domain, relative to that end or to the other, a strain leaves it.
CLOSE_TO_AN_END = 1.0e-6
# An extension at which a law that acts in extension exerts a force.
SMALL_EXTENSION = 1.0e-3


class Run(NamedTuple):
    """One integration of a scene: everything that it works on."""

    scene: Chain
    law: Law
    boundary: Boundary
    beads: Beads
    chain: np.record  # Of type `state.CHAIN`.
    table: np.ndarray  # Rows of the chain, see `state`.
    recording: Recording
    momentum: float  # Σm_nẋ_n at t = 0.

    @property
    def clock(self):
        """Time and work so far (`state.CLOCK`)."""
        return self.chain.clock

    def row(self, row):
        """Entries 1 … N of a row of the table, a view."""
        return self.table[row, 1 : self.chain.beads + 1]


def prepare(scene: Mapping[str, Any] | Chain) -> Run:
    """Return the run of a scene, ready at t = 0."""
    scene = Chain.read(scene)
    law = scene.law
    boundary, beads = make_boundary(scene), make_beads(scene)
    u, velocity = initial_state(scene, law, boundary, beads)
    chain, table = make_chain(law, boundary, u, velocity, beads)
    integrator.begin(chain, table)
    breaks = boundary.drive.breaks if boundary.drive else np.empty(0)
    recording = make_recording(scene, chain, table[U], breaks)
    momentum = float((beads.mass * velocity).sum())
    run = Run(scene, law, boundary, beads, chain, table, recording, momentum)
    _note_openings(run, u, velocity, chain.contacts)
    return run


def _note_openings(run, u, velocity, contacts):
    """Of the first contacts those that just touch and are pulled apart open now."""
    recording, t = run.recording, float(run.clock.t)
    rate = equations.differences(velocity, run.boundary)
    gained = equations.accelerations(u, velocity, run.boundary, run.law, run.beads, t + JUST_AFTER)
    parts = (rate < 0.0) | ((rate == 0.0) & (equations.differences(gained, run.boundary) < 0.0))
    opens = 1 + np.flatnonzero(((np.abs(u) <= NEGLIGIBLE) & parts)[:contacts])
    opens = opens[np.isnan(recording.opening[TIME, opens])]
    recording.opening[VALUE, opens], recording.opening[TIME, opens] = 0.0, t
    # Contacts that part from rest open at this time, and no slope locates it.
    recording.opening[STEEPNESS, opens] = np.where(rate < 0.0, -rate, np.nan)[opens - 1]


def _state(run):
    """Return the present u and ẋ of all beads."""
    u, boundary = run.row(U).copy(), run.boundary
    if boundary.holds_right:
        u[-1] = boundary.right
    return u, equations.velocities(run.row(D), u, boundary, run.law, run.momentum, run.beads)


def integrate(
    run: Run,
    tolerance: Mapping[str, float] | Tolerance,
    after_block: Callable[[Run], None] = lambda run: None,
) -> np.ndarray:
    """Advance a run to its end; returns the times at which steps ended.

    The tolerance is `relative` and `absolute`, per step, in the maximum norm over beads.
    `after_block` is called with the run after about `STEPS_PER_BLOCK` steps each and at the end.

    A SolveError says that the step size collapsed, that the state is no longer finite, or that for
    α < 1 a contact opened.
    """
    asked = read_part(Tolerance, tolerance, "tolerance: ")
    blocks = []

    def advance(run):
        before, ends = run.clock.accepted, np.empty(STEPS_PER_BLOCK)
        status = integrator.advance(
            run.chain, run.table, run.recording, asked.relative, asked.absolute, ends, False
        )
        blocks.append(ends[: run.clock.accepted - before].copy())
        return status

    _advance(run, advance, after_block)
    return np.concatenate(blocks)


def integrate_in_halves(
    run: Run,
    tolerance: Mapping[str, float] | Tolerance,
    ends: np.ndarray,
    after_block: Callable[[Run], None] = lambda run: None,
) -> np.ndarray:
    """Advance a run to its end by two steps for each of another run of the same scene.

    `ends` are the times at which the steps of that run ended, at the same tolerance; returns those
    of the halves.  Where the error is one of truncation it is smaller by 2⁸, whatever limited the
    steps: accuracy, stability or outputs.  Steps are cut at contacts so that as much less is left.
    """
    halves = np.union1d(ends, 0.5 * (np.append(0.0, ends[:-1]) + ends))
    halves = halves[halves > 0.0]
    asked = read_part(Tolerance, tolerance, "tolerance: ")
    least = asked.relative * GAIN_OF_HALVES, asked.absolute * GAIN_OF_HALVES

    def follow(run):
        first = np.searchsorted(halves, run.clock.t, side="right")
        part = halves[first : first + STEPS_PER_BLOCK]
        return integrator.advance(run.chain, run.table, run.recording, *least, part, True)

    _advance(run, follow, after_block)
    return halves


def _advance(run, advance, after_block):
    """Advance a run to the last of its stops, from one break point of its drive to the next."""
    stops, drive, shown = run.recording.stops, run.boundary.closing_drive, 0
    breaks = drive.breaks[drive.breaks < stops[-1]] if drive else []
    for piece, end in enumerate([*breaks, stops[-1]]):
        if piece:
            run.chain.drive = drive.pieces[piece]
            integrator.begin(run.chain, run.table)
            # A drive that sets in pulls at bead 1 alone.
            _note_openings(run, *_state(run), 1)
        part = run.recording._replace(stops=stops[: np.searchsorted(stops, end, side="right")])
        status = integrator.RUNNING
        while status == integrator.RUNNING:
            status = advance(run._replace(recording=part))
            if end == stops[-1] or run.clock.accepted >= shown + STEPS_PER_BLOCK:
                after_block(run)
                shown = run.clock.accepted
        if status != integrator.FINISHED:
            raise SolveError(_cause(status, run))


def make_boundary(scene: Chain) -> Boundary:
    """Boundary conditions (25) or (26) of a scene, with its drive."""
    boundary = scene.boundary
    ring, piston, wall = (boundary.kind == kind for kind in ("ring", "piston", "wall"))
    drive = make_drive(boundary.pieces())
    return Boundary(ring, boundary.left_end, boundary.right_end, drive, piston, wall)


def make_beads(scene: Chain) -> Beads:
    """Masses, factors of contacts and body force of a scene, by its patterns."""
    count, mass, elastic = scene.beads.count, scene.beads.masses(), scene.elastic
    if mass.is_one and elastic.is_one and not scene.contacts.model_fields_set:
        return Beads(gravity=scene.gravity)

    def along(pattern):
        # The held contact at the right end has a force of its own.
        values = values_along(pattern, scene.contact_count)
        return np.append(values, [1.0] * (count - values.size))

    stiffness, viscosity = along(elastic), along(scene.contacts.viscous or elastic)
    return Beads(values_along(mass, count), stiffness, viscosity, scene.gravity)


def initial_state(
    scene: Chain, law: Law, boundary: Boundary, beads: Beads = EQUAL
) -> tuple[np.ndarray, np.ndarray]:
    """Relative displacements and velocities at t = 0, both of shape (N,)."""
    count, start = scene.beads.count, scene.start
    u, velocity = np.zeros(count), np.zeros(count)
    if start.kind in ("equilibrium", "striker"):
        u[:] = equations.equilibrium(law, boundary, beads, count)
    if isinstance(start, Striker):
        velocity[: start.beads] = start.velocity
    elif isinstance(start, Given):
        u[: scene.contact_count] = start.relative_displacement
        velocity[:] = start.velocity
    if boundary.piston:
        velocity[0] = boundary.drive.value(0.0)
    if boundary.holds_right:
        u[-1] = boundary.right
    return u, velocity


def make_chain(
    law: Law, boundary: Boundary, u: np.ndarray, velocity: np.ndarray, varied: Beads = EQUAL
) -> tuple[np.record, np.ndarray]:
    """A record `state.CHAIN` at t = 0 and its table, with the forces of held contacts in place.

    u and velocity have the shape (N,); with pressure on the right u_N is the held value.
    """
    beads, has_slack = u.size, _is_at_rest_without_stiffness(law, boundary.right)
    margin = MARGIN_WITHOUT_STIFFNESS if has_slack else STAGES + 1
    drive, ratio = boundary.closing_drive, equations.damping_ratio(law, boundary, varied)
    chain = make_record(
        state.CHAIN,
        law=compile_law(law, ratio),
        clock=make_record(state.CLOCK, h=FIRST_STEP),
        beads=beads,
        contacts=beads - boundary.holds_right,
        ring=boundary.ring,
        varied=varied.varied,
        driven=drive is not None,
        drive=drive.pieces[0] if drive else 0.0,
        piston=np.ravel(varied.mass)[0] if boundary.piston else 0.0,
        gravity=varied.gravity,
        ahead=boundary.right,
        margin=beads if varied.gravity else margin,
    )
    rows = state.ROWS_OF_SINGLE if chain.law.single else state.ROWS_OF_PAIR
    table = state.make_table(rows, beads)
    table[U, 1 : beads + 1] = u
    table[D, 1 : beads + 1] = equations.strain_rates(velocity, u, boundary, law, varied)
    table[state.STIFFNESS, 1 : beads + 1] = varied.stiffness
    table[state.VISCOSITY, 1 : beads + 1] = varied.viscosity
    table[state.MOBILITY, 1 : beads + 1] = 1.0 / np.asarray(varied.mass)
    table[state.MOBILITY, beads + 1] = table[state.MOBILITY, 1] if boundary.ring else 1.0
    if boundary.holds_right:
        table[U, beads] = 0.0
    if not boundary.ring:
        for row, potential in ((state.FORCE, law.elastic), (state.DAMPING, law.viscous)):
            table[row, 0], table[row, 1:] = equations.force(
                potential, (boundary.left, boundary.right)
            )
    moves_at_the_end = boundary.ring or table[D, beads] != 0.0
    # Contacts that differ are not in balance where all are compressed alike.
    unlike = np.any(np.not_equal(varied.stiffness, 1.0))
    moves = moves_at_the_end or (unlike and boundary.right != 0.0)
    chain["clock"]["reach"] = beads if moves else end_of_window(chain, table, chain.contacts)
    return chain, table


def compile_law(law: Law, ratio: float | None) -> np.record:
    """What the kernels know of a law, a record of type `state.LAW`; G = ratio F if it is a number.

    More kinks or parameters than the record has room for are an InputError.  So is a user's
    function that cannot be compiled or has changed since.
    """
    kinks, single = -np.array(law.kinks[::-1]), ratio is not None
    record = make_record(
        state.LAW,
        single=single,
        gamma=ratio if single else 1.0,
        elastic=row_map(law.elastic, 1),
        viscous=0 if single else row_map(law.viscous, 1),
        stage_pass=stage_pass(law.elastic) if single else 0,
        kink_count=kinks.size,
        has_stiff_kinks=any(np.isinf(law.elastic.second(kink)) for kink in law.kinks),
        attraction=_acts_in_extension(law),
    )
    _fill_parameters(record["elastic_parameters"], law.elastic)
    if not single:
        _fill_parameters(record["viscous_parameters"], law.viscous)
    if kinks.size > state.MOST_KINKS:
        raise InputError(
            f"The law of {law.elastic.name} and {law.viscous.name} has {kinks.size} kinks, but a "
            f"chain has room for {state.MOST_KINKS}: declare those alone that its contacts pass."
        )
    record["kinks"][: kinks.size] = kinks
    return record


def _fill_parameters(room, potential):
    """Write the parameters of the force of a potential."""
    parameters = row_parameters(potential, 1)
    if parameters.size > state.MOST_PARAMETERS:
        raise InputError(
            f"{potential.name} has {parameters.size} parameters with its factor, but a chain has "
            f"room for {state.MOST_PARAMETERS}: make some of them constants of its kind."
        )
    room[: parameters.size] = parameters


def _acts_in_extension(law):
    """Whether an extended contact exerts a force."""
    extension = min(SMALL_EXTENSION, 0.5 * law.domain[1])
    return extension > 0.0 and law.elastic.first(extension) != 0.0


@functools.lru_cache(maxsize=256)
def _is_at_rest_without_stiffness(law, u):
    """Whether small disturbances of the compression u exert no force to first order."""
    return law.elastic.second(-u) == 0.0 and law.viscous.second(-u) == 0.0


def work_done(run: Run) -> dict[str, int]:
    """Steps and right-hand sides so far, as a dict."""
    clock = run.clock
    return {
        "steps_accepted": int(clock.accepted),
        "steps_rejected": int(clock.rejected),
        "steps_cut_at_contacts": int(clock.cut),
        "right_hand_sides": int(clock.right_hand_sides),
    }


def _cause(status, run):
    """The sentence for a solve that stopped."""
    t, contacts = run.clock.t, slice(1, run.chain.contacts + 1)
    u, new_u = run.table[U, contacts], run.table[state.NEW_U, contacts]
    if status == integrator.OPENED:
        bead = 1 + int(np.argmin(new_u))
        is_hertzian = run.law.elastic.shape is kinds.hertz
        which = "For alpha < 1" if is_hertzian else f"For {run.law.elastic.name}"
        return (
            f"At t = {t:.6g} the contact of beads {bead} and {bead + 1} opens. {which} the "
            "force is not differentiable there and the motion is not known to be unique: "
            "precompress the chain, lower the load, or end the run earlier."
        )
    if status == integrator.NOT_FINITE and _comes_to_an_end(run.law, u).any():
        bead, (low, high) = 1 + int(np.argmax(_comes_to_an_end(run.law, u))), run.law.domain
        return (
            f"At t = {t:.6g} the strain of contact {bead} leaves the interval from {low:g} to "
            f"{high:g} in which the law holds: take a law with a wider interval, lower the load, "
            "or end the run earlier."
        )
    if status == integrator.NOT_FINITE:
        bead = 1 + int(np.argmax(~np.isfinite(new_u)))
        return (
            f"At t = {t:.6g} the state of bead {bead} is not a finite number however short the "
            "step: the start or the boundary values are too large for double precision."
        )
    bead = 1 + int(np.argmax(np.abs(new_u - u)))
    return (
        f"At t = {t:.6g} the step size collapsed to {run.clock.h:.3g}, with the fastest change "
        f"at bead {bead}: the tolerance cannot be met in double precision; raise "
        "tolerance.relative or tolerance.absolute."
    )


def _comes_to_an_end(law, u):
    """Whether each strain −u is as good as at an end of the law's domain."""
    low, high = law.domain
    size = max((abs(end) for end in law.domain if np.isfinite(end)), default=0.0)
    return np.minimum(-u - low, high + u) <= CLOSE_TO_AN_END * size
