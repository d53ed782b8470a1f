// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh segmentation in this thread, which index.js exports for browsers and index_node.js for Node.

import createModule from "./module.js";

const writtenFormats = [".glb", ".obj", ".off", ".ply"];

const isList = value =>
  Array.isArray(value) || ArrayBuffer.isView(value) && !(value instanceof DataView);
const clamped = integer => Math.max(-(2 ** 31), Math.min(integer, 2 ** 31 - 1)); // for the module
const isNumber = value => typeof value === "number";

// The kinds of options, and the requirement on a value of each.
const kinds = {
  method: [value => value === "calibrated" || value === "paper", "'calibrated' or 'paper'"],
  integer: [Number.isInteger, "an integer"],
  number: [isNumber, "a number"],
  boolean: [value => typeof value === "boolean", "a boolean"],
  function: [value => typeof value === "function", "a function"],
  seed: [value => Number.isSafeInteger(value) && value >= 0, "an integer, not negative"],
  weights: [value => isList(value) && value.length === 3 && value.every(isNumber),
            "three numbers"],
  numbers: [value => isList(value) && value.length > 0 && value.every(isNumber),
            "an array of numbers"],
  integers: [value => isList(value) && value.every(each => each === (each | 0)),
             "an array of integers of 32 bits"]
};

const choiceKinds = {
  numberOfSegments: "integer", maximumNumberOfSegments: "integer", salienceThreshold: "number"
};

// The module adds the options that are a number or a boolean.
const optionKinds = {
  method: "method", salienceWeights: "weights", distanceWeights: "weights", randomSeed: "seed",
  faceGroups: "integers", faceSeeds: "integers", features: "numbers",
  constrainedEdges: "integers", uncuttableEdges: "integers", progress: "function"
};

// The names of other options in messages of the library.
const optionOfName = {
  edge_is_constrained_map: "constrainedEdges", edge_is_uncuttable_map: "uncuttableEdges",
  face_seed_map: "faceSeeds", face_group_map: "faceGroups",
  face_feature_map: "features",
  "zhang_liu_2005()": "the method 'paper'"
};

function translatedName(name) {
  const option = name.replace(/_[a-z]/g, letter => letter[1].toUpperCase());
  return optionOfName[name] ?? (Object.hasOwn(optionKinds, option) ? option : name);
}

const translated = message => message
  .replace(/^(segment_spectral_recursive|Segmentation_hierarchy): /, "")
  .replace(/, which is read only from a file with .*/,
           ", which is not read here: save the mesh as PLY")
  .replace(/[a-z]+(_[a-z0-9]+)+(\(\))?/g, translatedName);

const extensionOf = name => (/\.[^./\\]*$/.exec(name)?.[0] ?? "").toLowerCase();

function checkedOptions(options, kindOfOption = optionKinds) {
  if (typeof options !== "object" || options === null || isList(options))
    throw new TypeError("options must be an object, such as { numberOfSegments: 5 }");
  const given = Object.fromEntries(
    Object.entries(options).filter(([, value]) => value !== undefined));
  for (const [name, value] of Object.entries(given)) {
    if (!Object.hasOwn(kindOfOption, name))
      throw new TypeError(`there is no option ${name}`);
    const [isRight, requirement] = kinds[kindOfOption[name]];
    if (!isRight(value))
      throw new TypeError(`${name} must be ${requirement}`);
    if (kindOfOption[name] === "integer")
      given[name] = clamped(value);
  }
  if (given.numberOfSegments !== undefined &&
      (given.maximumNumberOfSegments ?? given.salienceThreshold) !== undefined)
    throw new TypeError("numberOfSegments goes neither with maximumNumberOfSegments nor with " +
                        "salienceThreshold");
  return given;
}

// Adds the features as an array of one type. Whole numbers, one a face, are labels, but not if
// their type is one of real numbers.
function addFeatures(features, mesh, given) {
  const { numberOfFaces } = mesh;
  if (features.length % numberOfFaces !== 0)
    throw new TypeError(`features must have as many numbers for each of the ${numberOfFaces} ` +
                        `faces, not ${features.length} in all`);
  const areReal = features instanceof Float32Array || features instanceof Float64Array;
  given.featuresAreLabels = !areReal && features.length === numberOfFaces &&
    features.every(each => each === (each | 0));
  given.features = (given.featuresAreLabels ? Int32Array : Float64Array).from(features);
}

// Returns whether the salience of a run is a probability, as it is without options.
const isProbability = ({ method, salienceWeights }) => method !== "paper" && !salienceWeights;

// Throws a TypeError if a threshold is no probability.
function checkThreshold({ salienceThreshold: threshold = 0 }) {
  if (Number.isFinite(threshold) && (threshold < 0 || threshold > 1))
    throw new TypeError("salienceThreshold must be from 0 to 1, because it is a probability, " +
                        `not ${threshold}`);
}

