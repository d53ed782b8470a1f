// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The side of the caller of a segmentation in a worker, without the parts that differ between
// browsers and Node.

import { decode } from "./decode.js";

const errorTypes = { TypeError, RangeError };

export class Client {
  #startWorker;
  #wasmUrl;
  #worker;
  #ready;
  #requests = new Map();
  #numberOfRequests = 0;
  #isClosed = false;

  // `startWorker` returns a worker with the functions of one of a browser.
  constructor(startWorker, wasmUrl) {
    this.#startWorker = startWorker;
    this.#wasmUrl = wasmUrl;
  }

  #start() {
    const worker = this.#worker = this.#startWorker();
    return new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => data.isReady ? resolve() : this.#receive(data);
      worker.onerror = error => {
        error.preventDefault?.();
        const failure = new Error(error.message ? `the worker failed: ${error.message}` :
                                  `the worker cannot be loaded${this.placeOfWorker}`);
        reject(failure);
        this.#end(failure);
      };
    });
  }

  #receive({ id, fraction, result, error }) {
    const request = this.#requests.get(id);
    if (fraction !== undefined) {
      request?.progress?.(fraction);
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
      this.#ready ??= this.#start();
      this.#ready.then(() => this.#worker.postMessage({ id, action, argument }))
        .catch(error => { // also of what cannot be sent, such as functions
          this.#requests.delete(id);
          reject(error);
        });
    });
  }

  async segment({ bytes, points, triangles, name = "mesh" }, options = {}, progress = undefined) {
    if (options?.progress !== undefined)
      throw new TypeError("progress is the third argument of segment(), not an option");
    const { data, numberOfSegments, warnings } = await this.#request(
      "segment", { file: bytes, points, triangles, name, options, wasmUrl: this.#wasmUrl },
      progress);
    return { model: decode(data), numberOfSegments, warnings };
  }

  write(name, choice) { return this.#request("write", { name, choice }); }
  labels(choice) { return this.#request("labels", { choice }); }
  toJSON() { return this.#request("toJSON", {}); }
  close() { this.#end(new DOMException("the worker is closed", "AbortError")); }
}
