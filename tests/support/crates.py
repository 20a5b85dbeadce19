"""RO-Crates validated without a network, as the test of the record of a run needs it."""

import io
import json
from importlib import resources

import requests
import urllib3
from requests_cache import CachedSession
from rocrate_validator import services
from rocrate_validator.models import Severity

CONTEXT = "https://w3id.org/ro/crate/1.1/context"
WORKFLOW = "https://bioschemas.org/ComputationalWorkflow"
AS_IN_1_1 = {
    "ComputationalWorkflow": WORKFLOW,
    "FormalParameter": "https://bioschemas.org/FormalParameter",
    "input": f"{WORKFLOW}#input",
    "output": f"{WORKFLOW}#output",
}
"""Terms whose meaning differs between the context of RO-Crate 1.1 and the later one at hand."""

UNKNOWN = {
    # Who started the run.
    "The Action SHOULD have an agent that is a Person or Organization",
    # The authors are a group without a page, and so is the publisher.
    "The organization SHOULD have a URL.",
    "The author SHOULD have an organizational affiliation.",
    "The author SHOULD have a Contextual Entity which specifies the organizational `affiliation`.",
    "The `publisher` property of a `Root Data Entity` SHOULD be an `Organization`",
    # A script has a path in the crate, and a package a package URL, which is no web address.
    "The Application SHOULD have a url",
    "The SoftwareApplication id SHOULD be an absolute URI",
    # That profile asks for an address of the workflow.
    "The Main Workflow SHOULD comply with Bioschemas ComputationalWorkflow profile version 1.0 "
    "or later",
}
"""Recommendations that cannot be followed, since what they ask for is not known."""


def violations(crate, folder):
    """What a crate violates of the Provenance Run Crate profile and of those below it."""
    # The only document that a validator would fetch is put into its cache.
    shipped = json.loads((resources.files("rocrate") / "data/ro-crate.jsonld").read_text("utf-8"))
    terms = shipped["@context"] | AS_IN_1_1
    del terms["sha256"]
    content = json.dumps({"@context": terms}).encode()
    answer = requests.Response()
    answer.status_code, answer.url, answer._content = 200, CONTEXT, content
    answer.headers["Content-Type"] = "application/ld+json"
    answer.request = requests.Request("GET", CONTEXT).prepare()
    answer.raw = urllib3.HTTPResponse(io.BytesIO(content), answer.headers, preload_content=False)
    cache = str(folder / "cache")
    with CachedSession(cache, backend="sqlite", expire_after=-1) as session:
        session.cache.save_response(answer)
    settings = services.ValidationSettings(
        rocrate_uri=str(crate),
        profile_identifier="provenance-run-crate-0.5",
        offline=True,
        cache_path=cache,
        requirement_severity=Severity.RECOMMENDED,
    )
    found = services.validate(settings).get_issues()
    return {one.message for one in found if one.severity >= Severity.RECOMMENDED} - UNKNOWN
