"""Exact fronts of the lattice, section 6 of the paper."""


rule compile_front_kernels:
    input:
        kernels=[
            rules.compile_kernels.output.stamp,
            rules.compile_continuum_kernels.output.stamp,
        ],
    output:
        stamp="<results>/front_kernels.json",
    params:
        code=code("compile_kernels", "granular_fronts.fronts.compilation"),
        wings=["fronts"],
    log:
        "<logs>/compile_front_kernels.log",
    benchmark:
        "<benchmarks>/compile_front_kernels.tsv"
    threads: 1
    message:
        "Compiling the kernels of the exact fronts."
    conda:
        environment
    priority: 2
    script:
        "../scripts/compile_kernels.py"


rule shoot_front:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/fronts/{scene}.nc",
    params:
        code=code("shoot_front"),
        scene=lambda wildcards: config["scenes"]["front"][wildcards.scene],
        scene_id="{scene}",
    log:
        "<logs>/shoot_front/{scene}.log",
    benchmark:
        "<benchmarks>/shoot_front/{scene}.tsv"
    threads: 1
    message:
        "Solving the exact front of scene {wildcards.scene}, and what approximates it."
    conda:
        environment
    wildcard_constraints:
        scene="|".join(config["scenes"]["front"]),
    script:
        "../scripts/shoot_front.py"


rule survey_fronts:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/fronts/survey.nc",
    params:
        code=code("survey_fronts"),
        survey=config["exact_fronts"]["survey"],
    log:
        "<logs>/survey_fronts.log",
    benchmark:
        "<benchmarks>/survey_fronts.tsv"
    threads: 1
    message:
        "Solving exact fronts over exponents and dampings."
    conda:
        environment
    script:
        "../scripts/survey_fronts.py"


rule map_critical_damping:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/fronts/critical_damping.nc",
    params:
        code=code("map_critical_damping"),
        plane=config["exact_fronts"]["critical_damping"],
    log:
        "<logs>/map_critical_damping.log",
    benchmark:
        "<benchmarks>/map_critical_damping.tsv"
    threads: 1
    message:
        "Mapping critical damping and overshoot."
    conda:
        environment
    priority: 1
    script:
        "../scripts/map_critical_damping.py"


rule follow_trends:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/fronts/trends.nc",
    params:
        code=code("follow_trends"),
        scene=config["exact_fronts"]["trends"],
    log:
        "<logs>/follow_trends.log",
    benchmark:
        "<benchmarks>/follow_trends.tsv"
    threads: 1
    message:
        "Following fronts over velocity, pressure and exponent."
    conda:
        environment
    script:
        "../scripts/follow_trends.py"


rule compute_multipliers:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/fronts/multipliers.nc",
    params:
        code=code("compute_multipliers"),
        stability=config["exact_fronts"]["multipliers"],
    log:
        "<logs>/compute_multipliers.log",
    benchmark:
        "<benchmarks>/compute_multipliers.tsv"
    threads: 1
    message:
        "Computing the multipliers of exact fronts."
    conda:
        environment
    script:
        "../scripts/compute_multipliers.py"


rule tabulate_fronts:
    input:
        survey=rules.survey_fronts.output.dataset,
    output:
        properties_csv="<results>/tables/front_properties.csv",
        properties_markdown="<results>/tables/front_properties.md",
        errors_csv="<results>/tables/front_errors.csv",
        errors_markdown="<results>/tables/front_errors.md",
        properties_record="<results>/tables/front_properties.json",
        errors_record="<results>/tables/front_errors.json",
    params:
        code=code("tabulate_fronts"),
        asked=asked("fronts/survey"),
    log:
        "<logs>/tabulate_fronts.log",
    benchmark:
        "<benchmarks>/tabulate_fronts.tsv"
    threads: 1
    message:
        "Tabulating the properties of exact fronts and the errors of continuum fronts."
    conda:
        environment
    script:
        "../scripts/tabulate_fronts.py"


rule tabulate_critical_damping:
    input:
        dataset=rules.map_critical_damping.output.dataset,
    output:
        csv="<results>/tables/critical_damping.csv",
        markdown="<results>/tables/critical_damping.md",
        record="<results>/tables/critical_damping.json",
    params:
        code=code("tabulate_critical_damping"),
        asked=asked("fronts/critical_damping"),
    log:
        "<logs>/tabulate_critical_damping.log",
    benchmark:
        "<benchmarks>/tabulate_critical_damping.tsv"
    threads: 1
    message:
        "Tabulating the meanings of critical damping."
    conda:
        environment
    script:
        "../scripts/tabulate_critical_damping.py"
