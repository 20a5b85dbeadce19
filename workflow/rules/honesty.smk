"""How honest the stated errors are: random problems solved again by independent programs."""


rule measure_honesty:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/precision/honesty_{wing}.nc",
    params:
        code=code("measure_honesty", "truth.{wildcards.wing}"),
        wing="{wing}",
        problems=lambda wildcards: config["honesty"][wildcards.wing],
    log:
        "<logs>/measure_honesty/{wing}.log",
    benchmark:
        "<benchmarks>/measure_honesty/{wing}.tsv"
    message:
        "Comparing stated errors with true ones: random {wildcards.wing}."
    wildcard_constraints:
        wing="|".join(config["honesty"]),
    script:
        "../scripts/precision/measure_honesty.py"


rule honesty:
    input:
        rules.fig25.input,
    message:
        "Stated and true errors are compared; the next report shows them: {input}."
