//! Unstable regions of a map over speed and a parameter: located ranges of neighbouring values joined to areas.

use crate::outcome::{Table, TableBuilder};

/// A range of speeds at a value of the parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Slice {
    value: f64,
    from: f64,
    to: f64,
}

/// Areas, each from one value of the parameter to another.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Regions {
    areas: Vec<Vec<Slice>>,
}

/// Two ranges of neighbouring values belong to one area when they overlap, or lie no farther apart than so many times the wider of them.
const NEAR: f64 = 2.0;

impl Regions {
    /// From the unstable ranges at each value, in the order of the values. An area that is not there at the next value ends half way to it, in a point.
    pub fn of(rows: &[(f64, Vec<(f64, f64)>)]) -> Regions {
        let mut done: Vec<Vec<Slice>> = Vec::new();
        let mut open: Vec<Vec<Slice>> = Vec::new();
        let mut before: Option<f64> = None;
        for (value, ranges) in rows {
            let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
            for (i, area) in open.iter().enumerate() {
                let Some(last) = area.last() else { continue };
                for (j, r) in ranges.iter().enumerate() {
                    let gap = last.from.max(r.0) - last.to.min(r.1);
                    if gap <= NEAR * (last.to - last.from).max(r.1 - r.0) {
                        pairs.push((gap, i, j));
                    }
                }
            }
            pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
            let (mut kept, mut taken) = (vec![None; open.len()], vec![false; ranges.len()]);
            for (_, i, j) in pairs {
                if kept[i].is_none() && !taken[j] {
                    kept[i] = Some(j);
                    taken[j] = true;
                }
            }
            let half = before.map(|b| 0.5 * (b + value));
            let slice = |r: &(f64, f64)| Slice { value: *value, from: r.0, to: r.1 };
            let tip = |s: &Slice, at: f64| Slice { value: at, from: 0.5 * (s.from + s.to), to: 0.5 * (s.from + s.to) };
            let mut next = Vec::new();
            for (mut area, found) in std::mem::take(&mut open).into_iter().zip(kept) {
                if let Some(j) = found {
                    area.push(slice(&ranges[j]));
                    next.push(area);
                } else {
                    let end = area.last().copied();
                    area.extend(end.zip(half).map(|(s, at)| tip(&s, at)));
                    done.push(area);
                }
            }
            for (r, _) in ranges.iter().zip(&taken).filter(|t| !*t.1) {
                let own = slice(r);
                next.push(half.map(|at| tip(&own, at)).into_iter().chain([own]).collect());
            }
            open = next;
            before = Some(*value);
        }
        done.extend(open);
        Regions { areas: done }
    }

    pub fn is_empty(&self) -> bool {
        self.areas.is_empty()
    }

    /// The areas one after the other.
    pub fn table(&self, name: &str, unit: &str) -> TableBuilder {
        let rows: Vec<(usize, &Slice)> = self.areas.iter().enumerate().flat_map(|(k, a)| a.iter().map(move |s| (k, s))).collect();
        let column = |f: fn(&Slice) -> f64| rows.iter().map(|r| f(r.1)).collect::<Vec<f64>>();
        Table::new("regions", "Unstable regions between located speeds")
            .int("region", "", "number of the region", rows.iter().map(|r| r.0 as i64 + 1).collect())
            .float(name, unit, "parameter", column(|s| s.value))
            .float("from", "rad/s", "first unstable speed", column(|s| s.from))
            .float("to", "rad/s", "last unstable speed", column(|s| s.to))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Area of a region by the trapezoidal rule, exact for straight edges.
    fn area(slices: &[Slice]) -> f64 {
        slices.windows(2).map(|w| 0.5 * (w[1].value - w[0].value) * (w[0].to - w[0].from + w[1].to - w[1].from)).sum()
    }

    /// A wedge between straight lines is its own area, however narrow beside its motion from one value to the next.
    #[test]
    fn a_region_between_straight_lines_is_one_area() {
        let rows: Vec<(f64, Vec<(f64, f64)>)> =
            (0..=10).map(f64::from).map(|v| (v, vec![(100.0 + 5.0 * v, 104.0 + 6.0 * v), (900.0, 1000.0)])).collect();
        let regions = Regions::of(&rows);
        assert_eq!(regions.areas.len(), 2);
        let wedge = regions.areas.iter().find(|a| a[0].from < 500.0).unwrap();
        assert!((area(wedge) - (4.0 * 10.0 + 0.5 * 100.0)).abs() < 1e-9);
    }

    /// A region that appears and vanishes ends in a point half way to the values at which it is not there.
    #[test]
    fn an_island_is_closed() {
        let rows = [(0.0, vec![]), (1.0, vec![(10.0, 12.0)]), (2.0, vec![(10.0, 14.0)]), (3.0, vec![])];
        let regions = Regions::of(&rows);
        let island = &regions.areas[0];
        assert_eq!((regions.areas.len(), island.len()), (1, 4));
        assert_eq!((island[0], island[3]), (Slice { value: 0.5, from: 11.0, to: 11.0 }, Slice { value: 2.5, from: 12.0, to: 12.0 }));
        assert!(Regions::of(&[(0.0, vec![]), (1.0, vec![])]).is_empty());
    }

    #[test]
    fn two_regions_that_meet_become_one() {
        let rows = [(0.0, vec![(1.0, 2.0), (3.0, 5.0)]), (1.0, vec![(1.0, 5.0)])];
        let regions = Regions::of(&rows);
        assert_eq!(regions.areas.len(), 2);
        assert!(regions.areas.iter().any(|a| a.last().unwrap().to == 5.0 && a.last().unwrap().value == 1.0));
    }
}
