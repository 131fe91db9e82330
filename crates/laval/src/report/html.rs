//! The report as one page that opens offline: findings first, then each study with figures and tables, then the input.

use super::Report;
use super::animation::animation;
use super::embed::hash;
use super::evidence;
use super::first_page;
use super::payload::{Thinning, drawn_on_page, payload};
use super::scene::Scene;
use super::svg::{NARROW, WIDE, render};
use super::text::{escape, prose};
use super::units::Rung;
use super::words::Style;
use super::write::Names;
use crate::outcome::{
    Arg, Column, Data, Finding, Level, Message, Outcome, OutcomeError, Overview, SpecialPoint, Status, Table, significant, unit_text,
};
use std::fmt::Write;

const CSS: &str = concat!(include_str!("assets/report.css"), include_str!("assets/first_page.css"));
const JS: &str = concat!(include_str!("assets/report.js"), include_str!("assets/animation.js"));
/// Rows shown of a table; the files hold all.
const MOST_ROWS: usize = 20;
/// Relative width of a bracket above which it says where a located point was looked for, not how well it is known.
const SEARCHED: f64 = 1e-6;
/// More columns are set narrower and with fewer digits, to fit the page.
const MANY_COLUMNS: usize = 8;
/// Special points shown without unfolding.
const FEW_POINTS: usize = 12;
/// Results listed with a study; warnings are always listed.
const MOST_SHOWN: usize = 200;
/// Results listed in the summary; warnings are always listed.
const MOST_RESULTS: usize = 10;
/// Units at the ticks of logarithmic lengths, which the script writes too.
const LENGTHS: [&str; 4] = ["m", "mm", "µm", "nm"];

/// The report as one HTML page without any reference to the outside.
///
/// # Errors
/// When a figure names a table or column that does not exist.
pub fn html(report: &Report) -> Result<String, OutcomeError> {
    page(report, true).map_err(|e| e.1)
}

/// The page, or the study that contradicts itself and how. `links`: name the CSV files of the tables.
pub(super) fn page(report: &Report, links: bool) -> Result<String, (String, OutcomeError)> {
    let mut scenes = Vec::new();
    for o in &report.outcomes {
        let own: Result<Vec<Scene>, _> = o.figures.iter().map(|f| Scene::new(f, &o.tables, &report.style)).collect();
        scenes.push(own.map_err(|e| (o.name.clone(), e))?);
    }
    let style = &report.style;
    let over = over_speed(report);
    let thinning = Thinning::of(&scenes.iter().flatten().chain(&over).collect::<Vec<_>>());
    let names = Names::new(report);
    let p = &report.provenance;
    let mut s = opening(report);
    match &report.overview {
        Some(page) => {
            answer(&mut s, page, over.as_ref(), thinning, style);
            s.push_str("<details class=\"all\"><summary>");
            s.push_str(&say(style, "page-findings"));
            s.push_str("</summary>\n");
            summary(&mut s, report);
            s.push_str("</details>\n");
        }
        None => summary(&mut s, report),
    }
    for (i, (o, scenes)) in report.outcomes.iter().zip(&scenes).enumerate() {
        study(&mut s, report, scenes, i, thinning, links.then_some(&names)).map_err(|e| (o.name.clone(), e))?;
    }
    evidence::table(&mut s, report);
    if let Some(input) = &report.input {
        let name = style.message(&Message::new("page-input-file").arg("file", Arg::name(&p.input_name)));
        let _ = writeln!(
            s,
            "<section class=\"study\" id=\"input\">\n<h2>{}</h2>\n<details><summary>{}</summary>\n<pre tabindex=\"0\">{}</pre></details>\n</section>",
            say(style, "page-input"),
            prose(name.trim()),
            escape(input)
        );
    }
    let _ = write!(s, "</main>\n<footer>\n<details><summary>{}</summary><dl>", say(style, "page-provenance"));
    let mut row = |k: &Arg, v: &str| {
        let _ = write!(s, "<dt>{}</dt><dd>{}</dd>", prose(&style.arg(k)), prose(v));
    };
    row(&Arg::name("laval"), &p.version);
    if !p.build.is_empty() {
        row(&"build".into(), &p.build);
        row(&"processor level".into(), &p.processor);
    }
    row(&"input".into(), &p.input_name);
    row(&"hash of the input".into(), &p.input_hash);
    if let Some(seed) = p.seed {
        row(&"seed".into(), &seed.to_string());
    }
    p.settings.iter().for_each(|(k, v)| row(&Arg::term(k), v));
    s.push_str("</dl></details>\n</footer>\n</body>\n</html>\n");
    Ok(s)
}

