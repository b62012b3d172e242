// A scene that runs: the same events in three arithmetics, side by side, step by step.
import {arithmetics, endings} from './engine.mjs';
import {hexadecimal, ulpsBetween} from './numbers.mjs';
import {element, makePanels, say} from './panels.mjs';
import {drawScene, viewOf} from './picture.mjs';

const trailEvents = 40; // ways are drawn for this many past events

export class RunView {
  constructor(page, engine) {
    this.page = page;
    this.engine = engine;
    page.event.addEventListener('input', () => this.goTo(Number(page.event.value)));
    page.first.addEventListener('click', () => this.goTo(0));
    page.back.addEventListener('click', () => this.goTo(this.index - 1));
    page.forward.addEventListener('click', () => this.goTo(this.index + 1));
    page.last.addEventListener('click', () => this.goTo(Infinity));
    page.part.addEventListener('click', () => this.goTo(this.parting(1) + 1));
    page.play.addEventListener('click', () => this.play(!this.timer));
  }

  async show(scene, most) {
    this.play(false);
    this.scene = scene;
    this.runs = [];
    for (const how of [0, 1, 2]) {
      try {
        this.runs.push(await this.engine.run(how, scene, most, Number.MAX_VALUE));
      } catch (error) {
        this.runs.push({events: [], ending: -1, error: error.message});
      }
    }
    this.count = Math.max(...this.runs.map(run => run.events.length));
    this.page.event.max = this.count;
    this.panels = makePanels(this.page.panels, arithmetics);
    this.page.panels.className = 'runs';
    const exact = this.runs[2].events;
    this.view = viewOf(scene, exact.flatMap(e => [[...e.afterA], ...(e.b < 0 ? [] : [[...e.afterB]])]));
    this.page.part.hidden = this.parting(1) >= exact.length;
    this.goTo(0);
    this.#sumUp();
  }

  key(name) {
    const to = {ArrowRight: this.index + 1, ArrowLeft: this.index - 1, Home: 0, End: Infinity}[name];
    if (to !== undefined) this.goTo(to);
    if (name === ' ') this.play(!this.timer);
    return to !== undefined || name === ' ';
  }

  play(on) {
    clearInterval(this.timer);
    this.timer = on ? setInterval(() => (this.index < this.count ? this.goTo(this.index + 1) : this.play(false)), 120) : null;
    this.page.play.setAttribute('aria-pressed', String(on));
  }

  // The first event in which an arithmetic differs from graze.
  parting(how) {
    const exact = this.runs[2].events;
    const other = this.runs[how].events;
    let k = 0;
    while (k < exact.length && k < other.length && exact[k].who === other[k].who) ++k;
    return k === exact.length && other.length > k ? k : k < exact.length ? k : Infinity;
  }

  // Shows the state after this many events.
  goTo(index) {
    this.index = Math.min(this.count, Math.max(0, index));
    this.page.event.value = this.index;
    this.page.position.textContent = `event ${this.index} of ${this.count}`;
    this.draw();
    this.#list();
  }

  draw() {
    this.panels.forEach((panel, how) => {
      const {events, error} = this.runs[how];
      const done = events.slice(0, this.index);
      const now = done.length ? done.at(-1).time : 0;
      const since = this.scene.balls.map(({position: [x, y], velocity: [u, v]}) => ({x, y, u, v, t: 0}));
      const trails = since.map(({x, y}) => [[x, y]]);
      done.forEach((event, k) => {
        const note = (ball, [x, y, u, v]) => {
          if (this.scene.balls[ball].mass === Infinity) return;
          since[ball] = {x, y, u, v, t: event.time};
          if (k < this.index - trailEvents) trails[ball] = [];
          trails[ball].push([x, y]);
        };
        note(event.a, event.afterA);
        if (event.b >= 0) note(event.b, event.afterB);
      });
      const balls = since.map(({x, y, u, v, t}) => ({x: x + u * (now - t), y: y + v * (now - t), u, v}));
      balls.forEach(({x, y}, i) => trails[i].push([x, y]));
      const last = done.at(-1);
      const met = last ? [last.a, last.b] : [];
      drawScene(panel.canvas, this.scene, this.view, {balls, trails, met, draft: how === 2 ? this.draft : null});
      const parted = this.parting(how) < this.index;
      say(panel.note, error ?? (how === 2 ? 'exact' : parted ? 'on a way of its own' : 'the same events'), error || parted ? 'bad' : how === 2 ? 'good' : '');
    });
  }

  #sumUp() {
    const exact = this.runs[2];
    if (exact.error) {
      this.page.verdict.textContent = `graze: ${exact.error}.`;
      return;
    }
    const parts = [0, 1].map(how => {
      const k = this.parting(how);
      return k === Infinity ? `${arithmetics[how].title} has the same events` : `${arithmetics[how].title} leaves them at event ${k + 1}`;
    });
    this.page.verdict.textContent = `${exact.events.length} ${exact.events.length === 1 ? 'event' : 'events'}, ${endings[exact.ending]}; ${parts.join(', ')}.`;
  }

  // The events around this one, with their times to the last bit.
  #list() {
    const from = Math.max(0, Math.min(this.index - 4, this.count - 7));
    const head = element('tr', ['event', ...arithmetics.map(a => a.title)].map(text => element('th', text)));
    const bits = (how, k, time) => (k + 1 === this.index ? [document.createElement('br'), element('span', hexadecimal(time, how === 0 ? 6 : 13), 'who')] : []);
    const rows = [];
    for (let k = from; k < Math.min(from + 7, this.count); ++k) {
      const exact = this.runs[2].events[k];
      const cells = this.runs.map(({events}, how) => {
        const event = events[k];
        if (!event) return element('td', '—');
        const digits = event.time.toPrecision(how === 0 ? 9 : 17);
        const right = exact ? exact.time.toPrecision(how === 0 ? 9 : 17) : '';
        let same = 0;
        while (same < digits.length && digits[same] === right[same]) ++same;
        const who = element('span', event.who + (event.chosen ? ' (a tie)' : ''), event.who === exact?.who ? 'who' : 'other');
        const off = how === 1 && event.who === exact?.who ? ulpsBetween(exact.time, event.time) : 0;
        const last = off ? ` ${off > 0 ? '+' : '−'}${Math.abs(off).toLocaleString('en')} ulp` : '';
        return element('td', [digits.slice(0, same), element('span', digits.slice(same), 'other'), element('span', last, 'who'), ...bits(how, k, event.time), document.createElement('br'), who]);
      });
      rows.push(element('tr', [element('td', String(k + 1)), ...cells], k + 1 === this.index ? 'now' : ''));
    }
    this.page.table.replaceChildren(element('table', [head, ...rows]));
  }

  get drawing() {
    return {canvas: this.panels[2].canvas, view: this.view};
  }
}
