// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The picture: a mesh whose pieces have colors, can be moved and hidden. It needs the global THREE
// with its OrbitControls.

import { firstViews } from "./first_view.js";

function inUnitBall(points) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  points.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  const centered = points.map((x, i) => x - (low[i % 3] + high[i % 3]) / 2);
  let radius = 0;
  for (let v = 0; v < centered.length; v += 3)
    radius = Math.max(radius, Math.hypot(centered[v], centered[v + 1], centered[v + 2]));
  return centered.map(x => x / (radius || 1));
}

// For each point the mean of the normals around it, whatever the orientation of the triangles.
function pointNormals(points, triangles) {
  const normals = new Float32Array(points.length);
  const n = [0, 0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const [p, q, r] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
    for (let k = 0; k < 3; ++k) {
      const l = (k + 1) % 3, m = (k + 2) % 3;
      n[k] = (points[q + l] - points[p + l]) * (points[r + m] - points[p + m]) -
             (points[q + m] - points[p + m]) * (points[r + l] - points[p + l]);
    }
    for (const v of [p, q, r]) {
      const sign = normals[v] * n[0] + normals[v + 1] * n[1] + normals[v + 2] * n[2] < 0 ? -1 : 1;
      for (let k = 0; k < 3; ++k)
        normals[v + k] += sign * n[k];
    }
  }
  return normals;
}

// The points once more for each piece that they are at, so that pieces can be moved apart; and the
// edges between pieces: for each two ends and a piece on one side, and the same on the other.
function split({ points, triangles, pieces }) {
  const size = points.length / 3;
  const numbers = new Map();
  const origins = [], pieceOfPoint = [];
  const corners = new Uint32Array(triangles.length);
  triangles.forEach((v, i) => {
    const piece = pieces[(i / 3) | 0];
    const key = piece * size + v;
    let number = numbers.get(key);
    if (number === undefined) {
      numbers.set(key, number = origins.length);
      origins.push(v);
      pieceOfPoint.push(piece);
    }
    corners[i] = number;
  });
  const halves = new Map(), seams = [];
  for (let i = 0; i < triangles.length; ++i) {
    const j = i % 3 === 2 ? i - 2 : i + 1;
    const [a, b] = triangles[i] < triangles[j] ? [i, j] : [j, i];
    const key = triangles[a] * size + triangles[b];
    const other = halves.get(key);
    if (other === undefined)
      halves.set(key, i);
    else if (pieces[(other / 3) | 0] !== pieces[(i / 3) | 0]) {
      const k = other % 3 === 2 ? other - 2 : other + 1;
      seams.push([corners[i], corners[j], pieces[(i / 3) | 0],
                  corners[other], corners[k], pieces[(other / 3) | 0]]);
    }
  }
  return { corners, origins, pieceOfPoint, seams };
}

export class Scene {

  // mesh: points, three numbers each; triangles, three points each; pieces, one of each triangle.
  constructor(element, { points, triangles, pieces }, numberOfPieces) {
    const { THREE } = globalThis;
    const mesh = { points: inUnitBall(points), triangles, pieces };
    this.element = element;
    this.pieces = pieces;
    Object.assign(this, split(mesh));
    const normals = pointNormals(mesh.points, mesh.triangles);
    this.input = mesh;
    const taken = from => {
      const result = new Float32Array(3 * this.origins.length);
      this.origins.forEach((v, i) => result.set(from.subarray(3 * v, 3 * v + 3), 3 * i));
      return result;
    };
    this.points = taken(mesh.points);
    this.geometry = new THREE.BufferGeometry();
    this.positions = new THREE.BufferAttribute(this.points.slice(), 3);
    this.colors = new THREE.BufferAttribute(new Float32Array(this.points.length), 3);
    this.geometry.setAttribute("position", this.positions);
    this.geometry.setAttribute("normal", new THREE.BufferAttribute(taken(normals), 3));
    this.geometry.setAttribute("color", this.colors);
    this.findCentroids(mesh, numberOfPieces);
    this.build();
  }

  // Finds the area of each piece, and its centroid times the area.
  findCentroids({ points, triangles, pieces }, numberOfPieces) {
    this.areas = new Float64Array(numberOfPieces);
    this.moments = new Float64Array(3 * numberOfPieces);
    pieces.forEach((piece, t) => {
      const [p, q, r] = [0, 1, 2].map(k => 3 * triangles[3 * t + k])
        .map(v => [points[v], points[v + 1], points[v + 2]]);
      const [a, b] = [q, r].map(x => x.map((y, k) => y - p[k]));
      const area = Math.hypot(a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                              a[0] * b[1] - a[1] * b[0]) / 2 + 1e-12;
      this.areas[piece] += area;
      for (let k = 0; k < 3; ++k)
        this.moments[3 * piece + k] += area * (p[k] + q[k] + r[k]) / 3;
    });
  }

