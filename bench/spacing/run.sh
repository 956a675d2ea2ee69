#!/usr/bin/env bash
# Builds the program, plays every scene with every gap, and draws: everything that README.md in this
# directory shows, written to results/. Seconds, after building.
#
#     bench/spacing/run.sh [--orders N] [--seed N] [BUILD_DIRECTORY]      default: build/bench
#
# Exits with 1 if the symmetric law depends on the names of balls, or misses a closed form.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
root="$here/../.."
options=()
while [ $# -gt 1 ]; do
    case "$1" in
        --orders | --seed) options+=("$1" "$2") && shift 2 ;;
        *) break ;;
    esac
done
build="${1:-$root/build/bench}"

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DOSCULO_BUILD_BENCH=ON \
    -DOSCULO_BUILD_TESTS=OFF -DOSCULO_BUILD_CLI=OFF -DOSCULO_BUILD_IO=OFF
cmake --build "$build" --target bench_spacing --parallel "$(nproc)"

results="$here/results"
mkdir -p "$results"
"$build/bench/spacing/bench_spacing" "${options[@]}" "$results/spacing.csv" "$results/spacing.md"
python3 "$here/plot.py" "$results/spacing.csv" "$results/spacing.svg"
