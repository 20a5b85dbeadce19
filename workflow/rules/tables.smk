"""Tables, a rule each: numbers read from the data, and compared with the paper's."""


rule tabulate_paper_numbers:
    """Statements, of the paper or our own, with computed numbers, errors and verdicts."""
    input:
        statements="config/paper_numbers.yaml",
        datasets=data(*DATASETS),
    output:
        **table("paper_numbers"),
    params:
        code=code("tabulate_statements", *measured_by("config/paper_numbers.yaml")),
        shown=shown(*DATASETS),
    log:
        "<logs>/tabulate_paper_numbers.log",
    benchmark:
        "<benchmarks>/tabulate_paper_numbers.tsv"
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_statements.py"


use rule tabulate_paper_numbers as tabulate_findings with:
    input:
        statements="config/findings.yaml",
        datasets=data(*DATASETS),
    output:
        **table("findings"),
    params:
        code=code("tabulate_statements", *measured_by("config/findings.yaml")),
        shown=shown(*DATASETS),
    log:
        "<logs>/tabulate_findings.log",
    benchmark:
        "<benchmarks>/tabulate_findings.tsv"


rule tabulate_fronts:
    """Properties of exact fronts, and errors of continuum fronts."""
    input:
        survey="<results>/data/fronts/survey.nc",
    output:
        properties_csv="<results>/tables/front_properties.csv",
        properties_markdown="<results>/tables/front_properties.md",
        errors_csv="<results>/tables/front_errors.csv",
        errors_markdown="<results>/tables/front_errors.md",
    params:
        code=code("tabulate_fronts", *made_by("fronts/survey")),
        shown=shown("fronts/survey"),
    log:
        "<logs>/tabulate_fronts.log",
    benchmark:
        "<benchmarks>/tabulate_fronts.tsv"
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_fronts.py"


rule tabulate_critical_damping:
    """Critical damping by several definitions, over the exponent."""
    input:
        dataset="<results>/data/fronts/critical_damping.nc",
    output:
        **table("critical_damping"),
    params:
        code=code("tabulate_critical_damping", *made_by("fronts/critical_damping")),
        shown=shown("fronts/critical_damping"),
    log:
        "<logs>/tabulate_critical_damping.log",
    benchmark:
        "<benchmarks>/tabulate_critical_damping.tsv"
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_critical_damping.py"


rule tabulate_materials:
    """Glass, steel and cork, remark 6."""
    input:
        dataset="<results>/data/laws/materials.nc",
    output:
        **table("materials"),
    params:
        code=code("tabulate_materials", *made_by("laws/materials")),
        shown=shown("laws/materials"),
    log:
        "<logs>/tabulate_materials.log",
    benchmark:
        "<benchmarks>/tabulate_materials.tsv"
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_materials.py"


rule tabulate_jump_conditions:
    """Speed, velocity jump and power of fronts for several laws, section 2."""
    input:
        dataset="<results>/data/laws/jump_conditions.nc",
    output:
        **table("jump_conditions"),
    params:
        code=code("tabulate_jump_conditions", *made_by("laws/jump_conditions")),
        shown=shown("laws/jump_conditions"),
    log:
        "<logs>/tabulate_jump_conditions.log",
    benchmark:
        "<benchmarks>/tabulate_jump_conditions.tsv"
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_jump_conditions.py"


TABLES = [
    *(rules.tabulate_paper_numbers, rules.tabulate_findings, rules.tabulate_fronts),
    *(rules.tabulate_critical_damping, rules.tabulate_materials, rules.tabulate_jump_conditions),
]
"""Of a plain call, in the order of the report."""


rule tables:
    """All tables of these figures."""
    input:
        [table.output for table in TABLES],
