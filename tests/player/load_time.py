#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Size of a page of `dot_run --player`, and the time of a cold load: from the request of the page, in a browser that
was just started with an empty profile, until its first picture can be seen; and the time of one step to the next frame.

usage: load_time.py PAGE [CHROMIUM]
"""
import os
import statistics
import sys

from browser import Browser

TRIALS = 5


def trial(page, chromium):
    with Browser(chromium) as browser:
        load = browser.open(page)
        step = browser.value("""(async () => {
          const start = performance.now();
          for (let i = 1; i < run.frames.length; ++i) {
            view.go(i);
            await document.getElementById("image").decode();
          }
          return (performance.now() - start) / Math.max(1, run.frames.length - 1);
        })()""")
        return load, step, browser.value("run.frames.length")


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    results = [trial(sys.argv[1], sys.argv[2] if len(sys.argv) == 3 else "chromium") for _ in range(TRIALS)]
    print(f"{results[0][2]} frames, {os.path.getsize(sys.argv[1]) / 1e6:.1f} MB, "
          f"cold load {statistics.median(r[0] for r in results):.2f} s "
          f"({min(r[0] for r in results):.2f} to {max(r[0] for r in results):.2f}), "
          f"a step {statistics.median(r[1] for r in results):.1f} ms")
