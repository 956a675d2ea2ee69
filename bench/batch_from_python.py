#!/usr/bin/env python3
"""Batches through Python next to the same from C++ (batch.cpp): processor time per shot.

    batch_from_python.py [BENCH_BATCH]

plays, on one thread, strikes of 6 to 10 m/s into a rack of eight-ball and starts with 15 balls
anywhere, drawn as batch.cpp draws them, and in turns with it the program BENCH_BATCH, if given.
"""

import re
import subprocess
import sys
import time

import numpy as np

import osculo

SHOTS = 4000
TURNS = 3
REPETITIONS = 5
RADIUS = 0.028575  # [m]
WIDTH, LENGTH = 1.27, 2.54  # of the bed [m]


def breaks(rng):
    shots = np.full((SHOTS, 5), np.nan)
    shots[:, 0] = rng.uniform(6, 10, SHOTS)
    shots[:, 1] = np.pi / 2 + 0.01 * rng.uniform(-0.5, 0.5, SHOTS)
    shots[:, 3:] = 0.2 * rng.uniform(-0.5, 0.5, (SHOTS, 2))
    return shots


def places(rng, radius):
    """Centres of 15 disks in the unit square, each anywhere in its cell of a grid."""
    cells = np.stack(np.divmod(np.arange(15), 4)[::-1], axis=1)
    return (cells + 0.5) / 4 + rng.uniform(-0.5, 0.5, (15, 2)) * 0.999 * (0.25 - 2 * radius)


def mid_games(rng, scene):
    starts = np.zeros((SHOTS, len(scene), 7))
    present = np.ones((SHOTS, len(scene)), bool)
    present[:, scene.ids.index("8")] = False
    room = np.array([WIDTH, LENGTH]) - 2.2 * RADIUS
    for shot in range(SHOTS):
        starts[shot, present[shot], :2] = 1.1 * RADIUS + places(rng, RADIUS / room[0]) * room
    angle = rng.uniform(-np.pi, np.pi, SHOTS)
    speed = rng.uniform(1, 6, SHOTS)
    cue = scene.ids.index("cue")
    starts[:, cue, 2] = speed * np.cos(angle)
    starts[:, cue, 3] = speed * np.sin(angle)
    return starts, present


def best_time(play):
    play()
    times = []
    for _ in range(REPETITIONS):
        began = time.process_time()
        result = play()
        times.append(time.process_time() - began)
    return 1e6 * min(times) / SHOTS, result["event_count"].mean()


def from_cpp(program):
    text = subprocess.run([program], check=True, capture_output=True, text=True).stdout
    pattern = r"^(\S+) +1 threads.* ([0-9.]+) us/shot +([0-9.]+) events/shot"
    return {kind: (float(us), float(events)) for kind, us, events in re.findall(pattern, text, re.M)}


def main():
    rng = np.random.default_rng(1)
    scene = osculo.Scene(table="pool-9ft", rack="eight-ball")
    batch = osculo.Batch(scene, threads=1)
    strikes = breaks(rng)
    starts, present = mid_games(rng, scene)
    kinds = {
        "break": lambda: batch.strike(strikes),
        "balls-15": lambda: batch.release(starts, present),
    }
    best = {}
    for _ in range(TURNS):
        rows = {("Python", kind): best_time(play) for kind, play in kinds.items()}
        if len(sys.argv) > 1:
            rows.update({("C++", kind): row for kind, row in from_cpp(sys.argv[1]).items()})
        for key, row in rows.items():
            best[key] = min(best.get(key, row), row)
    for (language, kind), (us, events) in sorted(best.items(), key=lambda item: item[0][::-1]):
        print(
            f"{kind:8} {language:6} {us:6.1f} us/shot {1e6 / us:8.0f} shots/s and core "
            f"{events:5.1f} events/shot {us / events:6.3f} us/event"
        )
    began = time.perf_counter()
    for _ in range(1000):
        batch.strike(np.empty((0, 5)))
    print(f"a batch of no shots: {1e3 * (time.perf_counter() - began):.0f} us")


if __name__ == "__main__":
    main()
