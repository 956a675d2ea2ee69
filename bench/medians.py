#!/usr/bin/env python3
"""Medians of a Google Benchmark result file as tables: predictions, impacts, queues, engines."""

import json
import re
import sys


def medians(path):
    with open(path, encoding="utf-8") as file:
        for run in json.load(file)["benchmarks"]:
            if run.get("aggregate_name") == "median":
                yield run


def table(title, cells, columns, unit_width=10):
    """Rows and columns in the order in which they come."""
    print(f"\n{title}")
    print(f"{'':26}" + "".join(f"{column:>{unit_width}}" for column in columns))
    for row, values in cells.items():
        words = (f"{values[c]:.1f}" if c in values else "" for c in columns)
        print(f"{row:26}" + "".join(f"{word:>{unit_width}}" for word in words))


def main():
    predictions = {}
    groups = {}
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
        elif name.split("/")[0] in ("parabolic", "impact", "queue"):
            group, row, *column = name.split("/")
            cells = groups.setdefault(group, {}).setdefault(row, {})
            cells[column[0] if column else "ns"] = run["cpu_time"]
        else:
            engines.append((name.replace("/manual_time", ""), run))
    order = ["leaving", "beside", "near_miss", "later", "hit"]
    outcomes.sort(key=order.index)
    print("processor time per prediction [ns]")
    print(f"{'':26}" + "".join(f"{outcome:>10}" for outcome in outcomes))
    for (thing, scalar), times in sorted(predictions.items(), key=lambda item: item[1]["hit"]):
        row = "".join(f"{times[outcome]:10.0f}" for outcome in outcomes)
        print(f"ball-{thing:8} {scalar:12}{row}")
    titles = {
        "parabolic": "processor time per prediction on curved paths, double [ns]",
        "impact": "processor time per impact, double [ns]",
        "queue": "processor time of the event list per event, by number of balls [ns]",
    }
    for group, cells in groups.items():
        columns = {column for values in cells.values() for column in values}
        numbers = all(column.isdigit() for column in columns)
        columns = sorted(columns, key=int if numbers else None)
        # Repetitions may come in any order: the quickest first, as in the other tables.
        quickest = sorted(cells.items(), key=lambda item: max(item[1].values()))
        table(titles[group], dict(quickest), columns)
    print("\nengines: gas<scalar, broad phase>/disks/events, pi<scalar>/digits")
    print(f"{'':46}{'events/s':>12}{'ns/event':>10}{'predictions/event':>19}")
    for name, run in sorted(engines, key=lambda engine: engine[1]["events/s"]):
        rate = run["events/s"]
        print(f"{name:46}{rate:12.0f}{1e9 / rate:10.0f}{run['predictions/event']:19.2f}")


if __name__ == "__main__":
    main()
