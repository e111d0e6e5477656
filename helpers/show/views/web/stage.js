// What the page of a view shows, live or recorded: meshcat's viewer, the names over it, and two buttons for them.
'use strict';

import {Look} from './camera.js';
import {drawNames} from './names.js';
import {take} from './nodes.js';
import {at, webgl} from './page.js';
import {curtain, resolution} from './shapes.js';

if (!webgl) {
  document.body.classList.add('flat');
  at('bottom').hidden = true;
  throw new Error('no WebGL');
}
const viewer = new MeshCat.Viewer(at('pane'));
for (const path of [['Grid'], ['Axes'], ['Background']]) viewer.set_property(path, 'visible', false);
viewer.gui.domElement.style.display = 'none';
viewer.scene.add(curtain);
const look = new Look(viewer), canvas = at('labels');
let withNames = true;
export const drawn = [];  // functions to call after each picture

const render = viewer.render.bind(viewer);
viewer.render = () => {
  resolution.set(canvas.clientWidth, canvas.clientHeight);
  look.update();
  render();
  canvas.style.visibility = withNames ? 'visible' : 'hidden';
  if (withNames) drawNames(canvas, viewer.camera);
  for (const call of drawn) call();
};

window.addEventListener('resize', () => { look.news = true; viewer.set_dirty(); });
at('fit').addEventListener('click', () => { look.reset(); viewer.set_dirty(); });
at('names').addEventListener('click', () => {
  withNames = !withNames;
  at('names').setAttribute('aria-pressed', String(withNames));
  viewer.set_dirty();
});

// Brings the scene up to date with one message. Returns its state, if it has one.
export function show(buffer) {
  const {state} = take(buffer);
  if (state) {
    at('problems').textContent = state.problems.join('\n');
    look.focus(state.focus, state.span);
  }
  look.news = true;
  window.updates = (window.updates || 0) + 1;  // for measurements
  viewer.set_dirty();
  return state;
}
