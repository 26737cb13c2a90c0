# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Errors name the argument as the caller knows it."""

import pickle

import demo
import numpy as np
import pytest
from conftest import new_tracker, track

import dot_slam
from dot_slam import Camera, CameraMotion, InvalidArgument, NoResult, Tracker

MOTION = CameraMotion(np.eye(4), np.eye(6) * 1e-6)


def camera(**changes):
    return Camera(**{**vars(demo.CAMERA), **changes})


@pytest.mark.parametrize("field, arguments, text", [
    ("camera", {"camera": None}, "is NoneType, must be dot_slam.Camera"),
    ("camera", {"camera": (1, 2)}, "is tuple, must be dot_slam.Camera"),
    ("camera.fx", {"camera": camera(fx=0)}, "must be 1 to 1e6 pixels"),
    ("camera.fx", {"camera": camera(fx=float("nan"))}, ""),
    ("camera.fy", {"camera": camera(fy="280")}, "must be a number"),
    ("camera.width", {"camera": camera(width=320.5)}, "is 320.5"),
    ("camera.height", {"camera": camera(height=-1)}, "is -1"),
    ("camera.height", {"camera": camera(height=2**40)}, "is 1099511627776"),
    ("camera.baseline", {"camera": camera(baseline=-1)}, ""),
    ("velocity.keep", {"options": {"velocity.keep": 2}}, "0.5"),
    ("velocity.nonsense", {"options": {"velocity.v0": 1, "velocity.nonsense": 2}}, "no setting 'velocity.nonsense'"),
    ("depth_noise.source", {"options": {"depth_noise.source": 1}},
     "no setting 'depth_noise.source': use the argument depth_source= of Tracker"),
    ("depth_source", {"options": {"depth_source": 1}}, "use the argument depth_source="),
    ("classifier", {"options": {"classifier": 1}}, "use the argument classifier= of Tracker"),
    ("velocity.v0", {"options": {"velocity.v0": float("inf")}}, "must be finite"),
    ("velocity.v0", {"options": {"velocity.v0": "1"}}, "'1', must be a number"),
    ("velocity.v0", {"options": {"velocity.v0": None}}, "None"),
    ("options", {"options": [("threads", 1)]}, "is list, must be a dict"),
    ("options", {"options": []}, "is list, must be a dict"),
    ("options", {"options": {1: 2}}, "has the name 1, must be text"),
    ("options", {"options": {"\ud800": 1}}, "must be text"),
    ("options", {"options": {"threads\0x": 1}}, "must be text"),
    ("threads", {"options": {"threads": 1.5}}, "whole number"),
    ("threads", {"options": {"threads": 0}}, "256"),
    ("discover_unknown", {"options": {"discover_unknown": 2}}, "0 or 1"),
    ("depth_source", {"depth_source": "sonar"}, "must be one of unknown, stereo, rgbd, lidar"),
    ("depth_source", {"depth_source": ["stereo"]}, "must be one of"),
    ("classifier", {"classifier": "guess"}, "velocity, entropy, entropy_literal"),
    ("colour", {"colour": "grey"}, "'bgr' or 'rgb'"),
    ("depth_units_per_metre", {"depth_units_per_metre": 0}, "0.001 to 1e+07"),
])
def test_making(field, arguments, text):
    with pytest.raises(InvalidArgument) as caught:
        Tracker(**{"camera": demo.CAMERA, **arguments})
    assert caught.value.field == field
    assert field in str(caught.value) and text in str(caught.value)


