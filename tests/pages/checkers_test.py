# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""checkers_test.py FOLDER: what the checkers in that folder find in pages that are wrong."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(sys.argv.pop(1))
GOOD = "# One\n\n[to it](#two-words), [a file](docs/other.md#a-b)\n\n## Two `words`\n"
OTHER = "# Other\n\n## A, b!\n"


class Markdown(unittest.TestCase):
    def check(self, readme, tests=""):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for path, text in {"README.md": readme, "docs/other.md": OTHER, "tests/CMakeLists.txt": tests,
                               "examples/dot_run/arguments.cpp": '"--out"',
                               "dev.sh": "case $verb in\n  test) run ;;\nesac\n"}.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(text)
            run = subprocess.run([sys.executable, "-B", SCRIPTS / "check_markdown.py", root], text=True,
                                 capture_output=True, check=False)
        self.assertEqual(run.returncode, 1 if run.stderr else 0, run.stderr)
        return run.stderr.splitlines()

    def complains(self, text, about, tests=""):
        complaints = self.check(text, tests)
        self.assertEqual(len(complaints), 1, complaints)
        self.assertIn(about, complaints[0])

    def test_good_pages(self):
        self.assertEqual(self.check(GOOD), [])
        self.assertEqual(self.check("<!-- snippet: one -->\n```cpp\nint a;\n```\n", "take(one)"), [])
        self.assertEqual(self.check("```sh\n./dev.sh test\ndot_run SEQ --out OUT\n```\n"), [])
        self.assertEqual(self.check("`[no link](nowhere.md)`\n\n```\n[none](here.md)\n```\n"), [])

    def test_links(self):
        self.complains("[x](nowhere.md)", "leads to no file")
        self.complains("[x](#nothing)", "leads to no heading")
        self.complains("[x](docs/other.md#b-a)", "leads to no heading")
        self.complains("[over two\nlines](nowhere.md)", "leads to no file")
        self.complains("![picture](nowhere.png)", "leads to no file")
        self.complains("[x](../outside.md)", "out of the project")

    def test_blocks(self):
        self.complains("```cpp\nint a;\n```\n", "without <!-- snippet: --> before it")
        self.complains("<!-- snippet: two -->\n```cpp\nint a;\n```\n", "no test takes the snippet two", "take(one)")
        self.complains("<!-- fragment: why -->\n```cpp\nint a;\n```\n", "which nothing checks")
        self.complains("<!-- fragment: why -->\n```python\nif:\n```\n", "README.md:3: invalid syntax")
        self.complains("<!-- fragment: why -->\n```cmake\nlink(dot::none)\n```\n", "no target dot::none")
        self.complains("```perl\n1\n```\n", "blocks of perl are not checked")
        self.complains("```cpp\nint a;\n", "does not end")

    def test_commands(self):
        self.complains("```sh\n./dev.sh nothing\n```\n", "dev.sh has no verb nothing")
        self.complains("```sh\nbuild/examples/dot_run SEQ \\\n  --none\n```\n", "dot_run has no option --none")
        self.complains("```sh\nif then\n```\n", "syntax error")


if __name__ == "__main__":
    unittest.main()
