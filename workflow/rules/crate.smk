"""The crate of a run, which others can rerun: a Workflow Run RO-Crate."""


include: "project_files.smk"


rule write_crate:
    input:
        files=rules.all.input,
        sources=project_files,
    output:
        archive="<results>/crate.zip",
    params:
        code=code("write_crate"),
        results=subpath(output.archive, parent=True),
        configuration=config,
        scripts=lambda wildcards: {
            one.name: os.path.normpath(os.path.join("workflow/rules", one.script))
            for one in workflow.rules
            if one.script and is_ours(one)
        },
    log:
        "<logs>/write_crate.log",
    benchmark:
        "<benchmarks>/write_crate.tsv"
    message:
        "Writing the crate of the run."
    script:
        "../scripts/report/write_crate.py"


rule crate:
    input:
        rules.write_crate.output,
        rules.all.input,
    message:
        "The crate of the run is written: {input[0]}."
