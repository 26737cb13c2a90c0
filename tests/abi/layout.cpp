// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

// Prints the layout of every type in the interface of dot::Tracker: size and alignment, then for each member its
// offset, its size, and f, i, u, b, e or s for floating point, signed, unsigned, bool, enum and everything else; then
// each enum with its values. It is the same for all compilers on 64-bit Linux whose standard library is GCC's. Compared
// with src/abi/layout.txt, which ./dev.sh abi accept writes.

#include <cstdio>
#include <string_view>
#include <type_traits>
#include <utility>

#include "dot/pipeline/exclusion.hpp"
#include "dot/tracker.hpp"

namespace {

/// Converts to whatever a member is.
struct Anything {
  template <typename T>
  operator T() const {
    return T();
  }
};
template <std::size_t>
using AnythingAt = Anything;

template <typename T, std::size_t... I>
auto has_members(std::index_sequence<I...>) -> decltype(T{AnythingAt<I>()...}, std::true_type());
template <typename T>
std::false_type has_members(...);

/// The number of members of the aggregate T.
template <typename T, std::size_t n = 64>
constexpr int member_count() {
  if constexpr (decltype(has_members<T>(std::make_index_sequence<n>()))::value)
    return n;
  else
    return member_count<T, n - 1>();
}

template <typename T>
constexpr char kind() {
  if (std::is_same_v<T, bool>) return 'b';
  if (std::is_floating_point_v<T>) return 'f';
  if (std::is_enum_v<T>) return 'e';
  if (!std::is_integral_v<T>) return 's';
  return std::is_signed_v<T> ? 'i' : 'u';
}

/// Prints one type; a member that is not listed is an error.
template <typename T>
class Layout {
 public:
  explicit Layout(const char* name) : name_(name) { std::printf("%s %zu %zu\n", name, sizeof(T), alignof(T)); }
  template <typename M>
  Layout& member(const char* name, M T::*which) {
    const T object{};
    const auto offset = reinterpret_cast<const char*>(&(object.*which)) - reinterpret_cast<const char*>(&object);
    std::printf("%s.%s %td %c%zu\n", name_, name, offset, kind<M>(), sizeof(M));
    ++listed_;
    return *this;
  }
  int missing() const { return member_count<T>() - listed_; }

 private:
  const char* name_;
  int listed_ = 0;
};

int failures = 0;

/// The enumerator as the compiler spells it, e.g. dot::State::Moving, or (dot::State)4 where the value has no name.
template <auto value>
constexpr std::string_view spelling() {
  constexpr std::string_view function = __PRETTY_FUNCTION__;
  constexpr std::string_view before = "value = ";
  constexpr std::size_t begin = function.find(before) + before.size();
  return function.substr(begin, function.find_first_of(";]", begin) - begin);
}

template <typename E, int value = 0>
void print_values() {
  constexpr std::string_view name = spelling<static_cast<E>(value)>();
  if constexpr (name.find(')') == std::string_view::npos) {
    std::printf("%.*s %d\n", static_cast<int>(name.size()), name.data(), value);
    print_values<E, value + 1>();
  }
}
template <typename E>
void print_enum(const char* name) {
  std::printf("%s %c%zu\n", name, kind<std::underlying_type_t<E>>(), sizeof(E));
  print_values<E>();
}

}  // namespace

// BEGIN(T) M(member)... END: one type.
#define BEGIN(T)                      \
  {                                   \
    using Type = T;                   \
    const char* const type_name = #T; \
    Layout<Type> layout(type_name);
#define M(name) layout.member(#name, &Type::name);
#define END                                                                            \
  if (layout.missing() != 0) {                                                         \
    std::fprintf(stderr, "%s has members that layout.cpp does not list\n", type_name); \
    ++failures;                                                                        \
  }                                                                                    \
  }

