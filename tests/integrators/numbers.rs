//! One method in three kinds of numbers: what of its error is the step's, and what is rounding.

use spinning_bodies::integrators::geometric::{
    FreeSplitting, Integrator, MoserVeselov, Order, Phase, Real, TwoWords, VeselovOrder,
};

use super::common::{MOMENTS, distance, free, start};

fn run<T: Real>(method: &impl Integrator<T>, t: f64, steps: u64) -> Phase {
    let mut phase = start().cast::<T>();
    let step = T::from_double(t / steps as f64);
    method.advance(&mut phase, step, steps).unwrap();
    phase.cast()
}

#[test]
fn rounding_falls_with_the_length_of_the_numbers() {
    let (t, steps) = (16.0, 16_384);
    let exact = free(MOMENTS, &start(), t);
    let method = FreeSplitting::new(MOMENTS, Order::Six).unwrap();
    let [f32_error, _] = distance(&run::<f32>(&method, t, steps), &exact);
    let [f64_error, _] = distance(&run::<f64>(&method, t, steps), &exact);
    let [dd_error, _] = distance(&run::<TwoWords>(&method, t, steps), &exact);
    println!("{f32_error:e} {f64_error:e} {dd_error:e}");
    assert!(f32_error > 1e-8 && f32_error < 2e-5);
    assert!(f64_error < 1e-14 && dd_error < 2e-15);
}

/// The truncation error is the same in doubles and in two words: the difference of the two is rounding, and tiny.
#[test]
fn two_words_take_the_same_steps() {
    let (t, steps) = (10.0, 1000);
    for order in Order::ALL {
        let method = FreeSplitting::new(MOMENTS, order).unwrap();
        let apart = distance(
            &run::<f64>(&method, t, steps),
            &run::<TwoWords>(&method, t, steps),
        );
        assert!(apart[0] < 1e-14 && apart[1] < 1e-14, "{order:?} {apart:?}");
    }
    for order in VeselovOrder::ALL {
        let method = MoserVeselov::new(MOMENTS, order).unwrap();
        let apart = distance(
            &run::<f64>(&method, t, steps),
            &run::<TwoWords>(&method, t, steps),
        );
        assert!(apart[0] < 1e-14 && apart[1] < 1e-14, "{order:?} {apart:?}");
    }
}
