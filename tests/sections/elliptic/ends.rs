//! The ends m = 0 and m = 1, and no jump on the way.

use super::*;

#[test]
fn the_circular_end_is_sine_and_cosine() -> Result<()> {
    let modulus = Modulus::new(Parameter::from_parameter(0.0)?);
    assert_eq!(modulus.quarter_period(), FRAC_PI_2);
    let mut u = 1e-300;
    while u < 1.4e16 {
        let Jacobi { sn, cn, dn, am } = modulus.jacobi(u)?;
        // The platform reduces by π exactly and is good to an ulp; so are we (observed: 0.7 against the table).
        let ulp = |x: f64| x.abs().next_up() - x.abs();
        assert!((sn - u.sin()).abs() <= ulp(sn), "{u}: {sn}");
        assert!((cn - u.cos()).abs() <= ulp(cn), "{u}: {cn}");
        assert_eq!(dn, 1.0);
        assert_eq!(am, u);
        u *= 1.37;
    }
    Ok(())
}

#[test]
fn the_hyperbolic_end_is_tanh_and_sech() -> Result<()> {
    let modulus = Modulus::new(Parameter::from_complement(0.0)?);
    assert_eq!(modulus.quarter_period(), f64::INFINITY);
    let mut u = 1e-300;
    while u < 1e18 {
        let Jacobi { sn, cn, dn, am } = modulus.jacobi(u)?;
        near!(sn, u.tanh(), 3.0 * f64::EPSILON * u.tanh());
        assert_eq!(cn, dn);
        if u < 700.0 {
            // cosh of the platform is good to two ulps.
            near!(cn * u.cosh(), 1.0, 4.0 * f64::EPSILON);
        } else if u > 746.0 {
            assert_eq!(cn, 0.0);
        }
        near!(am, u.sinh().atan(), 3.0 * f64::EPSILON * am);
        u *= 1.37;
    }
    Ok(())
}

/// sn, cn, dn, am at two parameters that hardly differ must hardly differ.
fn no_jump(of: fn(f64) -> Result<Parameter>, [one, two]: [f64; 2], u: f64) -> Result<()> {
    let at = |m: f64| Modulus::new(of(m)?).jacobi(u);
    let (a, b) = (at(one)?, at(two)?);
    let pairs = [(a.sn, b.sn), (a.cn, b.cn), (a.dn, b.dn), (a.am, b.am)];
    // Each is within 4 ulp of the truth, and the truths are within a derivative of at most 4 times the difference of
    // m, which is below 2⁻⁵² (|u| ≤ 3). Observed: 2.9 eps.
    for (a, b) in pairs {
        near!(a, b, 5.0 * f64::EPSILON * a.abs().max(0.5));
    }
    Ok(())
}

#[test]
fn nothing_jumps_at_the_ends_or_where_the_method_changes() -> Result<()> {
    for i in -30..=30 {
        let u = f64::from(i) * 0.1;
        for tiny in [5e-324, 1e-300, 1e-100, 1e-17] {
            no_jump(Parameter::from_parameter, [0.0, tiny], u)?;
            no_jump(Parameter::from_complement, [0.0, tiny], u)?;
        }
        // Twenty floats on either side of 0, of 1 and of 1/2, where sides are changed.
        let (mut least, mut greatest) = (0.0_f64, 1.0_f64);
        let mut half = f64::from_bits(0.5_f64.to_bits() - 20);
        for _ in 0..40 {
            let next = (least.next_up(), greatest.next_down(), half.next_up());
            for pair in [[least, next.0], [greatest, next.1], [half, next.2]] {
                no_jump(Parameter::from_parameter, pair, u)?;
            }
            (least, greatest, half) = next;
        }
    }
    Ok(())
}

#[test]
fn the_three_ways_to_a_parameter_agree() -> Result<()> {
    // (3/5)² + (4/5)² = 1, in the sense of doubles.
    let ways = [
        Parameter::new(0.36, 0.64)?,
        Parameter::from_parameter(0.36)?,
        Parameter::from_complement(0.64)?,
    ];
    for way in ways {
        assert!((complete_first(way)? - complete_first(ways[0])?).abs() <= 2.0 * f64::EPSILON);
    }
    // Where one is tiny it is believed, and the other says no more than 1.
    let tiny = Parameter::new(1.0, 1e-300)?;
    assert_eq!((tiny.m(), tiny.mc()), (1.0, 1e-300));
    let other = Parameter::from_complement(1e-300)?;
    assert_eq!(complete_first(tiny)?, complete_first(other)?);
    Ok(())
}
