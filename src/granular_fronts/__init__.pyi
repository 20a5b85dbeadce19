"""The public names with their types, as `__init__.py` imports them when they are first used."""

from granular_fronts.chain.experiment import pulses as pulses
from granular_fronts.chain.simulate import simulate_chain as simulate_chain
from granular_fronts.continuum.evolution import evolve_log_burgers as evolve_log_burgers
from granular_fronts.continuum.evolution import evolve_log_kdv_burgers as evolve_log_kdv_burgers
from granular_fronts.continuum.log_burgers.equation import log_burgers_front as log_burgers_front
from granular_fronts.continuum.log_kdv_burgers.heteroclinic import heteroclinic as heteroclinic
from granular_fronts.fronts.linear.critical_damping import critical_damping as critical_damping
from granular_fronts.fronts.linear.floquet import front_multipliers as front_multipliers
from granular_fronts.fronts.linear.tails import tail_roots as tail_roots
from granular_fronts.fronts.solve import evaluate_front as evaluate_front
from granular_fronts.fronts.solve import solve_front as solve_front
from granular_fronts.fronts.sweep import sweep_fronts as sweep_fronts
from granular_fronts.model.collision import damping_for_restitution as damping_for_restitution
from granular_fronts.model.collision import restitution as restitution
from granular_fronts.model.jump_conditions import jump_conditions as jump_conditions
from granular_fronts.model.laws import make_law as make_law
from granular_fronts.model.materials import contact_stiffness as contact_stiffness
from granular_fronts.model.potentials import Potential as Potential
from granular_fronts.model.scaling import Scaling as Scaling
from granular_fronts.model.scaling import damping_from_restitution as damping_from_restitution
from granular_fronts.model.scaling import sphere_stiffness as sphere_stiffness
from granular_fronts.output import plot as plot
from granular_fronts.proofs.certificate import prove_front as prove_front
from granular_fronts.proofs.checker import check_certificate as check_certificate
from granular_fronts.scenes.chain import Chain as Chain
from granular_fronts.scenes.front import Front as Front
from granular_fronts.scenes.ring import Ring as Ring

__version__: str
__all__: list[str]
