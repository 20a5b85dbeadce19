"""A front in motion, for the README; a target of its own, since no figure needs it."""


rule animate_front:
    input:
        dataset="<results>/data/chain/initiation_underdamped.nc",
    output:
        gif="<results>/animation/front.gif",
        pdf="<results>/animation/front.pdf",
        png="<results>/animation/front.png",
        provenance="<results>/animation/front.json",
    params:
        code=code("animate_front"),
        parameters=parameters("chain/initiation_underdamped"),
    log:
        "<logs>/animate_front.log",
    benchmark:
        "<benchmarks>/animate_front.tsv"
    message:
        "Drawing a front in motion."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/figures/animate_front.py"


rule animation:
    """A front in motion, as a moving picture and a still."""
    input:
        rules.animate_front.output,
    message:
        "The moving picture is drawn: {input[0]}."
