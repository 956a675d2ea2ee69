#!/usr/bin/env bash
# Builds the programs, measures, checks the orders of magnitude and draws: everything that README.md
# in this directory shows, written to results/.
#
#     bench/error_vs_runtime/run.sh [--quick] [BUILD_DIRECTORY]      default: build/bench
#
# About ten minutes, half of it building; --quick: a minute of measuring, written to the build
# directory instead. Needs Google Benchmark; Box2D and Chipmunk take part if they are installed
# (.ci/setup --bench).
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
quick=()
if [ "${1:-}" = --quick ]; then
    quick=(--quick)
    shift
fi
root="$here/../.."
build="${1:-$root/build/bench}"

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DOSCULO_BUILD_BENCH=ON \
    -DOSCULO_BUILD_TESTS=OFF -DOSCULO_BUILD_CLI=OFF -DOSCULO_BUILD_IO=OFF
cmake --build "$build" --target bench_error_vs_runtime bench_precision_cost --parallel "$(nproc)"
programs="$build/bench/error_vs_runtime"

results="$here/results"
if [ ${#quick[@]} -gt 0 ]; then results="$build/error_vs_runtime"; fi
mkdir -p "$results"
"$programs/bench_error_vs_runtime" "${quick[@]}" "$results/points.csv"
"$programs/bench_precision_cost" "${quick[@]}" | tee "$results/precision.txt"
python3 "$here/plot.py" "$results/points.csv" "$results"
python3 "$here/summary.py" "$results/points.csv" >"$results/summary.md"
python3 "$here/check.py" "$results/points.csv"
