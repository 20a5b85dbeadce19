"""One page with figures, captions, tables, configuration and run times."""

# Titles and texts of the figures and tables of the page, by the stem of their files.
SHOWN_FIGURES = {
    stem_of(figure): FIGURES[figure]
    for figure in FIGURES
    if figure in DEFAULT_FIGURES or stem_of(figure) in ON_DEMAND
}
SHOWN_TABLES = {
    f"tables/{table}": TABLES[table]
    for table in TABLES
    if table in DEFAULT_TABLES or f"tables/{table}" in ON_DEMAND
}


rule write_report:
    input:
        template="workflow/report/page.html.j2",
        files=FIGURE_FILES + TABLE_FILES,
        datasets=DATASETS,
        benchmarks=[
            rules.compile_kernels.benchmark,
            rules.compile_continuum_kernels.benchmark,
            rules.compile_front_kernels.benchmark,
            expand(rules.initiate_front.benchmark, scene=config["scenes"]["chain"]),
            expand(rules.compute_heteroclinic.benchmark, scene=config["scenes"]["heteroclinic"]),
            expand(rules.compare_periodic_chain.benchmark, scene=config["scenes"]["periodic"]),
            expand(rules.shoot_front.benchmark, scene=config["scenes"]["front"]),
            STUDY_BENCHMARKS,
            rules.tabulate_fronts.benchmark,
            rules.tabulate_critical_damping.benchmark,
            [f"<benchmarks>/plot_{figure}.tsv" for figure in DEFAULT_FIGURES],
            rules.tabulate_materials.benchmark,
            rules.tabulate_jump_conditions.benchmark,
            rules.tabulate_paper_numbers.benchmark,
            rules.tabulate_findings.benchmark,
            rules.check_results.benchmark,
        ],
        verdict=rules.check_results.output.verdict,
    output:
        page="<results>/report.html",
    params:
        code=code("write_report"),
        configuration=config,
        figures=lambda wildcards: SHOWN_FIGURES,
        tables=lambda wildcards: SHOWN_TABLES,
        results=subpath(output.page, parent=True),
        contents=contents(file for files in ON_DEMAND.values() for file in files),
    log:
        "<logs>/write_report.log",
    benchmark:
        "<benchmarks>/write_report.tsv"
    message:
        "Writing the report."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/report/write_report.py"


rule report:
    """One page with figures, tables, configuration and run times."""
    input:
        rules.write_report.output,
        # A page is not up to date while something that it shows is missing.
        FIGURE_FILES,
        TABLE_FILES,
        DATASETS,
    message:
        "The report is written: {input[0]}."
