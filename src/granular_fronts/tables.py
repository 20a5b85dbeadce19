"""The one place that writes tables: each for machines with all digits, and rounded for people."""

from granular_fronts.files import complete_file


def write_table(table, rounded, csv, markdown):
    """Write both files, each appearing under its name only when it is complete.

    Parameters
    ----------
    table : pandas.DataFrame
        With all digits.
    rounded : pandas.DataFrame
        What people read, its numbers as text.
    csv, markdown : Path
        Files to write.
    """
    with complete_file(csv) as unfinished:
        table.to_csv(unfinished, index=False)
    with complete_file(markdown) as unfinished:
        rounded.to_markdown(unfinished, index=False, disable_numparse=True)


def round_floats(table, digits):
    """A table whose floats are text of a number of significant digits; all else is left alone."""
    return table.map(lambda cell: f"{cell:.{digits}g}" if isinstance(cell, float) else cell)
