// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
"use strict";

// Buttons, keys and playing; shows the first frame at the end.
(() => {
  const byId = (id) => document.getElementById(id);
  let timer = null;

  function pause() {
    clearTimeout(timer);
    timer = null;
    byId("play").textContent = "Play";
  }

  // At the recording's own pace; a long gap in it is not waited for.
  function schedule() {
    const next = run.frames[view.index + 1];
    if (!next) return pause();
    const seconds = Math.min(1, Math.max(0.01, next.time - view.frame.time)) / Number(byId("rate").value);
    timer = setTimeout(() => {
      view.go(view.index + 1);
      schedule();
    }, 1000 * seconds);
  }

  function togglePlay() {
    if (timer !== null) return pause();
    if (run.frames.length < 2) return;
    if (view.index === run.frames.length - 1) view.go(0);
    byId("play").textContent = "Pause";
    schedule();
  }

  function go(index) {
    pause();
    view.go(index);
  }

  // To the next frame, in this direction, in which the selected object's state differs from that of the frame before.
  function goToChange(direction) {
    if (view.id === null) return;
    const state = (i) => (run.track(view.id).at[i] || {}).state;
    for (let i = view.index + direction; i > 0 && i < run.frames.length; i += direction)
      if (state(i) !== undefined && state(i) !== state(i - 1)) return go(i);
  }

  // To the next object that is visible in this frame.
  function selectNext(direction) {
    if (!view.frame) return;
    const ids = view.frame.objects.filter((object) => object.area > 0).map((object) => object.id);
    if (ids.length === 0) return;
    const place = ids.indexOf(view.id);
    const next = place < 0 ? (direction > 0 ? 0 : ids.length - 1) : (place + direction + ids.length) % ids.length;
    view.select(ids[next]);
  }

  const keys = [
    { key: "ArrowLeft", name: "left, right", does: "one frame back or forward; with shift ten",
      run: (event) => go(view.index - (event.shiftKey ? 10 : 1)) },
    { key: "ArrowRight", run: (event) => go(view.index + (event.shiftKey ? 10 : 1)) },
    { key: "Home", name: "Home, End", does: "first or last frame", run: () => go(0) },
    { key: "End", run: () => go(run.frames.length - 1) },
    { key: " ", name: "space", does: "play or pause", run: togglePlay },
    { key: "ArrowUp", name: "up, down", does: "select another object of this frame", run: () => selectNext(-1) },
    { key: "ArrowDown", run: () => selectNext(1) },
    { key: "p", name: "p, n", does: "previous or next change of the selected object's state",
      run: () => goToChange(-1) },
    { key: "n", run: () => goToChange(1) },
    { key: "Escape", name: "Esc", does: "select nothing", run: () => view.select(null) },
    ...view.layers.map((layer, i) => ({ key: String(i + 1), name: String(i + 1), does: `layer: ${layer.title}`,
      run: () => view.toggle(layer.name) })),
    { key: "?", name: "?", does: "this list", run: () => byId("help").showModal() },
  ];
  for (const { name, does } of keys)
    if (name) byId("keys").append(make.html("dt", {}, name), make.html("dd", {}, does));

  document.addEventListener("keydown", (event) => {
    // A dialog, a list and a button have their own use of keys.
    const ownKeys = event.target.closest("select") ||
      (event.key === " " && event.target.closest("button, label, input"));
    if (event.ctrlKey || event.altKey || event.metaKey || byId("help").open || ownKeys) return;
    const found = keys.find(({ key }) => key === event.key);
    if (!found) return;
    event.preventDefault();
    found.run(event);
  });

  byId("first").addEventListener("click", () => go(0));
  byId("back").addEventListener("click", () => go(view.index - 1));
  byId("play").addEventListener("click", togglePlay);
  byId("forward").addEventListener("click", () => go(view.index + 1));
  byId("last").addEventListener("click", () => go(run.frames.length - 1));
  byId("previous-change").addEventListener("click", () => goToChange(-1));
  byId("next-change").addEventListener("click", () => goToChange(1));
  byId("help-button").addEventListener("click", () => byId("help").showModal());
  addEventListener("hashchange", view.restore);
  view.restore();
})();
