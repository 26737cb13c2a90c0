// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
"use strict";

// What is shown: the frame, the selected object and the layers. Parts of the page redraw themselves when it changes.
const view = (() => {
  const layers = [
    { name: "moving", title: "moving", colour: "--moving", on: true },
    { name: "static", title: "static", colour: "--static", on: true },
    { name: "unobservable", title: "not decided", colour: "--unobservable", on: true },
    { name: "network", title: "network", colour: "--network", on: false },
    { name: "predicted", title: "predicted", colour: "--predicted", on: false },
    { name: "texture", title: "points", colour: "--texture", on: false },
    { name: "names", title: "names", colour: "--ink", on: true },
  ];
  const state = { index: 0, id: null };
  const listeners = [];

  // The page's address leads back to this frame and object. Browsers limit how often it may change.
  let remembering = null;
  function remember() {
    const object = state.id === null ? "" : "&object=" + state.id;
    history.replaceState(null, "", "#frame=" + run.frames[state.index].frame + object);
  }

  function update() {
    clearTimeout(remembering);
    if (run.frames.length > 0) remembering = setTimeout(remember, 300);
    for (const listener of listeners) listener();
  }

  return {
    layers,
    get index() { return state.index; },
    get frame() { return run.frames[state.index]; },
    get id() { return state.id; },
    // What the shown frame says of the selected object, or undefined.
    get object() { return state.id === null ? undefined : run.track(state.id).at[state.index]; },
    isOn: (name) => layers.find((layer) => layer.name === name).on,
    onChange: (listener) => listeners.push(listener),
    update,
    go(index) {
      const last = Math.max(0, run.frames.length - 1);
      state.index = Math.min(last, Math.max(0, Math.round(index)));
      update();
    },
    // id null: no object.
    select(id) {
      state.id = id !== null && run.track(id) ? id : null;
      update();
    },
    toggle(name) {
      const layer = layers.find((each) => each.name === name);
      layer.on = !layer.on;
      update();
    },
    // Frame and object of the address, else the first frame without an object.
    restore() {
      const wanted = new URLSearchParams(location.hash.slice(1));
      const index = run.frames.findIndex((frame) => String(frame.frame) === wanted.get("frame"));
      const id = Number(wanted.get("object"));
      state.index = Math.max(0, index);
      state.id = run.track(id) ? id : null;
      update();
    },
  };
})();
