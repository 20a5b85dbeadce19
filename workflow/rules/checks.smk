"""Tests of the finished files; nothing is called done before they pass."""


rule check_results:
    input:
        tests=sorted(glob("tests/artefacts/*.py")),
        datasets=[
            *CHAIN_DATASETS,
            *PERIODIC_DATASETS,
            *HETEROCLINIC_DATASETS,
            *FRONT_DATASETS,
            *FRONT_SURVEYS,
            *LAWS_DATASETS,
        ],
        figures=FIGURES,
        tables=rules.tables.input,
        modules=sources("check_results"),
    output:
        verdict="<results>/checks.txt",
    params:
        results=subpath(output.verdict, parent=True),
    log:
        "<logs>/check_results.log",
    benchmark:
        "<benchmarks>/check_results.tsv"
    threads: 1
    message:
        "Testing the finished files."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/check_results.py"
