# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The names that Doxygen found, from its XML: where each is described, and which have no description."""
import xml.etree.ElementTree as xml

COMPOUNDS = ("class", "struct", "namespace", "file")
SETTINGS = "dot::Options"


def described(element):
    return any("".join(element.find(kind).itertext()).strip()
               for kind in ("briefdescription", "detaileddescription") if element.find(kind) is not None)


def is_default(member):
    """Destructors, and what the language makes by itself, say nothing of their own."""
    return "~" in member.findtext("name") or member.findtext("argsstring", "").endswith("=default")


class Names:
    def __init__(self, folder):
        self.url = {}
        self.undescribed = []
        self.count = 0
        self._types = {}
        for path in sorted(folder.glob("*.xml")):
            for compound in xml.parse(path).getroot().iter("compounddef"):
                if compound.get("kind") in COMPOUNDS and compound.get("prot") != "private":
                    self._compound(compound)
        for member, kind in self._types.items():  # velocity.v0 is a member of VelocitySettings
            for name, url in list(self.url.items()):
                if name.startswith(kind + "::"):
                    self.url.setdefault(f"{member}.{name[len(kind) + 2:]}", url)

    def _compound(self, compound):
        kind, name, page = compound.get("kind"), compound.findtext("compoundname"), compound.get("id") + ".html"
        if kind != "file":
            self._add(name, page, compound)
        for member in compound.iter("memberdef"):
            if member.get("prot") != "public":
                continue
            scope = "" if kind == "file" else name + "::"
            full = scope + member.findtext("name")
            if not is_default(member):
                self._add(full, self._url(member), member)
            if scope == SETTINGS + "::":
                self._types[member.findtext("name")] = "dot::" + "".join(member.find("type").itertext()).strip()
            for value in member.findall("enumvalue"):
                inner = full + "::" if "@" not in full and member.get("strong") == "yes" else scope
                self._add(inner + value.findtext("name"), self._url(value), value)

    def _url(self, member):
        page, _, anchor = member.get("id").rpartition("_1")
        return f"{page}.html#{anchor}"

    def _add(self, name, url, element):
        self.count += 1
        if not described(element):
            self.undescribed.append(name)
        self.url.setdefault(name, url)
        if name.startswith("dot::"):
            self.url.setdefault(name[5:], url)
