// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The integers of packed.h.
function integers(text) {
  const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
  const result = [];
  let value = 0, weight = 1;
  for (const byte of bytes) {
    value += (byte & 127) * weight; // not by shifts, which have 32 bits
    weight *= 128;
    if (byte < 128) {
      result.push(value % 2 === 1 ? -(value + 1) / 2 : value / 2);
      value = 0;
      weight = 1;
    }
  }
  return result;
}

function sums(text, stride) {
  const result = integers(text);
  for (let i = stride; i < result.length; ++i)
    result[i] += result[i - stride];
  return result;
}

function runs(text) {
  const values = integers(text);
  let length = 0;
  for (let i = 1; i < values.length; i += 2)
    length += values[i];
  const result = new Uint32Array(length);
  for (let i = 0, begin = 0; i < values.length; begin += values[i + 1], i += 2)
    result.fill(values[i], begin, begin + values[i + 1]);
  return result;
}

function pairs(list) {
  const result = new Map();
  for (let i = 0; i < list.length; i += 2)
    result.set(list[i], list[i + 1]);
  return result;
}

// The model of a Viewer from what page_data.h writes.
export function decode({ name, segments, salience, input_triangles, hierarchy, mesh, piece_of_face,
                         exceptions }) {
  const pieces = runs(mesh.pieces);
  const numberShown = pieces.length;
  const notes = numberShown >= input_triangles ? [] :
    [`The mesh shown is simplified to ${numberShown.toLocaleString("en")} triangles; labels are ` +
     "those of all faces."];
  return {
    name, segments, salience, notes, pieceOfFace: runs(piece_of_face),
    mesh: { points: Float32Array.from(sums(mesh.points, 3)),
            triangles: Uint32Array.from(sums(mesh.triangles, 1)), pieces,
            corner: mesh.corner, unit: mesh.unit },
    hierarchy: { roots: hierarchy.roots, cutNodes: hierarchy.cut_nodes,
                 saliences: hierarchy.saliences.map(x => x ?? Infinity), areas: hierarchy.areas,
                 firstTriangles: hierarchy.first_triangles },
    exceptions: Object.fromEntries(Object.entries(exceptions).map(([n, e]) =>
      [n, { segments: pairs(e.segments), faces: sums(e.faces, 1), labels: runs(e.labels) }]))
  };
}
