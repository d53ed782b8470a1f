// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The actions of a worker, which has one mesh and its segmentation.

// Returns a function that carries out the requests of client.js. It sends its answers by `send`.
export function answerer(load, send) {
  let segmentation;

  function existing() {
    if (!segmentation)
      throw new Error("the worker has no segmentation yet");
    return segmentation;
  }

  // Returns a function that sends the progress, some twenty times a second at most.
  function progressReporter(id) {
    let last = -Infinity;
    return fraction => {
      const now = performance.now();
      if (now - last > 50) {
        last = now;
        send({ id, fraction });
      }
    };
  }

  const actions = {
    async segment({ file, points, triangles, name, options, wasmUrl }, id) {
      const module = await load({ wasmUrl });
      const mesh = file ? module.read(file, name) : module.mesh(points, triangles);
      const next = module.segment(
        mesh, options instanceof Object ? { ...options, progress: progressReporter(id) } : options);
      const { warnings } = mesh;
      mesh.free(); // except the data that the segmentation needs
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
