"""Tables: numbers read from the data, set beside those the paper prints."""

# The list of printed numbers names functions of these modules.
MEASURES = [name for name in MODULES if name.endswith(".measures")]


rule tabulate_paper_numbers:
    input:
        numbers="config/paper_numbers.yaml",
        datasets=CHAIN_DATASETS
        + PERIODIC_DATASETS
        + HETEROCLINIC_DATASETS
        + FRONT_DATASETS
        + LAWS_DATASETS,
        modules=sources("tabulate_paper_numbers", *MEASURES),
    output:
        csv="<results>/tables/paper_numbers.csv",
        markdown="<results>/tables/paper_numbers.md",
    log:
        "<logs>/tabulate_paper_numbers.log",
    benchmark:
        "<benchmarks>/tabulate_paper_numbers.tsv"
    threads: 1
    message:
        "Comparing the numbers printed in the paper with ours."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_paper_numbers.py"


rule tables:
    input:
        rules.tabulate_paper_numbers.output,
        rules.tabulate_materials.output,
        rules.tabulate_fronts.output,
        rules.tabulate_critical_damping.output,
        rules.tabulate_jump_conditions.output,
    message:
        "All tables are written."
