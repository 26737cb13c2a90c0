#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Makes other recordings of a sequence's scene, with its ground truth: to see what holds beyond the cameras at hand.

usage: variants.py KIND OUT SEQ...        needs numpy and OpenCV for Python

Writes OUT/NAME-KIND for each folder SEQ of the layout of docs/evaluation.md. KIND is
  half, third   images of that share of the width
  mirror        left and right exchanged
  crop          the middle half, left to right
  slow          every other frame
  twice         each frame twice, as JPEG files of a camera that repeats its images would be: noise of one grey value,
                quality 90
  reverse       the frames from the last to the first
  late          without the first 13 frames
  skip1, skip2, skip3
                without the first one, two, three frames: other masks serve where not every frame has one
  bands         light of lamps that flickers by 15 %, three periods from the first to the last row of a rolling shutter
  flicker       brightness that jumps by up to a quarter and 10 grey values from frame to frame
  noise         noise of 8 grey values
  grain         noise of 25 grey values
  dark          a quarter of the brightness, noise of 1.5 grey values
  shake         a camera that is jolted: each frame is turned by some 2 degrees about each axis
  rolling       a shaken hand that turns by up to 1.5 degrees from frame to frame, and a rolling shutter that reads the
                rows in .6 of the time between frames
  bonnet        a bonnet with texture, 1.2 m before the camera: the lowest fifth of the image, at its sides a tenth
  caption       two lines of writing in the image
  letterbox     black bars above and below, to a square
  tilt          the camera turned by 45 degrees about its optical axis, with black corners
  stutter       every fourth frame with the image and depth of the one before, as drivers repeat them
  overlay       a cross hair with a ring in the middle of the image, a clock and other figures in its corners
  near          no depth beyond 20 m
  bias          disparities wrong by up to a pixel at the borders, as from a stereo pair calibrated badly
  lidar64, lidar32, lidar16
                depth of a lidar of so many beams, 0.3 m above and 0.3 m behind the camera, with noise of 2 cm
  tof60         depth of a time-of-flight camera of 60x45 pixels that reaches 8 m, 5 cm beside the camera: the mean of
                what each pixel sees, with an error of 1 %, at one pixel of the image
  flash60       the same, up to 100 m
  mappoints     the 300 map points that a SLAM host sees, on what stands: errors of half a pixel of disparity that stay
  holes50       half of the depth missing, in patches
  thin50        half of the depth missing, here and there
  edges         depth at strong gradients of the image alone
  scale2        depth of a network: that of each frame is wrong by a factor of its own, 2 % (sigma)
  objects5      depth of a network: that of each object is wrong by a factor of its own, 5 % (sigma), which stays
  network5      depth of a network that sees one image: an error of 5 %, and of 10 % beyond 40 m, that changes over a
                tenth of the image and mostly stays in the scene; a scale that differs by 1.5 % from frame to frame; no
                holes, the sky at some 80 m; edges that bleed; no thin things
  shadow        depth of a structured-light camera: none beside near things, which hide the scene from the projector;
                edges that reach up to three pixels too far, and flicker
  flying        depth of a time-of-flight camera: pixels at edges lie anywhere between both surfaces
  wide          masks that reach 6 pixels beyond their objects, nearer ones over farther ones
  shared        one mask for two objects that touch in the image and move differently, in all frames
  motionblur    exposures of half the time between two frames: what moves in the image is smeared
  jolt          in every eighth frame a camera that turns by 1.5 degrees during the exposure
  defocus       a lens that hunts for its focus: sharp, and half a second later a blur of 4 pixels (sigma), and back
  focusing      a recording that starts with that blur, and is sharp after half a second
  fog           fog in which 5 % of the contrast is left at 60 m
  rain, snow    streaks of drops, or flakes, up to 12 m away; flakes of three pixels or more have their depth
