// Scenes in the plane, to and from the JSON that graze-compare reads.
import {readNumber} from './numbers.mjs';

const keys = {
  scene: ['dimension', 'balls', 'planes', 'walls', 'name', 'description', 'source'],
  ball: ['position', 'velocity', 'radius', 'mass'],
  plane: ['point', 'normal'],
  wall: ['corner', 'edges'],
};

function fail(place, message) {
  throw new Error(place === '' ? message : `${place}: ${message}`);
}

function checkKeys(object, kind, place) {
  if (typeof object !== 'object' || object === null || Array.isArray(object)) fail(place, `a ${kind} is an object`);
  for (const key of Object.keys(object)) {
    if (!keys[kind].includes(key)) fail(`${place}/${key}`, 'unknown key');
  }
}

function number(value, place) {
  let x;
  try {
    x = readNumber(value);
  } catch (error) {
    fail(place, error.message);
  }
  return x;
}

function finite(value, place) {
  const x = number(value, place);
  if (!Number.isFinite(x)) fail(place, 'not a finite number');
  return x;
}

function vector(value, place) {
  if (!Array.isArray(value) || value.length !== 2) fail(place, 'two numbers are expected');
  return value.map((x, i) => finite(x, `${place}/${i}`));
}

function nonZero(value, place) {
  const v = vector(value, place);
  if (v[0] === 0 && v[1] === 0) fail(place, 'a vector of length 0');
  return v;
}

function readBall(ball, place) {
  checkKeys(ball, 'ball', place);
  const radius = finite(ball.radius, `${place}/radius`);
  const mass = ball.mass === undefined ? 1 : number(ball.mass, `${place}/mass`);
  if (radius < 0) fail(`${place}/radius`, 'a negative radius');
  if (!(mass > 0)) fail(`${place}/mass`, 'a mass that is not positive');
  return {
    position: vector(ball.position, `${place}/position`),
    velocity: vector(ball.velocity, `${place}/velocity`),
    radius,
    mass,
  };
}

function readPlane(plane, place) {
  checkKeys(plane, 'plane', place);
  return {point: vector(plane.point, `${place}/point`), normal: nonZero(plane.normal, `${place}/normal`)};
}

function readWall(wall, place) {
  checkKeys(wall, 'wall', place);
  if (!Array.isArray(wall.edges) || wall.edges.length !== 1) fail(`${place}/edges`, 'one edge is expected');
  return {corner: vector(wall.corner, `${place}/corner`), edge: nonZero(wall.edges[0], `${place}/edges/0`)};
}

// A scene of doubles. Throws an Error, which names the place of a mistake by its JSON pointer.
export function readScene(text) {
  const json = JSON.parse(text);
  checkKeys(json, 'scene', '');
  if (json.dimension !== 2) fail('/dimension', 'this page has scenes in the plane: 2 is expected');
  const list = (key, read) => {
    const items = json[key] ?? [];
    if (!Array.isArray(items)) fail(`/${key}`, 'an array is expected');
    return items.map((item, i) => read(item, `/${key}/${i}`));
  };
  const scene = {
    name: typeof json.name === 'string' ? json.name : 'scene',
    description: typeof json.description === 'string' ? json.description : '',
    balls: list('balls', readBall),
    planes: list('planes', readPlane),
    walls: list('walls', readWall),
  };
  if (scene.balls.length === 0) fail('/balls', 'at least one ball is expected');
  return scene;
}

// A scene's JSON, with a line for each thing. Doubles have as many digits as they need.
export function writeScene(scene) {
  const line = x => JSON.stringify(x, (_, value) => (value === Infinity ? 'inf' : value)).replaceAll(',', ', ').replaceAll(':', ': ');
  const list = (name, items) => (items.length ? `,\n  "${name}": [\n    ${items.map(line).join(',\n    ')}\n  ]` : '');
  return (
    `{\n  "dimension": 2,\n  "name": ${JSON.stringify(scene.name)}` +
    (scene.description ? `,\n  "description": ${JSON.stringify(scene.description)}` : '') +
    list('balls', scene.balls) +
    list('planes', scene.planes) +
    list('walls', scene.walls.map(wall => ({corner: wall.corner, edges: [wall.edge]}))) +
    '\n}\n'
  );
}

// To the fragment of an address, and back.
export const fragmentOf = text => '#' + encodeURIComponent(JSON.stringify(JSON.parse(text)));
export const textOfFragment = fragment => writeBack(decodeURIComponent(fragment.slice(1)));

function writeBack(text) {
  return JSON.stringify(JSON.parse(text), null, 1).replace(/\[\s+([^[\]{}]*?)\s+\]/g, (_, inner) => `[${inner.replace(/\s+/g, ' ')}]`);
}

// Whether it is two balls and nothing else; then every position near the first ball's is shown.
export const isPair = scene => scene.balls.length === 2 && scene.planes.length + scene.walls.length === 0;
