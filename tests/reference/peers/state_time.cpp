// Nanoseconds for one state (Omega and attitude) of a free top by the textbook's formulas over GSL and over Boost.Math:
// with the body prepared, and with its preparation. Least of many batches, on one core.
//
//     g++ -std=c++17 -O2 -o state_time state_time.cpp -lgsl -lgslcblas && ./state_time
#include "textbook_top.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

static volatile double sink;

template <class F>
static double nanoseconds(int calls, F f) {
    double best = 1e300;
    for (int batch = 0; batch < 60; ++batch) {
        auto start = std::chrono::steady_clock::now();
        double sum = 0;
        for (int i = 0; i < calls; ++i) sum += f(i);
        sink = sum;
        std::chrono::duration<double, std::nano> taken = std::chrono::steady_clock::now() - start;
        best = std::min(best, taken.count() / calls);
    }
    return best;
}

template <class Library>
static void measure(const char* name, double i1, double i2, double i3, const double w[3], double span) {
    Top<Library> top(i1, i2, i3, w);
    top.prepare();
    const int calls = 1000;
    auto state = [&](const Top<Library>& body, int i) {
        double o[3], t = span * (i + 0.5) / calls;
        Quaternion q = body.state(t, o);
        return o[0] + o[1] + o[2] + q.w + q.x + q.y + q.z;
    };
    double prepared = nanoseconds(calls, [&](int i) { return state(top, i); });
    double scratch = nanoseconds(calls, [&](int i) {
        double start[3] = {w[0], w[1], w[2] * (1 + 1e-9 * i)};
        Top<Library> fresh(i1, i2, i3, start);
        fresh.prepare();
        return state(fresh, i);
    });
    std::printf("%-14s I = (%g, %g, %g), Omega = (%g, %g, %g): %6.0f ns prepared, %6.0f ns with preparation\n", name, i1, i2, i3,
                w[0], w[1], w[2], prepared, scratch);
}

int main() {
    gsl_set_error_handler_off();
    double ordinary[3] = {0.9 / 0.6, 0.5, 1.8}, racket[3] = {1e-3, 1.0, 1e-3};
    measure<Gsl>("GSL", 0.6, 0.8, 1.0, ordinary, 10);
    measure<BoostDouble>("Boost, double", 0.6, 0.8, 1.0, ordinary, 10);
    measure<Boost>("Boost.Math", 0.6, 0.8, 1.0, ordinary, 10);
    measure<Gsl>("GSL", 1.0, 2.0, 3.0, racket, 100);
    measure<BoostDouble>("Boost, double", 1.0, 2.0, 3.0, racket, 100);
    measure<Boost>("Boost.Math", 1.0, 2.0, 3.0, racket, 100);
}
