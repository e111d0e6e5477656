// The shapes of helpers/show/views/shapes.py as objects of three.js.
'use strict';

const THREE = MeshCat.THREE;
const AXES = [[0.86, 0.15, 0.18], [0.13, 0.62, 0.22], [0.13, 0.36, 0.86]];
export const resolution = new THREE.Vector2(1, 1);  // of the screen in pixels, for the width of lines

function shared(geometry) {  // by many objects: not to be disposed of with one of them
  geometry.userData = {shared: true};
  return geometry;
}

function coloured(geometry, colour) {
  const count = geometry.attributes.position.count;
  geometry.setAttribute('color', new THREE.BufferAttribute(perPoint(new Float32Array(colour), count), 3));
  return geometry;
}

function perPoint(colours, count) {
  if (colours.length === 3 * count) return colours;
  const all = new Float32Array(3 * count);
  for (let i = 0; i < count; i++) all.set(colours.subarray(0, 3), 3 * i);
  return all;
}

function merged(geometries) {
  const result = new THREE.BufferGeometry();
  const plain = geometries.map((geometry) => geometry.toNonIndexed());
  for (const name of ['position', 'normal', 'color']) {
    if (!plain[0].attributes[name]) continue;
    const parts = plain.map((geometry) => geometry.attributes[name].array);
    const all = new Float32Array(parts.reduce((sum, part) => sum + part.length, 0));
    parts.reduce((at, part) => { all.set(part, at); return at + part.length; }, 0);
    result.setAttribute(name, new THREE.BufferAttribute(all, 3));
  }
  return result;
}

const UNIT_AXES = shared(merged(AXES.map((colour, axis) => {
  const geometry = new THREE.CylinderGeometry(0.035, 0.035, 1, 10);
  geometry.translate(0, 0.5, 0);  // along +y
  if (axis === 0) geometry.rotateZ(-Math.PI / 2);
  if (axis === 2) geometry.rotateX(Math.PI / 2);
  return coloured(geometry, colour);
})));
const UNIT_BOX = shared(new THREE.BoxGeometry(1, 1, 1));
const UNIT_SPHERE = shared(new THREE.SphereGeometry(1, 24, 16));
const UNIT_CYLINDER = shared(new THREE.CylinderGeometry(1, 1, 1, 32).rotateX(Math.PI / 2));

function solid(geometry, colour, more) {
  return new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({color: new THREE.Color(...colour), ...more}));
}

// Each takes a shape and two functions that return one of its arrays, as floats or as integers.
// Points that lie on a surface, as those of a scan do, are drawn over it; and they are seen from afar.
const POINTS_NEARER = `
  gl_PointSize = max(gl_PointSize, 3.0);
  vec4 nearer = projectionMatrix * (mvPosition + vec4(0.0, 0.0, max(0.03, -0.006 * mvPosition.z), 0.0));
  gl_Position.z = nearer.z * gl_Position.w / nearer.w;
  #include <logdepthbuf_vertex>`;

