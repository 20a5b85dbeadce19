"""A ball on a plate, with and without load: curves of Chatterjee et al. (2022)."""

from chatterjee_2022_settings import Falls

CHATTERJEE, CHATTERJEE_OWN = project_settings("chatterjee_2022", Falls)
JUDGED["chatterjee_2022"] = {"falls": [CHATTERJEE, CHATTERJEE_OWN]}


rule balls_on_a_plate:
    """Restitution of a ball on a plate, and published points."""
    input:
        kernels("chain"),
        statements="projects/chatterjee_2022/statements.yaml",
    output:
        dataset="<results>/data/chatterjee_2022/falls.nc",
    params:
        code=code("ball_on_plate"),
        settings=CHATTERJEE,
    log:
        "<logs>/chatterjee_2022/falls.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "ball_on_plate.py"


rule chatterjee_2022_restitution:
    """Restitution of a ball on a plate with published points."""
    input:
        falls="<results>/data/chatterjee_2022/falls.nc",
        texts="projects/chatterjee_2022/captions/chatterjee_2022_restitution.rst",
    output:
        **figure("chatterjee_2022_restitution", "projects/chatterjee_2022/captions"),
    params:
        code=code("chatterjee_2022_restitution", "ball_on_plate"),
        shown=JUDGED["chatterjee_2022"],
    log:
        "<logs>/chatterjee_2022/restitution.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "chatterjee_2022_restitution.py"


rule chatterjee_2022:
    """A ball on a plate, with figure and verdicts; seconds."""
    input:
        rules.chatterjee_2022_restitution.output,
        "<results>/chatterjee_2022.txt",
