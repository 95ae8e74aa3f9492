// The racket I = (1, 2, 3), Omega(0) = (eps, 1, eps), by the textbook's formulas (tutorial 6.6) in double precision,
// with the elliptic functions of GSL, of Boost.Math and of the C++ standard library.
//
// Reads lines "eps t1 t2" (hexadecimal floats) and prints, a line for each and each library:
//   library version eps flip_time, then Omega (3) at t1, Omega (3) and attitude (4) at t2.
// What a library refuses is printed as nan. Built and run by flip_time.py.
#include "textbook_top.hpp"

#include <cstdio>

template <class F>
static void guarded(F f) {
    try {
        f();
    } catch (const std::exception&) {
    }
}

template <class Library>
static void report(const char* name, const char* version, double eps, double t1, double t2) {
    double w[3] = {eps, 1, eps}, flip = NONE, one[3] = {NONE, NONE, NONE}, two[3] = {NONE, NONE, NONE};
    Quaternion q = {NONE, NONE, NONE, NONE};
    guarded([&] {
        Top<Library> top(1, 2, 3, w);
        flip = top.flip_time();
        top.prepare();
        top.omega(t1, one);
        top.omega(t2, two);
        double reduced[3];
        q = top.state(t2, reduced);
    });
    std::printf("%s %s %a %a %a %a %a %a %a %a %a %a %a %a\n", name, version, eps, flip, one[0], one[1], one[2], two[0],
                two[1], two[2], q.w, q.x, q.y, q.z);
}

int main() {
    gsl_set_error_handler_off();
    char boost_version[32], standard_version[32];
    std::snprintf(boost_version, sizeof boost_version, "%d.%d", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000);
    std::snprintf(standard_version, sizeof standard_version, "%d", _GLIBCXX_RELEASE);
    double eps, t1, t2;
    while (std::scanf("%la %la %la", &eps, &t1, &t2) == 3) {
        report<Gsl>("GSL", GSL_VERSION, eps, t1, t2);
        report<Boost>("Boost.Math", boost_version, eps, t1, t2);
        report<Standard>("libstdc++", standard_version, eps, t1, t2);
    }
}
