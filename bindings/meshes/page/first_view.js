// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The view that a page begins with: the mesh stands, and much of it and of its segments is seen.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [0, 1, 2].map(k => a[(k + 1) % 3] * b[(k + 2) % 3] -
                                           a[(k + 2) % 3] * b[(k + 1) % 3]);
const length = a => Math.hypot(...a);

// Returns points at equal distances of area, {point, normal, piece} each.
function samplesOf({ points, triangles, pieces }, number) {
  const corners = t => [0, 1, 2].map(k => 3 * triangles[3 * t + k])
    .map(v => [points[v], points[v + 1], points[v + 2]]);
  const normal = ([p, q, r]) => cross(q.map((x, k) => x - p[k]), r.map((x, k) => x - p[k]));
  const areas = Float64Array.from(pieces, (_, t) => length(normal(corners(t))));
  const step = areas.reduce((sum, area) => sum + area, 0) / number;
  const result = [];
  let sum = 0;
  areas.forEach((area, t) => {
    for (sum += area; sum > step * (result.length + 0.5) && result.length < number;) {
      const i = result.length + 1; // these two irrational steps fill a square evenly
      let [a, b] = [0.7548776662 * i % 1, 0.5698402910 * i % 1];
      if (a + b > 1)
        [a, b] = [1 - a, 1 - b];
      const [p, q, r] = corners(t);
      result.push({ point: p.map((x, k) => (1 - a - b) * x + a * q[k] + b * r[k]),
                    normal: normal([p, q, r]).map(x => x / area), piece: pieces[t] });
    }
  });
  return result;
}

// Sets for each sample how much the surface bends around it, from 0 to 1: faces and fingers do.
function findBends(samples) {
  const cells = new Map();
  for (const sample of samples) {
    const key = sample.point.map(x => Math.floor(8 * x)).join();
    cells.set(key, [...cells.get(key) ?? [], sample]);
  }
  for (const cell of cells.values()) {
    const sums = [0, 1, 2].map(k => cell.reduce((sum, { normal }) => sum + normal[k], 0));
    for (const sample of cell)
      sample.bend = 1 - length(sums) / cell.length;
  }
}

// Returns whether points stand on a plane: their mean is above the lowest ones.
function stands(points, up) {
  const lowest = Math.min(...points.map(p => dot(p, up)));
  const feet = points.filter(p => dot(p, up) < lowest + 0.04);
  const mean = [0, 1, 2].map(k => points.reduce((sum, p) => sum + p[k], 0) / points.length);
  const side = [1, 0, 0], front = cross(side, up);
  return Array.from({ length: 32 }, (_, i) => Math.PI * i / 16).every(angle => {
    const direction = side.map((x, k) => Math.cos(angle) * x + Math.sin(angle) * front[k]);
    return feet.some(p => dot(p, direction) > dot(mean, direction));
  });
}

// Returns the samples that are seen in a picture, and the area that all cover.
function look(samples, direction, right, top) {
  const size = 48;
  const cell = x => Math.min(Math.floor((1 + x) / 2 * size), size - 1);
  const depths = new Float32Array(size * size).fill(-Infinity);
  const cells = samples.map(({ point }) => size * cell(dot(point, top)) + cell(dot(point, right)));
  const depth = samples.map(({ point }) => dot(point, direction));
  cells.forEach((cell, i) => { depths[cell] = Math.max(depths[cell], depth[i]); });
  return { seen: samples.filter((_, i) => depth[i] > depths[cells[i]] - 0.06),
           area: new Set(cells).size };
}

// Degrees above the horizon, and how much less of them is liked.
const elevations = [[-15, 0.15], [0, 0.03], [15, 0], [30, 0.08], [60, 0.15], [85, 0.15]];

// Returns the best view of a mesh in the unit ball with y up and that with z up: each has the
// direction to the eye, and a value.
export function firstViews(mesh, segmentOfPiece) {
  const samples = samplesOf(mesh, 2500);
  findBends(samples);
  const segmentOf = ({ piece }) => segmentOfPiece[piece];
  const counts = list => {
    const result = new Map();
    list.forEach(sample => result.set(segmentOf(sample), (result.get(segmentOf(sample)) ?? 0) + 1));
    return result;
  };
  const totals = counts(samples);
  const views = [];
  for (const up of [[0, 1, 0], [0, 0, 1]]) {
    const side = [1, 0, 0], front = cross(side, up);
    const bonus = (stands(samples.map(({ point }) => point), up) ? 0.12 : 0) + (up[1] ? 0.05 : 0);
    for (const [elevation, malus] of elevations)
      for (let azimuth = 0; azimuth < 360; azimuth += 20) {
        const [e, a] = [elevation, azimuth].map(x => Math.PI / 180 * x);
        const direction = side.map((x, k) => Math.cos(e) *
          (Math.sin(a) * x + Math.cos(a) * front[k]) + Math.sin(e) * up[k]);
        const right = side.map((x, k) => Math.cos(a) * x - Math.sin(a) * front[k]);
        const { seen, area } = look(samples, direction, right, cross(direction, right));
        let segments = 0; // one that is seen by a third counts in full
        for (const [segment, count] of counts(seen))
          segments += Math.min(1, 3 * count / totals.get(segment)) / totals.size;
        views.push({ direction, up, area, bends: seen.reduce((sum, { bend }) => sum + bend, 0),
                     value: 0.7 * segments + bonus - malus });
      }
  }
  const [mostArea, mostBends] = ["area", "bends"].map(name =>
    Math.max(...views.map(view => view[name])) || 1);
  for (const view of views)
    view.value += view.area / mostArea + 0.5 * view.bends / mostBends;
  return [1, 2].map(k => views.filter(({ up }) => up[k] === 1)
    .reduce((best, view) => view.value > best.value ? view : best));
}
