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
  function revisionText(frame) {
    const revision = run.revisionOf(frame);
    if (!revision) return "";
    const size = revision.wrong === undefined ? "" : ` by ${revision.wrong.toFixed(2)} m`;
    return ` Its motion was revised in frame ${revision.by}: it was wrong${size}.`;
  }
  addRow("camera", scrubbed(strip(
    (i) => run.frames[i].camera.status + (run.revisionOf(run.frames[i]) ? " revised" : ""),
    (i) => run.frames[i].camera.words + revisionText(run.frames[i]))));
  const maskText = (frame) => !frame.masks ? "No masks came with this frame: earlier ones are carried on."
    : run.masksUsed(frame) ? "The network's masks of this frame are used."
    : "The network's masks of this frame came too late for its result, or show nothing.";
  addRow("network masks", scrubbed(strip(
    (i) => run.frames[i].masks && (run.masksUsed(run.frames[i]) ? "network" : "network hidden"),
    (i) => maskText(run.frames[i]))));
  const selected = addRow("selected object", scrubbed(strip(() => "", () => "")));

  const lost = run.intervals(run.cameraFailed);
  byId("lost").textContent = lost.length === 0 ? "" : "Camera's motion not found: " + run.inWords(lost) + ".";

  const revised = run.intervals(run.revisionOf);
  byId("revised").textContent = revised.length === 0 ? "" : "Camera's motion revised later: " + run.inWords(revised) + ".";

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
    text += revisionText(frame);
    if (camera.revised) {
      const corrected = run.intervals((other) => camera.revised.some((item) => item.frame === other.frame));
      text += ` It shows that the camera's motion in ${run.inWords(corrected)} was wrong.`;
    }
    return `${text} ${maskText(frame)}`;
  }

  let shownId = null;
  view.onChange(() => {
    const frame = view.frame;
    if (!frame) return;
    slider.value = view.index;
    byId("frame-title").textContent = `Frame ${frame.frame}, ${frame.time.toFixed(2)} s`;
    byId("camera").textContent = cameraText(frame);
    byId("camera").className = run.cameraFailed(frame) || run.revisionOf(frame) ? "bad" : "";
    if (view.id !== shownId) {
      shownId = view.id;
      const content = shownId === null ? strip(() => "", () => "") : trackStrip(run.track(shownId));
      selected.replaceChildren(scrubbed(content));
    }
    for (const mark of timeline.querySelectorAll("rect.now")) mark.setAttribute("x", view.index);
  });
})();
