"""Tests of the finished files; nothing is called done before they pass."""


rule check_results:
    input:
        tests=sorted(glob("tests/artefacts/*.py")),
        datasets=CHAIN_DATASETS + PERIODIC_DATASETS + HETEROCLINIC_DATASETS + LAWS_DATASETS,
        figures=FIGURES,
        tables=[
            rules.tabulate_paper_numbers.output,
            rules.tabulate_materials.output,
            rules.tabulate_jump_conditions.output,
        ],
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
