// node check.mjs index.html chromium directory [graze-compare]: uses the playground as a person would, on a desktop and on a telephone, and
// compares the decisions about its pair with integers of any length, which round nothing. Leaves pictures and the scene that it drew
// in the directory; graze-compare must accept that scene. Exit code 1 if anything was not as expected.
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdirSync, rmSync, statSync, writeFileSync} from 'node:fs';
import {join, resolve} from 'node:path';
import {Browser} from './browser.mjs';

const [page, chromium, folder, reader] = process.argv.slice(2);
const desk = {width: 1200, height: 900, dark: false};
const telephone = {width: 390, height: 844, dark: true};
const url = `file://${resolve(page)}`;
mkdirSync(folder, {recursive: true});
rmSync(join(folder, 'profile'), {recursive: true, force: true});
assert.ok(statSync(page).size <= 1_500_000, 'the page has at most 1.5 MB');
const browser = await Browser.open(chromium, join(folder, 'profile'));

const text = selector => browser.evaluate(`document.querySelector(${JSON.stringify(selector)}).textContent`);
const until = async (what, f) => {
  for (let i = 0; i < 600; ++i) {
    if (await f()) return;
    await new Promise(go => setTimeout(go, 50));
  }
  assert.fail(`in vain: ${what}`);
};
const open = async (screen, fragment = '') => {
  await browser.goTo(url + fragment, screen);
  await until('the page is ready', () => browser.evaluate('document.body?.dataset.ready === "yes"'));
};
const click = selector => browser.evaluate(`document.querySelector(${JSON.stringify(selector)}).click()`);
const shown = name => until(name, () => browser.evaluate(`document.body.dataset.shown === ${JSON.stringify(name)}`));
const picture = async name => writeFileSync(join(folder, `${name}.png`), await browser.picture());

// Nothing is wider than the page, except for tables that scroll.
async function fits(what) {
  const out = await browser.evaluate(`[document.documentElement.scrollWidth > innerWidth ? 'the page scrolls sideways' : '',
    ...[...document.querySelectorAll('body *')].filter(e => !e.closest('.scroll') && e.getBoundingClientRect().right > innerWidth + 0.5)
    .map(e => e.id || e.className || e.tagName)].join(' ').trim()`);
  assert.equal(out, '', `${what}: what reaches out of the page`);
}

// The encounter of the pair's balls, with the first one moved, in integers: all numbers are multiples of 2^-80.
function decided([a, b], dx, dy) {
  const scaled = x => BigInt(x * 2 ** 80);
  const minus = (p, q) => p.map((x, i) => scaled(x) - scaled(q[i]));
  const [x, y] = minus([a.position[0] + dx, a.position[1] + dy], b.position);
  const [u, v] = minus(a.velocity, b.velocity);
  const r = scaled(a.radius) + scaled(b.radius);
  const h = x * u + y * v;
  const c = x * x + y * y - r * r;
  const d = h * h - (u * u + v * v) * c;
  return h >= 0n ? 'recede' : c < 0n ? 'overlap' : d < 0n ? 'miss' : d === 0n ? 'graze' : 'hit';
}

async function checkPair(screen) {
  await open(screen);
  assert.equal(await browser.evaluate('document.body.dataset.shown'), 'a grazing pair');
  const side = 64;
  const step = 2 ** -50;
  const found = await browser.evaluate(`(async () => {
    const {Engine, encounters} = await import('playground/engine.mjs');
    const {module} = await import('playground/graze_module.mjs');
    const bytes = await new Response(new Blob([Uint8Array.from(atob(module), c => c.charCodeAt(0))]).stream()
      .pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
    const engine = await Engine.from(bytes);
    const {balls} = JSON.parse(document.querySelector('#json').value);
    const ask = async how => [...await engine.decide(how, balls, ${side}, ${step})].map(x => encounters[x]);
    return {balls, double: await ask(1), graze: await ask(2)};
  })()`);
  const truth = found.graze.map((_, k) => decided(found.balls, ((k % side) - side / 2) * step, (Math.floor(k / side) - side / 2) * step));
  assert.deepEqual(found.graze, truth, 'graze decides as integers do');
  assert.equal(truth.filter(x => x === 'graze').length, 16);
  const wrong = truth.filter((x, k) => x !== found.double[k]).length;
  assert.ok(wrong > 100, 'doubles are wrong on the first screen');
  assert.equal(await text('[data-key=double] .note'), `${wrong} wrong`);
  assert.equal(await text('[data-key=graze] .note'), 'exact');
  await until('doubles say of the framed pixel what graze does not', () => browser.evaluate('document.querySelector("#table .other") !== null'));
  const lowest = await browser.evaluate('document.querySelector("[data-key=double] canvas").getBoundingClientRect().bottom');
  assert.ok(lowest <= screen.height, 'the wrong decisions are on the first screen');

  const k = found.double.findIndex((x, i) => x !== truth[i]);
  const [red, green, blue] = await browser.evaluate(`(() => {
    const canvas = document.querySelector('[data-key=double] canvas'), cell = canvas.width / ${side};
    return [...canvas.getContext('2d').getImageData(${(k % side) + 0.5} * cell, ${side - 0.5 - Math.floor(k / side)} * cell, 1, 1).data] })()`);
  assert.ok(red > 150 && green < 110 && blue < 130, 'a wrong pixel is red');

  for (let i = 0; i < 12; ++i) await browser.key('ArrowLeft');
  await until('further away all are right', async () => (await text('[data-key=double] .note')) === 'all right');
  for (let i = 0; i < 12; ++i) await click('#in');
  await until('near by they are wrong again', async () => (await text('[data-key=double] .note')) === `${wrong} wrong`);
  await fits('pair');
}

