"""A page on which motions and fronts are explored: snakemake -c2 explore."""

# What moves over space and time in a way that the page can show.
EXPLORED = [
    f"{folder}/{scene}"
    for folder in ("chain", "periodic")
    for scene, described in config["scenes"][folder].items()
    if "grid" in described["record"]
]
EXPLORER_SCRIPTS = ["shared", "chain", "motions", "fronts"]
EXPLORED_FRONTS = ["fronts/collection", "fronts/critical_damping"]


rule write_explorer:
    input:
        template=project("workflow/report/explorer/page.html.j2"),
        scripts=[project(f"workflow/report/explorer/{script}.js") for script in EXPLORER_SCRIPTS],
        motions=[data_file(motion) for motion in EXPLORED],
        collection=rules.study_collection.output.dataset,
        plane=rules.study_critical_damping.output.dataset,
    output:
        page="<results>/explore.html",
        provenance="<results>/explore.json",
    params:
        code=code("write_explorer"),
        parameters=parameters(*EXPLORED, *EXPLORED_FRONTS),
    log:
        "<logs>/write_explorer.log",
    benchmark:
        "<benchmarks>/write_explorer.tsv"
    message:
        "Writing the page to explore motions and fronts."
    script:
        "../scripts/report/write_explorer.py"


rule explore:
    input:
        rules.write_explorer.output.page,
        [data_file(dataset) for dataset in [*EXPLORED, *EXPLORED_FRONTS]],
    message:
        "Open {input[0]} in a browser."
