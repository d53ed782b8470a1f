// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh segmentation in a worker of Node. worker_client.d.ts documents it.

import { Worker } from "node:worker_threads";

import { Client } from "./client.js";

function startWorker() {
  const worker = new Worker(new URL("./worker_node.js", import.meta.url));
  worker.on("message", data => worker.onmessage({ data }));
  worker.on("error", error => worker.onerror(error));
  return worker;
}

export class SegmentationWorker extends Client {
  constructor({ wasmUrl } = {}) { super(startWorker, wasmUrl && String(wasmUrl)); }
}
