"""Fronts of the amplitude equations, section 5 of the paper."""

CONTINUUM_MODULES = modules("continuum/*.py", "configuration.py", "datasets.py")
HETEROCLINIC_DATASETS = expand(
    "<results>/data/continuum/{scene}.nc", scene=config["scenes"]["heteroclinic"]
)


rule compute_heteroclinic:
    input:
        modules=CONTINUUM_MODULES,
    output:
        dataset="<results>/data/continuum/{scene}.nc",
    params:
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
        "../envs/main.yaml"
    wildcard_constraints:
        scene="|".join(config["scenes"]["heteroclinic"]),
    script:
        "../scripts/compute_heteroclinic.py"
