//! The same method in three kinds of numbers.

use lab::accuracy::Problem;
use spinning_bodies::integrators::geometric::{
    DoubleDouble, Integrator, MoserVeselov, Real, VeselovOrder,
};

use super::problem::problem;
use crate::prelude::*;

/// Errors after ten turns against steps per turn.
fn line<T: Real>(problem: &Problem, method: &MoserVeselov) -> Result<Vec<[f64; 2]>> {
    let counts = [8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0];
    let moments = problem.moments();
    tried(counts, |count| {
        let steps = count * problem.turns();
        // The step is rounded in these numbers as well: the runs have lengths that are sums of few powers of two.
        let step = T::from_double(problem.end() / steps);
        let mut stepper = method.start(&problem.start().cast(), step)?;
        stepper.advance(steps as u64)?;
        let off = problem.last().apart(&stepper.phase()?, moments);
        Ok([count, off.attitude])
    })
}

/// Single, double and two doubles.
pub fn three_numbers(_: &Values) -> Result<Figure> {
    let problem = problem("free-top/10")?;
    let method = MoserVeselov::new(problem.moments(), VeselovOrder::Ten)?;
    let single = line::<f32>(&problem, &method)?;
    let double = line::<f64>(&problem, &method)?;
    let two = line::<DoubleDouble>(&problem, &method)?;
    let lines = [
        (single, muted(DATA), "single (f32)"),
        (double, inked(DATA), "double (f64)"),
        (two, inked(DATA).dashed(), "two doubles"),
    ];
    let frame = Frame::log([7.0, 600.0], [1e-26, 1.0], [64.0, 584.0, 372.0, 32.0]);
    let words = words!(
        "The numbers set the floor, the method sets the slope.",
        "Moser and Veselov’s discrete top of order 10, one program, three kinds of numbers: error of the attitude after ten turns against the steps a turn. While the error is that \
         of the method, the three agree. Then each comes to the floor of its own rounding; two doubles are nowhere near theirs.",
        "Three lines on logarithmic axes, error against 8 to 512 steps a turn. They run down together. Single precision leaves at a millionth and stays there, double \
         precision at about ten to the minus 15, two doubles go on falling with the tenth power."
    );
    Ok(figure("accuracy-numbers", 424.0, words, |pen| {
        let across = marks(&[8.0, 32.0, 128.0, 512.0], "");
        let up = powers([0, -5, -10, -15, -20, -25]);
        frame.draw(pen, &across, &up, ["steps a turn", "error, rad"]);
        for (k, (line, style, name)) in lines.iter().enumerate() {
            let places = frame.trace(line.iter().copied());
            beaded(pen, &places, *style);
            if let Some(&end) = places.last() {
                let aside = if k == 2 { [-40.0, 4.0] } else { [0.0, -14.0] };
                pen.text(shifted(end, aside), End, name, label(style.role()));
            }
        }
    }))
}
