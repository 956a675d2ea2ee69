#!/usr/bin/env python3
"""A planner of pots: tries shots on the exact table before it plays one.

For a layout of eight-ball it makes candidates (every own ball into every pocket, directly, with
several speeds and a fan of directions around the ghost ball; and a sweep of all directions, which
finds banks, combinations and luck), plays each of them without noise, the better ones a few times
with it, and the best ones more often. The choice is then executed with noise that nobody has seen.

    potting_planner.py --layouts 500

compares it with aiming at random and with the ghost ball alone: pots per attempt with the noise of
the computational pool tournaments.
"""

import argparse
import math
import time

import numpy as np

import osculo
from osculo import eightball

SPEEDS = (1.5, 2.5, 4.0)  # of the cue [m/s]
FAN = np.radians([-1.2, -0.6, -0.3, 0.0, 0.3, 0.6, 1.2])  # around the ghost ball's direction
SWEEP = 360  # directions that are tried without any plan
# How many of the best are kept, and how often each of them is played with noise.
ROUNDS = ((160, 4), (40, 16), (10, 64))
PLANNING_SEEDS = 1_000_000  # of noise, from here on; below are those of the execution


def shots(azimuth, speed):
    """Level strikes in the middle of the ball, or as level as what is behind it lets them be."""
    azimuth, speed = np.broadcast_arrays(np.asarray(azimuth, float), np.asarray(speed, float))
    rows = np.zeros((azimuth.size, 5))
    rows[:, 0] = speed.ravel()
    rows[:, 1] = azimuth.ravel()
    rows[:, 2] = np.nan
    return rows


def blocked(start, end, others, reach):
    """Whether a ball that goes from start to end meets one of the others."""
    way = end - start
    length = np.hypot(*way)
    if length == 0 or len(others) == 0:
        return False
    along = np.clip((others - start) @ way / length**2, 0, 1)
    return bool((np.hypot(*(others - start - along[:, None] * way).T) < reach).any())


class Aim:
    """A direct pot: the cue ball goes to where it touches the ball opposite to the pocket."""

    def __init__(self, scene, ball, pocket):
        index = scene.ids.index(ball)
        cue = scene.positions[scene.ids.index("cue")]
        target = scene.positions[index]
        diameter = 2 * scene.radii[index]
        to_pocket = pocket - target
        distance = np.hypot(*to_pocket)
        ghost = target - to_pocket * (diameter / distance)
        to_ghost = ghost - cue
        reach = np.hypot(*to_ghost)
        is_other = [name not in ("cue", ball) for name in scene.ids]
        others = scene.positions[is_other]
        self.azimuth = math.atan2(to_ghost[1], to_ghost[0])
        self.cosine = float(to_ghost @ to_pocket / (reach * distance)) if reach > 0 else -1.0
        self.possible = self.cosine > 0.1
        self.clear = not blocked(cue, ghost, others, diameter) and not blocked(
            target, pocket, others, diameter
        )
        # An error of the cue's direction grows by the way to the ghost ball over the diameter and
        # the cosine of the cut, and then along the way to the pocket.
        self.difficulty = (
            reach * distance / (diameter * self.cosine) if self.possible else math.inf
        )


def aims(scene):
    pockets = [np.array(rim["center"]) for rim in scene.to_dict()["rims"]]
    every = [Aim(scene, ball, pocket) for ball in eightball.targets(scene) for pocket in pockets]
    return sorted((aim for aim in every if aim.possible), key=lambda aim: aim.difficulty)


class RandomAim:
    """Any direction, any speed."""

    name = "random aim"

    def decide(self, scene, seed):
        rng = np.random.default_rng((seed, 1))
        return shots(rng.uniform(-math.pi, math.pi), rng.uniform(SPEEDS[0], SPEEDS[-1]))[0], 0


