// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/** Which segments are given. */
export interface Choice {
  /** Exactly this number, whatever the saliences are; not together with the next two. */
  numberOfSegments?: number;
  /** At most this number. By default there is no limit, but with the method "paper" 12 for a
   *  connected mesh, unless a salienceThreshold is given. */
  maximumNumberOfSegments?: number;
  /** The smallest salience of a cut: by default 0.4, the probability that people cut there, from 0
   *  to 1 or infinite; or 0.54 for weighted saliences, such as with the method "paper". */
  salienceThreshold?: number;
}

export type Integers = Int32Array | Uint32Array | Uint16Array | Int16Array | Uint8Array |
  Int8Array | readonly number[];

/** The parameters of a run. The manual of the C++ library has more about each of them. */
export interface Options extends Choice {
  /** "calibrated", the default, cuts where people cut; "paper" is Zhang and Liu 2005. */
  method?: "calibrated" | "paper";
  /** The smallest area of a segment, as a fraction of the area of the mesh, from 0 to 0.5: by
   *  default 0.003, with the method "paper" 0.005. */
  minimumSegmentSize?: number;
  /** Edges that must be between segments, each given by the indices of its two points. The
   *  constraints, which are this and the next two, do not go with the method "paper". */
  constrainedEdges?: Integers;
  /** Edges whose triangles must belong to one segment, given like `constrainedEdges`. */
  uncuttableEdges?: Integers;
  /** A number for each face. Faces with the same number belong to one segment, and faces with
   *  different numbers to different segments. Negative numbers mean nothing. */
  faceSeeds?: Integers;
  /** The group of each face, such as an object of a file. Groups are kept apart like connected
   *  components. */
  faceGroups?: Integers;
  /** The features of each face beyond the shape: the vectors of all faces one after the other,
   *  each of the same length; or one whole number a face, a label that may be wrong (not as a
   *  `Float32Array` or `Float64Array`). Not with the method "paper". */
  features?: Integers | Float32Array | Float64Array;
  /** How much the features count against the shape, from 0 to 1: by default 0.5. */
  featureWeight?: number;
  /** Whether each connected component is a part from the start: by default false, with the method
   *  "paper" true. */
  keepComponentsSeparate?: boolean;
  /** The weights of size, cut strength and protrusiveness in a weighted salience: three numbers,
   *  not negative, with sum 1. */
  salienceWeights?: readonly number[] | Float64Array;
  /** The weight of the geodesic distance, from 0 to 1, and the factors of the angle distance at
   *  concave and at convex edges: by default 0.03, 1, 0.1, with the method "paper" 0.01, 1, 0.1. */
  distanceWeights?: readonly number[] | Float64Array;
  /** Cuts are searched on a coarse mesh with this number of triangles: by default 3400. 0 means the
   *  mesh itself, the default of the method "paper". */
  numberOfCoarseFaces?: number;
  /** The number of coarse meshes that are searched, from 1 to 100: by default 5; 1 with the method
   *  "paper". The cuts are those of the search that agrees best with the others. */
  numberOfSearches?: number;
  /** The dimension of the context vector, from 1 to 1000: by default 3, with the method "paper" 10.
   */
  numberOfReferenceFaces?: number;
  /** Steps of Laplacian smoothing before the search; 0 by default. */
  numberOfSmoothingIterations?: number;
  /** Chooses reference faces at random, as in the paper: an integer from 0 to 2^53 - 1. */
  randomSeed?: number;
}

export interface RunOptions extends Options {
  /** Receives the fraction of the run that is done. If it returns false, the run ends with the
   *  cuts made so far. If it throws, the run throws the same. */
  progress?: (fraction: number) => boolean | void;
}

/** A mesh in the memory of the module. `free()` gives the memory back at once, a second call does
 *  nothing, and any other use of a freed mesh throws an Error. Without `free()` the memory is given
 *  back some time after the last use. */
export interface Mesh {
  /** The number of faces in the file, where a polygon is one face; else of triangles. */
  readonly numberOfFaces: number;
  /** Copies: three coordinates a point, */
  readonly points: Float64Array;
  /** three indices of points a triangle, */
  readonly triangles: Uint32Array;
  /** and the face that each triangle belongs to. */
  readonly faceOfTriangle: Uint32Array;
  /** Messages about what `read()` left out of the file or found missing, such as "line 5: 'vw' is
   *  not a statement of OBJ". `read()` and `mesh()` leave out corners at points that are not
   *  finite. A face with fewer than three others has no triangle, and the label of a neighbor. */
  readonly warnings: readonly string[];
  free(): void;
}

/** A run, in the memory of the module; `free()` does the same as `Mesh.free()`. */
export interface Segmentation {
  readonly numberOfSegments: number;
  /** The most that can be asked for below. */
  readonly maximumNumberOfSegments: number;
  /** The label of each face: of the run, of `n` segments, or of another choice. There are more
   *  than `n` segments if there are more components. Throws if `n` is larger than
   *  `maximumNumberOfSegments`; a run with `{ numberOfSegments: n }` makes exactly `n`. The C++
   *  library and its tool give the same labels. */
  labels(n?: number | Choice): Uint32Array;
  /** Returns a colored mesh, in the format of the ending of the name: .ply, .glb, .off or .obj. Its
   *  faces are split along smooth boundaries between the segments. */
  write(name: string, n?: number | Choice): Uint8Array;
  /** All cuts, as `segment_mesh --hierarchy` writes them. */
  toJSON(): object;
  /** Returns the data from which `decode()` of decode.js makes the model of a Viewer. */
  pageData(name?: string): object;
  free(): void;
}

export interface Module {
  readonly version: string;
  /** Reads OFF, OBJ, PLY or STL, by the ending of the name. Throws an Error with the line or byte
   *  at fault if the bytes contradict the format. */
  read(bytes: Uint8Array, name: string): Mesh;
  /** A mesh of three coordinates a point and three indices a triangle. Throws an Error if an index
   *  belongs to no point, or no triangle has three finite points. */
  mesh(points: Float32Array | Float64Array,
       triangles: Uint32Array | Int32Array | Uint16Array): Mesh;
  /** Throws a TypeError for an argument of a wrong type, a RangeError if memory is out, an Error
   *  for what the library refuses. */
  segment(mesh: Mesh, options?: RunOptions): Segmentation;
}

export interface LoadOptions {
  /** The place of module.wasm, by default beside the module. In Node, a URL of a file. */
  wasmUrl?: string | URL;
}

/** A new instance of the module, with a memory of its own. Works in browsers and in Node. */
export function load(options?: LoadOptions): Promise<Module>;
