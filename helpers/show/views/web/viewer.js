// The page of one view: meshcat's viewer (three.js, camera, lights), fed by the kernel, with a few controls. Where the
// browser has no WebGL, pictures that the kernel draws.
'use strict';

import {at, webgl} from './page.js';

const {drawn, show} = await import(webgl ? './stage.js' : './flat.js');

let undrawn = 0;
drawn.push(() => {
  if (undrawn) tell({drawn: undrawn});  // the kernel does not send more than can be drawn
  undrawn = 0;
});

// -- controls

const fixed = at('fixed'), slider = at('slider'), when = at('when'), live = at('live');
let dragging = false;

function showState(state) {
  const wanted = ['', ...state.frames], there = [...fixed.options].map((option) => option.value);
  if (state.chosen && !wanted.includes(state.chosen)) wanted.push(state.chosen);
  if (wanted.join('\n') !== there.join('\n')) {
    fixed.replaceChildren(...wanted.map((frame) => new Option(frame, frame)));
  }
  fixed.options[0].textContent = state.chosen ? 'automatic' : `automatic: ${state.fixed_frame || 'no frame yet'}`;
  if (document.activeElement !== fixed) fixed.value = state.chosen;
  slider.min = -state.history;
  if (!dragging) slider.value = state.past === null ? 0 : -state.past;
  when.textContent = state.past === null ? 'now' : `${state.past.toFixed(2)} s ago`;
  when.classList.toggle('past', state.past !== null);
  live.setAttribute('aria-pressed', String(state.past === null));
}

const tell = (content) => { if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(content)); };
fixed.addEventListener('change', () => { fixed.blur(); tell({fixed_frame: fixed.value}); });
slider.addEventListener('pointerdown', () => { dragging = true; });
slider.addEventListener('pointerup', () => { dragging = false; });
slider.addEventListener('input', () => tell({past: -Number(slider.value)}));
live.addEventListener('click', () => tell({past: 0}));

// -- the kernel

const ENDED = 4000;       // the server's code for a view that has stopped
const TRIES = [1, 3, 9];  // s before each try to connect again, as after a proxy's hiccup
let socket, tries = 0;
let ended = false;  // the view's block has ended: nothing more comes, but it can be turned

function connect() {
  socket = new WebSocket(new URL('socket', location.href).href.replace(/^http/, 'ws'));
  socket.binaryType = 'arraybuffer';
  socket.onmessage = (event) => {
    undrawn += 1;
    tries = 0;
    const state = show(event.data);
    if (state) {
      showState(state);
      ended = Boolean(state.ended);
    }
    document.body.classList.toggle('ended', ended);
  };
  socket.onclose = (event) => {
    undrawn = 0;
    document.body.classList.add('ended');
    if (event.code !== ENDED && tries < TRIES.length) setTimeout(connect, 1000 * TRIES[tries++]);
  };
}
connect();
