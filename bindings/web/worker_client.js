// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh segmentation in a worker of a browser, so that a page goes on. worker_client.d.ts documents
// it.

import { Client } from "./client.js";

export class SegmentationWorker extends Client {
  constructor({ wasmUrl } = {}) {
    // Bundlers find the file by this expression.
    super(() => new Worker(new URL("./worker.js", import.meta.url), { type: "module" }),
          wasmUrl && new URL(wasmUrl, location.href).href);
  }

  get placeOfWorker() {
    return `; without a bundler its address is ${import.meta.url.replace(/[^/]*$/, "worker.js")}`;
  }
}
