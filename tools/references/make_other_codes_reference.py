"""Motions of short chains by LIGGGHTS and YADE, to compare the half-step scheme with.

Both have one law in common with the package: LIGGGHTS β = 3/2, YADE β = 5/4, the latter as long as
no viscous force exceeds the elastic one, since it allows no attraction. The chains are pressed from
rest; with LIGGGHTS the last contacts open.

Needs the commands liggghts and yade: apt-get install liggghts yade. Run
``python tools/references/make_other_codes_reference.py --help`` for the command line.
"""

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import xarray as xr

REFERENCES = Path(__file__).parents[2] / "tests" / "references"
BEADS, STEP, PRESSURE = 20, 0.1, 0.1**1.5
GAMMAS = (0.06, 0.3)
STEPS = {"liggghts": 600, "yade": 300}
BETA = {"liggghts": 1.5, "yade": 1.25}

LIGGGHTS = """\
units si
atom_style granular
boundary f f f
newton off
communicate single vel yes
region room block -10 60 -2 2 -2 2 units box
create_box 1 room
neighbor 0.3 bin
neigh_modify every 1 delay 0
{atoms}
set group all diameter 1.0 density {density!r}
fix m1 all property/global kn peratomtypepair 1 2.0
fix m2 all property/global kt peratomtypepair 1 0.0
fix m3 all property/global gamman peratomtypepair 1 {damping!r}
fix m4 all property/global gammat peratomtypepair 1 0.0
pair_style gran model hertz/stiffness tangential off
pair_coeff * *
group first id 1
fix push first addforce {pressure!r} 0 0
fix motion all nve/sphere
timestep {step!r}
dump out all custom {steps} final.txt id x vx
dump_modify out format "%d %.17g %.17g"
run {steps}
"""

YADE = """\
bead = FrictMat(young=3.0, poisson=0.0, density={density!r}, frictionAngle=0.0)
O.materials.append(bead)
O.bodies.append([sphere((float(n), 0, 0), 0.5, material=bead) for n in range({beads})])
O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb()]),
    InteractionLoop(
        [Ig2_Sphere_Sphere_ScGeom()],
        [Ip2_FrictMat_FrictMat_MindlinPhys(betan={damping!r})],
        [Law2_ScGeom_MindlinPhys_Mindlin()],
    ),
    ForceEngine(force=({pressure!r}, 0, 0), ids=[0]),
    NewtonIntegrator(damping=0.0),
]
O.dt = {step!r}
O.run({steps}, True)
with open("final.txt", "w") as file:
    for n, body in enumerate(O.bodies):
        file.write("%d %r %r\\n" % (n + 1, body.state.pos[0], body.state.vel[0]))
"""

CODES = {
    # Damping γ_n m_eff (R_eff u)^(1/2) u'.
    "liggghts": (LIGGGHTS, lambda gamma: 6.0 * gamma, ["liggghts", "-in"]),
    # Damping 2 β_n (m_eff k_n)^(1/2) u', with the stiffness k_n = (3/2) u^(1/2).
    "yade": (YADE, lambda gamma: 1.25 * gamma / np.sqrt(3.0), ["yade", "-n", "-x", "-j1"]),
}


def run_code(code, gamma):
    """Final positions less those at rest, and final velocities as the code shows them."""
    template, damping, command = CODES[code]
    text = template.format(
        atoms="\n".join(f"create_atoms 1 single {n} 0 0 units box" for n in range(BEADS)),
        beads=BEADS,
        density=6.0 / np.pi,
        damping=float(damping(gamma)),
        pressure=PRESSURE,
        step=STEP,
        steps=STEPS[code],
    )
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "chain.py").write_text(text)
        process = subprocess.run(
            [*command, "chain.py"], cwd=folder, capture_output=True, text=True, timeout=120
        )
        final = Path(folder, "final.txt")
        if not final.exists():
            sys.exit(f"{code} failed: {process.stdout[-1000:]}{process.stderr[-1000:]}")
        rows = [line.split() for line in final.read_text().splitlines()]
    table = np.array([row for row in rows if len(row) == 3 and row[0].isdigit()], float)[-BEADS:]
    table = table[np.argsort(table[:, 0])]
    return table[:, 1] - np.arange(BEADS), table[:, 2]


def main():
    """Run both codes and write what they find."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, default=REFERENCES / "other_codes_reference.nc")
    parser.add_argument("--versions", required=True, help="what to name in the file")
    options = parser.parse_args()
    found = [[run_code(code, gamma) for gamma in GAMMAS] for code in CODES]
    xr.Dataset(
        {
            "displacement": (("code", "gamma", "bead"), [[x for x, _ in row] for row in found]),
            "velocity": (("code", "gamma", "bead"), [[v for _, v in row] for row in found]),
            "beta": ("code", [BETA[code] for code in CODES]),
            "steps": ("code", [STEPS[code] for code in CODES]),
        },
        {"code": list(CODES), "gamma": list(GAMMAS), "bead": np.arange(1, BEADS + 1)},
        {"title": options.versions, "step": STEP},
    ).to_netcdf(options.output)
    print(f"{options.output}: {options.versions}")


if __name__ == "__main__":
    main()
