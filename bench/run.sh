#!/usr/bin/env bash
# Builds the benchmarks and writes their figures to bench/results/.
#
#     bench/run.sh [BUILD_DIRECTORY]      default: build/bench; CXX and CXXFLAGS as for CMake
#
# Takes about twenty-five minutes. The accuracy programs fail if a target is missed.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
build="${1:-$here/../build/bench}"
results="$here/results"
mkdir -p "$results"

cmake -S "$here/.." -B "$build" -DCMAKE_BUILD_TYPE=Release -DOSCULO_BUILD_BENCH=ON \
    -DOSCULO_BUILD_TESTS=OFF -DOSCULO_BUILD_CLI=OFF -DOSCULO_BUILD_IO=OFF
cmake --build "$build" --target bench_programs --parallel "$(nproc)"
programs="$build/bench"

{
    grep -m1 'model name' /proc/cpuinfo | sed 's/.*: //'
    nproc | sed 's/$/ processors/'
    grep -E '^CMAKE_CXX_COMPILER:|^CMAKE_BUILD_TYPE:|^CMAKE_CXX_FLAGS(_RELEASE)?:' \
        "$build/CMakeCache.txt"
    "$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$build/CMakeCache.txt")" --version | head -1
} >"$results/machine.txt"

"$programs/bench_sizes" | tee "$results/sizes.txt"
"$programs/bench_shots" | tee "$results/shots.txt"
"$programs/bench_batch" | tee "$results/batch.txt"
"$programs/bench_micro" --benchmark_min_time=0.1 --benchmark_repetitions=5 \
    --benchmark_enable_random_interleaving=true --benchmark_report_aggregates_only=true \
    --benchmark_out="$build/micro.json" --benchmark_out_format=json >/dev/null
python3 "$here/medians.py" "$build/micro.json" | tee "$results/micro.txt"
"$programs/bench_long_runs" | tee "$results/long_runs.txt"
"$programs/bench_time_reversal" | tee "$results/time_reversal.txt"
if command -v valgrind >/dev/null; then
    "$here/instructions.sh" "$programs" | tee "$results/instructions.txt"
fi
"$programs/bench_first_contact_accuracy" 1000000 1000000 \
    "$results/first_contact_accuracy.csv" | tee "$results/first_contact_accuracy.txt"
"$programs/bench_parabolic_accuracy" 2050000 "$results/parabolic_accuracy.csv" |
    tee "$results/parabolic_accuracy.txt"
