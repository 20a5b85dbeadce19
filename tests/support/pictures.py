"""What is drawn in a panel."""


def curves(axes):
    """Lines and markers that show data, in the order in which they were drawn."""
    return [line for line in axes.get_lines() if line.get_transform() is axes.transData]


def plane(axes):
    """The one coloured plane of a panel."""
    [mesh] = [each for each in axes.collections if each.get_array() is not None]
    return mesh
