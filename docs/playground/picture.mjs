// Pictures: the balls of a run at an event, and the map of a pair's decisions.

const colour = name => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

// Fits a canvas to its place in the page, in that shape and in the screen's pixels. Its unit is a CSS pixel.
export function prepare(canvas, aspect) {
  const width = canvas.clientWidth || 300;
  const height = Math.round(width * aspect);
  const density = window.devicePixelRatio || 1;
  canvas.style.height = `${height}px`;
  canvas.width = Math.round(width * density);
  canvas.height = Math.round(height * density);
  const pen = canvas.getContext('2d');
  pen.setTransform(density, 0, 0, density, 0, 0);
  pen.clearRect(0, 0, width, height);
  return {pen, width, height};
}

// The part of the plane that a picture shows: the whole scene and, if nothing holds the balls, where they go.
export function viewOf(scene, paths) {
  const xs = [];
  const ys = [];
  const add = (x, y, r = 0) => {
    xs.push(x - r, x + r);
    ys.push(y - r, y + r);
  };
  for (const b of scene.balls) add(...b.position, b.radius);
  for (const w of scene.walls) {
    add(...w.corner);
    add(w.corner[0] + w.edge[0], w.corner[1] + w.edge[1]);
  }
  for (const p of scene.planes) add(...p.point);
  if (scene.walls.length === 0) for (const [x, y] of paths) add(x, y);
  let [left, right, bottom, top] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const size = Math.max(right - left, top - bottom, 1e-300);
  const least = 0.28 * size; // so that it is neither a line nor a point
  const grow = (low, high) => (high - low < least ? [(low + high - least) / 2, (low + high + least) / 2] : [low, high]);
  [left, right] = grow(left, right);
  [bottom, top] = grow(bottom, top);
  const margin = 0.04 * size;
  return {left: left - margin, bottom: bottom - margin, width: right - left + 2 * margin, height: top - bottom + 2 * margin};
}

const place = (view, scale) => (x, y) => [(x - view.left) * scale, (view.bottom + view.height - y) * scale];

// The place in the scene of a point of the picture.
export function scenePoint(canvas, view, event) {
  const box = canvas.getBoundingClientRect();
  const scale = box.width / view.width;
  return [view.left + (event.clientX - box.left) / scale, view.bottom + view.height - (event.clientY - box.top) / scale];
}

// balls: each ball's {x, y, u, v} now; trails: each ball's list of points; met: the indices of the event's balls.
export function drawScene(canvas, scene, view, {balls, trails, met, draft}) {
  const {pen, width} = prepare(canvas, view.height / view.width);
  const scale = width / view.width;
  const at = place(view, scale);
  const line = (from, to, style, thick) => {
    pen.strokeStyle = style;
    pen.lineWidth = thick;
    pen.beginPath();
    pen.moveTo(...at(...from));
    pen.lineTo(...at(...to));
    pen.stroke();
  };
  const ink = colour('ink');
  for (const {point: [x, y], normal: [nx, ny]} of scene.planes) {
    const long = (2 * (view.width + view.height)) / Math.hypot(nx, ny);
    line([x - ny * long, y + nx * long], [x + ny * long, y - nx * long], ink, 1.5);
  }
  for (const {corner: [x, y], edge: [ex, ey]} of scene.walls) line([x, y], [x + ex, y + ey], ink, 2);

  pen.lineWidth = 1;
  pen.strokeStyle = colour('trail');
  for (const trail of trails) {
    pen.beginPath();
    trail.forEach(([x, y], i) => (i === 0 ? pen.moveTo(...at(x, y)) : pen.lineTo(...at(x, y))));
    pen.stroke();
  }
  balls.forEach(({x, y, u, v}, i) => {
    const ball = scene.balls[i];
    const radius = Math.max(ball.radius * scale, 2.5);
    const isMet = met.includes(i);
    const still = ball.mass === Infinity;
    pen.beginPath();
    pen.arc(...at(x, y), radius, 0, 2 * Math.PI);
    pen.fillStyle = colour(isMet ? 'graze' : still ? 'trail' : 'hit');
    pen.fill();
    const speed = Math.hypot(u, v);
    if (speed > 0) {
      const reach = (radius + 9) / scale / speed;
      line([x, y], [x + u * reach, y + v * reach], ink, 1.25);
    }
  });
  if (draft) line(draft.from, draft.to, colour('accent'), 2);
}

// answers: indices of encounters, row by row from the bottom; truth: the right ones.
export function drawMap(canvas, answers, truth, side, names, chosen) {
  const {pen, width} = prepare(canvas, 1);
  const rgb = name => {
    const c = colour(name);
    return [1, 3, 5].map(i => parseInt(c.slice(i, i + 2), 16));
  };
  const palette = Object.fromEntries(['hit', 'miss', 'graze', 'wrong'].map(name => [name, rgb(name)]));
  const image = new ImageData(side, side);
  answers.forEach((answer, k) => {
    const name = answer !== truth[k] ? 'wrong' : names[answer];
    const [r, g, b] = palette[name] ?? palette[name === 'overlap' ? 'hit' : 'miss'];
    const row = side - 1 - Math.floor(k / side);
    image.data.set([r, g, b, 255], 4 * (row * side + (k % side)));
  });
  const small = new OffscreenCanvas(side, side);
  small.getContext('2d').putImageData(image, 0, 0);
  pen.imageSmoothingEnabled = false;
  pen.drawImage(small, 0, 0, width, width);
  if (chosen) {
    const cell = width / side;
    pen.strokeStyle = colour('ink');
    pen.lineWidth = 2;
    pen.strokeRect((chosen.i - 1) * cell, (side - 2 - chosen.j) * cell, 3 * cell, 3 * cell);
  }
}
