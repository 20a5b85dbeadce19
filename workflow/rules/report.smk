"""One page with figures, captions, tables, configuration and run times."""

# Titles and captions of the tables of the page.
SHOWN_TABLES = {
    table: TABLES[table]
    for table in TABLES
    if table in DEFAULT_TABLES or f"{config['results']}/tables/{table}.json" in ON_DEMAND
}


rule write_report:
    input:
        template="workflow/report/page.html.j2",
        figures=[f"<results>/{stem_of(figure)}.json" for figure in DEFAULT_FIGURES],
        tables=[f"<results>/tables/{name}.json" for name in DEFAULT_TABLES],
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
        texts=lambda wildcards: SHOWN_TABLES,
        results=subpath(output.page, parent=True),
        on_demand=ON_DEMAND,
        parameters=parameters(*default_parameters(config), *datasets_on_demand()),
        contents=contents(ON_DEMAND),
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
