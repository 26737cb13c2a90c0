// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
"use strict";

// Making elements. Text is never read as HTML.
const make = (() => {
  function fill(element, attributes, children) {
    for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
    element.append(...children);
    return element;
  }
  return {
    html: (name, attributes = {}, ...children) => fill(document.createElement(name), attributes, children),
    svg: (name, attributes = {}, ...children) =>
      fill(document.createElementNS("http://www.w3.org/2000/svg", name), attributes, children),
  };
})();

// A row of colours, one for each frame. classOf(i) and titleOf(i) give the CSS class and the tip of frame i; frames
// without a class stay empty.
function strip(classOf, titleOf) {
  const count = run.frames.length;
  const svg = make.svg("svg", { class: "strip", viewBox: `0 0 ${Math.max(1, count)} 1`, preserveAspectRatio: "none" });
  for (let i = 0; i < count; ) {
    const name = classOf(i), title = titleOf(i), begin = i;
    while (i < count && classOf(i) === name && titleOf(i) === title) ++i;
    if (!name) continue;
    const rect = make.svg("rect", { class: name, x: begin, y: 0, width: i - begin, height: 1 });
    rect.append(make.svg("title", {}, title));
    svg.append(rect);
  }
  return svg;
}

// The strip of an object's states.
function trackStrip(track) {
  const at = (i) => track.at[i];
  return strip(
    (i) => at(i) && at(i).state + (at(i).area > 0 ? "" : " hidden"),
    (i) => at(i) ? run.stateName(at(i)) + (at(i).area > 0 ? "" : ", not visible") : "");
}

// Calls place(share) for 0 <= share <= 1 of the element's width, where the pointer is pressed or drawn to.
function onScrub(element, place) {
  const call = (event) => {
    const box = element.getBoundingClientRect();
    place(Math.min(1, Math.max(0, (event.clientX - box.left) / box.width)));
  };
  element.addEventListener("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    call(event);
  });
  element.addEventListener("pointermove", (event) => {
    if (element.hasPointerCapture(event.pointerId)) call(event);
  });
}
