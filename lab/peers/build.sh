#!/bin/sh
# Builds the peers written in C and C++ into target/peers. Never part of the normal build.
# Debian, Ubuntu: apt-get install -y g++ libgsl-dev libboost-math-dev
set -eu
cd "$(dirname "$0")/../.."
mkdir -p target/peers
cc -std=c99 -O2 -o target/peers/elliptic_gsl lab/peers/elliptic_gsl.c -lgsl -lgslcblas -lm
c++ -std=c++17 -O2 -o target/peers/elliptic_integrals lab/peers/elliptic_integrals.cpp -lgsl -lgslcblas -lm
