"""Other threads run while osculo computes."""

import threading
import time

import numpy as np
import pytest

import osculo


def play_gas():
    osculo.simulate(osculo.preset("gas", balls=200).replace(limits={"time": 12}), record="none")


def play_batch():
    shots = np.tile([8.0, np.pi / 2, np.nan, 0, 0], (1500, 1))
    osculo.simulate_batch(osculo.preset("break"), shots, threads=1)


@pytest.mark.parametrize("work", [play_gas, play_batch])
def test_a_second_thread_runs_meanwhile(work):
    began, ended = [], []

    def play():
        began.append(time.monotonic())
        work()
        ended.append(time.monotonic())

    player = threading.Thread(target=play)
    player.start()
    seen = []
    while player.is_alive():
        seen.append(time.monotonic())
        time.sleep(0.001)
    player.join()
    took = ended[0] - began[0]
    assert took > 0.05, "too short to tell"
    # Held by the other thread, the lock would let this one in at the very start and end alone.
    middle = [t for t in seen if began[0] + 0.2 * took < t < ended[0] - 0.2 * took]
    assert len(middle) > 5, f"{len(middle)} times in {took:.3f} s"


def test_the_same_bits_from_any_thread():
    scene = osculo.preset("break")
    results = [None] * 4

    def play(index):
        results[index] = osculo.simulate(scene).to_json()

    threads = [threading.Thread(target=play, args=(i,)) for i in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert len(set(results)) == 1
