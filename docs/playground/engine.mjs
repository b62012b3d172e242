// graze, compiled to WebAssembly: runs and decisions in three arithmetics.

export const arithmetics = [
  {key: 'float', title: 'float', about: 'the textbook’s formulas in 24 bits'},
  {key: 'double', title: 'double', about: 'the textbook’s formulas in 53 bits'},
  {key: 'graze', title: 'graze', about: 'the same doubles, decided exactly, rounded once'},
];
export const encounters = ['overlap', 'recede', 'miss', 'graze', 'hit'];
export const endings = {
  0: 'then the time was reached',
  1: 'as many as are asked for',
  2: 'then nothing more will ever happen',
  3: 'then stopped',
  4: 'then events without end at one time',
};
const partners = ['ball', 'plane', 'wall'];
const numbersOfEvent = 13;

export class Engine {
  #module;
  #graze;

  // bytes: the module.
  static async from(bytes) {
    const engine = new Engine();
    engine.#module = await WebAssembly.compile(bytes);
    await engine.#start();
    return engine;
  }

  // A run or a decision that ends the module (a state beyond the largest double) is an error; the module starts anew.
  async #start() {
    const nothing = new Proxy({}, {get: () => () => 8}); // no files and no clock: every request fails
    const instance = await WebAssembly.instantiate(this.#module, {wasi_snapshot_preview1: nothing, env: nothing});
    this.#graze = instance.exports;
    this.#graze._initialize();
  }

  #give(numbers) {
    const at = this.#graze.room(numbers.length);
    new Float64Array(this.#graze.memory.buffer, at, numbers.length).set(numbers);
  }

  async #ask(f) {
    try {
      return f(this.#graze);
    } catch (error) {
      await this.#start();
      throw new Error('this arithmetic leaves the range of its numbers here', {cause: error});
    }
  }

  // A scene's events {time, who, chosen, after: [of a, of b], each [x, y, u, v] or null}, and how the run ended.
  run(how, scene, most, until) {
    return this.#ask(graze => {
      const ball = b => [...b.position, ...b.velocity, b.radius, b.mass];
      this.#give([
        ...scene.balls.flatMap(ball),
        ...scene.planes.flatMap(p => [...p.point, ...p.normal]),
        ...scene.walls.flatMap(w => [...w.corner, ...w.edge]),
      ]);
      const ending = graze.run(how, scene.balls.length, scene.planes.length, scene.walls.length, most, until);
      const count = graze.event_count();
      const rows = new Float64Array(graze.memory.buffer, graze.first_event(), count * numbersOfEvent);
      const events = [];
      for (let i = 0; i < count; ++i) {
        const row = rows.slice(i * numbersOfEvent, (i + 1) * numbersOfEvent);
        const [time, kind, a, b, chosen] = row;
        events.push({
          time,
          a,
          b: kind === 0 ? b : -1,
          who: `ball ${a} and ${partners[kind]} ${b}`,
          chosen: chosen !== 0,
          afterA: row.slice(5, 9),
          afterB: row.slice(9, 13),
        });
      }
      return {events, ending};
    });
  }

  // The encounters of two balls for side × side positions of the first, `step` apart: indices into `encounters`.
  decide(how, [a, b], side, step) {
    return this.#ask(graze => {
      this.#giveBalls(a, b);
      const at = graze.decide(how, side, step);
      return new Uint8Array(graze.memory.buffer, at, side * side).slice();
    });
  }

  // When two balls meet; NaN if they do not.
  timeOf(how, [a, b]) {
    return this.#ask(graze => {
      this.#giveBalls(a, b);
      return graze.time_of(how);
    });
  }

  #giveBalls(...balls) {
    this.#give(balls.flatMap(b => [...b.position, ...b.velocity, b.radius, b.mass]));
  }
}
