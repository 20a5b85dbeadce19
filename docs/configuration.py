"""The keys of the configuration and of campaigns as tables, from their schemas."""

import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, NamedTuple

import yaml

from granular_fronts.campaign.file import CampaignFile
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.model import kinds, laws
from granular_fronts.scenes.configuration import Configuration
from granular_fronts.scenes.parts import LARGEST_WHOLE, Part

CONFIG = Path(__file__).parents[1] / "config"


class Key(NamedTuple):
    """One key below a part of a schema."""

    path: str  # keys joined by dots; ⟨name⟩ is a name of the user's choice, … an entry of a list
    part: Mapping[str, Any]
    required: bool
    kind: str = ""  # for which `kind` of the mapping around it the key is meant

    @property
    def description(self) -> str:
        """What the key means."""
        return self.part.get("description") or self.part.get("const", "")


def keys(
    part: Mapping[str, Any],
    schema: Mapping[str, Any],
    seen: tuple[str, ...] = (),
    path: str = "",
    kind: str = "",
) -> Iterator[Key]:
    """The keys below a part of the schema, in its order.

    Parameters
    ----------
    part : mapping
        The part.
    schema : mapping
        The whole, in which `$ref` points.
    seen : tuple of str
        References that the part is below; one that comes back is not followed again.
    path : str
        Keys of the part, joined by dots.
    kind : str
        For which `kind` the part is meant.

    Yields
    ------
    Key
    """
    reference = part.get("$ref")
    if reference and reference not in seen:
        yield from keys(_pointed_at(reference, schema), schema, (*seen, reference), path, kind)
    below = dict(part.get("properties", {}))
    kind = below.get("kind", {}).get("const", kind)
    if isinstance(part.get("additionalProperties"), dict):
        below["⟨name⟩"] = part["additionalProperties"]
    for entry in part.get("patternProperties", {}).values():
        below["⟨name⟩"] = entry
    for key, value in below.items():
        longer = f"{path}.{key}".removeprefix(".")
        yield Key(longer, _resolved(value, schema), key in part.get("required", []), kind)
        yield from keys(value, schema, seen, longer)
    if "items" in part:
        yield from keys(part["items"], schema, seen, f"{path}.…")
    for choice in ("oneOf", "anyOf"):
        for one in part.get(choice, []):
            yield from keys(one, schema, seen, path, kind)


def _resolved(part: Mapping[str, Any], schema: Mapping[str, Any]) -> dict[str, Any]:
    """A part with what it refers to, and the types of its choices."""
    referred = _pointed_at(part["$ref"], schema) if "$ref" in part else {}
    whole = {**referred, **part}
    choices = [_resolved(one, schema) for one in whole.get("anyOf", whole.get("oneOf", []))]
    choices = [one for one in choices if one.get("type") != "null"]
    for choice in choices[::-1]:
        whole = {**choice, **whole}
    if len(choices) > 1:
        whole["type"] = [*dict.fromkeys(one.get("type", "object") for one in choices)]
    return whole


def distinct_keys(schema: Mapping[str, Any]) -> list[Key]:
    """The keys of a schema, one that several cases share only once."""
    found: dict[tuple[str, str], Key] = {}
    for key in keys(schema, schema):
        if "const" not in key.part:
            found.setdefault((key.path, key.description), key)
    return list(found.values())


def _pointed_at(reference: str, schema: Mapping[str, Any]) -> Mapping[str, Any]:
    """The part of the schema that a JSON pointer such as ``#/$defs/bead`` names."""
    part = schema
    for key in reference.removeprefix("#/").split("/"):
        part = part[key]
    return part


