"""RO-Crates validated without a network, as tests of the record of a run need it."""

import io
import json
from importlib import resources

import requests
import urllib3
from requests_cache import CachedSession
from rocrate_validator import services
from rocrate_validator.models import Severity

CONTEXT = "https://w3id.org/ro/crate/1.1/context"
AS_IN_1_1 = {
    "ComputationalWorkflow": "https://bioschemas.org/ComputationalWorkflow",
    "FormalParameter": "https://bioschemas.org/FormalParameter",
    "input": "https://bioschemas.org/ComputationalWorkflow#input",
    "output": "https://bioschemas.org/ComputationalWorkflow#output",
    "sha256": None,
}
"""Terms whose meaning differs between the context of RO-Crate 1.1 and the later one at hand."""


def context():
    """The terms of RO-Crate 1.1: those that `rocrate` ships, of a later version, but for a few."""
    shipped = json.loads((resources.files("rocrate") / "data/ro-crate.jsonld").read_text("utf-8"))
    terms = shipped["@context"] | AS_IN_1_1
    return {name: meaning for name, meaning in terms.items() if meaning is not None}


def fill_cache(cache):
    """Put the only document that a validator would fetch into its cache."""
    content = json.dumps({"@context": context()}).encode()
    answer = requests.Response()
    answer.status_code, answer.url, answer._content = 200, CONTEXT, content
    answer.headers["Content-Type"] = "application/ld+json"
    answer.request = requests.Request("GET", CONTEXT).prepare()
    answer.raw = urllib3.HTTPResponse(io.BytesIO(content), answer.headers, preload_content=False)
    with CachedSession(cache, backend="sqlite", expire_after=-1) as session:
        session.cache.save_response(answer)


def violations(crate, folder):
    """What a crate violates of the Provenance Run Crate profile and of those below it.

    Returns
    -------
    tuple of set of str
        Of what is required, and of what is recommended.
    """
    cache = folder / "cache"
    fill_cache(cache)
    settings = services.ValidationSettings(
        rocrate_uri=str(crate),
        profile_identifier="provenance-run-crate-0.5",
        offline=True,
        cache_path=str(cache),
        requirement_severity=Severity.RECOMMENDED,
    )
    issues = services.validate(settings).get_issues()
    return tuple(
        {issue.message for issue in issues if issue.severity == severity}
        for severity in (Severity.REQUIRED, Severity.RECOMMENDED)
    )
