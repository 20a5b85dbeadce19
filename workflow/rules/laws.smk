"""Contact laws at work: materials, damping regimes, numerical damping; section 3.1 of the paper."""


rule evaluate_materials:
    output:
        dataset="<results>/data/laws/materials.nc",
    params:
        code=code("evaluate_materials"),
        materials=config["laws"]["materials"],
    log:
        "<logs>/evaluate_materials.log",
    benchmark:
        "<benchmarks>/evaluate_materials.tsv"
    threads: 1
    message:
        "Finding the damping of glass, steel and cork."
    conda:
        environment
    script:
        "../scripts/evaluate_materials.py"


rule evaluate_damping_regimes:
    output:
        dataset="<results>/data/laws/damping_regimes.nc",
    params:
        code=code("evaluate_damping_regimes"),
        regimes=config["laws"]["damping_regimes"],
    log:
        "<logs>/evaluate_damping_regimes.log",
    benchmark:
        "<benchmarks>/evaluate_damping_regimes.tsv"
    threads: 1
    message:
        "Finding where damping is weak."
    conda:
        environment
    script:
        "../scripts/evaluate_damping_regimes.py"


rule measure_numerical_damping:
    input:
        kernels=rules.compile_kernels.output.stamp,
    output:
        dataset="<results>/data/laws/numerical_damping.nc",
    params:
        code=code("measure_numerical_damping"),
        scene=config["laws"]["numerical_damping"],
    log:
        "<logs>/measure_numerical_damping.log",
    benchmark:
        "<benchmarks>/measure_numerical_damping.tsv"
    threads: 1
    message:
        "Measuring the damping that the theta-method brings."
    conda:
        environment
    priority: 1
    script:
        "../scripts/measure_numerical_damping.py"


rule measure_half_step_damping:
    input:
        kernels=rules.compile_kernels.output.stamp,
    output:
        dataset="<results>/data/laws/half_step_damping.nc",
    params:
        code=code("measure_half_step_damping"),
        scene=config["laws"]["half_step_damping"],
    log:
        "<logs>/measure_half_step_damping.log",
    benchmark:
        "<benchmarks>/measure_half_step_damping.tsv"
    threads: 1
    message:
        "Measuring the damping that the step of discrete-element codes brings."
    conda:
        environment
    priority: 1
    script:
        "../scripts/measure_half_step_damping.py"


rule measure_pistons:
    input:
        kernels=rules.compile_kernels.output.stamp,
    output:
        dataset="<results>/data/laws/piston.nc",
    params:
        code=code("measure_pistons"),
        piston=config["laws"]["piston"],
    log:
        "<logs>/measure_pistons.log",
    benchmark:
        "<benchmarks>/measure_pistons.tsv"
    threads: 1
    message:
        "Driving fronts with a piston, at once and by a ramp."
    conda:
        environment
    priority: 1
    script:
        "../scripts/measure_pistons.py"


rule compare_variables:
    input:
        kernels=rules.compile_kernels.output.stamp,
    output:
        dataset="<results>/data/laws/choice_of_variables.nc",
    params:
        code=code("compare_variables"),
        scene=config["laws"]["choice_of_variables"],
    log:
        "<logs>/compare_variables.log",
    benchmark:
        "<benchmarks>/compare_variables.tsv"
    threads: 1
    message:
        "Comparing the variables (x, w) and (x, velocity)."
    conda:
        environment
    script:
        "../scripts/compare_variables.py"


rule measure_limiting_cases:
    input:
        kernels=[
            rules.compile_kernels.output.stamp,
            rules.compile_continuum_kernels.output.stamp,
        ],
    output:
        dataset="<results>/data/laws/limiting_cases.nc",
    params:
        code=code("measure_limiting_cases"),
        scene=config["laws"]["limiting_cases"],
    log:
        "<logs>/measure_limiting_cases.log",
    benchmark:
        "<benchmarks>/measure_limiting_cases.tsv"
    threads: 1
    message:
        "Measuring limiting cases: no damping, no nonlinearity, softening, collisions, exponents towards 1."
    conda:
        environment
    priority: 1
    script:
        "../scripts/measure_limiting_cases.py"


rule check_jump_conditions:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/laws/jump_conditions.nc",
    params:
        code=code("check_jump_conditions"),
        scene=config["laws"]["jump_conditions"],
    log:
        "<logs>/check_jump_conditions.log",
    benchmark:
        "<benchmarks>/check_jump_conditions.tsv"
    threads: 1
    message:
        "Measuring fronts of any potentials against the jump conditions."
    conda:
        environment
    priority: 1
    script:
        "../scripts/check_jump_conditions.py"


rule tabulate_jump_conditions:
    input:
        dataset=rules.check_jump_conditions.output.dataset,
    output:
        csv="<results>/tables/jump_conditions.csv",
        markdown="<results>/tables/jump_conditions.md",
        record="<results>/tables/jump_conditions.json",
    params:
        code=code("tabulate_jump_conditions"),
        asked=asked("laws/jump_conditions"),
    log:
        "<logs>/tabulate_jump_conditions.log",
    benchmark:
        "<benchmarks>/tabulate_jump_conditions.tsv"
    threads: 1
    message:
        "Writing the table of jump conditions."
    conda:
        environment
    script:
        "../scripts/tabulate_jump_conditions.py"


rule tabulate_materials:
    input:
        dataset=rules.evaluate_materials.output.dataset,
    output:
        csv="<results>/tables/materials.csv",
        markdown="<results>/tables/materials.md",
        record="<results>/tables/materials.json",
    params:
        code=code("tabulate_materials"),
        asked=asked("laws/materials"),
    log:
        "<logs>/tabulate_materials.log",
    benchmark:
        "<benchmarks>/tabulate_materials.tsv"
    threads: 1
    message:
        "Writing the table of materials."
    conda:
        environment
    script:
        "../scripts/tabulate_materials.py"
