"""Motions of a finite chain, section 3.3 of the paper."""


# Otherwise jobs that start together would each compile the same kernels.
rule compile_kernels:
    input:
        modules=sources("compile_kernels", "granular_fronts.chain.compilation"),
    output:
        stamp="<results>/kernels.json",
    params:
        wings=["chain"],
    log:
        "<logs>/compile_kernels.log",
    benchmark:
        "<benchmarks>/compile_kernels.tsv"
    threads: 1
    message:
        "Compiling the kernels of the chain."
    conda:
        environment
    script:
        "../scripts/compile_kernels.py"


rule initiate_front:
    input:
        kernels=rules.compile_kernels.output.stamp,
        modules=sources("initiate_front"),
    output:
        dataset="<results>/data/chain/{scene}.nc",
    params:
        scene=lambda wildcards: config["scenes"]["chain"][wildcards.scene],
        scene_id="{scene}",
    log:
        "<logs>/initiate_front/{scene}.log",
    benchmark:
        "<benchmarks>/initiate_front/{scene}.tsv"
    threads: 1
    message:
        "Solving the chain of scene {wildcards.scene}."
    conda:
        environment
    script:
        "../scripts/initiate_front.py"