// Two fingers zoom; a tap asks about a place.
async function checkTouch(screen) {
  await open(screen);
  const box = await browser.evaluate(`(() => { const c = document.querySelector('[data-key=double] canvas'); c.scrollIntoView({block: 'center'});
    const {left, top, width, height} = c.getBoundingClientRect(); return {left, top, width, height} })()`);
  const at = (x, y) => [box.left + x * box.width, box.top + y * box.height];
  const apart = far => [at(0.5 - far, 0.5), at(0.5 + far, 0.5)];
  const pinch = (...widths) => browser.touch(...[0, 1].map(k => widths.map(far => apart(far)[k])));
  const note = () => text('[data-key=double] .note');
  for (let i = 0; i < 12 && (await note()) !== 'all right'; ++i) await pinch(0.4, 0.3, 0.2, 0.1);
  await until('fingers that close zoom out, where all are right', async () => (await note()) === 'all right');
  for (let i = 0; i < 12 && (await note()) === 'all right'; ++i) await pinch(0.1, 0.2, 0.3, 0.4);
  await until('fingers that part zoom in, where doubles are wrong', async () => /^\d+ wrong$/.test(await note()));
  const place = () => text('#table p');
  const before = await place();
  await browser.touch([at(0.25, 0.25)]);
  await until('a tap asks about another place', async () => (await place()) !== before);
}

// The button's title, the scene's name, its events, the last event's balls and time, and the event at which doubles go wrong.
async function checkRun(title, name, events, who, time, parting) {
  await browser.evaluate(`[...document.querySelectorAll('#scenes button')].find(b => b.textContent === ${JSON.stringify(title)}).click()`);
  await shown(name);
  assert.equal(await text('#position'), `event 0 of ${events}`);
  await browser.key('ArrowRight');
  assert.equal(await text('#position'), `event 1 of ${events}`, `${title}: a step`);
  await browser.key('End');
  assert.equal(await text('#position'), `event ${events} of ${events}`, `${title}: the end`);
  const last = await browser.evaluate(`[...document.querySelectorAll('#table tr.now td:last-child .who')].map(e => e.textContent)`);
  assert.deepEqual(last, ['', time, who], `${title}: the last event`);
  assert.equal(/double leaves them at event (\d+)/.exec(await text('#verdict'))?.[1], parting, `${title}: where doubles part`);
  await fits(title);
}

async function checkRuns() {
  await checkRun('corner pocket', 'corner pocket', 300, 'ball 0 and wall 6', '0x1.368757f115b3ep+5', '99');
  await checkRun('Galperin’s blocks', "Galperin's billiard", 314, 'ball 0 and plane 0', '0x1.c028ce357bab9p+2', undefined);
  await checkRun('Sinai’s billiard', 'Sinai billiard', 200, 'ball 0 and plane 2', '0x1.60a2954de75f3p+6', '52');
}

async function checkSharing(screen) {
  const scene = {dimension: 2, name: 'given', balls: [{position: [0.1, '1/3'], velocity: ['0x1.8p-3', 0], radius: 0.25, mass: 'inf'}],
    planes: [{point: [2, 0], normal: [1, 0]}]};
  await open(screen, '#' + encodeURIComponent(JSON.stringify(scene)));
  await shown('given');
  const json = await browser.evaluate('document.querySelector("#json").value');
  assert.deepEqual(JSON.parse(json), scene, 'the scene of the address, as it was written');
  const ball = await browser.evaluate(`import('playground/scene.mjs').then(m => m.readScene(${JSON.stringify(json)}).balls[0])`);
  assert.deepEqual([ball.position, ball.velocity], [[0.1, 1 / 3], [0.1875, 0]]);

  await browser.evaluate(`document.querySelector('#json').value = '{"dimension": 2, "balls": [{"position": [0, 0], "velocity": [0, 0], "radius": -1}]}'`);
  await click('#apply');
  await until('a fault is named', async () => (await text('#fault')) === '/balls/0/radius: a negative radius');
}

