# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""release_test.py SCRIPTS: releases of a small repository that has the project's release script."""
import hashlib
import json
import os
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

SCRIPTS = Path(sys.argv.pop(1)).resolve()
WHO = {f"GIT_{role}_{what}": value for role in ("AUTHOR", "COMMITTER")
       for what, value in (("NAME", "A"), ("EMAIL", "a@example.org"))}


class Release(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.repository = Path(self.folder.name) / "a"
        self.environment = {**os.environ, **WHO, "HOME": self.folder.name, "GIT_CONFIG_NOSYSTEM": "1"}
        for path, text in {
                "include/dot/version.hpp": '#define DOT_VERSION_STRING "1.2.3"\n', "picture.png": "no text",
                "CHANGELOG.md": "# Changelog\n\n## [1.2.3] - 2026-01-31\n\nNew.\n\n## [1.2.2] - 2026-01-01\n\nOld.\n",
                ".gitignore": "/out/\n__pycache__/\n", "a folder/ä.cpp": "// SPDX-License-Identifier: Apache-2.0\n"}.items():
            self.write(path, text)
        shutil.copytree(SCRIPTS, self.repository / "scripts", ignore=shutil.ignore_patterns("docs*", "__pycache__"))
        self.git("init", "-q")
        self.commit()

    def write(self, path, text):
        (self.repository / path).parent.mkdir(parents=True, exist_ok=True)
        (self.repository / path).write_text(text)

    def git(self, *arguments):
        return subprocess.run(["git", "-C", self.repository, *arguments], env=self.environment, check=True, text=True,
                              capture_output=True).stdout

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "-q", "-m", "x")

    def release(self, *arguments, folder=None, **environment):
        return subprocess.run([(folder or self.repository) / "scripts/release.sh", *arguments], text=True,
                              capture_output=True, env={**self.environment, **environment}, check=False)

    def refused(self, why, *arguments):
        run = self.release(*arguments)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn(why, run.stderr)
        self.assertEqual(self.git("tag"), "")
        self.assertFalse((self.repository / "out").exists())

    def made(self, folder=None):
        return {p.name: p.read_bytes() for p in sorted(((folder or self.repository) / "out/release").iterdir())}

    def test_the_same_bytes_everywhere(self):
        other = Path(self.folder.name) / "another place" / "b"
        subprocess.run(["git", "clone", "-q", self.repository, other], env=self.environment, check=True)
        os.chmod(other / "picture.png", 0o600)
        self.assertEqual(self.release("1.2.3").returncode, 0)
        (Path(self.folder.name) / ".gitconfig").write_text("[core]\n autocrlf = true\n[tar]\n umask = 0077\n")
        run = self.release("1.2.3", folder=other, TZ="Asia/Tokyo", LANG="de_DE.UTF-8", GZIP_OPT="-1", SOURCE_DATE_EPOCH="7")
        self.assertEqual(run.returncode, 0, run.stderr)
        first, second = self.made(), self.made(other)
        self.assertEqual(sorted(first), ["dot-1.2.3.md", "dot-1.2.3.spdx.json", "dot-1.2.3.tar.gz",
                                         "dot-1.2.3.tar.gz.sha256"])
        self.assertEqual(first, second)

    def test_what_is_made(self):
        self.assertEqual(self.release("1.2.3").returncode, 0)
        made = self.made()
        archive = made["dot-1.2.3.tar.gz"]
        self.assertEqual(made["dot-1.2.3.tar.gz.sha256"].decode(),
                         hashlib.sha256(archive).hexdigest() + "  dot-1.2.3.tar.gz\n")
        self.assertEqual(made["dot-1.2.3.md"].decode(), "## [1.2.3] - 2026-01-31\n\nNew.\n\n")
        sbom = json.loads(made["dot-1.2.3.spdx.json"])
        with tarfile.open(self.repository / "out/release/dot-1.2.3.tar.gz") as tar:
            files = {m.name[len("dot-1.2.3/"):]: tar.extractfile(m).read() for m in tar if m.isfile()}
        self.assertEqual(set(files), set(self.git("-c", "core.quotePath=off", "ls-files").splitlines()))
        self.assertEqual({f["fileName"]: f["checksums"][1]["checksumValue"] for f in sbom["files"]},
                         {"./" + path: hashlib.sha256(data).hexdigest() for path, data in files.items()})
        self.assertEqual({f["fileName"]: f["licenseConcluded"] for f in sbom["files"]}["./a folder/ä.cpp"], "Apache-2.0")
        package = sbom["packages"][0]
        self.assertEqual(package["checksums"][0]["checksumValue"], hashlib.sha256(archive).hexdigest())
        ids = [e["SPDXID"] for kind in ("packages", "files") for e in sbom[kind]] + [sbom["SPDXID"]]
        self.assertEqual(len(ids), len(set(ids)))
        self.assertLessEqual({r[end] for r in sbom["relationships"] for end in ("spdxElementId", "relatedSpdxElement")},
                             set(ids))
        self.assertIn(self.git("rev-parse", "HEAD").strip(), sbom["documentNamespace"])
        self.assertEqual(self.git("tag"), "", "no tag without --tag")

    def test_versions_that_differ(self):
        self.refused("has version 1.2.3, not 1.2.4", "1.2.4")
        self.refused("is no version", "1.2")
        self.refused("which version?")
        self.write("include/dot/version.hpp", '#define DOT_VERSION_STRING "1.3.0"\n')
        self.commit()
        self.refused("the first version in CHANGELOG.md is '## [1.2.3] - 2026-01-31', not 1.3.0", "1.3.0")

    def test_a_tree_with_changes(self):
        self.write("picture.png", "other")
        self.refused("M picture.png", "1.2.3")
        self.git("checkout", "-q", "picture.png")
        self.write("new.txt", "")
        self.refused("?? new.txt", "1.2.3")

    def test_unreleased(self):
        self.write("CHANGELOG.md", "## [1.2.3] - unreleased\n")
        self.commit()
        self.refused("gives 1.2.3 no date but 'unreleased'", "1.2.3")
        self.refused("a draft gets no tag", "1.2.3", "--draft", "--tag")
        self.assertEqual(self.release("1.2.3", "--draft").returncode, 0)

    def test_tag(self):
        self.assertEqual(self.release("1.2.3", "--tag").returncode, 0)
        self.assertEqual(self.git("cat-file", "-t", "v1.2.3").strip(), "tag")
        before = self.made()
        self.assertEqual(self.release("1.2.3", "--tag").returncode, 0, "once more on the same commit")
        self.assertEqual(self.made(), before)
        self.write("picture.png", "other")
        self.commit()
        run = self.release("1.2.3")
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("the tag v1.2.3 is on another commit", run.stderr)


if __name__ == "__main__":
    unittest.main()
