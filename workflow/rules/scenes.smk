"""Scenes of the configuration, a dataset each."""


rule initiate_front:
    """A chain that pressure, a piston or a striker sets in motion, section 3.3."""
    input:
        kernels("chain"),
    output:
        dataset="<results>/data/chain/{scene}.nc",
    params:
        code=code("initiate_front"),
        scene=scene("chain"),
    log:
        "<logs>/initiate_front/{scene}.log",
    benchmark:
        "<benchmarks>/initiate_front/{scene}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        scene="|".join(config["scenes"]["chain"]),
    # Before studies, because a newcomer waits for figure 1.
    priority: 2
    script:
        "../scripts/initiate_front.py"


rule compare_periodic_chain:
    """A ring of beads, and the amplitude equations from the same start, section 4."""
    input:
        kernels("chain", "continuum", "reference_methods"),
    output:
        dataset="<results>/data/periodic/{scene}.nc",
    params:
        code=code("compare_periodic_chain"),
        scene=scene("periodic"),
    log:
        "<logs>/compare_periodic_chain/{scene}.log",
    benchmark:
        "<benchmarks>/compare_periodic_chain/{scene}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        scene="|".join(config["scenes"]["periodic"]),
    priority: 1
    script:
        "../scripts/compare_periodic_chain.py"


rule compute_heteroclinic:
    """Stationary fronts of the logarithmic KdV–Burgers equation, section 5."""
    input:
        kernels("continuum"),
    output:
        dataset="<results>/data/continuum/{scene}.nc",
    params:
        code=code("compute_heteroclinic"),
        scene=scene("heteroclinic"),
    log:
        "<logs>/compute_heteroclinic/{scene}.log",
    benchmark:
        "<benchmarks>/compute_heteroclinic/{scene}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        scene="|".join(config["scenes"]["heteroclinic"]),
    script:
        "../scripts/compute_heteroclinic.py"


rule shoot_front:
    """An exact front of the lattice by two methods, and what approximates it, section 6."""
    input:
        kernels("chain", "fronts"),
    output:
        dataset="<results>/data/fronts/{scene}.nc",
    params:
        code=code("shoot_front"),
        scene=scene("front"),
    log:
        "<logs>/shoot_front/{scene}.log",
    benchmark:
        "<benchmarks>/shoot_front/{scene}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        scene="|".join(config["scenes"]["front"]),
    script:
        "../scripts/shoot_front.py"
