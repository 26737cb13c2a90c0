// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT

/// Fuzzes the readers of recordings and of configuration files. The first byte of an input chooses the file, 'a' for
/// the first of `targets`; the rest is its content, in a recording that is good otherwise. A FileError is an answer;
/// any other exception is a fault, and so is nonsense that was accepted.

#include <Eigen/LU>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <opencv2/core/utils/logger.hpp>
#include <string>

#include "run/config.hpp"
#include "sequence/coco_masks.hpp"
#include "sequence/errors.hpp"
#include "sequence/images.hpp"
#include "sequence/instance_list.hpp"
#include "sequence/sequence.hpp"

namespace {

namespace fs = std::filesystem;
using namespace runner;

const cv::Size size(8, 6);
const std::string still = "1 0 0 0 0 1 0 0 0 0 1 0\n";

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "accepted: %s\n", what);
  std::abort();
}

// --- What was read must make sense -----------------------------------------------------------------------------------

bool between(double value, double least, double most) { return value >= least && value <= most; }

void check_pose(const Eigen::Matrix4d& T) {
  require(T.allFinite() && T.topRightCorner<3, 1>().norm() < 1e11, "a pose that is nowhere");
  const Eigen::Matrix3d R = T.topLeftCorner<3, 3>();
  require((R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 0.01 && R.determinant() > 0, "no rotation");
}

void check_camera(const dot::Intrinsics& camera) {
  require(between(camera.fx, 1, 1e6) && between(camera.fy, 1, 1e6), "a focal length");
  require(between(camera.cx, -1e5, 1e5) && between(camera.cy, -1e5, 1e5), "a centre of the image");
  require(between(camera.baseline, 0, 1000), "a baseline");
  require(cv::Size(camera.width, camera.height) == size, "an image size");
}

void check_recording(const Recording& recording) {
  check_camera(recording.intrinsics);
  double last = -1e300;
  for (const RecordingEntry& entry : recording.entries) {
    require(std::abs(entry.timestamp) < 1e13 && entry.timestamp > last, "a time");
    last = entry.timestamp;
    require(entry.depth.empty() != entry.right.empty(), "not one source of depth");
    if (entry.truth.camera) check_pose(*entry.truth.camera);
    for (const auto& [id, pose] : entry.truth.poses) {
      require(between(id, 1, 65535), "an object's id");
      check_pose(pose);
    }
    for (const auto& [id, object] : entry.truth.objects)
      require(between(id, 1, 65535) && std::isfinite(object.speed), "an object");
  }
}

// --- How a file is fed to its reader ---------------------------------------------------------------------------------

void open(const fs::path& folder, const fs::path& /*file*/) {
  SequenceOptions options;
  options.folder = folder;
  options.truth = true;
  check_recording(Sequence(options).recording());
}

void read_motion(const fs::path& folder, const fs::path& file) {
  SequenceOptions options;
  options.folder = folder;
  options.camera = file;
  const SequenceFrame frame = Sequence(options).read(1);
  check_pose(pose_from_row_major(frame.camera_motion->T_cur_prev.data()));
}

void read_list(const fs::path& /*folder*/, const fs::path& file) {
  for (const dot::Instance& instance : read_instances(file, {"person"}))
    require(between(instance.id, 1, 65535) && std::isfinite(instance.score), "an instance");
}

void read_settings(const fs::path& /*folder*/, const fs::path& file) {
  dot::Options options;
  read_config(file, options);
  require(between(options.threads, 1, 256), "a number of threads");
  dot::for_each_option(options, [](const char* name, auto value) { require(std::isfinite(double(value)), name); });
}

void read_picture(const fs::path& /*folder*/, const fs::path& file) {
  require(read_image(file, size).size() == size, "a size of an image");
}

void read_ids(const fs::path& /*folder*/, const fs::path& file) {
  require(read_indices(file, size).size() == size, "a size of an image of ids");
}

void read_coco(const fs::path& /*folder*/, const fs::path& file) {
  const CocoMasks coco(file);
  for (const char* const name : {"000000.png", "000001.png"}) {
    if (!coco.has(name)) continue;
    const Segmentation masks = coco.read(name, size, {"person"});
    double largest = 0;
    cv::minMaxLoc(masks.ids, nullptr, &largest);
    require(masks.ids.size() == size, "a size of masks");
    require(largest <= static_cast<double>(masks.instances.size()), "an id of no instance");
    for (const dot::Instance& instance : masks.instances) require(std::isfinite(instance.score), "a score");
  }
}

void open_named(const fs::path& folder, const fs::path& file) {
  SequenceOptions options;
  options.folder = folder;
  options.images = "rgb";
  options.intrinsics = file.filename();
  check_recording(Sequence(options).recording());
}

// --- Recordings of two frames, one of each layout --------------------------------------------------------------------

void text(const fs::path& path, const std::string& content) {
  fs::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << content;
}

void images(const fs::path& folder, const std::string& name, int type) {
  fs::create_directories(folder);
  for (const char* const digit : {"0", "1"})
    write_image(folder / (name + digit + ".png"), cv::Mat(size, type, cv::Scalar(1)));
}

void make_own(const fs::path& folder) {
  images(folder / "rgb", "00000", CV_8UC1);
  images(folder / "depth", "00000", CV_16UC1);
  images(folder / "instance", "00000", CV_8UC1);
  text(folder / "intrinsics.txt", "36 36 3.5 2.5 8 6 0.5 10\n");
  text(folder / "objects.csv", "frame,id,moving,speed_mps\n");
}

void make_kitti(const fs::path& folder) {
  images(folder / "image_2", "00000", CV_8UC1);
  images(folder / "depth", "00000", CV_16UC1);
  text(folder / "calib.txt", "P2: 36 0 3.5 0 0 36 2.5 0 0 0 1 0\nP3: 36 0 3.5 -18 0 36 2.5 0 0 0 1 0\n");
  text(folder / "times.txt", "0\n0.1\n");
}

void make_raw(const fs::path& folder) {
  for (const char* const camera : {"image_02", "image_03"}) images(folder / camera / "data", "000000000", CV_8UC1);
  text(folder / "image_02/timestamps.txt", "2011-09-26 13:02:25.9\n2011-09-26 13:02:26.0\n");
  text(folder / "calib_cam_to_cam.txt",
       "R_rect_00: 1 0 0 0 1 0 0 0 1\nP_rect_02: 36 0 3.5 0 0 36 2.5 0 0 0 1 0\n"
       "P_rect_03: 36 0 3.5 -18 0 36 2.5 0 0 0 1 0\n");
  for (const char* const name : {"calib_imu_to_velo.txt", "calib_velo_to_cam.txt"})
    text(folder / name, "R: 1 0 0 0 1 0 0 0 1\nT: 0 0 0\n");
  for (const char* const name : {"0000000000.txt", "0000000001.txt"})
    text(folder / "oxts/data" / name, "49 8.4 116 0 0 0\n");
}

void make_vkitti2(const fs::path& folder) {
  images(folder / "frames/rgb/Camera_0", "rgb_0000", CV_8UC1);
  text(folder / "intrinsic.txt", "cameraID K[0,0] K[1,1] K[0,2] K[1,2]\n0 36 36 3.5 2.5\n");
  text(folder / "extrinsic.txt",
       "frame cameraID r1,1 r1,2 r1,3 t1 r2,1 r2,2 r2,3 t2 r3,1 r3,2 r3,3 t3\n0 0 " + still + "1 0 " + still);
  text(folder / "pose.txt",
       "frame cameraID trackID camera_space_X camera_space_Y camera_space_Z rotation_camera_space_y "
       "rotation_camera_space_x rotation_camera_space_z\n0 0 1 0 0 9 0 0 0\n1 0 1 0 0 9 0 0 0\n");
  text(folder / "bbox.txt", "frame cameraID trackID isMoving\n0 0 1 True\n1 0 1 False\n");
}

void make_tum(const fs::path& folder) {
  images(folder / "rgb", "", CV_8UC1);
  text(folder / "rgb.txt", "1305031710.0 rgb/0.png\n1305031710.1 rgb/1.png\n");
  text(folder / "depth.txt", "1305031710.0 depth/0.png\n1305031710.1 depth/1.png\n");
  text(folder / "groundtruth.txt", "1305031710.0 0 0 0 0 0 0 1\n1305031710.2 0 0 0 0 0 0 1\n");
}

void make_nothing(const fs::path& /*folder*/) {}

struct Target {
  const char* file;
  void (*make)(const fs::path& folder);
  void (*feed)(const fs::path& folder, const fs::path& file);
};
constexpr Target targets[] = {{"intrinsics.txt", make_own, open},            // a
                              {"times.txt", make_own, open},                 // b
                              {"poses.txt", make_own, open},                 // c
                              {"objects.csv", make_own, open},               // d
                              {"object_poses.txt", make_own, open},          // e
                              {"camera.txt", make_own, read_motion},         // f
                              {"masks.csv", make_nothing, read_list},        // g
                              {"config", make_nothing, read_settings},       // h
                              {"image.png", make_nothing, read_picture},     // i
                              {"ids.png", make_nothing, read_ids},           // j
                              {"calib.txt", make_kitti, open},               // k
                              {"times.txt", make_kitti, open},               // l
                              {"poses.txt", make_kitti, open},               // m
                              {"calib_cam_to_cam.txt", make_raw, open},      // n
                              {"image_02/timestamps.txt", make_raw, open},   // o
                              {"oxts/data/0000000001.txt", make_raw, open},  // p
                              {"calib_imu_to_velo.txt", make_raw, open},     // q
                              {"intrinsic.txt", make_vkitti2, open},         // r
                              {"extrinsic.txt", make_vkitti2, open},         // s
                              {"pose.txt", make_vkitti2, open},              // t
                              {"bbox.txt", make_vkitti2, open},              // u
                              {"rgb.txt", make_tum, open},                   // v
                              {"depth.txt", make_tum, open},                 // w
                              {"groundtruth.txt", make_tum, open},           // x
                              {"coco.json", make_nothing, read_coco},        // y
                              {"camera.json", make_own, open_named}};        // z

/// A folder for each target, so that no file has to be put back; removed at the end.
class Folders {
 public:
  Folders() {
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    const fs::path memory = "/dev/shm";
    std::string name =
        ((fs::is_directory(memory) ? memory : fs::temp_directory_path()) / "dot_readers_XXXXXX").string();
    require(mkdtemp(name.data()) != nullptr, "no folder for temporary files");
    root_ = name;
    for (const Target& target : targets) target.make(of(target));
  }
  ~Folders() {
    std::error_code error;
    fs::remove_all(root_, error);
  }
  fs::path of(const Target& target) const { return root_ / std::to_string(&target - targets); }

 private:
  fs::path root_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t length) {
  static const Folders folders;
  if (length == 0) return 0;
  const std::size_t count = std::size(targets);
  const Target& target = targets[(data[0] + 'a' * (count - 1)) % count];  // 'a' gives the first
  const fs::path folder = folders.of(target), file = folder / target.file;
  text(file, std::string(reinterpret_cast<const char*>(data) + 1, length - 1));
  try {
    target.feed(folder, file);
  } catch (const FileError& error) {
    const std::string message = error.what();
    require(message.rfind(folder.string(), 0) == 0, "an error that does not name the file");
    require(message.find_first_of("\r\n") == std::string::npos, "an error of several lines");
  }
  return 0;
}
