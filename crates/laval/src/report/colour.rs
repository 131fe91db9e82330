//! Colours: Okabe-Ito for series, viridis and a blue-white-red map for heat.

/// Colour of a series.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Colour {
    /// Entry of the categorical palette.
    Slot(usize),
    /// Position 0..1 on the plain ramp, for many ordered groups.
    Ramp(f64),
    /// Grey, for reference lines.
    Muted,
}

/// Okabe and Ito's palette without yellow, which vanishes on white, in an order that separates neighbours.
pub(super) const SLOTS: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#444444"];

pub(super) const MUTED: &str = "#8a8a8a";

impl Colour {
    pub fn hex(self) -> String {
        match self {
            Colour::Slot(i) => SLOTS[i % SLOTS.len()].into(),
            // the bright end of the ramp vanishes on white
            Colour::Ramp(t) => hex(ramp(&VIRIDIS, 0.88 * t)),
            Colour::Muted => MUTED.into(),
        }
    }

    /// The palette is used up: lines of this colour are dotted, so that they differ from the first of it.
    pub fn is_again(self) -> bool {
        matches!(self, Colour::Slot(i) if i >= SLOTS.len())
    }

    /// Class by which a page restyles the colour for a dark background.
    pub fn class(self) -> String {
        match self {
            Colour::Slot(i) => format!("c{}", i % SLOTS.len()),
            Colour::Ramp(_) => "cr".into(),
            Colour::Muted => "cm".into(),
        }
    }
}

const VIRIDIS: [[u8; 3]; 9] = [
    [68, 1, 84],
    [71, 44, 122],
    [59, 81, 139],
    [44, 113, 142],
    [33, 144, 141],
    [39, 173, 129],
    [92, 200, 99],
    [170, 220, 50],
    [253, 231, 37],
];

const BLUE_RED: [[u8; 3]; 11] = [
    [5, 48, 97],
    [33, 102, 172],
    [67, 147, 195],
    [146, 197, 222],
    [209, 229, 240],
    [247, 247, 247],
    [253, 219, 199],
    [244, 165, 130],
    [214, 96, 77],
    [178, 24, 43],
    [103, 0, 31],
];

/// Vermilion to green, of colours that the colour-blind tell apart.
const FORBIDDEN_ALLOWED: [[u8; 3]; 7] =
    [[224, 138, 92], [236, 174, 140], [246, 214, 196], [247, 247, 247], [190, 230, 212], [84, 184, 148], [0, 128, 94]];

fn ramp(anchors: &[[u8; 3]], t: f64) -> [u8; 3] {
    let s = t.clamp(0.0, 1.0) * (anchors.len() - 1) as f64;
    let i = (s.floor() as usize).min(anchors.len() - 2);
    let f = s - i as f64;
    std::array::from_fn(|k| (anchors[i][k] as f64 * (1.0 - f) + anchors[i + 1][k] as f64 * f).round() as u8)
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Colour of a heat map at 0..1; 0.5 is neutral when `diverging`.
pub(super) fn heat(t: f64, diverging: bool) -> String {
    hex(if diverging { ramp(&BLUE_RED, t) } else { ramp(&VIRIDIS, t) })
}

/// Colour at 0..1 of what is forbidden below 0.5 and allowed above.
pub(super) fn allowed(t: f64) -> String {
    hex(ramp(&FORBIDDEN_ALLOWED, t))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_and_middle() {
        assert_eq!(heat(0.0, false), "#440154");
        assert_eq!(heat(1.0, false), "#fde725");
        assert_eq!(heat(0.5, true), "#f7f7f7");
        assert_eq!(heat(-3.0, true), heat(0.0, true));
    }

    /// Relative luminance rises all along the plain ramp, so that it also reads in grey.
    #[test]
    fn plain_ramp_is_monotonic_in_lightness() {
        let light = |t: f64| {
            let [r, g, b] = ramp(&VIRIDIS, t).map(|c| (c as f64 / 255.0).powf(2.2));
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        for i in 0..100 {
            assert!(light((i + 1) as f64 / 100.0) > light(i as f64 / 100.0) - 1e-4);
        }
    }
}
