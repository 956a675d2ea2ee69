#!/usr/bin/env python3
"""Whether the orders of magnitude still hold, of errors and of ratios of times, never of times.

    check.py CSV        says what does not hold and exits with 1
"""

import csv
import sys

STEPPERS = ["paper as printed", "paper repaired", "Box2D default", "Box2D tuned",
            "Chipmunk default", "Chipmunk tuned"]
# Scenes without much chaos until then: osculo is exact but for rounding, steps are not.
SCENES = [("thin wall, 1 m/s", "3"), ("thin wall, 100 m/s", "0.03"),
          ("thin wall, 1000000 m/s", "3e-06"), ("graze", "1"), ("three bodies", "1"),
          ("cradle", "0.5"), ("mass ratio 1e6", "1.5"), ("rim", "0.5"), ("16 disks", "0.25"),
          ("16 disks", "0.5"), ("break", "0.11"), ("break", "0.2"), ("1,000 disks", "0.03")]
EXACT_SCENES = SCENES + [("cloth break", "0.2"), ("cloth break", "0.5")]


class Checks:
    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self.rows = list(csv.DictReader(file))
        self.failed = 0
        self.made = 0

    def of(self, scene, time, contender):
        return [
            row for row in self.rows
            if (row["scene"], row["time_s"], row["contender"]) == (scene, time, contender)
        ]

    def expect(self, holds, words):
        self.made += 1
        if not holds:
            self.failed += 1
            print("does not hold:", words)


def number(row, column):
    return float(row[column])


def main():
    checks = Checks(sys.argv[1])
    for scene, time in EXACT_SCENES:
        where = f"{scene} at {time} s: "
        ours = {}
        for name in ["float", "double", "long double", "quad"]:
            rows = checks.of(scene, time, "osculo " + name)
            checks.expect(len(rows) == 1, where + name + " took part")
            if rows:
                ours[name] = rows[0]
        if len(ours) < 4:
            continue
        double = ours["double"]
        checks.expect(number(double, "rms_worst_radii") < 1e-9, where + "double is below 1e-9 radii")
        for name, factor in [("float", 1e3), ("long double", 1e-2), ("quad", 1e-12)]:
            least = number(double, "rms_worst_radii") * factor
            error = number(ours[name], "rms_worst_radii")
            holds = error > least if factor > 1 else error <= least
            checks.expect(holds, where + name + " differs from double as its digits do")
        for name in ["double", "long double", "quad"]:
            checks.expect(
                number(ours[name], "wrong_contacts") == 0 and number(ours[name], "gave_up") == 0,
                where + name + " has every contact in its order",
            )
    for scene, time in SCENES:
        where = f"{scene} at {time} s: "
        double = checks.of(scene, time, "osculo double")
        steppers = [row for name in STEPPERS for row in checks.of(scene, time, name)]
        checks.expect(bool(steppers), where + "a stepper took part")
        if not steppers or not double:
            continue
        best = min(number(row, "rms_p90_radii") for row in steppers)
        checks.expect(best > 1e-7, where + f"the best stepper is above 1e-7 radii ({best:g})")
        swept = [number(row, "rms_p90_radii") for row in checks.of(scene, time, "swept steps")]
        checks.expect(bool(swept) and min(swept) < 1e-8, where + "swept steps are below 1e-8 radii")
    for scene, time in [("16 disks", "0.5"), ("break", "0.2")]:
        double = checks.of(scene, time, "osculo double")
        good = [
            number(row, "cpu_s_per_s_median")
            for name in STEPPERS for row in checks.of(scene, time, name)
            if number(row, "rms_p90_radii") < 1e-2
        ]
        if double and good:
            ratio = min(good) / number(double[0], "cpu_s_per_s_median")
            checks.expect(
                ratio > 10,
                f"{scene}: 1e-2 radii by steps costs 10 times what 1e-9 costs without ({ratio:.3g})",
            )
    print(f"{checks.made - checks.failed} of {checks.made} orders of magnitude hold")
    return 1 if checks.failed else 0


if __name__ == "__main__":
    sys.exit(main())
