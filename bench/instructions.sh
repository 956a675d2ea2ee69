#!/usr/bin/env bash
# Instructions per prediction and per event, counted by callgrind as the difference of two amounts
# of work (what it takes to start cancels).
#
#     bench/instructions.sh DIRECTORY_OF_bench_work
set -euo pipefail
work="$1/bench_work"
out="$(mktemp -d)"
trap 'rm -rf "$out"' EXIT

# count KIND AMOUNT [DISKS]: instructions of the whole program.
count() {
    valgrind --tool=callgrind --callgrind-out-file="$out/callgrind" "$work" "$@" 2>&1 >"$out/answer" |
        awk '/Collected/ { print $NF }'
}
# per KIND LESS MORE [DISKS]: instructions per unit of work.
per() {
    local kind="$1" less="$2" more="$3"
    shift 3
    local low high
    low="$(count "$kind" "$less" "$@")"
    high="$(count "$kind" "$more" "$@")"
    printf '%-16s %-8s %8d\n' "$kind" "${1:-}" $(((high - low) / (more - less)))
}

echo "instructions per prediction of a ball-ball contact"
for kind in hit near-miss beside later leaving; do per "$kind" 20480 40960; done
echo "instructions per event, by number of disks"
per gas-all-pairs 5000 15000 16
per gas-all-pairs 500 1500 1000
per gas-cell-grid 5000 15000 16
per gas-cell-grid 5000 15000 1000
per gas-cell-grid 5000 15000 100000
