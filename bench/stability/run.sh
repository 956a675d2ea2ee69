#!/usr/bin/env bash
# Builds the programs, runs the catalogue in every precision and draws: everything that README.md in
# this directory shows, written to results/.
#
#     bench/stability/run.sh [--quick] [--seed N] [--count M] [BUILD_DIRECTORY]
#                                                                  default: build/stability
# Some twenty minutes after building, which takes half as long; --quick: a minute, written to the build
# directory instead. Exits with 1 if anything is wrong.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
root="$here/../.."
mode=(--full)
growth=()
random=()
while [ $# -gt 0 ]; do
    case "$1" in
        --quick) mode=(--quick) growth=(--quick) ;;
        --seed | --count) random+=("$1" "$2") && shift ;;
        *) break ;;
    esac
    shift
done
build="${1:-$root/build/stability}"

cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DOSCULO_BUILD_BENCH=ON \
    -DOSCULO_BUILD_TESTS=OFF -DOSCULO_BUILD_CLI=OFF -DOSCULO_BUILD_IO=ON
cmake --build "$build" --target bench_stability bench_error_growth --parallel "$(nproc)"
programs="$build/bench/stability"

results="$here/results"
if [ "${mode[0]}" = --quick ]; then results="$build/stability-results"; fi
mkdir -p "$results"
"$programs/bench_error_growth" "${growth[@]}" "$results/growth.csv" | tee "$results/growth.txt"
python3 "$here/plot.py" "$results/growth.csv" "$results/growth.svg"
"$programs/bench_stability" "${mode[@]}" "${random[@]}" "$results/stability.csv" \
    "$results/stability.md" | tee "$results/summary.txt"