/// The first page of the report by itself: verdict, checks, machine, behaviour over the speed, modes; the findings of a report that has none.
pub fn page_one(report: &Report) -> String {
    let over = over_speed(report);
    let mut s = opening(report);
    match &report.overview {
        Some(page) => answer(&mut s, page, over.as_ref(), Thinning::of(&over.iter().collect::<Vec<_>>()), &report.style),
        None => summary(&mut s, report),
    }
    s.push_str("</main>\n</body>\n</html>\n");
    s
}

/// The behaviour over the speed, drawn.
fn over_speed(report: &Report) -> Option<Scene> {
    let page = report.overview.as_ref()?;
    let over = page.over_speed.as_ref()?;
    Scene::new(&first_page::over_speed(page, over), &first_page::tables(over), &report.style).ok()
}

/// The first page.
fn answer(s: &mut String, page: &Overview, over: Option<&Scene>, thinning: Thinning, style: &Style) {
    first_page::head(s, page, style);
    if let Some(scene) = over {
        drawn(s, scene, "over", thinning, style);
        hint(s, style);
    }
    first_page::tail(s, page, style);
}

/// Up to the beginning of the main part.
fn opening(report: &Report) -> String {
    let style = &report.style;
    let machine = if report.machine.is_empty() { say(style, "page-nameless") } else { prose(&report.machine) };
    let mut s = format!(
        "<!doctype html>\n<html lang=\"{}\">\n<head data-decimal=\"{}\" data-lengths=\"{}\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'sha256-{}'; script-src 'sha256-{}'; base-uri 'none'; form-action 'none'\">\n\
         <title>{machine} · {}</title>\n<style>{CSS}</style>\n<script>{JS}</script>\n</head>\n<body>\n<header>\n<h1>{machine}</h1>\n",
        style.language.code(),
        style.language.number("."),
        LENGTHS.map(|l| style.language.unit(l)).join(" "),
        hash(CSS),
        hash(JS),
        say(style, "page-report"),
    );
    let p = &report.provenance;
    let mut from = Vec::new();
    if !p.input_name.is_empty() {
        from.push(prose(&style.message(&Message::new("page-from").arg("file", Arg::name(&p.input_name)))));
    }
    from.push(format!("laval {}", prose(&p.version)).trim_end().to_string());
    if !p.input_hash.is_empty() {
        let short: String = p.input_hash.chars().take(12).collect();
        from.push(format!("{} <span title=\"{}\">{}</span>", say(style, "page-hash"), prose(&p.input_hash), prose(&short)));
    }
    let _ = writeln!(s, "<p class=\"from\">{}</p>\n</header>\n<main>", from.join(" · "));
    s
}

