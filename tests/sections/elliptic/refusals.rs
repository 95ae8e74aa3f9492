//! Bad input is refused; no finite input gives not-a-number.

use super::*;
use spinning_bodies::elliptic::sn_cn_dn;
use support::any;

#[test]
fn bad_input_is_refused_by_name_and_number() -> Result<()> {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refused!(Parameter::from_parameter(bad), NotFinite, "parameter m");
        assert!(Parameter::from_complement(bad).is_err());
        assert!(Parameter::new(bad, 0.5).is_err());
        assert!(Parameter::new(0.5, bad).is_err());
        assert!(Characteristic::from_characteristic(bad).is_err());
        assert!(Characteristic::from_complement(bad).is_err());
        let c = Characteristic::from_characteristic(0.5)?;
        for p in [0.0, 0.3, 0.8, 1.0] {
            let p = Parameter::from_parameter(p)?;
            refused!(Modulus::new(p).jacobi(bad), NotFinite, "argument u");
            let [mut sn, mut cn, mut dn] = [[0.0; 2]; 3];
            let batch = Modulus::new(p).jacobi_batch(&[1.0, bad], &mut sn, &mut cn, &mut dn);
            assert!(batch.is_err());
            assert!(incomplete_first(bad, p).is_err());
            assert!(incomplete_second(bad, p).is_err());
            assert!(incomplete_third(bad, c, p).is_err());
            assert!(inverse_sn(bad, p).is_err());
            assert!(inverse_cn(bad, p).is_err());
            assert!(inverse_dn(bad, p).is_err());
            assert!(inverse_cn_sn(bad, 1.0, p).is_err());
            assert!(inverse_cn_sn(1.0, bad, p).is_err());
        }
        for i in 0..4 {
            let mut x = [1.0; 4];
            x[i] = bad;
            if i < 3 {
                assert!(rf(x[0], x[1], x[2]).is_err());
                assert!(rd(x[0], x[1], x[2]).is_err());
                assert!(rg(x[0], x[1], x[2]).is_err());
            }
            assert!(rj(x[0], x[1], x[2], x[3]).is_err());
            if i < 2 {
                assert!(rc(x[0], x[1]).is_err());
            }
        }
    }
    let text = |error: Option<Error>| error.map(|e| e.to_string()).unwrap_or_default();
    assert_eq!(
        text(Parameter::from_parameter(1.5).err()),
        "parameter m must lie between 0 and 1, got 1.5"
    );
    assert_eq!(
        text(Parameter::from_complement(-0.5).err()),
        "complementary parameter mc must lie between 0 and 1, got -0.5"
    );
    assert_eq!(
        text(Parameter::new(0.5, 0.4).err()),
        "m + mc must be 1 to within 4 eps, got 0.9"
    );
    let p = Parameter::from_parameter(0.3)?;
    // Beyond 2⁵³ quarter periods, and a slice too short.
    refused!(Modulus::new(p).jacobi(1e17), OutOfRange, "argument u");
    assert!(Modulus::new(p).jacobi(1e15).is_ok());
    let [mut cn, mut dn] = [[0.0]; 2];
    let batch = Modulus::new(p).jacobi_batch(&[1.0], &mut [], &mut cn, &mut dn);
    assert!(batch.is_err());
    assert!(incomplete_first(1e16, p).is_err());
    assert!(inverse_sn(1.1, p).is_err());
    assert!(inverse_cn(-1.1, p).is_err());
    assert!(inverse_dn(0.5, p).is_err());
    assert!(inverse_cn_sn(0.0, 0.0, p).is_err());
    // Poles of the third kind, and arguments outside the domain of Carlson's forms.
    let one = Characteristic::from_complement(0.0)?;
    assert!(complete_third(one, p).is_err());
    assert!(incomplete_third(2.0, one, p).is_err());
    assert!(incomplete_third(1.0, one, p).is_ok());
    assert!(rf(-1.0, 1.0, 1.0).is_err());
    assert!(rf(0.0, 0.0, 1.0).is_err());
    assert!(rc(1.0, 0.0).is_err());
    assert!(rd(1.0, 1.0, 0.0).is_err());
    assert!(rj(1.0, 1.0, 1.0, 0.0).is_err());
    assert!(rg(-1.0, 1.0, 1.0).is_err());
    Ok(())
}

