"""Do stated errors hold?  Random problems are solved again by independent programs."""

from honest_errors_settings import HonestErrors

HONEST_ERRORS, _ = project_settings("honest_errors", HonestErrors)


rule measure_honest_errors:
    """Stated and true errors of random chains, fronts or rings."""
    input:
        kernels("fronts", "reference_methods"),
    output:
        dataset="<results>/data/honest_errors/{kind}.nc",
    params:
        code=code("measure_honest_errors", "true_{wildcards.kind}"),
        problems=lambda wildcards: HONEST_ERRORS[wildcards.kind],
    log:
        "<logs>/measure_honest_errors/{kind}.log",
    benchmark:
        "<benchmarks>/measure_honest_errors/{kind}.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    wildcard_constraints:
        kind="|".join(HONEST_ERRORS),
    script:
        "measure_honest_errors.py"


rule honest_errors:
    """How often true errors exceed stated ones, of a thousand random problems; 15 minutes."""
    input:
        chains="<results>/data/honest_errors/chains.nc",
        fronts="<results>/data/honest_errors/fronts.nc",
        rings="<results>/data/honest_errors/rings.nc",
        texts="projects/honest_errors/captions/honest_errors.rst",
    output:
        **figure("honest_errors", "projects/honest_errors/captions"),
    params:
        code=code(
            *("honest_errors", "measure_honest_errors", "true_chains", "true_fronts", "true_rings")
        ),
        problems=HONEST_ERRORS,
        shown=dict(),
    log:
        "<logs>/honest_errors.log",
    benchmark:
        "<benchmarks>/honest_errors.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "honest_errors.py"
