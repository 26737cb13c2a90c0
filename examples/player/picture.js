// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
"use strict";

// The frame's picture with its layers.
(() => {
  const image = document.getElementById("image");
  const overlay = document.getElementById("overlay");
  const picture = document.getElementById("picture");
  overlay.setAttribute("viewBox", `-0.5 -0.5 ${run.width} ${run.height}`);
  picture.style.aspectRatio = `${run.width} / ${run.height}`;
  picture.style.maxWidth = `min(100%, ${Math.round((62 * run.width) / run.height)}vh)`;

  const pathOf = (outlines) =>
    (outlines || []).map((flat) => {
      let d = "M";
      for (let i = 0; i < flat.length; i += 2) d += `${flat[i]} ${flat[i + 1]} `;
      return d + "Z";
    }).join("");

  function dots(flat) {
    let d = "";
    for (let i = 0; i < flat.length; i += 2) d += `M${flat[i]} ${flat[i + 1]}h0`;
    return make.svg("path", { class: "texture", d });
  }

  function drawObject(object) {
    const selected = object.id === view.id ? " selected" : "";
    const path = make.svg("path", { class: `object ${object.state}${selected}`, d: pathOf(object.outline) });
    path.dataset.id = object.id;
    path.append(make.svg("title", {}, `object ${object.id}: ${run.stateName(object)}`));
    overlay.append(path);
  }

  // A name stands above its object; where names would overlap, the speed is left out.
  function drawNames(objects) {
    const size = run.width / 95;
    const taken = [];
    for (const object of objects) {
      const [left, top, width] = object.box;
      const x = left + width / 2, y = top > 1.4 * size ? top - 0.35 * size : top + size;
      const halfWidth = (text) => 0.3 * size * text.length;
      const isFree = (text) => taken.every((other) =>
        Math.abs(other.y - y) > size || Math.abs(other.x - x) > halfWidth(text) + halfWidth(other.text));
      const { speed } = run.speedOf(object);
      const withSpeed = `#${object.id} ${run.number(speed || 0, 1)} m/s`;
      const measured = object.state === "moving" && speed !== undefined;
      const text = measured && isFree(withSpeed) ? withSpeed : `#${object.id}`;
      taken.push({ x, y, text });
      overlay.append(make.svg("text", { x, y, "font-size": size }, text));
    }
  }

  function draw() {
    overlay.replaceChildren();
    const frame = view.frame;
    if (!frame) return;
    image.src = run.imageOf(view.index);
    image.alt = `frame ${frame.frame}`;
    // Large ones first: their names have the first choice.
    const shown = frame.objects.filter((object) => object.area > 0 && view.isOn(object.state))
      .sort((a, b) => b.area - a.area);
    shown.forEach(drawObject);
    if (view.isOn("texture")) {
      overlay.append(dots(frame.texture || []));
      for (const object of frame.objects) overlay.append(dots(object.texture || []));
    }
    if (view.isOn("network"))
      for (const outlines of frame.network || [])
        overlay.append(make.svg("path", { class: "network", d: pathOf(outlines) }));
    if (view.isOn("predicted"))
      for (const object of frame.objects)
        if (object.predicted) overlay.append(make.svg("path", { class: "predicted", d: pathOf(object.predicted) }));
    if (view.isOn("names")) drawNames(shown);
  }

  overlay.addEventListener("click", (event) => {
    const id = event.target.dataset.id;
    view.select(id === undefined ? null : Number(id));
  });

  for (const [i, layer] of view.layers.entries()) {
    const box = make.html("input", { type: "checkbox", id: "layer-" + layer.name });
    const swatch = make.html("i", { style: `background: var(${layer.colour})` });
    box.addEventListener("change", () => view.toggle(layer.name));
    document.getElementById("layers").append(make.html("label", { title: `key ${i + 1}` }, box, swatch, layer.title));
  }
  view.onChange(() => {
    for (const layer of view.layers) document.getElementById("layer-" + layer.name).checked = layer.on;
    draw();
  });
})();
