"""What projects have in common: datasets, statements on them, and their verdicts."""


rule project_study:
    """A dataset of a project, by a function of its folder."""
    input:
        kernels("chain", "fronts"),
    output:
        dataset="<results>/data/{study}.nc",
    params:
        code=lambda wildcards: digest_of(
            "project_study", MADE_BY[wildcards.study][0].partition(".")[0]
        ),
        made_by=lambda wildcards: MADE_BY[wildcards.study][0],
        settings=lambda wildcards: MADE_BY[wildcards.study][1],
    log:
        "<logs>/{study}.log",
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        study=one_of(MADE_BY),
    script:
        "../scripts/project_study.py"


rule project_statements:
    """Statements of a project with computed numbers, errors and verdicts."""
    input:
        statements="projects/{project}/statements.yaml",
        datasets=lambda wildcards: data(
            *(f"{wildcards.project}/{scene}" for scene in JUDGED[wildcards.project])
        ),
    output:
        **table("{project}_statements"),
    params:
        code=lambda wildcards, input: digest_of(
            "tabulate_statements", *measured_by(input.statements)
        ),
        shown=lambda wildcards: JUDGED[wildcards.project],
    log:
        "<logs>/{project}/statements.log",
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        project=one_of(JUDGED),
    script:
        "../scripts/tabulate_statements.py"


rule project_verdicts:
    """Whether each verdict is the expected one."""
    input:
        tables=["<results>/tables/{project}_statements.csv"],
    output:
        verdict="<results>/{project}.txt",
    params:
        code=code("check_verdicts"),
    log:
        "<logs>/{project}/verdicts.log",
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        project=one_of(JUDGED),
    localrule: True
    script:
        "../scripts/check_verdicts.py"