class GhostBall:
    """The easiest pot by geometry, without a look at what would happen."""

    name = "ghost ball"

    def decide(self, scene, seed):
        every = aims(scene)
        best = next((aim for aim in every if aim.clear), every[0] if every else None)
        if best is None:
            return RandomAim().decide(scene, seed)
        return shots(best.azimuth, SPEEDS[1])[0], 0


class Planner:
    """The shot that is most often a legal pot when it is executed with noise."""

    name = "planner"

    def __init__(self, noise):
        self.noise = noise

    def candidates(self, scene):
        fans = [aim.azimuth + FAN for aim in aims(scene)]
        planned = np.concatenate(fans) if fans else np.empty(0)
        sweep = np.linspace(-math.pi, math.pi, SWEEP, endpoint=False)
        speeds = np.array(SPEEDS)[:, None]
        return np.concatenate([shots(planned[None, :], speeds), shots(sweep[None, :], speeds)])

    def decide(self, scene, seed):
        batch = osculo.Batch(scene)
        radius = float(scene.radii[0])
        chosen = self.candidates(scene)
        tried = len(chosen)
        score = eightball.judge(scene, batch.strike(chosen)).astype(float)
        for number, (kept, draws) in enumerate(ROUNDS):
            best = np.argsort(-score, kind="stable")[:kept]
            chosen = chosen[best]
            unseen = PLANNING_SEEDS + len(ROUNDS) * seed + number
            noisy = osculo.perturb(
                chosen, draws=draws, radius=radius, noise=self.noise, seed=unseen
            )
            made = eightball.judge(scene, batch.strike(noisy.reshape(-1, 5)))
            # What an earlier round has seen counts a little, to part those that are equal.
            score = made.reshape(len(chosen), draws).mean(axis=1) + 0.05 * score[best]
            tried += len(chosen) * draws
        return chosen[np.argmax(score)], tried


def executed(scene, shot, noise, attempts, seed):
    """Of so many attempts at the shot, how many are legal pots."""
    noisy = osculo.perturb(
        shot[None], draws=attempts, radius=float(scene.radii[0]), noise=noise, seed=seed
    )
    return float(eightball.judge(scene, osculo.simulate_batch(scene, noisy[0])).mean())


def compare(layouts, attempts, noise, balls, first_seed=0, progress=print):
    """A row for each player: name, pots per attempt and half its 95 % interval (over layouts),
    seconds and shots per decision."""
    players = (RandomAim(), GhostBall(), Planner(noise))
    rates = np.zeros((len(players), layouts))
    seconds = np.zeros(len(players))
    tried = np.zeros(len(players))
    for layout in range(layouts):
        seed = first_seed + layout
        scene = eightball.random_layout(seed, balls=balls)
        for i, player in enumerate(players):
            began = time.perf_counter()
            shot, count = player.decide(scene, seed)
            seconds[i] += time.perf_counter() - began
            tried[i] += count
            rates[i, layout] = executed(scene, shot, noise, attempts, seed)
        if progress and (layout + 1) % 50 == 0:
            progress(f"{layout + 1} layouts done")
    half = 1.96 * rates.std(axis=1, ddof=1) / math.sqrt(layouts)
    return [
        (player.name, rates[i].mean(), half[i], seconds[i] / layouts, tried[i] / layouts)
        for i, player in enumerate(players)
    ]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--layouts", type=int, default=500)
    parser.add_argument("--attempts", type=int, default=20, help="executions of each choice")
    parser.add_argument("--balls", type=int, default=15, help="object balls on the table")
    parser.add_argument("--noise", type=float, default=1.0, help="times that of the tournaments")
    parser.add_argument("--seed", type=int, default=0, help="of the first layout")
    arguments = parser.parse_args()
    rows = compare(
        arguments.layouts, arguments.attempts, arguments.noise, arguments.balls, arguments.seed
    )
    print(f"{'':12} pots per attempt      s per decision   shots per decision")
    for name, rate, half, seconds, tried in rows:
        print(f"{name:12} {rate:.3f} +- {half:.3f}        {seconds:10.4f}   {tried:12.0f}")


if __name__ == "__main__":
    main()
