r"""A chain as input of LAMMPS, the law mapped exactly; written from the scene of the chain.

Beads are spheres of diameter 1 and mass 1 in a row, bead n at n − 1 + x_n, so that neighbours
overlap by u_n.  Then R_eff = 1/4 and m_eff = 1/2, and ``pair_style granular`` with ``hertz k_n η``
and no tangential force has the elastic force :math:`k_n R_\mathrm{eff}^{1/2} u^{3/2}`, which is
:math:`u^{3/2}` for k_n = 2.  Three of its damping models are viscous forces
:math:`\gamma\beta u^{\beta-1}\dot u`:

- ``viscoelastic``, :math:`\eta\,m_\mathrm{eff}(R_\mathrm{eff}u)^{1/2}\dot u`: β = 3/2, η = 6γ;
- ``coeff_restitution``: β = 5/4, with the coefficient of restitution in place of η, :math:`\ln e =
  -\pi q/\sqrt{1-q^2}`, :math:`q = \tfrac54\sqrt{2/5}\,\gamma`;
- ``velocity``, :math:`\eta\,\dot u`: β = 1, η = γ.

A constant force :math:`\delta^{3/2}` on bead 1 is the pressure of (25).  The usual ``fix nve`` is
the scheme of `half_step`.  ``fix mvv/dpd 1.0`` is of order 2. It needs the atom style and a pair
style of dissipative particles, here without force.
"""

import math

from granular_fronts.errors import InputError
from granular_fronts.scenes.chain import Given

DIAMETER = 1.0
MARGIN = 10.0  # room around the chain, in diameters

DECK = """\
# {title}
# Run: lmp -in lammps.in -var step 0.05
# With -var integrator mvv the viscous force sees a predicted velocity, by fix mvv/dpd.
# The positions of bead n are n - 1 + x_n; the overlap of beads n and n + 1 is u_n = x_n - x_(n+1).
variable step index 0.05
variable integrator index nve
variable every equal round({interval!r}/v_step)
variable steps equal round({end_time!r}/v_step)
units lj
dimension 3
boundary f f f
newton on
if "${{integrator}} == mvv" then "atom_style hybrid sphere mdpd" else "atom_style sphere"
# Without this the viscous force across a border of the box sees no velocity.
comm_modify vel yes
region room block {low!r} {high!r} -2 2 -2 2
create_box 1 room
{atoms}
set group all diameter 1.0
set group all mass 1.0
{velocities}variable law string &
  "hertz {stiffness!r} {coefficient!r} damping {damping} tangential linear_nohistory 0 0"
if "${{integrator}} == mvv" then &
  "pair_style hybrid/overlay granular dpd 0.0 0.001 1" "pair_coeff * * dpd 0 0 0.001" &
  "pair_coeff * * granular ${{law}}" "fix motion all mvv/dpd 1.0" &
else "pair_style granular" "pair_coeff * * ${{law}}" "fix motion all nve"
neighbor 0.3 bin
neigh_modify every 1 delay 0 check yes
{wall}{push}timestep ${{step}}
dump out all custom ${{every}} {name}_${{step}}.dump id x vx
dump_modify out sort id time yes format float %.17g
run ${{steps}}
"""


def write_deck(name, title, scene, interval):
    """Return the input file of a chain.

    The scene has α = 3/2, β of 3/2, 5/4 or 1, a free right end, and beads that just touch at t = 0.
    A single bead may have a gap, a weight and a wall.  `name` begins the name of the file that
    LAMMPS writes, `interval` lies between two states in it.
    An InputError says that LAMMPS has no such law.
    """
    beads, velocities = scene.beads.count, _start_velocities(scene)
    push, (low, high) = force_on_first(scene), room(scene)
    damping, coefficient = damping_model(scene)
    wall = f"fix plate all wall/gran granular ${{law}} xplane NULL {beads - 0.5!r}\n"
    moving = [(n, v) for n, v in enumerate(velocities, 1) if v]
    return DECK.format(
        title=title,
        name=name,
        interval=float(interval),
        end_time=scene.end_time,
        low=low,
        high=high,
        atoms=atoms_of(scene),
        stiffness=effective(scene)[0] ** -0.5,
        velocities="".join(f"set atom {n} vx {v!r}\n" for n, v in moving),
        coefficient=coefficient,
        damping=damping,
        wall=wall if scene.boundary.kind == "wall" else "",
        push=f"group first id 1\nfix push first addforce {push!r} 0 0\n" if push else "",
    )


def atoms_of(scene, units=""):
    """Return the commands that create the beads, as LIGGGHTS takes them too."""
    gap = -sum(getattr(scene.start, "relative_displacement", ()))
    places = (n * DIAMETER - gap for n in range(scene.beads.count))
    return "\n".join(f"create_atoms 1 single {place!r} 0 0{units}" for place in places)


def force_on_first(scene):
    """Return the constant force on bead 1: the pressure, or the weight of a single bead."""
    return scene.boundary.left_end**scene.law.alpha + scene.gravity


def effective(scene):
    """Return R_eff and m_eff of a contact: of two beads, or of one with a wall."""
    radius, mass = 0.5 * DIAMETER, 1.0
    return (radius, mass) if scene.boundary.kind == "wall" else (0.5 * radius, 0.5 * mass)


def damping_model(scene):
    """Return LAMMPS's name and coefficient of a viscous force; an InputError if it has no name."""
    alpha, beta, gamma = scene.law.alpha, scene.law.beta, scene.law.gamma
    radius, mass = effective(scene)
    if alpha == 1.5 and beta == 1.5:
        return "viscoelastic", 1.5 * gamma / (mass * math.sqrt(radius))
    if alpha == 1.5 and beta == 1.0:
        return "velocity", gamma
    ratio = 1.25 * gamma / math.sqrt(5.0 * mass)
    if alpha == 1.5 and beta == 1.25 and ratio < 1.0:
        return "coeff_restitution", math.exp(-math.pi * ratio / math.sqrt(1.0 - ratio**2))
    raise InputError(
        f"LAMMPS has no law with alpha = {alpha:g}, beta = {beta:g}, gamma = {gamma:g}: take alpha "
        "= 3/2 and beta = 3/2, 1, or 5/4 with gamma below 1.26."
    )


def _start_velocities(scene):
    return scene.start.velocity if isinstance(scene.start, Given) else ()


def room(scene):
    """Return the ends of a box, by thrice the velocity of a front or of the start."""
    of_front = scene.boundary.left_end ** (0.5 * (scene.law.alpha + 1.0))
    farthest = 3.0 * max(of_front, *map(abs, _start_velocities(scene)), 0.0) * scene.end_time
    return -MARGIN, scene.beads.count * DIAMETER + MARGIN + farthest
