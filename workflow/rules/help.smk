"""What can be asked for by name, in words: `snakemake help`."""

TARGETS_IN_WORDS = {
    "all": "The report and the tests of all finished files; made when no target is named.",
    "figures": "All figures whose data do not take minutes; the others have targets of their own.",
    "tables": "All tables of these figures.",
    "report": "One page with figures, tables, configuration and run times.",
    "check_results": "The tests of the finished files.",
    "animation": "A front in motion, as a moving picture and a still.",
    "precision": "Time against error of all solvers, with figures 14 and 14b; minutes on a quiet machine.",
    "hard_cases": "Problems at the edge, with figure 15.",
    "honesty": "Stated errors of random problems against true ones, with figure 25.",
    "proofs": "Fronts proved by ball arithmetic, with figures 23 and 24; takes long.",
    "certificates": "An archive of all certificates of fronts, with their SHA-256 sums; takes long.",
    "referee": "Problems with accurate answers for discrete-element codes.",
    "ring_limit": "Rings of beads as α → 1, with figures 20 to 21b.",
    "real_chains": "A striker on chains of unlike beads, with figures 26 to 29.",
    "campaign": "A grid of parameter points; add --config campaign=NAME, a file of config/campaigns.",
    "papers": "What this project makes of papers of others.",
    "help": "This list.",
}


TARGETS_IN_WORDS |= {f"papers/{name}": f"{paper['title']}." for name, paper in papers().items()}


# A figure has the words of the rule that draws it.
TARGETS_IN_WORDS |= {
    drawing.name.removeprefix("plot_"): drawing.message.replace("Drawing figure", "Figure")
    for drawing in workflow.rules
    if drawing.name.startswith("plot_")
}


rule help:
    message:
        "\n".join(
            [
                "name one or more targets, for example: snakemake -c2 fig01 tables",
                *(f"  {target:14} {words}" for target, words in TARGETS_IN_WORDS.items()),
                "after --configfile or --config, put -- before the targets.",
                "any other name ends in Snakemake's own sentence, a MissingRuleException.",
            ]
        )
    localrule: True
