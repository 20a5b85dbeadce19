"""The tests of the finished files, and one page with figures, tables, configuration and times."""

# Texts of all that the page shows, in its order.
TEXTS = [
    *(figure.input.texts for figure in FIGURES),
    "workflow/captions/table_paper_numbers.rst",
    "workflow/captions/table_findings.rst",
    "workflow/captions/table_front_errors.rst",
    "workflow/captions/table_front_properties.rst",
    "workflow/captions/table_critical_damping.rst",
    "workflow/captions/table_materials.rst",
    "workflow/captions/table_jump_conditions.rst",
]


# Of projects the page shows what is there when the workflow starts, and never causes a computation.
PROJECT_TEXTS = [
    texts
    for texts in sorted(glob("projects/*/captions/*.rst"))
    if all(file.exists() for file in files_of(texts, config["results"]))
]


rule check_results:
    """The tests of the finished files; nothing is called done before they pass."""
    input:
        tests=sorted(glob("tests/artefacts/*.py")),
        datasets=data(*DATASETS),
        figures=rules.figures.input,
        tables=rules.tables.input,
    output:
        verdict="<results>/checks.txt",
    params:
        code=code("check_results"),
        results=subpath(output.verdict, parent=True),
        datasets={name: [parameters(name), parameters(name, DEFAULTS)] for name in DATASETS},
        figures=[Path(figure.input.texts).stem for figure in FIGURES],
    log:
        "<logs>/check_results.log",
    benchmark:
        "<benchmarks>/check_results.tsv"
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/check_results.py"


rule report:
    """One page with figures, tables, configuration and run times."""
    input:
        template="workflow/page.html.j2",
        texts=TEXTS,
        files=[rules.figures.input, rules.tables.input],
        benchmarks=[
            expand(rules.compile_kernels.benchmark, package=BELOW),
            expand(rules.initiate_front.benchmark, scene=config["scenes"]["chain"]),
            expand(rules.compare_periodic_chain.benchmark, scene=config["scenes"]["periodic"]),
            expand(rules.compute_heteroclinic.benchmark, scene=config["scenes"]["heteroclinic"]),
            expand(rules.shoot_front.benchmark, scene=config["scenes"]["front"]),
            expand(rules.study.benchmark, dataset=STUDIES),
            [one.benchmark for one in FIGURES + TABLES],
            rules.check_results.benchmark,
        ],
        verdict=rules.check_results.output.verdict,
    output:
        page="<results>/report.html",
    params:
        code=code("write_report"),
        configuration=config,
        texts=TEXTS + PROJECT_TEXTS,
        results=subpath(output.page, parent=True),
        contents=contents(PROJECT_TEXTS, config["results"]),
    log:
        "<logs>/report.log",
    benchmark:
        "<benchmarks>/report.tsv"
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/write_report.py"
