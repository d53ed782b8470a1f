// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Calls that the types allow and forbid; only compiled, beside the folder of the package.

import { load, Mesh, Segmentation } from "./package/index.js";
import { SegmentationWorker } from "./package/worker_client.js";

export async function allowed(bytes: Uint8Array): Promise<Uint32Array[]> {
  const module = await load();
  const mesh: Mesh = module.read(bytes, "elephant.off");
  const run: Segmentation = module.segment(mesh, {
    method: "paper", maximumNumberOfSegments: 5, salienceThreshold: 0.3,
    progress: fraction => fraction < 0.5 });
  const sameMesh = module.mesh(mesh.points, mesh.triangles);
  const worker = new SegmentationWorker();
  const { model, warnings } = await worker.segment(
    { bytes, name: "elephant.off" }, { numberOfSegments: 5 }, fraction => console.log(fraction));
  const messages: readonly string[] = [...mesh.warnings, ...warnings];
  console.log(messages.join("\n"));
  const labels = await worker.labels(model.segments);
  worker.close();
  const constrained = module.segment(mesh, {
    faceSeeds: new Int32Array(mesh.numberOfFaces), constrainedEdges: [0, 1],
    uncuttableEdges: mesh.triangles, distanceWeights: [0.1, 1, 0.2], randomSeed: 1 });
  constrained.labels({ salienceThreshold: 0.6, maximumNumberOfSegments: 3 });
  return [labels, run.labels(), module.segment(sameMesh).labels(5)];
}

export async function forbidden(mesh: Mesh): Promise<void> {
  const module = await load();
  // @ts-expect-error: there is no such option
  module.segment(mesh, { segments: 5 });
  // @ts-expect-error: a choice has no method
  module.segment(mesh).labels({ method: "paper" });
  // @ts-expect-error: there is no such method
  module.segment(mesh, { method: "zhang_liu_2005" });
  // @ts-expect-error: arrays of numbers
  module.mesh([0, 0, 0], [0, 0, 0]);
  // @ts-expect-error: progress is an argument of its own
  await new SegmentationWorker().segment({ bytes: new Uint8Array(), name: "" }, { progress() {} });
}
