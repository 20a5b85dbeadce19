"""Tables: numbers read from the data, set beside those the paper prints.

They are listed with their titles and captions in workflow/tables.yaml.
"""

# Statements name functions of these modules.
MEASURES = [name for name in MODULES if name.endswith("measures")]


rule tabulate_paper_numbers:
    input:
        statements=project("config", "paper_numbers.yaml"),
        datasets=DATASETS,
    output:
        csv="<results>/tables/paper_numbers.csv",
        markdown="<results>/tables/paper_numbers.md",
        record="<results>/tables/paper_numbers.json",
    params:
        code=code("tabulate_statements", *MEASURES),
        reference=reference(*questions(config)),
        asked=asked(*questions(config)),
    log:
        "<logs>/tabulate_paper_numbers.log",
    benchmark:
        "<benchmarks>/tabulate_paper_numbers.tsv"
    threads: 1
    message:
        "Comparing the numbers and words of the paper with ours."
    conda:
        environment
    script:
        "../scripts/tabulate_statements.py"


rule tabulate_findings:
    input:
        statements=project("config", "findings.yaml"),
        datasets=DATASETS,
    output:
        csv="<results>/tables/findings.csv",
        markdown="<results>/tables/findings.md",
        record="<results>/tables/findings.json",
    params:
        code=code("tabulate_statements", *MEASURES),
        reference=reference(*questions(config)),
        asked=asked(*questions(config)),
    log:
        "<logs>/tabulate_findings.log",
    benchmark:
        "<benchmarks>/tabulate_findings.tsv"
    threads: 1
    message:
        "Judging our own checks and findings."
    conda:
        environment
    script:
        "../scripts/tabulate_statements.py"


rule tabulate_ring_limit:
    input:
        statements=project("config", "ring_limit.yaml"),
        datasets=[data_file(campaign) for campaign in TABLES["ring_limit"]["data"]],
    output:
        csv="<results>/tables/ring_limit.csv",
        markdown="<results>/tables/ring_limit.md",
        record="<results>/tables/ring_limit.json",
    params:
        code=code("tabulate_statements", *MEASURES),
        reference=reference(*TABLES["ring_limit"]["data"]),
        asked=asked(*TABLES["ring_limit"]["data"]),
    log:
        "<logs>/tabulate_ring_limit.log",
    benchmark:
        "<benchmarks>/tabulate_ring_limit.tsv"
    threads: 1
    message:
        "Judging the limit α → 1 on rings."
    conda:
        environment
    script:
        "../scripts/tabulate_statements.py"


rule ring_limit:
    input:
        rules.tabulate_ring_limit.output,
        rules.fig20.input,
        rules.fig21.input,
    message:
        "The limit α → 1 is judged and drawn: {input}."


rule tables:
    input:
        WRITTEN_FILES,
        DATASETS,
    message:
        "All tables are written."
