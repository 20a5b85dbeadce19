"""Amplitude equations beside a chain, section 4 of the paper, and their fronts, section 5."""


rule compile_continuum_kernels:
    output:
        stamp="<results>/continuum_kernels.json",
    params:
        code=code(
            "compile_kernels",
            "granular_fronts.continuum.compilation",
            "granular_fronts.reference_methods.compilation",
        ),
        wings=["continuum", "reference_methods"],
    log:
        "<logs>/compile_continuum_kernels.log",
    benchmark:
        "<benchmarks>/compile_continuum_kernels.tsv"
    threads: 1
    message:
        "Compiling the kernels of the amplitude equations."
    conda:
        environment
    priority: 3
    script:
        "../scripts/compile_kernels.py"


rule compute_heteroclinic:
    input:
        kernels=rules.compile_continuum_kernels.output.stamp,
    output:
        dataset="<results>/data/continuum/{scene}.nc",
    params:
        code=code("compute_heteroclinic"),
        scene=lambda wildcards: config["scenes"]["heteroclinic"][wildcards.scene],
        scene_id="{scene}",
    log:
        "<logs>/compute_heteroclinic/{scene}.log",
    benchmark:
        "<benchmarks>/compute_heteroclinic/{scene}.tsv"
    threads: 1
    message:
        "Computing the heteroclinic orbits of scene {wildcards.scene}."
    conda:
        environment
    wildcard_constraints:
        scene="|".join(config["scenes"]["heteroclinic"]),
    script:
        "../scripts/compute_heteroclinic.py"


rule evaluate_fronts:
    output:
        dataset="<results>/data/continuum/log_burgers_fronts.nc",
    params:
        code=code("evaluate_fronts"),
        exponents=config["front_exponents"],
    log:
        "<logs>/evaluate_fronts.log",
    benchmark:
        "<benchmarks>/evaluate_fronts.tsv"
    threads: 1
    message:
        "Evaluating fluxes and fronts of the amplitude equations."
    conda:
        environment
    script:
        "../scripts/evaluate_fronts.py"


rule compare_periodic_chain:
    input:
        kernels=[
            rules.compile_kernels.output.stamp,
            rules.compile_continuum_kernels.output.stamp,
        ],
    output:
        dataset="<results>/data/periodic/{scene}.nc",
    params:
        code=code("compare_periodic_chain"),
        scene=lambda wildcards: config["scenes"]["periodic"][wildcards.scene],
        scene_id="{scene}",
    log:
        "<logs>/compare_periodic_chain/{scene}.log",
    benchmark:
        "<benchmarks>/compare_periodic_chain/{scene}.tsv"
    threads: 1
    message:
        "Solving the ring of scene {wildcards.scene} and its amplitude equations."
    conda:
        environment
    priority: 1
    script:
        "../scripts/compare_periodic_chain.py"
