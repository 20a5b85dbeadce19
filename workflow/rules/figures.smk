"""Figures: each rule draws what the data hold and computes nothing.

They are listed in workflow/figures.yaml; each is a target of its own, fig01 for example.
"""

for figure in FIGURES:

    rule:
        name:
            f"plot_{figure}"
        input:
            **figure_inputs(figure),
            template=template_of(figure),
        output:
            pdf=f"<results>/{stem_of(figure)}.pdf",
            png=report(
                f"<results>/{stem_of(figure)}.png",
                caption=os.path.abspath(f"{config['results']}/{stem_of(figure)}.rst"),
                category="Figures",
                labels={"figure": number_of(figure), "title": FIGURES[figure]["title"]},
            ),
            caption=f"<results>/{stem_of(figure)}.rst",
        params:
            code=code("figure_step", script_of(figure)),
            script=script_of(figure),
            reference=reference(*datasets_of(figure)),
            parameters=parameters(*datasets_of(figure)),
        log:
            f"<logs>/plot_{figure}.log",
        benchmark:
            f"<benchmarks>/plot_{figure}.tsv"
        message:
            f"Drawing figure {number_of(figure)}: {FIGURES[figure]['title']}."
        conda:
            "../envs/main.yaml"
        localrule: True
        script:
            "../lib/figure_step.py"

    rule:
        """One figure with what it needs."""
        name:
            figure
        input:
            figure_files(figure),
            [data_file(dataset) for dataset in datasets_of(figure)],
            campaign_chunks_behind(figure),
        message:
            f"Figure {number_of(figure)} is drawn."


rule real_chains:
    """A striker on chains of unlike beads, and a driven chain: figure 26."""
    input:
        rules.fig26.input,
    message:
        "Chains of unlike beads are drawn; the next report shows them: {input}."


rule figures:
    """All figures whose data do not take minutes; the others have targets of their own."""
    input:
        FIGURE_FILES,
        [data_file(dataset) for figure in DEFAULT_FIGURES for dataset in datasets_of(figure)],
    message:
        "All figures are drawn."
