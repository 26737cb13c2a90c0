# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Depth of other sensors, from that of a recording. variants.py lists the kinds. Needs numpy and OpenCV for Python."""
import csv
import glob

import cv2
import numpy as np

import depth_cameras
import depth_networks

NETWORKS = ("scale2", "objects5", "network5")
MAP_BASELINE = 0.5  # metres: of a SLAM host's triangulation, if the recording has none


def read(sequence, folder, frame):
    """A frame's image in a folder of the recording; None if there is none."""
    paths = glob.glob(f"{sequence}/{folder}/{frame:06d}.*")
    return cv2.imread(paths[0], cv2.IMREAD_UNCHANGED) if paths else None


def grey(image):
    return image if image.ndim == 2 else cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)


def registered(x, y, z, nearest, intrinsics, depth):
    """Points in the camera's axes, metres, farther than `nearest`, as depth at single pixels: 1/256 m, like `depth`."""
    fx, fy, cx, cy = intrinsics[:4]
    u, v = np.round(fx * x / z + cx).astype(int), np.round(fy * y / z + cy).astype(int)
    inside = (z > nearest) & (u >= 0) & (v >= 0) & (u < depth.shape[1]) & (v < depth.shape[0])
    out = np.zeros(depth.shape, depth.dtype)
    far_to_near = np.argsort(-z[inside])  # where two points fall on a pixel, the nearer one stays
    out[v[inside][far_to_near], u[inside][far_to_near]] = np.round(256 * z[inside][far_to_near])
    return out


# Elevations of the beams, degrees: the highest, and the step from beam to beam. All turn in steps of 0.2 degrees.
BEAMS = {"lidar64": (2.0, 0.43, 64), "lidar32": (10.67, 1.33, 32), "lidar16": (15.0, 2.0, 16)}
AZIMUTH = np.radians(0.2)
MOUNT = np.array([0, 0.3, 0.3])  # from the lidar's axes to the camera's: x right, y down, z forward


def scanned(depth, intrinsics, kind, random):
    """What a lidar measures of the surfaces that the camera sees, in 1/256 m at the camera's pixels.

    It looks past objects from its own place. What it sees there, the camera does not: that surface is continued from
    the farther one of its neighbours along the beam.
    """
    fx, fy, cx, cy = intrinsics[:4]
    v, u = np.nonzero(depth)
    z = depth[v, u] / 256.0
    x, y, z = (u - cx) / fx * z, (v - cy) / fy * z + MOUNT[1], z + MOUNT[2]
    elevation, azimuth = np.degrees(np.arctan2(-y, np.hypot(x, z))), np.arctan2(x, z)
    distance = np.sqrt(x * x + y * y + z * z)
    highest, step, count = BEAMS[kind]
    columns = np.round(azimuth / AZIMUTH).astype(int)
    first = columns.min()
    ranges = np.full((count, columns.max() - first + 1), np.inf)
    beam = np.round((highest - elevation) / step).astype(int)
    on_beam = np.abs(highest - beam * step - elevation) < 0.6 * np.degrees(1 / fy)  # half a pixel and a little more
    on_beam &= (beam >= 0) & (beam < count)
    np.minimum.at(ranges, (beam[on_beam], columns[on_beam] - first), distance[on_beam])
    for row in ranges:
        seen = np.flatnonzero(np.isfinite(row))
        for left, right in zip(seen[:-1], seen[1:]):
            row[left + 1 : right] = max(row[left], row[right])
    i, j = np.nonzero(np.isfinite(ranges) & (ranges < 100))
    r = ranges[i, j] + random.normal(0, 0.02, len(i))
    e, a = np.radians(highest - i * step), (j + first) * AZIMUTH
    x, y, z = r * np.cos(e) * np.sin(a), -r * np.sin(e) - MOUNT[1], r * np.cos(e) * np.cos(a) - MOUNT[2]
    return registered(x, y, z, 0.5, intrinsics, depth)


# Farthest range of a time-of-flight camera, metres: one of rooms, and one with the pulses of a lidar.
FLASHES = {"tof60": 8, "flash60": 100}
ASIDE = 0.05  # metres: how far it is to the right of the colour camera


def seen_from_aside(depth, focal):
    """Metres, inf = nothing: what a camera ASIDE of this one sees, with the same pixels.

    It looks past objects from its own place. What it sees there, the camera does not: that surface is continued from
    the farther one of its neighbours in the row.
    """
    v, u = np.nonzero(depth)
    z = depth[v, u] / 256.0
    to = np.round(u - focal * ASIDE / z).astype(int)
    far_to_near = np.argsort(-z)
    v, u, z, to = (values[far_to_near][to[far_to_near] >= 0] for values in (v, u, z, to))
    seen, source = np.full(depth.shape, np.inf), np.zeros(depth.shape, int)
    seen[v, to], source[v, to] = z, u
    for row, columns in zip(seen, source):
        known = np.flatnonzero(np.isfinite(row))
        for left, right in zip(known[:-1], known[1:]):
            if right > left + 1 and columns[right] == columns[left] + 1:  # no depth is missing between them
                row[left + 1 : right] = max(row[left], row[right])
    return seen


