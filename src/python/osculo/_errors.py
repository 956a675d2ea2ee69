"""What goes wrong, as exceptions."""

__all__ = ["FormatError", "SceneError"]


class SceneError(ValueError):
    """A scene that breaks a rule.

    `path` is the member that does, e.g. "balls[3].mass"; `rule` what it must be, e.g.
    "must be > 0"; `value` what it is, e.g. "-1", or "" where there is nothing to show.
    """

    def __init__(self, path: str, rule: str, value: str) -> None:
        super().__init__(path, rule, value)
        self.path = path
        self.rule = rule
        self.value = value

    def __str__(self) -> str:
        return f"{self.path}: {self.rule}" + (f", but it is {self.value}" if self.value else "")


class FormatError(ValueError):
    """Input that is not a file of osculo at all; for broken JSON with line and column."""
