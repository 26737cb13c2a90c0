# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""The numbers of dot/dot.h by name. As IntEnum they compare with what arrays hold: `labels == State.MOVING`."""

from enum import IntEnum


class State(IntEnum):
    """Of an object, and of each pixel of `Result.labels`."""

    BACKGROUND = 0
    STATIC = 1
    MOVING = 2
    NOT_OBSERVABLE = 3  # the data does not decide between static and moving


class Reason(IntEnum):
    """Why an object has no motion estimate in a frame."""

    NONE = 0  # it has one
    NEW = 1
    NO_REFERENCE = 2
    TOO_FEW_PIXELS = 3
    TOO_LITTLE_DEPTH = 4
    TOO_LITTLE_TEXTURE = 5
    LEAVES_IMAGE = 6
    OCCLUDED = 7
    DIVERGED = 8
    LOW_CORRELATION = 9
    TOO_FEW_INLIERS = 10
    DEPTH_DISAGREES = 11
    IMPLAUSIBLE = 12
    HIDDEN = 13
    CAMERA_LOST = 14
    LOST = 15  # dropped: not seen for too long, or too many
    TOO_MANY_OBJECTS = 16


class CameraStatus(IntEnum):
    """Where the camera's motion comes from. After the last two it is a guess."""

    FIRST_FRAME = 0
    TRACKED = 1
    FROM_HOST = 2
    TOO_LITTLE_DEPTH = 3
    LOST = 4


class Suspicion(IntEnum):
    """What may be wrong with the input; its figure is CameraResult.suspicion_figure."""

    NONE = 0
    IMPLAUSIBLE_TIMES = 1  # steps between frames that no camera has; the last one, seconds
    REPEATED_IMAGES = 2  # images of the frame before; share of the last frames, 0 to 1
    TOO_LITTLE_DEPTH = 3  # too few points to track; share of the pixels with depth, 0 to 1
    TOO_LITTLE_TEXTURE = 4  # too few points to track; share of the last frames, 0 to 1
    IMPLAUSIBLE_DEPTH = 5  # its unit may be wrong; the typical depth, metres
    DEPTH_OUT_OF_STEP = 6  # depth of another frame; frames by which it is late, negative: early
    MASKS_COVER_IMAGE = 7  # masks leave too few points to track; share of the image that they cover, 0 to 1
    SATURATED_DEPTH = 8  # depth cut off at a largest value instead of missing; share of the pixels, 0 to 1
    FIXED_PART = 9  # a part of the image that does not move with the scene; share of the image, 0 to 1
    ROLLING_SHUTTER = 10  # rows that a turning camera shows turned against each other; first to last row, radians
    UNSTEADY_SCALE = 11  # depth whose scale differs from frame to frame, as that of a network; its sigma, relative
    HOST_MOTION = 12  # camera_motion that the image refutes and that was not used; its error, pixels in the image
    LENS_DISTORTION = 13  # radial distortion that the camera model lacks, or depth along the ray; pixels at a corner


class DepthSource(IntEnum):
    """Determines the form of the depth's noise."""

    UNKNOWN = 0
    STEREO = 1
    RGBD = 2
    LIDAR = 3


class Classifier(IntEnum):
    VELOCITY = 0  # belief over the velocities of the object's points
    ENTROPY = 1  # the paper's rule with the gate H < H_max
    ENTROPY_LITERAL = 2
