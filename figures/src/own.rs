//! Diagrams of the reader's own motions: one number against another, a panel each.

use crate::Figure;
use crate::plot::{Axis, Frame};
use crate::style::{AXIS, DATA, Point, Role, Words, figure, number, stroke};

/// The values of a quantity along a motion.
#[derive(Debug, Clone)]
pub struct Quantity {
    /// As a scene calls it: `tilt`, `omega1`, …
    pub name: &'static str,
    /// Its unit; `1` for a pure number.
    pub unit: &'static str,
    /// Whether it is an angle told between −π and π: a line that goes once round is broken there.
    pub goes_round: bool,
    /// The values, one a row.
    pub values: Vec<f64>,
}

/// A quantity as it is drawn: less its first value if it hardly changes, in units of a power of ten.
struct Drawn {
    label: String,
    values: Vec<f64>,
    shown: [f64; 2],
}

fn extent(values: &[f64]) -> [f64; 2] {
    let widen = |[low, high]: [f64; 2], &value: &f64| [low.min(value), high.max(value)];
    values
        .iter()
        .fold([f64::INFINITY, f64::NEG_INFINITY], widen)
}

impl Quantity {
    fn drawn(&self) -> Drawn {
        let [low, high] = extent(&self.values);
        let greatest = low.abs().max(high.abs());
        let first = self.values.first().copied().unwrap_or(0.0);
        let hardly = high > low && high - low < 1e-6 * greatest;
        let (before, origin) = if hardly {
            ("change of ", first)
        } else {
            ("", 0.0)
        };
        let values: Vec<f64> = self.values.iter().map(|value| value - origin).collect();
        let [low, high] = extent(&values);
        let power = low.abs().max(high.abs()).log10().floor();
        let power = if (-3.0..5.0).contains(&power) || !power.is_finite() {
            0.0
        } else {
            power
        };
        let values: Vec<f64> = values
            .iter()
            .map(|value| value / 10_f64.powf(power))
            .collect();
        let [low, high] = extent(&values);
        let air = if high > low { 0.06 * (high - low) } else { 1.0 };
        let unit = match (power, self.unit) {
            (0.0, "1") => String::new(),
            (0.0, unit) => format!(", {unit}"),
            (_, "1") => format!(", 10^{{{power}}}"),
            (_, unit) => format!(", 10^{{{power}}} {unit}"),
        };
        Drawn {
            label: format!("{before}{}{}", self.name, unit.replace('-', "\u{2212}")),
            values,
            shown: [low - air, high + air],
        }
    }

    /// A colour belongs to a quantity.
    fn role(&self) -> Role {
        let letters = self.name.trim_end_matches(|c: char| c.is_ascii_digit());
        match letters {
            _ if letters.starts_with("omega") || self.name == "spin" => Role::Omega,
            "l" | "lx" | "ly" | "lz" | "angular_momentum" => Role::AngularMomentum,
            _ => Role::Ink,
        }
    }
}

/// A diagram of the motion called `title`: in each panel a quantity to the right and one upward, with as many values as each other.
pub fn diagram(title: &str, panels: &[[Quantity; 2]]) -> Figure {
    let named = |[x, y]: &[Quantity; 2]| format!("{} against {}", y.name, x.name);
    let names: Vec<String> = panels.iter().map(named).collect();
    let told = |[_, y]: &[Quantity; 2]| {
        let [low, high] = extent(&y.values);
        let unit = if y.unit == "1" { "" } else { y.unit };
        format!(
            "{} goes from {} to {} {unit}",
            y.name,
            short(low),
            short(high)
        )
    };
    let told: Vec<String> = panels.iter().map(told).collect();
    let details = format!("{}.", told.join("; ").replace(" ;", ";").trim_end());
    let words = Words {
        claim: format!("The motion of {title}: {}.", names.join(", ")),
        alt: format!(
            "{} panels, below each other: {}. {details}",
            panels.len(),
            names.join(", ")
        ),
        details,
    };
    let height = if panels.len() == 1 { 300.0 } else { 190.0 };
    let gap = 88.0;
    let whole = panels.len() as f64 * (height + gap) + 6.0;
    let made = figure("plot", whole, words, |pen| {
        for (k, [x, y]) in panels.iter().enumerate() {
            let top = 36.0 + k as f64 * (height + gap);
            let (across, up) = (x.drawn(), y.drawn());
            // Time begins at its beginning.
            let shown = if x.name == "t" {
                extent(&across.values)
            } else {
                across.shown
            };
            let shown = if shown[0] < shown[1] {
                shown
            } else {
                across.shown
            };
            let frame = Frame {
                x: Axis::linear(shown, [84.0, 582.0]),
                y: Axis::linear(up.shown, [top + height, top]),
            };
            frame.draw_round(pen, [&across.label, &up.label]);
            let [low, high] = up.shown;
            if low < 0.0 && high > 0.0 {
                let zero = [frame.at(shown[0], 0.0), frame.at(shown[1], 0.0)];
                pen.line(&zero, stroke(Role::Muted, AXIS).dashed());
            }
            let mut line: Vec<Point> = Vec::new();
            let mut before = None;
            for (&x, &y_there) in across.values.iter().zip(&up.values) {
                let jumps = before.is_some_and(|last: f64| (y_there - last).abs() > 3.2);
                if y.goes_round && jumps {
                    pen.line(&line, stroke(y.role(), DATA));
                    line.clear();
                }
                line.push(frame.at(x, y_there));
                before = Some(y_there);
            }
            pen.line(&line, stroke(y.role(), DATA));
        }
    });
    panels.iter().fold(made, |made, [x, y]| {
        let rows = x.values.iter().zip(&y.values).map(|(&x, &y)| vec![x, y]);
        made.data(
            format!("{} against {}", y.name, x.name),
            &["across", "up"],
            rows,
        )
    })
}

/// A number in four digits.
fn short(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        size if (1e-3..1e5).contains(&size) => {
            let decimals = (3.0 - size.log10().floor()).clamp(0.0, 6.0) as usize;
            number(value, decimals)
        }
        _ => format!("{value:.3e}").replace('-', "\u{2212}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn quantity(name: &'static str, values: &[f64]) -> Quantity {
        let values = values.to_vec();
        Quantity {
            name,
            unit: "J",
            goes_round: false,
            values,
        }
    }

    #[test]
    fn what_hardly_changes_is_drawn_as_its_change() {
        let energy = quantity("energy", &[5.0, 5.0 + 4e-13, 5.0 - 4e-13]).drawn();
        assert_eq!(energy.label, "change of energy, 10^{\u{2212}13} J");
        assert!(energy.values[0] == 0.0 && energy.shown[1] > 3.9);
        assert_eq!(quantity("energy", &[2.0, 2.0]).drawn().shown, [1.0, 3.0]);
        assert_eq!(quantity("energy", &[0.0, 0.0]).drawn().label, "energy, J");
    }

    #[test]
    fn a_panel_each() {
        let time = quantity("t", &[0.0, 1.0, 2.0]);
        let tilt = Quantity {
            goes_round: true,
            ..quantity("phi", &[3.0, -3.0, -2.0])
        };
        let made = diagram("a.toml", &[[time.clone(), tilt], [time.clone(), time]]);
        assert!(
            made.claim
                .starts_with("The motion of a.toml: phi against t")
        );
        assert_eq!(made.data.rows.len(), 6);
        // The line of phi is broken where it goes round: one point is left alone and draws nothing.
        assert!(!made.svg().contains("NaN"));
    }
}
