#!/usr/bin/env python3
"""The picture of what comes out as gaps go to zero, from what bench_spacing found.

    plot.py CSV SVG
"""

import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "error_vs_runtime"))

from figure import Axis, Figure  # noqa: E402

# Colours of Okabe and Ito.
LAWS = {"sequential": "#D55E00", "symmetric": "#0072B2"}
NONE, LOWEST = 1e-17, 1e-17  # where the gap 0, and differences below all rounding, are drawn
LEFT, TOP, WIDTH, HEIGHT, GAP_X, GAP_Y = 66, 84, 312, 180, 80, 72


def panel(figure, k, title, rows):
    left = LEFT + (k % 2) * (WIDTH + GAP_X)
    top = TOP + (k // 2) * (HEIGHT + GAP_Y)
    x = Axis(NONE, 1e-2, left, left + WIDTH)
    y = Axis(LOWEST, 1e1, top + HEIGHT, top)
    figure.frame(x, y, title, "gap between neighbours [radii]", "difference of velocities", 3, 4)
    figure.text(left, top + HEIGHT + 14, "0", 10, "middle")
    for law, color in LAWS.items():
        mine = [row for row in rows if row["simultaneous"] == law]
        for what, dashed in (("furthest", False), ("spread", True)):
            points = [
                (x.place(max(float(row["gap_radii"]), NONE)), y.place(max(float(row[what]), LOWEST)))
                for row in mine
            ]
            # The gap 0 stands alone: it is not the limit.
            figure.curve(points[1:], color, dashed)
            at_x, at_y = points[0]
            fill = "white" if dashed else color
            figure.add(
                f'<circle cx="{at_x:.1f}" cy="{at_y:.1f}" r="3" fill="{fill}" stroke="{color}"/>'
            )


def legend(figure):
    y = 18
    for law, color in LAWS.items():
        x = LEFT
        for words, dashed in (
            (f"{law}: from the symmetric outcome without gaps", False),
            (f"{law}: between two orders of the names", True),
        ):
            figure.curve([(x, y), (x + 26, y)], color, dashed)
            figure.text(x + 31, y + 4, words)
            x += 370
        y += 18
    figure.text(LEFT, y + 4, "largest of any ball, over the speed of the one that comes; "
                "dots: without gaps, full and open as the lines are solid and dashed", 10.5)


def main():
    table, path = sys.argv[1:3]
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    height = TOP + (len(scenes) + 1) // 2 * (HEIGHT + GAP_Y) - 22
    figure = Figure(LEFT + 2 * WIDTH + GAP_X + 30, height, "What comes out as gaps go to zero")
    legend(figure)
    for k, scene in enumerate(scenes):
        panel(figure, k, scene, [row for row in rows if row["scene"] == scene])
    figure.write(path)


if __name__ == "__main__":
    main()
