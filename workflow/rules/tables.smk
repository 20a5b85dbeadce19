"""Tables: numbers read from the data, compared with the paper's.

They are listed with their titles and captions in workflow/tables.yaml; a script that writes several
has a rule of its own here.
"""

for table in [name for name, described in TABLES.items() if "script" in described]:

    rule:
        name:
            f"tabulate_{table}"
        input:
            **table_inputs(table),
        output:
            csv=f"<results>/tables/{table}.csv",
            markdown=f"<results>/tables/{table}.md",
        params:
            **table_params(table),
            script=script_file(TABLES[table]["script"]),
        log:
            f"<logs>/tabulate_{table}.log",
        benchmark:
            f"<benchmarks>/tabulate_{table}.tsv"
        message:
            f"Writing the table: {TABLES[table]['title']}."
        conda:
            "../envs/main.yaml"
        script:
            "{params.script}"


rule tabulate_fronts:
    input:
        survey=data_file("fronts/survey"),
    output:
        properties_csv="<results>/tables/front_properties.csv",
        properties_markdown="<results>/tables/front_properties.md",
        errors_csv="<results>/tables/front_errors.csv",
        errors_markdown="<results>/tables/front_errors.md",
    params:
        code=code("tabulate_fronts"),
        parameters=parameters("fronts/survey"),
    log:
        "<logs>/tabulate_fronts.log",
    benchmark:
        "<benchmarks>/tabulate_fronts.tsv"
    message:
        "Tabulating the properties of exact fronts and the errors of continuum fronts."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/fronts/tabulate_fronts.py"


rule ring_limit:
    """Rings of beads as α → 1, with figure 20."""
    input:
        rules.tabulate_ring_limit.output,
        rules.tabulate_ring_orders.output,
        rules.fig20.input,
    message:
        "The limit α → 1 is judged and drawn: {input}."


rule tables:
    """All tables of these figures."""
    input:
        TABLE_FILES,
        DATASETS,
    message:
        "All tables are written."
