"""How a dispersive shock becomes a front as damping sets in."""

from weak_damping_settings import WeakDamping

WEAK, WEAK_OWN = project_settings("weak_damping", WeakDamping)
WEAK_SHOWN = {name: [WEAK[name], WEAK_OWN[name]] for name in WEAK}


rule weak_damping_motion:
    """Chains that a constant force drives."""
    input:
        kernels("chain"),
    output:
        dataset="<results>/data/weak_damping/{scene}.nc",
    params:
        code=code("initiate_front"),
        scene=lambda wildcards: WEAK[wildcards.scene],
    log:
        "<logs>/weak_damping/{scene}.log",
    benchmark:
        "<benchmarks>/weak_damping/{scene}.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    wildcard_constraints:
        scene="free|weak|medium|strong",
    script:
        "../../workflow/scripts/initiate_front.py"


rule follow_shocks:
    """Crests behind a constant force, without and with damping."""
    input:
        kernels("chain"),
    output:
        dataset="<results>/data/weak_damping/shocks.nc",
    params:
        code=code("dispersive_shocks"),
        settings=WEAK["shocks"],
    log:
        "<logs>/weak_damping/shocks.log",
    benchmark:
        "<benchmarks>/weak_damping/shocks.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "dispersive_shocks.py"


rule damp_weakly:
    """Weakly damped fronts and slowly changing waves."""
    input:
        kernels("fronts"),
    output:
        dataset="<results>/data/weak_damping/fronts.nc",
    params:
        code=code("weakly_damped_fronts"),
        settings=WEAK["fronts"],
    log:
        "<logs>/weak_damping/fronts.log",
    benchmark:
        "<benchmarks>/weak_damping/fronts.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "weakly_damped_fronts.py"


rule weak_damping_shocks:
    """Compression at one contact, from a dispersive shock to a front."""
    input:
        motions=data(
            *("weak_damping/free", "weak_damping/weak"),
            *("weak_damping/medium", "weak_damping/strong"),
        ),
        texts="projects/weak_damping/captions/weak_damping_shocks.rst",
    output:
        **figure("weak_damping_shocks", "projects/weak_damping/captions"),
    params:
        code=code("weak_damping_shocks", "initiate_front"),
        shown=WEAK_SHOWN,
    log:
        "<logs>/weak_damping/figure_shocks.log",
    benchmark:
        "<benchmarks>/weak_damping/figure_shocks.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "weak_damping_shocks.py"


rule weak_damping_damping:
    """Weakly damped fronts, their limit, and how a chain comes to them."""
    input:
        shocks="<results>/data/weak_damping/shocks.nc",
        fronts="<results>/data/weak_damping/fronts.nc",
        texts="projects/weak_damping/captions/weak_damping_damping.rst",
    output:
        **figure("weak_damping_damping", "projects/weak_damping/captions"),
    params:
        code=code("weak_damping_damping", "dispersive_shocks", "weakly_damped_fronts"),
        shown=WEAK_SHOWN,
    log:
        "<logs>/weak_damping/figure_damping.log",
    benchmark:
        "<benchmarks>/weak_damping/figure_damping.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "weak_damping_damping.py"


rule weak_damping_findings:
    """What was found, with verdicts."""
    input:
        statements="projects/weak_damping/findings.yaml",
        datasets=data("weak_damping/shocks", "weak_damping/fronts"),
    output:
        **table("weak_damping_findings"),
    params:
        code=code("tabulate_statements", *measured_by("projects/weak_damping/findings.yaml")),
        shown=WEAK_SHOWN,
    log:
        "<logs>/weak_damping/findings.log",
    benchmark:
        "<benchmarks>/weak_damping/findings.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "../../workflow/scripts/tabulate_statements.py"


rule weak_damping:
    """How a dispersive shock becomes a front, with figures and verdicts; a minute."""
    input:
        figures=[rules.weak_damping_shocks.output, rules.weak_damping_damping.output],
        tables=[rules.weak_damping_findings.output.csv],
    output:
        verdict="<results>/weak_damping.txt",
    params:
        code=code("check_verdicts"),
    log:
        "<logs>/weak_damping/verdicts.log",
    benchmark:
        "<benchmarks>/weak_damping/verdicts.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "../../workflow/scripts/check_verdicts.py"
