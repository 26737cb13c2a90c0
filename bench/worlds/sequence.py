# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Writes a sequence folder, of the layout of docs/evaluation.md, from rendered pictures and the poses of all that is in
them: image, depth and masks as sensors and a network give them, and the truth."""
import os

import cv2
import numpy as np

import sensors
import truth

# Takes the axes of a sequence's objects (x right, y down, z forward) to those of the things here (y forward, z up).
OBJECT_AXES = np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])
FOLDERS = ("rgb", "depth", "depth_true", "masks", "instance")


def write(folder, recording, kinds, poses, pictures):
    """Writes the pictures (rendered.Picture) as frames 0, 1, ...; the world of the poses is the camera of the first.
    `kinds` names each thing, by its id; `poses` are rendered.Poses."""
    for name in FOLDERS:
        os.makedirs(f"{folder}/{name}")
    random = np.random.default_rng(recording.seed)
    random.random((recording.height, recording.width))  # unused; without it all noise would be another
    frames, objects = [], []
    for number, picture in enumerate(pictures):
        write_images(folder, number, picture, recording, kinds, poses, random)
        for thing, (speed, turn, pixels) in truth.motions(picture, recording, poses).items():
            moving = speed > recording.slowest or turn > recording.slowest_turn
            objects.append(f"{number},{thing},{kinds[thing]},{int(moving)},{speed:.4f},{pixels}")
        frames.append(picture.frame)
    write_lines(f"{folder}/intrinsics.txt", intrinsics(recording))
    write_lines(f"{folder}/objects.csv", ["frame,id,class,moving,speed_mps,pixels"] + objects)
    write_poses(folder, frames, poses)


def write_images(folder, number, picture, recording, kinds, poses, random):
    def write_image(name, image):
        cv2.imwrite(f"{folder}/{name}/{number:06d}.png", image)

    instance = truth.instances(picture, poses)
    write_image("instance", instance.astype(np.uint16))
    write_image("depth_true", stored(picture.depth))
    write_image("rgb", sensors.noisy_image(picture.image, random))
    write_image("depth", stored(measured_depth(picture, instance, recording, len(kinds), random)))
    masks, found = sensors.network_masks(instance, picture.depth, random)
    write_image("masks", masks)
    write_lines(f"{folder}/masks/{number:06d}.csv", ["id,class,score"] + [
        f"{mask_id},{kinds[thing]},{score:.2f}" for mask_id, (thing, score) in found.items()])


def measured_depth(picture, instance, recording, things, random):
    """Metres, as the recording's sensor measures them."""
    lens = recording.focal_length, recording.baseline, recording.max_depth
    if recording.sensor == "rgbd":
        return sensors.Rgbd(*lens).measure(picture.depth, random)
    grey = cv2.cvtColor(picture.image, cv2.COLOR_BGR2GRAY)
    return sensors.Stereo(*lens).measure(picture.depth, grey, instance, things, random)


def stored(depth):
    """16 bit, metres * 256; 0 where there is none or it is too far for that."""
    units = np.rint(depth * 256)
    return np.where((units < 0) | (units > 65535), 0, units).astype(np.uint16)


def intrinsics(recording):
    cx, cy = recording.centre
    return [f"{recording.focal_length:f} {recording.focal_length:f} {cx:f} {cy:f} {recording.width} {recording.height} "
            f"{recording.baseline:f} {recording.rate:g}", f"depth {recording.sensor}"]


def write_poses(folder, frames, poses):
    """poses.txt and object_poses.txt."""
    world = np.linalg.inv(poses.camera[frames[0]])
    write_lines(f"{folder}/poses.txt", [numbers(world @ poses.camera[frame]) for frame in frames])
    write_lines(f"{folder}/object_poses.txt", [
        f"{number} {thing} {numbers(world @ pose @ OBJECT_AXES)}"
        for number, frame in enumerate(frames) for thing, pose in enumerate(poses.things[frame], start=1)])


def numbers(pose):
    """The upper three rows of a pose, one after the other."""
    return " ".join(f"{value:.12g}" for value in pose[:3].ravel())


def write_lines(path, lines):
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(line + "\n" for line in lines)
