//! A figure with its columns looked up: values in display units, axis ranges, colours, legend. Layout and drawing follow from it.

mod axes;
mod cut;
mod paths;
pub(super) mod whirl;

use self::axes::{axis_view, extent, x_axis, y_axis};
use self::cut::{Cut, cut};
use self::paths::{ends, pieces_of, smooth, split, unwrap};
use super::colour::Colour;
use super::heat::HeatView;
use super::ticks::AxisView;
use super::words::Style;
use crate::outcome::{
    Arg, Band, BandPlace, Column, Data, Figure, Mark, Message, OutcomeError, Panel, Quantity, Role, Scale, Table, significant, unit_text,
};

pub(super) struct Scene {
    pub title: String,
    pub alt: String,
    /// Language and units of the reader.
    pub style: Style,
    pub x: AxisView,
    pub panels: Vec<PanelView>,
    pub legend: Vec<Entry>,
    /// Square panels: x and y to one scale.
    pub equal: bool,
    /// Small pictures in place of panels.
    pub tiles: Option<whirl::TilesView>,
}

pub(super) struct PanelView {
    pub y: AxisView,
    pub heat: Option<HeatView>,
    pub bands: Vec<BandView>,
    pub series: Vec<Series>,
    pub rules: Vec<RuleView>,
    pub texts: Vec<(f64, f64, String)>,
    /// Where curves leave a range that the axis was given.
    pub cut: Vec<Cut>,
    /// Curves whose ends are named, in display units.
    pub ends: Vec<(Vec<(f64, f64)>, String)>,
    /// Height over that of the other panels.
    pub height: f64,
}

/// Points in display units; NaN breaks a line.
pub(super) struct Series {
    /// Name for reading out; may be empty.
    pub name: String,
    /// Meaning of the line style for reading out: stable, unstable.
    pub state: String,
    pub kind: Kind,
    pub colour: Colour,
    pub points: Vec<(f64, f64)>,
    /// Entry of the legend that switches it.
    pub entry: Option<usize>,
    /// Reference line: thin, named at its end.
    pub reference: bool,
    /// Curves drawn upon it that may hide it: so many steps wider it is drawn.
    pub below: usize,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Kind {
    Solid,
    Dashed,
    Marker { shape: usize, open: bool },
}

pub(super) struct BandView {
    /// Outline in display units; infinite coordinates mean the border of the panel.
    pub outline: Vec<(f64, f64)>,
    pub tint: usize,
    /// With a strip at the upper border.
    pub strip: bool,
    /// In full colour.
    pub bar: bool,
}

pub(super) struct RuleView {
    pub vertical: bool,
    pub at: f64,
    pub label: String,
}

pub(super) struct Entry {
    pub label: String,
    pub colour: Colour,
    pub glyph: Glyph,
}

#[derive(Clone, Copy, PartialEq, Debug)]
pub(super) enum Glyph {
    Line,
    Dashed,
    Marker { shape: usize, open: bool },
    Tint(usize),
    Block(usize),
    Contour,
}

/// Shapes from here on belong to classes: their sizes differ.
pub(super) const CLASS: usize = 10;
/// Shapes from here on are small.
pub(super) const SMALL: usize = 20;

/// Shapes from here on are arrowheads, by so many degrees against the clock from the direction of x.
pub(super) const ARROW: usize = 1000;

/// The tint of strips: they warn.
const STRIP_TINT: usize = 1;
/// Tints of areas that have none of their own; the fifth, grey, marks unknown ranges.
const FREE_TINTS: usize = 4;

/// Most groups that get a colour of the palette; more get the ramp.
const PALETTE_GROUPS: usize = 7;
/// Words of a map of more that get such a colour all the same.
const FIXED: usize = 6;

impl Scene {
    /// A figure in the words and units of a reader.
    ///
    /// # Errors
    /// When it names a table or column that does not exist.
    pub fn new(figure: &Figure, tables: &[Table], style: &Style) -> Result<Scene, OutcomeError> {
        figure.check(tables)?;
        let figure = &style.units.figure(figure);
        let mut build = Build { figure, tables, style, legend: Vec::new(), names: Vec::new(), tints: 0 };
        // words keep the colours of their places, whatever else there is to see
        for mark in figure.panels.iter().flat_map(|p| &p.marks) {
            if let Mark::Heat(m) = mark {
                let fixed = m.classes.len().min(if m.classes.len() > PALETTE_GROUPS { FIXED } else { PALETTE_GROUPS });
                for class in &m.classes[..fixed] {
                    build.colour(class, 0, 1);
                }
            }
        }
        let mut drafts: Vec<PanelView> = figure.panels.iter().map(|p| build.panel(p)).collect();
        let mut x = x_axis(&figure.x, &drafts, style);
        for (draft, panel) in drafts.iter_mut().zip(&figure.panels) {
            draft.y = y_axis(&panel.y, draft, &x, style);
            if panel.y.range.is_some() {
                draft.cut = cut(&draft.series, &x, &draft.y);
            }
        }
        if figure.equal {
            let span = drafts.iter().map(|d| d.y.hi - d.y.lo).fold(x.hi - x.lo, f64::max);
            for a in drafts.iter_mut().map(|d| &mut d.y).chain([&mut x]) {
                let middle = 0.5 * (a.lo + a.hi);
                let wide = AxisView::new(&a.label, &a.unit, a.log, middle - 0.5 * span, middle + 0.5 * span);
                *a = AxisView { language: a.language, ..wide };
            }
        }
        let mut legend = build.legend;
        // a single unnamed curve needs no legend
        if legend.iter().all(|e| e.label.is_empty()) {
            legend.clear();
            drafts.iter_mut().flat_map(|d| &mut d.series).for_each(|s| s.entry = None);
        }
        let (title, alt) = (style.arg(&figure.title), style.message(&figure.alt));
        let tiles = figure.tiles.as_ref().and_then(|t| whirl::TilesView::new(t, tables, style));
        Ok(Scene { title, alt, style: style.clone(), x, panels: drafts, legend, equal: figure.equal, tiles })
    }

