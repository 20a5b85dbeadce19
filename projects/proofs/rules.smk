"""Fronts that are proved: certificates, what they prove, and the junctions of intervals of γ.

Certificates lie under <results>/proofs and are no outputs. A job that was stopped first proves
those files again, and goes on from the last one.
"""

from proof_chunks import chunk_name, proof_chunks
from proofs_settings import Proofs

PROOFS, PROOFS_OWN = project_settings("proofs", Proofs)
PROOFS_CHUNKS = {
    family: {chunk_name(chunk): chunk for chunk in proof_chunks(described)}
    for family, described in PROOFS["intervals"].items()
}


# What is proved of each part, and what config.yaml says.
PROOFS_SHOWN = {key: [PROOFS[key], PROOFS_OWN[key]] for key in ("fronts", "intervals")}


rule prove_fronts:
    """Single fronts, a certificate of each."""
    input:
        kernels("fronts"),
    output:
        dataset="<results>/data/proofs/fronts.nc",
    params:
        code=code("prove_fronts"),
        fronts=PROOFS["fronts"],
        folder=f"{config['results']}/proofs/fronts",
    log:
        "<logs>/prove_fronts.log",
    benchmark:
        "<benchmarks>/prove_fronts.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "prove_fronts.py"


rule prove_chunk:
    """Fronts for all γ of one chunk of an interval."""
    input:
        kernels("fronts"),
    output:
        dataset="<results>/data/proofs/{family}/{chunk}.nc",
    params:
        code=code("prove_chunk"),
        chunk=lambda wildcards: PROOFS_CHUNKS[wildcards.family][wildcards.chunk],
        folder=f"{config['results']}/proofs/{{family}}/{{chunk}}",
    log:
        "<logs>/prove_chunk/{family}/{chunk}.log",
    benchmark:
        "<benchmarks>/prove_chunk/{family}/{chunk}.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    wildcard_constraints:
        family="|".join(PROOFS_CHUNKS),
        chunk=r"\d+\.\d{6}-\d+\.\d{6}",
    script:
        "prove_chunk.py"


rule join_intervals:
    """Chunks whose fronts at a common end are proved to be one."""
    input:
        chunks=[
            f"<results>/data/proofs/{family}/{chunk}.nc"
            for family, chunks in PROOFS_CHUNKS.items()
            for chunk in chunks
        ],
    output:
        dataset="<results>/data/proofs/intervals.nc",
    params:
        code=code("join_intervals"),
        intervals=PROOFS["intervals"],
    log:
        "<logs>/join_intervals.log",
    benchmark:
        "<benchmarks>/join_intervals.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "join_intervals.py"


rule enclose_front:
    """One of the fronts with its enclosure, from its certificate."""
    input:
        rules.prove_fronts.output,
    output:
        dataset="<results>/data/proofs/shown_front.nc",
    params:
        code=code("enclose_front"),
        certificate=f"{config['results']}/proofs/fronts/{PROOFS['shown']}.npz",
        front=PROOFS["fronts"][PROOFS["shown"]],
    log:
        "<logs>/enclose_front.log",
    benchmark:
        "<benchmarks>/enclose_front.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "enclose_front.py"


rule proved_fronts:
    """Which fronts are proved, over exponent and damping, and what of them; takes long."""
    input:
        fronts=rules.prove_fronts.output.dataset,
        intervals=rules.join_intervals.output.dataset,
        texts="projects/proofs/captions/proved_fronts.rst",
    output:
        **figure("proved_fronts", "projects/proofs/captions"),
    params:
        code=code("proved_fronts", "prove_fronts", "prove_chunk", "join_intervals"),
        shown=PROOFS_SHOWN,
    log:
        "<logs>/proved_fronts.log",
    benchmark:
        "<benchmarks>/proved_fronts.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "proved_fronts.py"


rule enclosed_front:
    """A front that is proved, within its enclosure."""
    input:
        data=rules.enclose_front.output.dataset,
        texts="projects/proofs/captions/enclosed_front.rst",
    output:
        **figure("enclosed_front", "projects/proofs/captions"),
    params:
        code=code("enclosed_front", "prove_fronts", "enclose_front"),
        shown={"shown_front": [one["fronts"][one["shown"]] for one in (PROOFS, PROOFS_OWN)]},
    log:
        "<logs>/enclosed_front.log",
    benchmark:
        "<benchmarks>/enclosed_front.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "enclosed_front.py"


rule tabulate_proofs:
    """What is proved of each front and family, and the margins of the inequalities."""
    input:
        fronts=rules.prove_fronts.output.dataset,
        intervals=rules.join_intervals.output.dataset,
    output:
        csv="<results>/tables/proofs.csv",
        markdown="<results>/tables/proofs.md",
        margins_csv="<results>/tables/proof_margins.csv",
        margins_markdown="<results>/tables/proof_margins.md",
    params:
        code=code("tabulate_proofs", "prove_fronts", "prove_chunk", "join_intervals"),
        shown=PROOFS_SHOWN,
    log:
        "<logs>/tabulate_proofs.log",
    benchmark:
        "<benchmarks>/tabulate_proofs.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "tabulate_proofs.py"


rule certificates:
    """An archive of all certificates of fronts, with their SHA-256 sums; takes long."""
    input:
        fronts=rules.prove_fronts.output.dataset,
        intervals=rules.join_intervals.output.dataset,
    output:
        archive="<results>/certificates.tar",
        sums="<results>/certificates.sha256",
    params:
        code=code("archive_certificates"),
        folder=f"{config['results']}/proofs",
    log:
        "<logs>/certificates.log",
    benchmark:
        "<benchmarks>/certificates.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "archive_certificates.py"


rule proofs:
    """Fronts proved by ball arithmetic, with figures and tables; more than half an hour."""
    input:
        rules.tabulate_proofs.output,
        rules.proved_fronts.output,
        rules.enclosed_front.output,
