#!/bin/sh
# Builds the peers written in C into target/peers. Never part of the normal build.
# Debian, Ubuntu: apt-get install -y gcc libgsl-dev
set -eu
cd "$(dirname "$0")/../.."
mkdir -p target/peers
cc -std=c99 -O2 -o target/peers/elliptic_gsl lab/peers/elliptic_gsl.c -lgsl -lgslcblas -lm
