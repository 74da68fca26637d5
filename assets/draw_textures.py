#!/usr/bin/env python3
"""Draws the book's textures: writes each SVG next to this script, then its PNG.

Usage: draw_textures.py [--svg-only]

Needs rsvg-convert, optipng and the EB Garamond fonts.  Nothing here is random:
the same packages give the same files.
"""

import math
import os
import shutil
import struct
import subprocess
import sys
import tempfile
import zlib

HERE = os.path.dirname(os.path.abspath(__file__))

# The cover is 187.8 mm x 290.85 mm, the spine 50 mm x 290.85 mm.
COVER_W, SPINE_W, HEIGHT = 1024, 272, 1586
PX_PER_MM = HEIGHT / 290.85
JOINT = 7.6 * PX_PER_MM          # the groove's centre, as in book_profile.cpp
BOARD = 9.6 * PX_PER_MM          # where the flat of the board begins

CLOTH = (0x82, 0x17, 0x20)
LEATHER = (0x4a, 0x0c, 0x13)
GOLD = "#dcb25c"
PAPER = "#eee4cc"
INK = "#6d121a"
FONT = "'EB Garamond 12'"


# ---------------------------------------------------------------- measuring

def _png_rows(data):
    """The rows of an 8-bit RGBA PNG, unfiltered."""
    width = height = 0
    packed = b""
    at = 8
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, depth, colour = struct.unpack(">IIBB", body[:10])
            assert (depth, colour) == (8, 6)
        elif kind == b"IDAT":
            packed += body
        at += size + 12
    raw = zlib.decompress(packed)
    stride = width * 4
    previous = bytearray(stride)
    rows = []
    for y in range(height):
        mode = raw[y * (stride + 1)]
        row = bytearray(raw[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            a = row[i - 4] if i >= 4 else 0
            b = previous[i]
            if mode == 1:
                row[i] = (row[i] + a) & 255
            elif mode == 2:
                row[i] = (row[i] + b) & 255
            elif mode == 3:
                row[i] = (row[i] + (a + b) // 2) & 255
            elif mode == 4:
                c = previous[i - 4] if i >= 4 else 0
                p = a + b - c
                pa, pb, pc = abs(p - a), abs(p - b), abs(p - c)
                near = a if pa <= pb and pa <= pc else b if pb <= pc else c
                row[i] = (row[i] + near) & 255
        rows.append(row)
        previous = row
    return rows


_ink_cache = {}


def ink(text, size, style="", spacing=0.0):
    """Left and right ends of the text's ink, in pixels from its origin."""
    key = (text, size, style, spacing)
    if key not in _ink_cache:
        # Drawn 40 px high whatever the size, so that it is quick.
        scale = 40.0 / size
        width = int(len(text) * (size + abs(spacing)) * scale * 1.2) + 60
        svg = (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" '
               f'height="64"><g transform="translate(20,44) scale({scale})">'
               f'<text font-family="{FONT}" font-size="{size}" {style} '
               f'letter-spacing="{spacing}">{text}</text></g></svg>')
        png = subprocess.run(["rsvg-convert"], input=svg.encode(),
                             stdout=subprocess.PIPE, check=True).stdout
        left, right = None, None
        columns = [0] * width
        for row in _png_rows(png):
            for x, alpha in enumerate(row[3::4]):
                if alpha > columns[x]:
                    columns[x] = alpha
        inked = [x for x, alpha in enumerate(columns) if alpha > 8]
        first, last = inked[0], inked[-1]
        left = first + 1 - columns[first] / 255.0
        right = last + columns[last] / 255.0
        _ink_cache[key] = ((left - 20) / scale, (right - 20) / scale)
    return _ink_cache[key]


# ------------------------------------------------------------------ drawing

def n(value):
    text = f"{value:.2f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def rgb(colour):
    return "#%02x%02x%02x" % colour


def text_centred(text, x, y, size, style="", spacing=0.0, squeeze=1.0):
    """Text whose ink, not whose advance, is centred on x."""
    left, right = ink(text, size, style, spacing)
    start = x - squeeze * (left + right) / 2
    return (f'<text transform="translate({n(start)},{n(y)}) '
            f'scale({squeeze:.4f},1)" font-size="{n(size)}" '
            f'letter-spacing="{n(spacing)}" {style}>{text}</text>')


def spacing_for(text, size, width, style=""):
    """The letter spacing that makes the ink of the text that wide."""
    left, right = ink(text, size, style)
    return (width - (right - left)) / (len(text) - 1)


def broken(text, width, size):
    """The text in lines, broken where the gaps come out most even."""
    words = text.split()
    spans = [right - left for left, right in (ink(w, size) for w in words)]
    ideal = 0.27 * size
    best = [(0.0, 0)] + [(1e18, 0)] * len(words)
    for end in range(1, len(words) + 1):
        for start in range(end - 1, -1, -1):
            room = width - sum(spans[start:end])
            count = end - start - 1
            if room < 0.17 * size * count:
                break
            if end == len(words):
                cost = 0.0 if room < 0.7 * width else 4.0
            else:
                gap = room / count if count else 9 * ideal
                cost = abs(gap / ideal - 1) ** 3
            if best[start][0] + cost < best[end][0]:
                best[end] = (best[start][0] + cost, start)
    lines, end = [], len(words)
    while end:
        start = best[end][1]
        lines.insert(0, " ".join(words[start:end]))
        end = start
    return lines


def justified(text, x, y, width, size, leading):
    """A paragraph set flush on both sides, but for its last line."""
    lines = broken(text, width, size)
    out = []
    for i, line in enumerate(lines):
        words = line.split()
        spans = [ink(word, size) for word in words]
        room = width - sum(right - left for left, right in spans)
        gap = room / max(1, len(words) - 1)
        if i == len(lines) - 1:
            gap = 0.27 * size
        at = x
        for word, (left, right) in zip(words, spans):
            out.append(f'<text x="{n(at - left)}" y="{n(y + i * leading)}" '
                       f'font-size="{n(size)}">{word}</text>')
            at += right - left + gap
    return "\n".join(out)


def rule(x0, y0, x1, y1, width):
    return (f'<path d="M{n(x0)} {n(y0)}L{n(x1)} {n(y1)}" '
            f'stroke-width="{n(width)}"/>')


def box(x0, y0, x1, y1, width):
    return (f'<rect x="{n(x0)}" y="{n(y0)}" width="{n(x1 - x0)}" '
            f'height="{n(y1 - y0)}" stroke-width="{n(width)}"/>')


def scooped_box(x0, y0, x1, y1, radius, width):
    """A box with quarter circles scooped out of its corners."""
    r = n(radius)
    return (f'<path stroke-width="{n(width)}" d="M{n(x0 + radius)} {n(y0)}'
            f'H{n(x1 - radius)}A{r} {r} 0 0 0 {n(x1)} {n(y0 + radius)}'
            f'V{n(y1 - radius)}A{r} {r} 0 0 0 {n(x1 - radius)} {n(y1)}'
            f'H{n(x0 + radius)}A{r} {r} 0 0 0 {n(x0)} {n(y1 - radius)}'
            f'V{n(y0 + radius)}A{r} {r} 0 0 0 {n(x0 + radius)} {n(y0)}Z"/>')


def lozenge(x, y, w, h, fill):
    return (f'<path d="M{n(x)} {n(y - h)}L{n(x + w)} {n(y)}L{n(x)} {n(y + h)}'
            f'L{n(x - w)} {n(y)}Z" fill="{fill}" stroke="none"/>')


def divider(x, y, half, fill, weight=1.0):
    """A rule that swells into a lozenge between two beads."""
    w = weight
    return "\n".join([
        rule(x - half, y, x - 40 * w, y, 3.4 * w),
        rule(x + 40 * w, y, x + half, y, 3.4 * w),
        lozenge(x, y, 15 * w, 15 * w, fill),
        lozenge(x - 27 * w, y, 6.5 * w, 6.5 * w, fill),
        lozenge(x + 27 * w, y, 6.5 * w, 6.5 * w, fill)])


# ------------------------------------------------------------------ emblem

class Polhodes:
    """The inertia ellipsoid of the book itself, and the curves on it.

    The body turns freely: w1, w2, w3 lie on the ellipsoid sum I w^2 = 1 and
    on a second one, sum I^2 w^2 = D; a polhode is where the two meet.  The
    axes are x along the width (the middle one), y along the height (the
    least) and z through the thickness (the greatest moment of inertia).
    """

    def __init__(self, yaw, pitch):
        w, h, t = 0.1878, 0.29085, 0.05
        self.inertia = (h * h + t * t, w * w + t * t, w * w + h * h)
        cy, sy = math.cos(yaw), math.sin(yaw)
        cp, sp = math.cos(pitch), math.sin(pitch)
        self.right = (cy, 0.0, -sy)
        self.up = (-sy * sp, cp, -cy * sp)
        self.view = (sy * cp, sp, cy * cp)
        self.scale = math.sqrt(self.inertia[1])   # the long half axis is 1

    def project(self, p):
        dot = lambda q: sum(a * b for a, b in zip(p, q)) * self.scale
        return dot(self.right), -dot(self.up)

    def facing(self, p):
        return sum(i * a * b for i, a, b in
                   zip(self.inertia, p, self.view)) > -1e-9

    def tip(self, axis, reach=1.0, sign=1):
        p = [0.0, 0.0, 0.0]
        p[axis] = sign * reach / math.sqrt(self.inertia[axis])
        return p

    def loop(self, pole, sign, fraction):
        """A polhode about the pole axis (1 or 2): fraction 0 is the pole
        itself, 1 the separatrix."""
        i = self.inertia
        middle, other = 0, 3 - pole
        s = fraction * fraction
        points = []
        for k in range(721):
            phi = 2 * math.pi * k / 720
            em = s * math.sin(phi) ** 2
            eo = s * (i[middle] - i[pole]) / (i[other] - i[pole]) \
                * math.cos(phi) ** 2
            ep = max(0.0, 1.0 - em - eo)
            p = [0.0, 0.0, 0.0]
            p[middle] = math.copysign(math.sqrt(em / i[middle]), math.sin(phi))
            p[other] = math.copysign(math.sqrt(eo / i[other]), math.cos(phi))
            p[pole] = sign * math.sqrt(ep / i[pole])
            points.append(p)
        return points

    def separatrix(self, sign):
        i1, i0, i2 = self.inertia
        points = []
        for k in range(721):
            phi = 2 * math.pi * k / 720
            c, s = math.cos(phi), math.sin(phi)
            points.append([s / math.sqrt(i1),
                           c * math.sqrt((i2 - i1) / (i2 - i0) / i0),
                           sign * c * math.sqrt((i1 - i0) / (i2 - i0) / i2)])
        return points

    def outline(self):
        v = [math.sqrt(i) * d for i, d in zip(self.inertia, self.view)]
        size = math.sqrt(sum(a * a for a in v))
        v = [a / size for a in v]
        a = [v[2], 0.0, -v[0]]
        size = math.sqrt(sum(c * c for c in a))
        a = [c / size for c in a]
        b = [v[1] * a[2] - v[2] * a[1], v[2] * a[0] - v[0] * a[2],
             v[0] * a[1] - v[1] * a[0]]
        points = []
        for k in range(361):
            phi = 2 * math.pi * k / 360
            points.append([(math.cos(phi) * c + math.sin(phi) * d)
                           / math.sqrt(i)
                           for c, d, i in zip(a, b, self.inertia)])
        return points

    def path(self, points, size, hide=True):
        out, pen = [], False
        # Start a closed curve where it is hidden, so that it stays one piece.
        if hide:
            dark = [k for k, p in enumerate(points) if not self.facing(p)]
            if dark:
                points = points[dark[0]:-1] + points[:dark[0] + 1]
        step = 3 if len(points) > 100 else 1
        shown = [not hide or self.facing(p) for p in points]
        for k, p in enumerate(points):
            if not shown[k]:
                pen = False
                continue
            last = k + 1 == len(points) or not shown[k + 1]
            if pen and k % step and not last:
                continue
            x, y = self.project(p)
            out.append(("L" if pen else "M") + f"{size * x:.1f} {size * y:.1f}")
            pen = True
        return "".join(out)


def ellipsoid(size, weights, loops, yaw=0.96, pitch=0.44, axes=None,
              colour=GOLD, letters=0.0):
    """The ellipsoid with its polhodes, centred on the origin.

    weights: of the outline, the separatrices, the other polhodes, the axes.
    loops: how many polhodes about the least and about the greatest axis.
    axes: how far each axis is drawn past the surface; none without it.
    """
    ell = Polhodes(yaw, pitch)
    outline, cross, thin, arm = weights
    out = [f'<g fill="none" stroke="{colour}" stroke-linecap="round" '
           'stroke-linejoin="round">']
    fine = []
    for pole, count in ((1, loops[0]), (2, loops[1])):
        for sign in (1, -1):
            for k in range(1, count + 1):
                fine.append(ell.path(
                    ell.loop(pole, sign, k / (count + 1)), size))
    out.append(f'<path stroke-width="{thin}" d="{"".join(fine)}"/>')
    both = "".join(ell.path(ell.separatrix(s), size) for s in (1, -1))
    out.append(f'<path stroke-width="{cross}" d="{both}"/>')
    out.append(f'<path stroke-width="{outline}" '
               f'd="{ell.path(ell.outline(), size, hide=False)}Z"/>')
    if axes:
        for axis, reach in enumerate(axes):
            sign = 1 if ell.facing(ell.tip(axis)) else -1
            x0, y0 = (size * c for c in ell.project(ell.tip(axis, 1, sign)))
            x1, y1 = (size * c for c in ell.project(ell.tip(axis, reach, sign)))
            length = math.hypot(x1 - x0, y1 - y0)
            ux, uy = (x1 - x0) / length, (y1 - y0) / length
            head = 5.2 * arm
            bx, by = x1 - ux * head, y1 - uy * head
            half = 0.36 * head
            out.append(rule(x0, y0, bx, by, arm))
            out.append(f'<path fill="{colour}" stroke="none" d="M{n(x1)} '
                       f'{n(y1)}L{n(bx - uy * half)} {n(by + ux * half)}'
                       f'L{n(bx + ux * head * .18)} {n(by + uy * head * .18)}'
                       f'L{n(bx + uy * half)} {n(by - ux * half)}Z"/>')
            out.append(f'<circle cx="{n(x0)}" cy="{n(y0)}" r="{n(1.7 * arm)}" '
                       f'fill="{colour}" stroke="none"/>')
            if letters:
                # Past the arrow's head, but beside it where it points up.
                away = 0.62 * letters
                lx, ly = x1 + ux * away, y1 + uy * away
                if uy < -0.8:
                    lx, ly = x1 + 0.78 * letters, y1 + 0.4 * letters
                name = "\u2082\u2081\u2083"[axis]
                out.append(
                    f'<g fill="{colour}" stroke="none"><text '
                    f'x="{n(lx - 0.30 * letters)}" y="{n(ly + 0.2 * letters)}" '
                    f'font-style="italic" font-size="{n(letters)}">e<tspan '
                    f'font-style="normal">{name}</tspan></text></g>')
    out.append("</g>")
    return "\n".join(out)


def tumbling_book(size, weights, colour):
    """The book in outline, turning about its middle axis; a metre is size
    pixels long.  weights: of the outline, the fine lines, the axis."""
    outline, thin, arm = weights
    yaw = 0.76
    ell = Polhodes(yaw, 0.34)
    w, h, t = 0.1878 / 2, 0.29085 / 2, 0.05 / 2

    def at(*p):
        return tuple(size * sum(a * b for a, b in zip(p, q)) * m
                     for q, m in ((ell.right, 1), (ell.up, -1)))

    def line(*points):
        return "M" + "L".join(f"{x:.1f} {y:.1f}" for x, y in
                              (at(*p) for p in points))

    def around(angle, x=w + 0.125, radius=0.06):
        return (x, radius * math.sin(angle), radius * math.cos(angle))

    silhouette = line((-w, -h, t), (w, -h, t), (w, -h, -t), (w, h, -t),
                      (-w, h, -t), (-w, h, t)) + "Z"
    edges = line((-w, h, t), (w, h, t), (w, -h, t)) + line((w, h, t),
                                                           (w, h, -t))
    b, i = 0.009, 0.02
    fine = "".join(
        line((-w, h, z), (w, h, z), (w, -h, z)) for z in (t - b, b - t))
    fine += "".join(
        line((-w, h, z), (w, h, z), (w, -h, z)) for z in (-t / 5, t / 5))
    fine += line((-w + i + .012, -h + i, t), (w - i, -h + i, t),
                 (w - i, h - i, t), (-w + i + .012, h - i, t)) + "Z"
    fine += line((-w + .016, -h, t), (-w + .016, h, t))
    turn = [around(math.radians(d)) for d in range(112, 401, 4)]
    tip = at(*around(math.radians(424)))
    base = at(*turn[-1])
    ux, uy = tip[0] - base[0], tip[1] - base[1]
    head = math.hypot(ux, uy)
    ux, uy = ux / head, uy / head
    half = 0.42 * head
    hidden = t * math.tan(yaw)      # behind the front board
    axis = (line((w, 0, 0), (w + 0.23, 0, 0))
            + line((-w - 0.2, 0, 0), (-w - hidden, 0, 0)))
    return (f'<g fill="none" stroke="{colour}" stroke-linejoin="round" '
            'stroke-linecap="round">'
            f'<path stroke-width="{arm}" d="{axis}"/>'
            f'<path stroke-width="{outline}" d="{silhouette}{edges}"/>'
            f'<path stroke-width="{thin}" d="{fine}"/>'
            f'<path stroke-width="{arm}" d="{line(*turn)}"/>'
            f'<path fill="{colour}" stroke="none" d="M{n(tip[0])} {n(tip[1])}'
            f'L{n(base[0] - uy * half)} {n(base[1] + ux * half)}'
            f'L{n(base[0] + uy * half)} {n(base[1] - ux * half)}Z"/></g>')


def graduated_ring(radius, colour, weight=1.0):
    w = weight
    ticks = []
    for degree in range(0, 360, 5):
        a = math.radians(degree)
        reach = 22 if degree % 30 == 0 else 13
        r1 = radius - 9 * w
        r0 = r1 - reach * w
        ticks.append(f"M{n(r0 * math.cos(a))} {n(r0 * math.sin(a))}"
                     f"L{n(r1 * math.cos(a))} {n(r1 * math.sin(a))}")
    return (f'<g fill="none" stroke="{colour}">'
            f'<circle r="{n(radius)}" stroke-width="{n(6 * w)}"/>'
            f'<circle r="{n(radius - 9 * w)}" stroke-width="{n(2.6 * w)}"/>'
            f'<path stroke-width="{n(3 * w)}" d="{"".join(ticks)}"/></g>')


# ------------------------------------------------------------------- cloth

def cloth(width, seed, colour=CLOTH, name="cloth"):
    """Linen: a plain weave, drawn a little off true, with thicker threads
    both ways and a slow unevenness of the dye."""
    r, g, b = (c / 255.0 for c in colour)

    def row(c, depth):
        return f"{c * depth:.4f} 0 0 0 {c * (1 - depth / 2):.4f}"

    def noise(result, frequency, octaves, number):
        return (f'<feTurbulence type="fractalNoise" '
                f'baseFrequency="{frequency}" numOctaves="{octaves}" '
                f'seed="{number}" result="{result}0"/>'
                f'<feColorMatrix in="{result}0" values="1 0 0 0 0 1 0 0 0 0 '
                f'1 0 0 0 0 0 0 0 0 1" result="{result}"/>')

    def mix(first, second, k1, k2, result):
        # grey = half + k1 (first - half) + k2 (second - half)
        return (f'<feComposite in="{first}" in2="{second}" '
                f'operator="arithmetic" k1="0" k2="{k1}" k3="{k2}" '
                f'k4="{(1 - k1 - k2) / 2:.4f}" result="{result}"/>')

    p = 7       # the pitch of the threads, 1.3 mm: it fades, not shimmers
    weave = (
        f'<pattern id="{name}-weave" width="{2 * p}" height="{2 * p}" '
        f'patternUnits="userSpaceOnUse"><rect width="{2 * p}" '
        f'height="{2 * p}" fill="#585858"/>'
        f'<g fill="#b0b0b0"><rect x="0.6" y="-0.6" width="{p - 1.2}" '
        f'height="{p + 1.2}" rx="2.4"/><rect x="{p + .6}" y="{p - .6}" '
        f'width="{p - 1.2}" height="{p + 1.2}" rx="2.4"/></g>'
        f'<g fill="#8c8c8c"><rect x="{p - .4}" y="0.8" width="{p + .8}" '
        f'height="{p - 1.6}" rx="2.2"/><rect x="-0.4" y="{p + .8}" '
        f'width="{p + .8}" height="{p - 1.6}" rx="2.2"/></g></pattern>')
    grey = (
        noise("across", "0.007 0.15", 2, seed)
        + noise("along", "0.15 0.007", 2, seed + 1)
        + noise("dye", "0.007", 3, seed + 2)
        + '<feTurbulence type="fractalNoise" baseFrequency="0.035" '
          f'numOctaves="2" seed="{seed + 3}" result="bend"/>'
        + '<feDisplacementMap in="SourceGraphic" in2="bend" scale="7" '
          'xChannelSelector="R" yChannelSelector="G" result="bent"/>'
        + '<feGaussianBlur in="bent" stdDeviation="0.6" result="woven"/>'
        + mix("across", "along", 0.9, 0.9, "threads")
        + mix("threads", "dye", 0.6, 0.5, "uneven")
        + mix("uneven", "woven", 1.0, 1.0, "grey"))
    defs = (
        weave
        + f'<filter id="{name}" x="0" y="0" width="1" height="1" '
          'color-interpolation-filters="sRGB">' + grey
        + f'<feColorMatrix in="grey" values="{row(r, .26)} {row(g, .3)} '
          f'{row(b, .3)} 0 0 0 0 1"/></filter>'
        # The same weave as a thin shade, to lie over the stamped gold.
        + f'<filter id="{name}-press" x="0" y="0" width="1" height="1" '
          'color-interpolation-filters="sRGB">' + grey
        + '<feColorMatrix in="grey" values="0 0 0 0 0.2 0 0 0 0 0.03 '
          '0 0 0 0 0.03 -0.34 0 0 0 0.17"/></filter>')
    ground = (f'<rect width="{width}" height="{HEIGHT}" '
              f'fill="url(#{name}-weave)" filter="url(#{name})"/>')
    press = (f'<rect width="{width}" height="{HEIGHT}" '
             f'fill="url(#{name}-weave)" filter="url(#{name}-press)"/>')
    return defs, ground, press


def fade(name, stops, across=True):
    direction = 'x2="1" y2="0"' if across else 'x2="0" y2="1"'
    return (f'<linearGradient id="{name}" x1="0" y1="0" {direction}>'
            + "".join(f'<stop offset="{o}" stop-color="#2a0408" '
                      f'stop-opacity="{a}"/>' for o, a in stops)
            + "</linearGradient>")


def worn_edges(width):
    """Rubbed, darker cloth along the four edges."""
    d = 26
    defs = (fade("wear-l", [(0, .42), (.3, .16), (1, 0)])
            + fade("wear-r", [(0, 0), (.7, .16), (1, .42)])
            + fade("wear-t", [(0, .42), (.3, .16), (1, 0)], False)
            + fade("wear-b", [(0, 0), (.7, .16), (1, .42)], False))
    body = (f'<rect width="{d}" height="{HEIGHT}" fill="url(#wear-l)"/>'
            f'<rect x="{width - d}" width="{d}" height="{HEIGHT}" '
            'fill="url(#wear-r)"/>'
            f'<rect width="{width}" height="{d}" fill="url(#wear-t)"/>'
            f'<rect y="{HEIGHT - d}" width="{width}" height="{d}" '
            'fill="url(#wear-b)"/>')
    return defs, body


def joint(at):
    """The groove where the board hinges."""
    half = 17
    defs = fade("joint", [(0, 0), (.22, .07), (.42, .26), (.58, .26),
                          (.78, .07), (1, 0)])
    return defs, (f'<rect x="{n(at - half)}" width="{2 * half}" '
                  f'height="{HEIGHT}" fill="url(#joint)"/>')


def sheet(width, height, defs, *layers):
    body = "\n".join(layers)
    return ('<?xml version="1.0" encoding="UTF-8"?>\n'
            '<!-- Written by draw_textures.py. -->\n'
            f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" '
            f'height="{height}" viewBox="0 0 {width} {height}" '
            f'font-family="{FONT}">\n<defs>{defs}</defs>\n{body}\n</svg>\n')


def gold(*parts):
    body = "\n".join(parts)
    return (f'<g fill="{GOLD}" stroke="none">{body}</g>')


def lines(*parts, colour=GOLD):
    body = "\n".join(parts)
    return f'<g fill="none" stroke="{colour}">{body}</g>'


def frame(x0, y0, x1, y1):
    """The covers' frame: a broad rule, and a fine one with scooped corners."""
    inset, scoop = 15, 44
    corners = [lozenge(x, y, 9, 9, GOLD)
               for x in (x0 + 27, x1 - 27) for y in (y0 + 27, y1 - 27)]
    return lines(box(x0, y0, x1, y1, 6.5),
                 scooped_box(x0 + inset, y0 + inset, x1 - inset, y1 - inset,
                             scoop, 3.2), *corners)


# ------------------------------------------------------------------ covers

def front():
    defs, ground, press = cloth(COVER_W, 11)
    wear_defs, wear = worn_edges(COVER_W)
    joint_defs, groove = joint(JOINT)
    margin = 38
    x0, x1 = BOARD + margin, COVER_W - margin
    y0, y1 = margin, HEIGHT - margin
    cx = (x0 + x1) / 2

    size, measure = 160, 806
    left, right = ink("MECHANICS", size, spacing=3)
    squeeze = measure / (right - left)
    track = spacing_for("CLASSICAL", size, measure / squeeze)
    title = (f'<g stroke="{GOLD}" stroke-width="2.4" stroke-miterlimit="2">'
             + text_centred("CLASSICAL", cx, 266, size, spacing=track,
                            squeeze=squeeze)
             + text_centred("MECHANICS", cx, 416, size, spacing=3,
                            squeeze=squeeze) + "</g>")
    subtitle = text_centred("On the Rotation of Rigid Bodies", cx, 564, 58,
                            'font-style="italic" stroke="%s" '
                            'stroke-width="0.8"' % GOLD, 0.6)
    ey, radius = 1002, 318
    emblem = (f'<g transform="translate({n(cx)},{ey})">'
              + graduated_ring(radius, GOLD)
              + ellipsoid(240, (6.5, 5.2, 2.8, 4.6), (4, 4),
                          axes=(2.02, 1.22, 1.72), letters=54) + "</g>")
    imprint = text_centred("POLHODE PRESS", cx, 1462, 40, "", 9)
    return sheet(
        COVER_W, HEIGHT, defs + wear_defs + joint_defs, ground, wear, groove,
        frame(x0, y0, x1, y1), gold(title, subtitle),
        lines(divider(cx, 479, 250, GOLD)), gold(emblem),
        lines(divider(cx, 1394, 130, GOLD, 0.8)), gold(imprint), press)


BLURB = (
    "Toss a book into the air. About its longest axis, or its shortest, it "
    "spins steadily. About the one between, it never does: the least wobble "
    "grows, the book turns over, and soon turns back again. No force turns "
    "it. Its energy and angular momentum stay as they are, and the one path "
    "they leave open leads through the flip.")


def back():
    defs, ground, press = cloth(COVER_W, 47)
    wear_defs, wear = worn_edges(COVER_W)
    joint_defs, groove = joint(COVER_W - JOINT)
    margin = 38
    x0, x1 = margin, COVER_W - BOARD - margin
    y0, y1 = margin, HEIGHT - margin
    cx = (x0 + x1) / 2
    w, top, bottom = 690, 158, 1304
    lx0, lx1 = cx - w / 2, cx + w / 2
    paper_defs = (
        '<filter id="laid" x="0" y="0" width="1" height="1" '
        'color-interpolation-filters="sRGB"><feTurbulence '
        'type="fractalNoise" baseFrequency="0.02 0.03" numOctaves="4" '
        'seed="5"/><feColorMatrix values="0 0 0 0 0.45 0 0 0 0 0.33 '
        '0 0 0 0 0.16 0.11 0 0 0 -0.03"/></filter>')
    label = (f'<rect x="{n(lx0)}" y="{top}" width="{w}" '
             f'height="{bottom - top}" fill="{PAPER}"/>'
             f'<rect x="{n(lx0)}" y="{top}" width="{w}" '
             f'height="{bottom - top}" filter="url(#laid)"/>')
    border = lines(box(lx0 + 20, top + 20, lx1 - 20, bottom - 20, 4.5),
                   box(lx0 + 30, top + 30, lx1 - 30, bottom - 30, 2),
                   colour=INK)
    emblem = (f'<g transform="translate({n(cx)},{top + 178})">'
              + tumbling_book(670, (4.6, 2.4, 3.6), INK)
              + "</g>")
    words = (f'<g fill="{INK}">'
             + text_centred("The Middle Axis", cx, top + 392, 80,
                            'font-style="italic"')
             + justified(BLURB, lx0 + 62, top + 518, w - 124, 46.5, 58)
             + "</g>")
    foot = text_centred("MADE TO BE THROWN", cx, 1462, 40, "", 9)
    return sheet(
        COVER_W, HEIGHT, defs + wear_defs + joint_defs + paper_defs, ground,
        wear, groove, lines(box(x0, y0, x1, y1, 6.5)), gold(foot),
        lines(divider(cx, 1394, 130, GOLD, 0.8)), press, label, border,
        emblem, words,
        lines(divider(cx, top + 432, 150, INK, 0.7), colour=INK))


# ------------------------------------------------------------------- spine

def spine():
    defs, ground, press = cloth(SPINE_W, 83)
    wear_defs, wear = worn_edges(SPINE_W)
    cx = SPINE_W / 2

    def band(y):
        return lines(rule(0, y - 13, SPINE_W, y - 13, 3.2),
                     rule(0, y, SPINE_W, y, 9),
                     rule(0, y + 13, SPINE_W, y + 13, 3.2))

    bands = [70, 352, 1246, 1516]
    top, bottom = bands[1] + 34, bands[2] - 34
    panel = (f'<rect y="{top}" width="{SPINE_W}" height="{bottom - top}" '
             f'fill="{rgb(LEATHER)}" fill-opacity="0.78"/>')
    edge = lines(box(16, top + 16, SPINE_W - 16, bottom - 16, 3.4))

    middle = (top + bottom) / 2
    size, measure = 116, 720
    left, right = ink("MECHANICS", size, spacing=4)
    squeeze = measure / (right - left)
    track = spacing_for("CLASSICAL", size, measure / squeeze)
    title = (f'<g transform="translate({n(cx)},{n(middle)}) rotate(90)" '
             f'stroke="{GOLD}" stroke-width="1.8" stroke-miterlimit="2">'
             + text_centred("CLASSICAL", 0, -20, size, spacing=track,
                            squeeze=squeeze)
             + text_centred("MECHANICS", 0, 20 + 0.65 * size, size, spacing=4,
                            squeeze=squeeze) + "</g>")
    emblem = (f'<g transform="translate({n(cx)},{(bands[0] + bands[1]) // 2})">'
              + ellipsoid(100, (5, 4.4, 2.6, 3), (2, 3)) + "</g>")
    y = (bands[2] + bands[3]) / 2
    imprint = (text_centred("POLHODE", cx, y - 17, 36, "", 4)
               + text_centred("PRESS", cx, y + 54, 36, "", 6))
    return sheet(
        SPINE_W, HEIGHT, defs + wear_defs, ground, panel, wear,
        *[band(b) for b in bands], edge, gold(title, emblem, imprint),
        lines(divider(cx, y + 6, 70, GOLD, 0.6)), press)


# ------------------------------------------------------------------- paper

PAPER_SIZE = 256


def paper():
    """Edges of leaves, running across; repeats both ways."""
    state = 12345

    def chance():
        nonlocal state
        state = (state * 1103515245 + 12345) & 0x7fffffff
        return state / 0x7fffffff

    out = [f'<rect width="{PAPER_SIZE}" height="{PAPER_SIZE}" '
           'fill="#ded2b8"/>']
    y = 0.0
    while y < PAPER_SIZE:
        pitch = 2.6 + 2.2 * chance()
        dark = chance()
        shade = ("#a98f66" if dark < .72 else "#fffaf0")
        depth = 0.22 + 0.40 * chance()
        if dark > .96:
            shade, depth = "#7a6442", 0.5
        # A leaf that waves by whole periods joins itself at the sides.
        wave, phase = 0.5 * chance(), 2 * math.pi * chance()
        turns = 1 + int(3 * chance())
        points = []
        for k in range(33):
            x = PAPER_SIZE * k / 32
            dy = wave * math.sin(2 * math.pi * turns * k / 32 + phase)
            points.append(f"{n(x)} {n(y + dy)}")
        d = "M" + "L".join(points)
        for shift in (0, -PAPER_SIZE, PAPER_SIZE):
            if -4 < y + shift < PAPER_SIZE + 4:
                out.append(f'<path transform="translate(0,{shift})" d="{d}" '
                           f'fill="none" stroke="{shade}" stroke-width="'
                           f'{n(0.9 + 0.9 * depth)}" '
                           f'stroke-opacity="{n(depth)}"/>')
        y += pitch
    return sheet(PAPER_SIZE, PAPER_SIZE, "", *out)


# -------------------------------------------------------------------- files

def write(name, svg, svg_only):
    source = os.path.join(HERE, name + ".svg")
    with open(source, "w", encoding="utf-8", newline="\n") as file:
        file.write(svg)
    if svg_only:
        return
    picture = os.path.join(HERE, name + ".png")
    with tempfile.TemporaryDirectory() as folder:
        raw = os.path.join(folder, name + ".png")
        subprocess.run(["rsvg-convert", "-b", "#000000", source, "-o", raw],
                       check=True)
        # Packs it, and drops the alpha channel, which is opaque throughout.
        # Without filters it is unpacked in half the time.
        subprocess.run(["optipng", "-quiet", "-o1", "-f0", "-nc", "-strip",
                        "all", "-force", raw], check=True)
        shutil.copyfile(raw, picture)


def main():
    svg_only = sys.argv[1:] == ["--svg-only"]
    for name, draw in (("front", front), ("back", back), ("spine", spine),
                       ("paper", paper)):
        write(name, draw(), svg_only)


if __name__ == "__main__":
    main()
