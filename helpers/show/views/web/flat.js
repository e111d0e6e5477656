// In place of stage.js where the browser has no WebGL: still pictures that the kernel draws, one after the other.
'use strict';

import {read} from './message.js';
import {at} from './page.js';

const PAUSE = 200;  // ms between two pictures
const picture = new Image();
let number = 0, news = false, busy = false;
export const drawn = [];  // functions to call after each picture

picture.alt = 'frames';
at('pane').append(picture);
document.body.classList.add('flat');

async function draw() {
  busy = true;
  while (news) {
    news = false;
    picture.src = `picture?${++number}`;
    await picture.decode().catch(() => {});  // the view may have stopped meanwhile
    for (const call of drawn) call();
    await new Promise((wake) => setTimeout(wake, PAUSE));
  }
  busy = false;
}

// Asks for a picture, as one message tells of news. Returns the message's state, if it has one.
export function show(buffer) {
  news = true;
  if (!busy) draw();
  return read(buffer)[0].state;
}
