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


class Html(unittest.TestCase):
    def check(self, body, script=""):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            (root / "search").mkdir()
            (root / "a.html").write_text(f"<html><body><a class='anchor' id='here'></a>{body}</body></html>")
            (root / "b.html").write_text("<p id='there'></p>")
            (root / "search/all.js").write_text(script)
            run = subprocess.run([sys.executable, "-B", SCRIPTS / "check_html.py", root], text=True,
                                 capture_output=True, check=False)
        self.assertEqual(run.returncode, 1 if run.stderr else 0, run.stderr)
        return run.stderr.splitlines(), run.stdout

    def test_good(self):
        complaints, said = self.check("<a href='#here'></a> <a href='b.html#there'></a> <a href='https://example.org'></a>",
                                      "['../b.html#there',1]")
        self.assertEqual(complaints, [])
        self.assertEqual(said, "2 pages, 4 links, 1 of them into the network, 0 dead\n")

    def test_dead(self):
        for body in ("<a href='c.html'></a>", "<a href='#nowhere'></a>", "<a href='b.html#here'></a>", "<img src='x.png'/>",
                     "<a href='../outside.html'></a>"):
            self.assertEqual(len(self.check(body)[0]), 1, body)
        self.assertEqual(len(self.check("", "['../b.html#here',1]")[0]), 1)


class Described(unittest.TestCase):
    def test_names(self):
        sys.path.insert(0, str(SCRIPTS))
        sys.dont_write_bytecode = True
        from names import Names

        def member(kind, name, text, inner="", prot="public", arguments=""):
            return (f'<memberdef kind="{kind}" id="classA_1{name}" prot="{prot}" strong="yes"><name>{name}</name>'
                    f'<argsstring>{arguments}</argsstring><briefdescription>{text}</briefdescription>{inner}</memberdef>')

        value = '<enumvalue id="classA_1e{0}" prot="public"><name>{0}</name><briefdescription>{1}</briefdescription></enumvalue>'
        with tempfile.TemporaryDirectory() as folder:
            Path(folder, "a.xml").write_text(
                '<doxygen><compounddef kind="class" id="classA" prot="public"><compoundname>dot::A</compoundname>'
                '<briefdescription>A.</briefdescription>' + member("variable", "x", "metres") + member("variable", "y", "")
                + member("variable", "hidden", "", prot="private") + member("function", "A", "", arguments="()=default")
                + member("enum", "E", "Which.", value.format("One", "it") + value.format("Two", ""))
                + "</compounddef></doxygen>")
            names = Names(Path(folder))
        self.assertEqual(names.undescribed, ["dot::A::y", "dot::A::E::Two"])
        self.assertEqual(names.url["A::x"], "classA.html#x")


if __name__ == "__main__":
    unittest.main()
