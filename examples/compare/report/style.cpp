#include "style.hpp"

namespace compare::report {
namespace {

constexpr const char* light = R"(
  --paper: #fdfdfb; --panel: #f2f4f1; --text: #1c2126; --muted: #59636d; --grid: #e1e5e1; --rule: #cdd3ce;
  --bad: #c8321f; --open: #a86400; --best: #1d7a3e;
  --one: #1c68b0; --two: #c2571a; --three: #0d7f80; --four: #8a46b8; --five: #a6396f; --six: #6f6a14; --seven: #4a5560;
)";
constexpr const char* dark = R"(
  --paper: #14181c; --panel: #1d2328; --text: #e6e9eb; --muted: #9aa5ae; --grid: #2a3137; --rule: #3a434b;
  --bad: #ff7a66; --open: #f0b04a; --best: #5fca84;
  --one: #6cb2f2; --two: #f29a5c; --three: #4cc5c3; --four: #cf96f0; --five: #f08ab8; --six: #cfc95a; --seven: #aab4bd;
)";

constexpr const char* pictures = R"(
svg text { font-family: system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif;
  dominant-baseline: auto; paint-order: stroke; stroke: var(--paper); stroke-width: 2.5px; stroke-linejoin: round; }
svg path { fill: none; }
svg .full { fill: currentColor; stroke: transparent; stroke-width: 1; pointer-events: all; }
svg .hollow { fill: var(--paper); stroke: currentColor; stroke-width: .38; pointer-events: all; }
svg .point:hover > * { stroke: var(--text); stroke-width: .3; }
svg.decisions text { stroke: none; }
)";

constexpr const char* page = R"(
:root { color-scheme: light dark; }
* { box-sizing: border-box; }
html { -webkit-text-size-adjust: 100%; }
body { margin: 0; background: var(--paper); color: var(--text); overflow-wrap: anywhere;
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, sans-serif; }
main { max-width: 1088px; margin: 0 auto; padding: 28px 24px 80px; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .2em; letter-spacing: -.01em; }
h2 { font-size: 1.3rem; line-height: 1.3; margin: 2.6em 0 .3em; }
h3 { font-size: 1rem; margin: 1.4em 0 .2em; }
p { max-width: 72ch; margin: .5em 0; }
.under { color: var(--muted); margin-top: 0; }
.answer { font-size: 1.2rem; line-height: 1.45; border-left: 4px solid var(--best); padding: .1em 0 .1em .8em; margin: 1.1em 0; }
.notice { border-left: 4px solid var(--bad); background: var(--panel); padding: .6em .9em; }
code { font: .88em/1.5 ui-monospace, SFMono-Regular, Menlo, Consolas, "DejaVu Sans Mono", monospace; }
.made { display: grid; grid-template-columns: max-content 1fr; gap: .15em 1.2em; margin: 1em 0 0; font-size: .9rem; }
.made dt { color: var(--muted); }
.made dd { margin: 0; }
.made code { background: var(--panel); border-radius: 4px; padding: .15em .4em; }
nav { margin: 1.4em 0 0; font-size: .9rem; }
nav a { margin-right: 1em; white-space: nowrap; }
a { color: var(--one); text-underline-offset: 2px; }
figure { margin: 1em 0 0; }
figure svg { display: block; width: 100%; height: auto; }
.narrow { display: none; }
output { display: block; min-height: 1.6em; font-size: .9rem; color: var(--muted); }
.panels { display: grid; grid-template-columns: repeat(3, minmax(0, 1fr)); gap: 8px 16px; }
.panels h4 { font-size: .9rem; margin: .6em 0 .1em; }
.key { display: flex; flex-wrap: wrap; gap: .1em 1.3em; list-style: none; padding: 0; margin: .8em 0 .2em; font-size: .9rem; }
.key svg { display: inline-block; width: 26px; height: 10px; margin-right: .4em; vertical-align: baseline; }
details { margin: .6em 0; border-top: 1px solid var(--rule); padding-top: .5em; }
summary { cursor: pointer; font-weight: 600; }
table { border-collapse: collapse; width: 100%; font-size: .8rem; line-height: 1.4; margin: .6em 0;
  font-variant-numeric: tabular-nums; }
