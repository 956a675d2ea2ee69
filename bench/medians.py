#!/usr/bin/env python3
"""Medians of a Google Benchmark result file as two tables: predictions and engines."""

import json
import re
import sys


def medians(path):
    with open(path, encoding="utf-8") as file:
        for run in json.load(file)["benchmarks"]:
            if run.get("aggregate_name") == "median":
                yield run


def main():
    predictions = {}
    outcomes = []
    engines = []
    for run in medians(sys.argv[1]):
        name = run["run_name"]
        match = re.match(r"ball_(\w+)<(.*), Outcome::(\w+)>", name)
        if match:
            thing, scalar, outcome = match.groups()
            predictions.setdefault((thing, scalar), {})[outcome] = run["cpu_time"]
            if outcome not in outcomes:
                outcomes.append(outcome)
        else:
            engines.append((name.replace("/manual_time", ""), run))
    order = ["leaving", "beside", "near_miss", "later", "hit"]
    outcomes.sort(key=order.index)
    print("processor time per prediction [ns]")
    print(f"{'':26}" + "".join(f"{outcome:>10}" for outcome in outcomes))
    for (thing, scalar), times in sorted(predictions.items(), key=lambda item: item[1]["hit"]):
        row = "".join(f"{times[outcome]:10.0f}" for outcome in outcomes)
        print(f"ball-{thing:8} {scalar:12}{row}")
    print("\nengines: gas<scalar, broad phase>/disks/events, pi<scalar>/digits")
    print(f"{'':46}{'events/s':>12}{'ns/event':>10}{'predictions/event':>19}")
    for name, run in sorted(engines, key=lambda engine: engine[1]["events/s"]):
        rate = run["events/s"]
        print(f"{name:46}{rate:12.0f}{1e9 / rate:10.0f}{run['predictions/event']:19.2f}")


if __name__ == "__main__":
    main()