"""
import glob
import os
import shutil
import sys

import cv2
import numpy as np

import blur
import depth_sensors
import shared_masks
import weather

IMAGES = ("rgb", "depth", "depth_true", "instance", "masks")
POSES = (("poses.txt", 0), ("object_poses.txt", 2))  # and the columns before the pose

NOISE = {"noise": (1, 8), "grain": (1, 25), "dark": (0.25, 1.5)}  # gain, and sigma in grey values


def shrunk(image, folder, n):
    """The mean of n x n pixels; of depth and ids the one in their middle, or next to it."""
    image = image[: image.shape[0] // n * n, : image.shape[1] // n * n]
    if folder != "rgb":
        return image[(n - 1) // 2 :: n, (n - 1) // 2 :: n]
    return cv2.resize(image, (image.shape[1] // n, image.shape[0] // n), interpolation=cv2.INTER_AREA)


def biased(depth, focal_baseline):
    """Depth, 1/256 m, of disparities that are too small at the left border and too large right of the middle."""
    height, width = depth.shape
    u, v = np.meshgrid(np.linspace(-1, 1, width), np.linspace(-1, 1, height))
    disparity = focal_baseline * 256 / np.maximum(depth, 1) + 0.6 * np.sin(2.4 * u + 0.4) + 0.2 * v - 0.1
    changed = np.clip(focal_baseline * 256 / np.maximum(disparity, 0.1), 1, 65535)
    return np.where(depth > 0, np.round(changed), 0).astype(depth.dtype)


def widened(ids, depth):
    """The ids of a segmentation, each mask grown by 6 pixels. Nearer masks cover farther ones."""
    distance = {i: np.median(depth[(ids == i) & (depth > 0)]) for i in np.unique(ids[(ids > 0) & (depth > 0)])}
    far_to_near = sorted(np.unique(ids[ids > 0]), key=lambda i: -distance.get(i, 1e9))
    disc, wide = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (13, 13)), np.zeros_like(ids)
    for i in far_to_near:
        wide[cv2.dilate((ids == i).astype(np.uint8), disc) > 0] = i
    return wide


def jolt(frame):
    """Rotation from a frame's camera to that of the shaken one. The first frame, whose camera is the world, stays."""
    turn = np.random.default_rng(frame).normal(0, np.radians(2), 3) * (frame > 0)
    return cv2.Rodrigues(turn)[0]


def tilt():
    """Rotation about the optical axis."""
    return cv2.Rodrigues(np.radians([0, 0, 45.0]))[0]


def turned(image, folder, R, intrinsics, border=cv2.BORDER_REFLECT):
    """The image of a camera turned by R. What it sees beyond the old image's border is mirrored at it, or black."""
    fx, fy, cx, cy = intrinsics[:4]
    K = np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])
    H = K @ R @ np.linalg.inv(K)
    size = image.shape[1], image.shape[0]
    if folder == "rgb":
        return cv2.warpPerspective(image, H, size, flags=cv2.INTER_LINEAR, borderMode=border)
    values = image.astype(np.float32)
    if folder.startswith("depth"):
        v, u = np.indices(image.shape)
        values *= ((u - cx) / fx * R[2, 0] + (v - cy) / fy * R[2, 1] + R[2, 2]).astype(np.float32)
    return np.round(cv2.warpPerspective(values, H, size, flags=cv2.INTER_NEAREST)).astype(image.dtype)


def hand(time):
    """Rotation from a camera to one in a shaken hand, at a time in frames. The first frame, the world, stays."""
    turn = np.radians(3.6) * np.array([np.sin(2 * np.pi * time / 15), 0.8 * np.sin(2 * np.pi * time / 20), 0])
    return cv2.Rodrigues(turn)[0]


def rolled(image, folder, frame, intrinsics):
    """The image of a camera in that hand, whose shutter reads row after row. The frame's time is that of the middle."""
    fx, fy, cx, cy = intrinsics[:4]
    v, u = np.indices(image.shape[:2])
    R = np.array([hand(frame + 0.6 * ((row + 0.5) / len(image) - 0.5)) for row in range(len(image))])
    rays = np.stack([(u - cx) / fx, (v - cy) / fy, np.ones_like(u, float)], -1)
    old = np.einsum("vkj,vuk->vuj", R, rays)  # R' times the ray
    x = (fx * old[..., 0] / old[..., 2] + cx).astype(np.float32)
    y = (fy * old[..., 1] / old[..., 2] + cy).astype(np.float32)
    if folder == "rgb":
        return cv2.remap(image, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT)
    values = cv2.remap(image.astype(np.float32), x, y, cv2.INTER_NEAREST)
    return np.round(values / old[..., 2] if folder.startswith("depth") else values).astype(image.dtype)


