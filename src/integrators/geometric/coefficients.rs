//! Lengths of the part steps of a symmetric splitting, from Blanes and Moan (2002), "Practical symplectic partitioned Runge–Kutta and
//! Runge–Kutta–Nyström methods", J. Comput. Appl. Math. 142, tables 2 and 3: S6 and S10 for any two parts, SRKN 6 and 11 of type b for kicks by a
//! torque that depends on the attitude alone between free motions. That three such kicks in a row commute counts beyond order 4 only, so all but the last
//! hold for any two parts, and for any three where a step and its mirror image follow each other.

/// Part steps A B A B … A: `outer` has one more than `inner`, both are symmetric and have the sum 1.
pub(super) struct Splitting {
    /// All A but the last, which equals the first.
    pub outer: &'static [f64],
    /// All B.
    pub inner: &'static [f64],
}

pub(super) const STRANG: Splitting = Splitting {
    outer: &[0.5],
    inner: &[1.0],
};

/// Order 4 for any two parts.
pub(super) const S6: Splitting = {
    let [a1, a2, a3] = [
        0.079_203_696_431_195_7,
        0.353_172_906_049_774,
        -0.042_065_080_357_719_5,
    ];
    let [b1, b2] = [0.209_515_106_613_362, -0.143_851_773_179_818];
    let a4 = 1.0 - 2.0 * (a1 + a2 + a3);
    let b3 = 0.5 - (b1 + b2);
    Splitting {
        outer: &[a1, a2, a3, a4, a3, a2],
        inner: &[b1, b2, b3, b3, b2, b1],
    }
};

/// Order 6 for any two parts.
pub(super) const S10: Splitting = {
    let [a1, a2, a3, a4, a5] = [
        0.050_262_764_400_392_2,
        0.413_514_300_428_344,
        0.045_079_889_794_397_7,
        -0.188_054_853_819_569,
        0.541_960_678_450_780,
    ];
    let [b1, b2, b3, b4] = [
        0.148_816_447_901_042,
        -0.132_385_865_767_784,
        0.067_307_604_692_185,
        0.432_666_402_578_175,
    ];
    let a6 = 1.0 - 2.0 * (a1 + a2 + a3 + a4 + a5);
    let b5 = 0.5 - (b1 + b2 + b3 + b4);
    Splitting {
        outer: &[a1, a2, a3, a4, a5, a6, a5, a4, a3, a2],
        inner: &[b1, b2, b3, b4, b5, b5, b4, b3, b2, b1],
    }
};

/// Order 4 for any two parts; its error is least for kicks and free motions.
pub(super) const NYSTROM_6: Splitting = {
    let [b1, b2, b3] = [
        0.082_984_406_417_405_2,
        0.396_309_801_498_368,
        -0.039_056_304_922_348_6,
    ];
    let [a1, a2] = [0.245_298_957_184_271, 0.604_872_665_711_080];
    let b4 = 1.0 - 2.0 * (b1 + b2 + b3);
    let a3 = 0.5 - (a1 + a2);
    Splitting {
        outer: &[b1, b2, b3, b4, b3, b2],
        inner: &[a1, a2, a3, a3, a2, a1],
    }
};

/// Order 6 for kicks (outer) and free motions (inner).
pub(super) const NYSTROM_11: Splitting = {
    let [b1, b2, b3, b4, b5] = [
        0.041_464_998_518_262_4,
        0.198_128_671_918_067,
        -0.040_006_192_104_153_3,
        0.075_253_984_301_580_7,
        -0.011_511_387_420_687_9,
    ];
    let [a1, a2, a3, a4, a5] = [
        0.123_229_775_946_271,
        0.290_553_797_799_558,
        -0.127_049_212_625_417,
        -0.246_331_761_062_075,
        0.357_208_872_795_928,
    ];
    let b6 = 0.5 - (b1 + b2 + b3 + b4 + b5);
    let a6 = 1.0 - 2.0 * (a1 + a2 + a3 + a4 + a5);
    Splitting {
        outer: &[b1, b2, b3, b4, b5, b6, b6, b5, b4, b3, b2],
        inner: &[a1, a2, a3, a4, a5, a6, a5, a4, a3, a2, a1],
    }
};
