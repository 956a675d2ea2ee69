#!/usr/bin/env python3
"""Tables of what bench_error_vs_runtime measured, as Markdown on stdout.

    summary.py CSV
"""

import csv
import sys

from plot import OURS, PANELS, STYLES

WALLS = ["1", "10", "100", "1000", "10000", "100000", "1000000"]


def cells(row):
    return (
        f"{float(row['rms_p90_radii']):.1e} | {100 * float(row['wrong_contacts']):.0f} % | "
        f"{float(row['cpu_s_per_s_median']):.1e} | {row['runs']}"
    )


def step_of(row):
    step = float(row["step_s"])
    return f"1/{1 / step:.0f}" if step > 1.01e-6 else "1e-6"


def scene_table(rows, title):
    print(f"\n### {title}\n")
    print("| | step [s] | error [radii] | wrong contacts | CPU s/s | runs |")
    print("|---|---|---|---|---|---|")
    for name in OURS:
        for row in rows:
            if row["contender"] == "osculo " + name:
                print(f"| osculo {name} | none | {cells(row)} |")
    for name in STYLES:
        mine = [row for row in rows if row["contender"] == name]
        if not mine:
            continue
        usual = [row for row in mine if step_of(row) == "1/60"]
        best = min(mine, key=lambda row: float(row["rms_p90_radii"]))
        for row in usual:
            print(f"| {name} | 1/60 | {cells(row)} |")
        if best not in usual:
            print(f"| {name}, its best | {step_of(best)} | {cells(best)} |")


def wall_table(rows):
    print("\n### The thin wall: share of the runs in which the ball flew through, or never came back\n")
    print("| | step [s] | " + " | ".join(f"{float(v):g} m/s" for v in WALLS) + " |")
    print("|---|---|" + "---|" * len(WALLS))
    for name in ["osculo double"] + list(STYLES):
        for step in [0] if name.startswith("osculo") else [1 / 60, 1 / 960, 1e-6]:
            line = []
            for speed in WALLS:
                mine = [
                    row for row in rows
                    if row["scene"] == f"thin wall, {speed} m/s" and row["contender"] == name
                    and abs(float(row["step_s"]) - step) <= 1e-5 * step
                ]
                line.append(f"{100 * float(mine[0]['wrong_contacts']):.0f} %" if mine else "")
            words = "none" if step == 0 else f"1/{1 / step:.0f}" if step > 1.01e-6 else "1e-6"
            if any(line):
                print(f"| {name} | {words} | " + " | ".join(line) + " |")


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    print("# Errors and run times in numbers\n")
    print("Written by summary.py. Error: rms over the balls that 9 in 10 runs stay below. CPU s/s:")
    print("processor time per simulated second, median. Of steps, 1/60 s and the best one tried.")
    wall_table(rows)
    for scene, time, title in PANELS:
        scene_table(
            [row for row in rows if row["scene"] == scene and row["time_s"] == time],
            f"{title[0].upper()}{title[1:]} ({scene}, {time} s)",
        )


if __name__ == "__main__":
    main()