FORMULAS = {
    "hertz": r"$k\,(-r)_+^{\alpha+1}/(\alpha+1)$",
    "toda": r"$a\,(e^{-br} + br - 1)/b$",
    "fpu": r"$\kappa r^2/2 + a r^3/3 + b r^4/4$",
    "morse": r"$D\,(1 - e^{-br})^2$",
    "lennard_jones": r"$D\,(s^{-6} - 1)^2$, $s = 1 + r/d$",
    "power": r"$\gamma\,(-r)_+^{\beta+1}/(\beta+1)$, of W only",
    "linear": r"$\gamma r^2/2$, of W only",
    "none": r"$W = 0$",
    "proportional": r"$W' = \gamma V'$",
    "kuwabara_kono": r"$W' = \gamma V'$ for a Hertz potential, so that $\beta = \alpha$",
    "simon_hunt_crossley": r"that of `power` with $\beta = \alpha + 1$, for a Hertz potential",
}
"""Each kind of `granular_fronts.model.kinds`, and those of W that depend on V."""

TYPES = {
    "array": "list",
    "boolean": "true or false",
    "integer": "whole number",
    "number": "number",
    "object": "mapping",
    "string": "text",
}
LIMITS = {"exclusiveMinimum": ">", "minimum": "≥", "exclusiveMaximum": "<", "maximum": "≤"}
UNITS = {"seconds": "s", "milliseconds": "ms", "metres": "m", "kilograms": "kg", "newtons": "N"}

MOST_NAMES = 6
"""Names that a type lists; more are in the example below."""

LONGEST = 50
"""Letters of a default that is shown."""

COLUMNS = ("key", "type", "default", "unit", "meaning")


def type_of(part: Mapping[str, Any]) -> str:
    """Type and range of a value, in words."""
    if "const" in part:
        return f"`{part['const']}`"
    if len(part.get("enum", [])) > MOST_NAMES:
        return "text"
    if "enum" in part:
        return ", ".join(f"`{name}`" for name in part["enum"])
    given = part.get("type", "object")
    words = " or ".join(TYPES[one] for one in ([given] if isinstance(given, str) else given))
    limits = [
        f"{sign} {part[name]:g}"
        for name, sign in LIMITS.items()
        if name in part and abs(part[name]) < LARGEST_WHOLE
    ]
    inside = part.get("items", {})
    if "list" in words and ("enum" in inside or inside.get("type") in ("number", "integer")):
        return f"{words} of {type_of(inside)}"
    return ", ".join([words, *limits])


def default_of(key: Key, defaults: Any) -> str:
    """What holds where the key is not given: a value, or whether it must be."""
    for one in key.path.split("."):
        defaults = defaults.get(one) if isinstance(defaults, dict) else None
    if defaults is None:
        defaults = key.part.get("default")
    if defaults not in (None, []) and not isinstance(defaults, dict):
        text = yaml.safe_dump(defaults, default_flow_style=True, width=1000).split("\n")[0]
        return f"`{text}`" if len(text) < LONGEST else "as below"
    said = re.search(r"([^\s;,.]+(?:\.\d+)?)(?:,[^.;]*)? by default", key.description)
    return said[1] if said else "required" if key.required else "none"


def table(found: list[Key], defaults: Any = None, within: str = "") -> list[str]:
    """Keys as rows of a Markdown table, their paths without the beginning that all share."""
    rows = [f"| {' | '.join(COLUMNS)} |", "|" + "---|" * len(COLUMNS)]
    for key in found:
        kind, named = type_of(key.part), re.search(r"in (\S+) \(SI\)", key.description)
        unit = UNITS.get(named[1], named[1]) if named else "1" if "number" in kind else ""
        meaning = f"For kind `{key.kind}`: {key.description}" if key.kind else key.description
        cells = [f"`{key.path.removeprefix(within)}`", kind, default_of(key, defaults)]
        cells += [unit, meaning.replace("|", r"\|")]
        rows.append(f"| {' | '.join(cells)} |")
    return ["```{container} keys", *rows, "```"]


