#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Puts faults of known size into sequences, one at a time, and prints what `dot_run --check` says of them.

usage: check_faults.py DOT_RUN SEQ... [--only FAULT,...]        needs numpy and OpenCV for Python

The sequences as they are come first: what is said of them is a false alarm. A fault counts as found if it is named and
its figure is within 30 % of the true one. The copies are made in a temporary folder, one after the other, by faults.py.
"""
import argparse
import json
import os
import subprocess
import sys
import tempfile

import faults


def same(size, clean):
    return float(size)


def texture(size, clean):
    """Noise of a grey value, and rounding, come on top."""
    return ((clean["texture-low"]["figure"] * float(size) / 100) ** 2 + 1 + 1 / 12) ** 0.5


def missing(size, clean):
    """Those that are missing anyway, and of the others so many."""
    before = clean["masks-missing"]["figure"] / 100
    return 100 * (before + (1 - before) * float(size) / 100)


def beyond(size, clean):
    """Of the pixels that have depth."""
    return (100 - float(size)) * clean["depth-sparse"]["figure"] / 100


def scaled(size, clean):
    return clean["principal-point"]["figure"] * float(size) / 100


# Of each fault: the name that it has in the report, the sizes to try, the true figure (None: it need only be named).
TRIALS = {
    "depth-unit": ("depth-unit", ["mm", "5000", "cm"], lambda s, c: {"mm": 1000, "5000": 5000, "cm": 100}[s] / 256),
    "depth-late": ("depth-lag", ["1", "2", "-1"], same),
    "depth-offset": ("depth-offset", ["4", "8", "16"], lambda s, c: (int(s) ** 2 + (int(s) // 2) ** 2) ** 0.5),
    "focal": ("focal-baseline", ["3", "5", "10"], same),
    "resolution": ("principal-point", ["25", "50", "200"], scaled),
    "no-centre": ("principal-point", ["cx", "cy"], lambda s, c: 0),
    "disparity": ("depth-inverse", ["16", "64", "256"], lambda s, c: 100),
    "rows": ("pair-rows", ["1", "2", "4"], same),
    "bias": ("disparity-bias", ["1", "2", "4"], same),
    "masks-late": ("masks-lag", ["1", "2", "-1"], same),
    "masks-size": ("masks-size", ["50", "75", "200"], same),
    "masks-values": ("masks-values", ["classes", "binary", "probabilities"], lambda s, c: None),
    "background": ("masks-cover", ["10", "50", "100"], lambda s, c: None),
    "masks-missing": ("masks-missing", ["20", "40", "60"], missing),
    "time-unit": ("time-unit", ["ms", "us", "ns"], lambda s, c: {"ms": 1e3, "us": 1e6, "ns": 1e9}[s]),
    "dropped": ("frames-dropped", ["1", "2", "4"], lambda s, c: 3 * int(s)),
    "twice": ("images-repeated", ["5", "10", "25"], same),
    "depth-twice": ("depth-repeated", ["5", "10", "25"], same),
    "exposure": ("exposure-jumps", ["20", "30", "40"], same),
    "blur": ("motion-blur", ["5", "9", "15"], same),
    "bands": ("brightness-bands", ["5", "10", "20"], same),
    "depth-sparse": ("depth-sparse", ["1", "3", "10"], same),
    "depth-saturated": ("depth-saturated", ["95", "85", "70"], beyond),
    "texture": ("texture-low", ["5", "10", "20"], texture),
    "hood": ("fixed-part", ["10", "20", "30"], lambda s, c: float(s) * (1 - 0.25 / 3)),
}


def check(dot_run, folder):
    """@return findings by name"""
    done = subprocess.run([dot_run, folder, "--check", "--json"], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        return {"error": {"verdict": "fault", "figure": None, "words": done.stderr.strip()}}
    return {finding["fault"]: finding for finding in json.loads(done.stdout)["findings"]}


def faults_of(findings):
    return {name: finding["figure"] for name, finding in findings.items() if finding["verdict"] == "fault"}


def shown(value):
    return "-" if value is None else f"{value:.3g}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("dot_run")
    parser.add_argument("sequences", nargs="+")
    parser.add_argument("--only", default=",".join(TRIALS))
    arguments = parser.parse_args()
    tried = found = 0
    for folder in arguments.sequences:
        name = os.path.basename(os.path.normpath(folder))
        clean = check(arguments.dot_run, folder)
        print(f"{name:14} {'as it is':26} {'none':>9} {'':>9}  {faults_of(clean) or 'ok'}", flush=True)
        for fault in arguments.only.split(","):
            finding_name, sizes, expected = TRIALS[fault]
            if fault in ("rows", "bias") and not os.path.isdir(f"{folder}/right"):
                continue
            for size in sizes:
                with tempfile.TemporaryDirectory() as scratch:
                    report = check(arguments.dot_run, faults.make(fault, size, scratch, folder))
                said = faults_of(report)
                true = expected(size, clean)
                figure = said.get(finding_name)
                good = finding_name in said and (true is None or abs(figure - true) <= 0.3 * abs(true))
                others = {k: shown(v) for k, v in said.items() if k != finding_name and k not in faults_of(clean)}
                why = "" if good else report.get(finding_name, report.get("error", {})).get("words", "")
                tried, found = tried + 1, found + good
                print(f"{name:14} {fault + ' ' + size:26} {shown(true):>9} {shown(figure):>9}  "
                      f"{'ok' if good else 'MISSED'}  {('also: ' + str(others)) if others else ''} {why}", flush=True)
    print(f"{found} of {tried} found")


if __name__ == "__main__":
    sys.exit(main())
