"""Tests of the finished files; nothing is called done before they pass."""


rule check_results:
    """The tests of the finished files."""
    input:
        tests=sorted(glob("tests/artefacts/*.py")),
        samples="tests/support/figure_samples.py",
        datasets=DATASETS,
        figures=FIGURE_FILES,
        tables=TABLE_FILES,
    output:
        verdict="<results>/checks.txt",
    params:
        code=code("check_results"),
        results=subpath(output.verdict, parent=True),
        configuration=config,
    log:
        "<logs>/check_results.log",
    benchmark:
        "<benchmarks>/check_results.tsv"
    message:
        "Testing the finished files."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tables/check_results.py"
