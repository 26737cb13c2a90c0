// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "page/escape.hpp"
#include "page/json.hpp"
#include "page/style.hpp"
#include "words.hpp"

namespace check {
namespace {

std::string figure(const Finding& finding) {
  if (std::isnan(finding.figure)) return "";
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.4g", finding.figure);
  return std::string(buffer) + " " + finding.unit;
}

std::string verdict_text(const Report& report) {
  const auto counted = [&](Verdict verdict, const char* noun) {
    return count_text(static_cast<int>(report.count(verdict)), noun);
  };
  const std::string hints = report.count(Verdict::Hint) > 0 ? ", " + counted(Verdict::Hint, "hint") : "";
  return (report.faults() == 0 ? "no fault found" : counted(Verdict::Fault, "fault") + " found") + hints;
}

/// Lines of at most `width` characters, all after the first indented.
std::string wrapped(const std::string& words, std::size_t indent) {
  constexpr std::size_t width = 100;
  std::string lines;
  std::size_t column = indent;
  std::istringstream stream(words);
  for (std::string word; stream >> word; column += word.size() + 1) {
    if (column > indent && column + word.size() > width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      lines += " ";
    }
    lines += word;
  }
  return lines;
}

constexpr std::size_t name_width = 18;

const char* mark(Verdict verdict) {
  if (verdict == Verdict::Fault) return "\nFAULT  ";
  if (verdict == Verdict::Hint) return "\nHINT   ";
  return verdict == Verdict::Fine ? "fine   " : "?      ";
}

std::string padded(std::string name) {
  name.resize(std::max(name_width, name.size() + 1), ' ');
  return name;
}

}  // namespace

std::string text_report(const Report& report) {
  std::string out = padded("check") + report.folder + ": " + verdict_text(report) + "; looked at " +
                    count_text(static_cast<int>(report.looked_at), "frame") + " of " +
                    text(static_cast<int>(report.frames)) + "\n";
  for (const Finding& finding : report.findings) {
    const bool advised = finding.verdict == Verdict::Fault || finding.verdict == Verdict::Hint;
    out += mark(finding.verdict) + padded(finding.fault);
    const std::size_t indent = 7 + name_width;
    if (advised) out += figure(finding) + "\n" + std::string(indent, ' ');
    out += wrapped(finding.words, indent) + "\n";
    if (advised) out += std::string(indent, ' ') + wrapped("What to do: " + finding.advice, indent) + "\n\n";
  }
  return out;
}

std::string html_report(const Report& report) {
  using page::escaped;
  std::string out = "<!DOCTYPE html>\n<html lang=\"en\"><meta charset=\"utf-8\"><title>Check of " +
                    escaped(report.folder) + "</title>\n<style>\n" + std::string(page::style_css) +
                    "td { white-space: normal; text-align: left; vertical-align: top; }\n"
                    "tr.fault td:first-child { color: var(--bad); font-weight: 650; }\n</style>\n<main>\n<h1>" +
                    escaped(report.folder) + ": " + verdict_text(report) + "</h1>\n<p>Looked at " +
                    count_text(static_cast<int>(report.looked_at), "frame") + " of " +
                    text(static_cast<int>(report.frames)) +
                    ".</p>\n<div class=\"card scroll\"><table>\n<tr><th>what</th><th>verdict</th><th>figure</th>"
                    "<th>found</th><th>what to do</th></tr>\n";
  for (const Finding& finding : report.findings) {
    out += finding.verdict == Verdict::Fault ? "<tr class=\"fault\">" : "<tr>";
    for (const std::string& cell :
         {finding.fault, std::string(to_string(finding.verdict)), figure(finding), finding.words, finding.advice})
      out += "<td>" + escaped(cell) + "</td>";
    out += "</tr>\n";
  }
  return out + "</table></div>\n</main>\n</html>\n";
}

std::string json_report(const Report& report) {
  using page::Json;
  Json findings = Json::array();
  for (const Finding& finding : report.findings)
    findings.push(Json::object({{"fault", finding.fault},
                                {"verdict", to_string(finding.verdict)},
                                {"figure", finding.figure},
                                {"unit", finding.unit},
                                {"words", finding.words},
                                {"advice", finding.advice}}));
  std::ostringstream out;
  Json::object({{"folder", report.folder},
                {"frames", static_cast<long>(report.frames)},
                {"looked_at", static_cast<long>(report.looked_at)},
                {"faults", static_cast<long>(report.faults())},
                {"hints", static_cast<long>(report.count(Verdict::Hint))},
                {"findings", findings}})
      .write(out);
  out << "\n";
  return out.str();
}

}  // namespace check
