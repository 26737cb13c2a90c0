#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""sbom.py ARCHIVE VERSION COMMIT SECONDS: prints the bill of materials of a source archive, SPDX 2.3 in JSON. All of it
follows from the archive and the commit, whose time SECONDS is: nothing from the clock, no random numbers."""
import hashlib
import json
import re
import sys
import tarfile
import time

LICENCE = re.compile(rb"SPDX-License-Identifier: *([\w.+-]+)")
COPYRIGHT = re.compile(rb"SPDX-FileCopyrightText: *([^\n]*\w)")
OURS = ("MIT", "2026 The dot authors")  # LICENSE, for files that cannot say it themselves

# What is not in the archive but needed: name, licence, and what for.
NEEDED = [
    ("Eigen", "MPL-2.0", "BUILD_DEPENDENCY_OF", "3.3 or newer"),
    ("OpenCV", "Apache-2.0", "DEPENDENCY_OF", "4.5 or newer: core, imgproc"),
    ("GoogleTest", "BSD-3-Clause", "TEST_DEPENDENCY_OF", "tests"),
    ("Google Benchmark", "Apache-2.0", "DEV_DEPENDENCY_OF", "benchmarks"),
]


def spdx_id(kind, text):
    return f"SPDXRef-{kind}-" + re.sub(r"[^A-Za-z0-9.-]+", "-", text)


def files_of(archive):
    with tarfile.open(archive) as tar:
        for number, member in enumerate(sorted((m for m in tar if m.isfile()), key=lambda m: m.name), 1):
            data = tar.extractfile(member).read()
            head = data[:2000]
            stated, copyright_ = LICENCE.search(head), COPYRIGHT.search(head)
            stated = stated[1].decode() if stated else None
            yield {
                "SPDXID": f"SPDXRef-File-{number}",
                "fileName": "./" + member.name.split("/", 1)[1],
                "checksums": [{"algorithm": a, "checksumValue": hashlib.new(a.lower(), data).hexdigest()}
                              for a in ("SHA1", "SHA256")],
                "licenseConcluded": stated or OURS[0],
                "licenseInfoInFiles": [stated or "NONE"],
                "copyrightText": copyright_[1].decode() if copyright_ else OURS[1],
            }


def document(archive, version, commit, seconds):
    files = list(files_of(archive))
    name = f"dot-{version}"
    package = spdx_id("Package", name)
    sums = sorted(f["checksums"][0]["checksumValue"] for f in files)
    with open(archive, "rb") as file:
        checksum = hashlib.sha256(file.read()).hexdigest()
    packages = [{
        "SPDXID": package, "name": "dot", "versionInfo": version, "packageFileName": name + ".tar.gz",
        "downloadLocation": "NOASSERTION", "filesAnalyzed": True, "primaryPackagePurpose": "SOURCE",
        "packageVerificationCode": {"packageVerificationCodeValue": hashlib.sha1("".join(sums).encode()).hexdigest()},
        "checksums": [{"algorithm": "SHA256", "checksumValue": checksum}], "sourceInfo": f"git commit {commit}",
        "licenseConcluded": OURS[0], "licenseDeclared": OURS[0], "copyrightText": OURS[1],
        "licenseInfoFromFiles": sorted({stated for f in files for stated in f["licenseInfoInFiles"]} - {"NONE"}),
        "hasFiles": [f["SPDXID"] for f in files],
    }]
    relationships = [("SPDXRef-DOCUMENT", "DESCRIBES", package)]
    for needed, licence, relation, comment in NEEDED:
        packages.append({
            "SPDXID": spdx_id("Package", needed), "name": needed, "downloadLocation": "NOASSERTION",
            "filesAnalyzed": False, "licenseConcluded": licence, "licenseDeclared": licence,
            "copyrightText": "NOASSERTION", "comment": comment + "; not in the archive"})
        relationships.append((spdx_id("Package", needed), relation, package))
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": name,
        "documentNamespace": f"https://spdx.org/spdxdocs/{name}-{commit}",
        "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds)),
                         "creators": ["Organization: The dot authors", "Tool: scripts/release/sbom.py"]},
        "packages": packages, "files": files,
        "relationships": [{"spdxElementId": a, "relationshipType": r, "relatedSpdxElement": b}
                          for a, r, b in relationships],
    }


def main():
    archive, version, commit, seconds = sys.argv[1:5]
    json.dump(document(archive, version, commit, int(seconds)), sys.stdout, indent=1, sort_keys=True)
    print()


if __name__ == "__main__":
    main()