def configuration_page() -> str:
    """Every key of the configuration, with an example of each family."""
    schema = Configuration.model_json_schema()
    text = (CONFIG / "default.yaml").read_text(encoding="utf-8")
    defaults = yaml.safe_load(text)
    lines = ["# Configuration", "", schema["description"], ""]
    lines += ["A key in ⟨ ⟩ is a name of your choice; … is an entry of a list. Defaults are the"]
    lines += ["values of `config/default.yaml`, shown at the [end](#a-complete-example)."]
    tables: dict[str, list[Key]] = {}
    for key in (found := distinct_keys(schema)):
        # A family of named entries has a table of its own, and so has a mapping at the top.
        family, named, _ = key.path.partition(".⟨name⟩.")
        single = "." not in key.path and not key.part.get("properties")
        head = f"{family}.⟨name⟩" if named else "At the top" if single else key.path.split(".")[0]
        tables.setdefault(head, []).append(key)
    descriptions = {key.path: key.description for key in reversed(found)}
    for head, rows in tables.items():
        lines += ["", f"## {head}", "", descriptions.get(head, "Keys with a single value.")]
        rows = [key for key in rows if key.path != head or "." not in head]
        lines += ["", *table(rows, defaults, f"{head}." if head.endswith("⟨name⟩") else "")]
        lines += _example(head, defaults)
    lines += ["", "## Kinds of potentials", "", "V of `law.elastic` and W of `law.viscous`."]
    lines += ["", "| kind | potential | parameters |", "|---|---|---|"]
    every = kinds.KINDS | laws._DEPENDENT
    for name, formula in FORMULAS.items():
        given = []
        for key, one in every[name].parameters.items():
            default = "required" if one.default is None else f"{one.default:g} by default"
            given.append(f"`{key}`: {one.meaning}, {default}")
        lines.append(f"| `{name}` | {formula} | {'; '.join(given)} |")
    lines += ["", "## A complete example", "", "The default configuration:", ""]
    lines += ["```yaml", text, "```"]
    return "\n".join(lines) + "\n"


def _example(head: str, defaults: Any) -> list[str]:
    """The first entry of a family in the default configuration, in a block of YAML."""
    *path, last = head.split(".")
    for key in path:
        defaults = defaults.get(key, {})
    if last != "⟨name⟩" or not defaults:
        return []
    name = next(iter(defaults))
    example = {name: defaults[name]}
    for key in reversed(path):
        example = {key: example}
    text = yaml.safe_dump(example, sort_keys=False, default_flow_style=None, width=88)
    return ["", "For example:", "", "```yaml", text.strip(), "```"]


OF_SCENE = "An axis is any number of the scene, such as `start.velocity`."


def campaign_page() -> str:
    """The keys of a campaign, and the axes and scalars of each kind."""
    schema = CampaignFile.model_json_schema()
    lines = ["# Campaigns", "", schema["description"], "", *table(distinct_keys(schema))]
    example = (CONFIG / "campaigns" / "smoke.yaml").read_text(encoding="utf-8").strip()
    lines += ["", "A complete example, `config/campaigns/smoke.yaml`:", ""]
    lines += ["```yaml", example, "```"]
    for name, kind in KINDS.items():
        lines += ["", f"## Kind {name}", ""]
        lines += [*_axes_of(kind.point)] or [OF_SCENE]
        if "law" in kind.keys:
            lines += ["", "With `law`:", "", *_axes_of(kind.point_of_given)]
        for group in kind.one_of:
            lines += ["", f"Give exactly one of {', '.join(f'`{one}`' for one in group)}."]
        lines += ["", "| scalar | meaning |", "|---|---|"]
        lines += [f"| `{key}` | {meaning} |" for key, meaning in kind.scalars.items()]
        (profile, meaning), (along, place) = kind.profile, kind.profile_along
        lines += ["", f"Profile: `{profile}`, {meaning}, along `{along}`, {place}."]
    return "\n".join(lines) + "\n"


def _axes_of(point: type[Part]) -> list[str]:
    """A table of the numbers of a point of a campaign, none if it has none."""
    head = ["| axis | range | default | meaning |", "|---|---|---|---|"]
    rows = []
    for key in distinct_keys(point.model_json_schema()):
        default = "required" if key.required else key.part["default"]
        default = "α" if key.path == "beta" else "none" if default is None else default
        rows.append(f"| `{key.path}` | {type_of(key.part)} | {default} | {key.description} |")
    return [*head, *rows] if rows else []
