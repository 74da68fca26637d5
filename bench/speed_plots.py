"""The plots of speed.py, written as SVG: points joined by a line, on axes from 0 or with powers of two."""
import math
import os

WIDTH, HEIGHT, LEFT, TOP, RIGHT, BOTTOM = 760, 480, 80, 60, 680, 420
TEXT = '<text x="{0:.1f}" y="{1:.1f}" text-anchor="{2}">{3}</text>'
LINE = '<path d="M{0:.1f} {1:.1f}L{2:.1f} {3:.1f}" stroke="#ddd"/>'


def ticks_of(values, logarithmic):
    """Round numbers from below the smallest of the values, or 0, to above the largest."""
    if logarithmic:
        return [2.0**n for n in range(math.floor(math.log2(min(values))), math.ceil(math.log2(max(values))) + 1)]
    step = 10 ** math.floor(math.log10(max(values) or 1))
    step *= next(factor for factor in (0.2, 0.5, 1, 2) if 6 * factor * step >= max(values))
    return [step * n for n in range(math.ceil(max(values) / step) + 1)]


def place(value, ticks, low, high, logarithmic):
    first, last, at = (math.log(number) if logarithmic else number for number in (ticks[0], ticks[-1], value))
    return low + (at - first) / (last - first) * (high - low)


def panel(rows, names, left=0, logarithmic=False):
    """The SVG of one panel. A row has its place across, its place up and, if any, its label."""
    xs, ys = (ticks_of([row[i] for row in rows], logarithmic) for i in (0, 1))
    at = [(left + place(row[0], xs, LEFT, RIGHT, logarithmic), place(row[1], ys, BOTTOM, TOP, logarithmic))
          for row in rows]
    parts = [TEXT.format(left + LEFT, TOP - 20, "start", "↑ " + names[1]),
             TEXT.format(left + RIGHT, BOTTOM + 45, "end", names[0] + " →")]
    for tick in xs:
        x = left + place(tick, xs, LEFT, RIGHT, logarithmic)
        parts += [LINE.format(x, TOP, x, BOTTOM), TEXT.format(x, BOTTOM + 20, "middle", f"{tick:g}")]
    for tick in ys:
        y = place(tick, ys, BOTTOM, TOP, logarithmic)
        parts += [LINE.format(left + LEFT, y, left + RIGHT, y), TEXT.format(left + LEFT - 8, y + 5, "end", f"{tick:g}")]
    line = " ".join(f"{x:.1f},{y:.1f}" for x, y in at)
    parts.append(f'<polyline points="{line}" fill="none" stroke="#0072b2" stroke-width="2"/>')
    parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="#0072b2"/>' for x, y in at]
    parts += [TEXT.format(x + 8, y - 8, "start", row[2]) for row, (x, y) in zip(rows, at) if len(row) > 2]
    return "\n".join(parts)


def write(path, panels):
    width = WIDTH * len(panels)
    with open(path, "w", encoding="utf-8") as file:
        file.write(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {HEIGHT}" font-family="sans-serif" '
                   f'font-size="14">\n<rect width="{width}" height="{HEIGHT}" fill="#fff"/>\n'
                   + "\n".join(panels) + "\n</svg>\n")
    return path


def draw(sizes, counts, folder):
    """Returns the files, made in `folder`: speed by size, and time and memory by the length of the clip."""
    os.makedirs(folder, exist_ok=True)
    frames = "frames of 1280x720"
    return [write(os.path.join(folder, "resolution.svg"),
                  [panel([(pixels, speed, name) for name, pixels, speed in sizes],
                         ("pixels of a picture  [millions]", "frames a second"), logarithmic=True)]),
            write(os.path.join(folder, "frames.svg"),
                  [panel([row[:2] for row in counts], (frames, "time  [s]")),
                   panel([row[::2] for row in counts], (frames, "peak memory  [MB]"), WIDTH)])]
