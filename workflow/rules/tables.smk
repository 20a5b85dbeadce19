"""Tables: numbers read from the data, set beside those the paper prints."""

# Statements name functions of these modules.
MEASURES = [name for name in MODULES if name.endswith(".measures")]

MEASURED_DATASETS = (
    CHAIN_DATASETS
    + PERIODIC_DATASETS
    + HETEROCLINIC_DATASETS
    + FRONT_DATASETS
    + LAWS_DATASETS
    + [
        rules.evaluate_fronts.output.dataset,
        rules.map_critical_damping.output.dataset,
        rules.follow_trends.output.dataset,
    ]
)


rule tabulate_paper_numbers:
    input:
        statements="config/paper_numbers.yaml",
        reference="config/default.yaml",
        datasets=MEASURED_DATASETS,
        modules=sources("tabulate_statements", *MEASURES),
    output:
        csv="<results>/tables/paper_numbers.csv",
        markdown="<results>/tables/paper_numbers.md",
    log:
        "<logs>/tabulate_paper_numbers.log",
    benchmark:
        "<benchmarks>/tabulate_paper_numbers.tsv"
    threads: 1
    message:
        "Comparing the numbers and words of the paper with ours."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_statements.py"


rule tabulate_findings:
    input:
        statements="config/findings.yaml",
        reference="config/default.yaml",
        datasets=MEASURED_DATASETS,
        modules=sources("tabulate_statements", *MEASURES),
    output:
        csv="<results>/tables/findings.csv",
        markdown="<results>/tables/findings.md",
    log:
        "<logs>/tabulate_findings.log",
    benchmark:
        "<benchmarks>/tabulate_findings.tsv"
    threads: 1
    message:
        "Judging our own checks and findings."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_statements.py"


rule tables:
    input:
        rules.tabulate_paper_numbers.output,
        rules.tabulate_findings.output,
        rules.tabulate_materials.output,
        rules.tabulate_fronts.output,
        rules.tabulate_critical_damping.output,
        rules.tabulate_jump_conditions.output,
    message:
        "All tables are written."
