"""Figures, a rule each: what the data hold is drawn, and nothing computed.

fig01 to fig08 are the paper's; the others, named after what they show, are ours.
"""


rule fig01:
    """Figure 1, section 3.3."""
    input:
        data="<results>/data/chain/initiation_underdamped.nc",
        texts="workflow/captions/fig01_initiation_underdamped.rst",
    output:
        **figure("fig01_initiation_underdamped"),
    params:
        code=code("fig01", "initiate_front"),
        shown=shown("chain/initiation_underdamped"),
    log:
        "<logs>/fig01.log",
    benchmark:
        "<benchmarks>/fig01.tsv"
    conda:
        "../envs/main.yaml"
    priority: 2
    localrule: True
    script:
        "../scripts/figures/fig01.py"


rule fig02:
    """Figure 2, section 3.3."""
    input:
        data="<results>/data/chain/initiation_underdamped.nc",
        texts="workflow/captions/fig02_spacetime_underdamped.rst",
    output:
        **figure("fig02_spacetime_underdamped"),
    params:
        code=code("fig02", "initiate_front"),
        shown=shown("chain/initiation_underdamped"),
    log:
        "<logs>/fig02.log",
    benchmark:
        "<benchmarks>/fig02.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/fig02.py"


rule fig03:
    """Figure 3, section 3.3."""
    input:
        data="<results>/data/chain/initiation_overdamped.nc",
        texts="workflow/captions/fig03_initiation_overdamped.rst",
    output:
        **figure("fig03_initiation_overdamped"),
    params:
        code=code("fig03", "initiate_front"),
        shown=shown("chain/initiation_overdamped"),
    log:
        "<logs>/fig03.log",
    benchmark:
        "<benchmarks>/fig03.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/fig03.py"


rule fig04:
    """Figure 4, section 4.1."""
    input:
        data="<results>/data/continuum/log_burgers_fronts.nc",
        texts="workflow/captions/fig04_log_burgers_fronts.rst",
    output:
        **figure("fig04_log_burgers_fronts"),
    params:
        code=code("fig04", *made_by("continuum/log_burgers_fronts")),
        shown=shown("continuum/log_burgers_fronts"),
    log:
        "<logs>/fig04.log",
    benchmark:
        "<benchmarks>/fig04.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/fig04.py"


rule fig05:
    """Figure 5, section 4.3."""
    input:
        weak="<results>/data/periodic/weak.nc",
        hertz="<results>/data/periodic/hertz.nc",
        texts="workflow/captions/fig05_initial_conditions.rst",
    output:
        **figure("fig05_initial_conditions"),
    params:
        code=code("fig05", "compare_periodic_chain"),
        shown=shown("periodic/weak", "periodic/hertz"),
    log:
        "<logs>/fig05.log",
    benchmark:
        "<benchmarks>/fig05.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/fig05.py"


rule fig06:
    """Figures 6 and 7, section 4.3."""
    input:
        data="<results>/data/periodic/weak.nc",
        texts="workflow/captions/fig06_periodic_chain_weak.rst",
    output:
        **figure("fig06_periodic_chain_weak"),
    params:
        code=code("fig06", "compare_periodic_chain"),
        shown=shown("periodic/weak"),
    log:
        "<logs>/fig06.log",
    benchmark:
        "<benchmarks>/fig06.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/fig06.py"


use rule fig06 as fig07 with:
    input:
        data="<results>/data/periodic/hertz.nc",
        texts="workflow/captions/fig07_periodic_chain_hertz.rst",
    output:
        **figure("fig07_periodic_chain_hertz"),
    params:
        code=code("fig06", "compare_periodic_chain"),
        shown=shown("periodic/hertz"),
    log:
        "<logs>/fig07.log",
    benchmark:
        "<benchmarks>/fig07.tsv"


rule model_error:
    """How far rings are from their amplitude equations, section 4.3."""
    input:
        weak="<results>/data/periodic/weak.nc",
        hertz="<results>/data/periodic/hertz.nc",
        texts="workflow/captions/model_error.rst",
    output:
        **figure("model_error"),
    params:
        code=code("model_error", "compare_periodic_chain"),
        shown=shown("periodic/weak", "periodic/hertz"),
    log:
        "<logs>/model_error.log",
    benchmark:
        "<benchmarks>/model_error.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/model_error.py"


rule fig08:
    """Figure 8, section 5.2."""
    input:
        data="<results>/data/continuum/front_profiles.nc",
        texts="workflow/captions/fig08_heteroclinic.rst",
    output:
        **figure("fig08_heteroclinic"),
    params:
        code=code("fig08", "compute_heteroclinic"),
        shown=shown("continuum/front_profiles"),
    log:
        "<logs>/fig08.log",
    benchmark:
        "<benchmarks>/fig08.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/fig08.py"


