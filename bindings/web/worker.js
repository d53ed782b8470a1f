// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The worker behind worker_client.js: one mesh and its segmentation.

import { load } from "./index.js";

const isNode = typeof process === "object" && Boolean(process.versions?.node);
const port = isNode ? (await import(/* @vite-ignore */ "node:worker_threads")).parentPort
                    : globalThis;

let segmentation;

function existing() {
  if (!segmentation)
    throw new Error("the worker has no segmentation yet");
  return segmentation;
}

// Progress is told at most some twenty times a second.
function teller(id) {
  let last = -Infinity;
  return share => {
    const now = performance.now();
    if (now - last > 50) {
      last = now;
      port.postMessage({ id, share });
    }
  };
}

const actions = {
  async segment({ file, points, triangles, name, options }, id) {
    const module = await load();
    const mesh = file ? module.read(file, name) : module.mesh(points, triangles);
    segmentation?.free();
    segmentation = undefined; // if the next line throws
    segmentation = module.segment(mesh, { ...options, progress: teller(id) });
    mesh.free(); // but for what the segmentation needs of it
    return { data: segmentation.pageData(name), numberOfSegments: segmentation.numberOfSegments };
  },
  write({ name, n }) { return existing().write(name, n); },
  labels({ n }) { return existing().labels(n); },
  toJSON() { return existing().toJSON(); }
};

async function answer({ id, action, argument }) {
  try {
    const result = await actions[action](argument, id);
    port.postMessage({ id, result }, result?.buffer ? [result.buffer] : []);
  }
  catch (error) {
    const isMemory = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
    port.postMessage({ id, error: { name: isMemory ? "RangeError" : error.name,
                                    message: error.message } });
  }
}

if (isNode)
  port.on("message", answer);
else
  port.onmessage = event => answer(event.data);
port.postMessage({ isReady: true });
