// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "summary.hpp"

#include "sequence/text.hpp"

namespace dataset {
namespace {

/// A field as RFC 4180 has it.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace

const char* to_string(Status status) {
  if (status == Status::Complete) return "complete";
  return status == Status::Failed ? "failed" : "interrupted";
}

std::string summary_csv(const std::vector<Outcome>& outcomes) {
  std::string text = "name,sequence,status,frames,moving,static,undecided,camera_lost,ms_per_frame,reason\n";
  for (const Outcome& o : outcomes) {
    text += field(o.item.name) + ',' + field(o.item.folder.string()) + ',' + to_string(o.status) + ',';
    if (o.status == Status::Complete) {
      for (const int count :
           {o.figures.frames, o.figures.moving, o.figures.standing, o.figures.undecided, o.figures.camera_lost})
        text += std::to_string(count) + ',';
      text += runner::format("%.3f", o.figures.ms_per_frame) + ',';
    } else {
      text += ",,,,,,";
    }
    text += field(o.reason) + '\n';
  }
  return text;
}

}  // namespace dataset
