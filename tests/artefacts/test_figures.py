"""Each dataset and figure is there, whole, with a caption, and says what it was made from."""

import re

from conftest import read_dataset

from granular_fronts.output.datasets import configuration_of


def test_data_answer_the_configuration(results, made):
    for name, (parameters, _) in made["datasets"].items():
        assert configuration_of(read_dataset(results / f"data/{name}.nc")) == parameters, name


def test_pictures_are_whole_and_name_what_they_were_drawn_from(results, made):
    data = [read_dataset(results / f"data/{name}.nc").attrs for name in made["datasets"]]
    present = {f"{attributes['scene']}:{attributes['data_digest']}" for attributes in data}
    for name in made["figures"]:
        for ending, start, end in (("png", b"\x89PNG", b"IEND"), ("pdf", b"%PDF", b"%%EOF")):
            content = (results / f"figures/{name}.{ending}").read_bytes()
            assert content.startswith(start)
            assert end in content[-12:]
            named = re.findall(rb"([a-z]\w*:[0-9a-f]{16})", content)
            assert named, name
            assert {one.decode() for one in named} <= present, name


def test_captions_are_filled(results, made):
    for name in made["figures"]:
        caption = (results / f"figures/{name}.rst").read_text(encoding="utf-8")
        assert caption.strip()
        assert not re.search(r"[{}]{2}|\bNone\b", caption), name
