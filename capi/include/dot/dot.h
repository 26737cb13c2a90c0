// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#ifndef DOT_DOT_H
#define DOT_DOT_H

#include <stdint.h>

/// @file
/// The C interface of dot. Valid C99 and C++98; needs neither Eigen nor OpenCV.
///
/// Conventions. Axes x right, y down, z forward; metres, radians, seconds; pixel centres at integer coordinates. T_a_b
/// maps coordinates of b into a and is stored as a row-major 3x4 matrix of doubles. Covariances are row-major.
/// Booleans are bits of a `flags` field. A valid id is never 0.
///
/// Structs. Every struct but dot_setting starts with `struct_size`, which the caller sets to its sizeof, for inputs and
/// for outputs: `dot_frame frame = DOT_FRAME_INIT;`, or in C99 `{.struct_size = sizeof frame}`. Structs grow at their
/// end only. A field that an older caller does not have counts as zero. A size that is not that of a published header
/// (0, of a newer header, or one that cuts a field in half) is an error.
///
/// Errors. Functions return DOT_OK or a negative status. The text, which names the field at fault, is in
/// dot_last_error, or in dot_create_error for functions without a tracker. No function aborts, exits, throws or prints.
///
/// Threads. Trackers are independent. Only one thread at a time may use a given tracker, also for reading. A call
/// during another call on the same tracker changes nothing and returns DOT_BUSY. This detects the mistake, but it is no
/// lock: dot_last_error and dot_destroy are not covered by it.

/// @def DOT_API
/// Before a function: exported by the library. On Windows define DOT_CAPI_STATIC to link the archive.
#if defined(_WIN32) && !defined(DOT_CAPI_STATIC)
#ifdef DOT_CAPI_EXPORTS
#define DOT_API __declspec(dllexport)
#else
#define DOT_API __declspec(dllimport)
#endif
#elif defined(__GNUC__)
#define DOT_API __attribute__((visibility("default")))
#else
#define DOT_API
#endif

/// @def DOT_NOEXCEPT
/// After a function: throws nothing. Empty in C and C++98.
#if defined(__cplusplus) && __cplusplus >= 201103L
#define DOT_NOEXCEPT noexcept
#else
#define DOT_NOEXCEPT
#endif

/// Version of this header: 1000000 major + 1000 minor + patch. Compare with dot_version().
#define DOT_HEADER_VERSION 1000

/// Version of the binary interface, which is also in the shared library's name. A program compiled against this header
/// runs with every library whose dot_abi_version() is the same and whose dot_version() is not older.
#define DOT_ABI_VERSION 0

