"""Contact laws at work: materials, damping regimes, numerical damping; section 3.1 of the paper."""

LAWS_DATASETS = expand(
    "<results>/data/laws/{name}.nc",
    name=[
        "materials",
        "damping_regimes",
        "numerical_damping",
        "jump_conditions",
        "choice_of_variables",
        "limiting_cases",
        "piston",
    ],
)


rule evaluate_materials:
    input:
        modules=sources("evaluate_materials"),
    output:
        dataset="<results>/data/laws/materials.nc",
    params:
        materials=config["laws"]["materials"],
    log:
        "<logs>/evaluate_materials.log",
    benchmark:
        "<benchmarks>/evaluate_materials.tsv"
    threads: 1
    message:
        "Finding the damping of glass, steel and cork."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/evaluate_materials.py"


rule evaluate_damping_regimes:
    input:
        modules=sources("evaluate_damping_regimes"),
    output:
        dataset="<results>/data/laws/damping_regimes.nc",
    params:
        regimes=config["laws"]["damping_regimes"],
    log:
        "<logs>/evaluate_damping_regimes.log",
    benchmark:
        "<benchmarks>/evaluate_damping_regimes.tsv"
    threads: 1
    message:
        "Finding where damping is weak."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/evaluate_damping_regimes.py"


rule measure_numerical_damping:
    input:
        kernels=rules.compile_kernels.output.stamp,
        modules=sources("measure_numerical_damping"),
    output:
        dataset="<results>/data/laws/numerical_damping.nc",
    params:
        scene=config["laws"]["numerical_damping"],
    log:
        "<logs>/measure_numerical_damping.log",
    benchmark:
        "<benchmarks>/measure_numerical_damping.tsv"
    threads: 1
    message:
        "Measuring the damping that the theta-method brings."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/measure_numerical_damping.py"


rule measure_pistons:
    input:
        kernels=rules.compile_kernels.output.stamp,
        modules=sources("measure_pistons"),
    output:
        dataset="<results>/data/laws/piston.nc",
    params:
        piston=config["laws"]["piston"],
    log:
        "<logs>/measure_pistons.log",
    benchmark:
        "<benchmarks>/measure_pistons.tsv"
    threads: 1
    message:
        "Driving fronts with a piston, at once and by a ramp."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/measure_pistons.py"


rule compare_variables:
    input:
        kernels=rules.compile_kernels.output.stamp,
        modules=sources("compare_variables"),
    output:
        dataset="<results>/data/laws/choice_of_variables.nc",
    params:
        scene=config["laws"]["choice_of_variables"],
    log:
        "<logs>/compare_variables.log",
    benchmark:
        "<benchmarks>/compare_variables.tsv"
    threads: 1
    message:
        "Comparing the variables (x, w) and (x, velocity)."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/compare_variables.py"


rule measure_limiting_cases:
    input:
        kernels=[
            rules.compile_kernels.output.stamp,
            rules.compile_continuum_kernels.output.stamp,
        ],
        modules=sources("measure_limiting_cases"),
    output:
        dataset="<results>/data/laws/limiting_cases.nc",
    params:
        scene=config["laws"]["limiting_cases"],
    log:
        "<logs>/measure_limiting_cases.log",
    benchmark:
        "<benchmarks>/measure_limiting_cases.tsv"
    threads: 1
    message:
        "Measuring limiting cases: no damping, no nonlinearity, softening, collisions, exponents towards 1."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/measure_limiting_cases.py"


rule check_jump_conditions:
    input:
        kernels=rules.compile_kernels.output.stamp,
        modules=sources("check_jump_conditions"),
    output:
        dataset="<results>/data/laws/jump_conditions.nc",
    params:
        scene=config["laws"]["jump_conditions"],
    log:
        "<logs>/check_jump_conditions.log",
    benchmark:
        "<benchmarks>/check_jump_conditions.tsv"
    threads: 1
    message:
        "Measuring fronts of any potentials against the jump conditions."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/check_jump_conditions.py"


rule tabulate_jump_conditions:
    input:
        dataset=rules.check_jump_conditions.output.dataset,
        modules=sources("tabulate_jump_conditions"),
    output:
        csv="<results>/tables/jump_conditions.csv",
        markdown="<results>/tables/jump_conditions.md",
    log:
        "<logs>/tabulate_jump_conditions.log",
    benchmark:
        "<benchmarks>/tabulate_jump_conditions.tsv"
    threads: 1
    message:
        "Writing the table of jump conditions."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_jump_conditions.py"


rule tabulate_materials:
    input:
        dataset=rules.evaluate_materials.output.dataset,
        modules=sources("tabulate_materials"),
    output:
        csv="<results>/tables/materials.csv",
        markdown="<results>/tables/materials.md",
    log:
        "<logs>/tabulate_materials.log",
    benchmark:
        "<benchmarks>/tabulate_materials.tsv"
    threads: 1
    message:
        "Writing the table of materials."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_materials.py"
