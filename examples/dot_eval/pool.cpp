// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "pool.hpp"

#include <algorithm>
#include <cmath>

namespace eval {
namespace {

/// Mask IoU of a sequence at the first rate; not a number where there is none.
double first_iou(const std::vector<RunScore>& runs, const std::string& name, int first_rate) {
  for (const RunScore& run : runs)
    if (run.name == name && run.every == first_rate && run.objects) return run.objects->mask_iou();
  return not_a_number;
}

/// Values that are numbers.
void keep(std::vector<double>& list, double value) {
  if (std::isfinite(value)) list.push_back(value);
}

double least(const std::vector<double>& values) { return percentile(values, 0); }
double largest(const std::vector<double>& values) { return percentile(values, 100); }

/// Median over the two nearest bands.
double near_median(const std::array<Band, band_count>& bands, std::vector<double> Band::*figure) {
  std::vector<double> values = bands[0].*figure;
  values.insert(values.end(), (bands[1].*figure).begin(), (bands[1].*figure).end());
  return median(std::move(values));
}

}  // namespace

Pooled pool(const std::vector<RunScore>& runs, int every, int first_rate) {
  Pooled p;
  p.every = every;
  std::vector<double> ious, ratios, instance_ious, speed, sigma, motion, rpe_median, rpe, rpe_max, rot, ate, nees;
  std::vector<double> ms, median_ms, p99_ms, largest_ms, second_ms;
  for (const RunScore& run : runs) {
    if (run.every != every) continue;
    ++p.runs;
    if (!run.error.empty()) {
      ++p.failed;
      continue;
    }
    const FrameTime time = frame_time(run.frame_ms);
    keep(ms, time.mean);
    keep(median_ms, time.median);
    keep(p99_ms, time.p99);
    keep(largest_ms, time.largest);
    keep(second_ms, time.second);
    if (std::isfinite(time.mean))
      for (std::size_t i = 0; i < stage_count; ++i) p.stage_ms[i] += run.stage_ms[i];
    p.latency.insert(p.latency.end(), run.latency.begin(), run.latency.end());
    if (run.hidden) p.hidden.add(*run.hidden);
    if (run.camera) {
      keep(rpe_median, run.camera->rpe_trans_median_cm());
      keep(rpe, run.camera->rpe_trans_cm());
      keep(rpe_max, run.camera->rpe_trans_max_cm());
      keep(rot, run.camera->rpe_rot_median_deg());
      keep(ate, run.camera->ate_m);
      keep(nees, run.camera->nees_per_axis());
    }
    if (!run.objects) continue;
    const ObjectScore& objects = *run.objects;
    p.confusion.add(objects.confusion);
    for (std::size_t i = 0; i < band_count; ++i) p.bands[i].add(objects.bands[i]);
    for (std::size_t i = 0; i < speed_count; ++i)
      for (std::size_t b = 0; b <= band_count; ++b)
        for (std::size_t answer = 0; answer < answer_count; ++answer)
          p.by_speed[i][b][answer] += objects.by_speed[i][b][answer];
    if (objects.moving_pixels() > 0) {
      keep(ious, objects.mask_iou());
      keep(ratios, ratio(objects.mask_iou(), first_iou(runs, run.name, first_rate)));
    }
    instance_ious.insert(instance_ious.end(), objects.instance_iou.begin(), objects.instance_iou.end());
    p.turning.add(objects.turning);
    p.id_switches += objects.id_switches;
    keep(speed, objects.speed_coverage());
    keep(sigma, objects.sigma_coverage());
    keep(motion, objects.motion_coverage());
  }
  for (double& stage : p.stage_ms) stage = ratio(stage, static_cast<double>(ms.size()));
  p.frame_time = {mean(ms), mean(median_ms), largest(p99_ms), largest(largest_ms), largest(second_ms)};
  p.mask_iou = mean(ious);
  p.iou_ratio_mean = mean(ratios);
  p.iou_ratio_min = least(ratios);
  p.instance_iou = mean(instance_ious);
  p.near_speed_error = near_median(p.bands, &Band::moving_speed_error);
  p.near_motion_error_m = near_median(p.bands, &Band::motion_error_m);
  p.near_motion_error_deg = near_median(p.bands, &Band::motion_error_deg);
  p.speed_coverage = least(speed);
  p.sigma_coverage = least(sigma);
  p.motion_coverage = least(motion);
  p.rpe_trans_median_cm = largest(rpe_median);
  p.rpe_trans_cm = largest(rpe);
  p.rpe_trans_max_cm = largest(rpe_max);
  p.rpe_rot_median_deg = largest(rot);
  p.ate_m = largest(ate);
  p.camera_nees = median(nees);
  return p;
}

}  // namespace eval
