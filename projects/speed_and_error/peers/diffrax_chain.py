"""Dopri8 of diffrax on the chain, compiled by JAX for the processor, in double precision."""

from functools import cache

from peers.runs import Run, Stopwatch, missing_package


@cache
def _compiled_solve():
    """Return solve(start, end, rtol, atol, parameters) to the final state and whether it is one."""
    import diffrax
    import jax
    import jax.numpy as jnp

    jax.config.update("jax_enable_x64", True)

    def right_hand_side(_, state, parameters):
        gamma, left = parameters
        positions, momenta = jnp.split(state, 2)
        ends = jnp.array([left, 0.0])
        inner = positions[:-1] - positions[1:]
        contacts = jnp.maximum(jnp.concatenate([ends[:1], inner, ends[1:]]), 0.0)
        forces = contacts * jnp.sqrt(contacts)
        momentum_rate = forces[:-1] - forces[1:]
        return jnp.concatenate([momenta + gamma * momentum_rate, momentum_rate])

    @jax.jit
    def solve(start, end, rtol, atol, parameters):
        solution = diffrax.diffeqsolve(
            diffrax.ODETerm(right_hand_side),
            diffrax.Dopri8(),
            0.0,
            end,
            None,
            start,
            parameters,
            stepsize_controller=diffrax.PIDController(rtol=rtol, atol=atol),
            saveat=diffrax.SaveAt(t1=True),
            adjoint=diffrax.ForwardMode(),
            max_steps=None,
            throw=False,
        )
        solved = solution.result == diffrax.RESULTS.successful
        return solution.ys[-1], solved

    return solve


def _run_dopri8(system, rtol, atol):
    """Run diffrax's Dopri8, of 14 stages."""
    absent = missing_package("jax", "diffrax")
    if absent:
        return absent
    import numpy as np

    solve = _compiled_solve()
    parameters = system.gamma, system.left
    with Stopwatch() as watch:
        state, solved = solve(system.start(), system.end, rtol, atol, parameters)
        state = np.asarray(state)
    if not solved:
        return Run(message="diffrax reported failure")
    return Run(system.observe(state), **watch.times)


METHODS = {"diffrax_dopri8": _run_dopri8}
