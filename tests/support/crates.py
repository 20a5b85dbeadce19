"""RO-Crates validated without a network, for the test of the crate of a run."""

import json
import re
from importlib import resources
from unittest import mock

import requests
from rocrate_validator import services
from rocrate_validator.models import Severity

WORKFLOW = "https://bioschemas.org/ComputationalWorkflow"
# Terms whose meaning differs between the context of RO-Crate 1.1 and the later one in `rocrate`.
TERMS = {"FormalParameter": "https://bioschemas.org/FormalParameter"}
TERMS |= {"ComputationalWorkflow": WORKFLOW}
TERMS |= {f"{end}put": f"{WORKFLOW}#{end}put" for end in ("in", "out")}
# Recommendations that ask for what is not known: who started the run; a page or an affiliation of
# the authors, who are a group; web addresses of the scripts, the packages and the workflow.
UNKNOWN = re.compile("an agent|have a url|affiliation|`publisher`|absolute uri|bioschemas", re.I)


def violations(crate):
    """Return what a crate violates of the Provenance Run Crate profile and of those below it."""
    shipped = json.loads((resources.files("rocrate") / "data/ro-crate.jsonld").read_text("utf-8"))
    terms = shipped["@context"] | TERMS
    del terms["sha256"]
    # The context is the only document that a validator fetches.
    context = requests.Response()
    context.status_code, context._content = 200, json.dumps({"@context": terms}).encode()
    context.headers["Content-Type"] = "application/ld+json"
    settings = services.ValidationSettings(
        rocrate_uri=str(crate),
        profile_identifier="provenance-run-crate-0.5",
        requirement_severity=Severity.RECOMMENDED,
    )
    with mock.patch("requests_cache.CachedSession.send", return_value=context):
        found = services.validate(settings).get_issues()
    found = {one.message for one in found if one.severity >= Severity.RECOMMENDED}
    return {message for message in found if not UNKNOWN.search(message)}
