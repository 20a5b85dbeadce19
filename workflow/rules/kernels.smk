"""Compiled kernels; otherwise jobs that start together would each compile the same ones."""

# What a package imports is compiled before it.
BELOW = {"chain": [], "continuum": [], "reference_methods": [], "fronts": ["continuum"]}


rule compile_kernels:
    """Kernels of one package, which several jobs share."""
    input:
        lambda wildcards: kernels(*BELOW[wildcards.package]),
    output:
        stamp="<results>/kernels/{package}.json",
    params:
        code=code("compile_kernels", "granular_fronts.{wildcards.package}.compilation"),
    log:
        "<logs>/kernels/{package}.log",
    benchmark:
        "<benchmarks>/kernels/{package}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        package="|".join(BELOW),
    priority: 3
    script:
        "../scripts/compile_kernels.py"
