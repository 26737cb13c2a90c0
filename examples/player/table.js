// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
"use strict";

// All objects of the run, with what the shown frame says of them.
(() => {
  const presentOnly = document.getElementById("present-only");
  const head = ["object", "over time", "state", "P(moving)", "m/s", "sigma", "metres", "measured?"];
  const body = make.html("tbody");
  const container = document.getElementById("table");
  container.append(make.html("table", {},
    make.html("thead", {}, make.html("tr", {}, ...head.map((name) => make.html("th", {}, name)))), body));

  const number = (value) => (value === undefined ? "" : run.number(value, value < 10 ? 2 : 1));

  const rows = run.tracks.map((track) => {
    const cells = head.map(() => make.html("td"));
    cells[0].textContent = track.id;
    cells[1].append(trackStrip(track));
    cells[7].className = "words";
    const row = make.html("tr", { tabindex: 0, "data-id": track.id }, ...cells);
    row.addEventListener("click", () => view.select(track.id));
    row.addEventListener("keydown", (event) => { if (event.key === "Enter") view.select(track.id); });
    body.append(row);
    return { track, row, cells };
  });

  function show({ track, row, cells }) {
    const object = track.at[view.index];
    row.classList.toggle("selected", track.id === view.id);
    row.classList.toggle("absent", !object || object.area === 0);
    row.hidden = presentOnly.checked && !object && track.id !== view.id;
    cells[2].className = object ? object.state : "";
    cells[2].textContent = object ? run.stateName(object) : "";
    cells[3].textContent = number(object && object.p);
    const { speed, sigma } = object ? run.speedOf(object) : {};
    cells[4].textContent = number(speed);
    cells[5].textContent = number(sigma);
    cells[6].textContent = number(object && object.range);
    cells[7].textContent = object ? object.words : "not in this frame";
  }

  // Moves the table alone, not the page.
  function reveal(row) {
    const top = row.offsetTop - body.offsetTop;
    const room = container.clientHeight - body.offsetTop;
    if (top < container.scrollTop) container.scrollTop = top;
    if (top + row.offsetHeight > container.scrollTop + room) container.scrollTop = top + row.offsetHeight - room;
  }

  let shownId = null;
  presentOnly.addEventListener("change", () => view.update());
  view.onChange(() => {
    rows.forEach(show);
    if (view.id === shownId) return;
    shownId = view.id;
    const selected = rows.find(({ track }) => track.id === shownId);
    if (selected) reveal(selected.row);
  });
})();
