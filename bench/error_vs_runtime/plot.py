#!/usr/bin/env python3
"""Pictures of what bench_error_vs_runtime measured.

    plot.py CSV DIRECTORY

errors.svg      error against processor time, one panel per scene
disks.svg       the same for 16 disks, as time goes by
contacts.svg    how often a contact is missed or comes in the wrong order, against the step
"""

import csv
import math
import os
import sys

from figure import Axis, Figure, marker

# Colours of Okabe and Ito: distinct for the colour-blind, and the marks differ as well.
STYLES = {
    "paper as printed": ("#999999", "up", True),
    "paper repaired": ("#E69F00", "up", False),
    "swept steps": ("#009E73", "diamond", False),
    "Box2D default": ("#56B4E9", "square", True),
    "Box2D tuned": ("#0072B2", "square", False),
    "Chipmunk default": ("#CC79A7", "down", True),
    "Chipmunk tuned": ("#D55E00", "down", False),
}
OURS = ["float", "double", "long double", "quad"]
HALO = 'stroke="white" stroke-width="3" paint-order="stroke"'
FLOOR = 1e-20  # what is more exact is drawn here, with its error beside it
PANELS = [
    ("thin wall, 100 m/s", "0.03", "a ball of 100 m/s and a thin wall"),
    ("graze", "1", "two balls that graze"),
    ("three bodies", "1", "three bodies: which comes first?"),
    ("cradle", "0.5", "cradle of five balls"),
    ("mass ratio 1e6", "1.5", "mass ratio 1e6, 3,141 contacts"),
    ("rim", "0.5", "a hole caught or missed"),
    ("16 disks", "0.5", "16 disks after 0.5 s"),
    ("break", "0.2", "break of 15 balls, 0.1 s after the hit"),
    ("1,000 disks", "0.03", "1,000 disks after 0.03 s"),
    ("cloth break", "0.5", "break on cloth after 0.5 s"),
]
WIDTH, LEFT, TOP = 800, 66, 92
PANEL_WIDTH, PANEL_HEIGHT, GAP_X, GAP_Y = 312, 200, 80, 72


def legend(figure, with_ours):
    x, y = LEFT, 22
    if with_ours:
        figure.add(marker("circle", x + 5, y - 4, "black"))
        figure.text(x + 14, y, "osculo: one point per number type (no time step)")
        x, y = LEFT, y + 18
    for name, (color, shape, dashed) in STYLES.items():
        figure.curve([(x, y - 4), (x + 26, y - 4)], color, dashed)
        figure.add(marker(shape, x + 13, y - 4, color, filled=not dashed))
        figure.text(x + 31, y, name)
        x += 31 + 6.2 * len(name) + 22
        if x > WIDTH - 150:
            x, y = LEFT, y + 18


def corner(k):
    return (
        LEFT + (k % 2) * (PANEL_WIDTH + GAP_X),
        TOP + (k // 2) * (PANEL_HEIGHT + GAP_Y),
    )


def figure_of(count, title):
    rows = (count + 1) // 2
    return Figure(WIDTH, TOP + rows * (PANEL_HEIGHT + GAP_Y) - 22, title)


def errors_panel(figure, k, rows, title):
    left, top = corner(k)
    if not rows:
        return
    times = [float(row["cpu_s_per_s_median"]) for row in rows]
    low = 10.0 ** math.floor(math.log10(min(times)))
    high = 10.0 ** math.ceil(math.log10(max(times)))
    x = Axis(low, high, left, left + PANEL_WIDTH)
    y = Axis(FLOOR, 1e4, top + PANEL_HEIGHT, top)
    figure.frame(
        x, y, title, "processor time per simulated second [s]", "rms error of 9 in 10 runs [radii]", 1, 4
    )
    for name, (color, shape, dashed) in STYLES.items():
        mine = sorted(
            (row for row in rows if row["contender"] == name), key=lambda row: -float(row["step_s"])
        )
        points = [
            (x.place(float(row["cpu_s_per_s_median"])), y.place(float(row["rms_p90_radii"])))
            for row in mine
        ]
        if points:
            figure.curve(points, color, dashed)
        for at in points:
            figure.add(marker(shape, *at, color, filled=not dashed))
    below = 0
    for name in OURS:
        for row in rows:
            if row["contender"] != "osculo " + name:
                continue
            error = float(row["rms_p90_radii"])
            at = x.place(float(row["cpu_s_per_s_median"]))
            figure.add(marker("circle", at, y.place(max(error, FLOOR)), "black", 4))
            words = name if error >= FLOOR else f"{name}: {error:.0e}" if error else f"{name}: 0"
            right = at > left + 0.7 * PANEL_WIDTH
            height = y.place(max(error, FLOOR)) - 4
            if error < FLOOR:
                height -= 12 * below
                below += 1
            figure.text(
                at + (-7 if right else 7), height, words, 10, "end" if right else "start", HALO
            )


def contacts_panel(figure, k, rows, title):
    left, top = corner(k)
    x = Axis(1e-6, 1e-1, left, left + PANEL_WIDTH)
    y = Axis(0, 1, top + PANEL_HEIGHT, top, log=False)
    figure.frame(x, y, title, "time step [s]", "runs with a wrong contact", 1, 0.25)
    for name, (color, shape, dashed) in STYLES.items():
        mine = sorted(
            (row for row in rows if row["contender"] == name), key=lambda row: float(row["step_s"])
        )
        points = [
            (x.place(float(row["step_s"])), y.place(float(row["wrong_contacts"]))) for row in mine
        ]
        if points:
            figure.curve(points, color, dashed)
        for at in points:
            figure.add(marker(shape, *at, color, filled=not dashed))
    ours = [row for row in rows if row["contender"] == "osculo double"]
    if ours:
        share = float(ours[0]["wrong_contacts"])
        figure.curve([(left, y.place(share)), (left + PANEL_WIDTH, y.place(share))], "black", False)
        figure.text(left + PANEL_WIDTH - 4, y.place(share) - 4, "osculo double", 10, "end")


def main():
    table, directory = sys.argv[1:3]
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))

    def of(scene, time):
        return [row for row in rows if row["scene"] == scene and row["time_s"] == time]

    figure = figure_of(len(PANELS), "Error against processor time")
    legend(figure, True)
    for k, (scene, time, title) in enumerate(PANELS):
        errors_panel(figure, k, of(scene, time), title)
    figure.write(os.path.join(directory, "errors.svg"))

    times = ["0.25", "0.5", "1", "2"]
    figure = figure_of(len(times), "16 disks: error against processor time")
    legend(figure, True)
    for k, time in enumerate(times):
        errors_panel(figure, k, of("16 disks", time), f"16 disks after {time} s")
    figure.write(os.path.join(directory, "disks.svg"))

    stepped = [panel for panel in PANELS if panel[0] != "cloth break"]
    figure = figure_of(len(stepped), "Runs with a missed or wrongly ordered contact")
    legend(figure, False)
    for k, (scene, time, title) in enumerate(stepped):
        contacts_panel(figure, k, of(scene, time), title)
    figure.write(os.path.join(directory, "contacts.svg"))


if __name__ == "__main__":
    main()