#ifdef __cplusplus
extern "C" {
#endif

/// Result of a call, one of the values below.
typedef int32_t dot_status;

/// The values of dot_status.
enum {
  DOT_OK = 0,                 ///< it did what it says
  DOT_INVALID_ARGUMENT = -1,  ///< the text names the field; the state is unchanged
  DOT_NO_RESULT = -2,         ///< no frame tracked yet, or none since dot_reset or a failure
  DOT_OUT_OF_MEMORY = -3,     ///< the tracker has been reset
  DOT_INTERNAL = -4,          ///< a fault of the library; the tracker has been reset
  DOT_BUSY = -5               ///< another call on this tracker has not ended; all is unchanged, also dot_last_error
};

/// dot_image.format. 0 is none, so that a forgotten format is an error.
enum {
  DOT_FORMAT_GREY8 = 1,      ///< one byte a pixel
  DOT_FORMAT_BGR8 = 2,       ///< three bytes a pixel, blue first
  DOT_FORMAT_RGB8 = 3,       ///< three bytes a pixel, red first
  DOT_FORMAT_BGRA8 = 4,      ///< four bytes a pixel, blue first, alpha ignored
  DOT_FORMAT_DEPTH_F32 = 5,  ///< float, metres
  DOT_FORMAT_DEPTH_U16 = 6,  ///< 16 bit, metres = value / depth_units_per_metre; 65535 = no measurement
  DOT_FORMAT_ID8 = 7,        ///< instance ids, 0 = background
  DOT_FORMAT_ID16 = 8,       ///< two bytes a pixel, 0 = background
  DOT_FORMAT_ID32 = 9,       ///< four bytes a pixel, 0 = background
  DOT_FORMAT_LABEL8 = 10     ///< output only: a DOT_STATE_ value a pixel
};

/// The state of an object and of each of its label pixels.
enum {
  DOT_STATE_BACKGROUND = 0,     ///< no object
  DOT_STATE_STATIC = 1,         ///< it stands
  DOT_STATE_MOVING = 2,         ///< it moves
  DOT_STATE_NOT_OBSERVABLE = 3  ///< the data does not decide between static and moving
};

/// Why an object has no motion estimate in this frame (or was dropped after it).
enum {
  DOT_REASON_NONE = 0,                ///< it has one
  DOT_REASON_NEW = 1,                 ///< first seen in this frame, and the frame before gives no motion
  DOT_REASON_NO_REFERENCE = 2,        ///< the frames before this one were dropped (gap in time, or reset)
  DOT_REASON_TOO_FEW_PIXELS = 3,      ///< its mask is too small
  DOT_REASON_TOO_LITTLE_DEPTH = 4,    ///< its mask has too little valid depth
  DOT_REASON_TOO_LITTLE_TEXTURE = 5,  ///< too few pixels with a gradient
  DOT_REASON_LEAVES_IMAGE = 6,        ///< too small a part of it stays inside the image
  DOT_REASON_OCCLUDED = 7,            ///< nearer objects hide too much of it
  DOT_REASON_DIVERGED = 8,            ///< the alignment did not converge
  DOT_REASON_LOW_CORRELATION = 9,     ///< reference and tracked intensities do not correlate (phi)
  DOT_REASON_TOO_FEW_INLIERS = 10,    ///< too few points agree with the fitted line between intensities
  DOT_REASON_DEPTH_DISAGREES = 11,    ///< the motion found contradicts the measured depth
  DOT_REASON_IMPLAUSIBLE = 12,        ///< faster than the setting object.max_speed
  DOT_REASON_HIDDEN = 13,             ///< neither predicted to be visible nor shown by a mask; or discovered, and no
                                      ///< longer confirmed to move
  DOT_REASON_CAMERA_LOST = 14,        ///< no camera motion, hence no object motion
  DOT_REASON_LOST = 15,               ///< dropped: not seen for too long, or too many
  DOT_REASON_TOO_MANY_OBJECTS =
      16  ///< not among the largest, setting "object.max_fitted": predicted at its last velocity
};

/// dot_camera_result.status.
enum {
  DOT_CAMERA_FIRST_FRAME = 0,       ///< no reference: T_cur_prev is the identity without meaning; after a gap in time
                                    ///< covariance is that of a motion of which only the limits are known
  DOT_CAMERA_TRACKED = 1,           ///< estimated from the image
  DOT_CAMERA_FROM_HOST = 2,         ///< dot_frame.camera_motion
  DOT_CAMERA_TOO_LITTLE_DEPTH = 3,  ///< T_cur_prev is a guess: the prior, or constant velocity
  DOT_CAMERA_LOST = 4               ///< T_cur_prev is a guess likewise
};

/// What may be wrong with the input, with its figure. The log has a line when one appears, see dot_set_log.
enum {
  DOT_SUSPICION_NONE = 0,                ///< nothing; figure 0
  DOT_SUSPICION_IMPLAUSIBLE_TIMES = 1,   ///< steps between frames that no camera has; the last one, seconds
  DOT_SUSPICION_REPEATED_IMAGES = 2,     ///< images of the frame before; share of the last frames, 0 to 1
  DOT_SUSPICION_TOO_LITTLE_DEPTH = 3,    ///< too few points to track; share of the pixels with depth, 0 to 1
  DOT_SUSPICION_TOO_LITTLE_TEXTURE = 4,  ///< too few points to track; share of the last frames, 0 to 1
  DOT_SUSPICION_IMPLAUSIBLE_DEPTH = 5,   ///< its unit may be wrong; the typical depth, metres
  DOT_SUSPICION_DEPTH_OUT_OF_STEP = 6,   ///< depth of another frame; frames by which it is late, negative: early
  DOT_SUSPICION_MASKS_COVER_IMAGE = 7,   ///< masks leave too few points to track; share that they cover, 0 to 1
  DOT_SUSPICION_SATURATED_DEPTH = 8,     ///< depth cut off at a largest value, not missing; share of the pixels
  DOT_SUSPICION_FIXED_PART = 9,          ///< part of the image that does not move with the scene; share of the image
  DOT_SUSPICION_ROLLING_SHUTTER = 10,    ///< rows turned against each other; first to last row, radians
  DOT_SUSPICION_UNSTEADY_SCALE = 11,     ///< depth whose scale differs from frame to frame; its sigma, relative
  DOT_SUSPICION_HOST_MOTION = 12,        ///< camera_motion that the image refutes, not used; its error, pixels
  DOT_SUSPICION_LENS_DISTORTION = 13     ///< distortion that the camera lacks, or depth along the ray; px at a corner
};

/// dot_options.classifier.
enum {
  DOT_CLASSIFIER_VELOCITY = 0,        ///< belief over the velocities of the object's points
  DOT_CLASSIFIER_ENTROPY = 1,         ///< the paper's rule with the gate H < H_max
  DOT_CLASSIFIER_ENTROPY_LITERAL = 2  ///< the paper's rule as printed, H > H_min; for comparison
};

/// dot_options.depth_source. It determines the form of the depth noise.
enum {
  DOT_DEPTH_UNKNOWN = 0,  ///< a share of the inverse depth
  DOT_DEPTH_STEREO = 1,   ///< constant in disparity; needs dot_camera.baseline
  DOT_DEPTH_RGBD = 2,     ///< grows with the square of the depth
  DOT_DEPTH_LIDAR = 3     ///< constant in range, and a share for the interpolation between the beams
};

/// dot_instance.flags.
enum {
  DOT_INSTANCE_ALWAYS_DYNAMIC = 1  ///< people and other non-rigid objects: always reported as moving
};

/// dot_object.flags.
enum {
  DOT_OBJECT_ALWAYS_DYNAMIC = 1,  ///< flagged by the caller
  DOT_OBJECT_SEGMENTED = 2,       ///< an instance of this frame's segmentation was associated: instance_id
  DOT_OBJECT_DISCOVERED = 4  ///< found by its motion (setting "discover_unknown"); no instance was associated so far
};

/// dot_exclusion_policy.flags.
enum {
  DOT_EXCLUDE_NOT_OBSERVABLE = 1,  ///< objects that were never decided; for others the last decision counts
  DOT_EXCLUDE_STATIC = 2,          ///< objects that are known to stand still, too
  DOT_EXCLUDE_INVERTED = 4         ///< write 0 = do not use, 255 = use, as OpenCV's feature detectors need
};

/// Level of a log message.
enum {
  DOT_LOG_ERROR = 1,    ///< a call failed; the text is that of dot_last_error
  DOT_LOG_WARNING = 2,  ///< the camera's motion is only a guess from this frame on; or a suspicion appears
  DOT_LOG_INFO = 3      ///< the camera's motion is known again
};

/// A tracker and all its memory. Made by dot_create, freed by dot_destroy. Threads that share it must lock it.
typedef struct dot_tracker dot_tracker;

/// A view of pixels. It owns no memory. As an input it is borrowed for the duration of one call.
typedef struct dot_image {
  uint32_t struct_size;          ///< sizeof(dot_image)
  uint32_t format;               ///< DOT_FORMAT_
  int32_t width;                 ///< pixels
  int32_t height;                ///< pixels
  int64_t stride_bytes;          ///< from one row to the next, at least width times the pixel's size
  const void* data;              ///< top left pixel, aligned to its element type
  double depth_units_per_metre;  ///< DOT_FORMAT_DEPTH_U16 only: 1000 for RGB-D cameras, 256 for KITTI files
} dot_image;

/// A rectified pinhole camera.
typedef struct dot_camera {
  uint32_t struct_size;  ///< sizeof(dot_camera)
  int32_t width;         ///< pixels
  int32_t height;        ///< pixels
  uint32_t reserved;     ///< 0
  double fx;             ///< pixels
  double fy;             ///< pixels
  double cx;             ///< pixels
  double cy;             ///< pixels
  double baseline;       ///< metres; 0 if the depth does not come from stereo
} dot_camera;

/// One setting by its name in dot/pipeline/options.hpp, such as "velocity.decide". Integers and booleans are given as
/// whole numbers. (This struct does not grow, because it is an array element without a size.)
typedef struct dot_setting {
  const char* name;  ///< such as "velocity.decide"
  double value;      ///< in the unit of the setting
} dot_setting;

/// The main settings. Start from dot_options_init. All pointers are read by dot_create only.
typedef struct dot_options {
  uint32_t struct_size;         ///< sizeof(dot_options)
  uint32_t classifier;          ///< DOT_CLASSIFIER_
  uint32_t depth_source;        ///< DOT_DEPTH_
  int32_t background_points;    ///< budget for the background of one frame
  int32_t object_points;        ///< budget for one object
  uint32_t setting_count;       ///< length of `settings`
  const dot_setting* settings;  ///< further settings, applied last; may be NULL if there are none
  double v0;  ///< m/s: faster objects count as moving; near ones at less, setting velocity.v0_per_square_metre
  double stereo_sigma_px;  ///< pixels: disparity noise of one pixel
} dot_options;

/// One instance of a segmentation. All elements of an array have the same struct_size.
typedef struct dot_instance {
  uint32_t struct_size;   ///< sizeof(dot_instance)
  uint32_t id;            ///< the caller's, need not be stable from frame to frame
  const dot_image* mask;  ///< GREY8 or ID8, non-zero = object; NULL: the pixels of dot_masks.ids that equal `id`
  int32_t x;              ///< pixels: place of the mask's top left corner in the frame
  int32_t y;              ///< pixels
  int32_t class_id;       ///< the caller's, -1 = unknown
  float score;            ///< of the network; of masks that show the same the highest counts
  uint32_t flags;         ///< DOT_INSTANCE_
  uint32_t reserved;      ///< 0
} dot_instance;

/// The segmentation of one frame: an id image, or instances that may overlap, or an id image with instances that give
/// class and score of some of its ids. Instances that are boxes are cut to the objects in them, by depth. Both absent:
/// the network ran and found nothing.
typedef struct dot_masks {
  uint32_t struct_size;           ///< sizeof(dot_masks)
  uint32_t instance_count;        ///< length of `instances`
  const dot_image* ids;           ///< ID8, ID16 or ID32, of the frame's size; may be NULL
  const dot_instance* instances;  ///< may be NULL if there are none
} dot_masks;

/// A camera motion that the host knows better than the tracker.
typedef struct dot_camera_motion {
  uint32_t struct_size;   ///< sizeof(dot_camera_motion)
  uint32_t reserved;      ///< 0
  double T_cur_prev[12];  ///< a static point at X in the previous frame's camera is at T_cur_prev X in this one's
  double covariance[36];  ///< of the left twist [translation; rotation], metres and radians
} dot_camera_motion;

/// One frame. All that it points to is borrowed for the duration of dot_track.
typedef struct dot_frame {
  uint32_t struct_size;                    ///< sizeof(dot_frame)
  uint32_t reserved;                       ///< 0
  uint64_t id;                             ///< the caller's number of the frame
  double timestamp;                        ///< seconds, strictly increasing
  const dot_image* image;                  ///< GREY8, BGR8, RGB8 or BGRA8
  const dot_image* depth;                  ///< DEPTH_F32 or DEPTH_U16; zero, negative, NaN, infinite = no measurement
  const dot_masks* masks;                  ///< NULL: no segmentation for this frame, or not yet
  const dot_camera_motion* camera_motion;  ///< NULL: estimated from the image
  const double* camera_prior;  ///< start of that estimate, from odometry or an IMU: T_cur_prev, 12 values; NULL:
  ///< constant velocity alone
} dot_frame;

/// The camera's motion over the last interval.
typedef struct dot_camera_result {
  uint32_t struct_size;        ///< sizeof(dot_camera_result)
  uint32_t status;             ///< DOT_CAMERA_
  int32_t n_points;            ///< background points inside the image
  int32_t n_inliers;           ///< of these, points that fit the line between intensities
  uint64_t frame_id;           ///< dot_frame.id
  double timestamp;            ///< dot_frame.timestamp
  double interval;             ///< seconds since the previous frame, 0 if there is no reference
  double T_cur_prev[12];       ///< T_c
  double covariance[36];       ///< of the left twist [translation; rotation], metres and radians
  double phi;                  ///< Pearson correlation of reference and tracked intensities
  double gain;                 ///< I_cur = gain I_prev + offset
  double offset;               ///< grey values
  double residual_sigma;       ///< grey values, robust
  double normalised_variance;  ///< of the residuals over their predicted sigma; near 1 if consistent
  double masked_share;         ///< 0 to 1: share of the image that the default policy excludes, without dilation
  int32_t small_instances;     ///< masks of this frame without a track, too small to start one (mask.min_pixels)
  uint32_t reserved;           ///< 0
  double suspicion_figure;     ///< size of what may be wrong, see DOT_SUSPICION_
  uint32_t suspicion;          ///< DOT_SUSPICION_: what may be wrong with the last frames' images, depth and times
  uint32_t reserved2;          ///< 0
} dot_camera_result;

/// An earlier motion of the camera that was wrong, and the right one. A host that has used it should use this instead.
typedef struct dot_camera_revision {
  uint32_t struct_size;   ///< sizeof(dot_camera_revision)
  uint32_t reserved;      ///< 0
  uint64_t frame_id;      ///< dot_frame.id of the frame that the motion led to
  double timestamp;       ///< of that frame, seconds
  double T_cur_prev[12];  ///< from the frame before that one to it: replaces the T_cur_prev that was reported then
  double covariance[36];  ///< of its left twist [translation; rotation], metres and radians
} dot_camera_revision;

/// One object in one frame.
typedef struct dot_object {
  uint32_t struct_size;   ///< sizeof(dot_object)
  uint32_t id;            ///< of the track, never reused by this tracker
  uint32_t state;         ///< DOT_STATE_
  uint32_t reason;        ///< DOT_REASON_
  uint32_t last_decided;  ///< last state that was STATIC or MOVING; NOT_OBSERVABLE if there was none
  uint32_t flags;         ///< DOT_OBJECT_
  uint32_t instance_id;   ///< dot_instance.id, or the value in dot_masks.ids; with DOT_OBJECT_SEGMENTED
  int32_t class_id;       ///< of the last instance associated
  float score;            ///< of the last instance associated
  int32_t area;           ///< visible label pixels
  int32_t box[4];         ///< x, y, width, height of the visible label pixels; zeros if there are none
  int32_t n_points;       ///< points inside the image
  int32_t n_inliers;      ///< of these, points that fit the line between intensities
  double p_moving;        ///< belief after this frame

  /* The single fit of this frame. Valid if `reason` is DOT_REASON_NONE. */
  double T_o[12];                 ///< previous camera's axes: a point at X_prev is at T_c T_o X_prev in this camera
  double covariance[36];          ///< of T_o: twist about the centroid, photometric part only
  double velocity[3];             ///< of the centroid, m/s, previous camera's axes
  double velocity_covariance[9];  ///< includes the errors of camera and depth
  double speed;                   ///< m/s
  double phi;                     ///< Pearson correlation
  double disparity_px;            ///< median pixel distance between the points moved by T_c and by T_c T_o
  double disparity_noise_px;      ///< the part of that due to the covariance
  double entropy;                 ///< of the pose, nats
  double range;                   ///< depth of the centroid, metres
  double interval;                ///< seconds that velocity spans; T_o is of the last interval

  /* Fused over time. */
  double fused_velocity[3];    ///< m/s, this camera's axes
  double fused_covariance[9];  ///< (m/s)^2, row-major; zeros if there is no fused velocity

  /* The single fit of this frame, continued. */
  double angular_velocity[3];    ///< rad/s, previous camera's axes; without the prior that T_o contains
  double angular_covariance[9];  ///< (rad/s)^2, includes the errors of camera and depth
  double point_speed;            ///< m/s, of the object's points, turning included: root of the mean square
  double point_speed_sigma;      ///< m/s, of the points' velocities: root of the mean trace of their covariances
} dot_object;

/// The objects that dot_exclusion_mask excludes besides moving ones.
typedef struct dot_exclusion_policy {
  uint32_t struct_size;  ///< sizeof(dot_exclusion_policy)
  uint32_t flags;        ///< DOT_EXCLUDE_
  int32_t dilation;      ///< pixels by which the excluded area is widened, >= 0
  uint32_t reserved;     ///< 0
} dot_exclusion_policy;

/// The function called for log messages, see dot_set_log. @param user the value given to dot_set_log.
/// @param level DOT_LOG_. @param text valid during the call; English, without a line break.
typedef void (*dot_log_function)(void* user, uint32_t level, const char* text);

/* Initial values: struct_size is set, the rest is empty or the default. */
/// Initial value of a dot_image.
#define DOT_IMAGE_INIT \
  { sizeof(dot_image), 0, 0, 0, 0, 0, 0 }
/// Initial value of a dot_camera.
#define DOT_CAMERA_INIT \
  { sizeof(dot_camera), 0, 0, 0, 0, 0, 0, 0, 0 }
/// Initial value of a dot_options.
#define DOT_OPTIONS_INIT \
  { sizeof(dot_options), DOT_CLASSIFIER_VELOCITY, DOT_DEPTH_UNKNOWN, 2000, 300, 0, 0, 0.5, 0.3 }
/// Initial value of a dot_instance.
#define DOT_INSTANCE_INIT \
  { sizeof(dot_instance), 0, 0, 0, 0, -1, 1, 0, 0 }
/// Initial value of a dot_masks.
#define DOT_MASKS_INIT \
  { sizeof(dot_masks), 0, 0, 0 }
/// Initial value of a dot_camera_motion.
#define DOT_CAMERA_MOTION_INIT                                                \
  {                                                                           \
    sizeof(dot_camera_motion), 0, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, { 0 } \
  }
/// Initial value of a dot_frame.
#define DOT_FRAME_INIT \
  { sizeof(dot_frame), 0, 0, 0, 0, 0, 0, 0, 0 }
/// Initial value of a dot_camera_result.
#define DOT_CAMERA_RESULT_INIT \
  { sizeof(dot_camera_result), 0, 0, 0, 0, 0, 0, {0}, {0}, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0 }
/// Initial value of a dot_camera_revision.
#define DOT_CAMERA_REVISION_INIT                     \
  {                                                  \
    sizeof(dot_camera_revision), 0, 0, 0, {0}, { 0 } \
  }
/// Initial value of a dot_object.
#define DOT_OBJECT_INIT                                                                                             \
  {                                                                                                                 \
    sizeof(dot_object), 0, 0, 0, 0, 0, 0, 0, 0, 0, {0}, 0, 0, 0, {0}, {0}, {0}, {0}, 0, 0, 0, 0, 0, 0, 0, {0}, {0}, \
        {0}, {0}, 0, 0                                                                                              \
  }
/// Initial value of a dot_exclusion_policy.
#define DOT_EXCLUSION_POLICY_INIT \
  { sizeof(dot_exclusion_policy), DOT_EXCLUDE_NOT_OBSERVABLE, 2, 0 }

/// Version of the library, counted as DOT_HEADER_VERSION.
DOT_API uint32_t dot_version(void) DOT_NOEXCEPT;

/// DOT_ABI_VERSION of the library.
DOT_API uint32_t dot_abi_version(void) DOT_NOEXCEPT;

/// Short English name of a status. Never NULL; static memory.
DOT_API const char* dot_status_string(dot_status status) DOT_NOEXCEPT;

/// Fills in the defaults of DOT_OPTIONS_INIT. @param struct_size sizeof(dot_options). On failure nothing is written.
DOT_API dot_status dot_options_init(dot_options* options, uint32_t struct_size) DOT_NOEXCEPT;

/// Fills in the defaults of DOT_EXCLUSION_POLICY_INIT: objects that were never decided are excluded, static ones are
/// not, and the area is widened by 2 pixels. @param struct_size sizeof(dot_exclusion_policy). On failure nothing is
/// written.
DOT_API dot_status dot_exclusion_policy_init(dot_exclusion_policy* policy, uint32_t struct_size) DOT_NOEXCEPT;

/// Makes a tracker, which the caller frees with dot_destroy. @param options NULL for the defaults.
/// @param out set to NULL on failure. The arguments are copied.
DOT_API dot_status dot_create(const dot_camera* camera, const dot_options* options, dot_tracker** out) DOT_NOEXCEPT;

/// Error text of the last call on this thread that takes no tracker (dot_create, the init functions), empty if that
/// succeeded. Never NULL; valid until the thread's next such call.
DOT_API const char* dot_create_error(void) DOT_NOEXCEPT;

/// Frees the tracker and all views that it handed out. NULL is allowed.
DOT_API void dot_destroy(dot_tracker* tracker) DOT_NOEXCEPT;

/// Sets the function that is called for log messages of this tracker. NULL, the initial value, turns logging off. It is
/// called on the thread of the call that logs, before that call returns. It must not use the tracker: every call on it
/// returns DOT_BUSY. Exceptions of the function are dropped.
DOT_API dot_status dot_set_log(dot_tracker* tracker, dot_log_function function, void* user) DOT_NOEXCEPT;

/// Forgets all frames and objects. Keeps the buffers and never reuses an id.
DOT_API dot_status dot_reset(dot_tracker* tracker) DOT_NOEXCEPT;

/// Labels the objects of one frame. After DOT_INVALID_ARGUMENT the tracker and its last result are unchanged.
DOT_API dot_status dot_track(dot_tracker* tracker, const dot_frame* frame) DOT_NOEXCEPT;

/// dot_track in two steps, for a host that waits for the labels: this one returns as soon as they are ready. The rest
/// is done by dot_prepare, or by the next dot_track, dot_label or dot_submit_masks.
DOT_API dot_status dot_label(dot_tracker* tracker, const dot_frame* frame) DOT_NOEXCEPT;

/// Prepares for the next frame what dot_label left: points of the new one. Then dot_get_camera also tells the
/// suspicion. Label and id images may be read meanwhile, in another thread. Does nothing if all is prepared.
DOT_API dot_status dot_prepare(dot_tracker* tracker) DOT_NOEXCEPT;

/// Takes masks that arrive late, for an earlier frame that was tracked without masks. A network may take longer than a
/// frame. The masks are moved to the present and appear in the next result. The last result does not change. Masks must
/// come in the order of their frames, for frames after the last segmented one, and at most a second late (setting
/// "mask.late_seconds").
/// @param frame_id dot_frame.id; the newest, if several frames have it. DOT_INVALID_ARGUMENT if it is none of these
/// frames; the tracker is then unchanged.
/// @param masks borrowed for the duration of the call.
DOT_API dot_status dot_submit_masks(dot_tracker* tracker, uint64_t frame_id, const dot_masks* masks) DOT_NOEXCEPT;

/// Number of objects in the last result, including those without pixels and those just dropped.
DOT_API dot_status dot_object_count(dot_tracker* tracker, uint32_t* count) DOT_NOEXCEPT;

/// Copies object `index` of the last result, 0 <= index < count. Sets all fields of `out` but struct_size.
DOT_API dot_status dot_get_object(dot_tracker* tracker, uint32_t index, dot_object* out) DOT_NOEXCEPT;

/// Copies the camera's part of the last result. Sets all fields of `out` but struct_size.
DOT_API dot_status dot_get_camera(dot_tracker* tracker, dot_camera_result* out) DOT_NOEXCEPT;

/// Number of earlier frames whose camera motion the last frame proved to be wrong; 0 in nearly all frames.
DOT_API dot_status dot_revision_count(dot_tracker* tracker, uint32_t* count) DOT_NOEXCEPT;

/// Copies the right motion of one of these frames, the oldest first, 0 <= index < count. Sets all fields of `out` but
/// struct_size.
DOT_API dot_status dot_get_revision(dot_tracker* tracker, uint32_t index, dot_camera_revision* out) DOT_NOEXCEPT;

/// View of the label image, DOT_FORMAT_LABEL8, of the frame's size. Its pixels belong to the tracker and are valid
/// until its next dot_track, dot_label, dot_reset or dot_destroy.
DOT_API dot_status dot_label_image(dot_tracker* tracker, dot_image* out) DOT_NOEXCEPT;

/// View of the track id of each pixel, DOT_FORMAT_ID32, 0 = background. Valid as long as the label image.
DOT_API dot_status dot_id_image(dot_tracker* tracker, dot_image* out) DOT_NOEXCEPT;

/// Copies the label image, a DOT_STATE_ value a pixel.
/// @param data the caller's: `height` rows of `width` bytes, `stride_bytes` apart, of the frame's size.
DOT_API dot_status dot_copy_labels(dot_tracker* tracker, uint8_t* data, int32_t width, int32_t height,
                                   int64_t stride_bytes) DOT_NOEXCEPT;

/// Copies the track id of each pixel, 0 = background.
/// @param data the caller's: `height` rows of `width` ids, `stride_bytes` (a multiple of 4) apart, of the frame's size.
DOT_API dot_status dot_copy_ids(dot_tracker* tracker, uint32_t* data, int32_t width, int32_t height,
                                int64_t stride_bytes) DOT_NOEXCEPT;

/// Writes the mask that a feature extractor needs: 255 = do not use this pixel, 0 = use it. That is the OPPOSITE of the
/// mask that OpenCV's feature detectors need; DOT_EXCLUDE_INVERTED writes theirs.
/// @param policy NULL for the defaults, see dot_exclusion_policy_init.
/// @param data the caller's: `height` rows of `width` bytes, `stride_bytes` apart, of the frame's size.
DOT_API dot_status dot_exclusion_mask(dot_tracker* tracker, const dot_exclusion_policy* policy, uint8_t* data,
                                      int32_t width, int32_t height, int64_t stride_bytes) DOT_NOEXCEPT;

/// Error text of the last call on this tracker, empty if that succeeded. Never NULL; valid until the next call on it.
DOT_API const char* dot_last_error(const dot_tracker* tracker) DOT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif /* DOT_DOT_H */
