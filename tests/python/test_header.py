# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What the package repeats of dot/dot.h is what stands there."""

import re
from dataclasses import fields

import dot_slam
import pytest
from conftest import SOURCE, track

from dot_slam import _library as c
from dot_slam import result

HEADER = re.sub(r"//.*|/\*.*?\*/", "", (SOURCE / "capi/include/dot/dot.h").read_text(encoding="utf-8"))
C_TYPES = {"uint32_t": "u4", "int32_t": "i4", "uint64_t": "u8", "int64_t": "i8", "double": "f8", "float": "f4"}


def struct(name):
    """Name, type and length of the fields."""
    body = re.search(rf"typedef struct {name} {{(.*?)}} {name};", HEADER, re.DOTALL).group(1)
    found = re.findall(r"(?:const )?(\w+)(\*?)\s+(\w+)(?:\[(\d+)\])?;", body)
    assert len(found) == body.count(";")
    return [(field, "pointer" if star else kind, int(count or 1)) for kind, star, field, count in found]


@pytest.mark.parametrize("name, dtype", [("dot_object", result.OBJECT_DTYPE),
                                         ("dot_camera_result", result.CAMERA_DTYPE),
                                         ("dot_camera_revision", result.REVISION_DTYPE)])
def test_results(name, dtype):
    def shape(field):
        kind = dtype[field]
        count = 1
        for side in kind.shape:
            count *= side
        return field, kind.base.str[1:], count

    assert [shape(field) for field in dtype.names] == [(f, C_TYPES[kind], count) for f, kind, count in struct(name)]


@pytest.mark.parametrize("kind, name", [(c.Image, "dot_image"), (c.Camera, "dot_camera"), (c.Setting, "dot_setting"),
                                        (c.Options, "dot_options"), (c.Instance, "dot_instance"),
                                        (c.Masks, "dot_masks"), (c.CameraMotion, "dot_camera_motion"),
                                        (c.Frame, "dot_frame"), (c.ExclusionPolicy, "dot_exclusion_policy")])
def test_arguments(kind, name):
    def describe(field, ctype):
        if hasattr(ctype, "_length_"):
            return field, ctype._type_._type_, ctype._length_
        return field, getattr(ctype, "_type_", ctype), 1

    codes = {"uint32_t": "I", "int32_t": "i", "uint64_t": "L", "int64_t": "l", "double": "d", "float": "f"}
    for (field, code, count), (its, c_type, length) in zip([describe(*item) for item in kind._fields_], struct(name)):
        assert (field, count) == (its, length)
        assert code == codes[c_type] if c_type != "pointer" else not isinstance(code, str) or code in "Pz"
    assert len(kind._fields_) == len(struct(name))


@pytest.mark.parametrize("kind, prefix", [(dot_slam.State, "STATE"), (dot_slam.Reason, "REASON"),
                                          (dot_slam.CameraStatus, "CAMERA"), (dot_slam.DepthSource, "DEPTH"),
                                          (dot_slam.Classifier, "CLASSIFIER"), (dot_slam.Suspicion, "SUSPICION")])
def test_enums(kind, prefix):
    assert {item.name: int(item) for item in kind} == enum(prefix)


def test_constants():
    formats = {name: getattr(c, name) for name in enum("FORMAT") if name != "LABEL8"}
    assert {**formats, "LABEL8": 10} == enum("FORMAT")
    for prefix in ("INSTANCE", "OBJECT", "EXCLUDE"):
        assert {name: getattr(c, f"{prefix}_{name}") for name in enum(prefix)} == enum(prefix)
    assert c.ABI_VERSION == int(re.search(r"#define DOT_ABI_VERSION (\d+)", HEADER).group(1))
    assert c.HEADER_VERSION == int(re.search(r"#define DOT_HEADER_VERSION (\d+)", HEADER).group(1))
    text = (SOURCE / "include/dot/version.hpp").read_text(encoding="utf-8")
    assert f'DOT_VERSION_STRING "{dot_slam.__version__}"' in text


def enum(prefix):
    found = re.findall(rf"\bDOT_{prefix}_(\w+)\s*=\s*(\d+)", HEADER)
    assert found
    return {name: int(value) for name, value in found}


def test_dataclasses_hold_every_field(tracker):
    left_out = {"struct_size", "reserved", "reserved2", "flags"}
    for kind, dtype in ((dot_slam.Object, result.OBJECT_DTYPE), (dot_slam.CameraResult, result.CAMERA_DTYPE),
                        (dot_slam.CameraRevision, result.REVISION_DTYPE)):
        assert {field.name for field in fields(kind)} >= set(dtype.names) - left_out
    last = [track(tracker, i) for i in range(4)][-1]
    assert len(last.objects) == len(last.table) == 2
    for item, row in zip(last.objects, last.table):
        for name in set(row.dtype.names) - left_out:
            value = getattr(item, name)
            assert (value == row[name]).all() if hasattr(value, "all") else value == pytest.approx(row[name])
        assert item.T_o.shape == (3, 4) and item.covariance.shape == (6, 6) and item.fused_covariance.shape == (3, 3)
        assert item.segmented == bool(row["flags"] & 2)
        assert last.find(item.id) is item
    assert last.find(12345) is None
    assert last.camera.status is dot_slam.CameraStatus.TRACKED and last.camera.T_cur_prev.shape == (3, 4)
    assert (last.frame_id, last.timestamp) == (3, pytest.approx(0.3))
