// The textbook's formulas for the free top (tutorial 6.6) in double precision, the way a user writes them down, over the
// elliptic functions of a library: GSL, Boost.Math, or the C++ standard library (which has K but no Jacobi functions).
// The azimuth about L is the integral of the third kind, by the library's Carlson forms.
#pragma once
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_ellint.h>
#include <gsl/gsl_sf_elljac.h>
#include <gsl/gsl_version.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>
#include <boost/version.hpp>
#include <cmath>
#include <limits>

static const double NONE = std::numeric_limits<double>::quiet_NaN();

struct Gsl {
    static double K(double k) { return gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE); }
    static double RF(double x, double y, double z) { return gsl_sf_ellint_RF(x, y, z, GSL_PREC_DOUBLE); }
    static double RJ(double x, double y, double z, double p) { return gsl_sf_ellint_RJ(x, y, z, p, GSL_PREC_DOUBLE); }
    static void jacobi(double u, double k, double& sn, double& cn, double& dn) {
        if (gsl_sf_elljac_e(u, k * k, &sn, &cn, &dn)) sn = cn = dn = NONE;
    }
};

struct Boost {
    static double K(double k) { return boost::math::ellint_1(k); }
    static double RF(double x, double y, double z) { return boost::math::ellint_rf(x, y, z); }
    static double RJ(double x, double y, double z, double p) { return boost::math::ellint_rj(x, y, z, p); }
    static void jacobi(double u, double k, double& sn, double& cn, double& dn) {
        sn = boost::math::jacobi_elliptic(k, u, &cn, &dn);
    }
};

// The same without Boost's default of computing doubles in long double.
struct BoostDouble {
    typedef boost::math::policies::policy<boost::math::policies::promote_double<false>> Policy;
    static double K(double k) { return boost::math::ellint_1(k, Policy()); }
    static double RF(double x, double y, double z) { return boost::math::ellint_rf(x, y, z, Policy()); }
    static double RJ(double x, double y, double z, double p) { return boost::math::ellint_rj(x, y, z, p, Policy()); }
    static void jacobi(double u, double k, double& sn, double& cn, double& dn) {
        sn = boost::math::jacobi_elliptic(k, u, &cn, &dn, Policy());
    }
};

struct Standard {
    static double K(double k) { return std::comp_ellint_1(k); }
    static double RF(double, double, double) { return NONE; }
    static double RJ(double, double, double, double) { return NONE; }
    static void jacobi(double, double, double& sn, double& cn, double& dn) { sn = cn = dn = NONE; }
};

struct Quaternion {
    double w, x, y, z;
};

static Quaternion operator*(Quaternion p, Quaternion q) {
    return {p.w * q.w - p.x * q.x - p.y * q.y - p.z * q.z, p.w * q.x + p.x * q.w + p.y * q.z - p.z * q.y,
            p.w * q.y - p.x * q.z + p.y * q.w + p.z * q.x, p.w * q.z + p.x * q.y - p.y * q.x + p.z * q.w};
}
static Quaternion about_y(double a) { return {std::cos(a / 2), 0, std::sin(a / 2), 0}; }
static Quaternion about_z(double a) { return {std::cos(a / 2), 0, 0, std::sin(a / 2)}; }

// The formulas of 6.6 for the sector L^2 > 2 E I2, Omega_3 > 0, and the azimuth about L by the integral of the third kind.
template <class Library>
struct Top {
    double i1, i2, i3, w[3], L, rate, k, a1, a2, a3, n, K, PiK, phase, third0;

    Top(double i1, double i2, double i3, const double w[3]) : i1(i1), i2(i2), i3(i3), w{w[0], w[1], w[2]} {
        double energy2 = i1 * w[0] * w[0] + i2 * w[1] * w[1] + i3 * w[2] * w[2];
        double l2 = i1 * i1 * w[0] * w[0] + i2 * i2 * w[1] * w[1] + i3 * i3 * w[2] * w[2];
        L = std::sqrt(l2);
        rate = std::sqrt((i3 - i2) * (l2 - energy2 * i1) / (i1 * i2 * i3));
        k = std::sqrt((i2 - i1) * (energy2 * i3 - l2) / ((i3 - i2) * (l2 - energy2 * i1)));
        a1 = std::sqrt((energy2 * i3 - l2) / (i1 * (i3 - i1)));
        a2 = std::sqrt((energy2 * i3 - l2) / (i2 * (i3 - i2)));
        a3 = std::sqrt((l2 - energy2 * i1) / (i3 * (i3 - i1)));
        n = -i3 * (i2 - i1) / (i1 * (i3 - i2));
        K = Library::K(k);
    }
    void prepare() {
        PiK = third(1, 0);
        double angle = std::atan2(w[1] / a2, w[0] / a1), s = std::sin(angle), c = std::cos(angle);
        phase = s * Library::RF(c * c, 1 - k * k * s * s, 1);
        third0 = third(s, std::fabs(c));
        if (c < 0) {
            double far = s >= 0 ? 1 : -1;
            phase = 2 * far * K - phase;
            third0 = 2 * far * PiK - third0;
        }
    }
    double third(double s, double c) const {
        double y = 1 - k * k * s * s;
        return s * Library::RF(c * c, y, 1) + n / 3 * s * s * s * Library::RJ(c * c, y, 1, 1 - n * s * s);
    }
    double flip_time() const { return 2 * K / rate; }
    void omega(double t, double out[3]) const {
        double sn, cn, dn;
        Library::jacobi(rate * t + phase, k, sn, cn, dn);
        out[0] = a1 * cn, out[1] = a2 * sn, out[2] = a3 * dn;
    }
    Quaternion tilted(const double o[3], int sense) const {
        double x = i1 * o[0], y = i2 * o[1], tilt = std::atan2(std::hypot(x, y), i3 * o[2]), heading = std::atan2(y, x);
        return sense > 0 ? about_z(heading) * about_y(tilt) : about_y(-tilt) * about_z(-heading);
    }
    // Omega and the attitude with one call of the Jacobi functions, their argument reduced by half periods.
    Quaternion state(double t, double o[3]) const {
        double u = rate * t + phase, halves = std::floor(u / (2 * K) + 0.5), sn, cn, dn;
        Library::jacobi(u - 2 * halves * K, k, sn, cn, dn);
        double turned = third(sn, cn) + 2 * halves * PiK - third0, sign = std::fmod(halves, 2) == 0 ? 1 : -1;
        o[0] = sign * a1 * cn, o[1] = sign * a2 * sn, o[2] = a3 * dn;
        return tilted(w, +1) * about_z(L * t / i3 + L * (i3 - i1) / (i1 * i3 * rate) * turned) * tilted(o, -1);
    }
};
