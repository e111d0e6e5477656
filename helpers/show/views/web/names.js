// Names, drawn on a canvas above the picture: sharp, turned to the viewer, never hidden, and out of each other's way.
'use strict';

import {isVisible, labels, opacityOf} from './nodes.js';

const THREE = MeshCat.THREE;
const SIZE = 13, FONT = 'system-ui, sans-serif';  // pixels
// Left or right of the point, and how many lines above or below it; the best free one is taken.
const PLACES = [[1, -1], [1, 1], [-1, -1], [-1, 1], [1, -2.3], [1, 2.3], [-1, -2.3], [-1, 2.3], [1, -3.6], [1, 3.6]];

export function drawNames(canvas, camera) {
  const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const pen = canvas.getContext('2d'), taken = [], point = new THREE.Vector3();
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, width, height);
  pen.textBaseline = 'middle';
  pen.lineJoin = 'round';
  for (const label of labels.values()) {
    const {group, shape} = label;
    if (!shape.text || !isVisible(group)) continue;
    point.setFromMatrixPosition(group.matrixWorld).applyMatrix4(camera.matrixWorldInverse);
    if (point.z > -camera.near) continue;
    const scale = height / 2 / Math.tan(THREE.MathUtils.degToRad(camera.fov) / 2) / -point.z;
    const size = shape.height === null ? SIZE : Math.min(200, 1.4 * shape.height * scale);
    if (size < 4) continue;
    point.applyMatrix4(camera.projectionMatrix);
    const x = (point.x + 1) / 2 * width, y = (1 - point.y) / 2 * height;
    pen.font = `${shape.bold ? 600 : 400} ${size}px ${FONT}`;
    const long = pen.measureText(shape.text).width, tall = 1.15 * size;
    let box;
    if (shape.height !== null) {  // one that was given a size stands where it was put
      box = {left: x - long / 2, middle: y, long, tall};
    } else {
      const [place, covered] = freePlace(x, y, long, tall, taken, label.place ?? 0);
      label.place = place;
      label.left_out = covered > (label.left_out ? 0.1 : 0.3) * long * tall;  // no room: nearer, there is more
      if (label.left_out) continue;
      box = boxAt(PLACES[place], x, y, long, tall);
      taken.push(box);
    }
    write(pen, shape, box, x, y, size, opacityOf(group));
  }
}

function boxAt([side, up], x, y, long, tall) {
  return {left: side > 0 ? x + 8 : x - 8 - long, middle: y + up * 0.75 * tall, long, tall};
}

function freePlace(x, y, long, tall, taken, last) {  // the last one, as long as nothing better is there: no flicker
  const covered = (place) => {
    const box = boxAt(PLACES[place], x, y, long, tall);
    return taken.reduce((sum, other) => sum
      + Math.max(0, Math.min(box.left + box.long, other.left + other.long) - Math.max(box.left, other.left))
      * Math.max(0, (box.tall + other.tall) / 2 - Math.abs(box.middle - other.middle)), 0);
  };
  let best = last, least = covered(last);
  for (let place = 0; least > 0 && place < PLACES.length; place++) {
    const much = covered(place);
    if (much < least) [best, least] = [place, much];
  }
  return [best, least];
}

function write(pen, shape, box, x, y, size, opacity) {
  const colour = `rgb(${shape.colour.map((value) => Math.round(255 * value)).join()})`;
  pen.globalAlpha = opacity;
  if (Math.abs(box.middle - y) > box.tall) {  // far off: a thin line leads to the point
    pen.strokeStyle = colour;
    pen.lineWidth = 0.7;
    pen.beginPath();
    pen.moveTo(x, y);
    pen.lineTo(box.left > x ? box.left - 2 : box.left + box.long + 2, box.middle);
    pen.stroke();
  }
  pen.strokeStyle = 'rgba(255,255,255,0.85)';
  pen.lineWidth = Math.max(3.5, 0.2 * size);
  pen.strokeText(shape.text, box.left, box.middle);
  pen.fillStyle = colour;
  pen.fillText(shape.text, box.left, box.middle);
  pen.globalAlpha = 1;
}
