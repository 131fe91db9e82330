"""The studio from Python: its page, what was changed there, its end."""

from __future__ import annotations

import json
import urllib.error
import urllib.request
from pathlib import Path

import pytest

import laval
from conftest import ROOT

FILE = ROOT / "examples" / "02-rigid-rotor" / "machine.toml"


def request(address: str, path: str, body: object = None) -> tuple[int, str]:
    data = None if body is None else json.dumps(body).encode()
    origin = "/".join(address.split("/")[:3])
    headers = {} if data is None else {"Content-Type": "application/json", "Origin": origin}
    try:
        with urllib.request.urlopen(urllib.request.Request(address + path, data, headers), timeout=60) as answer:
            return answer.status, answer.read().decode()
    except urllib.error.HTTPError as error:
        return error.code, ""


def test_the_page_is_served_and_its_changes_come_back(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    machine = laval.load(FILE)
    with laval.studio(machine, browser=False) as studio:
        assert studio.address.startswith("http://127.0.0.1:") and studio.text == machine.text
        status, page = request(studio.address, "")
        assert status == 200 and "<html" in page
        start = json.loads(request(studio.address, "api/start")[1])
        assert start["text"] == machine.text
        changed = machine.text.replace("2.4 kg", "2.6 kg")
        assert changed != machine.text
        assert request(studio.address, "api/check", {"text": changed})[0] == 200
        assert studio.text == changed
        assert studio.machine.parameters["drum.mass"].value == 2.6
        wrong = studio.address.rstrip("/")[:-1] + "/"
        assert request(wrong, "")[0] == 403
    with pytest.raises(OSError):
        for _ in range(100):
            request(studio.address, "")


def test_a_wrong_language_is_refused() -> None:
    with pytest.raises(ValueError):
        laval.studio(laval.load(FILE), browser=False, language="xx")


def test_a_notebook_shows_it_in_a_frame() -> None:
    pytest.importorskip("anywidget")
    with laval.studio(laval.load(FILE), browser=False) as studio:
        shown = studio._repr_mimebundle_()
        data = shown[0] if isinstance(shown, tuple) else shown
        assert "application/vnd.jupyter.widget-view+json" in data
