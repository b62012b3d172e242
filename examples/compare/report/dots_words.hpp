// The section of dots, and the script that draws it and opens the tables' rows.
#pragma once

namespace compare::report::words {

inline constexpr const char* dots = R"(<h2>Every pair a dot</h2>
<p>The error of the time against the pair’s hardness, against the true time, and against the pair’s distance from the border
where its decision changes. Each dot is one pair in one type. The upper line holds wrong and open decisions, the lower one
times without any error. <span class="pointing">Choose types and a group; touch a dot to see its pair.</span></p>
)";

// #pair-N shows a pair; #pair-N-row-R also shows where row R puts it; #row-R opens that row of a table.
inline constexpr const char* dots_script = R"js(<script>
(() => {
const text = document.getElementById('pairs-data');
if (!text) return;
const data = JSON.parse(text.textContent), section = document.getElementById('dots');
const EXACT = -9999, INFINITE = 9999, WRONG = 9998, OPEN = 9997;
const W = 360, H = 300, left = 42, right = 10, top = 40, bottom = 62;
const make = (tag, content, attributes) => {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes || {})) element.setAttribute(name, value);
  element.append(...[].concat(content ?? []));
  return element;
};
const superscript = n => String(n).replace(/./g, c => '⁰¹²³⁴⁵⁶⁷⁸⁹'[c] ?? '⁻');
const power = n => n === 0 ? '1' : '10' + superscript(n);
const said = (code, group) => code === EXACT ? 'no error' : code === INFINITE ? 'no finite number'
  : code === WRONG ? 'wrong decision' : code === OPEN ? 'left open'
  : Number((2 ** (code / 10)).toPrecision(3)) + ' units in the last place';
let group = Math.max(0, data.groups.findIndex(g => g.hardness)), chosen = null, chosenRow = null;
const on = data.lines.map(() => true);

// Pairs of one hardness stand beside one another.
const spread = i => (i * 0.618034 % 1 - 0.5) * 0.7;
const panels = [
  {key: 'hardness', title: g => g.k + ' →', at: (g, i) => g.hardness[i] === null ? null : g.hardness[i] + spread(i), tick: x => x, step: 10},
  {key: 'time', title: () => 'true time →', at: (g, i) => g.time[i] === null ? null : g.time[i] / 100, tick: power, step: 1},
  {key: 'border', title: () => 'relative distance from the border →', at: (g, i) => g.border[i] === null ? null : g.border[i] / 100, tick: power, step: 1}];

const axis = g => {
  let low = Infinity, high = -Infinity;
  for (const l of data.lines) for (const v of l.dots[group]) if (v !== null && Math.abs(v) < 9000) low = Math.min(low, v), high = Math.max(high, v);
  return low > high ? [-10, 10] : [low, Math.max(high, low + 10)];
};
const y_of = (v, [low, high]) => v === EXACT ? H - 46 : v >= OPEN ? (v === INFINITE ? 32 : 20) : top + 6 + (high - v) * (H - top - bottom - 12) / (high - low);

function range(panel, g) {
  let low = Infinity, high = -Infinity;
  for (let i = 0; i < g.number.length; ++i) {
    const x = panel.at(g, i);
    if (x !== null && data.lines.some(l => l.dots[group][i] !== null)) low = Math.min(low, x), high = Math.max(high, x);
  }
  return low > high ? null : [low - (high - low || 1) * 0.03, high + (high - low || 1) * 0.03];
}
// Pairs without such a number, such as a miss without a time, stand at the left edge.
const x_of = (panel, g, i, [low, high]) => {
  const x = panel.at(g, i);
  return x === null ? left + 3 : left + 8 + (x - low) * (W - left - right - 12) / (high - low);
};

