//! The pictures k, l, m and n: what the axis writes on the sphere, and where φ' changes its sign (7.2, 7.3, 7.4).

use super::*;

/// Signs of φ' at 400 moments of one nutation: how many are negative, zero up to rounding, positive.
fn signs(top: &LagrangeTop) -> [u32; 3] {
    let mut counts = [0; 3];
    for k in 0..400 {
        let state = at(top, top.period() * (f64::from(k) + 0.5) / 400.0);
        let rate = precession(top, &state);
        counts[usize::from(rate >= 0.0) + usize::from(rate > 0.0)] += 1;
    }
    counts
}

/// How fast the axis moves.
fn speed(top: &LagrangeTop, t: f64) -> f64 {
    let omega = at(top, t).omega;
    omega.x().hypot(omega.y())
}

// claim: C7.2-12
#[test]
fn s7_2_waves_or_swirls() {
    // L_vert/L₃ = 2 is outside the band [0, ½], 1/3 is strictly inside [−½, ½].
    for (top, kind) in [(wave(), Nutation::Waves), (swirl(), Nutation::Loops)] {
        assert!(is(&top, kind), "{:?}", top.kind());
        let ([h1, h2, _], (l3, vertical)) = (roots(&top), spins(&top));
        let still = vertical / l3;
        let [negative, _, positive] = signs(&top);
        assert_eq!(h1 < still && still < h2, negative > 0 && positive > 0);
    }
    // Equal to h₂: cusps. Whatever the tilt and the spin, release from rest is that.
    for (degrees, l3) in [(30.0_f64, 2.0), (90.0, -3.0), (120.0, 0.7), (60.0, 20.0)] {
        let top = released(degrees.to_radians(), l3);
        assert!(is(&top, Nutation::Cusps), "{:?}", top.kind());
        let [negative, _, positive] = signs(&top);
        assert!(negative == 0 || positive == 0, "{negative} {positive}");
        let still = top.vertical_angular_momentum() / l3;
        near!(still, roots(&top)[1], 0.0..=4e-16);
    }
    // A little φ' at release, forward or backward, makes waves or loops of them.
    assert!(is(&spun(1.0, 0.0, 1e-9, 2.0), Nutation::Waves));
    assert!(is(&spun(1.0, 0.0, -1e-9, 2.0), Nutation::Loops));
    // L₃ = 0: φ' keeps the sign of L_vert. And φ' = 0 at h₁ there cannot be: a start at rest is at h₂.
    let [negative, _, positive] = signs(&spun(1.0, 0.3, 0.5, 0.0));
    assert_eq!((negative, positive), (0, 400));
    let mut numbers = Uniform(7212);
    for _ in 0..200 {
        let (theta, l3) = (3.1 * numbers.next() + 0.02, 4.0 * numbers.signed());
        let [h1, h2, _] = roots(&released(theta, l3));
        assert!(theta.cos() - h1 > 1e-6 && (theta.cos() - h2).abs() < 1e-15);
        // And from anywhere on its way.
        let top = spun(theta, numbers.signed(), 2.0 * numbers.signed(), l3);
        let [negative, _, positive] = signs(&top);
        assert_eq!(is(&top, Nutation::Loops), negative > 0 && positive > 0);
    }
}

// claim: C7.2-16
#[test]
fn s7_2_picture_k_waves() {
    let top = wave();
    assert_eq!(signs(&top), [0, 0, 400]);
    // The trace goes round between two circles of latitude and touches both without a stop.
    near!(speed(&top, 0.0), 2.0, 0.0..=3e-16);
    // At the upper circle φ' = (2 − ½)/(3/4) = 2 and sin θ = √3/2.
    near!(speed(&top, 0.5 * top.period()), 3.0_f64.sqrt(), 0.0..=3e-16);
}

// claim: C7.2-17
#[test]
fn s7_2_picture_m_loops() {
    let top = swirl();
    let [negative, _, positive] = signs(&top);
    assert!(negative > 50 && positive > 200, "{negative} {positive}");
    // φ' = 0 at h = L_vert/L₃ = 1/3: forward below, backward above.
    for k in 0..200 {
        let state = at(&top, 0.0173 * f64::from(k));
        let rate = precession(&top, &state);
        assert_eq!(rate > 0.0, state.height < 1.0 / 3.0, "{}", state.height);
    }
    // The trace crosses itself: going up through 1/3 and coming down through it the azimuth has run back.
    let (mut before, mut after) = (0.0, 0.5 * top.period());
    for _ in 0..60 {
        let middle = 0.5 * (before + after);
        let below = at(&top, middle).height < 1.0 / 3.0;
        *(if below { &mut before } else { &mut after }) = middle;
    }
    let ends = [before, top.period() - before].map(|t| axis(&at(&top, t)));
    let back = ends[0][0] * ends[1][1] - ends[0][1] * ends[1][0];
    assert!(back < -0.01, "{back}");
    // Still forward on the whole.
    assert!(top.precession_per_nutation().unwrap() > 1.7);
}

// claim: C7.4-5
#[test]
fn s7_4_picture_l_cusps() {
    // Where the text has "picture 1" it means picture l (E6), the one between k and m. What that shows: at the upper
    // circle the axis stands still, and leaves and arrives along the meridian.
    let top = released(FRAC_PI_3, 2.0);
    assert_eq!(speed(&top, 0.0), 0.0);
    observed!(speed(&top, top.period()), 0.0..=3e-16);
    assert!(speed(&top, 0.5 * top.period()) > 0.9);
    for t in [1e-2, 1e-3] {
        let [x, y, _] = axis(&at(&top, t));
        let [x0, y0, _] = axis(&at(&top, 0.0));
        // Down by ½ sin²θ t², along the parallel by t³ only.
        let aside = (x * y0 - y * x0).abs() / x0.hypot(y0);
        assert!(aside < t * t * t, "{aside:e}");
        let fall = axis(&at(&top, 0.0))[2] - at(&top, t).height;
        within((fall / (0.375 * t * t) - 1.0).abs(), t * t);
    }
    // Among a fan of starts at one tilt only the one at rest has cusps; at φ' = 2Mgl/L₃ = 1 the start would be below one.
    let cusps = (-20..20).filter(|k| {
        let top = spun(1.0, 0.0, 0.05 * f64::from(*k), 2.0);
        is(&top, Nutation::Cusps)
    });
    assert_eq!(cusps.collect::<Vec<_>>(), [0]);
}

// claim: C7.3-8
#[test]
fn s7_3_picture_n_a_circle_of_latitude() {
    // cos θ = 0: the horizontal top precesses with Mgl/L₃, here ½, exactly.
    let top = started([0.0, 0.5, 4.0], level());
    assert!(is(&top, Nutation::PurePrecession), "{:?}", top.kind());
    for k in 0..100 {
        let t = 0.9 * f64::from(k);
        let [x, y, z] = axis(&at(&top, t));
        observed!(z.abs(), 1e-16..=2e-15);
        // From (0, −1, 0) round at the rate ½.
        let (sine, cosine) = (0.5 * t).sin_cos();
        observed!((x - sine).hypot(y + cosine), 1e-16..=2e-15);
    }
    let mean = mean(50, |s| at(&top, 2.0 * TAU * s).height);
    observed!(mean.abs(), 0.0..=3e-16);
    // Its neighbours make waves of it.
    assert!(!is(&turning(0.0, 2.0, 0.6), Nutation::PurePrecession));
}