// Returns the options for the module, which takes constraints as arrays of one type.
function checkedRunOptions(options, mesh) {
  const given = checkedOptions(options);
  const integers = ["constrainedEdges", "uncuttableEdges", "faceSeeds", "faceGroups"];
  for (const name of integers.filter(each => each in given)) {
    const numbers = given[name] = Int32Array.from(given[name]);
    if (name.startsWith("face") && numbers.length !== mesh.numberOfFaces)
      throw new TypeError(`${name} must have ${mesh.numberOfFaces} integers, one for each face, ` +
                          `not ${numbers.length}`);
    if (name.endsWith("Edges") && numbers.length % 2 !== 0)
      throw new TypeError(`${name} must have two points for each edge, not ${numbers.length} ` +
                          "in all");
  }
  if (given.features !== undefined)
    addFeatures(given.features, mesh, given);
  return given;
}

// Returns the choice of segments for the module; undefined for the segments of the run.
function checkedChoice(choice, maximum, hasProbability) {
  if (choice === undefined)
    return undefined;
  const given = checkedOptions(isNumber(choice) ? { numberOfSegments: choice } : choice,
                               choiceKinds);
  for (const name of ["numberOfSegments", "maximumNumberOfSegments"])
    if (given[name] < 1)
      throw new TypeError(`${name} must be at least 1`);
  const { numberOfSegments } = given;
  if (numberOfSegments > maximum)
    throw new TypeError(`there are only ${maximum} segments, not ${numberOfSegments}; a run with ` +
                        `{ numberOfSegments: ${numberOfSegments} } makes exactly this number`);
  if (Number.isNaN(given.salienceThreshold))
    throw new TypeError("salienceThreshold must be a number");
  if (hasProbability)
    checkThreshold(given);
  return Object.keys(given).length > 0 ? given : undefined;
}

function checkedTriples(name, value, types) {
  if (!types.some(type => value instanceof type))
    throw new TypeError(`${name} must be a ${types.map(type => type.name).join(" or ")}`);
  if (value.length % 3 !== 0)
    throw new TypeError(`${name} must have three numbers each, not ${value.length} in all`);
  return value;
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
    throw isMemory ? outOfMemory() : new Error(translated(message));
  }
}

const registry = globalThis.FinalizationRegistry &&
  new FinalizationRegistry(handle => handle.delete());

// An object in the memory of a module. It is freed by `free()`, or some time after its last use.
class Owned {
  #module;
  #handle;

  constructor(module, handle) {
    this.#module = module;
    this.#handle = handle;
    registry?.register(this, handle, this);
  }

  // Calls a function with the object of the module.
  call(what, action) {
    if (!this.#handle)
      throw new Error(`${this.description} was freed`);
    return call(this.#module, what, () => action(this.#handle));
  }

  isOf(module) { return module === this.#module; }

  free() {
    registry?.unregister(this);
    this.#handle?.delete();
    this.#handle = undefined;
  }
}

if (Symbol.dispose)
  Owned.prototype[Symbol.dispose] = Owned.prototype.free;

class Mesh extends Owned {
  #get(name) { return this.call("for the arrays of a mesh", handle => handle[name]()); }

  get description() { return "the mesh"; }
  get numberOfFaces() { return this.#get("numberOfFaces"); }
  get points() { return this.#get("points"); }
  get triangles() { return this.#get("triangles"); }
  get faceOfTriangle() { return this.#get("faceOfTriangle"); }
  get warnings() { return this.#get("warnings"); }
}

class Segmentation extends Owned {
  #hasProbability;

  constructor(module, handle, hasProbability) {
    super(module, handle);
    this.#hasProbability = hasProbability;
  }

  #checked(choice) {
    return checkedChoice(choice, this.maximumNumberOfSegments, this.#hasProbability);
  }

  get description() { return "the segmentation"; }
  get numberOfSegments() { return this.call("", handle => handle.numberOfSegments()); }
  get maximumNumberOfSegments() {
    return this.call("", handle => handle.maximumNumberOfSegments());
  }
  labels(choice) {
    return this.call("for labels", handle => handle.labels(this.#checked(choice)));
  }
  toJSON() { return JSON.parse(this.call("for JSON", handle => handle.json())); }
  pageData(name = "") {
    return JSON.parse(this.call("for a page", handle => handle.pageData(String(name))));
  }

  write(name, choice) {
    const extension = extensionOf(name);
    if (!writtenFormats.includes(extension))
      throw new TypeError(`the name must end in ${writtenFormats.join(", ")}, not ${name}`);
    return this.call("for a file", handle => handle.write(extension, this.#checked(choice)));
  }
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
    if (!mesh.isOf(this.#module))
      throw new TypeError("mesh must be of the same instance of the module, as load() returns it");
    const { progress, ...others } = checkedRunOptions(options, mesh);
    let error;
    // An exception that passed through the module would leave its memory behind.
    const report = progress && (fraction => {
      try {
        return progress(fraction) !== false;
      }
      catch (e) {
        error = e ?? new Error("progress failed");
        return false;
      }
    });
    const handle = mesh.call(`for ${mesh.numberOfFaces} faces`, handleOfMesh =>
      new this.#module.Segmentation(handleOfMesh, others, report));
    if (error) {
      handle.delete();
      throw error;
    }
    return new Segmentation(this.#module, handle, isProbability(others));
  }
}

// Starts an instance of the module. `settings` give emscripten the place of module.wasm.
export async function start(settings) {
  const module = await createModule(settings);
  Object.assign(optionKinds, module.optionKinds());
  return new Module(module);
}
