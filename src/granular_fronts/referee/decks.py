r"""Cases as input of LIGGGHTS, YADE and Lethe; `lammps_deck` has LAMMPS's.

Beads are as there.  A contact has R_eff = 1/4 and m_eff = 1/2, with a wall 1/2 and 1.  Each code
has one viscous force, and does without:

- LIGGGHTS ``hertz/stiffness``: :math:`\gamma_n m_\mathrm{eff}(R_\mathrm{eff}u)^{1/2}\dot u`,
  β = 3/2;
- YADE ``MindlinPhys``: :math:`2\beta_n(m_\mathrm{eff}k_n)^{1/2}\dot u` with
  :math:`k_n = \tfrac32u^{1/2}`, β = 5/4; a contact that opens does not attract;
- Lethe ``hertz``: by a coefficient of restitution, as LAMMPS's ``coeff_restitution``, β = 5/4.  Its
  deck is written after its documentation, which names no force on a single bead, and was not run.

YADE keeps velocities of half steps.  Its deck starts half a step before t = 0, and adds half a
step to the velocities that it writes, so that both are those of whole steps.
"""

import math

from granular_fronts.referee.lammps_deck import (
    atoms_of,
    damping_model,
    effective,
    room,
    write_deck,
)
from granular_fronts.referee.problems import Problem

RADIUS, MASS = 0.5, 1.0
DENSITY = MASS / (4.0 / 3.0 * math.pi * RADIUS**3)

RUN_BY = {
    "lammps.in": "run by LAMMPS (22 Jul 2025 - Update 4)",
    "liggghts.in": "run by LIGGGHTS 3.8.0 (Debian 3.8.0+repack1-9+b2)",
    "yade.py": "run by YADE 2023.02a (Debian 2023.02a-1)",
    "lethe.prm": "not run",
}
"""Where a run agreed with `lagged_verlet` to rounding, in every case that has the deck."""

LIGGGHTS = """\
# {title}
# Run: liggghts -in liggghts.in -var step 0.05
variable step index 0.05
variable every equal round({interval!r}/v_step)
variable steps equal round({end_time!r}/v_step)
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region room block {low!r} {high!r} -2 2 -2 2 units box
create_box 1 room
neighbor 0.3 bin
neigh_modify every 1 delay 0
{atoms}
set group all diameter 1.0 density {density!r}
{velocities}fix m1 all property/global kn peratomtypepair 1 {stiffness!r}
fix m2 all property/global kt peratomtypepair 1 0.0
fix m3 all property/global gamman peratomtypepair 1 {damping!r}
fix m4 all property/global gammat peratomtypepair 1 0.0
pair_style gran model hertz/stiffness tangential off
pair_coeff * *
{wall}group first id 1
fix push first addforce {force!r} 0 0
fix motion all nve/sphere
timestep ${{step}}
dump out all custom ${{every}} {name}_${{step}}.dump id x vx
dump_modify out sort id format "%d %.17g %.17g"
run ${{steps}}
"""

LIGGGHTS_WALL = """\
fix plate all wall/gran model hertz/stiffness tangential off primitive type 1 xplane {!r}
"""

YADE = """\
# {title}
# Run: yade -n -x -j1 yade.py 0.05
import sys

step = float(sys.argv[1]) if len(sys.argv) > 1 else 0.05
every = round({interval!r} / step)
bead = FrictMat(young=3.0, poisson=0.0, density={density!r}, frictionAngle=0.0)
O.materials.append(bead)
ids = [O.bodies.append(sphere((x, 0, 0), 0.5, material=bead)) for x in {positions!r}]
for n, v in zip(ids, {start!r}):
    O.bodies[n].state.vel = (v - (0.5 * step * {force!r} if n == 0 else 0.0), 0, 0)
{wall}rows = ["t,bead,x,v"]


def save():
    if O.iter % every == 0:
        for n in ids:
            state = O.bodies[n].state
            v = state.vel[0] + 0.5 * step * O.forces.f(n, sync=True)[0] / state.mass
            rows.append("%r,%d,%r,%r" % (O.iter * step, n + 1, state.pos[0] - n, v))


O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(betan={damping!r})],
        [Law2_ScGeom_MindlinPhys_Mindlin()],
    ),
    ForceEngine(force=({force!r}, 0, 0), ids=[0]),
    PyRunner(command="save()", iterPeriod=1, initRun=True),
    NewtonIntegrator(damping=0.0),
]
O.dt = step
O.run(round({end_time!r} / step) + 1, True)
with open("{name}_%g.csv" % step, "w") as file:
    file.write("\\n".join(rows) + "\\n")
"""

