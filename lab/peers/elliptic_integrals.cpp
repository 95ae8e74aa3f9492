// Boost's elliptic integrals in long double and GSL's in double, timed for lab/benches/elliptic.rs. The argument is the
// function; reads its arguments in hexadecimal floats, four a line, until the end of the input, goes over the list again
// and again, and prints the least times of a call in nanoseconds, Boost's first. Built by build.sh.
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_3.hpp>
#include <boost/math/special_functions/ellint_rc.hpp>
#include <boost/math/special_functions/ellint_rd.hpp>
#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rg.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_ellint.h>
#include <limits>
#include <string>
#include <vector>

using namespace boost::math;
using Real = long double;

struct Row {
    double a[4];
};

template <class Function> double least(const std::vector<Row> &rows, double &sum, Function function)
{
    double best = std::numeric_limits<double>::infinity();
    for (int round = 0; round < 20; round++) {
        auto start = std::chrono::steady_clock::now();
        for (const Row &row : rows)
            sum += static_cast<double>(function(row.a));
        std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        best = std::fmin(best, time.count() / static_cast<double>(rows.size()));
    }
    return best;
}

int main(int, char **argv)
{
    const gsl_mode_t mode = GSL_PREC_DOUBLE;
    std::string function = argv[1];
    std::vector<Row> rows;
    Row row;
    while (scanf("%la %la %la %la", &row.a[0], &row.a[1], &row.a[2], &row.a[3]) == 4)
        rows.push_back(row);
    gsl_set_error_handler_off();
    double sum = 0, boost = NAN, gsl = NAN;
#define TIMED(name, ours, theirs)                                                                                      \
    if (function == name) {                                                                                            \
        boost = least(rows, sum, [&](const double *a) { return ours; });                                               \
        gsl = least(rows, sum, [&](const double *a) { return theirs; });                                               \
    }
    TIMED("F", ellint_1(std::sqrt(Real(a[1])), Real(a[0])), gsl_sf_ellint_F(a[0], std::sqrt(a[1]), mode))
    TIMED("E", ellint_2(std::sqrt(Real(a[1])), Real(a[0])), gsl_sf_ellint_E(a[0], std::sqrt(a[1]), mode))
    TIMED("Pi", ellint_3(std::sqrt(Real(a[1])), Real(a[2]), Real(a[0])), gsl_sf_ellint_P(a[0], std::sqrt(a[1]), -a[2], mode))
    TIMED("RF", ellint_rf(Real(a[0]), Real(a[1]), Real(a[2])), gsl_sf_ellint_RF(a[0], a[1], a[2], mode))
    TIMED("RC", ellint_rc(Real(a[0]), Real(a[1])), gsl_sf_ellint_RC(a[0], a[1], mode))
    TIMED("RD", ellint_rd(Real(a[0]), Real(a[1]), Real(a[2])), gsl_sf_ellint_RD(a[0], a[1], a[2], mode))
    TIMED("RJ", ellint_rj(Real(a[0]), Real(a[1]), Real(a[2]), Real(a[3])), gsl_sf_ellint_RJ(a[0], a[1], a[2], a[3], mode))
    // GSL has none.
    if (function == "RG")
        boost = least(rows, sum, [&](const double *a) { return ellint_rg(Real(a[0]), Real(a[1]), Real(a[2])); });
    printf("%.3f %.3f %g\n", boost, gsl, sum);
    return 0;
}
