"""Studies: a dataset each, by the function that workflow/studies.yaml names."""

from granular_fronts.scenes.study import studies

for study, described in (studies() | listed_in_papers("studies")).items():

    rule:
        name:
            f"study_{study}"
        input:
            kernels=stamps(described.get("kernels", [])),
        output:
            dataset=data_file(f"{described['folder']}/{study}"),
        params:
            code=code("study", described["function"].rpartition(".")[0]),
            function=described["function"],
            study=study,
            section=parameters_of(f"{described['folder']}/{study}"),
        log:
            f"<logs>/study/{study}.log",
        benchmark:
            f"<benchmarks>/study/{study}.tsv"
        message:
            described["message"]
        conda:
            "../envs/main.yaml"
        priority: described.get("priority", 0)
        script:
            "../scripts/study.py"


# Of the studies that a plain call makes.
STUDY_BENCHMARKS = expand("<benchmarks>/study/{study}.tsv", study=studies())