YADE_WALL = """\
O.bodies.append(wall({!r}, axis=0, material=bead))
"""

LETHE = """\
# {title}
# After the documentation of Lethe; not run. Run: lethe-particles lethe.prm
# Turn the positions and velocities of its output into a table {name}_STEP.csv: t, bead, x, v.
set dimension = 3
subsection simulation control
  set time step        = 0.05
  set time end         = {end_time!r}
  set log frequency    = {every}
  set output frequency = {every}
end
subsection model parameters
  subsection contact detection
    set contact detection method = constant
    set frequency                = 1
    set neighborhood threshold   = 1.3
  end
  set particle particle contact force method = hertz
  set particle wall contact force method     = nonlinear
  set rolling resistance torque method       = none
  set integration method                     = velocity_verlet
end
subsection lagrangian physical properties
  set g                        = {force!r}, 0.0, 0.0
  set number of particle types = 1
  subsection particle type 0
    set size distribution type            = uniform
    set diameter                          = 1.0
    set number of particles               = {beads}
    set density particles                 = {density!r}
    set young modulus particles           = 3.0
    set poisson ratio particles           = 0.0
    set restitution coefficient particles = {restitution!r}
    set friction coefficient particles    = 0.0
    set rolling friction particles        = 0.0
  end
  set young modulus wall           = {young_of_wall!r}
  set poisson ratio wall           = 0.0
  set restitution coefficient wall = {restitution!r}
  set friction coefficient wall    = 0.0
  set rolling friction wall        = 0.0
end
subsection insertion info
  set insertion method    = list
  set insertion frequency = 100000000
  set list x              = {list_x}
  set list y              = {zeros}
  set list z              = {zeros}
  set list velocity x     = {list_v}
  set list velocity y     = {zeros}
  set list velocity z     = {zeros}
  set list omega x        = {zeros}
  set list omega y        = {zeros}
  set list omega z        = {zeros}
  set list diameters      = {ones}
end
subsection mesh
  set type               = dealii
  set grid type          = subdivided_hyper_rectangle
  set grid arguments     = {cells}, 2, 2 : {low!r}, -4, -4 : {end!r}, 4, 4 : false
  set initial refinement = 0
end
"""


def write_decks(problem: Problem) -> dict[str, str]:
    """Return the decks of the codes that have the law and the motion of a problem, by files."""
    scene, law, wall = problem.scene, problem.scene.law, problem.wall
    deck = write_deck(problem.name, problem.title, scene, problem.interval)
    found, (radius, mass) = {"lammps.in": deck}, effective(scene)
    x, v = (values.tolist() for values in problem.start)
    plate = scene.beads.count - 0.5
    low, high = room(scene)
    common = {
        "title": problem.title,
        "name": problem.name,
        "interval": problem.interval,
        "end_time": scene.end_time,
        "force": problem.force,
        "density": DENSITY,
        "low": low,
        "high": high,
    }
    if not law.gamma or law.beta == 1.5:
        found["liggghts.in"] = LIGGGHTS.format(
            **common,
            atoms=atoms_of(scene, " units box"),
            velocities="".join(f"set atom {n + 1} vx {one!r}\n" for n, one in enumerate(v) if one),
            stiffness=radius**-0.5,
            damping=1.5 * law.gamma / (mass * math.sqrt(radius)),
            wall=LIGGGHTS_WALL.format(plate) if wall else "",
        )
    # Damped contacts of YADE do not attract, which those of a front do not do either.
    if not law.gamma or (law.beta == 1.25 and problem.motion == "front"):
        found["yade.py"] = YADE.format(
            **common,
            positions=[n + one for n, one in enumerate(x)],
            start=v,
            damping=1.25 * law.gamma / math.sqrt(3.0),
            wall=YADE_WALL.format(plate) if wall else "",
        )
    pushed = problem.force and not wall
    if not pushed and (not law.gamma or law.beta == 1.25):
        found["lethe.prm"] = LETHE.format(
            **common,
            every=round(problem.interval / 0.05),
            beads=len(x),
            restitution=damping_model(scene)[1] if law.gamma else 1.0,
            young_of_wall=1.0 / (math.sqrt(8.0) / 3.0 - 1.0 / 3.0) if wall else 3.0,
            list_x=", ".join(repr(n + one) for n, one in enumerate(x)),
            list_v=", ".join(map(repr, v)),
            zeros=", ".join(["0"] * len(x)),
            ones=", ".join(["1.0"] * len(x)),
            end=plate if wall else high,
            cells=round(((plate if wall else high) - low) / 4.0),
        )
    return found
