"""Figures of the paper: each rule draws what the data hold and computes nothing."""


rule plot_fig01:
    input:
        dataset="<results>/data/chain/initiation_underdamped.nc",
        modules=sources("plot_fig01"),
    output:
        pdf="<results>/figures/fig01_initiation_underdamped.pdf",
        png="<results>/figures/fig01_initiation_underdamped.png",
    log:
        "<logs>/plot_fig01.log",
    benchmark:
        "<benchmarks>/plot_fig01.tsv"
    threads: 1
    message:
        "Drawing figure 1: the front starts and becomes steady, weak damping."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig01.py"


rule plot_fig02:
    input:
        dataset="<results>/data/chain/initiation_underdamped.nc",
        modules=sources("plot_fig02"),
    output:
        pdf="<results>/figures/fig02_spacetime_underdamped.pdf",
        png="<results>/figures/fig02_spacetime_underdamped.png",
    log:
        "<logs>/plot_fig02.log",
    benchmark:
        "<benchmarks>/plot_fig02.tsv"
    threads: 1
    message:
        "Drawing figure 2: space–time diagrams, weak damping."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig02.py"


rule plot_fig03:
    input:
        dataset="<results>/data/chain/initiation_overdamped.nc",
        modules=sources("plot_fig03"),
    output:
        pdf="<results>/figures/fig03_initiation_overdamped.pdf",
        png="<results>/figures/fig03_initiation_overdamped.png",
    log:
        "<logs>/plot_fig03.log",
    benchmark:
        "<benchmarks>/plot_fig03.tsv"
    threads: 1
    message:
        "Drawing figure 3: the front starts and crosses the chain, strong damping."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig03.py"


rule plot_fig04:
    input:
        dataset="<results>/data/continuum/log_burgers_fronts.nc",
        modules=sources("plot_fig04"),
    output:
        pdf="<results>/figures/fig04_log_burgers_fronts.pdf",
        png="<results>/figures/fig04_log_burgers_fronts.png",
    log:
        "<logs>/plot_fig04.log",
    benchmark:
        "<benchmarks>/plot_fig04.tsv"
    threads: 1
    message:
        "Drawing figure 4: fluxes and fronts of the amplitude equations."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig04.py"


rule plot_fig05:
    input:
        weak="<results>/data/periodic/weak.nc",
        hertz="<results>/data/periodic/hertz.nc",
        modules=sources("plot_fig05"),
    output:
        pdf="<results>/figures/fig05_initial_conditions.pdf",
        png="<results>/figures/fig05_initial_conditions.png",
    log:
        "<logs>/plot_fig05.log",
    benchmark:
        "<benchmarks>/plot_fig05.tsv"
    threads: 1
    message:
        "Drawing figure 5: the start on the ring."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig05.py"


rule plot_fig06:
    input:
        dataset="<results>/data/periodic/weak.nc",
        modules=sources("plot_fig06"),
    output:
        pdf="<results>/figures/fig06_periodic_chain_weak.pdf",
        png="<results>/figures/fig06_periodic_chain_weak.png",
    log:
        "<logs>/plot_fig06.log",
    benchmark:
        "<benchmarks>/plot_fig06.tsv"
    threads: 1
    message:
        "Drawing figure 6: ring and logarithmic Burgers equation, alpha = 1.1."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig06.py"


rule plot_fig07:
    input:
        dataset="<results>/data/periodic/hertz.nc",
        modules=sources("plot_fig07"),
    output:
        pdf="<results>/figures/fig07_periodic_chain_hertz.pdf",
        png="<results>/figures/fig07_periodic_chain_hertz.png",
    log:
        "<logs>/plot_fig07.log",
    benchmark:
        "<benchmarks>/plot_fig07.tsv"
    threads: 1
    message:
        "Drawing figure 7: ring and logarithmic Burgers equation, alpha = 3/2."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig07.py"


rule plot_fig07b:
    input:
        weak="<results>/data/periodic/weak.nc",
        hertz="<results>/data/periodic/hertz.nc",
        modules=sources("plot_fig07b"),
    output:
        pdf="<results>/figures/fig07b_model_error.pdf",
        png="<results>/figures/fig07b_model_error.png",
    log:
        "<logs>/plot_fig07b.log",
    benchmark:
        "<benchmarks>/plot_fig07b.tsv"
    threads: 1
    message:
        "Drawing figure 7b: how far the ring is from its equations."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig07b.py"


rule plot_fig08:
    input:
        dataset="<results>/data/continuum/front_profiles.nc",
        modules=sources("plot_fig08"),
    output:
        pdf="<results>/figures/fig08_heteroclinic.pdf",
        png="<results>/figures/fig08_heteroclinic.png",
    log:
        "<logs>/plot_fig08.log",
    benchmark:
        "<benchmarks>/plot_fig08.tsv"
    threads: 1
    message:
        "Drawing figure 8: the heteroclinic orbit."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig08.py"


