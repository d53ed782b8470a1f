// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh segmentation in this thread, which index.js exports for browsers and index_node.js for Node.

import createModule from "./module.js";

const writtenFormats = [".glb", ".obj", ".off", ".ply"];

// The types of options; numbers with whether they are integers.
const optionTypes = {
  method: "method", numberOfSegments: "integer", maximumNumberOfSegments: "integer",
  salienceThreshold: "number", minimumSegmentSize: "number", numberOfSmoothingIterations: "integer",
  keepComponentsSeparate: "boolean", smoothBoundaries: "boolean", progress: "function"
};

const extensionOf = name => (/\.[^./\\]*$/.exec(name)?.[0] ?? "").toLowerCase();

function checkOption(name, value) {
  const type = optionTypes[name];
  if (type === undefined)
    throw new TypeError(`there is no option ${name}`);
  const isRight = type === "method" ? value === "calibrated" || value === "paper" :
    type === "integer" ? Number.isInteger(value) && Math.abs(value) < 2 ** 31 :
    typeof value === type;
  if (!isRight)
    throw new TypeError(`${name} must be ${type === "method" ? "'calibrated' or 'paper'" :
                                           `${type === "integer" ? "an" : "a"} ${type}`}`);
}

function checkedOptions(options) {
  const given = Object.fromEntries(
    Object.entries(options).filter(([, value]) => value !== undefined));
  for (const [name, value] of Object.entries(given))
    checkOption(name, value);
  if (given.numberOfSegments !== undefined &&
      (given.maximumNumberOfSegments ?? given.salienceThreshold) !== undefined)
    throw new TypeError("numberOfSegments goes neither with maximumNumberOfSegments nor with " +
                        "salienceThreshold");
  return given;
}

function checkedTriples(name, value, types) {
  if (!types.some(type => value instanceof type))
    throw new TypeError(`${name} must be a ${types.map(type => type.name).join(" or ")}`);
  if (value.length % 3 !== 0)
    throw new TypeError(`${name} must have three numbers each, not ${value.length} in all`);
  return value;
}

// Checks that `value` is undefined or the number of segments to give.
function checkedNumber(value) {
  if (value !== undefined && !(Number.isInteger(value) && value >= 1))
    throw new TypeError("the number of segments must be an integer, at least 1");
  return value && Math.min(value, 2 ** 31); // more than fits into the module's integers is all
}

// Calls a function of the module, whose exceptions are numbers here.
function call(module, what, action) {
  const outOfMemory = () => new RangeError(`there is not enough memory ${what}`);
  try {
    return action();
  }
  catch (error) {
    if (error instanceof RangeError) // of an array
      throw outOfMemory();
    if (typeof error !== "number")
      throw error;
    const { isMemory, message } = module.errorOf(error);
    throw isMemory ? outOfMemory() : new Error(message.replace("segment_spectral_recursive: ", ""));
  }
}

class Mesh {
  #module;

  constructor(module, handle) {
    this.#module = module;
    this.handle = handle;
  }

  #get(name) {
    return call(this.#module, "for the arrays of a mesh", () => this.handle[name]());
  }

  get numberOfFaces() { return this.#get("numberOfFaces"); }
  get points() { return this.#get("points"); }
  get triangles() { return this.#get("triangles"); }
  get faceOfTriangle() { return this.#get("faceOfTriangle"); }
  free() { this.handle.delete(); }
}

class Segmentation {
  #module;
  #handle;

  constructor(module, handle) {
    this.#module = module;
    this.#handle = handle;
  }

  #call(what, action) { return call(this.#module, what, () => action(this.#handle)); }

  get numberOfSegments() { return this.#handle.numberOfSegments(); }
  get maximumNumberOfSegments() { return this.#handle.maximumNumberOfSegments(); }
  labels(n) { return this.#call("for labels", handle => handle.labels(checkedNumber(n))); }
  toJSON() { return JSON.parse(this.#call("for JSON", handle => handle.json())); }
  pageData(name = "") {
    return JSON.parse(this.#call("for a page", handle => handle.pageData(String(name))));
  }

  write(name, n) {
    const extension = extensionOf(name);
    if (!writtenFormats.includes(extension))
      throw new TypeError(`the name must end in ${writtenFormats.join(", ")}, not ${name}`);
    return this.#call("for a file", handle => handle.write(extension, checkedNumber(n)));
  }

  free() { this.#handle.delete(); }
}

class Module {
  #module;

  constructor(module) { this.#module = module; }

  get version() { return this.#module.version(); }

  read(bytes, name) {
    if (!(bytes instanceof Uint8Array))
      throw new TypeError("bytes must be a Uint8Array");
    const extension = extensionOf(name);
    return new Mesh(this.#module, call(this.#module, `for a file of ${bytes.length} bytes`, () =>
      this.#module.Mesh.read(bytes, extension)));
  }

  mesh(points, triangles) {
    checkedTriples("points", points, [Float32Array, Float64Array]);
    checkedTriples("triangles", triangles, [Uint32Array, Int32Array, Uint16Array]);
    return new Mesh(this.#module, call(this.#module, `for ${triangles.length / 3} triangles`, () =>
      this.#module.Mesh.ofArrays(points, triangles)));
  }

  segment(mesh, options = {}) {
    if (!(mesh instanceof Mesh))
      throw new TypeError("mesh must be what read() or mesh() returns");
    const { progress, ...others } = checkedOptions(options);
    let error;
    // An exception that passed through the module would leave its memory behind.
    const told = progress && (share => {
      try {
        return progress(share) !== false;
      }
      catch (e) {
        error = e ?? new Error("progress failed");
        return false;
      }
    });
    const handle = call(this.#module, `for ${mesh.numberOfFaces} faces`, () =>
      new this.#module.Segmentation(mesh.handle, others, told));
    if (error) {
      handle.delete();
      throw error;
    }
    return new Segmentation(this.#module, handle);
  }
}

// Starts an instance of the module; `settings` tell emscripten where module.wasm is.
export async function start(settings) {
  return new Module(await createModule(settings));
}
