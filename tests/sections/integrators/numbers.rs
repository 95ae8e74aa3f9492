//! One method in three kinds of numbers: what of its error is the step's, and what is rounding.

use super::*;
use spinning_bodies::integrators::geometric::{DoubleDouble, Real};

fn run<T: Real>(method: &impl Integrator<T>, t: f64, steps: u64) -> Phase {
    let step = T::from_double(t / steps as f64);
    let mut stepper = method.start(&start().cast(), step).unwrap();
    stepper.advance(steps).unwrap();
    stepper.phase().unwrap().cast()
}

#[test]
fn rounding_falls_with_the_length_of_the_numbers() {
    let (t, steps) = (16.0, 16_384);
    let exact = free(MOMENTS, &start(), t);
    let method = FreeSplitting::new(MOMENTS, Order::Six).unwrap();
    let [f32_error, _] = distance(&run::<f32>(&method, t, steps), &exact);
    let [f64_error, _] = distance(&run::<f64>(&method, t, steps), &exact);
    let [dd_error, _] = distance(&run::<DoubleDouble>(&method, t, steps), &exact);
    // Observed: 3.8e-6; 2.5e-15; 6.6e-16, which is the rounding of the phase that is compared.
    assert!(f32_error > 1e-7 && f32_error < 1e-5, "{f32_error:e}");
    within(f64_error, 5e-15);
    within(dd_error, 1.3e-15);
}

/// The truncation error is the same in doubles and in two words: the difference of the two is rounding, and tiny.
#[test]
fn two_words_take_the_same_steps() {
    fn check(method: &(impl Integrator<f64> + Integrator<DoubleDouble>)) {
        let (t, steps) = (10.0, 1000);
        let words = run::<DoubleDouble>(method, t, steps);
        let apart = distance(&run::<f64>(method, t, steps), &words);
        assert!(apart[0] < 1e-14 && apart[1] < 1e-14, "{apart:?}");
    }
    for order in Order::ALL {
        check(&FreeSplitting::new(MOMENTS, order).unwrap());
    }
    for order in VeselovOrder::ALL {
        check(&MoserVeselov::new(MOMENTS, order).unwrap());
    }
}