@pytest.mark.parametrize("field, changes, text", [
    ("timestamp", {"timestamp": 0.0625}, "is 0.0625 s, must be greater than the last frame's, 0.1 s, by"),
    ("timestamp", {"timestamp": 0.1}, "call reset() first"),
    ("timestamp", {"timestamp": float("nan")}, "must be finite"),
    ("timestamp", {"timestamp": "now"}, "must be a number"),
    ("timestamp", {"timestamp": None}, "must be a number"),
    ("frame_id", {"frame_id": -1}, "is -1"),
    ("frame_id", {"frame_id": 2**64}, "is 18446744073709551616"),
    ("frame_id", {"frame_id": 1.0}, "is 1.0"),
    ("camera_prior", {"camera_prior": np.eye(3)}, "of shape (3, 3), must be numbers of shape (3, 4) or (4, 4)"),
    ("camera_prior", {"camera_prior": 2 * np.eye(4)[:3]}, "is not a rotation"),
    ("camera_prior", {"camera_prior": np.ones((4, 4))}, "must be 0 0 0 1"),
    ("camera_motion", {"camera_motion": np.eye(4)}, "is ndarray, must be CameraMotion"),
    ("camera_motion.T_cur_prev", {"camera_motion": CameraMotion(np.eye(4) * np.nan, np.eye(6))}, ""),
    ("camera_motion.T_cur_prev", {"camera_motion": CameraMotion(-np.eye(4)[:3], np.eye(6))}, "mirror image"),
    ("camera_motion.covariance", {"camera_motion": CameraMotion(np.eye(4), -np.eye(6))}, "must be 0 to"),
    ("camera_motion.covariance", {"camera_motion": CameraMotion(np.eye(4), np.eye(3))}, "numbers of shape (6, 6)"),
])
def test_tracking(tracker, field, changes, text):
    track(tracker, 1)
    with pytest.raises(InvalidArgument) as caught:
        track(tracker, 2, **changes)
    assert caught.value.field == field
    assert str(caught.value).startswith(field) and text in str(caught.value)
    assert track(tracker, 2).frame_id == 1  # counted from 0; what failed does not count


def test_frame_ids_end(tracker):
    assert track(tracker, 0, frame_id=2**64 - 1).frame_id == 2**64 - 1
    with pytest.raises(InvalidArgument, match="frame_id is 18446744073709551616, must be"):
        track(tracker, 1)


def test_camera_motion_and_prior_arrive(tracker):
    track(tracker, 0)
    result = track(tracker, 1, camera_motion=MOTION)
    assert result.camera.status is dot_slam.CameraStatus.FROM_HOST
    np.testing.assert_array_equal(result.camera.T_cur_prev, np.eye(4)[:3])
    np.testing.assert_array_equal(result.camera.covariance, np.eye(6) * 1e-6)
    prior = np.eye(4)
    prior[0, 3] = 0.1
    nothing = np.zeros((demo.HEIGHT, demo.WIDTH), np.float32)
    tracker.reset()
    for i, given in ((2, prior), (3, prior[:3])):
        result = track(tracker, i, depth=nothing, camera_prior=given)
    assert result.camera.status is dot_slam.CameraStatus.TOO_LITTLE_DEPTH
    np.testing.assert_array_equal(result.camera.T_cur_prev, prior[:3])


def test_before_the_first_frame(tracker):
    with pytest.raises(NoResult, match="no frame was tracked yet"):
        tracker.exclusion_mask()
    track(tracker, 0)
    tracker.exclusion_mask()
    tracker.reset()
    with pytest.raises(NoResult):
        tracker.exclusion_mask()


@pytest.mark.parametrize("dilation", [-1, 1.5, 2**31, None])
def test_dilation(tracker, dilation):
    track(tracker, 0)
    with pytest.raises(InvalidArgument, match="dilation") as caught:
        tracker.exclusion_mask(dilation=dilation)
    assert caught.value.field == "dilation"


def test_builtin_bases():
    for error, base in ((InvalidArgument, ValueError), (NoResult, LookupError), (dot_slam.Busy, RuntimeError),
                        (dot_slam.OutOfMemory, MemoryError), (dot_slam.Closed, ValueError)):
        assert issubclass(error, base) and issubclass(error, dot_slam.Error)


def test_error_survives_another_process():
    with pytest.raises(InvalidArgument) as caught:
        new_tracker(options={"threads": 0})
    copy = pickle.loads(pickle.dumps(caught.value))
    assert (copy.field, str(copy)) == (caught.value.field, str(caught.value))
