// Where one looks from, and the ground: both follow what is there until somebody takes the camera.
'use strict';

import {eachPoint, placeOf, root} from './nodes.js';

const THREE = MeshCat.THREE;
const VIEW_FROM = new THREE.Vector3(0.49, -0.70, 0.53).normalize();  // as in helpers/show/views/picture.py
const SIDE = 0.88, BARS = 92;  // share of the width, and pixels of the height, that are for names and controls

const upright = (v) => new THREE.Vector3(v.x, v.z, -v.y);  // three.js: y is up; ROS: z is up

export class Look {
  constructor(viewer) {
    this.viewer = viewer;
    this.ground = new THREE.Group();
    viewer.scene.add(this.ground, root);
    viewer.camera.fov = 40;
    viewer.controls.addEventListener('start', () => { this.byHand = true; });
    this.reset();
  }

  reset() {
    this.byHand = false;
    this.fitted = null;
    this.followed = null;
    this.news = true;
  }

  // A node to follow, and how much around it to show, in m; or null: everything.
  focus(path, span) {
    if (path === this.path && span === this.span) return;
    [this.path, this.span] = [path, span];
    this.reset();
  }

  update() {  // before a picture is drawn
    const {clientWidth, clientHeight} = this.viewer.dom_element;
    if (!this.news || !clientWidth || !clientHeight) return;  // a page that is not laid out yet has no size
    this.news = false;
    const place = this.path ? placeOf(this.path) : null, box = new THREE.Box3();
    if (place) {
      this.follow(place);
      this.drawGround(box.setFromCenterAndSize(place, new THREE.Vector3().setScalar(2 * this.span)));
      return;
    }
    root.updateWorldMatrix(true, false);
    const camera = this.viewer.camera, flat = new THREE.Vector3(), used = [0, 0], room = this.room();
    const project = camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse).multiply(root.matrixWorld);
    eachPoint((point) => {
      box.expandByPoint(point);
      flat.copy(point).applyMatrix4(project);
      used[0] = Math.max(used[0], Math.abs(flat.x) / room[0]);
      used[1] = Math.max(used[1], Math.abs(flat.y) / room[1]);
    });
    if (box.isEmpty()) return;
    this.drawGround(box);
    if (this.byHand) return;
    const most = Math.max(...used), radius = Math.max(0.05, box.getSize(new THREE.Vector3()).length() / 2);
    const fits = this.fitted && most < 1.08 && most > 0.45 && radius < 3 * this.fitted;
    if (!fits) this.fit(box.getCenter(new THREE.Vector3()), radius);
  }

  room() {  // what part of the picture the scene may fill, in x and in y
    const height = this.viewer.dom_element.clientHeight || 400;
    return [SIDE, Math.max(0.4, 1 - BARS / height)];
  }

  follow(place) {
    if (this.followed) {  // also with a camera that was moved by hand: it goes along
      const step = upright(place.clone().sub(this.followed));
      this.viewer.camera.position.add(step);
      this.viewer.controls.target.add(step);
      this.viewer.controls.update();
    } else {
      const camera = this.viewer.camera, tall = Math.tan(THREE.MathUtils.degToRad(camera.fov) / 2);
      this.place(place, 0.5 * this.span / tall / Math.min(1, camera.aspect), 0.5 * this.span);
    }
    this.followed = place;
  }

  fit(centre, radius) {
    const camera = this.viewer.camera;
    const right = new THREE.Vector3(0, 0, 1).cross(VIEW_FROM).normalize(), up = VIEW_FROM.clone().cross(right);
    const half = Math.tan(THREE.MathUtils.degToRad(camera.fov) / 2), room = this.room();
    const wide = room[0] * half * camera.aspect, tall = room[1] * half;
    let distance = 0.2 * radius;
    eachPoint((point) => {
      point.sub(centre);
      const away = Math.max(Math.abs(point.dot(right)) / wide, Math.abs(point.dot(up)) / tall);
      distance = Math.max(distance, away + point.dot(VIEW_FROM));
    });
    this.place(centre, distance, radius);
    this.fitted = radius;
  }

  place(centre, distance, radius) {
    const camera = this.viewer.camera;
    camera.position.copy(upright(centre.clone().addScaledVector(VIEW_FROM, distance)));
    camera.near = radius / 100;
    camera.far = radius * 200;
    camera.updateProjectionMatrix();
    this.viewer.controls.target.copy(upright(centre));
    this.viewer.controls.update();
  }

  drawGround(box) {
    const size = box.getSize(new THREE.Vector3()), wide = Math.max(size.x, size.y, 0.1);
    const power = 10 ** Math.floor(Math.log10(wide / 4));
    const step = power * [1, 2, 5, 10, 20].find((factor) => wide / (factor * power) <= 8);
    const low = [box.min.x, box.min.y].map((value) => Math.floor(value / step) - 1);
    const high = [box.max.x, box.max.y].map((value) => Math.ceil(value / step) + 1);
    const key = [step, ...low, ...high].join();
    if (this.drawn === key) return;
    this.drawn = key;
    for (const child of [...this.ground.children]) {
      this.ground.remove(child);
      child.geometry.dispose();
      child.material.dispose();
    }
    const points = [];
    for (let i = low[0]; i <= high[0]; i++) points.push(i, low[1], 0, i, high[1], 0);
    for (let i = low[1]; i <= high[1]; i++) points.push(low[0], i, 0, high[0], i, 0);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.Float32BufferAttribute(points.map((value) => value * step), 3));
    this.ground.add(new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({color: 0xc4cad3})));
    this.step = step;
  }
}