fn summary(s: &mut String, report: &Report) {
    let heading = say(&report.style, "page-results");
    let _ = write!(
        s,
        "<section class=\"summary\" aria-labelledby=\"findings\">\n<h2 id=\"findings\">{heading}</h2>\n<ul class=\"findings\">\n"
    );
    let many = report.outcomes.len() > 1;
    let all = || report.outcomes.iter().enumerate().flat_map(|(i, o)| o.findings.iter().map(move |f| (i, o, f)));
    let link =
        |i: usize, o: &Outcome| if many { format!(" <a class=\"where\" href=\"#s{i}\">{}</a>", prose(&o.name)) } else { String::new() };
    let mut sorted: Vec<_> = all().filter(|f| f.2.level > Level::Info).collect();
    sorted.sort_by_key(|f| std::cmp::Reverse(f.2.level));
    for (i, o) in report.outcomes.iter().enumerate().filter(|(_, o)| !o.end.is_complete()) {
        let _ = writeln!(
            s,
            "<li class=\"warning\"><span class=\"tag\">! {}</span>{}{}</li>",
            say(&report.style, "page-stopped"),
            prose(&report.style.message(&o.end_message())),
            link(i, o)
        );
    }
    sorted.extend(all().filter(|f| f.2.level == Level::Info));
    // what several studies say in the same words stands once, with all their names
    let mut once: Vec<(&Finding, Vec<(usize, &Outcome)>)> = Vec::new();
    for (i, o, f) in sorted {
        let text = report.style.sentence(f);
        match once.iter_mut().find(|k| k.0.level == f.level && report.style.sentence(k.0) == text) {
            Some((_, places)) => places.push((i, o)),
            None => once.push((f, vec![(i, o)])),
        }
    }
    let urgent = once.iter().filter(|k| k.0.level > Level::Info).count();
    let more = (once.len() - urgent).saturating_sub(MOST_RESULTS);
    let shown = fair(once[urgent..].iter().map(|(_, places)| places[0].0));
    let results = once[urgent..].iter().zip(shown).filter(|r| r.1).map(|r| r.0);
    for (f, places) in once[..urgent].iter().chain(results) {
        let mut places = places.clone();
        places.dedup_by_key(|p| p.0);
        let links: Vec<String> = places.iter().map(|(i, o)| link(*i, o)).collect();
        let _ = writeln!(s, "{}{}</li>", sentence(f, &report.style), links.join(","));
    }
    s.push_str("</ul>\n");
    if more > 0 {
        let _ = writeln!(s, "<p class=\"more\">{}</p>", counted(&report.style, "page-more-studies", more));
    }
    if all().next().is_none() {
        let _ = writeln!(s, "<p class=\"more\">{}</p>", say(&report.style, "page-nothing"));
    }
    if many {
        let _ = write!(s, "<nav aria-label=\"{}\"><ul>", say(&report.style, "page-studies"));
        for (i, o) in report.outcomes.iter().enumerate() {
            let _ = write!(s, "<li><a href=\"#s{i}\">{}</a></li>", prose(&o.name));
        }
        s.push_str("</ul></nav>\n");
    }
    s.push_str("</section>\n");
}

/// Which results the summary shows, of the studies they come from: the first of each study before the second of any, [`MOST_RESULTS`] in all.
fn fair(studies: impl Iterator<Item = usize>) -> Vec<bool> {
    let mut seen: Vec<usize> = Vec::new();
    let ranks: Vec<usize> = studies
        .map(|i| {
            let rank = seen.iter().filter(|s| **s == i).count();
            seen.push(i);
            rank
        })
        .collect();
    let mut order: Vec<usize> = (0..ranks.len()).collect();
    order.sort_by_key(|&k| ranks[k]);
    let mut shown = vec![false; ranks.len()];
    order.iter().take(MOST_RESULTS).for_each(|&k| shown[k] = true);
    shown
}

/// Start of a list item; the caller closes it.
fn sentence(f: &Finding, style: &Style) -> String {
    let tag = match f.level {
        Level::Info => String::new(),
        Level::Warning => format!("<span class=\"tag\">! {}</span>", say(style, "page-warning")),
        Level::Invalid => format!("<span class=\"tag\">!! {}</span>", say(style, "page-outside")),
    };
    format!("<li class=\"{}\">{tag}{}", f.level.word(), prose(&style.sentence(f)))
}

