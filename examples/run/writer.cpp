// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "writer.hpp"

#include <cmath>
#include <cstddef>
#include <iomanip>
#include <limits>
#include <opencv2/core.hpp>
#include <stdexcept>
#include <string>
#include <system_error>

#include "dot/image/opencv.hpp"
#include "dot/pipeline/exclusion.hpp"
#include "old_results.hpp"
#include "overlay.hpp"
#include "sequence/errors.hpp"
#include "sequence/images.hpp"
#include "sequence/text.hpp"

namespace runner {
namespace fs = std::filesystem;

namespace {

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) throw FileError(folder.string() + ": the folder cannot be made");
}

/// A label pixel must be the state that objects.csv gives for its id.
void check_labels(const dot::Result& result) {
  const dot::ObjectResult* object = nullptr;
  for (int y = 0; y < result.labels.height; ++y) {
    for (int x = 0; x < result.labels.width; ++x) {
      const std::uint32_t id = result.ids(x, y);
      const auto label = static_cast<dot::State>(result.labels(x, y));
      if (id == 0 && label == dot::State::Background) continue;
      if (object == nullptr || object->id != id) object = result.find(id);
      if (id == 0 || object == nullptr || object->state != label)
        throw std::runtime_error("frame " + std::to_string(result.frame_id) + ": the label at pixel " +
                                 std::to_string(x) + ", " + std::to_string(y) + " contradicts the state of track " +
                                 std::to_string(id));
    }
  }
}

cv::Mat ids_16_bit(const dot::Result& result) {
  const cv::Mat ids = dot::to_mat(result.ids);
  double largest = 0;
  cv::minMaxLoc(ids, nullptr, &largest);
  if (largest > std::numeric_limits<std::uint16_t>::max())
    throw std::runtime_error("frame " + std::to_string(result.frame_id) + ": track id " +
                             std::to_string(static_cast<std::int64_t>(largest)) +
                             " does not fit the 16 bits of instances/. Do many small masks come and go? Raise "
                             "mask.min_pixels, or split the recording");
  cv::Mat ids16;
  ids.convertTo(ids16, CV_16U);
  return ids16;
}

double sigma(const std::array<double, 9>& covariance, std::size_t axis) { return std::sqrt(covariance[4 * axis]); }

void write_object(std::ostream& out, int frame, const dot::ObjectResult& o) {
  const bool measured = o.reason == dot::Reason::None;
  // What a frame did not measure stays empty: a zero would be a statement.
  const auto optional_field = [&](double value, bool exists) {
    out << ',';
    if (exists) out << value;
  };
  const auto field = [&](double value) { optional_field(value, measured); };
  out << frame << ',' << o.id << ',' << dot::to_string(o.state);
  field(o.speed);
  out << ',' << o.p_moving;
  field(o.disparity_px);
  field(o.entropy);
  field(o.phi);
  out << ',' << o.n_points;
  for (const double v : o.velocity) field(v);
  for (std::size_t axis = 0; axis < 3; ++axis) field(sigma(o.velocity_covariance, axis));
  for (const double element : o.T_o) field(element);
  out << ',' << dot::to_string(o.reason);
  out << ',' << o.n_inliers;
  field(o.disparity_noise_px);
  field(o.range);
  field(o.interval);
  const bool fused = o.fused_covariance[0] > 0;
  for (const double v : o.fused_velocity) optional_field(v, fused);
  for (std::size_t axis = 0; axis < 3; ++axis) optional_field(sigma(o.fused_covariance, axis), fused);
  out << ',' << o.area << ',' << o.class_id << ',' << o.segmented << ',' << o.always_dynamic << ',' << o.discovered;
  field(o.point_speed);
  field(o.point_speed_sigma);
  for (const double w : o.angular_velocity) field(w);
  for (std::size_t axis = 0; axis < 3; ++axis) field(sigma(o.angular_covariance, axis));
  out << '\n';
}

constexpr const char* object_columns =
    "frame,track_id,state,speed_mps,p_moving,disparity_px,entropy,phi,n_points,vx,vy,vz,sigma_vx,sigma_vy,sigma_vz,"
    "T00,T01,T02,T03,T10,T11,T12,T13,T20,T21,T22,T23,reason,"
    "n_inliers,disparity_noise_px,range_m,interval_s,fused_vx,fused_vy,fused_vz,"
    "sigma_fused_vx,sigma_fused_vy,sigma_fused_vz,pixels,class,segmented,always_dynamic,discovered,"
    "point_speed_mps,sigma_point_speed,wx,wy,wz,sigma_wx,sigma_wy,sigma_wz\n";

