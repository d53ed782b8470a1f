// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The view that a page begins with: the mesh stands, and much of it and of its segments is seen.

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [0, 1, 2].map(k => a[(k + 1) % 3] * b[(k + 2) % 3] -
                                           a[(k + 2) % 3] * b[(k + 1) % 3]);
const length = a => Math.hypot(...a);

// Returns points [x, y, z, piece], as many in each triangle as its weight asks for.
function samplePoints({ points, triangles, pieces }, weights, number) {
  const step = weights.reduce((sum, weight) => sum + weight, 0) / number;
  const result = [];
  let sum = 0;
  weights.forEach((weight, t) => {
    for (sum += weight; sum > step * (result.length + 0.5) && result.length < number;) {
      const i = result.length + 1; // these two irrational steps fill a square evenly
      let [a, b] = [0.7548776662 * i % 1, 0.5698402910 * i % 1];
      if (a + b > 1)
        [a, b] = [1 - a, 1 - b];
      const [p, q, r] = triangles.subarray(3 * t, 3 * t + 3).map(v => 3 * v);
      result.push([0, 1, 2].map(k => (1 - a - b) * points[p + k] + a * points[q + k] +
                                     b * points[r + k]));
      result[i - 1].push(pieces[t]);
    }
  });
  return result;
}

// Returns samples of the surface, and behind them as many where it bends.
function samplesOf(mesh, number) {
  const { points, triangles, pieces, normals } = mesh;
  const at = (array, v) => [array[3 * v], array[3 * v + 1], array[3 * v + 2]];
  const areas = new Float64Array(pieces.length), bends = new Float64Array(pieces.length);
  pieces.forEach((_, t) => {
    const corners = [0, 1, 2].map(k => triangles[3 * t + k]);
    const [p, q, r] = corners.map(v => at(points, v));
    areas[t] = length(cross(q.map((x, k) => x - p[k]), r.map((x, k) => x - p[k])));
    const units = corners.map(v => at(normals, v)).map(n => n.map(x => x / (length(n) || 1)));
    const mean = units[0].map((x, k) => (x + units[1][k] + units[2][k]) / 3);
    bends[t] = Math.max(1 - length(mean), 0);
  });
  return [areas, bends].flatMap(weights => samplePoints(mesh, weights, number));
}

// Returns whether samples stand on a plane: their mean is above the lowest ones.
function stands(samples, up) {
  const lowest = Math.min(...samples.map(p => dot(p, up)));
  const feet = samples.filter(p => dot(p, up) < lowest + 0.04);
  const mean = [0, 1, 2].map(k => samples.reduce((sum, p) => sum + p[k], 0) / samples.length);
  const side = [1, 0, 0], front = cross(side, up);
  return Array.from({ length: 32 }, (_, i) => Math.PI * i / 16).every(angle => {
    const direction = side.map((x, k) => Math.cos(angle) * x + Math.sin(angle) * front[k]);
    return feet.some(p => dot(p, direction) > dot(mean, direction));
  });
}

// Returns which samples are seen in a picture, and the area that they cover.
function look(samples, direction, right, top) {
  const size = 48;
  const cell = x => Math.min(Math.floor((1 + x) / 2 * size), size - 1);
  const depths = new Float32Array(size * size).fill(-Infinity);
  const cells = samples.map(p => size * cell(dot(p, top)) + cell(dot(p, right)));
  const depth = samples.map(p => dot(p, direction));
  cells.forEach((cell, i) => { depths[cell] = Math.max(depths[cell], depth[i]); });
  return { isSeen: cells.map((cell, i) => depth[i] > depths[cell] - 0.06),
           area: new Set(cells).size };
}

// Degrees above the horizon, and how much less of them is liked.
const elevations = [[-15, 0.15], [0, 0.03], [15, 0], [30, 0.05], [60, 0.15], [85, 0.15]];

// Returns the best view of a mesh in the unit ball with y up and that with z up: each has the
// direction to the eye, and a value.
export function firstViews(mesh, segmentOfPiece) {
  const number = 1500;
  const samples = samplesOf(mesh, number);
  const totals = new Map();
  for (const p of samples) {
    p[3] = segmentOfPiece[p[3]];
    totals.set(p[3], (totals.get(p[3]) ?? 0) + 1);
  }
  const views = [];
  for (const up of [[0, 1, 0], [0, 0, 1]]) {
    const side = [1, 0, 0], front = cross(side, up);
    const bonus = (stands(samples.slice(0, number), up) ? 0.12 : 0) + (up[1] ? 0.05 : 0);
    for (const [elevation, malus] of elevations)
      for (let azimuth = 0; azimuth < 360; azimuth += 20) {
        const [e, a] = [elevation, azimuth].map(x => Math.PI / 180 * x);
        const direction = side.map((x, k) => Math.cos(e) *
          (Math.sin(a) * x + Math.cos(a) * front[k]) + Math.sin(e) * up[k]);
        const right = side.map((x, k) => Math.cos(a) * x - Math.sin(a) * front[k]);
        const { isSeen, area } = look(samples, direction, right, cross(direction, right));
        const counts = new Map();
        let details = 0;
        isSeen.forEach((isSeen, i) => {
          if (!isSeen)
            return;
          counts.set(samples[i][3], (counts.get(samples[i][3]) ?? 0) + 1);
          details += i >= number;
        });
        let segments = 0; // one that is seen by a third counts in full
        for (const [segment, count] of counts)
          segments += Math.min(1, 3 * count / totals.get(segment)) / totals.size;
        views.push({ direction, up, area, details, value: 0.7 * segments + bonus - malus });
      }
  }
  const [mostArea, mostDetails] = ["area", "details"].map(name =>
    Math.max(1, ...views.map(view => view[name])));
  for (const view of views)
    view.value += view.area / mostArea + 0.7 * view.details / mostDetails;
  return [1, 2].map(k => views.filter(({ up }) => up[k] === 1)
    .reduce((best, view) => view.value > best.value ? view : best));
}
