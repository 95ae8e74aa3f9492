//! Lengths of the part steps of a symmetric splitting, from Blanes and Moan (2002), "Practical symplectic partitioned Runge–Kutta and
//! Runge–Kutta–Nyström methods", J. Comput. Appl. Math. 142, tables 2 and 3: S6 and S10 for any two parts, SRKN 6 and 11 of type b for free motions
//! and kicks by a torque that depends on the attitude alone. That such kicks commute matters only beyond order 4, so all but the last
//! set hold for any two parts, and for any three where a step and its mirror image alternate.

/// The part steps of A B A … A, symmetric, those of A and those of B each with the sum 1. `first` holds the first ones, of A and B in turn; the
/// next completes half of its sum, and the one in the middle completes the sum of the other part.
pub(super) fn part_steps(first: &[f64]) -> Vec<f64> {
    let left_of_half = |place: usize| {
        let alike = first.iter().skip(place % 2).step_by(2);
        0.5 - alike.sum::<f64>()
    };
    let next = first.len();
    let before = first.iter().copied().chain([left_of_half(next)]);
    let after = before.clone().rev();
    let middle = 2.0 * left_of_half(next + 1);
    before.chain([middle]).chain(after).collect()
}

/// Order 2: half a step of A, B, half a step of A.
pub(super) const STRANG: &[f64] = &[];

/// Order 4 for any two parts.
#[rustfmt::skip]
pub(super) const S6: &[f64] = &[
     0.079_203_696_431_195_7,  0.209_515_106_613_362,
     0.353_172_906_049_774,   -0.143_851_773_179_818,
    -0.042_065_080_357_719_5,
];

/// Order 6 for any two parts.
#[rustfmt::skip]
pub(super) const S10: &[f64] = &[
     0.050_262_764_400_392_2,  0.148_816_447_901_042,
     0.413_514_300_428_344,   -0.132_385_865_767_784,
     0.045_079_889_794_397_7,  0.067_307_604_692_185,
    -0.188_054_853_819_569,    0.432_666_402_578_175,
     0.541_960_678_450_780,
];

/// Order 4 for any two parts; its error is smallest for kicks and free motions.
#[rustfmt::skip]
pub(super) const NYSTROM_6: &[f64] = &[
     0.082_984_406_417_405_2,  0.245_298_957_184_271,
     0.396_309_801_498_368,    0.604_872_665_711_080,
    -0.039_056_304_922_348_6,
];

/// Order 6 for kicks (A) and free motions (B).
#[rustfmt::skip]
pub(super) const NYSTROM_11: &[f64] = &[
     0.041_464_998_518_262_4,  0.123_229_775_946_271,
     0.198_128_671_918_067,    0.290_553_797_799_558,
    -0.040_006_192_104_153_3, -0.127_049_212_625_417,
     0.075_253_984_301_580_7, -0.246_331_761_062_075,
    -0.011_511_387_420_687_9,  0.357_208_872_795_928,
];
