//! Figures as data: axes in the units of the reader, marks over columns of tables.

use laval::outcome::{Arg, Axis, Band, BandPlace, Figure, Heat, Line, Mark, Panel, Points, Rule, Scale, Text, unit_text};
use laval::plain;
use laval::report::Style;
use serde_json::{Value, json};

/// A figure whose axes are in the units of the reader.
pub fn json(figure: &Figure, style: &Style) -> Value {
    let words = Words(style);
    json!({
        "name": figure.name,
        "title": words.arg(&figure.title),
        "alt": plain::line(&style.message(&figure.alt)),
        "x": words.axis(&figure.x),
        "equal": figure.equal,
        "panels": figure.panels.iter().map(|p| words.panel(p)).collect::<Vec<_>>(),
    })
}

struct Words<'a>(&'a Style);

impl Words<'_> {
    fn arg(&self, arg: &Arg) -> String {
        plain::line(&self.0.arg(arg)).into_owned()
    }

    fn axis(&self, a: &Axis) -> Value {
        json!({
            "label": self.arg(&a.label),
            "unit": self.0.language.unit(&unit_text(&a.unit)),
            "log": a.scale == Scale::Log,
            "factor": a.factor,
            "range": a.range,
            "bare": a.bare,
            "names": a.names.iter().map(|(at, name)| json!([at, self.arg(name)])).collect::<Vec<_>>(),
            "knee": a.knee,
        })
    }

    fn panel(&self, p: &Panel) -> Value {
        json!({ "y": self.axis(&p.y), "height": p.height, "marks": p.marks.iter().map(|m| self.mark(m)).collect::<Vec<_>>() })
    }

    fn mark(&self, mark: &Mark) -> Value {
        match mark {
            Mark::Line(m) => self.line(m),
            Mark::Points(m) => self.points(m),
            Mark::Band(m) => self.band(m),
            Mark::Rule(m) => self.rule(m),
            Mark::Heat(m) => self.heat(m),
            Mark::Text(Text { x, y, text }) => json!({ "mark": "text", "x": x, "y": y, "text": self.arg(text) }),
        }
    }

    fn names(&self, list: &[(String, Arg)]) -> Value {
        list.iter().map(|(key, name)| (key.clone(), json!(self.arg(name)))).collect()
    }

    fn line(&self, m: &Line) -> Value {
        json!({
            "mark": "line",
            "table": m.table,
            "x": m.x,
            "y": m.y,
            "group": m.group,
            "class": m.class,
            "solid_where": m.solid_where,
            "solid_only": m.solid_only,
            "begins_where": m.begins_where,
            "valid_where": m.valid_where,
            "name": self.arg(&m.name),
            "called": self.names(&m.called),
            "reference": m.reference,
            "muted": m.muted,
            "ink": m.ink,
            "wrapped": m.wrapped,
            "period": m.period,
        })
    }

    fn points(&self, m: &Points) -> Value {
        json!({
            "mark": "points",
            "table": m.table,
            "x": m.x,
            "y": m.y,
            "group": m.group,
            "filled_where": m.filled_where,
            "name": self.arg(&m.name),
            "muted": m.muted,
            "small": m.small,
        })
    }

    fn band(&self, m: &Band) -> Value {
        let place = match &m.place {
            BandPlace::X(from, to) => json!({ "along": "x", "from": from, "to": to }),
            BandPlace::Y(from, to) => json!({ "along": "y", "from": from, "to": to }),
            BandPlace::Between(table, x, low, high) => json!({ "along": "curves", "table": table, "x": x, "low": low, "high": high }),
            BandPlace::Across(table, y, left, right) => {
                json!({ "along": "sideways", "table": table, "y": y, "left": left, "right": right })
            }
        };
        json!({ "mark": "band", "place": place, "name": self.arg(&m.name), "tint": m.tint, "bar": m.bar })
    }

    fn rule(&self, m: &Rule) -> Value {
        json!({ "mark": "rule", "vertical": m.vertical, "at": m.at, "label": self.arg(&m.label) })
    }

    fn heat(&self, m: &Heat) -> Value {
        json!({
            "mark": "heat",
            "table": m.table,
            "x": m.x,
            "y": m.y,
            "value": m.value,
            "colours": self.axis(&m.colours),
            "diverging": m.diverging,
            "contour": m.contour,
            "classes": m.classes,
            "called": self.names(&m.called),
        })
    }
}
