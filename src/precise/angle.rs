//! The angle of a point in twice the precision.

use super::{DoubleDouble, Number, logarithm::THIRD};

/// π/2 to 106 bits.
pub(crate) const RIGHT_ANGLE: DoubleDouble =
    DoubleDouble::new(core::f64::consts::FRAC_PI_2, 6.123_233_995_736_766e-17);

/// arctan(j/16) for j = 0…16, twice the precision.
const ARCTANGENTS: [[f64; 2]; 17] = [
    [0.0, 0.0],
    [0.062_418_809_995_957_35, -1.549_075_630_829_504_6e-18],
    [0.124_354_994_546_761_44, -3.125_324_142_453_938_3e-18],
    [0.185_347_949_995_694_76, 4.180_692_268_843_079e-18],
    [0.244_978_663_126_864_14, 1.069_875_561_873_445_1e-17],
    [0.302_884_868_374_971_4, -1.101_082_790_300_136_9e-17],
    [0.358_770_670_270_572_25, -2.462_381_558_263_863_5e-17],
    [0.412_410_441_597_387_3, -1.587_652_227_770_689e-17],
    [0.463_647_609_000_806_1, 2.269_877_745_296_168_7e-17],
    [0.512_389_460_310_737_7, -2.546_278_147_285_580_4e-17],
    [0.558_599_315_343_562_4, -5.455_630_548_591_626_4e-18],
    [0.602_287_346_134_964_2, 2.950_430_737_228_402e-17],
    [0.643_501_108_793_284_4, 1.583_478_505_144_428_6e-17],
    [0.682_316_554_874_748_1, 6.943_223_671_560_008e-18],
    [0.718_829_999_621_624_5, -2.147_838_844_445_698_3e-17],
    [0.753_151_280_962_194_4, -2.425_693_465_918_206_8e-17],
    [core::f64::consts::FRAC_PI_4, 3.061_616_997_868_383e-17],
];

/// The angle of the point (cosine, sine), both not negative and not both zero, to about 2⁻⁸⁰ of 1.
pub(crate) fn angle(cosine: DoubleDouble, sine: DoubleDouble) -> DoubleDouble {
    let steep = sine.high() > cosine.high();
    let (along, across) = if steep {
        (sine, cosine)
    } else {
        (cosine, sine)
    };
    // The nearest sixteenth of the tangent, in sixteenths.
    let index = ((across.high() / along.high() * 16.0 + 0.5) as usize).min(16);
    let [high, low] = ARCTANGENTS[index];
    let slope = index as f64 / 16.0;
    let r = (across - along.times(slope)).quick_quotient(along.add_alike(across.times(slope)));
    let square = r * r;
    let y = square.value();
    let tail = y * y * (0.2 - y * (1.0 / 7.0 - y * (1.0 / 9.0 - y * (1.0 / 11.0 - y / 13.0))));
    let series = (DoubleDouble::from(1.0) - square * THIRD).add_alike(DoubleDouble::from(tail));
    let small = r * series + DoubleDouble::sum(high, low);
    if steep { RIGHT_ANGLE - small } else { small }
}

#[cfg(test)]
mod tests {
    use super::angle;
    use crate::precise::{DoubleDouble, Number};

    #[test]
    fn angles_add_as_rotations_do() {
        for i in 0..200 {
            let t = f64::from(i) * 0.01 / 2.0;
            let (c, s) = (DoubleDouble::from(t.cos()), DoubleDouble::from(t.sin()));
            let c2 = c * c - s * s;
            let s2 = (c * s).scaled(2.0);
            if c2.value() < 0.0 {
                continue;
            }
            let rest = angle(c2, s2) - angle(c, s).scaled(2.0);
            assert!(rest.value().abs() < 1e-22, "{t}: {rest:?}");
            assert!((angle(c, s).value() - t).abs() < 2e-16);
        }
    }
}