fn study(
    s: &mut String,
    report: &Report,
    scenes: &[Scene],
    i: usize,
    thinning: Thinning,
    names: Option<&Names>,
) -> Result<(), OutcomeError> {
    let (o, overview) = (&report.outcomes[i], &report.overview);
    // the question it answers, and its own name where it has one
    let question = report.style.message(&Message::new(["study-", &o.kind].concat()));
    let name = if o.kind == o.name { String::new() } else { format!("<span class=\"kind\">{}</span>", prose(&o.name)) };
    let _ = writeln!(s, "<section class=\"study\" id=\"s{i}\">\n<h2>{}{name}</h2>", prose(&question));
    if !o.end.is_complete() {
        let _ = writeln!(s, "<p class=\"end stopped\">! {}</p>", prose(&report.style.message(&o.end_message())));
    }
    if !o.findings.is_empty() {
        s.push_str("<ul class=\"findings\">\n");
        let (mut shown, mut left) = (0, 0);
        for (k, f) in o.findings.iter().enumerate() {
            if f.level == Level::Info && shown >= MOST_SHOWN {
                left += 1;
                continue;
            }
            shown += 1;
            s.push_str(&sentence(f, &report.style));
            s.push_str(&evidence::link(&report.style, f, i, k));
            s.push_str("</li>\n");
        }
        s.push_str("</ul>\n");
        if left > 0 {
            let _ = writeln!(s, "<p class=\"more\">{}</p>", counted(&report.style, "page-more", left));
        }
    }
    for (k, scene) in scenes.iter().enumerate() {
        drawn(s, scene, &format!("f{i}-{k}"), thinning, &report.style);
        if i == 0 && k == 0 && overview.is_none() {
            hint(s, &report.style);
        }
    }
    for (k, a) in o.animations.iter().enumerate() {
        s.push_str(&animation(a, &o.tables, &format!("a{i}-{k}"), &report.style)?);
    }
    if !o.special_points.is_empty() {
        special(s, o, &report.style);
    }
    if !o.tables.is_empty() {
        let _ = writeln!(s, "<h3>{}</h3>", say(&report.style, "page-tables"));
    }
    for (k, t) in o.tables.iter().enumerate() {
        table(s, t, &report.style, (o.tables.len() == 1 || t.is_leading()) && t.rows() <= MOST_ROWS, names.map(|n| n.table(i, k)));
    }
    if !o.work.is_empty() {
        let _ = write!(s, "<details><summary>{}</summary><dl>", say(&report.style, "page-work"));
        for (name, count) in &o.work {
            let _ = write!(s, "<dt>{}</dt><dd>{count}</dd>", prose(&report.style.word(name)));
        }
        s.push_str("</dl></details>\n");
    }
    s.push_str("</section>\n");
    Ok(())
}

/// A sentence of the catalogues, escaped.
pub(super) fn say(style: &Style, key: &str) -> String {
    prose(&style.message(&Message::new(key)))
}

/// The same with a count.
fn counted(style: &Style, key: &str, count: usize) -> String {
    prose(&style.message(&Message::new(key).arg("count", Arg::count(count))))
}

/// How to read a figure with the mouse and the keyboard.
fn hint(s: &mut String, style: &Style) {
    let _ = writeln!(s, "<p class=\"hint\">{}</p>", say(style, "page-hint"));
}