th, td { padding: .28em .5em; vertical-align: top; border-bottom: 1px solid var(--grid); }
th { text-align: left; font-weight: 600; }
thead th { overflow-wrap: normal; color: var(--muted); font-weight: 500; vertical-align: bottom; border-bottom: 1px solid var(--rule); }
.figures td, .figures thead th + th { text-align: right; }
.figures td { white-space: nowrap; }
.figures small { color: var(--muted); display: block; }
.figures tbody th { min-width: 15em; }
.words tbody th { white-space: nowrap; }
.words small { display: block; color: var(--muted); }
.bad { color: var(--bad); }
.open { color: var(--open); }
.figures tbody tr:hover { background: var(--panel); }
.controls label { display: inline-block; margin-right: 1em; font-size: .9rem; }
.dots-of-pairs text { font-size: 11px; fill: var(--muted); stroke: none; }
.dots-of-pairs .rule { stroke: var(--grid); stroke-width: 1; }
.dots-of-pairs .dots { stroke-width: 3; stroke-linecap: round; stroke-opacity: .7; }
.dots-of-pairs .chosen { fill: none; stroke: var(--text); stroke-width: 1.6; }
.panels figure[hidden] { display: none; }
.card pre { white-space: pre-wrap; font-size: .8rem; }
.opens { border: 0; background: none; color: var(--one); cursor: pointer; padding: 0 .4em 0 0; font: inherit; }
.opens[aria-expanded=true] { transform: rotate(90deg); display: inline-block; }
.figures .list { text-align: left; white-space: normal; }
.list ul, .card ul { margin: .2em 0; padding-left: 1.2em; font-size: .85rem; }
@media screen and (max-width: 1100px) {
  main { padding: 20px 15px 60px; }
  h1 { font-size: 1.5rem; }
  .answer { font-size: 1.08rem; }
  .panels { grid-template-columns: repeat(auto-fit, minmax(min(100%, 320px), 1fr)); }
  thead { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); }
  table, tbody { display: block; }
  tr { display: grid; grid-template-columns: repeat(auto-fill, minmax(min(100%, 220px), 1fr)); gap: 0 14px;
    border-bottom: 1px solid var(--rule); padding: .6em 0; }
  tbody th { grid-column: 1 / -1; border: 0; padding: 0 0 .15em; font-size: .9rem; white-space: normal; }
  td, .figures td { display: flow-root; text-align: right; white-space: normal; border: 0; padding: .08em 0; }
  .list { grid-column: 1 / -1; }
  td[data-head]::before { content: attr(data-head); color: var(--muted); float: left; max-width: 55%; margin-right: .8em; text-align: left; }
  .words tbody th { white-space: normal; }
  .figures tbody th { min-width: 0; }
  .figures small { display: inline; }
  .words tr { grid-template-columns: 1fr; }
  .words small { display: inline; }
}
@media (max-width: 640px) {
  .wide { display: none; }
  .narrow { display: block; }
  .made { grid-template-columns: 1fr; gap: 0; }
  .made dd { margin-bottom: .5em; }
}
@media print {
  main { max-width: none; padding: 0; }
  body { font-size: 10.5pt; }
  nav, output, .pointing, .controls, .opens { display: none; }
  h2, h3, summary { break-after: avoid; }
  figure, .panels > div, tr { break-inside: avoid; }
  table { font-size: 7pt; }
  .figures small { display: block; }
  svg * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
}
)";

} // namespace

std::string picture_style() {
    return std::string(":root {") + light + "}\n@media screen and (prefers-color-scheme: dark) {\n:root {" + dark +
           "}\n}" + pictures;
}

std::string style() { return picture_style() + page; }

} // namespace compare::report
