#!/usr/bin/env node
// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// web.mjs PACKAGE ARRAYS_CALL RUNS MESH ...
//
// The time of the WebAssembly module in Node, whose package bindings/web/build.sh has built, beside
// that of the C++ call of arrays_call, one after the other: the median of the ratios, and the ratio
// of the first run of the module, which the engine of JavaScript compiles meanwhile.

import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";

const [packageFolder, arraysCall, runs, ...files] = process.argv.slice(2);
if (!files.length) {
  console.error("web.mjs PACKAGE ARRAYS_CALL RUNS MESH ...");
  process.exit(1);
}
const { load } = await import(path.resolve(packageFolder, "index_node.js"));

const median = numbers => numbers.sort((a, b) => a - b)[numbers.length >> 1];

function read(segmentation, file) {
  const mesh = segmentation.read(new Uint8Array(readFileSync(file)), file);
  const { points, triangles } = mesh;
  mesh.free();
  return { points, triangles };
}

function seconds(segmentation, { points, triangles }) {
  const start = performance.now();
  const mesh = segmentation.mesh(points, triangles);
  const run = segmentation.segment(mesh);
  run.labels();
  const result = (performance.now() - start) / 1000;
  run.free();
  mesh.free();
  return result;
}

const folder = mkdtempSync(path.join(tmpdir(), "web-"));
for (const file of files) {
  const segmentation = await load();
  const arrays = read(segmentation, file);
  const names = ["points", "triangles"].map(name => path.join(folder, name));
  writeFileSync(names[0], arrays.points);
  writeFileSync(names[1], arrays.triangles);
  const first = seconds(segmentation, arrays);
  const pairs = Array.from({ length: Number(runs) }, () => [
    seconds(segmentation, arrays),
    Number(execFileSync(arraysCall, names, { encoding: "utf8" }).split(/\s+/)[0])]);
  const native = median(pairs.map(pair => pair[1]));
  console.log(`${arrays.triangles.length / 3} faces: C++ ${native.toFixed(3)} s, JavaScript ` +
              `${median(pairs.map(([js, cpp]) => js / cpp)).toFixed(2)} times, ` +
              `the first ${(first / native).toFixed(2)}`);
}
rmSync(folder, { recursive: true });