// Addresses made by somebody else.
async function checkAddresses(screen) {
  const address = (balls, more = {}) => '#' + encodeURIComponent(JSON.stringify({dimension: 2, ...more, balls}));
  const ball = (x, u, radius = 1) => ({position: x, velocity: u, radius});
  for (const [fragment, fault] of [['#%', 'URI malformed'], ['#null', 'a scene is an object'], ['#{"dimension":3}', '/dimension: this page has']]) {
    await open(screen, fragment);
    assert.ok((await text('#verdict')).startsWith(`The address has no scene: ${fault}`), fragment);
    assert.equal(await browser.evaluate('document.body.dataset.shown'), 'a grazing pair');
  }
  const name = '<img src=x onerror=alert(1)>';
  await open(screen, address([ball([0, 0], [1, 0]), ball([5, 0], [0, 0])], {name, description: name}));
  await shown(name);
  assert.equal(await browser.evaluate(`document.querySelectorAll('img').length`), 0, 'names are text');
  assert.match(await text('#verdict'), /all 4,096 positions/);
  // At the end of the numbers' range one cannot zoom out farther.
  await open(screen, address([ball([1e308, 0], [-1e308, 0]), ball([-1e308, 0], [1e308, 0])]));
  await browser.key('Home');
  await until('the end of the numbers is told', async () => (await text('#verdict')).startsWith('No farther: '));
  await browser.key('ArrowRight');
  await until('and one goes on from there', async () => (await text('#verdict')).startsWith('Doubles decide'));
  await open(screen, address([ball([0, 0], [1, 0])], {planes: [{point: [5, 0], normal: [1, 0]}]}));
  assert.match(await text('#verdict'), /^1 event, /);
}

async function checkDrawing(screen) {
  await open(screen);
  await click('#own summary');
  await click('#empty');
  await shown('my scene');
  await click('[data-tool=ball]');
  const box = await browser.evaluate(`(() => { const c = document.querySelector('[data-key=graze] canvas'); c.scrollIntoView({block: 'center'});
    const {left, top, width, height} = c.getBoundingClientRect(); return {left, top, width, height} })()`);
  const at = (x, y) => [box.left + x * box.width, box.top + y * box.height];
  const stroke = (from, to) => (screen === telephone ? browser.touch([from, to]) : browser.drag(from, to));
  await stroke(at(0.6, 0.5), at(0.7, 0.4));
  const scene = async () => JSON.parse(await browser.evaluate('document.querySelector("#json").value'));
  await until('a ball is drawn', async () => (await scene()).balls.length === 2);
  await click('[data-tool=wall]');
  await stroke(at(0.3, 0.3), at(0.4, 0.7));
  await until('a wall is drawn', async () => (await scene()).walls.length === 5);
  assert.ok((await scene()).balls[1].velocity[1] > 0, 'the ball flies up');
  await fits('drawing');
  writeFileSync(join(folder, 'drawn.json'), JSON.stringify(await scene()));
  const address = await browser.evaluate('location.hash');
  assert.deepEqual(JSON.parse(decodeURIComponent(address.slice(1))), await scene(), 'the address holds the scene');
}

try {
  for (const screen of [desk, telephone]) {
    const name = `${screen.width}${screen.dark ? '-dark' : ''}`;
    await checkPair(screen);
    await picture(`pair-${name}`);
    await checkRun('pool table', 'pool break', 400, 'ball 15 and wall 0', '0x1.4167f8debdfddp+3', '134');
    await picture(`pool-${name}`);
    if (screen === desk) await checkRuns();
    if (screen === telephone) await checkTouch(screen);
    await checkDrawing(screen);
    await picture(`drawing-${name}`);
  }
  await checkSharing(desk);
  await checkAddresses(desk);
  if (reader) {
    const {status, stderr} = spawnSync(reader, [join(folder, 'drawn.json'), '--types', 'double'], {encoding: 'utf8'});
    assert.equal(status, 0, `graze-compare reads what was drawn: ${stderr}`);
  }
  const loaded = await browser.evaluate(`performance.getEntriesByType('resource').map(r => r.name).filter(n => !n.startsWith('data:'))`);
  assert.deepEqual(loaded, [], 'nothing comes from elsewhere');
  assert.deepEqual(browser.faults, [], 'nothing in the console');
  console.log('all as expected');
} finally {
  browser.close();
}
