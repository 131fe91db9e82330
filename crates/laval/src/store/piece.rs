//! A long study in pieces: what one of many processes computes of it.

use std::str::FromStr;

/// One of `of` pieces: every `of`-th chunk, so that all pieces take about as long.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    index: usize,
    of: usize,
}

impl Piece {
    /// Piece `number` (from 1) of `of`.
    pub fn new(number: usize, of: usize) -> Option<Piece> {
        (1..=of).contains(&number).then(|| Piece { index: number - 1, of })
    }

    /// Its number, from 1.
    pub fn number(self) -> usize {
        self.index + 1
    }

    /// Number of pieces in all.
    pub fn of(self) -> usize {
        self.of
    }

    /// Whether the chunk belongs to it. Chunks that follow from the chunk before all belong to the first piece.
    pub fn has(self, chunk: usize, chained: bool) -> bool {
        if chained { self.index == 0 } else { chunk % self.of == self.index }
    }
}

impl FromStr for Piece {
    type Err = String;

    /// `3/10`.
    fn from_str(text: &str) -> Result<Piece, String> {
        let wrong = || "give the number of the part and the number of all parts, as in 3/10".to_string();
        let (number, of) = text.split_once('/').ok_or_else(wrong)?;
        let (number, of) = (number.trim().parse().map_err(|_| wrong())?, of.trim().parse().map_err(|_| wrong())?);
        Piece::new(number, of).ok_or_else(|| format!("parts are numbered from 1 to {of}"))
    }
}

/// What a run does with the chunks of a study.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Work {
    /// Compute those that are missing.
    #[default]
    Missing,
    /// Compute those that are missing of one piece, beside processes that compute other pieces.
    Piece(Piece),
    /// Compute none: all must be there.
    Collect,
    /// Neither compute nor write: the plan is enough.
    Plan,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_chunk_belongs_to_one_piece() {
        for of in [1, 2, 3, 7, 40] {
            let pieces: Vec<Piece> = (1..=of).map(|k| Piece::new(k, of).unwrap()).collect();
            for chained in [false, true] {
                for chunk in 0..50 {
                    assert_eq!(pieces.iter().filter(|p| p.has(chunk, chained)).count(), 1, "{chunk} of {of}");
                }
            }
        }
    }

    #[test]
    fn pieces_are_written_as_fractions() {
        assert_eq!("3/10".parse(), Ok(Piece { index: 2, of: 10 }));
        assert_eq!("3/10".parse::<Piece>().map(|p| (p.number(), p.of())), Ok((3, 10)));
        for wrong in ["", "3", "3/", "/3", "0/3", "4/3", "1/0", "-1/3", "1/3/5", "x/3"] {
            assert!(wrong.parse::<Piece>().is_err(), "{wrong}");
        }
    }
}
