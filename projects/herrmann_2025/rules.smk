"""Overdamped fronts: sentences of Herrmann, James and Matthies (2025)."""

JUDGED["herrmann_2025"] = {"fronts": [{}, {}]}


rule overdamped_fronts:
    """Overdamped fronts with linear dashpots, their tails, limit and proofs."""
    input:
        kernels("fronts"),
        certificate="docs/certificates/dashpots.npz",
    output:
        dataset="<results>/data/herrmann_2025/fronts.nc",
    params:
        code=code("overdamped_fronts"),
    log:
        "<logs>/herrmann_2025/fronts.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "overdamped_fronts.py"


rule herrmann_2025_rates:
    """Rates of both tails, and what is proved."""
    input:
        fronts=rules.overdamped_fronts.output.dataset,
        texts="projects/herrmann_2025/captions/herrmann_2025_rates.rst",
    output:
        **figure("herrmann_2025_rates", "projects/herrmann_2025/captions"),
    params:
        code=code("herrmann_2025_rates", "overdamped_fronts"),
        shown={},
    log:
        "<logs>/herrmann_2025/rates.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "herrmann_2025_rates.py"


rule herrmann_2025:
    """Overdamped fronts with linear dashpots, with a figure and verdicts; half a minute."""
    input:
        rules.herrmann_2025_rates.output,
        "<results>/herrmann_2025.txt",
