"""One page with figures, captions, tables, configuration and run times."""

# Speed is measured only on demand, by the target precision. The page shows what is there when the
# workflow starts: as files that no rule is asked for, so that the page never causes a measurement.
SPEED_FILES = [
    file
    for name in [
        "figures/fig14_speed_error.png",
        "tables/speed_verdicts.csv",
        "tables/speed_error.csv",
    ]
    if os.path.exists(file := os.path.join(config["results"], name))
]


rule write_report:
    input:
        template="workflow/report/page.html.j2",
        figures=[rule.output.png for rule in FIGURE_RULES.values()],
        captions=expand("workflow/report/{figure}.rst", figure=FIGURE_RULES),
        speed_caption="workflow/report/fig14.rst",
        tables=[
            rules.tabulate_paper_numbers.output.csv,
            rules.tabulate_fronts.output.errors_csv,
            rules.tabulate_critical_damping.output.csv,
            rules.tabulate_materials.output.csv,
            rules.tabulate_jump_conditions.output.csv,
        ],
        benchmarks=[
            rules.compile_kernels.benchmark,
            rules.compile_continuum_kernels.benchmark,
            rules.compile_front_kernels.benchmark,
            expand(rules.initiate_front.benchmark, scene=config["scenes"]["chain"]),
            expand(rules.compute_heteroclinic.benchmark, scene=config["scenes"]["heteroclinic"]),
            rules.evaluate_fronts.benchmark,
            expand(rules.compare_periodic_chain.benchmark, scene=config["scenes"]["periodic"]),
            expand(rules.shoot_front.benchmark, scene=config["scenes"]["front"]),
            rules.survey_fronts.benchmark,
            rules.map_critical_damping.benchmark,
            rules.compute_multipliers.benchmark,
            rules.tabulate_fronts.benchmark,
            rules.tabulate_critical_damping.benchmark,
            [rule.benchmark for rule in FIGURE_RULES.values()],
            rules.evaluate_materials.benchmark,
            rules.evaluate_damping_regimes.benchmark,
            rules.measure_numerical_damping.benchmark,
            rules.measure_pistons.benchmark,
            rules.check_jump_conditions.benchmark,
            rules.tabulate_materials.benchmark,
            rules.tabulate_jump_conditions.benchmark,
            rules.tabulate_paper_numbers.benchmark,
            rules.check_results.benchmark,
        ],
        verdict=rules.check_results.output.verdict,
        modules=sources("write_report"),
    output:
        page="<results>/report.html",
    params:
        configuration=config,
        speed=SPEED_FILES,
        speed_contents=contents(SPEED_FILES),
    log:
        "<logs>/write_report.log",
    benchmark:
        "<benchmarks>/write_report.tsv"
    threads: 1
    message:
        "Writing the report."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/write_report.py"


rule report:
    input:
        rules.write_report.output,
    message:
        "The report is written: {input}."