  // For each piece how far its segment is moved.
  offsets(segmentOfPiece, explosion) {
    const sums = new Map(); // of each segment, and of all: area, moments
    segmentOfPiece.forEach((segment, piece) => {
      for (const key of [segment, "all"]) {
        const sum = sums.get(key) ?? [0, 0, 0, 0];
        sum[0] += this.areas[piece];
        for (let k = 0; k < 3; ++k)
          sum[k + 1] += this.moments[3 * piece + k];
        sums.set(key, sum);
      }
    });
    const centroid = ([area, ...moments]) => moments.map(x => area > 0 ? x / area : 0);
    const center = centroid(sums.get("all"));
    for (const [key, sum] of sums)
      sums.set(key, centroid(sum).map((x, k) => explosion * (x - center[k])));
    return segmentOfPiece.map(segment => sums.get(segment));
  }

  build() {
    const { THREE } = globalThis;
    this.renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(globalThis.devicePixelRatio || 1, 2));
    this.canvas = this.renderer.domElement;
    this.element.append(this.canvas);
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
    const light = new THREE.DirectionalLight(0xffffff, 0.62);
    light.position.set(-0.5, 0.8, 1);
    this.camera.add(light, light.target);
    light.target.position.set(0, 0, -1);
    this.scene = new THREE.Scene();
    this.scene.add(this.camera, new THREE.AmbientLight(0xffffff, 0.5));
    this.buildMaterials();
    this.mesh = new THREE.Mesh(this.geometry, this.materials.smooth);
    const seamGeometry = new THREE.BufferGeometry();
    seamGeometry.setAttribute("position", this.positions);
    this.seamLines = new THREE.LineSegments(
      seamGeometry, new THREE.LineBasicMaterial({ color: 0x101010 }));
    this.edgeLines = new THREE.Mesh(this.geometry, new THREE.MeshBasicMaterial(
      { wireframe: true, color: 0x101010, transparent: true, opacity: 0.25, depthWrite: false }));
    this.edgeLines.visible = false;
    this.group = new THREE.Group();
    this.group.add(this.mesh, this.seamLines, this.edgeLines);
    for (const part of this.group.children)
      part.frustumCulled = false;
    this.scene.add(this.group);
    this.controls = new THREE.OrbitControls(this.camera, this.canvas);
    this.controls.enableKeys = false;
    this.controls.minDistance = 0.2;
    this.controls.maxDistance = 40;
    this.controls.addEventListener("change", () => this.draw());
    this.controls.addEventListener("start", () => { this.isFitted = false; });
    this.explosion = 0;
    this.observer = new ResizeObserver(() => this.resize());
    this.observer.observe(this.element);
  }

  buildMaterials() {
    const { THREE } = globalThis;
    const common = { vertexColors: THREE.VertexColors, side: THREE.DoubleSide,
                     polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 };
    const phong = { ...common, specular: 0x151515, shininess: 25 };
    this.materials = {
      smooth: new THREE.MeshPhongMaterial(phong),
      flat: new THREE.MeshPhongMaterial({ ...phong, flatShading: true }),
      none: new THREE.MeshBasicMaterial(common)
    };
    // Triangles may have any orientation, so their normals are turned to the camera. Beside sharp
    // edges and slivers, the normals of points mean little: the triangle has its own one there.
    this.materials.smooth.extensions = { derivatives: true };
    this.materials.smooth.onBeforeCompile = shader => {
      shader.fragmentShader = shader.fragmentShader.replace(
        "#include <normal_fragment_begin>",
        `vec3 own = normalize(cross(dFdx(vViewPosition), dFdy(vViewPosition)));
         vec3 normal = normalize(vNormal);
         if (dot(normal, own) < 0.0) normal = -normal;
         normal = normalize(mix(own, normal, smoothstep(0.6, 0.9, dot(normal, own))));
         if (dot(normal, vViewPosition) < 0.0) normal = -normal;
         vec3 geometryNormal = normal;`);
    };
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.element;
    if (width === 0 || height === 0)
      return;
    this.renderer.setSize(width, height);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    if (this.isFitted)
      this.fit();
    this.draw();
  }

  // Chooses the view to begin with, and returns whether z is up in it.
  chooseView(segmentOfPiece) {
    this.views = firstViews(this.input, segmentOfPiece);
    const isZ = this.views[1].value > this.views[0].value;
    this.setUp(isZ);
    return isZ;
  }

  resetCamera() {
    const [x, y, z] = this.views[+this.isZUp].direction;
    this.controls.target.set(0, 0, 0);
    this.camera.position.set(...this.isZUp ? [x, z, -y] : [x, y, z]);
    this.controls.update();
    this.fit();
  }

  // Turns the camera around its target by two angles, and multiplies its distance.
  turn(sideways, upwards, factor) {
    const { THREE } = globalThis;
    const { target } = this.controls;
    const place = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(target));
    place.set(place.radius * factor, place.phi - upwards, place.theta + sideways).makeSafe();
    this.camera.position.setFromSpherical(place).add(target);
    this.isFitted = false;
    this.controls.update();
    this.draw();
  }

  // Moves the camera, which goes on to look in its direction, so that all points fill the stage.
  fit() {
    this.camera.updateMatrixWorld();
    this.group.updateMatrixWorld();
    const [right, top, back] = [0, 1, 2].map(k =>
      new globalThis.THREE.Vector3().setFromMatrixColumn(this.camera.matrixWorld, k));
    const toGroup = new globalThis.THREE.Matrix4().getInverse(this.group.matrixWorld);
    const [r, t, b] = [right, top, back].map(axis => axis.clone().transformDirection(toGroup));
    const slope = 0.92 * Math.tan(Math.PI / 180 * this.camera.fov / 2);
    const slopes = [slope * this.camera.aspect, slope]; // of the sides of what is seen
    const most = [-Infinity, -Infinity, -Infinity, -Infinity]; // where sides meet the plane z = 0
    const { array } = this.positions;
    for (let i = 0; i < array.length; i += 3) {
      const z = b.x * array[i] + b.y * array[i + 1] + b.z * array[i + 2];
      for (let k = 0; k < 2; ++k) {
        const axis = k === 0 ? r : t;
        const x = axis.x * array[i] + axis.y * array[i + 1] + axis.z * array[i + 2];
        most[2 * k] = Math.max(most[2 * k], x + slopes[k] * z);
        most[2 * k + 1] = Math.max(most[2 * k + 1], -x + slopes[k] * z);
      }
    }
    const distance = Math.max(...[0, 1].map(k =>
      (most[2 * k] + most[2 * k + 1]) / (2 * slopes[k])));
    this.controls.target.copy(right).multiplyScalar((most[0] - most[1]) / 2)
      .addScaledVector(top, (most[2] - most[3]) / 2);
    this.camera.position.copy(this.controls.target).addScaledVector(back, distance);
    this.controls.update();
    this.isFitted = true;
    this.draw();
  }

  // For each piece its segment, its color and whether it is shown; explosion: how far segments are
  // moved from the center, in multiples of the distance that they have from it.
  show({ segmentOfPiece, colorOfPiece, isShown, explosion }) {
    const offsetOfPiece = this.offsets(segmentOfPiece, explosion);
    this.pieceOfPoint.forEach((piece, i) => {
      for (let k = 0; k < 3; ++k) {
        this.positions.array[3 * i + k] = this.points[3 * i + k] + offsetOfPiece[piece][k];
        this.colors.array[3 * i + k] = colorOfPiece[piece][k];
      }
    });
    this.positions.needsUpdate = this.colors.needsUpdate = true;
    this.geometry.setIndex(this.index(this.corners.filter((_, i) =>
      isShown[this.pieces[(i / 3) | 0]])));
    const ends = [];
    for (const [a, b, piece, c, d, other] of this.seams)
      if (segmentOfPiece[piece] !== segmentOfPiece[other]) {
        if (isShown[piece])
          ends.push(a, b);
        if (isShown[other])
          ends.push(c, d);
      }
    this.seamLines.geometry.setIndex(this.index(Uint32Array.from(ends)));
    this.geometry.boundingSphere = null; // points have moved
    if (this.isFitted || explosion !== this.explosion)
      this.fit();
    this.explosion = explosion;
    this.draw();
  }

  index(corners) { return new globalThis.THREE.BufferAttribute(corners, 1); }

  setShading(name) {
    this.mesh.material = this.materials[name];
    this.draw();
  }

  setVisible(what, isVisible) {
    this[what].visible = isVisible;
    this.draw();
  }

  setUp(isZ) {
    this.isZUp = isZ;
    this.group.rotation.x = isZ ? -Math.PI / 2 : 0;
    this.resetCamera();
  }

  // The piece at a place of the window, or undefined.
  pick(x, y) {
    const { THREE } = globalThis;
    const box = this.canvas.getBoundingClientRect();
    const place = new THREE.Vector2(2 * (x - box.left) / box.width - 1,
                                    1 - 2 * (y - box.top) / box.height);
    const caster = new THREE.Raycaster();
    this.scene.updateMatrixWorld();
    caster.setFromCamera(place, this.camera);
    const [hit] = caster.intersectObject(this.mesh);
    return hit && this.pieceOfPoint[hit.face.a];
  }

  // Once before the next picture of the window, however often it is called.
  draw() {
    this.isWaiting ??= requestAnimationFrame(() => {
      this.isWaiting = undefined;
      this.renderer.render(this.scene, this.camera);
    });
  }

  // A PNG, for a function.
  picture(use) {
    this.renderer.render(this.scene, this.camera);
    this.canvas.toBlob(use, "image/png");
  }

  dispose() {
    cancelAnimationFrame(this.isWaiting);
    this.observer.disconnect();
    this.controls.dispose();
    this.renderer.dispose();
    this.renderer.forceContextLoss(); // a browser has few contexts, and frees them late
    this.canvas.remove();
  }
}
