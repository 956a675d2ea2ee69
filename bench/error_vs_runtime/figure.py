"""Panels of curves as SVG, with nothing but the standard library."""

import math
from xml.sax.saxutils import escape

FONT = 'font-family="Helvetica, Arial, sans-serif"'


class Axis:
    """A range of numbers on a stretch of pixels."""

    def __init__(self, low, high, start, end, log=True):
        self.low, self.high, self.start, self.end, self.log = low, high, start, end, log

    def place(self, x):
        f = (lambda v: math.log10(v)) if self.log else (lambda v: v)
        x = min(max(x, self.low), self.high)
        part = (f(x) - f(self.low)) / (f(self.high) - f(self.low))
        return self.start + part * (self.end - self.start)

    def ticks(self, every):
        if not self.log:
            return [self.low + k * every for k in range(round((self.high - self.low) / every) + 1)]
        first, last = round(math.log10(self.low)), round(math.log10(self.high))
        return [10.0**k for k in range(first, last + 1) if k % every == 0]


def power(x):
    """10^k with a raised k."""
    k = round(math.log10(x))
    if k == 0:
        return "1"
    return f'10<tspan dy="-4" font-size="8">{str(k).replace("-", "&#8722;")}</tspan>'


def marker(shape, x, y, color, size=3.5, filled=True):
    fill = color if filled else "white"
    style = f'fill="{fill}" stroke="{color}" stroke-width="1.2"'
    if shape == "circle":
        return f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{size}" {style}/>'
    corners = {
        "square": [(-1, -1), (1, -1), (1, 1), (-1, 1)],
        "diamond": [(0, -1.3), (1.3, 0), (0, 1.3), (-1.3, 0)],
        "up": [(-1.1, 1), (1.1, 1), (0, -1.2)],
        "down": [(-1.1, -1), (1.1, -1), (0, 1.2)],
    }[shape]
    points = " ".join(f"{x + size * dx:.1f},{y + size * dy:.1f}" for dx, dy in corners)
    return f'<polygon points="{points}" {style}/>'


class Figure:
    def __init__(self, width, height, title):
        self.width, self.height = width, height
        self.parts = [
            f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" '
            f'width="{width}" height="{height}" {FONT}>',
            f"<title>{escape(title)}</title>",
            f'<rect width="{width}" height="{height}" fill="white"/>',
        ]

    def add(self, part):
        self.parts.append(part)

    def text(self, x, y, words, size=11, anchor="start", extra="", markup=False):
        words = words if markup else escape(words)
        self.add(
            f'<text x="{x:.1f}" y="{y:.1f}" font-size="{size}" text-anchor="{anchor}" {extra}>'
            f"{words}</text>"
        )

    def frame(self, x, y, title, x_label, y_label, x_every, y_every):
        """The axes of a panel: grid, ticks, labels."""
        left, right, top, bottom = x.start, x.end, y.end, y.start
        for value in x.ticks(x_every):
            at = x.place(value)
            self.add(f'<path d="M{at:.1f} {top}V{bottom}" stroke="#e6e6e6"/>')
            words = power(value) if x.log else f"{value:g}"
            self.text(at, bottom + 14, words, 10, "middle", markup=True)
        for value in y.ticks(y_every):
            at = y.place(value)
            self.add(f'<path d="M{left} {at:.1f}H{right}" stroke="#e6e6e6"/>')
            words = power(value) if y.log else f"{value:g}"
            self.text(left - 5, at + 4, words, 10, "end", markup=True)
        self.add(
            f'<rect x="{left}" y="{top}" width="{right - left}" height="{bottom - top}" '
            'fill="none" stroke="#444"/>'
        )
        self.text(left, top - 7, title, 12, extra='font-weight="bold"')
        self.text((left + right) / 2, bottom + 29, x_label, 10.5, "middle")
        at = f"{left - 44:.1f},{(top + bottom) / 2:.1f}"
        self.add(
            f'<text transform="translate({at}) rotate(-90)" font-size="10.5" '
            f'text-anchor="middle">{escape(y_label)}</text>'
        )

    def curve(self, points, color, dashed):
        path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
        dash = ' stroke-dasharray="5 3"' if dashed else ""
        self.add(f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="1.5"{dash}/>')

    def write(self, path):
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(self.parts + ["</svg>", ""]))
