// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/** The parameters of a run; those of the C++ library, whose manual tells more. */
export interface Options {
  /** "calibrated", the default, cuts where people cut; "paper" is Zhang and Liu 2005. */
  method?: "calibrated" | "paper";
  /** Exactly this number, whatever the saliences are; not together with the next two. */
  numberOfSegments?: number;
  /** At most this number. */
  maximumNumberOfSegments?: number;
  /** The smallest salience of a cut: 0.48 by default, 0.54 with the method "paper". */
  salienceThreshold?: number;
  /** The least share of the area for each side of a cut, from 0 to 0.5. */
  minimumSegmentSize?: number;
  /** Steps of Laplacian smoothing before the search; 0 by default. */
  numberOfSmoothingIterations?: number;
  /** Whether each connected component is a part from the start. */
  keepComponentsSeparate?: boolean;
  /** Whether boundaries of segments are smoothed; false by default. */
  smoothBoundaries?: boolean;
}

export interface RunOptions extends Options {
  /** Is told the share of the run that is done. If it returns false, the run ends with the cuts
   *  made so far. If it throws, the run ends with that. */
  progress?: (share: number) => boolean | void;
}

/** A mesh in the memory of the module, which keeps it until `free()`. */
export interface Mesh {
  /** Of the file, polygons being single faces; else the number of triangles. */
  readonly numberOfFaces: number;
  /** Copies: three coordinates a point, */
  readonly points: Float64Array;
  /** three indices of points a triangle, */
  readonly triangles: Uint32Array;
  /** and the face that each triangle belongs to. */
  readonly faceOfTriangle: Uint32Array;
  free(): void;
}

/** A run, in the memory of the module, which keeps it until `free()`. */
export interface Segmentation {
  readonly numberOfSegments: number;
  /** The most that can be asked for below. */
  readonly maximumNumberOfSegments: number;
  /** The label of each face: of the run, or of exactly `n` segments, or as near to `n` as there
   *  are components and cuts. The same labels as those of the C++ library and its tool. */
  labels(n?: number): Uint32Array;
  /** A colored mesh in the format that the name tells: .ply, .glb, .off or .obj. Its faces are
   *  split along smooth boundaries between the segments. */
  write(name: string, n?: number): Uint8Array;
  /** All cuts, as `segment_mesh --hierarchy` writes them. */
  toJSON(): object;
  /** What `decode()` of decode.js makes the model of a Viewer of. */
  pageData(name?: string): object;
  free(): void;
}

export interface Module {
  readonly version: string;
  /** Reads OFF, OBJ, PLY or STL, as the name tells. Throws an Error with the line or byte at fault
   *  if the bytes contradict the format. */
  read(bytes: Uint8Array, name: string): Mesh;
  /** A mesh of three coordinates a point and three indices a triangle. */
  mesh(points: Float32Array | Float64Array,
       triangles: Uint32Array | Int32Array | Uint16Array): Mesh;
  /** Throws a TypeError for an argument of a wrong type, a RangeError if memory is out, an Error
   *  for what the library refuses. */
  segment(mesh: Mesh, options?: RunOptions): Segmentation;
}

export interface LoadOptions {
  /** Where module.wasm is, by default beside the module. In Node, a URL of a file. */
  wasmUrl?: string | URL;
}

/** A new instance of the module, with a memory of its own. Works in browsers and in Node. */
export function load(options?: LoadOptions): Promise<Module>;
