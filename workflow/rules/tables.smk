"""Tables: numbers read from the data, set beside those the paper prints.

They are listed with their titles and captions in workflow/tables.yaml.
"""

# The list of printed numbers names functions of these modules.
MEASURES = [name for name in MODULES if name.endswith(".measures")]


rule tabulate_paper_numbers:
    input:
        numbers="config/paper_numbers.yaml",
        datasets=DATASETS,
        modules=sources("tabulate_paper_numbers", *MEASURES),
    output:
        csv="<results>/tables/paper_numbers.csv",
        markdown="<results>/tables/paper_numbers.md",
        record="<results>/tables/paper_numbers.json",
    params:
        asked=asked(*questions(config)),
    log:
        "<logs>/tabulate_paper_numbers.log",
    benchmark:
        "<benchmarks>/tabulate_paper_numbers.tsv"
    threads: 1
    message:
        "Comparing the numbers printed in the paper with ours."
    conda:
        environment
    script:
        "../scripts/tabulate_paper_numbers.py"


rule tables:
    input:
        WRITTEN_FILES,
        DATASETS,
    message:
        "All tables are written."