    /// Whether there is anything to see.
    pub fn is_empty(&self) -> bool {
        let visible = |p: &PanelView| {
            p.heat.as_ref().is_some_and(|h| h.values.iter().any(|v| v.is_finite()))
                || p.series.iter().any(|s| s.points.iter().any(|(a, b)| self.x.place(*a).is_finite() && p.y.place(*b).is_finite()))
                || !p.bands.is_empty()
                || !p.rules.is_empty()
        };
        !self.panels.iter().any(visible)
    }
}

struct Build<'a> {
    figure: &'a Figure,
    tables: &'a [Table],
    style: &'a Style,
    legend: Vec<Entry>,
    /// Names that have a colour, in order of appearance.
    names: Vec<String>,
    tints: usize,
}

struct Group {
    /// What figures know it by: the value of the column, behind the name of the mark.
    key: String,
    /// The same for readers.
    name: String,
    rows: Vec<usize>,
}

impl Build<'_> {
    fn column(&self, table: &str, column: &str) -> Option<&Column> {
        self.tables.iter().find(|t| t.name() == table)?.column(column)
    }

    fn values(&self, table: &str, column: &str, factor: f64) -> Vec<f64> {
        let Some(c) = self.column(table, column) else { return Vec::new() };
        (0..c.data.len()).map(|i| c.number(i).map_or(f64::NAN, |v| v * factor)).collect()
    }

    /// Numbers of a column, or places of its words among `classes`; NaN for others.
    fn places(&self, table: &str, column: &str, classes: &[String], factor: f64) -> Vec<f64> {
        match self.column(table, column).map(|c| &c.data) {
            Some(Data::Text(words)) => {
                let place = |w: &String| classes.iter().position(|c| c == w).map_or(f64::NAN, |k| k as f64);
                words.iter().map(place).collect()
            }
            _ => self.values(table, column, factor),
        }
    }

    fn flags(&self, table: &str, column: Option<&String>) -> Option<&[bool]> {
        match &self.column(table, column?)?.data {
            Data::Flag(v) => Some(v),
            _ => None,
        }
    }

    fn say(&self, arg: &Arg) -> String {
        self.style.arg(arg)
    }

    /// A value of a column that splits it: for the figure, and for readers.
    fn value(&self, c: &Column, row: usize) -> (String, String) {
        let label = || self.say(&c.label);
        let key = |value: &str| format!("{} {value}", c.name);
        match &c.data {
            Data::Text(v) if c.names => (v[row].clone(), self.style.owner(&v[row])),
            Data::Text(v) => (v[row].replace('_', " "), self.style.word(&v[row])),
            Data::Int(v) => (key(&v[row].to_string()), format!("{} {}", label(), v[row])),
            Data::Flag(v) => (key(&v[row].to_string()), if v[row] { label() } else { self.negated(&c.label) }),
            Data::Float(v) => {
                let quantity = Quantity { value: v[row], unit: c.unit.clone(), role: Role::Plain, digits: Some(4) };
                (key(&significant(v[row], 4)), format!("{} {}", label(), self.style.quantity(&quantity)))
            }
        }
    }

    /// What a flag that is not set means.
    fn negated(&self, label: &Arg) -> String {
        self.style.message(&Message::new("label-not").arg("what", label.clone()))
    }

    fn groups(&self, table: &str, column: Option<&String>, name: &Arg, rows: usize) -> Vec<Group> {
        let name = self.say(name);
        let Some(c) = column.and_then(|c| self.column(table, c)) else {
            return vec![Group { key: name.clone(), name, rows: (0..rows).collect() }];
        };
        let mut groups: Vec<Group> = Vec::new();
        let mut index = std::collections::HashMap::new();
        for i in 0..rows.min(c.data.len()) {
            let (key, word) = self.value(c, i);
            let k = *index.entry(key.clone()).or_insert_with(|| {
                let behind = |text: String| if name.is_empty() { text } else { format!("{name}, {text}") };
                groups.push(Group { key: behind(key), name: behind(word), rows: Vec::new() });
                groups.len() - 1
            });
            groups[k].rows.push(i);
        }
        groups
    }

    /// Groups cut where the class of their rows changes, each piece with its class; a piece reaches to the first row of the next.
    fn classed(&self, groups: Vec<Group>, table: &str, class: Option<&String>) -> Vec<(Group, Option<String>)> {
        let Some(Data::Text(words)) = class.and_then(|c| self.column(table, c)).map(|c| &c.data) else {
            return groups.into_iter().map(|g| (g, None)).collect();
        };
        let mut out: Vec<(Group, Option<String>)> = Vec::new();
        for g in groups {
            let mut begin = 0;
            for run in g.rows.chunk_by(|a, b| words[*a] == words[*b]) {
                let end = (begin + run.len() + 1).min(g.rows.len());
                out.push((
                    Group { key: g.key.clone(), name: g.name.clone(), rows: g.rows[begin..end].to_vec() },
                    Some(words[run[0]].clone()),
                ));
                begin += run.len();
            }
        }
        out
    }

    fn colour(&mut self, name: &str, index: usize, of: usize) -> Colour {
        if of > PALETTE_GROUPS {
            return Colour::Ramp(index as f64 / (of - 1) as f64);
        }
        let known = self.names.iter().position(|n| n == name);
        Colour::Slot(known.unwrap_or_else(|| {
            self.names.push(name.into());
            self.names.len() - 1
        }))
    }

    /// Colours of the words of a map. Of many the first have those of the palette, and those seen of the others share the ramp.
    fn classes(&mut self, classes: &[String], seen: &[bool]) -> Vec<(String, Colour)> {
        let many = classes.len() > PALETTE_GROUPS;
        let others = seen.iter().skip(FIXED).filter(|s| **s).count();
        let mut before = 0;
        let mut out = Vec::new();
        for (k, class) in classes.iter().enumerate() {
            let colour = if many && k >= FIXED {
                let place = (before as f64 + 1.0) / (others as f64 + 1.0);
                before += usize::from(seen[k]);
                Colour::Ramp(place.min(1.0))
            } else {
                self.colour(class, 0, 1)
            };
            out.push((class.clone(), colour));
        }
        out
    }

    fn entry(&mut self, label: &str, colour: Colour, glyph: Glyph) -> usize {
        let same = |e: &Entry| e.label == label && e.colour == colour && std::mem::discriminant(&e.glyph) == std::mem::discriminant(&glyph);
        self.legend.iter().position(same).unwrap_or_else(|| {
            self.legend.push(Entry { label: label.into(), colour, glyph });
            self.legend.len() - 1
        })
    }

    fn panel(&mut self, panel: &Panel) -> PanelView {
        let (fx, fy) = (self.figure.x.factor, panel.y.factor);
        let mut view = PanelView {
            y: AxisView::new("", "", false, 0.0, 1.0),
            heat: None,
            bands: Vec::new(),
            series: Vec::new(),
            rules: Vec::new(),
            texts: Vec::new(),
            cut: Vec::new(),
            ends: Vec::new(),
            height: panel.height,
        };
        let mut meanings = Vec::new();
        for mark in &panel.marks {
            match mark {
                Mark::Line(m) => {
                    let (xs, mut ys) = (self.values(&m.table, &m.x, fx), self.values(&m.table, &m.y, fy));
                    let solid = self.flags(&m.table, m.solid_where.as_ref()).map(<[bool]>::to_vec);
                    let mut begins = self.flags(&m.table, m.begins_where.as_ref()).map(<[bool]>::to_vec);
                    if m.wrapped {
                        let turn = std::f64::consts::TAU * fy;
                        ys.iter_mut().for_each(|y| *y -= turn * (*y / turn).round());
                        let far = |i: usize| i > 0 && (ys[i] - ys[i - 1]).abs() > 0.5 * turn;
                        let jumps = (0..ys.len()).map(|i| far(i) || begins.as_ref().is_some_and(|b| b[i])).collect();
                        begins = Some(jumps);
                    }
                    let valid = self.flags(&m.table, m.valid_where.as_ref()).map(<[bool]>::to_vec);
                    let mut groups = self.groups(&m.table, m.group.as_ref(), &m.name, xs.len());
                    for (group, name) in &m.called {
                        groups.iter_mut().filter(|g| g.key == *group).for_each(|g| g.name = self.say(name));
                    }
                    for class in m.classes.iter().filter(|c| !m.muted.contains(c)) {
                        self.colour(class, 0, 1);
                    }
                    if let Some(period) = m.period {
                        for g in &groups {
                            unwrap(&mut ys, &g.rows, period * fy.abs());
                        }
                    }
                    for (group, words) in &m.ends {
                        if let Some(g) = groups.iter().find(|g| g.key == *group) {
                            view.ends.push((g.rows.iter().map(|&i| (xs[i], ys[i])).collect(), self.say(words)));
                        }
                    }
                    let groups = self.classed(groups, &m.table, m.class.as_ref());
                    let of = if m.class.is_some() { 1 } else { groups.len() };
                    for (k, (g, class)) in groups.into_iter().enumerate() {
                        let key = class.as_ref().unwrap_or(&g.key);
                        let label = class.as_ref().map_or_else(|| g.name.clone(), |c| self.style.word(c));
                        let colour = match m.reference {
                            // modes without a legend are drawn like reference lines, and are none
                            true if m.group.is_none() => Colour::Slot(6),
                            true => Colour::Muted,
                            false if m.muted.contains(&key.as_str()) => Colour::Muted,
                            false if m.ink => Colour::Slot(6),
                            false => self.colour(key, k, of),
                        };
                        // curves on a heat map are black
                        let on_heat =
                            colour == Colour::Slot(0) && panel.marks.iter().any(|m| matches!(m, Mark::Heat(h) if h.curves.is_none()));
                        let glyph = if on_heat { Glyph::Contour } else { Glyph::Line };
                        let entry = (!m.reference).then(|| self.entry(&label, colour, glyph));
                        let place = |i: usize| (xs[i], ys[i]);
                        let at = |i: usize| if valid.as_ref().is_none_or(|v| v[i]) { place(i) } else { (f64::NAN, f64::NAN) };
                        if let Some(valid) = &valid {
                            let points = split(&g.rows, place, valid, begins.as_deref()).1;
                            if !points.is_empty() {
                                let state = self.say(&"outside validity".into());
                                let entry = Some(self.entry(&state, Colour::Muted, Glyph::Line));
                                view.series.push(Series {
                                    name: String::new(),
                                    state,
                                    kind: Kind::Solid,
                                    colour: Colour::Muted,
                                    points,
                                    entry,
                                    reference: true,
                                    below: 0,
                                });
                            }
                        }
                        let pieces = match &solid {
                            None => vec![(Kind::Solid, String::new(), pieces_of(&g.rows, at, begins.as_deref()))],
                            Some(solid) => {
                                let (full, mut dashed) = split(&g.rows, at, solid, begins.as_deref());
                                if m.solid_only {
                                    dashed.clear();
                                }
                                if !dashed.is_empty() && !meanings.contains(&&m.solid_dashed) {
                                    meanings.push(&m.solid_dashed);
                                }
                                let [solid, dash] = [&m.solid_dashed.0, &m.solid_dashed.1].map(|a| self.say(a));
                                vec![(Kind::Solid, solid, full), (Kind::Dashed, dash, dashed)]
                            }
                        };
                        for (kind, state, points) in pieces.into_iter().filter(|p: &(Kind, String, Vec<_>)| !p.2.is_empty()) {
                            let marked = if m.path { ends(&points) } else { Vec::new() };
                            let points = if m.path { smooth(points) } else { points };
                            let below = if m.nested { of.saturating_sub(1 + k) } else { 0 };
                            view.series.push(Series {
                                name: g.name.clone(),
                                state,
                                kind,
                                colour,
                                points,
                                entry,
                                reference: m.reference,
                                below,
                            });
                            view.series.extend(marked.into_iter().map(|(shape, state, point)| Series {
                                name: g.name.clone(),
                                state: self.say(&state.into()),
                                kind: Kind::Marker { shape, open: false },
                                colour,
                                points: vec![point],
                                entry,
                                reference: false,
                                below: 0,
                            }));
                        }
                    }
                }
                Mark::Points(m) => {
                    let (xs, ys) = (self.values(&m.table, &m.x, fx), self.values(&m.table, &m.y, fy));
                    let filled = self.flags(&m.table, m.filled_where.as_ref()).map(<[bool]>::to_vec);
                    let mut groups = self.groups(&m.table, m.group.as_ref(), &m.name, xs.len());
                    for (group, name) in &m.called {
                        groups.iter_mut().filter(|g| g.key == *group).for_each(|g| g.name = self.say(name));
                    }
                    let of = groups.len();
                    let place = |g: &Group| m.classes.iter().position(|c| *c == g.key);
                    groups.sort_by_key(|g| place(g).unwrap_or(usize::MAX));
                    for class in m.classes.iter().filter(|c| !m.muted.contains(c)) {
                        self.colour(class, 0, 1);
                    }
                    for (k, g) in groups.into_iter().enumerate() {
                        let colour = if m.muted.contains(&g.key.as_str()) { Colour::Muted } else { self.colour(&g.key, k, of) };
                        let shape = if m.small { SMALL + k } else { place(&g).map_or(k, |c| CLASS + c) };
                        let sides = [false, true].map(|open| {
                            let fits = |i: &&usize| filled.as_ref().is_none_or(|f| f[**i]) != open;
                            g.rows.iter().filter(fits).map(|i| (xs[*i], ys[*i])).collect::<Vec<_>>()
                        });
                        let both = sides.iter().all(|s| !s.is_empty());
                        for (open, points) in [false, true].into_iter().zip(sides).filter(|s| !s.1.is_empty()) {
                            // the name of the flag tells filled from open markers
                            let flag = m.filled_where.as_ref().filter(|_| both || open).and_then(|f| self.column(&m.table, f));
                            let words = |c: &Column| if open { self.negated(&c.label) } else { self.say(&c.label) };
                            let parts = [g.name.clone(), flag.map_or(String::new(), words)];
                            let name = parts.into_iter().filter(|p| !p.is_empty()).collect::<Vec<_>>().join(", ");
                            let kind = Kind::Marker { shape, open };
                            let entry = Some(self.entry(&name, colour, Glyph::Marker { shape, open }));
                            view.series.push(Series {
                                name,
                                state: String::new(),
                                kind,
                                colour,
                                points,
                                entry,
                                reference: false,
                                below: 0,
                            });
                        }
                    }
                }
                Mark::Band(m) => {
                    let name = self.say(&m.name);
                    let same =
                        |e: &Entry| if let Glyph::Tint(t) | Glyph::Block(t) = e.glyph { (e.label == name).then_some(t) } else { None };
                    let known = self.legend.iter().find_map(same);
                    let tint = m.tint.or(known).unwrap_or(if m.strip { STRIP_TINT } else { self.tints % FREE_TINTS });
                    let outlines = self.outlines(m, fx, fy);
                    if !outlines.is_empty() {
                        self.tints += usize::from(known.is_none());
                        view.bands.extend(outlines.into_iter().map(|outline| BandView { outline, tint, strip: m.strip, bar: m.bar }));
                        if !name.is_empty() && known.is_none() {
                            self.entry(&name, Colour::Slot(tint), if m.bar { Glyph::Block(tint) } else { Glyph::Tint(tint) });
                        }
                    }
                }
                Mark::Rule(m) => {
                    let at = m.at * if m.vertical { fx } else { fy };
                    if at.is_finite() {
                        let axis = if m.vertical { &self.figure.x } else { &panel.y };
                        let shown = |v: f64| Arg::number(v * axis.factor).digits(4);
                        let between = |(from, to): (f64, f64)| {
                            let range = Message::new("label-between").arg("label", m.label.clone());
                            self.style.message(&range.arg("from", shown(from)).arg("to", shown(to)))
                        };
                        let label = m.between.map_or_else(|| self.say(&m.label), between);
                        view.rules.push(RuleView { vertical: m.vertical, at, label });
                    }
                }
                Mark::Text(m) => view.texts.push((m.x * fx, m.y * fy, self.say(&m.text))),
                Mark::Heat(m) => {
                    let (x, y, v) = (
                        self.values(&m.table, &m.x, fx),
                        self.values(&m.table, &m.y, fy),
                        self.places(&m.table, &m.value, &m.classes, m.colours.factor),
                    );
                    let seen: Vec<bool> = (0..m.classes.len()).map(|k| v.contains(&(k as f64))).collect();
                    let classes = self.classes(&m.classes, &seen);
                    let called = |own: &Self, word: &str| {
                        let name = m.called.iter().find(|c| c.0 == word);
                        name.map_or_else(|| own.style.word(word), |c| own.say(&c.1))
                    };
                    let classes: Vec<_> = classes.into_iter().map(|(word, colour)| (called(self, &word), colour)).collect();
                    for ((name, colour), _) in classes.iter().zip(&seen).filter(|c| *c.1) {
                        self.entry(name, *colour, Glyph::Marker { shape: 1, open: false });
                    }
                    // what a logarithmic axis cannot show is left out
                    let fits = |v: f64, scale: Scale| scale == Scale::Linear || v > 0.0;
                    let scales = (self.figure.x.scale, panel.y.scale, m.colours.scale);
                    let rows = x.into_iter().zip(y).zip(v).map(|((x, y), v)| (x, y, v));
                    let rows: Vec<_> = rows.filter(|r| fits(r.0, scales.0) && fits(r.1, scales.1) && fits(r.2, scales.2)).collect();
                    let (xs, ys, values) = HeatView::grid(&rows, !classes.is_empty());
                    let mut range = extent(values.iter().copied(), m.colours.scale == Scale::Log);
                    if let (true, Some((lo, hi))) = (m.diverging, range) {
                        range = Some((lo.min(0.0), hi.max(0.0)));
                    }
                    let axis = axis_view(&m.colours, range, self.style);
                    let contour = m.contour.map(|c| c * m.colours.factor);
                    // a level that no cell reaches has no curve to explain
                    let contour = contour.filter(|c| values.iter().any(|v| v < c) && values.iter().any(|v| v >= c));
                    if let Some(level) = contour {
                        let unit = if level == 0.0 { String::new() } else { unit_text(&m.colours.unit) };
                        let number = self.style.language.number(&significant(level, 4));
                        let label = format!("{} = {number} {}", axis.label, self.style.language.unit(&unit));
                        self.entry(label.trim_end(), Colour::Muted, Glyph::Contour);
                    }
                    let curves = m.curves.as_ref().map(|levels| levels.iter().map(|c| c * m.colours.factor).collect::<Vec<f64>>());
                    if let Some(levels) = curves.as_ref().filter(|l| !l.is_empty()) {
                        let numbers: Vec<String> = levels.iter().map(|c| self.style.language.number(&significant(*c, 3))).collect();
                        let unit = self.style.language.unit(&unit_text(&m.colours.unit));
                        let label = format!("{} {} {unit}", axis.label, numbers.join(", "));
                        self.entry(label.trim_end(), Colour::Muted, Glyph::Line);
                    }
                    let (diverging, allowed) = (m.diverging, m.allowed);
                    view.heat = Some(HeatView { xs, ys, values, axis, diverging, allowed, contour, curves, classes });
                }
            }
        }
        for (solid, dashed) in meanings {
            let [solid, dashed] = [solid, dashed].map(|a| self.say(a));
            if !solid.is_empty() {
                self.entry(&solid, Colour::Muted, Glyph::Line);
            }
            self.entry(&dashed, Colour::Muted, Glyph::Dashed);
        }
        view
    }

    /// Outlines of the pieces of a band; NaN separates them.
    fn outlines(&self, band: &Band, fx: f64, fy: f64) -> Vec<Vec<(f64, f64)>> {
        const INF: f64 = f64::INFINITY;
        match &band.place {
            BandPlace::X(a, b) if !(a.is_nan() || b.is_nan()) => vec![vec![(a * fx, -INF), (b * fx, -INF), (b * fx, INF), (a * fx, INF)]],
            BandPlace::Y(a, b) if !(a.is_nan() || b.is_nan()) => vec![vec![(-INF, a * fy), (INF, a * fy), (INF, b * fy), (-INF, b * fy)]],
            BandPlace::X(..) | BandPlace::Y(..) => Vec::new(),
            BandPlace::Between(table, x, low, high) => {
                let (xs, lo, hi) = (self.values(table, x, fx), self.values(table, low, fy), self.values(table, high, fy));
                let rows: Vec<usize> = (0..xs.len()).collect();
                let fits = |i: &usize| xs[*i].is_finite() && lo[*i].is_finite() && hi[*i].is_finite();
                let around =
                    |r: &[usize]| r.iter().map(|i| (xs[*i], lo[*i])).chain(r.iter().rev().map(|i| (xs[*i], hi[*i]))).collect::<Vec<_>>();
                let areas = band.group.as_ref().map(|g| self.values(table, g, 1.0));
                let same = |a: &usize, b: &usize| fits(a) == fits(b) && areas.as_ref().is_none_or(|g| g[*a] == g[*b]);
                rows.chunk_by(same).filter(|r| fits(&r[0])).map(around).collect()
            }
            BandPlace::Across(table, y, left, right) => {
                let turned = Band { place: BandPlace::Between(table.clone(), y.clone(), left.clone(), right.clone()), ..band.clone() };
                let turn = |outline: Vec<(f64, f64)>| outline.into_iter().map(|(y, x)| (x, y)).collect();
                self.outlines(&turned, fy, fx).into_iter().map(turn).collect()
            }
        }
    }
}

#[cfg(test)]
mod tests;
