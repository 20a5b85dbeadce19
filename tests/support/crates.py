"""RO-Crates validated without a network, for the test of the crate of a run."""

import io
import json
import re
from importlib import resources

import requests
import urllib3
from requests_cache import CachedSession
from rocrate_validator import services
from rocrate_validator.models import Severity

CONTEXT = "https://w3id.org/ro/crate/1.1/context"
WORKFLOW = "https://bioschemas.org/ComputationalWorkflow"
# Terms whose meaning differs between the context of RO-Crate 1.1 and the later one in `rocrate`.
TERMS = {"FormalParameter": "https://bioschemas.org/FormalParameter"}
TERMS |= {"ComputationalWorkflow": WORKFLOW}
TERMS |= {f"{end}put": f"{WORKFLOW}#{end}put" for end in ("in", "out")}
# Recommendations that ask for what is not known: who started the run; a page or an affiliation of
# the authors, who are a group; web addresses of the scripts, the packages and the workflow.
UNKNOWN = re.compile("an agent|have a url|affiliation|`publisher`|absolute uri|bioschemas", re.I)


def violations(crate, folder):
    """Return what a crate violates of the Provenance Run Crate profile and of those below it."""
    # The only document that a validator would fetch is put into its cache.
    shipped = json.loads((resources.files("rocrate") / "data/ro-crate.jsonld").read_text("utf-8"))
    terms = shipped["@context"] | TERMS
    del terms["sha256"]
    content = json.dumps({"@context": terms}).encode()
    answer = requests.Response()
    answer.status_code, answer.url, answer._content = 200, CONTEXT, content
    answer.headers["Content-Type"] = "application/ld+json"
    answer.request = requests.Request("GET", CONTEXT).prepare()
    answer.raw = urllib3.HTTPResponse(io.BytesIO(content), answer.headers, preload_content=False)
    with CachedSession(str(folder / "cache"), backend="sqlite", expire_after=-1) as session:
        session.cache.save_response(answer)
    settings = services.ValidationSettings(
        rocrate_uri=str(crate),
        profile_identifier="provenance-run-crate-0.5",
        offline=True,
        cache_path=str(folder / "cache"),
        requirement_severity=Severity.RECOMMENDED,
    )
    found = services.validate(settings).get_issues()
    found = {one.message for one in found if one.severity >= Severity.RECOMMENDED}
    return {message for message in found if not UNKNOWN.search(message)}