function draw() {
  const g = data.groups[group], ys = axis(g);
  for (const panel of panels) {
    const xs = g[panel.key] ? range(panel, g) : null;
    panel.xs = xs, panel.ys = ys;
    panel.figure.hidden = !xs;
    if (!xs) continue;
    let svg = '';
    for (let d = Math.ceil(ys[0] / 33.2193); d * 33.2193 <= ys[1]; ++d) {
      if (d % (ys[1] - ys[0] > 400 ? 4 : 2)) continue;
      const y = y_of(d * 33.2193, ys).toFixed(1);
      svg += `<path class="rule" d="M${left} ${y}H${W - right}"/><text x="${left - 5}" y="${+y + 4}" text-anchor="end">${power(d)}</text>`;
    }
    for (const [y, name] of [[20, 'wrong'], [H - 46, 'exact']])
      svg += `<path class="rule" d="M${left} ${y}H${W - right}"/><text x="${left - 5}" y="${y + 4}" text-anchor="end">${name}</text>`;
    const step = panel.step * Math.max(1, Math.ceil((xs[1] - xs[0]) / panel.step / 6));
    for (let x = Math.ceil(xs[0] / step) * step; x <= xs[1]; x += step) {
      const at = (left + 8 + (x - xs[0]) * (W - left - right - 12) / (xs[1] - xs[0])).toFixed(1);
      svg += `<path class="rule" d="M${at} ${top - 24}V${H - 40}"/><text x="${at}" y="${H - 24}" text-anchor="middle">${panel.tick(x)}</text>`;
    }
    data.lines.forEach((l, n) => {
      if (!on[n]) return;
      const seen = new Set();
      let d = '';
      l.dots[group].forEach((v, i) => {
        if (v === null) return;
        const at = x_of(panel, g, i, xs).toFixed(1) + ' ' + y_of(v, ys).toFixed(1);
        if (!seen.has(at)) seen.add(at), d += 'M' + at + 'h0';
      });
      svg += `<path class="dots" data-line="${n}" style="stroke:var(${l.colour})" d="${d}"/>`;
    });
    const i = g.number.indexOf(chosen);
    if (i >= 0) {
      const ring = v => v === null || v === undefined ? '' : `<circle class="chosen" cx="${x_of(panel, g, i, xs).toFixed(1)}" cy="${y_of(v, ys).toFixed(1)}" r="6"/>`;
      data.lines.forEach((l, n) => svg += on[n] ? ring(l.dots[group][i]) : '');
      if (chosenRow !== null) for (const w of data.rows[chosenRow].worst) if (w[1] === chosen && /time|crossing|wrong|no answer|open/.test(w[0])) svg += ring(w[5]);
    }
    panel.svg.innerHTML = svg + `<text x="${W - right}" y="${H - 8}" text-anchor="end">${panel.escaped(g)}</text><text x="2" y="11">error of τ, units ↑</text>`;
  }
}

