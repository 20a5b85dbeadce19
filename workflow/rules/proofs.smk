"""Fronts that are proved: certificates, what they prove, and the junctions of intervals of γ.

Certificates lie under <results>/proofs and are no outputs. A job that was stopped first proves
those files again, and goes on from the last one.
"""

from proof_chunks import chunk_name, proof_chunks
from dataset_parameters import shown_front

PROOFS = config["proofs"]
CHUNKS = {
    family: {chunk_name(chunk): chunk for chunk in proof_chunks(described)}
    for family, described in PROOFS["intervals"].items()
}


rule prove_fronts:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
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
    message:
        "Proving single fronts."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/proofs/prove_fronts.py"


rule prove_chunk:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/proofs/{family}/{chunk}.nc",
    params:
        code=code("prove_chunk"),
        chunk=lambda wildcards: CHUNKS[wildcards.family][wildcards.chunk],
        folder=lambda wildcards: "/".join(
            [config["results"], "proofs", wildcards.family, wildcards.chunk]
        ),
    log:
        "<logs>/prove_chunk/{family}/{chunk}.log",
    benchmark:
        "<benchmarks>/prove_chunk/{family}/{chunk}.tsv"
    message:
        "Proving fronts of family {wildcards.family} for γ in {wildcards.chunk}."
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        family="|".join(CHUNKS),
        chunk=r"\d+\.\d{6}-\d+\.\d{6}",
    script:
        "../scripts/proofs/prove_chunk.py"


rule join_intervals:
    input:
        chunks=[
            f"<results>/data/proofs/{family}/{chunk}.nc"
            for family in CHUNKS
            for chunk in CHUNKS[family]
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
    message:
        "Joining the chunks of proved intervals."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/proofs/join_intervals.py"


rule enclose_front:
    input:
        dataset=rules.prove_fronts.output.dataset,
    output:
        enclosure="<results>/data/proofs/shown_front.nc",
    params:
        code=code("enclose_front"),
        front=shown_front(config),
        folder=f"{config['results']}/proofs/fronts",
    log:
        "<logs>/enclose_front.log",
    benchmark:
        "<benchmarks>/enclose_front.tsv"
    message:
        "Evaluating the enclosure of a front that is proved."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/proofs/enclose_front.py"


rule tabulate_proofs:
    input:
        fronts=rules.prove_fronts.output.dataset,
        intervals=rules.join_intervals.output.dataset,
    output:
        csv="<results>/tables/proofs.csv",
        markdown="<results>/tables/proofs.md",
        margins_csv="<results>/tables/proof_margins.csv",
        margins_markdown="<results>/tables/proof_margins.md",
    params:
        code=code("tabulate_proofs"),
        parameters=parameters("proofs/fronts", "proofs/intervals"),
    log:
        "<logs>/tabulate_proofs.log",
    benchmark:
        "<benchmarks>/tabulate_proofs.tsv"
    message:
        "Tabulating what is proved."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/proofs/tabulate_proofs.py"


rule archive_certificates:
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
        "<logs>/archive_certificates.log",
    benchmark:
        "<benchmarks>/archive_certificates.tsv"
    message:
        "Archiving the certificates of fronts."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/proofs/archive_certificates.py"


rule certificates:
    """An archive of all certificates of fronts, with their SHA-256 sums; takes long."""
    input:
        rules.archive_certificates.output,
    message:
        "All certificates are in one archive: {input[0]}."


rule proofs:
    """Fronts proved by ball arithmetic, with figures 23 and 24; takes long."""
    input:
        rules.tabulate_proofs.output,
        rules.fig23.input,
        rules.fig24.input,
    message:
        "Fronts are proved, tabulated and drawn: {input}."
