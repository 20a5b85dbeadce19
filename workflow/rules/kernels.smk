"""Compiled kernels; otherwise jobs that start together would each compile the same ones."""

# For each stamp: the rule, the packages that it compiles, and the packages that these import.
STAMPS = {
    "chain": "<results>/kernels.json",
    "continuum": "<results>/continuum_kernels.json",
    "fronts": "<results>/front_kernels.json",
}
COMPILED = {
    "chain": ("compile_kernels", ["chain"], [], "the chain"),
    "continuum": (
        "compile_continuum_kernels",
        ["continuum", "reference_methods"],
        [],
        "the amplitude equations",
    ),
    "fronts": ("compile_front_kernels", ["fronts"], ["chain", "continuum"], "the exact fronts"),
}


def stamps(packages):
    """Return the stamps of the kernels of some packages."""
    return [STAMPS[package] for package in packages]


for package, (compiling, packages, below, what) in COMPILED.items():

    rule:
        name:
            compiling
        input:
            kernels=stamps(below),
        output:
            stamp=STAMPS[package],
        params:
            code=code(
                "compile_kernels", *(f"granular_fronts.{one}.compilation" for one in packages)
            ),
            packages=packages,
        log:
            f"<logs>/{compiling}.log",
        benchmark:
            f"<benchmarks>/{compiling}.tsv"
        message:
            f"Compiling the kernels of {what}."
        conda:
            "../envs/main.yaml"
        priority: 2 if below else 3
        script:
            "../scripts/compile_kernels.py"