function number(x) { // a hexadecimal float or a fraction, and for a float its decimals
  const m = /^(-?)0x([0-9a-f]+)\.?([0-9a-f]*)p([+-]?\d+)$/.exec(x);
  if (!m) return String(x);
  const value = (m[1] ? -1 : 1) * parseInt(m[2] + m[3], 16) * 2 ** (m[4] - 4 * m[3].length);
  return value + ' (' + x + ')';
}
function show(pair, row) {
  const card = section.querySelector('.card'), known = data.pairs[pair];
  const g = data.groups.findIndex(one => one.number.includes(pair));
  chosen = pair, chosenRow = row;
  if (g >= 0 && g !== group) { group = g; section.querySelectorAll('[name=dots-group]').forEach((b, n) => b.checked = n === g); }
  const place = g >= 0 ? data.groups[g].number.indexOf(pair) : -1;
  const name = known ? known.name : place >= 0 ? data.groups[g].names[place] : '';
  const parts = [make('h3', `Pair ${pair}: ${name}` + (g >= 0 ? ` of ${data.groups[g].name}` : ''))];
  if (known) {
    parts.push(make('p', `In truth: ${known.truth}` + (known.time ? ` at ${known.time}` : '') + `; ${Number(known.border.toPrecision(2))} from the border, relative.`));
    const table = make('table', [], {class: 'words'});
    const line = (what, x) => table.append(make('tr', [make('th', what), make('td', [].concat(x).map(number).join(', '))]));
    (known.scene.balls || []).forEach((b, n) => { for (const k of Object.keys(b)) line('ball ' + 'ab'[n] + ' ' + k, b[k]); });
    (known.scene.planes || []).forEach(p => { for (const k of Object.keys(p)) line('plane ' + k, p[k]); });
    for (const what of ['wall', 'triangle']) (known.scene[what + 's'] || []).forEach(w => { line(what + ' corner', w.corner); w.edges.forEach((e, n) => line(what + ' edge ' + n, e)); });
    parts.push(table, make('details', [make('summary', 'As a scene file'), make('pre', JSON.stringify(known.scene))]));
  }
  const dots = [];
  if (place >= 0) data.lines.forEach(l => { const v = l.dots[g][place]; if (v !== null) dots.push(make('li', l.name + ': ' + said(v))); });
  if (dots.length) parts.push(make('ul', dots));
  const rows = [];
  data.rows.forEach((r, n) => { for (const w of r.worst) if (w[1] === pair) rows.push(make('li', [make('a', r.name, {href: '#row-' + n}), ': ' + w[0] + (w[2] ? ', ' + w[2] + ' units' : '') + ': ' + w[4] + ', in truth ' + w[3]])); });
  if (rows.length) parts.push(make('p', 'At their worst, or wrong, on it:'), make('ul', rows));
  parts.push(make('p', ['The command that shows it again: ', make('code', data.command + pair + (row !== null ? data.rows[row].form : ''))]));
  card.replaceChildren(...parts);
  draw();
}
function open_row(n, scroll) {
  const line = document.getElementById('row-' + n);
  if (!line) return;
  for (let e = line.parentElement; e; e = e.parentElement) if (e.tagName === 'DETAILS') e.open = true;
  if (!line.nextElementSibling || !line.nextElementSibling.classList.contains('worst')) {
    const list = data.rows[n].worst.map(w => make('li', [make('a', 'pair ' + w[1], {href: `#pair-${w[1]}-row-${n}`}), ': ' + w[0] + (w[2] ? ', ' + w[2] + ' units' : '') + ': ' + w[4] + ', in truth ' + w[3]]));
    line.after(make('tr', make('td', list.length ? make('ul', list) : 'No wrong decision, and no error.', {colspan: line.cells.length, class: 'list'}), {class: 'worst'}));
    line.querySelector('button').setAttribute('aria-expanded', 'true');
  }
  if (scroll) line.scrollIntoView({block: 'center'});
}
function follow() {
  const pair = /^#pair-(\d+)(?:-row-(\d+))?$/.exec(location.hash), row = /^#row-(\d+)$/.exec(location.hash);
  if (pair) { show(+pair[1], pair[2] === undefined ? null : +pair[2]); section.querySelector('.panels').scrollIntoView({block: 'start'}); }
  if (row) open_row(+row[1], true);
}
document.querySelectorAll('tr[id^=row-]').forEach(line => {
  const n = +line.id.slice(4);
  line.cells[0].prepend(make('button', '▸', {type: 'button', class: 'opens', 'aria-expanded': 'false', title: 'Its worst and wrong pairs'}));
  line.cells[0].firstChild.addEventListener('click', event => {
    const next = line.nextElementSibling;
    if (next && next.classList.contains('worst')) next.remove(), event.target.setAttribute('aria-expanded', 'false');
    else open_row(n, false);
  });
});
const controls = section.querySelector('.controls');
if (data.groups.length > 1) controls.append(make('p', data.groups.map((g, n) => {
  const button = make('input', [], {type: 'radio', name: 'dots-group', id: 'dots-group-' + n});
  button.checked = n === group;
  button.addEventListener('change', () => { group = n; draw(); });
  return make('label', [button, ' ' + g.name + ' ']);
})));
controls.append(make('p', data.lines.map((l, n) => {
  const box = make('input', [], {type: 'checkbox', id: 'dots-line-' + n});
  box.checked = true;
  box.addEventListener('change', () => { on[n] = box.checked; draw(); });
  return make('label', [box, ' ', make('span', '●', {style: `color:var(${l.colour})`}), ' ' + l.name + ' ']);
})));
const output = section.querySelector('output');
for (const panel of panels) {
  panel.figure = section.querySelector('.' + panel.key), panel.svg = panel.figure.querySelector('svg');
  panel.escaped = g => make('i', panel.title(g)).innerHTML;
  const nearest = event => {
    const box = panel.svg.getBoundingClientRect(), x = (event.clientX - box.left) * W / box.width, y = (event.clientY - box.top) * H / box.height;
    const g = data.groups[group];
    let best = null, least = 100;
    data.lines.forEach((l, n) => on[n] && l.dots[group].forEach((v, i) => {
      if (v === null) return;
      const off = (x_of(panel, g, i, panel.xs) - x) ** 2 + (y_of(v, panel.ys) - y) ** 2;
      if (off < least) least = off, best = {i, l, v};
    }));
    return best && {...best, g};
  };
  panel.svg.addEventListener('pointermove', event => {
    const at = nearest(event);
    if (at) output.textContent = `pair ${at.g.number[at.i]}, ${at.g.names[at.i]}: ${at.l.name}, ${said(at.v)}`;
  });
  panel.svg.addEventListener('click', event => { const at = nearest(event); if (at) location.hash = '#pair-' + at.g.number[at.i]; });
}
addEventListener('hashchange', follow);
draw();
follow();
})();
</script>
)js";

} // namespace compare::report::words
