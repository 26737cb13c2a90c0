// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "check.hpp"

#include <algorithm>
#include <utility>

#include "measures.hpp"

namespace check {
namespace {

/// Faults before hints before what is fine before what is not known.
int rank(Verdict verdict) {
  if (verdict == Verdict::Fault) return 0;
  if (verdict == Verdict::Hint) return 1;
  return verdict == Verdict::Fine ? 2 : 3;
}

/// Two measures of one thing count as one: what is certain before what is not.
void merge(Findings& all, Findings more) {
  for (Finding& finding : more) {
    const auto known =
        std::find_if(all.begin(), all.end(), [&](const Finding& other) { return other.fault == finding.fault; });
    if (known == all.end())
      all.push_back(std::move(finding));
    else if (rank(finding.verdict) < rank(known->verdict))
      *known = std::move(finding);
  }
}

/// Of disparities that were given as depth the steps look like a unit, and near things like far ones.
void forget_scale_of_disparity(Findings& all) {
  const auto inverse =
      std::find_if(all.begin(), all.end(), [](const Finding& finding) { return finding.fault == "depth-inverse"; });
  if (inverse == all.end() || inverse->verdict != Verdict::Fault) return;
  for (Finding& finding : all)
    for (const char* const name : {"depth-unit", "focal-baseline", "disparity-bias", "depth-offset"})
      if (finding.fault == name) finding = unknown(name, "The depth looks like disparity.");
}

}  // namespace

std::size_t Report::count(Verdict verdict) const {
  return static_cast<std::size_t>(
      std::count_if(findings.begin(), findings.end(), [&](const Finding& f) { return f.verdict == verdict; }));
}

Report check_recording(const runner::SequenceOptions& options) {
  const Samples samples = read_samples(options);
  Report report{options.folder.string(), samples.recording.entries.size(), samples.frames.size(), {}};
  for (const auto measure : {check_clock, check_repeats, check_amounts, check_registration, check_principal_point,
                             check_pair, check_depth_scale, check_depth_inverse, check_depth_saturation, check_masks,
                             check_masks_cover, check_missing_masks, check_exposure, check_blur, check_fixed_parts})
    merge(report.findings, measure(samples));
  forget_scale_of_disparity(report.findings);
  std::stable_sort(report.findings.begin(), report.findings.end(),
                   [](const Finding& a, const Finding& b) { return rank(a.verdict) < rank(b.verdict); });
  return report;
}

}  // namespace check
