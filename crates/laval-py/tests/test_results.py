"""Results: findings, tables, figures, verdict, report."""

from __future__ import annotations

import math
import pickle

import pytest

import laval


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


def test_results_say_how_they_travel(rotor: laval.Machine) -> None:
    with pytest.raises(TypeError, match="findings and tables"):
        pickle.dumps(rotor.run(only="modes"))
