#!/usr/bin/env python3
"""The picture of how errors grow, from what bench_error_growth measured.

    plot.py CSV SVG
"""

import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "error_vs_runtime"))

from figure import Axis, Figure  # noqa: E402

# Colours of Okabe and Ito; told apart by their order from above as well.
COLORS = {"double": "#D55E00", "extended": "#E69F00", "quad": "#0072B2", "50": "#009E73"}
NAMES = {"extended": "long double", "50": "50 digits"}
SCENES = ["16 disks", "break without friction", "break on cloth", "one ball in a circle"]
LOWEST = 1e-32
LEFT, TOP, WIDTH, HEIGHT, GAP_X, GAP_Y = 66, 66, 312, 220, 80, 72


def panel(figure, k, title, rows):
    left = LEFT + (k % 2) * (WIDTH + GAP_X)
    top = TOP + (k // 2) * (HEIGHT + GAP_Y)
    most = max(int(row["event"]) for row in rows)
    last = 100 * -(-most // 100)
    x = Axis(0, last, left, left + WIDTH, log=False)
    y = Axis(LOWEST, 1e0, top + HEIGHT, top)
    every = 50 if last <= 200 else 100 if last <= 500 else 200
    figure.frame(x, y, title, "event", "error of the places [radii]", every, 4)
    for name, color in COLORS.items():
        points = [
            (x.place(int(row["event"])), y.place(float(row["error_radii"])))
            for row in rows if row["precision"] == name
        ]
        if points:
            figure.curve(points, color, False)


def main():
    table, path = sys.argv[1:3]
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    height = TOP + 2 * (HEIGHT + GAP_Y) - 22
    figure = Figure(LEFT + 2 * WIDTH + GAP_X + 30, height, "Growth of errors, event by event")
    x = LEFT
    for name, color in COLORS.items():
        figure.curve([(x, 18), (x + 26, 18)], color, False)
        figure.text(x + 31, 22, NAMES.get(name, name))
        x += 120
    figure.text(LEFT, 40, "medians of 20 variants, while half of them have every contact in its order", 10.5)
    for k, scene in enumerate(SCENES):
        mine = [row for row in rows if row["scene"] == scene]
        if mine:
            panel(figure, k, scene, mine)
    figure.write(path)


if __name__ == "__main__":
    main()
