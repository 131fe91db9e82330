"""Results: findings, tables, figures, verdict, report."""

from __future__ import annotations

import math
import pickle
from pathlib import Path

import pytest

import laval
from conftest import ROOT


def test_findings_are_data(rotor: laval.Machine) -> None:
    results = rotor.run()
    assert [study.name for study in results] == ["modes", "critical_speeds", "response"] and results.complete
    critical = results["critical_speeds"]
    finding = next(f for f in critical.findings if f.value is not None and f.unit == "rad/s")
    assert math.isclose(finding.value or 0.0, math.sqrt(3e5 / 3), rel_tol=1e-3)
    assert finding.severity in ("info", "warning") and finding.study == "critical_speeds"
    assert any(isinstance(value, laval.Value) for value in finding.values.values())
    assert finding.evidence and all(isinstance(e.value, float) for e in finding.evidence)
    # in the units of the file, and in other languages
    assert "rpm" in finding.text
    assert len({finding.text, *(finding.in_language(code) for code in ("ru", "kk", "uz"))}) == 4
    again = pickle.loads(pickle.dumps(finding))
    assert again == finding and again.text == finding.text and again.in_language("ru") == finding.in_language("ru")
    with pytest.raises(ValueError, match="unknown language"):
        finding.in_language("la")


def test_verdict_and_checks(rotor: laval.Machine) -> None:
    results = rotor.run()
    assert results.verdict in ("passed", "attention", "failed", "not_computed", "no_limit")
    assert results.headline
    check = results.checks[0]
    assert check.name.startswith("check-") and check.title and check.result
    data = results.data()
    assert data["overview"]["verdict"] == results.verdict
    assert [c["check"] for c in data["overview"]["checks"]] == [c.name for c in results.checks]
    assert results.overview("ru")["headline"] != results.headline


def test_report_and_notebook(rotor: laval.Machine) -> None:
    results = rotor.run()
    page = results.report_html()
    assert page.startswith("<!doctype html>") and "Laval rotor" in page and 'lang="ru"' in results.report_html("ru")
    shown = results._repr_html_()
    assert shown.startswith("<iframe") and 'sandbox="allow-scripts"' in shown
    assert "<script>" not in shown.replace("&lt;script&gt;", "")
    assert len(shown) < len(page) * 2
    assert "Laval rotor" in str(results)


def test_a_subset_and_studies_given_to_the_run(rotor: laval.Machine) -> None:
    assert [s.name for s in rotor.run(only="forced_response")] == ["response"]
    assert [s.name for s in rotor.run(only=["modes", "response"])] == ["modes", "response"]
    own = rotor.run(laval.studies.modes(name="faster", speed="9000 rpm"))
    assert [s.name for s in own] == ["faster"]
    with pytest.raises(ValueError, match="did you mean"):
        rotor.run(only="mode")
    with pytest.raises(KeyError, match="no study 'x' was run"):
        own["x"]


def test_a_study_that_the_machine_cannot_answer_is_a_warning(rotor: laval.Machine) -> None:
    with pytest.warns(laval.MachineWarning, match="all parts of this machine are linear") as caught:
        results = rotor.run(laval.studies.backbone(), laval.studies.modes(), laval.studies.backbone(name="again"))
    assert [study.end for study in results] == ["refused", "reached", "refused"] and not results.complete
    assert len(caught) == 2 and caught[0].filename == __file__
    assert [f.id for f in results.findings if "refused" in f.id] == ["refused", "refused"]


def test_files(rotor: laval.Machine, tmp_path: object) -> None:
    results = rotor.run()
    written = results.write(str(tmp_path), formats=["json", "csv"])
    assert {path.rsplit(".", 1)[1] for path in written} == {"json", "csv"}
    with pytest.raises(ValueError, match="unknown format"):
        results.write(str(tmp_path), formats=["docx"])


def test_progress_is_shown(rotor: laval.Machine) -> None:
    seen: list[tuple[str, float, int]] = []
    rotor.run(progress=lambda *now: seen.append(now))
    assert seen and all(isinstance(name, str) and done >= 0 and total >= 0 for name, done, total in seen)

    def broken(*_: object) -> None:
        raise LookupError("of the user")

    with pytest.raises(LookupError, match="of the user"):
        rotor.run(progress=broken)
    pytest.importorskip("tqdm")
    assert rotor.run(progress=True).complete


@pytest.mark.parametrize("example", ["01-oil-separator", "02-rigid-rotor", "03-overhung-disc"])
def test_whole_results_pickle(example: str, tmp_path: Path) -> None:
    results = laval.load(ROOT / "examples" / example / "machine.toml").run()
    content = pickle.dumps(results)
    again = pickle.loads(content)
    assert again.findings == results.findings and again.tables == results.tables
    for study, other in zip(results, again):
        assert study.special_points == other.special_points and (study.end, study.work) == (other.end, other.work)
        assert study.end_text == other.end_text
        for name, figure in study.figures.items():
            assert figure.data == other.figures[name].data and figure.svg("ru") == other.figures[name].svg("ru")
    for language in (None, "kk"):
        assert again.summary(language) == results.summary(language)
        assert again.overview(language) == results.overview(language)
    # every file is that of the results themselves, also after another journey
    for k, each in enumerate((results, again, pickle.loads(pickle.dumps(again)))):
        each.write(tmp_path / str(k))
    files = [{p.relative_to(f): p.read_bytes() for p in f.rglob("*") if p.is_file()} for f in (tmp_path / str(k) for k in range(3))]
    assert files[0] == files[1] == files[2] and len(files[0]) > 5
    one = pickle.loads(pickle.dumps(results[0]))
    assert one.name == results[0].name and one.tables == results[0].tables


def test_results_of_another_build_are_refused(rotor: laval.Machine) -> None:
    call, (text, origin, build, content) = rotor.run(only="modes").__reduce__()
    assert call(text, origin, build, content)[0].name == "modes"
    with pytest.raises(ValueError, match="another build"):
        call(text, origin, build + "x", content)
    with pytest.raises(ValueError, match="no results"):
        call(text, origin, build, content[:-1])


def test_results_after_a_stop_pickle(rotor: laval.Machine) -> None:
    def stop(*_: object) -> None:
        raise KeyboardInterrupt

    long = laval.studies.transient(name="long", duration="100000 s", initial={"disc.x": "1 mm"})
    results = rotor.run(laval.studies.modes(), long, progress=stop, interrupted="return")
    assert [study.end for study in results] in (["reached", "cancelled"], ["cancelled", "cancelled"])
    again = pickle.loads(pickle.dumps(results))
    assert [study.end for study in again] == [study.end for study in results] and not again.complete
    assert again.verdict is None and again.overview() == results.overview() == {}
