// The page of a recorded view: see helpers/show/views/recording.py.
'use strict';

import {at} from './page.js';
import {show} from './stage.js';

const play = at('play'), slider = at('slider'), when = at('when');
let messages = [], length = 0;  // [{time, buffer}]; s
let next = 0, now = 0;          // index of the first message that is not yet shown; s
let last = null;                // when the playing clock last moved, in ms; null: it stands still

async function unpack(text) {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  const buffer = await new Response(stream).arrayBuffer(), view = new DataView(buffer), found = [];
  for (let start = 0; start < buffer.byteLength;) {
    const size = view.getUint32(start + 8, true);
    found.push({time: view.getFloat64(start, true), buffer: buffer.slice(start + 12, start + 12 + size)});
    start += 12 + size;
  }
  return found;
}

function goTo(time) {  // s since the beginning
  now = Math.min(length, Math.max(0, time));
  if (next && messages[next - 1].time > now) next = 0;  // the first message begins anew
  for (; next < messages.length && messages[next].time <= now; next++) {
    const state = show(messages[next].buffer);
    if (!state) continue;
    const past = state.past === null ? '' : `, ${state.past.toFixed(2)} s before the latest`;
    at('fixed').textContent = `fixed frame: ${state.fixed_frame}${past}`;
  }
  slider.value = now;
  when.textContent = `${now.toFixed(1)} of ${length.toFixed(1)} s`;
}

function run(wanted) {
  last = wanted ? performance.now() : null;
  play.textContent = wanted ? 'pause' : 'play';
  if (wanted) requestAnimationFrame(tick);
}

function tick() {
  if (last === null) return;
  const time = performance.now(), passed = Math.min(0.5, (time - last) / 1000);  // a hidden page waits
  last = time;
  goTo(now + passed);
  if (now < length) requestAnimationFrame(tick); else run(false);
}

play.addEventListener('click', () => {
  if (last === null && now >= length) goTo(0);
  run(last === null);
});
slider.addEventListener('input', () => {
  run(false);
  goTo(Number(slider.value));
});

unpack(at('recording').textContent.trim()).then((found) => {
  messages = found;
  length = found[found.length - 1].time;
  slider.max = length;
  if (length === 0) at('bottom').style.display = 'none';
  goTo(0);
  run(length > 0 && !matchMedia('(prefers-reduced-motion: reduce)').matches);
}).catch((error) => { at('problems').textContent = `This browser cannot replay the scene: ${error.message}`; });
