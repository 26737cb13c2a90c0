// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#include "dot/tracker.hpp"

#include <stdexcept>
#include <utility>
#include <variant>

#include "dot/dot.hpp"
#include "dot/kernel/dispatch.hpp"

namespace dot {

namespace {

/// The classifier chosen at run time.
struct ChosenClassifier {
  std::variant<VelocityClassifier, EntropyClassifier> policy;

  struct Memory {
    VelocityClassifier::Memory velocity;
    EntropyClassifier::Memory entropy;
  };

  Decision operator()(Memory& m, const MotionEstimate* fit, const Matrix3<double>& R_cur_prev, double dt) const {
    if (const auto* entropy = std::get_if<EntropyClassifier>(&policy))
      return (*entropy)(m.entropy, fit, R_cur_prev, dt);
    return std::get<VelocityClassifier>(policy)(m.velocity, fit, R_cur_prev, dt);
  }
};

}  // namespace

struct Tracker::Impl {
  Dot<Pinhole, ChosenClassifier> pipeline;

  Impl(const Intrinsics& camera, const Options& options) : pipeline(Pinhole(camera), options) {
    pipeline.aligner.reduction.kernels = find_kernels(options.align.kernel);
    if (!pipeline.aligner.reduction.kernels)
      throw std::invalid_argument("align.kernel must be one that this machine and this build have");
    if (options.classifier == ClassifierKind::Velocity)
      pipeline.classifier.policy = VelocityClassifier{options.velocity};
    else
      pipeline.classifier.policy =
          EntropyClassifier{options.entropy, options.classifier == ClassifierKind::EntropyLiteral};
  }
};

Tracker::Tracker(const Intrinsics& camera, const Options& options) : impl_(std::make_unique<Impl>(camera, options)) {}
Tracker::~Tracker() = default;
Tracker::Tracker(Tracker&&) noexcept = default;
Tracker& Tracker::operator=(Tracker&&) noexcept = default;

const Result& Tracker::track(const Frame& frame) { return impl_->pipeline.track(frame); }
const Result& Tracker::label(const Frame& frame) { return impl_->pipeline.label(frame); }
void Tracker::prepare() { impl_->pipeline.prepare(); }
void Tracker::submit_masks(std::uint64_t frame_id, const Masks& masks) {
  impl_->pipeline.submit_masks(frame_id, masks);
}
void Tracker::reset() noexcept { impl_->pipeline.reset(); }
void Tracker::set_pool(ThreadPool pool) { impl_->pipeline.threads.pool = std::move(pool); }
const Options& Tracker::options() const { return impl_->pipeline.options(); }

}  // namespace dot