rule plot_fig09:
    input:
        underdamped="<results>/data/fronts/underdamped.nc",
        overdamped="<results>/data/fronts/overdamped.nc",
        modules=sources("plot_fig09"),
    output:
        pdf="<results>/figures/fig09_exact_fronts.pdf",
        png="<results>/figures/fig09_exact_fronts.png",
    log:
        "<logs>/plot_fig09.log",
    benchmark:
        "<benchmarks>/plot_fig09.tsv"
    threads: 1
    message:
        "Drawing figure 9: exact fronts by two methods."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig09.py"


rule plot_fig10:
    input:
        scenes=FRONT_DATASETS,
        modules=sources("plot_fig10"),
    output:
        pdf="<results>/figures/fig10_fronts_compared.pdf",
        png="<results>/figures/fig10_fronts_compared.png",
    log:
        "<logs>/plot_fig10.log",
    benchmark:
        "<benchmarks>/plot_fig10.tsv"
    threads: 1
    message:
        "Drawing figure 10: exact fronts beside what approximates them."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig10.py"


rule plot_fig11:
    input:
        dataset="<results>/data/fronts/survey.nc",
        modules=sources("plot_fig11"),
    output:
        pdf="<results>/figures/fig11_continuum_errors.pdf",
        png="<results>/figures/fig11_continuum_errors.png",
    log:
        "<logs>/plot_fig11.log",
    benchmark:
        "<benchmarks>/plot_fig11.tsv"
    threads: 1
    message:
        "Drawing figure 11: errors of the continuum fronts."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig11.py"


rule plot_fig12:
    input:
        dataset="<results>/data/fronts/critical_damping.nc",
        modules=sources("plot_fig12"),
    output:
        pdf="<results>/figures/fig12_critical_damping.pdf",
        png="<results>/figures/fig12_critical_damping.png",
    log:
        "<logs>/plot_fig12.log",
    benchmark:
        "<benchmarks>/plot_fig12.tsv"
    threads: 1
    message:
        "Drawing figure 12: the meanings of critical damping."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig12.py"


rule plot_fig13:
    input:
        dataset="<results>/data/fronts/multipliers.nc",
        modules=sources("plot_fig13"),
    output:
        pdf="<results>/figures/fig13_multipliers.pdf",
        png="<results>/figures/fig13_multipliers.png",
    log:
        "<logs>/plot_fig13.log",
    benchmark:
        "<benchmarks>/plot_fig13.tsv"
    threads: 1
    message:
        "Drawing figure 13: multipliers of exact fronts."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig13.py"


rule plot_fig17:
    input:
        dataset="<results>/data/laws/jump_conditions.nc",
        modules=sources("plot_fig17"),
    output:
        pdf="<results>/figures/fig17_jump_conditions.pdf",
        png="<results>/figures/fig17_jump_conditions.png",
    log:
        "<logs>/plot_fig17.log",
    benchmark:
        "<benchmarks>/plot_fig17.tsv"
    threads: 1
    message:
        "Drawing figure 17: jump conditions and measured fronts."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig17.py"


rule plot_fig18:
    input:
        dataset="<results>/data/laws/damping_regimes.nc",
        modules=sources("plot_fig18"),
    output:
        pdf="<results>/figures/fig18_damping_regimes.pdf",
        png="<results>/figures/fig18_damping_regimes.png",
    log:
        "<logs>/plot_fig18.log",
    benchmark:
        "<benchmarks>/plot_fig18.tsv"
    threads: 1
    message:
        "Drawing figure 18: where damping is weak."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig18.py"


rule plot_fig19:
    input:
        dataset="<results>/data/laws/numerical_damping.nc",
        modules=sources("plot_fig19"),
    output:
        pdf="<results>/figures/fig19_numerical_damping.pdf",
        png="<results>/figures/fig19_numerical_damping.png",
    log:
        "<logs>/plot_fig19.log",
    benchmark:
        "<benchmarks>/plot_fig19.tsv"
    threads: 1
    message:
        "Drawing figure 19: damping by the theta-method."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/plot_fig19.py"


FIGURE_RULES = {
    "fig01": rules.plot_fig01,
    "fig02": rules.plot_fig02,
    "fig03": rules.plot_fig03,
    "fig04": rules.plot_fig04,
    "fig05": rules.plot_fig05,
    "fig06": rules.plot_fig06,
    "fig07": rules.plot_fig07,
    "fig07b": rules.plot_fig07b,
    "fig08": rules.plot_fig08,
    "fig09": rules.plot_fig09,
    "fig10": rules.plot_fig10,
    "fig11": rules.plot_fig11,
    "fig12": rules.plot_fig12,
    "fig13": rules.plot_fig13,
    "fig17": rules.plot_fig17,
    "fig18": rules.plot_fig18,
    "fig19": rules.plot_fig19,
}
FIGURES = [rule.output for rule in FIGURE_RULES.values()]
