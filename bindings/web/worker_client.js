// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh segmentation in a worker, so that a page goes on. index.d.ts documents it.

import { decode } from "./decode.js";

const isNode = typeof process === "object" && Boolean(process.versions?.node);

async function startWorker() {
  const url = new URL("./worker.js", import.meta.url);
  if (!isNode)
    return new Worker(url, { type: "module" });
  const { Worker: NodeWorker } = await import(/* @vite-ignore */ "node:worker_threads");
  const worker = new NodeWorker(url);
  worker.on("message", data => worker.onmessage({ data }));
  worker.on("error", error => worker.onerror(error));
  return worker;
}

const errorTypes = { TypeError, RangeError };

export class SegmentationWorker {
  #started;
  #worker;
  #requests = new Map();
  #numberOfRequests = 0;
  #isClosed = false;

  async #start() {
    const worker = await startWorker();
    if (this.#isClosed)
      return worker.terminate();
    this.#worker = worker;
    await new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => data.isReady ? resolve() : this.#receive(data);
      worker.onerror = error => {
        error.preventDefault?.();
        const failure = new Error(`the worker failed: ${error.message}`);
        reject(failure);
        this.#end(failure);
      };
    });
  }

  #receive({ id, share, result, error }) {
    const request = this.#requests.get(id);
    if (share !== undefined) {
      request?.progress?.(share);
      return;
    }
    this.#requests.delete(id);
    if (error)
      request?.reject(new (errorTypes[error.name] ?? Error)(error.message));
    else
      request?.resolve(result);
  }

  #end(error) {
    this.#isClosed = true;
    this.#worker?.terminate();
    for (const { reject } of this.#requests.values())
      reject(error);
    this.#requests.clear();
  }

  #request(action, argument, progress) {
    const closed = new DOMException("the worker is closed", "AbortError");
    return new Promise((resolve, reject) => {
      if (this.#isClosed) {
        reject(closed);
        return;
      }
      const id = ++this.#numberOfRequests;
      this.#requests.set(id, { resolve, reject, progress });
      this.#started ??= this.#start();
      this.#started.then(() => this.#worker?.postMessage({ id, action, argument }))
        .catch(error => { // also of what cannot be sent, such as functions
          this.#requests.delete(id);
          reject(error);
        });
    });
  }

  async segment({ bytes, points, triangles, name = "mesh" }, options = {}, progress = undefined) {
    const { data, numberOfSegments } = await this.#request(
      "segment", { file: bytes, points, triangles, name, options }, progress);
    return { model: decode(data), numberOfSegments };
  }

  write(name, n) { return this.#request("write", { name, n }); }
  labels(n) { return this.#request("labels", { n }); }
  toJSON() { return this.#request("toJSON", {}); }
  close() { this.#end(new DOMException("the worker is closed", "AbortError")); }
}
