// SPDX-FileCopyrightText: 2026 The dot authors
// SPDX-License-Identifier: MIT
#pragma once

namespace eval {

/// The page's style: light, or dark where the reader's system is.
constexpr const char* page_style = R"(
:root { color-scheme: light dark;
  --page: #f5f5f2; --card: #ffffff; --ink: #1b1f24; --soft: #5d6672; --grid: #e4e6e8; --edge: #e2e2dd;
  --moving: #f2690d; --static: #3aa655; --unobservable: #a9b0b8; --missed: #4a5058; --bad: #c62828;
  --rate0: #2a63c8; --rate1: #16a3a0; --rate2: #d99a00; --rate3: #d1466f; --rate4: #7a52c7; --rate5: #6b8e23;
  --stage0: #2a63c8; --stage1: #16a3a0; --stage2: #d99a00; --stage3: #e06a3b; --stage4: #8b6bd1; --stage5: #8a949e; }
@media (prefers-color-scheme: dark) { :root {
  --page: #121519; --card: #1b1f25; --ink: #e8eaed; --soft: #9ba4af; --grid: #2c323a; --edge: #2a2f37;
  --moving: #ff8433; --static: #57c274; --unobservable: #9aa3ad; --missed: #4d5661; --bad: #ff7a70;
  --rate0: #6f9ff0; --rate1: #3cc7c2; --rate2: #eebb45; --rate3: #ee7fa0; --rate4: #a98be6; --rate5: #a3c45c;
  --stage0: #6f9ff0; --stage1: #3cc7c2; --stage2: #eebb45; --stage3: #f08f66; --stage4: #ab91ea; --stage5: #7d8792; } }
* { box-sizing: border-box; }
body { margin: 0; background: var(--page); color: var(--ink);
  font: 15px/1.5 system-ui, -apple-system, "Segoe UI", "Liberation Sans", Arial, sans-serif; }
main { max-width: 1220px; margin: 0 auto; padding: 36px 24px 72px; }
h1 { font-size: 27px; line-height: 1.2; margin: 0 0 4px; letter-spacing: -.01em; }
h2 { font-size: 19px; margin: 46px 0 4px; }
h3 { font-size: 14px; margin: 0; font-weight: 600; }
p { margin: 0 0 14px; color: var(--soft); max-width: 86ch; }
.tiles { display: grid; grid-template-columns: repeat(auto-fit, minmax(150px, 1fr)); gap: 12px; margin-top: 22px; }
.card, .tile { background: var(--card); border: 1px solid var(--edge); border-radius: 10px; }
.tile { padding: 14px 16px 12px; }
.tile h3 { color: var(--soft); font-weight: 500; font-size: 13px; }
.tile dl { margin: 6px 0 0; display: grid; grid-template-columns: auto 1fr; column-gap: 10px; align-items: baseline; }
.tile dt { font-size: 12px; color: var(--soft); }
.tile dd { margin: 0; font-size: 23px; font-weight: 600; line-height: 1.28; font-variant-numeric: tabular-nums; }
.tile dd ~ dd { font-size: 17px; font-weight: 500; }
.card { padding: 14px 16px 10px; margin: 0; min-width: 0; }
.grid { display: grid; gap: 14px; }
.two { grid-template-columns: repeat(auto-fill, minmax(min(100%, 440px), 1fr)); }
.three { grid-template-columns: repeat(auto-fill, minmax(min(100%, 330px), 1fr)); }
.head { display: flex; flex-wrap: wrap; justify-content: space-between; gap: 2px 16px; margin-bottom: 6px; }
.legend { display: flex; flex-wrap: wrap; gap: 2px 13px; font-size: 12.5px; color: var(--soft); align-items: center; }
.legend i { display: inline-block; width: 11px; height: 11px; border-radius: 3px; margin-right: 5px; vertical-align: -1px; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; width: 100%; font-size: 13.5px; font-variant-numeric: tabular-nums; }
th, td { padding: 4px 9px; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--grid); }
th { color: var(--soft); font-weight: 500; font-size: 12.5px; vertical-align: bottom; }
th:first-child, td:first-child { text-align: left; padding-left: 2px; }
td.reason { text-align: left; white-space: normal; color: var(--bad); }
tr.pooled td { font-weight: 650; border-bottom: 0; padding-bottom: 18px; }
tbody tr:last-child td { border-bottom: 0; }
td.weak { color: var(--bad); }
svg { display: block; width: 100%; height: auto; overflow: visible; }
svg text { fill: var(--soft); font-size: 11.5px; font-variant-numeric: tabular-nums; }
svg text.value { fill: var(--ink); paint-order: stroke; stroke: var(--card); stroke-width: 3px; stroke-linejoin: round; }
svg text.count { font-size: 10.5px; }
line.tick { stroke: var(--grid); } line.axis { stroke: var(--soft); }
line.reference { stroke: var(--ink); stroke-dasharray: 5 4; }
polyline { fill: none; stroke-width: 1.7; stroke-linejoin: round; }
polyline.truth { stroke: var(--ink); stroke-width: 1.3; stroke-dasharray: 4 3; }
i.truth { background: var(--ink); height: 2px; vertical-align: 3px; }
img { display: block; width: 100%; height: auto; border-radius: 6px; }
figcaption { font-size: 13px; color: var(--soft); padding-top: 8px; } figcaption b { color: var(--ink); }
)";

}  // namespace eval