const builders = {
  Axes(shape) {  // sticks, and thick lines in them, which stay visible from afar
    const all = new THREE.Group();
    all.add(new THREE.Mesh(UNIT_AXES, new THREE.MeshLambertMaterial({vertexColors: true})));
    const ends = AXES.flatMap((_, axis) => [0, 0, 0, ...[0, 1, 2].map((other) => (axis === other ? 1 : 0))]);
    all.add(thickLine(new Float32Array(ends), new Float32Array(AXES.flatMap((colour) => [...colour, ...colour])),
                      {pieces: true, width: 2.4}));
    all.scale.setScalar(shape.length);
    return all;
  },
  Arrow(shape) {
    const radius = shape.radius ?? shape.length / 20;
    const head = Math.min(shape.head ?? Math.min(6 * radius, 0.5 * shape.length), shape.length);
    const parts = [new THREE.CylinderGeometry(0, 2 * radius, head, 16).translate(0, shape.length - head / 2, 0)];
    if (head < shape.length) {
      const shaft = new THREE.CylinderGeometry(radius, radius, shape.length - head, 16);
      parts.push(shaft.translate(0, (shape.length - head) / 2, 0));
    }
    return solid(merged(parts).rotateZ(-Math.PI / 2), shape.colour);
  },
  Box(shape) {
    const mesh = solid(UNIT_BOX, shape.colour);
    mesh.scale.set(...shape.size);
    return mesh;
  },
  Cylinder(shape) {
    const mesh = solid(UNIT_CYLINDER, shape.colour);
    mesh.scale.set(shape.radius, shape.radius, shape.length);
    return mesh;
  },
  Sphere(shape) {
    const mesh = solid(UNIT_SPHERE, shape.colour);
    mesh.scale.setScalar(shape.radius);
    return mesh;
  },
  Mesh(shape, floats, integers) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(floats(shape.vertices), 3));
    geometry.setIndex(new THREE.BufferAttribute(integers(shape.faces), 1));
    geometry.computeVertexNormals();
    return solid(geometry, shape.colour, {side: THREE.DoubleSide, flatShading: true});
  },
  Points(shape, floats) {
    const geometry = pointGeometry(floats(shape.points), floats(shape.colours));
    const material = new THREE.PointsMaterial({size: shape.size, vertexColors: true});
    material.onBeforeCompile = (shader) => {
      shader.vertexShader = shader.vertexShader.replace('#include <logdepthbuf_vertex>', POINTS_NEARER);
    };
    const cloud = new THREE.Points(geometry, material);
    cloud.frustumCulled = false;
    return cloud;
  },
  Line(shape, floats) {
    return thickLine(floats(shape.points), floats(shape.colours), shape);
  },
};

function pointGeometry(points, colours) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(points, 3));
  geometry.setAttribute('color', new THREE.BufferAttribute(perPoint(colours, points.length / 3), 3));
  return geometry;
}

// What often comes anew, and what must be the same for that only its numbers change: a new material costs time.
const RENEWABLE = {Line: ['width', 'dashed', 'on_top'], Points: ['size']};

export function renew(content, shape, floats) {
  const last = content.userData.shape, fixed = RENEWABLE[shape.type];
  if (!fixed || last.type !== shape.type || fixed.some((name) => last[name] !== shape[name])) return false;
  const points = floats(shape.points), colours = floats(shape.colours);
  content.geometry.dispose();
  content.geometry = shape.type === 'Line' ? lineGeometry(points, colours, shape) : pointGeometry(points, colours);
  content.userData.shape = shape;
  return true;
}

export function build(shape, floats, integers) {
  const content = builders[shape.type](shape, floats, integers);
  content.userData.shape = shape;
  if (shape.on_top) {
    content.traverse((part) => {
      part.renderOrder = ON_TOP;
      if (part.material) part.material.transparent = true;  // three.js draws these last
    });
  }
  return content;
}

// Drawn after all that can hide and before all that shall not be hidden: between them distances begin anew.
const ON_TOP = 2;
const NOTHING = new THREE.MeshBasicMaterial({colorWrite: false, depthWrite: false, transparent: true});
export const curtain = new THREE.Mesh(new THREE.BoxGeometry(1e-6, 1e-6, 1e-6), NOTHING);
curtain.frustumCulled = false;
curtain.renderOrder = ON_TOP - 1;
curtain.onBeforeRender = (renderer) => {
  renderer.state.buffers.depth.setMask(true);
  renderer.clearDepth();
};

export function dispose(content) {
  content.traverse((part) => {
    if (part.geometry && !part.geometry.userData.shared) part.geometry.dispose();
    if (part.material) part.material.dispose();
  });
}

