# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""workflows_test.py SCRIPTS: what the checker of the workflows finds in ones that are wrong."""
import sys
import unittest

sys.path.insert(0, sys.argv.pop(1))
from check_workflows import complaints_about, verbs_of  # noqa: E402

GOOD = """
on: [push]
permissions: {contents: read}
jobs:
  one:
    strategy: {matrix: {runner: [ubuntu-24.04, ubuntu-24.04-arm]}}
    runs-on: ${{ matrix.runner }}
    timeout-minutes: 9
    steps:
      - uses: actions/checkout@v4
      - run: ./dev.sh test
"""


class Workflows(unittest.TestCase):
    def complains(self, before, after, about):
        self.assertIn(before, GOOD)
        found = list(complaints_about(GOOD.replace(before, after), {"test"}))
        self.assertEqual(len(found), 1, found)
        self.assertIn(about, found[0])

    def test_good(self):
        self.assertEqual(list(complaints_about(GOOD, {"test"})), [])

    def test_verbs(self):
        self.assertEqual(verbs_of("case $verb in\n  test) run ;;\n  help | -h | --help)\n    x\n  *)\nesac\n"), {"test", "help"})
        self.complains("dev.sh test", "dev.sh tests", "dev.sh has no verb tests")
        self.complains("./dev.sh test", "make", "not one verb")
        self.complains("./dev.sh test", "./dev.sh test && make", "not one verb")
        self.complains("run: ./dev.sh test", "name: x", "does nothing")

    def test_rights(self):
        self.complains("contents: read", "contents: write", "permissions")
        self.complains("permissions: {contents: read}\n", "", "permissions")
        self.complains("    timeout-minutes: 9\n", "    timeout-minutes: 9\n    permissions: {}\n", "permissions of its own")
        self.complains("[push]", "[pull_request_target]", "starts at pull_request_target")
        self.complains("@v4", "@v4\n        with: {token: '${{ secrets.X }}'}", "secrets")

    def test_pins(self):
        self.complains("@v4", "@main", "actions/checkout@main")
        self.complains("actions/checkout", "others/checkout", "others/checkout")
        self.complains("[ubuntu-24.04, ubuntu-24.04-arm]", "[ubuntu-latest]", "runs on")
        self.complains("    timeout-minutes: 9\n", "", "timeout-minutes")

    def test_no_workflow(self):
        self.assertIn("is not YAML", next(complaints_about("a: [", {"test"})))
        self.assertIn("has no jobs", next(complaints_about("", {"test"})))


if __name__ == "__main__":
    unittest.main()
