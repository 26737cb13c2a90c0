#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Draws the plots of docs/performance.md from what the benchmarks wrote.

    bench/plots.py OUT BENCHMARKS.json PEER_ROOM.txt

BENCHMARKS.json is that of `dot_bench --benchmark_out`, PEER_ROOM.txt the output of `bench_peer_room`, which may be
missing. Writes SVG files into the folder OUT. Needs nothing but Python.
"""
import json
import math
import os
import re
import sys

COLOURS = ["#1f6fb4", "#d1603d", "#3a8f5c", "#7d5ba6", "#222222", "#c7a317"]
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 560, 340, 62, 16, 34, 46


def ticks_of(low, high, log):
    if log:
        steps = [m * 10**e for e in range(-4, 5) for m in (1, 2, 5)]
        return [t for t in steps if low <= t <= high]
    step = 10 ** math.floor(math.log10(high / 4))
    step *= min((m for m in (1, 2, 5, 10) if high / (step * m) <= 6), default=10)
    return [step * i for i in range(int(high / step) + 1)]


def plot(path, title, x_label, y_label, series, log=False):
    """series: (name, [(x, y)...], True for dots alone). Linear axes start at 0."""
    xs = [x for _, points, _ in series for x, _ in points]
    ys = [y for _, points, _ in series for _, y in points]
    x_range = (min(xs) * 0.8, max(xs) * 1.25) if log else (0, max(xs) * 1.05)
    y_range = (min(ys) * 0.7, max(ys) * 1.4) if log else (0, max(ys) * 1.1)

    def place(value, limits, begin, length):
        a, b = limits
        share = math.log(value / a) / math.log(b / a) if log else (value - a) / (b - a)
        return begin + share * length

    def at(x, y):
        return (place(x, x_range, LEFT, WIDTH - LEFT - RIGHT), place(y, y_range, HEIGHT - BOTTOM, TOP + BOTTOM - HEIGHT))

    svg = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" font-family="sans-serif" font-size="12">',
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>',
        f'<text x="{LEFT}" y="20" font-size="14">{title}</text>',
    ]
    for t in ticks_of(*x_range, log):
        x, y = at(t, y_range[0])
        svg.append(f'<path d="M{x:.1f} {TOP}V{y:.1f}" stroke="#e4e4e4"/>')
        svg.append(f'<text x="{x:.1f}" y="{y + 16:.1f}" text-anchor="middle">{t:g}</text>')
    for t in ticks_of(*y_range, log):
        x, y = at(x_range[0], t)
        svg.append(f'<path d="M{x:.1f} {y:.1f}H{WIDTH - RIGHT}" stroke="#e4e4e4"/>')
        svg.append(f'<text x="{x - 6:.1f}" y="{y + 4:.1f}" text-anchor="end">{t:g}</text>')
    middle = TOP + (HEIGHT - TOP - BOTTOM) / 2
    svg.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" text-anchor="middle">{x_label}</text>')
    svg.append(f'<text transform="translate(14 {middle}) rotate(-90)" text-anchor="middle">{y_label}</text>')
    for i, (name, points, dots) in enumerate(series):
        colour = COLOURS[i % len(COLOURS)]
        places = [at(x, y) for x, y in sorted(points)]
        if not dots:
            line = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
            svg.append(f'<polyline points="{line}" fill="none" stroke="{colour}" stroke-width="1.5"/>')
        svg += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="{4.5 if dots else 3}" fill="{colour}"/>' for x, y in places]
        # Where there is room: costs grow from the lower left, errors fall from the upper left.
        x = WIDTH - RIGHT - 150 if log else LEFT + 14
        y = TOP + 16 + 17 * i
        svg.append(f'<circle cx="{x}" cy="{y - 4}" r="4" fill="{colour}"/><text x="{x + 10}" y="{y}">{name}</text>')
    svg.append("</svg>\n")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(svg))


def benchmarks_of(path):
    """Name without options -> its entry; of repeated ones the median."""
    with open(path, encoding="utf-8") as file:
        entries = json.load(file)["benchmarks"]
    medians = [e for e in entries if e.get("aggregate_name") == "median"]
    scale = {"ns": 1e-6, "us": 1e-3, "ms": 1, "s": 1e3}
    found = {}
    for e in medians or entries:
        name = re.sub(r"/(iterations|repeats):\d+|/manual_time|_median$", "", e["name"])
        e["ms"] = (e["real_time"] if "manual_time" in e["name"] else e["cpu_time"]) * scale[e["time_unit"]]
        found[name] = e
    return found


def height_of(width):
    return width * 9 // 16 if width > 1280 else width * 3 // 4


def plot_benchmarks(out, found):
    widths = [w for w in (320, 640, 1280, 1920, 3840) if f"BM_Scene/5/{w}" in found]
    megapixels = {w: w * height_of(w) / 1e6 for w in widths}

    def over_pixels(name, pattern):
        return name, [(megapixels[w], found[pattern.format(w)]["ms"]) for w in widths], False

    plot(
        f"{out}/pixels.svg", "Time against resolution, 320x240 to 3840x2160", "megapixels", "ms a frame",
        [over_pixels("track, 5 objects", "BM_Scene/5/{}"), over_pixels("points, 3000", "BM_Select/{}/3000"),
         over_pixels("depth pyramid", "BM_DepthPyramid/{}"), over_pixels("image pyramid", "BM_Pyramid/{}")])
    counts = [n for n in (0, 1, 2, 5, 10, 20, 40) if f"BM_Scene/{n}/640" in found]
    scenes = [(n, found[f"BM_Scene/{n}/640"]) for n in counts]
    plot(f"{out}/objects.svg", "Time against objects, 640x480", "objects", "ms a frame",
         [("track", [(n, e["ms"]) for n, e in scenes], False)])
    sources = enumerate(("forward", "reference", "mean (ESM)"))
    plot(
        f"{out}/points.svg", "Alignment from the identity against points, 640x480", "budget of points", "ms",
        [(name, [(n, found[f"BM_Align/640/{n}/{k}"]["ms"]) for n in (300, 1000, 3000, 10000)], False)
         for k, name in sources])


def plot_accuracy(out, path):
    ways, peer = {}, []
    with open(path, encoding="utf-8") as file:
        for line in file.read().split("least time")[0].splitlines():
            if match := re.match(r"peer, .*?\s\s+([\d.]+)\s+[\d.]+\s+([\d.]+)", line):
                if "prepared" not in line:
                    peer.append((float(match[1]), float(match[2])))
            elif match := re.match(r"(\S.*?)\s+\d+\s+\d+\s+([\d.]+)\s+[\d.]+\s+([\d.]+)\s", line):
                ways.setdefault(match[1], []).append((float(match[2]), float(match[3])))
    pipeline = ways.pop("as the pipeline", [])
    series = [(name, points, False) for name, points in ways.items()]
    plot(f"{out}/accuracy.svg", "Pose error against time of a whole alignment, 640x480", "ms (log)", "median error, mm (log)",
         series + [("RgbdOdometry", peer, True)] + ([("pipeline's settings", pipeline, True)] if pipeline else []), log=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    os.makedirs(sys.argv[1], exist_ok=True)
    plot_benchmarks(sys.argv[1], benchmarks_of(sys.argv[2]))
    if len(sys.argv) > 3 and os.path.exists(sys.argv[3]):
        plot_accuracy(sys.argv[1], sys.argv[3])
