//! Division of a shaft into elements.

/// Nodes at a share of this of the neighbouring length, or nearer, are one.
const SAME: f64 = 1e-6;
/// Length of an element over its outer diameter, where the division is left to the program, and the most elements of a shaft then.
const SLENDER: f64 = 0.5;
const MOST: f64 = 60.0;

/// An element of a shaft: the part of a section between two shares of its length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece {
    /// Index of the section.
    pub section: usize,
    /// Shares of the length of the section.
    pub from: f64,
    /// See `from`.
    pub to: f64,
    /// Length, m.
    pub length: f64,
}

/// Nodes and elements.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Positions of the nodes, m, rising from 0.
    pub nodes: Vec<f64>,
    /// One between each node and the next.
    pub pieces: Vec<Piece>,
}

impl Mesh {
    /// Sections of these lengths and diameters (m) with nodes at their ends and at `positions`; every section is divided into so many elements, or into
    /// elements that are half as long as thick.
    pub fn new(lengths: &[f64], diameters: &[f64], elements: Option<usize>, positions: &[f64]) -> Self {
        let total: f64 = lengths.iter().sum();
        let usual = |k: usize| lengths[k] / (SLENDER * diameters[k]);
        let coarser = ((0..lengths.len()).map(usual).sum::<f64>() / MOST).max(1.0);
        let (mut nodes, mut pieces, mut start) = (vec![0.0], Vec::new(), 0.0);
        for (section, &length) in lengths.iter().enumerate() {
            let count = elements.unwrap_or_else(|| (usual(section) / coarser).ceil().max(1.0) as usize);
            let end = start + length;
            let mut inside: Vec<f64> = positions.iter().map(|z| (z - start) / length).filter(|s| *s > 0.0 && *s < 1.0).collect();
            // where the number of elements is given, attached parts move the nearest division to them
            inside.sort_by(f64::total_cmp);
            let mut marks = vec![0.0];
            for s in inside.into_iter().chain([1.0]) {
                let last = marks[marks.len() - 1];
                if (s - last) * length > SAME * total {
                    let pieces = ((s - last) * count as f64).round().max(1.0) as usize;
                    marks.extend((1..=pieces).map(|i| if i == pieces { s } else { last + (s - last) * i as f64 / pieces as f64 }));
                }
            }
            // a mark beside the end of the section stands for it
            if let Some(last) = marks.last_mut() {
                *last = 1.0;
            }
            for w in marks.windows(2) {
                pieces.push(Piece { section, from: w[0], to: w[1], length: (w[1] - w[0]) * length });
                nodes.push(if w[1] == 1.0 { end } else { start + w[1] * length });
            }
            start = end;
        }
        Mesh { nodes, pieces }
    }
    /// The node at a position, to the rounding of sums of lengths.
    pub fn node(&self, z: f64) -> Option<usize> {
        let near = |n: &f64| (n - z).abs() <= 1e-12 * self.nodes[self.nodes.len() - 1];
        self.nodes.iter().position(near)
    }
    /// The element that holds a position, and the share of its length there.
    pub fn place(&self, z: f64) -> (usize, f64) {
        let k = self.nodes.partition_point(|n| *n <= z).clamp(1, self.pieces.len()) - 1;
        (k, (z - self.nodes[k]) / (self.nodes[k + 1] - self.nodes[k]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: &[f64], b: &[f64]) -> bool {
        a.len() == b.len() && a.iter().zip(b).all(|(x, y)| (x - y).abs() < 1e-12)
    }

    #[test]
    fn nodes_stand_at_ends_divisions_and_attached_parts() {
        let of = |elements, positions: &[f64]| Mesh::new(&[0.5, 0.3], &[0.1, 0.05], elements, positions).nodes;
        assert!(near(&of(Some(1), &[]), &[0.0, 0.5, 0.8]));
        assert!(near(&of(Some(2), &[]), &[0.0, 0.25, 0.5, 0.65, 0.8]));
        // an attached part on a node adds none, one beside the ends neither
        assert!(near(&of(Some(2), &[0.25, 0.0, 0.8, 0.5 - 1e-9]), &[0.0, 0.25, 0.5, 0.65, 0.8]));
        assert!(near(&of(Some(1), &[0.1]), &[0.0, 0.1, 0.5, 0.8]));
        // half as long as thick
        let usual = of(None, &[]);
        assert_eq!(usual.len(), 1 + 10 + 12);
        assert!(Mesh::new(&[100.0], &[0.1], None, &[]).pieces.len() == 60);
    }

    #[test]
    fn places_are_found() {
        let m = Mesh::new(&[0.5, 0.3], &[0.1, 0.05], Some(2), &[]);
        assert_eq!((m.place(0.0), m.node(0.65 + 1e-16), m.node(0.6)), ((0, 0.0), Some(3), None));
        let (k, s) = m.place(0.6);
        assert!(k == 2 && (s - 2.0 / 3.0).abs() < 1e-12);
        let (k, s) = m.place(0.8);
        assert!(k == 3 && (s - 1.0).abs() < 1e-12);
        let total: f64 = m.pieces.iter().map(|p| p.length).sum();
        assert!((total - 0.8).abs() < 1e-15);
    }
}