export function setOpacity(content, opacity) {
  content.traverse((part) => {
    if (!part.material) return;
    part.material.transparent = opacity < 1 || part.renderOrder === ON_TOP;
    part.material.depthWrite = opacity >= 1;
    part.material.opacity = opacity;
    if (part.material.uniforms) part.material.uniforms.opacity.value = opacity;
    part.material.needsUpdate = true;
  });
}

// -- lines: WebGL draws them one pixel wide; here each piece is a rectangle of the right width on the screen

const VERTEX = `
  attribute vec3 a; attribute vec3 b; attribute vec3 ca; attribute vec3 cb;
  uniform vec2 resolution; uniform float width;
  varying vec3 colour; varying float along; varying float w;
  void main() {
    vec4 s = modelViewMatrix * vec4(a, 1.0), e = modelViewMatrix * vec4(b, 1.0);
    float near = -0.01;  // what is behind the camera is cut off
    if (s.z > near && e.z < near) s = mix(s, e, (near - s.z) / (e.z - s.z));
    if (e.z > near && s.z < near) e = mix(e, s, (near - e.z) / (s.z - e.z));
    vec4 cs = projectionMatrix * s, ce = projectionMatrix * e;
    vec2 from = cs.xy / cs.w * resolution * 0.5, to = ce.xy / ce.w * resolution * 0.5;
    vec2 way = to - from;
    float pixels = length(way);
    way = pixels > 1e-5 ? way / pixels : vec2(1.0, 0.0);
    vec4 here = position.y < 0.5 ? cs : ce;
    here.xy += (vec2(-way.y, way.x) * position.x + way * (position.y - 0.5) * 0.8) * width / resolution * here.w;
    colour = position.y < 0.5 ? ca : cb;
    w = here.w;
    along = position.y * pixels * w;  // divided by w again: linear on the screen
    gl_Position = here;
  }`;
const FRAGMENT = `
  uniform float opacity; uniform float dash;
  varying vec3 colour; varying float along; varying float w;
  void main() {
    if (dash > 0.0 && mod(along / w, dash) > 0.55 * dash) discard;
    gl_FragColor = vec4(colour, opacity);
  }`;
const DASH = 9;  // pixels

function lineGeometry(points, colours, shape) {
  const step = shape.pieces ? 2 : 1;
  const count = Math.max(0, shape.pieces ? points.length / 6 : points.length / 3 - 1);
  const all = perPoint(colours, points.length / 3);
  const [a, b, ca, cb] = [0, 1, 2, 3].map(() => new Float32Array(3 * count));
  for (let i = 0; i < count; i++) {
    const from = 3 * step * i;
    a.set(points.subarray(from, from + 3), 3 * i);
    b.set(points.subarray(from + 3, from + 6), 3 * i);
    ca.set(all.subarray(from, from + 3), 3 * i);
    cb.set(all.subarray(from + 3, from + 6), 3 * i);
  }
  const geometry = new THREE.InstancedBufferGeometry();
  const corners = new Float32Array([-1, 0, 0, 1, 0, 0, 1, 1, 0, -1, 1, 0]);
  geometry.setAttribute('position', new THREE.BufferAttribute(corners, 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  for (const [name, values] of [['a', a], ['b', b], ['ca', ca], ['cb', cb]]) {
    geometry.setAttribute(name, new THREE.InstancedBufferAttribute(values, 3));
  }
  geometry.instanceCount = count;
  geometry.userData = {ends: [a, b]};
  return geometry;
}

function thickLine(points, colours, shape) {
  const mesh = new THREE.Mesh(lineGeometry(points, colours, shape), new THREE.ShaderMaterial({
    vertexShader: VERTEX, fragmentShader: FRAGMENT, side: THREE.DoubleSide,
    uniforms: {resolution: {value: resolution}, width: {value: shape.width}, opacity: {value: 1},
               dash: {value: shape.dashed ? DASH : 0}},
  }));
  mesh.frustumCulled = false;
  return mesh;
}