constexpr std::size_t stage_count = static_cast<std::size_t>(dot::Stage::Count);

}  // namespace

ResultWriter::ResultWriter(const OutputOptions& options, const fs::path& sequence) : options_(options) {
  make_folder(options_.out);
  std::error_code error;
  if (fs::equivalent(options_.out, sequence, error))
    throw UsageError("--out must not be the sequence's own folder, " + sequence.string());
  remove_old_results(options_.out);
  timing_.emplace(options_.out / ResultNames::timing);
  timing_->stream() << std::fixed << std::setprecision(3) << "frame";
  for (std::size_t i = 0; i < stage_count; ++i)
    timing_->stream() << ',' << dot::to_string(static_cast<dot::Stage>(i)) << "_ms";
  timing_->stream() << ",total_ms\n";
  timing_->flush();
  camera_.emplace(options_.out / ResultNames::camera);
  camera_->stream() << std::setprecision(15);
  objects_.emplace(options_.out / ResultNames::objects);
  objects_->stream() << std::setprecision(10) << object_columns;

  make_folder(options_.out / "labels");
  make_folder(options_.out / "instances");
  if (options_.overlay) make_folder(options_.out / "overlay");
  if (options_.masks_out.empty()) return;
  remove_old_masks(options_.masks_out);
  for (const char* const folder : ResultNames::masks) make_folder(options_.masks_out / folder);
}

void ResultWriter::write(const SequenceFrame& frame, const dot::Result& result, double total_ms) {
  check_labels(result);
  write_images(frame, result, total_ms);
  if (!options_.masks_out.empty()) write_masks(frame, result);

  T_world_camera_ = T_world_camera_ * dot::SE3d::from_row_major(result.camera.T_cur_prev).inverse();
  const std::array<double, 12> pose = T_world_camera_.row_major();
  for (std::size_t i = 0; i < pose.size(); ++i) camera_->stream() << (i > 0 ? " " : "") << pose[i];
  camera_->stream() << '\n';
  camera_->flush();

  for (const dot::ObjectResult& object : result.objects) write_object(objects_->stream(), frame.number, object);
  objects_->flush();

  write_revised(result);

  timing_->stream() << frame.number;
  for (const double ms : result.stage_ms) timing_->stream() << ',' << ms;
  timing_->stream() << ',' << total_ms << '\n';
  timing_->flush();
}

void ResultWriter::finish() {
  if (revised_) revised_->finish();
  for (std::optional<OutputFile>* const table : {&camera_, &objects_, &timing_}) (*table)->finish();
}

void ResultWriter::write_images(const SequenceFrame& frame, const dot::Result& result, double total_ms) {
  const std::string name = frame_name(frame.number);
  write_image(options_.out / "labels" / name, dot::to_mat(result.labels));
  write_image(options_.out / "instances" / name, ids_16_bit(result));
  if (options_.overlay) write_image(options_.out / "overlay" / name, draw_overlay(frame, result, total_ms));
}

void ResultWriter::write_revised(const dot::Result& result) {
  if (result.revised.empty()) return;
  if (!revised_) {
    revised_.emplace(options_.out / ResultNames::revised);
    revised_->stream() << std::setprecision(15);
  }
  for (const dot::CameraRevision& revision : result.revised) {
    revised_->stream() << revision.frame_id;
    for (const double element : revision.T_cur_prev) revised_->stream() << ' ' << element;
    revised_->stream() << '\n';
  }
  revised_->flush();
}

void ResultWriter::write_masks(const SequenceFrame& frame, const dot::Result& result) {
  const std::string name = frame_name(frame.number);
  exclusion_.resize(result.labels.width, result.labels.height);
  dot::exclusion_mask(result, dot::ExclusionPolicy{}, exclusion_.view());
  write_image(options_.masks_out / "mask_dot" / name, dot::mat(exclusion_.view()));
  write_image(options_.masks_out / "mask_all" / name, dot::to_mat(result.labels) != 0);
}

}  // namespace runner
