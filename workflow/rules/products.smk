"""Figures and tables: what they are made from, and the files of each."""

FIGURES = read_yaml("workflow/figures.yaml") | listed_in_papers("figures")
TABLES = read_yaml("workflow/tables.yaml") | listed_in_papers("tables")
FOLDERS = {family: folder for folder, family in FAMILIES.items()}
for described, keys in (FIGURES, ("title", "data", "alt")), (
    TABLES,
    ("title", "meaning", "caption"),
):
    for name, one in described.items():
        if missing := [key for key in keys if key not in one]:
            sys.exit(f"{name} has no {missing[0]}: a figure or table needs {', '.join(keys)}.")


# A plain call makes these; the others wait until a command names them.
DEFAULT_FIGURES, DEFAULT_TABLES = (
    [name for name, one in described.items() if not one.get("on_demand")]
    for described in (FIGURES, TABLES)
)


def data_file(dataset):
    """Return the file of a dataset."""
    return f"<results>/data/{dataset}.nc"


def drawn_from(figure):
    """Return the datasets behind a figure: for each argument of its script one, or a list."""
    return {
        argument: (
            [f"{FOLDERS[named['family']]}/{scene}" for scene in config["scenes"][named["family"]]]
            if isinstance(named, dict)
            else named
        )
        for argument, named in FIGURES[figure]["data"].items()
    }


def datasets_of(figure):
    """Return all datasets behind a figure."""
    given = drawn_from(figure).values()
    return [name for one in given for name in (one if isinstance(one, list) else [one])]


def figure_inputs(figure):
    """Return the files of the datasets behind a figure, for each argument of its script."""
    return {
        argument: [data_file(name) for name in one] if isinstance(one, list) else data_file(one)
        for argument, one in drawn_from(figure).items()
    }


def stem_of(figure):
    """Return what the names of all files of a figure begin with."""
    return "_".join([f"figures/{figure}", *filter(None, [FIGURES[figure].get("name")])])


def script_of(figure):
    """Return the name of the script that draws a figure."""
    return FIGURES[figure].get("script", f"plot_{figure}")


def template_of(figure):
    """Return the template of the caption of a figure."""
    return f"{FIGURES[figure].get('folder', 'workflow/report')}/{figure}.rst"


def number_of(figure):
    """Return how a text names a figure: 7b for fig07b."""
    return figure.removeprefix("fig").lstrip("0")


def figure_files(figure):
    """Return the picture in two formats and its caption."""
    return [f"<results>/{stem_of(figure)}.{ending}" for ending in ("pdf", "png", "rst")]


def campaign_chunks_behind(figure):
    """Return a function that finds the chunks of the campaigns behind a figure.

    A chunk that a failed or killed job has lost is missed, even where an older merged file is.
    """
    campaigns = [name for name in datasets_of(figure) if name.startswith("campaigns/")]
    return lambda wildcards: [
        chunk for name in campaigns for chunk in campaign_chunks(name.removeprefix("campaigns/"))
    ]


def table_files(table):
    """Return the table in two formats."""
    return [f"<results>/tables/{table}.{ending}" for ending in ("csv", "md")]


# Statements name functions of these modules.
MEASURES = [name for name in MODULES if name.endswith("measures")]


def tabulated_from(table):
    """Return the datasets behind a table: those that it names, or all that a plain call makes."""
    return TABLES[table].get("data", list(default_parameters(config)))


def table_inputs(table):
    """Return the files behind a table, for each argument of its script."""
    files = [data_file(dataset) for dataset in tabulated_from(table)]
    if statements := TABLES[table].get("statements"):
        folder = TABLES[table].get("folder", "config")
        return {"statements": f"{folder}/{statements}", "datasets": files}
    return {"dataset": files[0]} if len(files) == 1 else {"datasets": files}


def table_params(table):
    """Return what a table depends on except its files: code, and the parameters of its data."""
    script, datasets = TABLES[table]["script"], tabulated_from(table)
    if "statements" not in TABLES[table]:
        return {"code": code(script), "parameters": parameters(*datasets)}
    return {
        "code": code(script, *MEASURES),
        "reference": reference(*datasets),
        "parameters": parameters(*datasets),
    }


# The checks of a plain call know the data of a plain call only.
for listed, names, behind in (
    ("figures", DEFAULT_FIGURES, datasets_of),
    ("tables", DEFAULT_TABLES, tabulated_from),
):
    for name in names:
        if others := [one for one in behind(name) if one not in default_parameters(config)]:
            sys.exit(
                f"{name} in workflow/{listed}.yaml is made from {others[0]}, which a plain call "
                f"does not make: correct this name, or give {name} on_demand: true."
            )

FIGURE_FILES = [file for figure in DEFAULT_FIGURES for file in figure_files(figure)]
TABLE_FILES = [file for table in DEFAULT_TABLES for file in table_files(table)]


def made_on_demand():
    """Return the files of each figure and table that was made on demand, by their stem.

    The report shows what is there when the workflow starts, and never causes a measurement.
    """
    files = {stem_of(one): figure_files(one) for one in FIGURES if one not in DEFAULT_FIGURES}
    files |= {f"tables/{one}": table_files(one) for one in TABLES if one not in DEFAULT_TABLES}
    places = {
        stem: [file.replace("<results>", config["results"]) for file in named]
        for stem, named in files.items()
    }
    return {stem: named for stem, named in places.items() if all(map(os.path.exists, named))}


ON_DEMAND = made_on_demand()
