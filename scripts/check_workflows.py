#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""check_workflows.py ROOT: the forge's workflows do nothing but what dev.sh does. Every command is one verb of it that
exists; actions are of the forge itself and have a major version; there are no secrets and no rights but to read; every
job has a time limit. Needs PyYAML."""
import re
import sys
from pathlib import Path

import yaml

RUNNERS = {"ubuntu-24.04", "ubuntu-24.04-arm"}
IMAGES = {"debian:12", "debian:13", "buildpack-deps:bookworm-scm"}
EVENTS = {"push", "pull_request", "schedule", "workflow_dispatch"}


def verbs_of(script):
    """The verbs that dev.sh's last `case` knows."""
    return set(re.findall(r"^  (?:[\w-]+ \| )*(\w+)(?: \| [\w-]+)*\)", script, re.M))


def values(job, field):
    """A field of a job; if it is one of the matrix, all its values."""
    value = job.get(field)
    inner = re.fullmatch(r"\$\{\{ matrix\.(\w+) \}\}", str(value))
    return job.get("strategy", {}).get("matrix", {}).get(inner[1], []) if inner else [value]


def complaints_about(text, verbs):
    if "secrets" in text:
        yield "names secrets"
    try:
        flow = yaml.safe_load(text)
    except yaml.YAMLError as error:
        yield f"is not YAML: {error}"
        return
    if not isinstance(flow, dict) or not isinstance(flow.get("jobs"), dict):
        yield "has no jobs"
        return
    events = flow.get("on", flow.get(True))  # YAML 1.1 reads `on` as true
    for event in events if isinstance(events, (dict, list)) else [events]:
        if event not in EVENTS:
            yield f"starts at {event}"
    if flow.get("permissions") != {"contents": "read"}:
        yield "must have the permissions {contents: read} and no others"
    for name, job in flow["jobs"].items():
        for complaint in complaints_about_job(job, verbs):
            yield f"{name}: {complaint}"


def complaints_about_job(job, verbs):
    if "permissions" in job:
        yield "has permissions of its own"
    if not isinstance(job.get("timeout-minutes"), int):
        yield "has no timeout-minutes"
    if not set(values(job, "runs-on")) <= RUNNERS:
        yield f"runs on {job.get('runs-on')}"
    if "container" in job and not set(values(job, "container")) <= IMAGES:
        yield f"runs in {job['container']}"
    steps = job.get("steps") or []
    if not any("run" in step for step in steps):
        yield "does nothing"
    for step in steps:
        if "uses" in step and not re.fullmatch(r"actions/[\w-]+@v\d+", step["uses"]):
            yield f"uses {step['uses']}, which is not an action of the forge with a major version"
        if "run" in step:
            command = re.fullmatch(r"\./dev\.sh (\w+)( [\w-]+)*", step["run"])
            if not command:
                yield f"runs '{step['run']}', which is not one verb of dev.sh"
            elif command[1] not in verbs:
                yield f"dev.sh has no verb {command[1]}"


def main():
    root = Path(sys.argv[1])
    verbs = verbs_of((root / "dev.sh").read_text())
    flows = sorted((root / ".github/workflows").glob("*.y*ml"))
    found = [f"{path.relative_to(root)}: {c}" for path in flows for c in complaints_about(path.read_text(), verbs)]
    for complaint in found:
        print(complaint, file=sys.stderr)
    print(f"{len(flows)} workflows")
    return 1 if found or not flows else 0


if __name__ == "__main__":
    sys.exit(main())
