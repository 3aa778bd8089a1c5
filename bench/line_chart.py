"""A line chart with logarithmic axes as plain SVG, the same bytes for the same numbers."""
import math

COLOURS = ["#1f5fae", "#c2410c", "#3f7d20", "#7c3aed"]
WIDTH, HEIGHT = 720, 440
LEFT, RIGHT, TOP, BOTTOM = 76, 24, 52, 60


def ticks(low, high):
    """The powers of ten in [low, high], and 2 and 5 times them where there are few."""
    decades = range(math.floor(math.log10(low)), math.ceil(math.log10(high)) + 1)
    for steps in ((1,), (1, 3), (1, 2, 5)):
        found = [s * 10.0 ** d for d in decades for s in steps if low * 0.999 <= s * 10.0 ** d <= high * 1.001]
        if len(found) >= 3:
            return found
    return found


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def widened(values):
    """The range of the values with some room."""
    return min(values) / 1.25, max(values) * 1.25


class LineChart:
    """title and axis labels; x_text and y_text write a tick's number."""

    def __init__(self, title, x_label, y_label, x_text, y_text):
        self.title, self.x_label, self.y_label = title, x_label, y_label
        self.x_text, self.y_text = x_text, y_text
        self.series = []

    def add(self, name, points):
        """A line through (x, y) points, all positive; empty lines are left out."""
        if points:
            self.series.append((name, sorted(points)))

    def svg(self):
        points = [p for _, series in self.series for p in series]
        (x0, x1), (y0, y1) = widened([p[0] for p in points]), widened([p[1] for p in points])

        def at(x, y):
            u = math.log(x / x0) / math.log(x1 / x0)
            v = math.log(y / y0) / math.log(y1 / y0)
            return LEFT + u * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - v * (HEIGHT - TOP - BOTTOM)

        out = [f'<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" '
               f'viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="13" role="img">',
               f"<title>{escaped(self.title)}</title>",
               f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#ffffff"/>',
               f'<text x="{LEFT}" y="22" font-size="16">{escaped(self.title)}</text>']
        out += self.axes(at, (x0, x1), (y0, y1))
        for i, (name, series) in enumerate(self.series):
            out += self.line(i, name, [at(*p) for p in series])
        return "\n".join(out) + "\n</svg>\n"

    def axes(self, at, xs, ys):
        bottom, right = HEIGHT - BOTTOM, WIDTH - RIGHT
        out = []
        for x in ticks(*xs):
            px = at(x, ys[0])[0]
            out.append(f'<path d="M{px:.1f} {TOP}V{bottom}" stroke="#e3e6ea"/>')
            out.append(f'<text x="{px:.1f}" y="{bottom + 20}" text-anchor="middle">{escaped(self.x_text(x))}</text>')
        for y in ticks(*ys):
            py = at(xs[0], y)[1]
            out.append(f'<path d="M{LEFT} {py:.1f}H{right}" stroke="#e3e6ea"/>')
            out.append(f'<text x="{LEFT - 8}" y="{py + 4:.1f}" text-anchor="end">{escaped(self.y_text(y))}</text>')
        out.append(f'<path d="M{LEFT} {TOP}V{bottom}H{right}" fill="none" stroke="#4b5057"/>')
        out.append(f'<text x="{(LEFT + right) / 2}" y="{HEIGHT - 14}" text-anchor="middle">'
                   f"{escaped(self.x_label)}</text>")
        out.append(f'<text x="{LEFT}" y="{TOP - 10}" fill="#4b5057">{escaped(self.y_label)}</text>')
        return out

    def line(self, index, name, pixels):
        colour = COLOURS[index % len(COLOURS)]
        path = "L".join(f"{x:.1f} {y:.1f}" for x, y in pixels)
        out = [f'<path d="M{path}" fill="none" stroke="{colour}" stroke-width="2"/>']
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3.5" fill="{colour}"/>' for x, y in pixels]
        # The key stands in the upper left corner, where growing lines leave room.
        y = TOP + 20 + 20 * index
        out.append(f'<rect x="{LEFT + 8}" y="{y - 14}" width="{24 + 7.4 * len(name):.0f}" height="20" '
                   f'fill="#ffffff" fill-opacity="0.85"/>')
        out.append(f'<path d="M{LEFT + 12} {y - 4}h16" stroke="{colour}" stroke-width="2"/>')
        out.append(f'<text x="{LEFT + 34}" y="{y}">{escaped(name)}</text>')
        return out
