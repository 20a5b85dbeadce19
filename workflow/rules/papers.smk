"""Papers of others: for each the figures and tables that its folder lists, and their verdicts."""

for paper, listed in papers().items():

    rule:
        name:
            f"check_{paper}"
        input:
            figures=[figure_files(figure) for figure in listed["figures"]],
            tables=[table_files(table) for table in listed["tables"]],
            datasets=[
                data_file(f"{folder}/{scene}")
                for folder, family in FAMILIES.items()
                for scene in listed["scenes"].get(family, [])
            ],
            studies=[
                data_file(f"{one['folder']}/{name}") for name, one in listed["studies"].items()
            ],
        output:
            verdict=f"<results>/papers/{paper}.txt",
        params:
            code=code("check_paper"),
            results=subpath(output.verdict, ancestor=2),
            judged=[name for name, table in listed["tables"].items() if "statements" in table],
        log:
            f"<logs>/check_{paper}.log",
        benchmark:
            f"<benchmarks>/check_{paper}.tsv"
        message:
            f"Comparing the verdicts on {listed['title']} with the expected ones."
        conda:
            "../envs/main.yaml"
        localrule: True
        script:
            "../scripts/tables/check_paper.py"

    rule:
        """Figures, tables and verdicts of one folder of papers."""
        name:
            f"papers/{paper}"
        input:
            f"<results>/papers/{paper}.txt",
        message:
            f"{listed['title']}: figures and tables are in the results folder."


rule papers:
    """Figures, tables and verdicts of every folder of papers."""
    input:
        [f"<results>/papers/{paper}.txt" for paper in papers()],
    message:
        "Figures, tables and verdicts of every folder of papers are there."