/// A figure that the script of the page makes live.
fn drawn(s: &mut String, scene: &Scene, id: &str, thinning: Thinning, style: &Style) {
    if scene.tiles.is_some() {
        let _ = writeln!(
            s,
            "<figure class=\"tiles\" id=\"{id}\">\n<figcaption><b>{}</b></figcaption>\n<div class=\"plot\">",
            prose(&scene.title)
        );
        s.push_str(&render(scene, WIDE, 1.0, Some(id)));
        s.push_str(&render(scene, NARROW, 1.0, Some(id)));
        s.push_str("</div>\n</figure>\n");
        return;
    }
    let _ = writeln!(
        s,
        "<figure class=\"fig\" id=\"{id}\" tabindex=\"0\" aria-labelledby=\"{id}-c\">\n<figcaption id=\"{id}-c\"><b>{}</b></figcaption>\n<div class=\"plot\">",
        prose(&scene.title)
    );
    let column = thinning.column(scene);
    let still = column.max(drawn_on_page(scene));
    s.push_str(&render(scene, WIDE, still, Some(&format!("{id}w"))));
    s.push_str(&render(scene, NARROW, still, Some(&format!("{id}n"))));
    let _ = writeln!(
        s,
        "<div class=\"tip\" hidden aria-live=\"polite\"></div><button type=\"button\" hidden>{}</button></div>\n<script type=\"application/json\">{}</script>\n</figure>",
        say(style, "page-reset"),
        payload(scene, column)
    );
}

/// How far the ends of a point's bracket lie apart; nothing where the point's own equations were solved and the bracket is merely where it was
/// looked for.
fn width(p: &SpecialPoint, size: f64) -> String {
    let width = p.bracket.1 - p.bracket.0;
    if p.status == Status::Located && width > SEARCHED * p.at.abs() { "–".into() } else { significant(width / size, 2) }
}

fn special(s: &mut String, o: &Outcome, style: &Style) {
    let (name, own) = o.parameter.as_ref().map_or(("at", ""), |p| (p.name.as_str(), p.unit.as_str()));
    let rung = style.units.column(name, own);
    let size = rung.as_ref().map_or(1.0, |r| r.size);
    let unit = style.language.unit(&unit_text(rung.as_ref().map_or(own, |r| &r.name)));
    let unit = if unit.is_empty() { String::new() } else { format!("<small>[{}]</small>", prose(&unit)) };
    let name = prose(&style.word(name));
    // many would push the figures of the next study out of sight
    let folded = o.special_points.len() > FEW_POINTS;
    let heading = say(style, "page-points");
    let _ = writeln!(s, "<h3>{heading}</h3>");
    if folded {
        let _ = writeln!(
            s,
            "<details class=\"table\"><summary>{heading} <span class=\"kind\">{}</span></summary>",
            counted(style, "page-rows", o.special_points.len())
        );
    }
    let _ = write!(
        s,
        "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{heading}\"><table><thead><tr><th class=\"w\">{}</th>\
         <th>{name}{unit}</th><th>{}{unit}</th><th class=\"w\">{}</th><th class=\"w\">{}</th></tr></thead><tbody>",
        say(style, "page-kind"),
        say(style, "page-bracket"),
        say(style, "page-status"),
        say(style, "page-evidence")
    );
    for p in o.special_points.iter().take(MOST_ROWS) {
        let SpecialPoint { kind, subject, at, status, evidence, .. } = p;
        let of = if subject.is_empty() { String::new() } else { format!(", {}", prose(&style.subject(subject))) };
        let status = match status {
            Status::Doubtful(reason) => {
                format!("! {}", prose(&style.message(&Message::new("page-doubtful").arg("reason", Arg::term(reason)))))
            }
            s => prose(&style.word(s.word())),
        };
        let list: Vec<String> =
            evidence.iter().map(|e| format!("{} {}", prose(&style.arg(&e.what)), prose(&style.number(e.value, &e.unit)))).collect();
        let _ = write!(
            s,
            "<tr><td class=\"w\">{}{of}</td><td>{}</td><td>{}</td><td class=\"w\">{status}</td><td class=\"w\">{}</td></tr>",
            prose(&style.word(kind)),
            style.language.number(&significant(*at / size, 7)),
            style.language.number(&width(p, size)),
            list.join(", ")
        );
    }
    s.push_str("</tbody></table></div>\n");
    if o.special_points.len() > MOST_ROWS {
        let _ = writeln!(s, "<p class=\"more\">{}</p>", counted(style, "page-more", o.special_points.len() - MOST_ROWS));
    }
    if folded {
        s.push_str("</details>\n");
    }
}

