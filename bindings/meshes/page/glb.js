// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { decoded } from "./colors.js";

// Returns the points that some triangles of a mesh have, and the triangles on these.
function part({ points, triangles, corner, unit }, indices) {
  const numbers = new Map(), coordinates = [];
  const corners = indices.flatMap(t => [0, 1, 2].map(k => triangles[3 * t + k]));
  const renumbered = corners.map(v => {
    if (!numbers.has(v)) {
      numbers.set(v, numbers.size);
      coordinates.push(...[0, 1, 2].map(k => corner[k] + unit * points[3 * v + k]));
    }
    return numbers.get(v);
  });
  return [Float32Array.from(coordinates), Uint32Array.from(renumbered)];
}

// Returns the bytes of a file of GLB. Each of `segments`, which has {segment, name, color}, is a
// node with a mesh and a material.
export function glbOf(mesh, segmentOfPiece, segments) {
  const json = { asset: { version: "2.0" }, scene: 0, scenes: [{ nodes: [] }], nodes: [],
                 meshes: [], materials: [], accessors: [], bufferViews: [], buffers: [] };
  const blocks = []; // of data
  let size = 0;
  const add = (array, accessor, target) => {
    json.accessors.push({ bufferView: blocks.length, ...accessor });
    json.bufferViews.push({ buffer: 0, byteOffset: size, byteLength: array.byteLength, target });
    blocks.push(array);
    size += array.byteLength;
    return blocks.length - 1;
  };
  const triangles = new Map(segments.map(({ segment }) => [segment, []]));
  mesh.pieces.forEach((piece, t) => triangles.get(segmentOfPiece[piece])?.push(t));
  for (const { segment, name, color } of segments) {
    const [points, corners] = part(mesh, triangles.get(segment));
    if (corners.length === 0)
      continue;
    const ends = better => [0, 1, 2].map(k =>
      points.reduce((end, x, i) => i % 3 === k && better(x, end) ? x : end, points[k]));
    const i = json.nodes.length;
    const position = add(points, { componentType: 5126, type: "VEC3", count: points.length / 3,
                                   min: ends((x, y) => x < y), max: ends((x, y) => x > y) }, 34962);
    const indices = add(corners, { componentType: 5125, type: "SCALAR", count: corners.length },
                        34963);
    json.scenes[0].nodes.push(i);
    json.nodes.push({ name, mesh: i });
    json.meshes.push({ name, primitives: [{ attributes: { POSITION: position }, indices,
                                            material: i }] });
    json.materials.push({ name, doubleSided: true, pbrMetallicRoughness: {
      baseColorFactor: [...color.map(decoded), 1], metallicFactor: 0, roughnessFactor: 0.9 } });
  }
  json.buffers.push({ byteLength: size });
  const text = new TextEncoder().encode(JSON.stringify(json));
  const padding = new Uint8Array(-text.length & 3).fill(32);
  const length = text.length + padding.length;
  return new Blob([Uint32Array.of(0x46546c67, 2, 28 + length + size, length, 0x4e4f534a),
                   text, padding, Uint32Array.of(size, 0x004e4942), ...blocks],
                  { type: "model/gltf-binary" });
}