rule exact_fronts:
    """Exact fronts by two methods, section 6."""
    input:
        underdamped="<results>/data/fronts/underdamped.nc",
        overdamped="<results>/data/fronts/overdamped.nc",
        texts="workflow/captions/exact_fronts.rst",
    output:
        **figure("exact_fronts"),
    params:
        code=code("exact_fronts", "shoot_front"),
        shown=shown("fronts/underdamped", "fronts/overdamped"),
    log:
        "<logs>/exact_fronts.log",
    benchmark:
        "<benchmarks>/exact_fronts.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/exact_fronts.py"


rule fronts_compared:
    """Exact fronts, the driven chain and continuum fronts, of two scenes."""
    input:
        scenes=data("fronts/overdamped", "fronts/underdamped"),
        texts="workflow/captions/fronts_compared.rst",
    output:
        **figure("fronts_compared"),
    params:
        code=code("fronts_compared", "shoot_front"),
        shown=shown("fronts/overdamped", "fronts/underdamped"),
    log:
        "<logs>/fronts_compared.log",
    benchmark:
        "<benchmarks>/fronts_compared.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/fronts_compared.py"


rule continuum_errors:
    """Errors of continuum fronts over the damping."""
    input:
        data="<results>/data/fronts/survey.nc",
        texts="workflow/captions/continuum_errors.rst",
    output:
        **figure("continuum_errors"),
    params:
        code=code("continuum_errors", *made_by("fronts/survey")),
        shown=shown("fronts/survey"),
    log:
        "<logs>/continuum_errors.log",
    benchmark:
        "<benchmarks>/continuum_errors.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/continuum_errors.py"


rule critical_damping:
    """Critical damping by four definitions, over the overshoot."""
    input:
        data="<results>/data/fronts/critical_damping.nc",
        materials="<results>/data/laws/materials.nc",
        texts="workflow/captions/critical_damping.rst",
    output:
        **figure("critical_damping"),
    params:
        code=code(
            "critical_damping", *made_by("fronts/critical_damping"), *made_by("laws/materials")
        ),
        shown=shown("fronts/critical_damping", "laws/materials"),
    log:
        "<logs>/critical_damping.log",
    benchmark:
        "<benchmarks>/critical_damping.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/critical_damping.py"


rule multipliers:
    """Floquet multipliers of exact fronts."""
    input:
        data="<results>/data/fronts/multipliers.nc",
        texts="workflow/captions/multipliers.rst",
    output:
        **figure("multipliers"),
    params:
        code=code("multipliers", *made_by("fronts/multipliers")),
        shown=shown("fronts/multipliers"),
    log:
        "<logs>/multipliers.log",
    benchmark:
        "<benchmarks>/multipliers.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/multipliers.py"


rule jump_conditions:
    """Jump conditions of section 2, and fronts of any law."""
    input:
        data="<results>/data/laws/jump_conditions.nc",
        texts="workflow/captions/jump_conditions.rst",
    output:
        **figure("jump_conditions"),
    params:
        code=code("jump_conditions", *made_by("laws/jump_conditions")),
        shown=shown("laws/jump_conditions"),
    log:
        "<logs>/jump_conditions.log",
    benchmark:
        "<benchmarks>/jump_conditions.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/jump_conditions.py"


rule damping_regimes:
    """Damping over velocity, equation (29)."""
    input:
        data="<results>/data/laws/damping_regimes.nc",
        texts="workflow/captions/damping_regimes.rst",
    output:
        **figure("damping_regimes"),
    params:
        code=code("damping_regimes", *made_by("laws/damping_regimes")),
        shown=shown("laws/damping_regimes"),
    log:
        "<logs>/damping_regimes.log",
    benchmark:
        "<benchmarks>/damping_regimes.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/damping_regimes.py"


rule numerical_damping:
    """The damping that the θ-method brings."""
    input:
        data="<results>/data/laws/numerical_damping.nc",
        texts="workflow/captions/numerical_damping.rst",
    output:
        **figure("numerical_damping"),
    params:
        code=code("numerical_damping", *made_by("laws/numerical_damping")),
        shown=shown("laws/numerical_damping"),
    log:
        "<logs>/numerical_damping.log",
    benchmark:
        "<benchmarks>/numerical_damping.tsv"
    conda:
        "../envs/main.yaml"
    localrule: True
    script:
        "../scripts/figures/numerical_damping.py"


FIGURES = [
    *(rules.fig01, rules.fig02, rules.fig03, rules.fig04, rules.fig05, rules.fig06, rules.fig07),
    *(rules.model_error, rules.fig08, rules.exact_fronts, rules.fronts_compared),
    *(rules.continuum_errors, rules.critical_damping, rules.multipliers, rules.jump_conditions),
    *(rules.damping_regimes, rules.numerical_damping),
]
"""Of a plain call, in the order of the report."""


rule figures:
    """All figures whose data take seconds."""
    input:
        [figure.output for figure in FIGURES],
