// Two balls: each arithmetic's decision for every position near the first ball's, down to the last bit.
import {arithmetics, encounters} from './engine.mjs';
import {hexadecimal, ulpsBetween} from './numbers.mjs';
import {element, makePanels, say} from './panels.mjs';
import {drawMap, drawScene, viewOf} from './picture.mjs';

const side = 64;
const wrongFrom = 50; // the step with which the page begins: 2^-50 of the scale

const superscript = k => [...String(k)].map(c => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'[c])).join('');

export class PairView {
  constructor(page, engine) {
    this.page = page;
    this.engine = engine;
    this.level = wrongFrom;
    page.zoom.addEventListener('input', () => this.zoomTo(Number(page.zoom.value)));
    page.in.addEventListener('click', () => this.zoomBy(1));
    page.out.addEventListener('click', () => this.zoomBy(-1));
  }

  async show(scene) {
    this.scene = scene;
    // Steps are counted from the power of two above the first ball's coordinates.
    const size = Math.max(...scene.balls.flatMap(b => b.position.map(Math.abs)), 2 ** -900);
    this.power = Math.ceil(Math.log2(size)) - 3;
    this.panels = makePanels(this.page.panels, [
      {key: 'pair', title: 'the pair', about: 'the balls and the way of the first one'},
      ...arithmetics,
    ]);
    this.page.panels.className = 'pair';
    this.answers = null;
    for (const panel of this.panels.slice(1)) this.#listen(panel.canvas);
    await this.#decide();
  }

  zoomBy(levels) {
    return this.zoomTo(this.level + levels);
  }
  zoomTo(level) {
    this.level = Math.min(54, Math.max(2, Math.round(level)));
    return this.#decide();
  }
  key(name) {
    const by = {ArrowRight: 1, ArrowLeft: -1, '+': 1, '-': -1, End: 54, Home: -54}[name];
    if (by) this.zoomBy(by);
    return by !== undefined;
  }

  get step() {
    return 2 ** (this.power - this.level);
  }

  async #decide() {
    const asked = (this.asked = Symbol('the last question'));
    const answers = [];
    try {
      for (const how of [0, 1, 2]) answers.push(await this.engine.decide(how, this.scene.balls, side, this.step));
    } catch (error) {
      if (asked !== this.asked) return;
      if (!this.answers) throw error;
      this.level = this.decided; // keep the level
      this.draw();
      this.page.verdict.textContent = `No farther: ${error.message}.`;
      return;
    }
    if (asked !== this.asked) return; // there has been another question since
    this.answers = answers;
    this.decided = this.level;
    this.chosen = this.#nearestWrong();
    this.draw();
    this.#tell();
  }

  draw() {
    const {zoom, scale} = this.page;
    zoom.value = this.level;
    const power = this.power - this.level;
    scale.textContent = `a pixel is 2${superscript(power)} ≈ ${(2 ** power).toExponential(0)}`;
    this.#drawPair();
    this.panels.slice(1).forEach((panel, how) => {
      drawMap(panel.canvas, this.answers[how], this.answers[2], side, encounters, this.chosen);
      const wrong = this.#wrong(how);
      if (how === 2) say(panel.note, 'exact', 'good');
      else say(panel.note, wrong === 0 ? 'all right' : `${wrong.toLocaleString('en')} wrong`, wrong === 0 ? '' : 'bad');
    });
  }

  #drawPair() {
    const [a, b] = this.scene.balls;
    const speed = Math.hypot(a.velocity[0] - b.velocity[0], a.velocity[1] - b.velocity[1]);
    const far = (2.2 * Math.hypot(a.position[0] - b.position[0], a.position[1] - b.position[1])) / (speed || 1);
    const ahead = ({position: [x, y], velocity: [u, v]}) => [x + u * far, y + v * far];
    const ends = [ahead(a), ahead(b)];
    const view = viewOf(this.scene, ends);
    const square = Math.max(view.width, view.height);
    view.left -= (square - view.width) / 2;
    view.bottom -= (square - view.height) / 2;
    view.width = view.height = square;
    this.view = view;
    drawScene(this.panels[0].canvas, this.scene, view, {
      balls: this.scene.balls.map(({position: [x, y], velocity: [u, v]}) => ({x, y, u, v})),
      trails: this.scene.balls.map((ball, i) => [ball.position, ends[i]]),
      met: [],
      draft: this.draft,
    });
    say(this.panels[0].note, encounters[this.answers[2][(side / 2) * side + side / 2]]);
  }

  // The position nearest the middle that doubles decide wrongly, preferably with a hit taken for a miss or the reverse; the
  // middle if there is none.
  #nearestWrong() {
    const middle = side / 2;
    let best = {i: middle, j: middle, far: Infinity};
    this.answers[1].forEach((answer, k) => {
      const right = this.answers[2][k];
      const [i, j] = [k % side, Math.floor(k / side)];
      const isTouch = encounters[answer] === 'graze' || encounters[right] === 'graze';
      const far = (i - middle) ** 2 + (j - middle) ** 2 + (isTouch ? side * side : 0);
      if (answer !== right && far < best.far) best = {i, j, far};
    });
    return best;
  }

  #wrong(how) {
    return this.answers[how].reduce((n, x, k) => n + (x === this.answers[2][k] ? 0 : 1), 0);
  }

  async #tell() {
    const {verdict, table} = this.page;
    const wrong = this.#wrong(1);
    verdict.textContent =
      wrong === 0
        ? `At this scale doubles decide all ${(side * side).toLocaleString('en')} positions as they are. Zoom in until they don’t.`
        : `Doubles decide ${wrong.toLocaleString('en')} of ${(side * side).toLocaleString('en')} positions wrongly: that balls meet which miss each other, or the reverse.`;
    const {i, j} = this.chosen;
    const [a, b] = this.scene.balls;
    const moved = {...a, position: [a.position[0] + (i - side / 2) * this.step, a.position[1] + (j - side / 2) * this.step]};
    const times = [NaN, await this.engine.timeOf(1, [moved, b]), await this.engine.timeOf(2, [moved, b])];
    const rows = arithmetics.map(({title}, how) => {
      const answer = this.answers[how][j * side + i];
      const right = answer === this.answers[2][j * side + i];
      const time = times[how];
      const off = ulpsBetween(times[2], time);
      return element('tr', [
        element('td', title),
        element('td', element('span', encounters[answer], right ? '' : 'other')),
        element('td', Number.isNaN(time) ? '' : [`at ${time.toPrecision(17)}`, document.createElement('br'), element('span', hexadecimal(time), 'who')]),
        element('td', how === 1 && off ? `${off > 0 ? '+' : '−'}${Math.abs(off).toLocaleString('en')} ulp` : ''),
      ]);
    });
    const where = element('p', `Of ball 0 at (${moved.position.map(x => hexadecimal(x)).join(', ')}), the framed pixel:`);
    table.replaceChildren(where, element('table', rows));
  }

  // Wheel and pinch zoom; a tap asks about one place.
  #listen(canvas) {
    const fingers = new Map();
    let spread = 0;
    let moved = false;
    const distance = () => {
      const [p, q] = [...fingers.values()];
      return Math.hypot(p.x - q.x, p.y - q.y);
    };
    canvas.addEventListener('wheel', event => {
      event.preventDefault();
      this.turned = (this.turned ?? 0) - event.deltaY;
      if (Math.abs(this.turned) < 60) return;
      this.zoomBy(Math.sign(this.turned));
      this.turned = 0;
    }, {passive: false});
    canvas.addEventListener('pointerdown', event => {
      if (event.isTrusted) canvas.setPointerCapture(event.pointerId);
      fingers.set(event.pointerId, {x: event.clientX, y: event.clientY});
      moved = fingers.size > 1;
      if (fingers.size === 2) spread = distance();
    });
    canvas.addEventListener('pointermove', event => {
      if (!fingers.has(event.pointerId)) return;
      fingers.set(event.pointerId, {x: event.clientX, y: event.clientY});
      if (fingers.size !== 2) return;
      const levels = Math.trunc(Math.log2(distance() / spread) * 2);
      if (levels !== 0) {
        spread = distance();
        this.zoomBy(levels);
      }
    });
    const lift = event => {
      fingers.delete(event.pointerId);
      if (moved || fingers.size > 0 || event.type === 'pointercancel') return;
      const box = canvas.getBoundingClientRect();
      const index = (from, size) => Math.min(side - 1, Math.max(0, Math.floor((from / size) * side)));
      this.chosen = {i: index(event.clientX - box.left, box.width), j: side - 1 - index(event.clientY - box.top, box.height)};
      this.draw();
      this.#tell();
    };
    canvas.addEventListener('pointerup', lift);
    canvas.addEventListener('pointercancel', lift);
  }

  // The canvas, and the part of the plane that it shows, into which a scene is drawn.
  get drawing() {
    return {canvas: this.panels[0].canvas, view: this.view};
  }
}
