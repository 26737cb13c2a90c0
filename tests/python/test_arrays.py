# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Arrays in any layout give the same answer, or a clear error."""

import demo
import numpy as np
import pytest
from conftest import new_tracker, same, track

from dot_slam import Instance, InvalidArgument, Masks


def in_wider(array):
    """The same values as a part of a wider image."""
    wide = np.zeros((array.shape[0] + 6, array.shape[1] + 10, *array.shape[2:]), array.dtype)
    wide[3:-3, 4:-6] = array
    return wide[3:-3, 4:-6]


def unaligned(array):
    raw = np.zeros(array.nbytes + 1, np.uint8)
    out = raw[1:].view(array.dtype).reshape(array.shape)
    out[...] = array
    assert array.itemsize == 1 or not out.flags.aligned
    return out


def read_only(array):
    array = array.copy()
    array.flags.writeable = False
    return array


LAYOUTS = {"fortran": np.asfortranarray, "every second": lambda a: np.repeat(np.repeat(a, 2, 0), 2, 1)[::2, ::2],
           "upside down": lambda a: a[::-1].copy()[::-1], "mirrored": lambda a: a[:, ::-1].copy()[:, ::-1],
           "part": in_wider, "swapped bytes": lambda a: a.astype(a.dtype.newbyteorder()), "unaligned": unaligned,
           "read-only": read_only, "list": lambda a: a if a.dtype != np.float32 else a.astype(np.float64).tolist()}


def three_frames(change, **settings):
    with new_tracker(**settings) as tracker:
        return [track(tracker, i, **change(*demo.draw(i))) for i in range(3)][-1]


PLAIN = three_frames(lambda grey, depth, ids: {})


@pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS)
def test_layouts(layout):
    found = three_frames(lambda grey, depth, ids: {"image": layout(grey), "depth": layout(depth), "masks": layout(ids)})
    assert same(found, PLAIN)
    metres = three_frames(lambda grey, depth, ids: {"depth": layout((depth / 1000).astype(np.float32))})
    assert same(metres, PLAIN)


@pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS)
def test_colours(layout):
    """Their order counts, in every layout: dot works on their grey value."""
    def colours(grey):
        return np.dstack((grey, grey // 2, 255 - grey))

    def found(change, **settings):
        return three_frames(lambda grey, depth, ids: {"image": layout(change(colours(grey)))}, **settings)

    bgr = three_frames(lambda grey, depth, ids: {"image": colours(grey)})
    assert same(found(lambda image: image), bgr)
    assert same(found(lambda image: image[:, :, ::-1], colour="rgb"), bgr)
    assert same(found(lambda image: np.dstack((image, image[:, :, 0]))), bgr)
    assert same(found(lambda image: np.dstack((image[:, :, ::-1], image[:, :, 0])), colour="rgb"), bgr)
    assert not same(found(lambda image: image, colour="rgb"), bgr)


@pytest.mark.parametrize("change", [
    lambda grey, depth, ids: {"image": grey[:, :, None], "depth": depth[:, :, None]},
    lambda grey, depth, ids: {"depth": depth / 1000},
    lambda grey, depth, ids: {"masks": ids.astype(np.int64)},
    lambda grey, depth, ids: {"masks": ids.astype(np.uint64)},
    lambda grey, depth, ids: {"masks": ids.astype(np.int8)},
    lambda grey, depth, ids: {"masks": ids.astype(np.uint16)},
    lambda grey, depth, ids: {"masks": ids.astype(np.uint32)},
    lambda grey, depth, ids: {"masks": Masks(ids)},
    lambda grey, depth, ids: {"masks": Masks(ids, [Instance(1), Instance(2)])},
    lambda grey, depth, ids: {"masks": np.stack((ids == 1, ids == 2))},
    lambda grey, depth, ids: {"masks": [Instance(1, ids == 1), Instance(2, (ids == 2).astype(np.uint8))]},
    lambda grey, depth, ids: {"masks": [Instance(1, ids[70:180] == 1, y=70), Instance(2, ids[:, 150:] == 2, x=150)]},
    lambda grey, depth, ids: {"masks": [Instance(i, np.asfortranarray(ids == i)) for i in (1, 2)]},
], ids=str)
def test_types(change):
    found = three_frames(change)
    found.table["score"] = PLAIN.table["score"]  # of instances it is 1, of an id image 0
    assert same(found, PLAIN)


@pytest.mark.parametrize("row", [lambda mask: mask[::-1][100:101], lambda mask: np.broadcast_to(mask[100], (1, 320))],
                         ids=["upside down", "broadcast"])
def test_a_single_row(tracker, row):
    """numpy takes it for contiguous, whatever its strides."""
    mask = row(IDS == 1)
    assert mask.shape == (1, 320) and mask.any()
    result = track(tracker, 0, masks=[Instance(1, mask, y=100), Instance(2, IDS == 2)])
    assert [item.instance_id for item in result.objects] == [1, 2]
    assert result.objects[0].box[1::2] == (100, 1)


def test_no_masks_and_none_found():
    def count(masks):
        return len(three_frames(lambda grey, depth, ids: {"masks": masks}).table)

    for nothing in (None, [], Masks(), np.zeros((0, demo.HEIGHT, demo.WIDTH), bool), np.zeros_like(demo.draw(0)[2])):
        assert count(nothing) == 0
    with new_tracker() as tracker:
        track(tracker, 0)
        assert track(tracker, 1, masks=None).table["flags"].tolist() == [0, 0]


def test_class_score_and_flag_arrive():
    ids = demo.draw(0)[2]
    with new_tracker() as tracker:
        masks = Masks(ids, [Instance(1, class_id=7, score=0.25), Instance(2, class_id=-3, always_dynamic=True)])
        one, two = track(tracker, 0, masks=masks).objects
    assert (one.class_id, one.score, one.always_dynamic, one.segmented, one.instance_id) == (7, 0.25, False, True, 1)
    assert (two.class_id, two.score, two.always_dynamic) == (-3, 1, True)


GREY, DEPTH, IDS = demo.draw(0)


@pytest.mark.parametrize("field, wrong, text", [
    ("image", GREY.astype(float), "float64 of shape (240, 320), must be uint8"),
    ("image", GREY[:-1], "shape (239, 320), of a camera of 320x240 it is (240, 320)"),
    ("image", GREY.T, "shape (320, 240)"),
    ("image", np.dstack([GREY] * 2), "shape (240, 320, 2)"),
    ("image", GREY[None], "shape (1, 240, 320)"),
    ("image", GREY[0], "shape (320,)"),
    ("image", None, "is None"),
    ("image", "000000.png", "is <U10"),
    ("image", np.ma.masked_array(GREY), "masked array"),
    ("depth", DEPTH.astype(np.int32), "int32 of shape (240, 320), must be float in metres or uint16"),
    ("depth", DEPTH.astype(np.uint8), "uint8"),
    ("depth", DEPTH.astype(complex), "complex128"),
    ("depth", np.dstack([DEPTH] * 3), "shape (240, 320, 3)"),
    ("depth", DEPTH[:, 1:], "shape (240, 319)"),
    ("depth", np.ma.masked_array(DEPTH), "masked array"),
    ("depth", None, "is None"),
    ("masks", IDS.astype(float), "float64"),
    ("masks", IDS[:, :-1], "shape (240, 319)"),
    ("masks", IDS.astype(np.int32) - 1, "from -1 to 1"),
    ("masks", IDS.astype(np.int64) << 40, "must be 0 to 4294967295"),
    ("masks", IDS > 0, "must be (n, 240, 320)"),
    ("masks", (IDS > 0)[None, 1:], "must be (n, 240, 320)"),
    ("masks", np.stack([IDS] * 2), "masks of single instances are bool: masks.astype(bool)"),
    ("masks", np.stack([IDS] * 2).astype(np.float32), "single instances are bool: masks > 0.5"),
    ("masks", np.dstack([IDS] * 3), "an id image has one channel: masks[:, :, 0]"),
    ("masks", np.stack([IDS] * 2)[:, 1:], "or bool of shape (n, h, w)"),
    ("masks", [(1, IDS > 0)], "nor a list of dot_slam.Instance, as Instance(1, mask): masks[0] is tuple"),
    ("masks", [Instance(1, IDS > 0), (IDS > 0)[1:]], "masks[1] is ndarray"),
    ("masks", [(IDS > 0)[1:], IDS > 0], "masks[0] is ndarray"),
    ("masks", [None], "masks[0] is NoneType"),
    ("masks.instances", [Instance(1, IDS[::2, ::2] > 0)], "of shape (120, 160) at x = y = 0, the frame is (240, 320)"),
    ("masks.instances", [Instance(i, IDS[:96, :96] == i) for i in (1, 2)], "resize them to the frame, or say by x"),
    ("masks.instances", Masks(None, [Instance(i, IDS[::4, ::4] == i) for i in (1, 2)]), "of shape (60, 80)"),
    ("masks.ids", Masks(IDS.astype(float)), "float64"),
    ("masks.instances[1]", Masks(IDS, [Instance(1), 2]), "is int, must be dot_slam.Instance"),
    ("masks.instances[1].mask", [Instance(1, IDS > 0), Instance(2, IDS.astype(float))], "must be bool or uint8"),
    ("masks.instances[0].mask", [Instance(1, IDS[:0])], "height is 0"),
    ("masks.instances[0].mask", [Instance(1)], "is NULL"),
    ("masks.instances[0].id", [Instance(-1, IDS > 0)], "is -1"),
    ("masks.instances[0].id", [Instance(2**32, IDS > 0)], "is 4294967296"),
    ("masks.instances[0].x", [Instance(1, IDS > 0, x=0.5)], "is 0.5"),
    ("image", [[1, 2], [3]], "is no array"),
    ("masks", [[1, 2], [3]], "is no array of one shape"),
    ("masks", (item for item in [Instance(1, IDS > 0)]), "it is generator"),
    ("masks.instances[0].mask", [Instance(1, [[1, 2], [3]])], "is no array: its rows differ in length"),
    ("masks.instances", Masks(IDS, None), "is NoneType, must be a list of dot_slam.Instance"),
    ("masks.instances", Masks(IDS, (Instance(i) for i in (1, 2))), "is generator, must be a list"),
    ("masks.instances[1].score", Masks(IDS, [Instance(1), Instance(2, score="high")]), "is 'high', must be a number"),
    ("masks.instances[0].score", Masks(IDS, [Instance(1, score=None)]), "is None, must be a number"),
    ("masks.instances[0].score", Masks(IDS, [Instance(1, score=float("nan"))]), "is nan, must be -1e+06 to 1e+06"),
    ("masks.instances[0].score", Masks(IDS, [Instance(1, score=float("inf"))]), "is inf, must be"),
    ("masks.instances[0].score", Masks(IDS, [Instance(1, score=1e300)]), "is 1e+300, must be"),
])
def test_wrong_arrays(tracker, field, wrong, text):
    """Named, and the tracker goes on as if nothing had been."""
    track(tracker, 0)
    track(tracker, 1)
    with pytest.raises(InvalidArgument) as caught:
        track(tracker, 2, **{field.split(".")[0]: wrong})
    assert caught.value.field is not None and caught.value.field.startswith(field)
    assert str(caught.value).startswith(field) and text in str(caught.value)
    assert same(track(tracker, 2), PLAIN)


def test_depth_without_unit():
    with new_tracker(depth_units_per_metre=None) as tracker:
        with pytest.raises(InvalidArgument, match="depth_units_per_metre, 1000 for millimetres") as caught:
            track(tracker, 0)
        assert caught.value.field == "depth"
        track(tracker, 0, depth=np.full((demo.HEIGHT, demo.WIDTH), 1e300))  # no measurement