def flashed(depth, intrinsics, kind, random):
    """What a time-of-flight camera of 60x45 pixels measures, in 1/256 m at the colour camera's pixels.

    It has that camera's field of view. A pixel measures the mean of all that it sees, also of two surfaces, if a quarter
    of it returns light. The error is 1 %.
    """
    fx, fy, cx, cy = intrinsics[:4]
    (height, width), (rows, columns) = depth.shape, (45, 60)
    seen = seen_from_aside(depth, fx)
    v, u = np.nonzero(np.isfinite(seen))
    pixel = v * rows // height * columns + u * columns // width
    count = np.bincount(pixel, minlength=rows * columns)
    z = np.bincount(pixel, seen[v, u], minlength=rows * columns) / np.maximum(count, 1)
    measured = (count > 0.25 * height * width / (rows * columns)) & (z < FLASHES[kind])
    i, j = np.divmod(np.flatnonzero(measured), columns)
    z = z[measured] * (1 + random.normal(0, 0.01, len(i)))
    x, y = ((j + 0.5) * width / columns - 0.5 - cx) / fx * z + ASIDE, ((i + 0.5) * height / rows - 0.5 - cy) / fy * z
    return registered(x, y, z, 0.1, intrinsics, depth)


def movers(sequence):
    """(frame, id) of all objects that move."""
    with open(f"{sequence}/objects.csv", encoding="utf-8") as file:
        return {(int(row["frame"]), int(row["id"])) for row in csv.DictReader(file) if int(row["moving"])}


class MapPoints:
    """The map points of a SLAM host that it sees in a frame: 300 corners on what stands, each with depth at one pixel.

    A point stays where it is in the scene, with the disparity error that it got with its first frame. It is seen where
    the frame's depth is the point's. Frames come in their order.
    """

    COUNT = 300
    ERROR = 0.5  # pixels of disparity

    def __init__(self, sequence, frames, intrinsics, random):
        self.sequence, self.frames, self.random = sequence, frames, random
        self.intrinsics, self.focal_baseline = intrinsics, intrinsics[0] * (intrinsics[6] or MAP_BASELINE)
        self.poses = np.loadtxt(f"{sequence}/poses.txt").reshape(-1, 3, 4)
        self.places, self.errors = np.empty((0, 3)), np.empty(0)  # in the world; in pixels
        self.movers = movers(sequence)

    def __call__(self, depth, frame):
        """Their depth in 1/256 m, from the frame's true depth."""
        fx, fy, cx, cy = self.intrinsics[:4]
        height, width = depth.shape
        pose = self.poses[self.frames.index(frame)]
        instance = read(self.sequence, "instance", frame)
        moving = [i for f, i in self.movers if f == frame]
        usable = (depth > 0) & ~np.isin(instance, moving)
        x, y, z = ((self.places - pose[:, 3]) @ pose[:, :3]).T
        ahead = np.flatnonzero(z > 0.1)
        u, v = (np.round(c).astype(int) for c in (fx * x[ahead] / z[ahead] + cx, fy * y[ahead] / z[ahead] + cy))
        inside = (u >= 0) & (v >= 0) & (u < width) & (v < height)
        seen, u, v = ahead[inside], u[inside], v[inside]
        q = 256.0 / np.maximum(depth[v, u], 1)
        same = np.abs(1 / z[seen] - q) < np.maximum(0.05 / z[seen], 2 * self.ERROR / self.focal_baseline)
        same = np.flatnonzero(same & usable[v, u])[: self.COUNT]
        new_u, new_v = self.corners(usable, u[same], v[same], frame)
        new_z = depth[new_v, new_u] / 256.0
        rays = np.stack([(new_u - cx) / fx, (new_v - cy) / fy, np.ones(len(new_u))], 1)
        self.places = np.vstack([self.places, (rays * new_z[:, None]) @ pose[:, :3].T + pose[:, 3]])
        errors = self.random.normal(0, self.ERROR, len(new_u))
        shown = np.concatenate([self.errors[seen[same]], errors]) / self.focal_baseline
        self.errors = np.concatenate([self.errors, errors])
        u, v = np.concatenate([u[same], new_u]), np.concatenate([v[same], new_v])
        q = 256.0 / depth[v, u] + shown
        out = np.zeros(depth.shape, depth.dtype)
        out[v, u] = np.where(q > 1 / 200, np.round(256 / np.maximum(q, 1 / 200)), 0)
        return out

    def corners(self, usable, u, v, frame):
        """Pixels of as many new points as are missing, away from those that there are."""
        height, width = usable.shape
        apart = 0.3 * np.sqrt(height * width / self.COUNT)
        free = usable.astype(np.uint8)
        for centre in zip(u.tolist(), v.tolist()):
            cv2.circle(free, centre, int(apart), 0, -1)
        missing = self.COUNT - len(u)
        found = None
        if missing:
            found = cv2.goodFeaturesToTrack(grey(read(self.sequence, "rgb", frame)), missing, 0.005, apart, mask=free)
        return np.round(np.empty((0, 2)) if found is None else found[:, 0]).astype(int).T


