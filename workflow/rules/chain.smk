"""Motions of a finite chain, section 3.3 of the paper."""


# Otherwise jobs that start together would each compile the same kernels.
rule compile_kernels:
    output:
        stamp="<results>/kernels.json",
    params:
        code=code("compile_kernels", "granular_fronts.chain.compilation"),
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
    priority: 3
    script:
        "../scripts/compile_kernels.py"


rule initiate_front:
    input:
        kernels=rules.compile_kernels.output.stamp,
    output:
        dataset="<results>/data/chain/{scene}.nc",
    params:
        code=code("initiate_front"),
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
