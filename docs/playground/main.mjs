// The page: shows a scene by one of the views.
import {Drawing} from './drawing.mjs';
import {Engine} from './engine.mjs';
import {module} from './graze_module.mjs';
import {PairView} from './pair_view.mjs';
import {RunView} from './run_view.mjs';
import {fragmentOf, isPair, readScene, textOfFragment, writeScene} from './scene.mjs';
import {scenes} from './scenes.mjs';

const ids = [
  'scenes', 'description', 'panels', 'verdict', 'table', 'own', 'json', 'apply', 'fault', 'undo', 'empty', 'share', 'told',
  'pair', 'zoom', 'in', 'out', 'scale', 'steps', 'first', 'back', 'play', 'forward', 'last', 'event', 'position', 'part',
];
const eventsOfOwn = 400;
const table = {name: 'my scene', description: '', balls: [{position: [0.5, 0.5], velocity: [1, 0.75], radius: 0.0625, mass: 1}], planes: [],
  walls: [[0, 0, 2, 0], [2, 0, 0, 1], [0, 1, 2, 0], [0, 0, 0, 1]].map(([x, y, u, v]) => ({corner: [x, y], edge: [u, v]}))};

// The module from its gzipped base64 text.
async function unpacked(base64) {
  const packed = Uint8Array.from(atob(base64), c => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}

export async function start(document) {
  const page = Object.fromEntries(ids.map(id => [id, document.getElementById(id)]));
  const engine = await Engine.from(await unpacked(module));
  const views = {pair: new PairView(page, engine), run: new RunView(page, engine)};
  let view = views.pair;
  let shown = null;
  const history = [];

  // Shows a scene. A text written by hand is left unchanged.
  async function show(scene, text = writeScene(scene), most = eventsOfOwn, {remember = true} = {}) {
    if (remember && shown) history.push(shown);
    shown = {scene, text, most};
    view = isPair(scene) ? views.pair : views.run;
    views.run.play(false);
    page.pair.hidden = view !== views.pair;
    page.steps.hidden = view !== views.run;
    page.description.textContent = scene.description;
    page.json.value = text;
    page.fault.textContent = '';
    page.told.textContent = '';
    for (const button of page.scenes.children) {
      button.setAttribute('aria-checked', String(scenes[button.dataset.index].text === text));
    }
    window.history.replaceState(null, '', fragmentOf(text));
    await view.show(scene, most);
    drawing.listen(view.drawing, scene);
    document.body.dataset.shown = scene.name;
  }

  const drawing = new Drawing(
    document.querySelectorAll('.tool'),
    scene => show(scene),
    line => {
      view.draft = line;
      view.draw();
    },
  );

  scenes.forEach(({title, text, most}, index) => {
    const button = document.createElement('button');
    Object.assign(button, {type: 'button', textContent: title});
    button.dataset.index = index;
    button.setAttribute('role', 'radio');
    button.addEventListener('click', () => show(readScene(text), text, most));
    page.scenes.append(button);
  });
  page.apply.addEventListener('click', async () => {
    try {
      await show(readScene(page.json.value), page.json.value);
    } catch (error) {
      page.fault.textContent = error.message;
    }
  });
  page.undo.addEventListener('click', () => {
    const before = history.pop();
    if (before) show(before.scene, before.text, before.most, {remember: false});
  });
  page.empty.addEventListener('click', () => show(table));
  page.share.addEventListener('click', async () => {
    try {
      await navigator.clipboard.writeText(window.location.href);
      page.told.textContent = 'copied';
    } catch {
      page.told.textContent = 'the address of this page is what to copy';
    }
  });

  document.addEventListener('keydown', event => {
    const isEditing = event.target.closest?.('textarea, input, button, summary') && event.key !== 'Home' && event.key !== 'End';
    if (isEditing && (event.key === ' ' || event.target.closest('textarea, input'))) return;
    if (event.target.closest?.('textarea') || event.ctrlKey || event.metaKey || event.altKey) return;
    if (view.key(event.key)) event.preventDefault();
  });
  new ResizeObserver(() => shown && view.panels && view.draw()).observe(page.panels);
  window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => view.draw());
  window.addEventListener('hashchange', open);

  // The scene in the address or, without one, the first.
  async function open() {
    const {hash} = window.location;
    if (shown && hash === fragmentOf(shown.text)) return;
    let fault = '';
    if (hash.length > 1) {
      try {
        const text = textOfFragment(hash);
        const known = scenes.find(s => fragmentOf(s.text) === fragmentOf(text));
        await show(readScene(text), known?.text ?? text, known?.most);
        return;
      } catch (error) {
        fault = `The address has no scene: ${error.message}`;
      }
    }
    await show(readScene(scenes[0].text), scenes[0].text, scenes[0].most);
    if (fault) page.verdict.textContent = fault;
  }
  await open();
  document.body.dataset.ready = 'yes';
}
