r"""Means of the numbers of a campaign over one of its axes, such as the seed of random draws.

With K values :math:`a_k` of a number the mean and its standard error are

.. math:: \bar a = \frac1K \sum_k a_k, \qquad
    s = \Bigl( \sum_k \frac{(a_k - \bar a)^2}{K (K - 1)} \Bigr)^{1/2} .

Points that failed, and numbers that a point does not have, are left out.  The error of a mean is
half of Student's interval of 95 per cent, :math:`\tfrac12 t_{K-1}\,s`, and the error of the values.
For many values this is s.  Of a single value the scatter is not known.
"""

import numpy as np
import xarray as xr
from scipy.special import stdtrit


def mean_over(campaign: xr.Dataset, axis: str) -> xr.Dataset:
    """Return the mean of each number of a merged campaign over an axis, and its error."""
    means = {}
    for name, values in campaign.data_vars.items():
        if axis in values.dims and "error_estimate" in values.attrs:
            count = values.count(axis)
            freedom = (count - 1).where(count > 1)
            scatter = 0.5 * stdtrit(freedom, 0.975) * np.sqrt(values.var(axis) / freedom)
            error = (scatter + values.attrs["error_estimate"]).fillna(np.inf)
            means[name] = values.mean(axis).assign_attrs(long_name=f"mean {name}")
            means[f"{name}_error"] = error.assign_attrs(long_name=f"error of the mean {name}")
    return xr.Dataset(means)