/// The column of a table whose rows have units of their own.
const UNIT: &str = "unit";

/// The unit in which a row with a unit of its own is read, where it is another than that of the results.
fn row_unit(t: &Table, row: usize, style: &Style) -> Option<Rung> {
    let text = |c: &Column| match &c.data {
        Data::Text(v) => v.get(row).cloned(),
        _ => None,
    };
    let unit = t.column(UNIT).and_then(text)?;
    let name = t.columns().iter().find(|c| c.names && c.name != UNIT).and_then(text).unwrap_or_default();
    style.units.column(&name, &unit)
}

fn table(s: &mut String, t: &Table, style: &Style, open: bool, file: Option<&str>) {
    let rows = t.rows();
    let many = t.columns().len() > MANY_COLUMNS;
    let count = counted(style, "page-rows", rows);
    let title = style.arg(t.doc());
    let title = if title.is_empty() { prose(t.name()) } else { prose(&title) };
    let _ = write!(
        s,
        "<details class=\"table\"{}><summary>{title} <span class=\"kind\">{count}</span></summary>\n<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{title}\"><table{}><thead><tr>",
        if open { " open" } else { "" },
        if many { " class=\"many\"" } else { "" }
    );
    let words = |c: &Column| if matches!(c.data, Data::Text(_)) { " class=\"w\"" } else { "" };
    let mut shown: Vec<(&Column, Option<Rung>)> = t.columns().iter().map(|c| (c, style.units.column(&c.name, &c.unit))).collect();
    // a frequency or speed that the table has in rad/s and in Hz or rpm stands once where both are read in that unit
    let again = |name: &str, all: &[(&Column, Option<Rung>)]| {
        let read_in =
            |plain: &str, unit: &str| all.iter().any(|(c, rung)| c.name == plain && rung.as_ref().is_some_and(|r| r.name == unit));
        [("_hz", "Hz"), ("_rpm", "rpm")].iter().any(|(end, unit)| name.strip_suffix(end).is_some_and(|plain| read_in(plain, unit)))
    };
    let twice: Vec<bool> = shown.iter().map(|(c, _)| again(&c.name, &shown)).collect();
    let mut twice = twice.into_iter();
    shown.retain(|_| twice.next() != Some(true));
    for (c, rung) in &shown {
        let unit = rung.as_ref().map_or(c.unit.as_str(), |r| r.name.as_str());
        let unit =
            if unit.is_empty() { String::new() } else { format!("<small>[{}]</small>", prose(&style.language.unit(&unit_text(unit)))) };
        let _ = write!(s, "<th{} title=\"{}\">{}{unit}</th>", words(c), prose(&style.arg(&c.doc)), prose(&style.arg(&c.label)));
    }
    s.push_str("</tr></thead><tbody>");
    let digits = if many { 4 } else { 6 };
    let by_row = t.columns().iter().any(|c| c.in_row_units);
    for r in 0..rows.min(MOST_ROWS) {
        s.push_str("<tr>");
        let of_row = if by_row { row_unit(t, r, style) } else { None };
        for (c, rung) in &shown {
            let rung = if c.in_row_units { &of_row } else { rung };
            let size = rung.as_ref().map_or(1.0, |r| r.size);
            let cell = match &c.data {
                Data::Float(v) if v[r].is_nan() => "–".into(),
                Data::Float(v) => style.language.number(&significant(v[r] / size, digits)),
                Data::Int(v) => v[r].to_string(),
                Data::Text(v) if by_row && c.name == UNIT => {
                    let unit = of_row.as_ref().map_or(v[r].as_str(), |r| r.name.as_str());
                    prose(&style.language.unit(&unit_text(unit)))
                }
                Data::Text(_) if r < c.phrases.len() => prose(&style.arg(&c.phrases[r])),
                Data::Text(v) if c.names => prose(&style.owner(&v[r])),
                Data::Text(v) => prose(&style.word(&v[r])),
                Data::Flag(v) => say(style, if v[r] { "page-yes" } else { "page-no" }),
            };
            let _ = write!(s, "<td{}>{cell}</td>", words(c));
        }
        s.push_str("</tr>");
    }
    s.push_str("</tbody></table></div>\n");
    let first = || Message::new("page-first-rows").arg("first", Arg::count(MOST_ROWS)).arg("count", Arg::count(rows));
    let shown = if rows > MOST_ROWS { prose(&style.message(&first())) } else { String::new() };
    match file {
        Some(f) if rows > 0 => {
            let all = say(style, "page-all-values");
            let _ = write!(s, "<p class=\"more\">{shown} {all} <a href=\"{0}.csv\">{0}.csv</a></p>", escape(f));
        }
        _ if !shown.is_empty() => {
            let _ = write!(s, "<p class=\"more\">{shown}</p>");
        }
        _ => {}
    }
    s.push_str("</details>\n");
}