int main() {
  using namespace dot;  // NOLINT(google-build-using-namespace)
  using View8 = ImageView<const std::uint8_t>;
  using View32 = ImageView<const std::uint32_t>;
  using Objects = Span<ObjectResult>;
  using Revisions = Span<CameraRevision>;
  using Instances = Span<Instance>;

  std::printf("dot::Tracker %zu %zu\n", sizeof(Tracker), alignof(Tracker));
  std::printf("dot::ThreadPool %zu %zu\n", sizeof(ThreadPool), alignof(ThreadPool));

  // clang-format off
  // In.
  BEGIN(Intrinsics) M(fx) M(fy) M(cx) M(cy) M(width) M(height) M(baseline) END
  BEGIN(ImageRef) M(data) M(width) M(height) M(stride) M(format) M(depth_units_per_metre) END
  BEGIN(Instance) M(id) M(mask) M(x) M(y) M(class_id) M(score) M(always_dynamic) END
  BEGIN(Instances) M(data) M(size) END
  BEGIN(Masks) M(ids) M(instances) END
  BEGIN(CameraMotion) M(T_cur_prev) M(covariance) END
  BEGIN(Frame) M(id) M(timestamp) M(image) M(depth) M(masks) M(camera_motion) M(camera_prior) END

  // Out.
  BEGIN(View8) M(data) M(width) M(height) M(stride) END
  BEGIN(View32) M(data) M(width) M(height) M(stride) END
  BEGIN(Objects) M(data) M(size) END
  BEGIN(CameraResult)
    M(status) M(T_cur_prev) M(covariance) M(phi) M(gain) M(offset) M(residual_sigma) M(reduced_chi2) M(n_points)
    M(n_inliers)
  END
  BEGIN(ObjectResult)
    M(id) M(state) M(reason) M(always_dynamic) M(segmented) M(discovered) M(instance_id) M(class_id) M(score) M(box)
    M(area) M(p_moving) M(last_decided) M(T_o) M(covariance) M(velocity) M(velocity_covariance) M(speed)
    M(angular_velocity) M(angular_covariance) M(point_speed) M(point_speed_sigma) M(phi) M(disparity_px)
    M(disparity_noise_px) M(entropy) M(range) M(interval) M(n_points) M(n_inliers) M(fused_velocity) M(fused_covariance)
  END
  BEGIN(Revisions) M(data) M(size) END
  BEGIN(CameraRevision) M(frame_id) M(timestamp) M(T_cur_prev) M(covariance) END
  BEGIN(Diagnosis) M(reason) M(figure) END
  BEGIN(Result)
    M(frame_id) M(timestamp) M(interval) M(too_little_depth) M(disparity_bias_px) M(diagnosis) M(camera) M(revised)
    M(labels) M(ids) M(objects) M(small_instances) M(stage_ms)
  END
  BEGIN(ExclusionPolicy) M(exclude_not_observable) M(exclude_static) M(dilation) END

  // Settings.
  BEGIN(SelectionSettings)
    M(background_points) M(object_points) M(min_object_pixels) M(min_depth_share) M(min_gradient) M(object_gradient)
    M(max_depth) M(window_radius)
  END
  BEGIN(AlignSettings)
    M(max_levels) M(max_iterations) M(huber) M(tukey) M(gradient_noise) M(min_intensity_sigma) M(outlier) M(gradient)
    M(kernel)
  END
  BEGIN(CameraSettings)
    M(min_points) M(min_phi) M(min_phi_unexpected) M(min_margin) M(min_inliers) M(multistart_margin) M(search_speed)
    M(search_turn) M(max_acceleration) M(multistart_shift) M(covariance_scale)
  END
  BEGIN(DepthNoiseSettings)
    M(source) M(stereo_sigma_px) M(stereo_shared_px) M(stereo_bias_px) M(rgbd_sigma) M(rgbd_shared) M(lidar_sigma)
    M(lidar_relative) M(lidar_shared) M(unknown_relative)
  END
  BEGIN(ObjectSettings)
    M(min_points) M(min_visible) M(min_phi) M(min_phi_expected) M(min_inliers) M(min_inlier_share)
    M(min_depth_agreement) M(max_speed) M(max_acceleration) M(search_speed) M(reference_seconds) M(max_fitted)
  END
  BEGIN(MotionPriorSettings) M(rotation) M(velocity) M(gain) M(offset) M(ground_vehicle) M(up_x) M(up_y) M(up_z) END
  BEGIN(VelocitySettings)
    M(v0) M(v0_per_square_metre) M(photometric_scale) M(rotation_scale) M(floor) M(floor_per_square_metre) M(decide)
    M(keep) M(switch_rate) M(prior_speed) M(prior_speed_per_metre) M(prior_turn) M(most_turning) M(acceleration)
    M(acceleration_per_metre) M(tail_share) M(tail_variance) M(outliers) M(max_evidence_rate) M(max_evidence)
    M(max_log_odds)
  END
  BEGIN(EntropySettings) M(max_entropy) M(min_entropy) M(min_disparity) M(noise_factor) END
  BEGIN(MaskSettings)
    M(min_iou) M(min_containment) M(keep_seconds) M(late_seconds) M(late_frames) M(depth_tolerance) M(min_pixels)
    M(max_instances)
  END
  BEGIN(Options)
    M(selection) M(align) M(camera) M(depth_noise) M(object) M(motion_prior) M(classifier) M(velocity) M(entropy) M(mask)
    M(max_gap) M(threads) M(discover_unknown)
  END
  print_enum<State>("State");
  // clang-format on
  print_enum<Reason>("Reason");
  print_enum<CameraStatus>("CameraStatus");
  print_enum<Suspicion>("Suspicion");
  print_enum<Stage>("Stage");
  print_enum<PixelFormat>("PixelFormat");
  print_enum<DepthSource>("DepthSource");
  print_enum<KernelVariant>("KernelVariant");
  print_enum<GradientSource>("GradientSource");
  print_enum<ClassifierKind>("ClassifierKind");
  return failures;
}
