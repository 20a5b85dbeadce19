"""Amplitude equations and their fronts, section 4 of the paper."""

CONTINUUM_MODULES = modules("continuum/*.py", "slow_scales.py", "datasets.py")
PERIODIC_DATASETS = expand("<results>/data/periodic/{scene}.nc", scene=config["scenes"]["periodic"])


rule evaluate_fronts:
    input:
        modules=CONTINUUM_MODULES,
    output:
        dataset="<results>/data/continuum/log_burgers_fronts.nc",
    params:
        exponents=config["front_exponents"],
    log:
        "<logs>/evaluate_fronts.log",
    benchmark:
        "<benchmarks>/evaluate_fronts.tsv"
    threads: 1
    message:
        "Evaluating fluxes and fronts of the amplitude equations."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/evaluate_fronts.py"


rule compare_periodic_chain:
    input:
        kernels=rules.compile_kernels.output.stamp,
        modules=[*CHAIN_MODULES, *CONTINUUM_MODULES, *modules("comparison.py")],
    output:
        dataset="<results>/data/periodic/{scene}.nc",
    params:
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
        "../envs/main.yaml"
    script:
        "../scripts/compare_periodic_chain.py"