def with_holes(depth, random):
    """Half of it, in patches of about 8 pixels."""
    height, width = depth.shape
    noise = random.random((height // 8 + 1, width // 8 + 1)).astype(np.float32)
    patches = cv2.resize(noise, (width, height), interpolation=cv2.INTER_LINEAR)
    return np.where(patches < np.median(patches), 0, depth).astype(depth.dtype)


def at_edges(depth, image):
    """Where the image's gradient is among the strongest 15 %, a pixel to each side."""
    smooth = cv2.GaussianBlur(grey(image), (0, 0), 1)
    gradient = np.hypot(cv2.Sobel(smooth, cv2.CV_32F, 1, 0), cv2.Sobel(smooth, cv2.CV_32F, 0, 1))
    strong = (gradient > np.percentile(gradient, 85)).astype(np.uint8)
    return np.where(cv2.dilate(strong, np.ones((3, 3))) > 0, depth, 0).astype(depth.dtype)


def rescaled(depth, kind, frame, sequence):
    """The depth of a frame by a network."""
    factor = np.exp(np.random.default_rng(frame).normal(0, 0.02))
    if kind == "objects5":
        instance = read(sequence, "instance", frame)
        factor = np.ones(depth.shape)
        for i in np.unique(instance[instance > 0]):
            factor[instance == i] = np.exp(np.random.default_rng(int(i)).normal(0, 0.05))
    return np.where(depth > 0, np.clip(np.round(depth * factor), 1, 65535), 0).astype(depth.dtype)


KINDS = (*BEAMS, *FLASHES, "mappoints", "holes50", "thin50", "edges", *NETWORKS, *depth_cameras.KINDS)


def by_depth_camera(depth, kind, frame, sequence, intrinsics):
    """The depth of a frame by a camera for rooms."""
    [path] = glob.glob(f"{sequence}/rgb/{frame:06d}.*")
    image, instance = cv2.imread(path, cv2.IMREAD_GRAYSCALE), read(sequence, "instance", frame)
    random = np.random.default_rng(frame)
    return depth_cameras.measured(kind, depth, image, instance, intrinsics[0], intrinsics[6], random)


def by_network(sequence, frames, intrinsics):
    """The depth of a frame by a network."""
    network = depth_networks.Network(intrinsics, movers(sequence))
    poses = np.loadtxt(f"{sequence}/poses.txt").reshape(-1, 3, 4)

    def measured(depth, frame):
        true, instance = read(sequence, "depth_true", frame), read(sequence, "instance", frame)
        surface = depth_networks.complete(depth / 256.0, instance) if true is None else true / 256.0
        return np.round(256 * network(surface, instance, frame, poses[frames.index(frame)])).astype(depth.dtype)

    return measured


def sensor(kind, sequence, frames, intrinsics, random):
    """The sensor of a kind: a function of a frame's recorded depth and its number. It returns that sensor's depth."""

    def exact(depth, frame):
        true = read(sequence, "depth_true", frame)
        return depth if true is None else true

    if kind in BEAMS:
        return lambda depth, frame: scanned(exact(depth, frame), intrinsics, kind, random)
    if kind in FLASHES:
        return lambda depth, frame: flashed(exact(depth, frame), intrinsics, kind, random)
    if kind == "mappoints":
        points = MapPoints(sequence, frames, intrinsics, random)
        return lambda depth, frame: points(exact(depth, frame), frame)
    if kind == "holes50":
        return lambda depth, _: with_holes(depth, random)
    if kind == "thin50":
        return lambda depth, _: np.where(random.random(depth.shape) < 0.5, 0, depth).astype(depth.dtype)
    if kind == "edges":
        return lambda depth, frame: at_edges(depth, read(sequence, "rgb", frame))
    if kind == "network5":
        return by_network(sequence, frames, intrinsics)
    if kind in depth_cameras.KINDS:
        return lambda depth, frame: by_depth_camera(depth, kind, frame, sequence, intrinsics)
    return lambda depth, frame: rescaled(depth, kind, frame, sequence)


def described(kind, baseline, lines):
    """Of intrinsics.txt for a kind: the baseline, and the lines after the first. Arguments: those of the recording."""
    if kind in BEAMS:
        return 0, "depth lidar\n"
    if kind in FLASHES or kind in NETWORKS:
        return 0, "depth unknown\n"
    if kind == "mappoints":
        return baseline or MAP_BASELINE, "depth stereo\n"
    if kind in depth_cameras.KINDS:
        return baseline, "depth rgbd\n"
    return baseline, lines
