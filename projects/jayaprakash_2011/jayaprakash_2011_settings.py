"""What a user may change: the mass ratios that are searched, and where a pulse is measured."""

from typing import Annotated

from pydantic import Field

from granular_fronts.scenes.chain import Tolerance
from granular_fronts.scenes.parts import Distinct, Part, Range


class Dimers(Part):
    """Inverse roots of the mass ratio, and cells between which the attenuation is measured."""

    roots: Range
    cells: Annotated[Distinct[Annotated[int, Field(ge=10, le=100)]], Field(min_length=3)]
    tolerance: Tolerance
