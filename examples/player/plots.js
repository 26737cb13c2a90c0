// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
"use strict";

// The selected object: why it has its state, and its figures over time.
(() => {
  const byId = (id) => document.getElementById(id);
  const width = 640, height = 130, left = 44, right = 8, top = 8, bottom = 18;
  const xOf = (i) => left + ((width - left - right) * (i + 0.5)) / Math.max(1, run.frames.length);

  // A round number of at least `value`.
  function roundUp(value) {
    const unit = Math.pow(10, Math.floor(Math.log10(value)));
    return unit * [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((factor) => factor * unit >= value * 0.999);
  }

  // The frames in a row that have a value: lists of [i, value].
  function pieces(values) {
    const found = [];
    values.forEach((value, i) => {
      if (value === undefined) return;
      const last = found[found.length - 1];
      if (last && last[last.length - 1][0] === i - 1) last.push([i, value]);
      else found.push([[i, value]]);
    });
    return found;
  }

  // One plot. series: [{class, values}]; band: [[low, high] or undefined] a frame; levels: [{value, class}].
  function plot({ name, title, series, band = [], levels = [], ceiling }) {
    const yOf = (value) => top + (height - top - bottom) * (1 - Math.min(ceiling, Math.max(0, value)) / ceiling);
    const text = (x, y, anchor, words) => svg.append(make.svg("text", { x, y, "text-anchor": anchor }, words));
    const level = (kind, value) =>
      svg.append(make.svg("line", { class: kind, x1: left, x2: width - right, y1: yOf(value), y2: yOf(value) }));
    const points = (piece) => piece.map(([i, value]) => `${xOf(i).toFixed(1)},${yOf(value).toFixed(1)}`);
    const svg = make.svg("svg", { viewBox: `0 0 ${width} ${height}`, id: "plot-" + name });
    for (const value of [0, ceiling / 2, ceiling]) {
      level("tick", value);
      text(left - 6, yOf(value) + 4, "end", String(+value.toPrecision(3)));
    }
    for (const piece of pieces(band)) {
      const low = piece.map(([i, range]) => [i, range[0]]).reverse();
      const high = piece.map(([i, range]) => [i, range[1]]);
      svg.append(make.svg("polygon", { class: "band", points: points(high.concat(low)).join(" ") }));
    }
    for (const { value, class: kind } of levels) level("limit " + kind, value);
    for (const { class: kind, values } of series) {
      for (const piece of pieces(values)) {
        svg.append(make.svg("polyline", { class: kind, points: points(piece).join(" ") }));
        const [i, value] = piece[0];
        if (piece.length === 1 && !kind) svg.append(make.svg("circle", { cx: xOf(i), cy: yOf(value), r: 2 }));
      }
    }
    const last = run.frames.length - 1;
    for (const i of new Set([0, Math.round(last / 2), last]))
      text(xOf(i), height - 4, "middle", String(run.frames[i].frame));
    svg.append(make.svg("line", { class: "now", y1: top, y2: height - bottom }));
    onScrub(svg, (share) => view.go(((share * width - left) / (width - left - right)) * run.frames.length - 0.5));
    return make.html("figure", { style: "margin: 0" }, make.html("h3", {}, title), svg);
  }

  function plotsOf(track) {
    const each = (value) => run.frames.map((_, i) => (track.at[i] ? value(track.at[i]) : undefined));
    const figure = (name) => each((object) => object[name]);
    const largest = (values) => Math.max(0, ...values.filter((value) => value !== undefined));
    const speed = figure("speed"), points = figure("pointSpeed"), range = figure("range");
    const levels = run.decide === undefined ? []
      : [{ value: run.decide, class: "moving" }, { value: 1 - run.decide, class: "static" }];
    return [
      plot({ name: "speed",
        title: "speed, m/s: measured with its sigma (blue), of its points, turning included (magenta), " +
          "fused over time (teal), limit (dashed)",
        // A wild sigma does not flatten the rest.
        ceiling: roundUp(Math.max(0.05, 1.1 * largest(speed.concat(points, figure("limit"))))),
        series: [{ class: "limit", values: figure("limit") }, { class: "points", values: points },
          { class: "fused", values: figure("fused") }, { class: "", values: speed }],
        band: each((o) => (o.speed === undefined ? undefined : [o.speed - o.sigma, o.speed + o.sigma])) }),
      plot({ name: "p", title: "P(moving): above the upper line moving, below the lower one static", ceiling: 1,
        series: [{ class: "", values: figure("p") }], levels }),
      plot({ name: "phi", title: "phi: how well the pixels look as before (dashed: least of a new motion)", ceiling: 1,
        series: [{ class: "", values: figure("phi") }], levels: [{ value: run.minPhi, class: "moving" }] }),
      plot({ name: "range", title: "range, metres", ceiling: roundUp(Math.max(1, largest(range))),
        series: [{ class: "", values: range }] }),
    ];
  }

  function facts(track, object) {
    const number = (i) => run.frames[i].frame;
    const decided = track.at.findIndex((o) => o && o.decided);
    const list = [`Frames ${number(track.first)} to ${number(track.last)}.`,
      decided < 0 ? "Never decided." : `First decided in frame ${number(decided)}.`];
    if (track.at.every((o) => !o || o.speed === undefined)) list.push("Never measured.");
    const hidden = run.intervals((_, i) => track.at[i] && track.at[i].area === 0);
    if (hidden.length > 0) list.push(`Not visible in ${run.inWords(hidden)}.`);
    if (object) {
      if (object.class >= 0) list.push(`Class ${run.className(object)}, score ${object.score.toFixed(2)}.`);
      if (object.discovered) list.push("Found by its motion, no mask shows it.");
      if (object.area > 0) list.push(`${object.area} pixels.`);
      if (run.masksUsed(view.frame))
        list.push(`The network ${object.segmented ? "shows" : "does not show"} it in this frame.`);
      if (object.points) list.push(`${object.inliers} of ${object.points} points agree.`);
    }
    return list.join(" ");
  }

  let shownId;
  view.onChange(() => {
    const track = view.id === null ? null : run.track(view.id);
    const object = view.object;
    for (const id of ["previous-change", "next-change"]) byId(id).disabled = !track;
    byId("object-title").textContent = !track ? "No object selected"
      : `Object ${track.id}` + (object ? `: ${run.stateName(object)}` : " is not in this frame");
    byId("why").textContent = !track ? "Click on an object in the picture or in the table." : object ? object.why : "";
    byId("facts").textContent = track ? facts(track, object) : "";
    if (view.id !== shownId) {
      shownId = view.id;
      byId("plots").replaceChildren(...(track ? plotsOf(track) : []));
    }
    for (const mark of byId("plots").querySelectorAll("line.now")) {
      mark.setAttribute("x1", xOf(view.index));
      mark.setAttribute("x2", xOf(view.index));
    }
  });
})();
