#!/usr/bin/env python3
"""Two result files of Google Benchmark, side by side: medians, spreads, and what has changed.

    compare.py BEFORE.json AFTER.json [PART OF NAME]

Spread: half the range of the middle half of the repetitions, in percent of the median (with
aggregates only: the coefficient of variation). A change within both spreads is marked "~".
"""

import json
import statistics
import sys


def spread_of(times):
    if len(times) < 2:
        return 0.0
    low, _, high = statistics.quantiles(times, n=4, method="inclusive")
    return 50 * (high - low) / statistics.median(times)


def read(path):
    """{name: (median processor time, unit, spread in percent)}"""
    times, units, medians, variations = {}, {}, {}, {}
    with open(path, encoding="utf-8") as file:
        for run in json.load(file)["benchmarks"]:
            name = run.get("run_name", run["name"])
            units[name] = run["time_unit"]
            kind = run.get("aggregate_name")
            if kind is None:
                times.setdefault(name, []).append(run["cpu_time"])
            elif kind == "median":
                medians[name] = run["cpu_time"]
            elif kind == "cv":
                variations[name] = 100 * run["cpu_time"]
    results = {}
    for name in units:
        if name in times:
            results[name] = (statistics.median(times[name]), units[name], spread_of(times[name]))
        elif name in medians:
            results[name] = (medians[name], units[name], variations.get(name, 0.0))
    return results


def main():
    if len(sys.argv) < 3:
        print(__doc__, file=sys.stderr)
        return 2
    before, after = read(sys.argv[1]), read(sys.argv[2])
    part = sys.argv[3] if len(sys.argv) > 3 else ""
    names = [name for name in before if part in name]
    width = max([len(name) for name in names] + [10])
    print(f"{'':{width}} {'before':>12} {'':5} {'after':>12} {'':5}      change")
    for name in names:
        if name not in after:
            print(f"{name:{width}}  only before")
            continue
        (old, unit, old_spread), (new, new_unit, new_spread) = before[name], after[name]
        scale = {"ns": 1, "us": 1e3, "ms": 1e6, "s": 1e9}
        change = 100 * (new * scale[new_unit] / (old * scale[unit]) - 1)
        mark = "~" if abs(change) <= old_spread + new_spread else " "
        print(
            f"{name:{width}} {old:9.2f} {unit:2} {old_spread:4.1f}% {new:9.2f} {new_unit:2} "
            f"{new_spread:4.1f}% {mark} {change:+7.1f} %"
        )
    for name in after:
        if part in name and name not in before:
            print(f"{name:{width}}  only after")
    return 0


if __name__ == "__main__":
    sys.exit(main())
