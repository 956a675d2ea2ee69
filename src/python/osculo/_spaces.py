"""What is used of Gymnasium, for those who do not have it."""

from typing import Any, Optional

import numpy

__all__ = ["Box", "Env"]


class Env:
    """Something with reset() and step(), and random numbers of its own."""

    _np_random: Optional[numpy.random.Generator] = None

    @property
    def np_random(self) -> numpy.random.Generator:
        """The same numbers as Gymnasium's for the same seed."""
        if self._np_random is None:
            self._np_random = numpy.random.default_rng()
        return self._np_random

    def reset(self, *, seed: Optional[int] = None, options: Optional[dict[str, Any]] = None) -> Any:
        """Begins the random numbers anew, with a seed."""
        if seed is not None:
            self._np_random = numpy.random.default_rng(seed)


class Box:
    """Arrays within bounds; the part of gymnasium.spaces.Box that is bounded on all sides."""

    def __init__(
        self,
        low: Any,
        high: Any,
        shape: Optional[tuple[int, ...]] = None,
        dtype: Any = numpy.float32,
    ) -> None:
        self.dtype = numpy.dtype(dtype)
        self.shape = numpy.shape(low) if shape is None else shape
        self.low = numpy.broadcast_to(low, self.shape).astype(self.dtype)
        self.high = numpy.broadcast_to(high, self.shape).astype(self.dtype)
        self._rng = numpy.random.default_rng()

    def seed(self, seed: Optional[int] = None) -> None:
        """Of sample()."""
        self._rng = numpy.random.default_rng(seed)

    def sample(self) -> "numpy.ndarray[Any, Any]":
        """An array within the bounds, uniformly at random."""
        drawn = self._rng.uniform(self.low, self.high, self.shape).astype(self.dtype)
        within: "numpy.ndarray[Any, Any]" = numpy.clip(drawn, self.low, self.high)
        return within

    def contains(self, x: Any) -> bool:
        """Whether x is an array of that shape and type within the bounds."""
        return (
            isinstance(x, numpy.ndarray)
            and numpy.can_cast(x.dtype, self.dtype)
            and x.shape == self.shape
            and bool(numpy.all((self.low <= x) & (x <= self.high)))
        )

    def __contains__(self, x: Any) -> bool:
        return self.contains(x)
