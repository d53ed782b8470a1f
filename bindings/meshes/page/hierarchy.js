// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The cuts of a mesh. Nodes are sets of faces: first the roots, then the two children of each cut,
// that of smaller area first. The leaves are the pieces of the mesh.
export class Hierarchy {

  // roots: their number; cutNodes: the node of each cut; saliences: of the cuts, Infinity between
  // components; areas: of the nodes; firstTriangles: of each piece that of smallest number.
  constructor({ roots, cutNodes, saliences, areas, firstTriangles }) {
    Object.assign(this, { roots, saliences, areas, firstTriangles });
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

  // The segments of pieces in the order of their labels, which is that of their first triangles.
  order(segmentOfPiece) {
    const first = new Map();
    segmentOfPiece.forEach((node, piece) => {
      first.set(node, Math.min(first.get(node) ?? Infinity, this.firstTriangles[piece]));
    });
    return [...first.keys()].sort((a, b) => first.get(a) - first.get(b));
  }

  // Returns the pieces on the two sides of the first cut through some pieces, that of larger area
  // first, and the node of the other side; or undefined for one piece.
  split(pieces) {
    const area = side => side.reduce((sum, piece) => sum + this.areas[this.leaves[piece]], 0);
    for (let n = this.roots; pieces.length > 1; ++n) {
      const nodes = this.segmentOfPiece(n);
      const sides = [true, false].map(isFirst =>
        pieces.filter(piece => (nodes[piece] === nodes[pieces[0]]) === isFirst));
      if (sides[1].length > 0) {
        const [kept, cut] = area(sides[0]) < area(sides[1]) ? sides.reverse() : sides;
        return { kept, cut, node: nodes[cut[0]] };
      }
    }
  }
}

// The label of each node that is a segment, and the label of each face. If the pieces do
// not determine a label, `exceptions` has it: for each n {segments: Map, faces, labels}.
export function labelOfSegment(hierarchy, n, exceptions) {
  return exceptions?.[n]?.segments ??
    new Map(hierarchy.order(hierarchy.segmentOfPiece(n)).map((node, label) => [node, label]));
}

export function faceLabels(hierarchy, n, pieceOfFace, exceptions) {
  const labels = labelOfSegment(hierarchy, n, exceptions);
  const labelOfPiece = hierarchy.segmentOfPiece(n).map(node => labels.get(node));
  const result = Uint32Array.from(pieceOfFace, piece => labelOfPiece[piece]);
  exceptions?.[n]?.faces.forEach((face, i) => { result[face] = exceptions[n].labels[i]; });
  return result;
}
