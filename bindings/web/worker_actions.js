// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a worker does: it has one mesh and its segmentation.

// Returns a function that does what a message of client.js asks. It sends its answers by `send`.
export function answerer(load, send) {
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
        send({ id, share });
      }
    };
  }

  const actions = {
    async segment({ file, points, triangles, name, options, wasmUrl }, id) {
      const module = await load({ wasmUrl });
      const mesh = file ? module.read(file, name) : module.mesh(points, triangles);
      const next = module.segment(
        mesh, options instanceof Object ? { ...options, progress: teller(id) } : options);
      const { warnings } = mesh;
      mesh.free(); // but for what the segmentation needs of it
      segmentation = next; // the instance of the former one goes with it
      return { data: segmentation.pageData(name), warnings,
               numberOfSegments: segmentation.numberOfSegments };
    },
    write({ name, choice }) { return existing().write(name, choice); },
    labels({ choice }) { return existing().labels(choice); },
    toJSON() { return existing().toJSON(); }
  };

  send({ isReady: true });
  return async ({ id, action, argument }) => {
    try {
      const result = await actions[action](argument, id);
      send({ id, result }, result?.buffer ? [result.buffer] : []);
    }
    catch (error) {
      const isMemory = error instanceof WebAssembly.RuntimeError || error instanceof RangeError;
      send({ id, error: { name: isMemory ? "RangeError" : error.name, message: error.message } });
    }
  };
}
