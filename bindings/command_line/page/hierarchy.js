// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The cuts of a mesh. Nodes are sets of faces: first the roots, then the two children of each cut,
// that of smaller area first. The leaves are the pieces of the mesh.
export class Hierarchy {

  // roots: their number; cutNodes: the node of each cut; saliences: of the cuts, Infinity between
  // components; areas, classes: of the nodes, copies have one class; firstTriangles: of each piece
  // that of smallest number.
  constructor({ roots, cutNodes, saliences, areas, classes, firstTriangles }) {
    Object.assign(this, { roots, saliences, areas, classes, firstTriangles });
    this.size = roots + 2 * cutNodes.length;
    this.most = roots + cutNodes.length; // segments
    this.parents = new Int32Array(this.size).fill(-1);
    const isLeaf = new Uint8Array(this.size).fill(1);
    this.cutNodes = cutNodes;
    cutNodes.forEach((node, i) => {
      isLeaf[node] = 0;
      this.parents[roots + 2 * i] = this.parents[roots + 2 * i + 1] = node;
    });
    this.leaves = [...isLeaf.keys()].filter(node => isLeaf[node]);
  }

  // The node that each piece belongs to if there are n segments.
  segmentOfPiece(n) {
    const end = 2 * n - this.roots;
    return this.leaves.map(node => {
      while (node >= end)
        node = this.parents[node];
      return node;
    });
  }

  // The nodes of n segments in the order of their labels, which is that of their first triangles.
  segments(n) {
    const first = new Map();
    this.segmentOfPiece(n).forEach((node, piece) => {
      first.set(node, Math.min(first.get(node) ?? Infinity, this.firstTriangles[piece]));
    });
    return [...first.keys()].sort((a, b) => first.get(a) - first.get(b));
  }

  // The salience of the cut that makes n segments of one fewer.
  salience(n) { return this.saliences[n - this.roots - 1]; }
}

// The label of each node that is a segment, and the label of each face. Where pieces do not tell a
// label, `exceptions` has it: for each n {segments: Map, faces, labels}.
export function labelOfSegment(hierarchy, n, exceptions) {
  return exceptions?.[n]?.segments ??
    new Map(hierarchy.segments(n).map((node, label) => [node, label]));
}

export function faceLabels(hierarchy, n, pieceOfFace, exceptions) {
  const labels = labelOfSegment(hierarchy, n, exceptions);
  const labelOfPiece = hierarchy.segmentOfPiece(n).map(node => labels.get(node));
  const result = Uint32Array.from(pieceOfFace, piece => labelOfPiece[piece]);
  exceptions?.[n]?.faces.forEach((face, i) => { result[face] = exceptions[n].labels[i]; });
  return result;
}