def shaken(pose, R):
    T = np.array(pose, float).reshape(3, 4)
    return [f"{v:.9g}" for v in np.hstack([T[:, :3] @ R.T, T[:, 3:]]).ravel()]


def with_bonnet(image, folder):
    height, width = image.shape[:2]
    rows, columns = np.indices((height, width))
    top = height * (0.8 + 0.1 * (2 * columns / width - 1) ** 2)
    if folder == "rgb":
        random = np.random.default_rng(9)
        texture = 110 + 3 * cv2.GaussianBlur(random.normal(0, 60, (height, width)).astype(np.float32), (0, 0), 2)
        part = np.clip(np.round(texture), 0, 255).astype(image.dtype)
        if image.ndim == 3:
            part, rows, top = part[..., None], rows[..., None], top[..., None]
    else:
        part = np.array(1.2 * 256 if folder.startswith("depth") else 0, image.dtype)
    return np.where(rows >= top, part, image)


def letterboxed(image):
    bar = (image.shape[1] - image.shape[0]) // 2
    return cv2.copyMakeBorder(image, bar, bar, 0, 0, cv2.BORDER_CONSTANT, value=0)


def with_caption(image):
    image, height = image.copy(), image.shape[0]
    lines = (height // 8, "2026-01-01 12:00:00 CAM0"), (height - 10, "FRONT CAMERA  50 km/h  N48.1 E11.5")
    for row, text in lines:
        for value, thick in ((0, 5), (255, 2)):
            cv2.putText(image, text, (10, row), cv2.FONT_HERSHEY_SIMPLEX, height / 375, (value,) * 3, thick)
    return image


def with_overlay(image, frame):
    """The clock is that of a camera at 20 Hz."""
    image, (height, width) = image.copy(), image.shape[:2]
    size, u, v = height / 480, width // 2, height // 2
    right = width - int(190 * size)
    texts = (
        (10, int(30 * size), f"{10 + frame // 20} m"),
        (right, int(30 * size), f"14:06:{frame // 20 % 60:02d}"),
        (10, height - int(15 * size), "BAT 15.8V"),
        (right, height - int(15 * size), "REC CAM0"),
    )
    for value, thick in ((0, 4), (255, 1.5)):
        color, width = (value,) * 3, max(1, round(thick * size))
        for left, base, text in texts:
            cv2.putText(image, text, (left, base), cv2.FONT_HERSHEY_SIMPLEX, 0.7 * size, color, width, cv2.LINE_AA)
        arm = int(40 * size)
        cv2.line(image, (u - arm, v), (u + arm, v), color, width)
        cv2.line(image, (u, v - arm), (u, v + arm), color, width)
        cv2.circle(image, (u, v), int(28 * size), color, width)
    return image


def with_bands(image, frame):
    """Between two frames the light goes on by .37 periods, as that of lamps at 100 Hz at 29.67 frames a second."""
    height = image.shape[0]
    light = 1 + 0.15 * np.sin(2 * np.pi * (3 * np.arange(height) / height + 0.37 * frame))
    return np.clip(np.round(image * light.reshape(-1, *[1] * (image.ndim - 1))), 0, 255).astype(np.uint8)


def changed(image, folder, kind, random, focal_baseline):
    if kind == "bonnet":
        return with_bonnet(image, folder)
    if kind == "letterbox":
        return letterboxed(image)
    if kind == "caption" and folder == "rgb":
        return with_caption(image)
    if kind in ("half", "third"):
        return shrunk(image, folder, 2 if kind == "half" else 3)
    if kind == "mirror":
        return image[:, ::-1]
    if kind == "crop":
        return image[:, image.shape[1] // 4 :][:, : image.shape[1] // 2]
    if kind == "flicker" and folder == "rgb":
        return np.clip(random.uniform(0.75, 1.25) * image + random.uniform(-10, 10), 0, 255).astype(np.uint8)
    if kind == "twice" and folder == "rgb":
        noisy = np.clip(np.round(image + random.normal(0, 1, image.shape)), 0, 255).astype(np.uint8)
        return cv2.imdecode(cv2.imencode(".jpg", noisy, [cv2.IMWRITE_JPEG_QUALITY, 90])[1], cv2.IMREAD_UNCHANGED)
    if kind in NOISE and folder == "rgb":
        gain, sigma = NOISE[kind]
        return np.clip(gain * image + random.normal(0, sigma, image.shape), 0, 255).astype(np.uint8)
    if kind == "bias" and folder == "depth":
        return biased(image, focal_baseline)
    if kind == "near" and folder == "depth":
        return np.where(image > 20 * 256, 0, image).astype(image.dtype)
    return image


def camera(line, kind):
    """fx fy cx cy width height baseline fps"""
    fx, fy, cx, cy, width, height, baseline, fps = (float(v) for v in line.split())
    if kind in ("half", "third"):
        n = 2 if kind == "half" else 3
        fx, fy, cx, cy = fx / n, fy / n, (cx + 0.5) / n - 0.5, (cy + 0.5) / n - 0.5
        width, height = width // n, height // n
    if kind == "letterbox":
        bar = (width - height) // 2
        cy, height = cy + bar, height + 2 * bar
    if kind == "mirror":
        cx = width - 1 - cx
    if kind == "crop":
        cx, width = cx - width // 4, width // 2
    if kind == "slow":
        fps /= 2
    if kind == "twice":
        fps *= 2
    baseline, _ = depth_sensors.described(kind, baseline, "")
    return f"{fx} {fy} {cx} {cy} {int(width)} {int(height)} {baseline} {fps}\n"


def mirrored(pose):
    mirror = np.diag([-1, 1, 1, 1])
    T = np.vstack([np.array(pose, float).reshape(3, 4), [0, 0, 0, 1]])
    return [f"{v:.9g}" for v in (mirror @ T @ mirror)[:3].ravel()]


def order(frames, kind):
    """The recorded frames in the order of the new ones."""
    if kind == "slow":
        return frames[::2]
    if kind == "reverse":
        return frames[::-1]
    return frames[{"late": 13, "skip1": 1, "skip2": 2, "skip3": 3}.get(kind, 0) :]


def make(kind, out, sequence):
    folder = os.path.join(out, f"{os.path.basename(os.path.normpath(sequence))}-{kind}")
    os.makedirs(folder, exist_ok=True)
    random = np.random.default_rng(1)
    frames = sorted(int(os.path.basename(f)[:-4]) for f in glob.glob(f"{sequence}/instance/*.png"))
    with open(f"{sequence}/intrinsics.txt") as f:
        intrinsics = [float(v) for v in f.readline().split()]
    copies = 2 if kind == "twice" else 1
    number = {frame: range(copies * i, copies * (i + 1)) for i, frame in enumerate(order(frames, kind))}
    if kind in depth_sensors.KINDS:
        sensor = depth_sensors.sensor(kind, sequence, frames, intrinsics, random)
    if kind in blur.KINDS:
        lens = blur.lens(kind, sequence, frames, intrinsics, random)
    if kind in weather.KINDS:
        sky = weather.sky(kind, sequence, frames, intrinsics, random)
    if kind in shared_masks.KINDS:
        unite = shared_masks.uniter(sequence, frames)
    for name in IMAGES:
        for path in sorted(glob.glob(f"{sequence}/{name}/*")):
            stem, suffix = os.path.splitext(os.path.basename(path))
            if int(stem) not in number:
                continue
            os.makedirs(f"{folder}/{name}", exist_ok=True)
            targets = [f"{folder}/{name}/{i:06d}" for i in number[int(stem)]]
            if suffix not in (".png", ".jpg"):
                for target in targets:
                    shutil.copy(path, target + suffix)
                continue
            for target in targets:
                image = cv2.imread(path, cv2.IMREAD_UNCHANGED)
                if kind == "stutter" and name in ("rgb", "depth") and int(stem) % 4 == 3:
                    image = cv2.imread(f"{sequence}/{name}/{int(stem) - 1:06d}{suffix}", cv2.IMREAD_UNCHANGED)
                if name == "depth" and kind in depth_sensors.KINDS:
                    image = sensor(image, int(stem))
                elif name == "rgb" and kind in blur.KINDS:
                    image = lens(image, int(stem))
                elif name in ("rgb", "depth") and kind in weather.KINDS:
                    image = sky(image, name, int(stem))
                elif name == "masks" and kind in shared_masks.KINDS:
                    image = unite(image, int(stem))
                elif kind == "wide" and name == "masks":
                    image = widened(image, cv2.imread(f"{sequence}/depth/{stem}.png", cv2.IMREAD_UNCHANGED))
                elif kind in ("bands", "overlay") and name == "rgb":
                    image = (with_bands if kind == "bands" else with_overlay)(image, int(stem))
                elif kind == "shake":
                    image = turned(image, name, jolt(int(stem)), intrinsics)
                elif kind == "tilt":
                    image = turned(image, name, tilt(), intrinsics, cv2.BORDER_CONSTANT)
                elif kind == "rolling":
                    image = rolled(image, name, int(stem), intrinsics)
                else:
                    image = changed(image, name, kind, random, intrinsics[0] * intrinsics[6])
                cv2.imwrite(f"{target}.png", np.ascontiguousarray(image), [cv2.IMWRITE_PNG_COMPRESSION, 1])
    with open(f"{sequence}/intrinsics.txt") as f, open(f"{folder}/intrinsics.txt", "w") as g:
        g.write(camera(f.readline(), kind))
        g.write(depth_sensors.described(kind, 0, f.read())[1])
    with open(f"{sequence}/objects.csv") as f, open(f"{folder}/objects.csv", "w") as g:
        g.write(f.readline())
        rows = [line.split(",", 1) for line in f]
        rows = [(i, rest) for frame, rest in rows for i in number.get(int(frame), ())]
        g.writelines(f"{i},{rest}" for i, rest in sorted(rows, key=lambda row: row[0]))
    for name, before in POSES:
        if not os.path.exists(f"{sequence}/{name}"):
            continue
        with open(f"{sequence}/{name}") as f:
            lines = [line.split() for line in f]
        poses = []
        for i, v in enumerate(lines):
            frame = int(v[0]) if before else frames[i]
            if frame in number:
                pose = mirrored(v[before:]) if kind == "mirror" else v[before:]
                if kind == "shake" and not before:
                    pose = shaken(pose, jolt(frame))
                if kind == "tilt" and not before:
                    pose = shaken(pose, tilt())
                if kind == "rolling" and not before:
                    pose = shaken(pose, hand(frame))
                for n in number[frame]:
                    poses.append((n, ([str(n)] + v[1:before] if before else []) + pose))
        with open(f"{folder}/{name}", "w") as g:
            g.writelines(" ".join(words) + "\n" for _, words in sorted(poses, key=lambda pose: pose[0]))


def main():
    kinds = "half third mirror crop slow twice reverse late skip1 skip2 skip3 bands flicker noise grain dark shake rolling"
    kinds += " bonnet caption letterbox tilt stutter overlay near bias wide"
    others = (*depth_sensors.KINDS, *blur.KINDS, *weather.KINDS, *shared_masks.KINDS)
    if len(sys.argv) < 4 or sys.argv[1] not in (*kinds.split(), *others):
        sys.exit(__doc__)
    for sequence in sys.argv[3:]:
        make(sys.argv[1], sys.argv[2], sequence)


if __name__ == "__main__":
    main()
