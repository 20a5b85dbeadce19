"""Figures of the paper: each rule draws what the data hold and computes nothing."""


rule plot_fig01:
    input:
        dataset="<results>/data/chain/initiation_underdamped.nc",
        modules=modules("drawing.py", "style.py"),
    output:
        pdf="<results>/figures/fig01_initiation_underdamped.pdf",
        png="<results>/figures/fig01_initiation_underdamped.png",
    log:
        "<logs>/plot_fig01.log",
    benchmark:
        "<benchmarks>/plot_fig01.tsv"
    threads: 1
    message:
        "Drawing figure 1: the front starts and becomes steady, weak damping."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig01.py"


rule plot_fig02:
    input:
        dataset="<results>/data/chain/initiation_underdamped.nc",
        modules=modules("drawing.py", "style.py"),
    output:
        pdf="<results>/figures/fig02_spacetime_underdamped.pdf",
        png="<results>/figures/fig02_spacetime_underdamped.png",
    log:
        "<logs>/plot_fig02.log",
    benchmark:
        "<benchmarks>/plot_fig02.tsv"
    threads: 1
    message:
        "Drawing figure 2: space–time diagrams, weak damping."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig02.py"


rule plot_fig03:
    input:
        dataset="<results>/data/chain/initiation_overdamped.nc",
        modules=modules("drawing.py", "style.py"),
    output:
        pdf="<results>/figures/fig03_initiation_overdamped.pdf",
        png="<results>/figures/fig03_initiation_overdamped.png",
    log:
        "<logs>/plot_fig03.log",
    benchmark:
        "<benchmarks>/plot_fig03.tsv"
    threads: 1
    message:
        "Drawing figure 3: the front starts and crosses the chain, strong damping."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig03.py"


rule plot_fig08:
    input:
        dataset="<results>/data/continuum/front_profiles.nc",
        modules=modules("style.py"),
    output:
        pdf="<results>/figures/fig08_heteroclinic.pdf",
        png="<results>/figures/fig08_heteroclinic.png",
    log:
        "<logs>/plot_fig08.log",
    benchmark:
        "<benchmarks>/plot_fig08.tsv"
    threads: 1
    message:
        "Drawing figure 8: the heteroclinic orbit."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig08.py"


FIGURE_RULES = {
    "fig01": rules.plot_fig01,
    "fig02": rules.plot_fig02,
    "fig03": rules.plot_fig03,
    "fig08": rules.plot_fig08,
}
FIGURES = [rule.output for rule in FIGURE_RULES.values()]


rule figures:
    input:
        FIGURES,
    message:
        "All figures are drawn."


rule fig01:
    input:
        rules.plot_fig01.output,
    message:
        "Figure 1 is drawn."


rule fig02:
    input:
        rules.plot_fig02.output,
    message:
        "Figure 2 is drawn."


rule fig03:
    input:
        rules.plot_fig03.output,
    message:
        "Figure 3 is drawn."


rule fig08:
    input:
        rules.plot_fig08.output,
    message:
        "Figure 8 is drawn."
