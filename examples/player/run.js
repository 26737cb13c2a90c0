// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
"use strict";

// The run, as frame_data.hpp describes it, read from the page.
const run = (() => {
  const data = JSON.parse(document.getElementById("run").textContent);
  const frames = [...document.querySelectorAll("script.frame")].map((element) => JSON.parse(element.textContent));
  const jpegs = [...document.querySelectorAll("script.jpeg")];

  // Each object over time: at[i] is what frame i says of it, or undefined.
  const tracks = new Map();
  frames.forEach((frame, i) => {
    for (const object of frame.objects) {
      if (!tracks.has(object.id)) tracks.set(object.id, { id: object.id, first: i, at: [] });
      tracks.get(object.id).at[i] = object;
      tracks.get(object.id).last = i;
    }
  });

  // Masks that come late are of a frame, but not in its result.
  const masksUsed = (frame) => frame.masks && frame.objects.some((object) => object.segmented);
  const cameraFailed = (frame) => ["lost", "too_little_depth"].includes(frame.camera.status);

  // Camera motions that a later frame proved to be wrong, by the number of their frame: that later frame, and by how many
  // metres.
  const revisions = new Map();
  for (const frame of frames)
    for (const { frame: number, wrong } of frame.camera.revised || []) revisions.set(number, { by: frame.frame, wrong });
  const revisionOf = (frame) => revisions.get(frame.frame);

  // [first, last] of the frames in a row for which test(frame, i) holds.
  function intervals(test) {
    const found = [];
    frames.forEach((frame, i) => {
      if (!test(frame, i)) return;
      if (found.length > 0 && found[found.length - 1][1] === i - 1) found[found.length - 1][1] = i;
      else found.push([i, i]);
    });
    return found;
  }

  // "frame 3", "frames 3, 8 to 11"
  function inWords(list) {
    const number = (i) => frames[i].frame;
    const parts = list.map(([first, last]) => first === last ? number(first) : `${number(first)} to ${number(last)}`);
    const single = list.length === 1 && list[0][0] === list[0][1];
    return (single ? "frame " : "frames ") + parts.join(", ");
  }

  const stateNames = { moving: "moving", static: "static", unobservable: "not decided" };

  return {
    ...data,
    frames,
    tracks: [...tracks.values()].sort((a, b) => a.id - b.id),
    track: (id) => tracks.get(id),
    imageOf: (i) => "data:image/jpeg;base64," + jpegs[i].textContent,
    cameraFailed,
    revisionOf,
    masksUsed,
    intervals,
    inWords,
    className: (object) => data.classNames[object.class] || object.class,
    // What to show of a measured object: its centroid's speed, or its points' where turning moves them faster.
    speedOf: (object) => object.turning ? { speed: object.pointSpeed, sigma: object.pointSigma } : object,
    // Near things move at centimetres per second.
    number: (value, decimals) => value.toFixed(value < 0.1 ? 3 : decimals),
    stateName: (object) => stateNames[object.state] || object.state,
  };
})();