#[test]
fn values_without_room_and_integrals_that_are_not_real_are_refused() -> Result<()> {
    let text = |refused: Result<f64>| refused.expect_err("refused").to_string();
    assert_eq!(
        text(rd(1e-300, 1e-300, 1e-300)),
        "the value of R_D must be finite, got inf"
    );
    assert!(text(rj(0.0, 5e-324, 1.0, 5e-324)).starts_with("the value of R_J"));
    // x^(−3/2) and x^(−1/2) at the ends of the range.
    assert_eq!(rd(1e300, 1e300, 1e300)?, 0.0);
    assert_eq!(rj(1e215, 1e215, 1e215, 1e215)?, 10f64.powf(-322.5));
    assert_eq!(rf(5e-324, 5e-324, 5e-324)?, 2f64.powi(537));
    assert_eq!(rc(5e-324, -f64::MAX)?, 0.0);
    let two = Characteristic::from_characteristic(2.0)?;
    for refused in [
        complete_first(two),
        complete_second(two),
        complete_d(two),
        complete_b(two),
        complete_third(two, two),
    ] {
        assert!(text(refused).contains("not real, got 2"));
    }
    // m sin² φ = 1 at π/4, where it ends; beyond, and past the next zero of the sine, there is nothing.
    assert!(incomplete_first(0.785, two).is_ok());
    for phi in [0.786, -1.5, 3.0, 1e6] {
        assert!(text(incomplete_first(phi, two)).contains("not real, got 2"));
        assert!(incomplete_second(phi, two).is_err() && incomplete_third(phi, two, two).is_err());
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_bits_at_all_give_not_a_number(x in prop::array::uniform4(any()), m in any(), n in any()) {
        let [a, b, c, d] = x;
        let e = x.map(f64::abs);
        for [a, b, c, d] in [[a, b, c, d], e, [e[0], e[1], e[2], d]] {
            let forms = [rf(a, b, c), rc(a, b), rd(a, b, c), rg(a, b, c), rj(a, b, c, d), rc(a, d)];
            for value in forms.into_iter().flatten() {
                prop_assert!(value.is_finite(), "{a:e} {b:e} {c:e} {d:e}");
            }
        }
        let small = |x: f64| f64::from_bits(x.to_bits() % 1f64.to_bits());
        let wide = [Characteristic::from_characteristic(n), Characteristic::from_complement(n), Characteristic::from_characteristic(small(n))];
        let mut given = vec![Parameter::from_parameter(m), Parameter::from_complement(m), Parameter::new(m, n)];
        given.extend([Parameter::from_parameter(small(m)), Parameter::from_complement(small(m))]);
        for p in given.into_iter().flatten() {
            let modulus = Modulus::new(p);
            let mut values: Vec<Result<f64>> = x.iter().flat_map(|&x| [inverse_sn(x, p), inverse_cn(x, p), inverse_dn(x, p), inverse_cn_sn(x, a, p)]).collect();
            for u in x {
                if let Ok(Jacobi { sn, cn, dn, am }) = modulus.jacobi(u) {
                    values.extend([Ok(sn), Ok(cn), Ok(dn), Ok(am)]);
                }
                if let (Ok((sn, cn, dn)), Ok(other)) = (sn_cn_dn(u, p), modulus.sn_cn_dn(u)) {
                    prop_assert_eq!((sn, cn, dn), other);
                }
            }
            let mut batch = [[0.0; 4]; 3];
            let [s, c, d] = &mut batch;
            if modulus.jacobi_batch(&x, s, c, d).is_ok() {
                values.extend(batch.as_flattened().iter().map(|x| Ok(*x)));
            }
            for value in values.into_iter().flatten() {
                prop_assert!(!value.is_nan(), "{x:?} {p:?}");
            }
        }
        let every: Vec<Characteristic> = [Characteristic::from_characteristic(m), Characteristic::from_complement(m), Parameter::from_complement(small(m)).map(Into::into)].into_iter().flatten().collect();
        for p in every {
            let mut values = vec![complete_first(p), complete_second(p), complete_d(p), complete_b(p)];
            for phi in [a, small(b)] {
                values.extend([incomplete_first(phi, p), incomplete_second(phi, p)]);
                values.extend(wide.iter().flatten().flat_map(|&n| [complete_third(n, p), incomplete_third(phi, n, p)]));
            }
            for value in values.into_iter().flatten() {
                prop_assert!(!value.is_nan(), "{x:?} {p:?} {n:e}");
            }
        }
    }
}
