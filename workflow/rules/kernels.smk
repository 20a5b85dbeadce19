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


def stamps(wings):
    """Return the stamps of the kernels of some packages."""
    return [STAMPS[wing] for wing in wings]


for wing, (compiling, wings, below, what) in COMPILED.items():

    rule:
        name:
            compiling
        input:
            kernels=stamps(below),
        output:
            stamp=STAMPS[wing],
        params:
            code=code("compile_kernels", *(f"granular_fronts.{one}.compilation" for one in wings)),
            wings=wings,
        log:
            f"<logs>/{compiling}.log",
        benchmark:
            f"<benchmarks>/{compiling}.tsv"
        message:
            f"Compiling the kernels of {what}."
        priority: 2 if below else 3
        script:
            "../scripts/compile_kernels.py"
