"""Scenes, a dataset each; in brackets the section of the paper.

They are chains (3.3), rings and their amplitude equations (4), heteroclinic orbits (5) and exact
fronts of the lattice (6).
"""

# For each family: the rule and its script, the packages whose kernels it needs, its priority, its words.
SOLVED_BY = {
    "chain": ("initiate_front", ["chain"], 0, "Solving the chain"),
    "periodic": (
        "compare_periodic_chain",
        ["chain", "continuum"],
        1,
        "Solving the ring and the amplitude equations",
    ),
    "heteroclinic": ("compute_heteroclinic", ["continuum"], 0, "Computing the heteroclinic orbits"),
    "front": ("shoot_front", ["fronts"], 0, "Solving the exact front, and what approximates it,"),
}


def scenes_of(family):
    """Return the scenes of a family by name, also those of papers."""
    return config["scenes"][family] | scenes_of_papers(family)


def scene_of(family):
    """Return a function for `params`: the scene that the wildcard names."""
    return lambda wildcards: scenes_of(family)[wildcards.scene]


for folder, family in FAMILIES.items():
    solving, packages, urgency, words = SOLVED_BY[family]

    rule:
        name:
            solving
        input:
            kernels=stamps(packages),
        output:
            dataset=f"<results>/data/{folder}/{{scene}}.nc",
        params:
            code=code(solving),
            # Snakemake looks for the script when the loop has ended.
            script=script_file(solving),
            scene=scene_of(family),
            scene_id="{scene}",
        log:
            f"<logs>/{solving}/{{scene}}.log",
        benchmark:
            f"<benchmarks>/{solving}/{{scene}}.tsv"
        message:
            f"{words} of scene {{wildcards.scene}}."
        conda:
            "../envs/main.yaml"
        wildcard_constraints:
            scene="|".join(scenes_of(family)),
        priority: urgency
        script:
            "{params.script}"
