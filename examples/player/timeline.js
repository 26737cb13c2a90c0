// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
"use strict";

// Title of the page and of the frame, what is known of the camera, and the rows of the timeline.
(() => {
  const byId = (id) => document.getElementById(id);
  const timeline = byId("timeline");
  const slider = make.html("input", { type: "range", min: 0, max: Math.max(0, run.frames.length - 1), step: 1,
    "aria-label": "Frame" });
  slider.addEventListener("input", () => view.go(Number(slider.value)));

  function addRow(name, content) {
    const row = make.html("div", {}, content);
    timeline.append(make.html("span", {}, name), row);
    return row;
  }

  function scrubbed(svg) {
    onScrub(svg, (share) => view.go(Math.floor(share * run.frames.length)));
    svg.append(make.svg("rect", { class: "now", y: 0, width: 1, height: 1 }));
    return svg;
  }

  addRow("frame", slider);
  addRow("camera", scrubbed(strip((i) => run.frames[i].camera.status, (i) => run.frames[i].camera.words)));
  addRow("network masks", scrubbed(strip((i) => run.frames[i].masks && "network",
    (i) => (run.frames[i].masks ? "the network's masks are of this frame" : ""))));
  const selected = addRow("selected object", scrubbed(strip(() => "", () => "")));

  function frames([first, last]) {
    const number = (i) => run.frames[i].frame;
    return first === last ? `frame ${number(first)}` : `frames ${number(first)} to ${number(last)}`;
  }
  const lost = run.intervals(run.cameraFailed);
  byId("lost").textContent = lost.length === 0 ? "" : "Camera's motion not found: " + lost.map(frames).join(", ") + ".";

  byId("title").textContent = run.sequence;
  byId("summary").textContent = run.frames.length === 0 ? "This run has no frames."
    : `${run.frames.length} ${run.frames.length === 1 ? "frame" : "frames"}, ${run.tracks.length} ` +
      `${run.tracks.length === 1 ? "object" : "objects"}, ${run.width} x ${run.height}, dot ${run.version}`;

  function cameraText(frame) {
    const camera = frame.camera;
    let text = camera.words;
    if (camera.speed !== undefined && !run.cameraFailed(frame)) text += ` Its speed is ${camera.speed.toFixed(1)} m/s.`;
    if (camera.phi !== undefined)
      text += ` ${camera.inliers} of ${camera.points} background points agree, phi ${camera.phi.toFixed(2)}.`;
    return text + (frame.masks ? " This frame has the network's masks." : " Masks are carried on from earlier frames.");
  }

  let shownId = null;
  view.onChange(() => {
    const frame = view.frame;
    if (!frame) return;
    slider.value = view.index;
    byId("frame-title").textContent = `Frame ${frame.frame}, ${frame.time.toFixed(2)} s`;
    byId("camera").textContent = cameraText(frame);
    byId("camera").className = run.cameraFailed(frame) ? "bad" : "";
    if (view.id !== shownId) {
      shownId = view.id;
      const content = shownId === null ? strip(() => "", () => "") : trackStrip(run.track(shownId));
      selected.replaceChildren(scrubbed(content));
    }
    for (const mark of timeline.querySelectorAll("rect.now")) mark.setAttribute("x", view.index);
  });
})();
