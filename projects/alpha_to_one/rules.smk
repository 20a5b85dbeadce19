"""The limit α → 1: rings of beads beside three amplitude equations, in campaigns."""

ALPHA_TO_ONE = [
    *("rings_damping", "rings_gamma", "rings_leading", "rings_map"),
    *("rings_mu", "rings_paper", "rings_time"),
]
RINGS_CODE = "merge_campaign", "solve_chunk", "granular_fronts.campaign.ring_points"


# What each campaign asks for, which is what its findings are about; read when a job is planned.
RINGS_SHOWN = lambda wildcards: {name: [campaign_of(name).given] * 2 for name in ALPHA_TO_ONE}


rule ring_limit:
    """Errors of the equations against ε, at fixed damping and at fixed μ."""
    input:
        damping="<results>/data/campaigns/rings_damping.nc",
        mu="<results>/data/campaigns/rings_mu.nc",
        texts="projects/alpha_to_one/captions/ring_limit.rst",
    output:
        **figure("ring_limit", "projects/alpha_to_one/captions"),
    params:
        code=code("ring_limit", *RINGS_CODE),
        shown=RINGS_SHOWN,
    log:
        "<logs>/ring_limit.log",
    benchmark:
        "<benchmarks>/ring_limit.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "ring_limit.py"


rule tabulate_ring_orders:
    """Orders in ε of the errors of u and of ẋ, a row for each line."""
    input:
        damping="<results>/data/campaigns/rings_damping.nc",
        gamma="<results>/data/campaigns/rings_gamma.nc",
        mu="<results>/data/campaigns/rings_mu.nc",
    output:
        **table("ring_orders"),
    params:
        code=code("tabulate_ring_orders", *RINGS_CODE),
        shown=RINGS_SHOWN,
    log:
        "<logs>/tabulate_ring_orders.log",
    benchmark:
        "<benchmarks>/tabulate_ring_orders.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "tabulate_ring_orders.py"


rule tabulate_ring_limit:
    """Findings on the limit, with verdicts."""
    input:
        statements="projects/alpha_to_one/findings.yaml",
        datasets=data(*[f"campaigns/{name}" for name in ALPHA_TO_ONE]),
    output:
        **table("ring_limit"),
    params:
        code=code(
            "tabulate_statements", *measured_by("projects/alpha_to_one/findings.yaml"), *RINGS_CODE
        ),
        shown=RINGS_SHOWN,
    log:
        "<logs>/tabulate_ring_limit.log",
    benchmark:
        "<benchmarks>/tabulate_ring_limit.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "../../workflow/scripts/tabulate_statements.py"


rule alpha_to_one:
    """How fast rings tend to their amplitude equations as α → 1, with verdicts; four minutes."""
    input:
        shown=[rules.ring_limit.output, rules.tabulate_ring_orders.output],
        tables=[rules.tabulate_ring_limit.output.csv],
    output:
        verdict="<results>/alpha_to_one.txt",
    params:
        code=code("check_verdicts"),
    log:
        "<logs>/alpha_to_one.log",
    benchmark:
        "<benchmarks>/alpha_to_one.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "../../workflow/scripts/check_verdicts.py"
