// The scene of helpers/show/views/scene.py: nodes by id and path. The messages that change them: helpers/show/views/live_view.py.
'use strict';

import {read} from './message.js';
import {build, dispose, renew, setOpacity} from './shapes.js';

const THREE = MeshCat.THREE;
export const root = new THREE.Group();
export const labels = new Map();  // id -> {group, shape}
const nodes = new Map();          // id -> group
const byPath = new Map();         // path -> group

function node(id, path) {
  let found = nodes.get(id);
  if (found) return found;
  found = new THREE.Group();
  found.matrixAutoUpdate = false;
  found.name = path;
  found.userData = {id, opacity: 1, content: null};
  (byPath.get(path.slice(0, Math.max(0, path.lastIndexOf('/')))) || root).add(found);
  nodes.set(id, found);
  byPath.set(path, found);
  return found;
}

function remove(id) {
  const gone = nodes.get(id);
  if (!gone) return;
  gone.parent.remove(gone);
  const all = [];
  gone.traverse((child) => { if (child.userData.id !== undefined) all.push(child); });
  for (const child of all) {
    setContent(child, null);
    nodes.delete(child.userData.id);
    labels.delete(child.userData.id);
    if (byPath.get(child.name) === child) byPath.delete(child.name);
  }
}

function setContent(target, content) {
  const old = target.userData.content;
  if (old) {
    target.remove(old);
    dispose(old);
  }
  target.userData.content = content;
  if (!content) return;
  target.add(content);
  const opacity = opacityOf(target);
  if (opacity < 1) setOpacity(content, opacity);
}

export function opacityOf(target) {
  let opacity = 1;
  for (let at = target; at && at !== root; at = at.parent) opacity *= at.userData.opacity ?? 1;
  return opacity;
}

export function isVisible(target) {
  for (let at = target; at && at !== root; at = at.parent) if (!at.visible) return false;
  return true;
}

// Where a node is, in coordinates of the fixed frame; null if there is none.
export function placeOf(path) {
  const target = byPath.get(path);
  if (!target) return null;
  root.updateWorldMatrix(true, true);
  return root.worldToLocal(new THREE.Vector3().setFromMatrixPosition(target.matrixWorld));
}

// Brings the nodes up to date with one message. Returns its JSON.
export function take(buffer) {
  const [message, start] = read(buffer);
  const floats = ([offset, count]) => new Float32Array(buffer.slice(start + offset, start + offset + 4 * count));
  const integers = ([offset, count]) => new Uint32Array(buffer.slice(start + offset, start + offset + 4 * count));
  if (message.reset) for (const child of [...root.children]) remove(child.userData.id);
  for (const id of message.deleted || []) remove(id);
  for (const [id, path, shape] of message.shapes || []) {
    const target = node(id, path), label = shape && shape.type === 'Label';
    labels.delete(id);
    if (label) labels.set(id, {group: target, shape});
    if (shape && target.userData.content && renew(target.userData.content, shape, floats)) continue;
    setContent(target, shape && !label ? build(shape, floats, integers) : null);
  }
  for (const [id, visible, opacity] of message.appearances || []) {
    const target = nodes.get(id);
    if (!target) continue;
    target.visible = visible;
    if (target.userData.opacity === opacity) continue;
    target.userData.opacity = opacity;
    target.traverse((child) => {
      if (child.userData.content) setOpacity(child.userData.content, opacityOf(child));
    });
  }
  if (message.poses) {
    const ids = integers(message.poses[0]), matrices = floats(message.poses[1]);
    ids.forEach((id, i) => {
      const target = nodes.get(id);
      if (!target) return;
      target.matrix.fromArray(matrices, 16 * i);
      target.matrixWorldNeedsUpdate = true;
    });
  }
  return message;
}

// Calls take(point) for points that say how far all that is visible reaches, in coordinates of the fixed frame.
export function eachPoint(take) {
  const point = new THREE.Vector3();
  root.updateWorldMatrix(true, true);
  const back = root.matrixWorld.clone().invert(), matrix = new THREE.Matrix4();
  const add = (target) => {
    if (!target.visible) return;
    if (target.userData.content) target.userData.content.traverse((part) => {
      matrix.multiplyMatrices(back, part.matrixWorld);
      if (part.geometry && part.geometry.userData.ends) {
        for (const values of part.geometry.userData.ends) {
          for (let i = 0; i < values.length; i += 3) take(point.fromArray(values, i).applyMatrix4(matrix));
        }
      } else if (part.isPoints) {
        const values = part.geometry.attributes.position;
        for (let i = 0; i < values.count; i += 5) take(point.fromBufferAttribute(values, i).applyMatrix4(matrix));
      } else if (part.geometry) {
        if (!part.geometry.boundingBox) part.geometry.computeBoundingBox();
        const {min, max} = part.geometry.boundingBox;
        for (let i = 0; i < 8; i++) {
          take(point.set(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z).applyMatrix4(matrix));
        }
      }
    });
    for (const child of target.children) if (child.userData.id !== undefined) add(child);
  };
  for (const child of root.children) add(child);
}
