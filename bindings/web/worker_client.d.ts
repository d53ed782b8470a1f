// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import type { Choice, LoadOptions, Options } from "./index.js";

/** A file, or a mesh as arrays as for `Module.mesh()`. */
export type Input = { name: string; bytes: Uint8Array } |
  { name?: string; points: Float32Array | Float64Array;
    triangles: Uint32Array | Int32Array | Uint16Array };

/** The model that the class Viewer of viewer.js shows. `faceLabels()` of hierarchy.js returns its
 *  labels for any number of segments. */
export interface Model {
  name: string;
  segments: number;
  hierarchy: object;
  [other: string]: unknown;
}

/** The segmentation of one mesh in a worker. The memory is given back by `close()`, before which a
 *  program in Node does not end. */
export class SegmentationWorker {
  /** The worker starts with the first call below. */
  constructor(options?: LoadOptions);
  /** `progress` receives the fraction of the run that is done. If the promise is rejected, the
   *  former segmentation stays. The warnings are the same as in `Mesh`. */
  segment(input: Input, options?: Options, progress?: (fraction: number) => void):
    Promise<{ model: Model; numberOfSegments: number; warnings: readonly string[] }>;
  /** These do the same as in `Segmentation`, for the last mesh. Without one, the promise is
   *  rejected with an Error. */
  write(name: string, n?: number | Choice): Promise<Uint8Array>;
  labels(n?: number | Choice): Promise<Uint32Array>;
  toJSON(): Promise<object>;
  /** Ends the worker, at once. Promises that are not settled are rejected with a DOMException
   *  "AbortError". */
  close(): void;
}