#[cfg(test)]
mod tests {
    use super::super::units::Units;
    use super::*;

    #[test]
    fn every_study_has_its_say_before_any_has_two() {
        let only = |list: &[usize]| fair(list.iter().copied()).iter().enumerate().filter(|s| *s.1).map(|s| s.0).collect::<Vec<usize>>();
        assert_eq!(only(&[0; 12]), (0..10).collect::<Vec<_>>());
        assert_eq!(only(&[&[0; 12][..], &[1; 3], &[2]].concat()), [0, 1, 2, 3, 4, 5, 12, 13, 14, 15]);
        assert_eq!(only(&[3, 4]), [0, 1]);
    }

    /// A speed that a table has in rad/s and in rpm stands once where it is read in rpm, and twice where it is not.
    #[test]
    fn a_speed_stands_once_in_each_unit() {
        let t = Table::new("t", "").float("speed", "rad/s", "spin speed", vec![100.0]).float("speed_rpm", "rpm", "spin speed", vec![955.0]);
        let t = t.build().unwrap();
        let columns = |units: Units| {
            let mut s = String::new();
            table(&mut s, &t, &Style { units, ..Style::default() }, true, None);
            s.matches("</th>").count()
        };
        let rpm = || [("rpm".to_string(), std::f64::consts::TAU / 60.0, "rad/s".to_string())];
        assert_eq!((columns(Units::new(rpm())), columns(Units::new([]))), (1, 2));
    }

    /// Rows have units of their own, and words put together from numbers those of the reader.
    #[test]
    fn rows_are_read_in_their_own_units() {
        let all = vec![("at 100 rad/s".to_string(), Arg::speed(100.0)), ("none".to_string(), Arg::term("none"))];
        let t = Table::new("t", "")
            .names("quantity", "name", vec!["critical speed".into(), "force".into()])
            .names("unit", "unit", vec!["rad/s".into(), "N".into()])
            .float("value", "", "value", vec![100.0, 5.0])
            .float("ratio", "", "a pure number", vec![100.0, 5.0])
            .phrases("place", "where", all)
            .in_row_units(&["value"]);
        let mut s = String::new();
        let rpm = Units::new([("rpm".to_string(), std::f64::consts::TAU / 60.0, "rad/s".to_string())]);
        table(&mut s, &t.build().unwrap(), &Style { units: rpm, ..Style::default() }, true, None);
        let cells: Vec<&str> = s.split("<td").skip(1).filter_map(|c| c.split('>').nth(1)?.split('<').next()).collect();
        assert_eq!(cells, ["critical speed", "rpm", "954.93", "100", "954.9\u{a0}rpm", "force", "N", "5", "5", "none"]);
    }
}
