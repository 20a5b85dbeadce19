"""How honest the stated errors are: random problems solved again by independent programs."""


rule measure_honesty:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/precision/honesty_{kind}.nc",
    params:
        code=code("measure_honesty", "truth.{wildcards.kind}"),
        kind="{kind}",
        problems=lambda wildcards: config["honesty"][wildcards.kind],
    log:
        "<logs>/measure_honesty/{kind}.log",
    benchmark:
        "<benchmarks>/measure_honesty/{kind}.tsv"
    message:
        "Comparing stated errors with true ones: random {wildcards.kind}."
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        kind="|".join(config["honesty"]),
    script:
        "../scripts/precision/measure_honesty.py"


rule honesty:
    """Stated errors of random problems against true ones, with figure 25."""
    input:
        rules.fig25.input,
    message:
        "Stated and true errors are compared; the next report shows them: {input}."
