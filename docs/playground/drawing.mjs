// Drawing into a picture: a drag makes a ball with its velocity, or a wall.
import {scenePoint} from './picture.mjs';

// add(scene with one thing more) is called after each drag; sketch(line) while it lasts.
export class Drawing {
  constructor(tools, add, sketch) {
    this.tool = null;
    this.tools = tools;
    this.add = add;
    this.sketch = sketch;
    for (const button of tools) button.addEventListener('click', () => this.choose(button.dataset.tool));
  }

  choose(tool) {
    this.tool = this.tool === tool ? null : tool;
    for (const button of this.tools) button.setAttribute('aria-pressed', String(button.dataset.tool === this.tool));
  }

  listen({canvas, view}, scene) {
    // Points of a grid of powers of two: short numbers, which every arithmetic holds.
    const grid = 2 ** Math.floor(Math.log2(view.width / 200));
    const snapped = event => scenePoint(canvas, view, event).map(x => Math.round(x / grid) * grid);
    let from = null;
    canvas.addEventListener('pointerdown', event => {
      if (!this.tool) return;
      event.stopImmediatePropagation();
      if (event.isTrusted) canvas.setPointerCapture(event.pointerId);
      from = snapped(event);
    });
    canvas.addEventListener('pointermove', event => {
      if (from) this.sketch({from, to: snapped(event)});
    });
    canvas.addEventListener('pointerup', event => {
      if (!from) return;
      const to = snapped(event);
      const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
      const larger = {...scene, name: 'my scene', description: '', balls: [...scene.balls], walls: [...scene.walls]};
      if (this.tool === 'ball') {
        const radius = scene.balls.length ? Math.max(...scene.balls.map(b => b.radius)) : 4 * grid;
        larger.balls.push({position: from, velocity: [dx, dy], radius, mass: 1});
      } else if (dx !== 0 || dy !== 0) {
        larger.walls.push({corner: from, edge: [dx, dy]});
      }
      from = null;
      this.sketch(null);
      this.add(larger);
    });
    canvas.addEventListener('pointercancel', () => {
      from = null;
      this.sketch(null);
    });
  }
}
