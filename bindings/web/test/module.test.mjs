// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Tests the module in Node. PACKAGE is its folder, MESHES the folder of libcgal-demo's meshes, and
// SEGMENT_MESH the native tool. With ALL_MESHES the labels of all meshes are compared.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import {
  copyFileSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync
} from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import test from "node:test";
import { pathToFileURL } from "node:url";

const { PACKAGE, MESHES, SEGMENT_MESH, ALL_MESHES } = process.env;
const { load } = await import(path.resolve(PACKAGE, "index_node.js"));
const { SegmentationWorker } = await import(path.resolve(PACKAGE, "worker_client_node.js"));
const { faceLabels, Hierarchy } = await import(path.resolve(PACKAGE, "hierarchy.js"));
const segmentation = await load();

const bytesOf = name => new Uint8Array(readFileSync(path.join(MESHES, name)));
const elephant = bytesOf("elephant.off");

function scratch(t) {
  const folder = mkdtempSync(path.join(tmpdir(), "spectral-"));
  t.after(() => rmSync(folder, { recursive: true }));
  return folder;
}

// The text of labels that the tool gives; undefined if it fails.
function labelsOfTool(file, ...options) {
  try {
    return execFileSync(SEGMENT_MESH, [file, "--quiet", "--labels", "-", ...options],
                        { encoding: "utf8", stdio: ["ignore", "pipe", "ignore"],
                          maxBuffer: 2 ** 30 });
  }
  catch (error) {
    assert.equal(error.status, 4, error.message); // no mesh
    return undefined;
  }
}

const text = labels => labels.join("\n") + "\n";

const tetrahedron = () => segmentation.mesh(new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]),
                                            new Uint16Array([0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3]));

test("labels equal the labels of the native tool", { timeout: 7200e3 }, () => {
  const names = ALL_MESHES ? readdirSync(MESHES).filter(name => /\.(off|obj|ply|stl)$/.test(name))
    : ["elephant.off", "bear.off", "fandisk.off", "cube.off", "blobby_3cc.off"];
  let compared = 0;
  for (const name of names)
    for (const method of ["calibrated", "paper"]) {
      const expected = labelsOfTool(path.join(MESHES, name), "--method", method);
      let mesh;
      try {
        mesh = segmentation.read(bytesOf(name), name);
      }
      catch (error) {
        assert.equal(expected, undefined, `${name}: ${error.message}`);
        continue;
      }
      const run = segmentation.segment(mesh, { method });
      assert.ok(text(run.labels()) === expected, `${name} by the method ${method}`);
      run.free();
      mesh.free();
      ++compared;
    }
  assert.ok(compared >= 10);
  console.log(`${compared} runs give the labels of the tool`);
});

test("options do the same as in the tool", () => {
  const mesh = segmentation.read(elephant, "elephant.off");
  for (const [options, ...ofTool] of [
    [{ numberOfSegments: 7, keepComponentsSeparate: true }, "--segments", "7",
     "--keep-components-separate"],
    [{ salienceThreshold: 0.7, maximumNumberOfSegments: 4 }, "--salience-threshold", "0.7",
     "--maximum-segments", "4"],
    [{ minimumSegmentSize: 0.02, numberOfSmoothingIterations: 2 }, "--minimum-segment-size", "0.02",
     "--smooth", "2"],
    [{ numberOfSearches: 2 }, "--searches", "2"]])
    assert.equal(text(segmentation.segment(mesh, options).labels()),
                 labelsOfTool(path.join(MESHES, "elephant.off"), ...ofTool), ofTool.join(" "));
});

test("a run gives the labels of all numbers, also as its page does", () => {
  const mesh = segmentation.read(elephant, "elephant.off");
  const run = segmentation.segment(mesh);
  mesh.free();
  for (const many of [run.maximumNumberOfSegments + 1, 1e6, 2 ** 32 + 1, 2 ** 50])
    for (const action of [() => run.labels(many), () => run.write("x.ply", many)])
      assert.throws(action, /^TypeError: there are only [0-9]+ segments, not [0-9]+; a run with/);
  assert.equal(run.numberOfSegments, new Set(run.labels()).size);
  for (let n = 1; n <= run.maximumNumberOfSegments; ++n)
    assert.equal(new Set(run.labels(n)).size, n);
  assert.equal(text(run.labels(5)),
               labelsOfTool(path.join(MESHES, "elephant.off"), "--segments", "5"));
  run.free();
});

test("a salience that is no probability has any threshold", () => {
  const mesh = segmentation.read(elephant, "elephant.off");
  const labels = segmentation.segment(mesh, { method: "paper" }).labels({ salienceThreshold: 9 });
  assert.deepEqual(new Set(labels), new Set([0]));
});

test("labels of a choice equal the labels of a run with it", () => {
  const mesh = segmentation.read(elephant, "elephant.off");
  const run = segmentation.segment(mesh);
  for (const choice of [{}, { numberOfSegments: 4 }, { salienceThreshold: 0.7 },
                        { salienceThreshold: 0.2, maximumNumberOfSegments: 14 },
                        { maximumNumberOfSegments: 3 }])
    assert.deepEqual(run.labels(choice), segmentation.segment(mesh, choice).labels());
  assert.deepEqual(run.write("x.off", { numberOfSegments: 4 }), run.write("x.off", 4));
});

test("constraints hold", () => {
  const mesh = segmentation.read(elephant, "elephant.off");
  const { triangles, numberOfFaces } = mesh;
  const plain = segmentation.segment(mesh).labels();
  const opposite = Math.floor(numberOfFaces / 2);
  const faceSeeds = new Int32Array(numberOfFaces).fill(-1);
  const segmentSizes = new Map();
  for (const label of plain)
    segmentSizes.set(label, (segmentSizes.get(label) ?? 0) + 1);
  const [largest] = [...segmentSizes].reduce((a, b) => b[1] > a[1] ? b : a);
  const inLargest = [...plain.keys()].filter(face => plain[face] === largest);
  const [a, b] = [inLargest[0], inLargest[inLargest.length - 1]];
  const c = plain.findIndex(label => label !== largest);
  faceSeeds[a] = 0;
  faceSeeds[b] = 1; // apart, although of one segment before
  faceSeeds[c] = 0; // together, although of two
  const seeded = segmentation.segment(mesh, { faceSeeds }).labels();
  assert.notEqual(seeded[a], seeded[b]);
  assert.equal(seeded[a], seeded[c]);

  const edge = [triangles[3 * a], triangles[3 * a + 1]];
  const facesAtEdge = edge => [...Array(numberOfFaces).keys()].filter(
    face => edge.every(point => triangles.subarray(3 * face, 3 * face + 3).includes(point)));
  const [f, g] = facesAtEdge(edge);
  assert.equal(plain[f], plain[g]);
  const constrained = segmentation.segment(mesh, { constrainedEdges: edge }).labels();
  assert.notEqual(constrained[f], constrained[g]);
  // All edges uncuttable: one segment.
  const whole = segmentation.segment(mesh, { uncuttableEdges: Array.from(triangles).flatMap(
    (corner, i) => [corner, triangles[i % 3 === 2 ? i - 2 : i + 1]]) });
  assert.equal(whole.numberOfSegments, 1);
  // Two halves as groups: no segment has faces of both.
  const faceGroups = Array.from(plain, (_, face) => Number(face < opposite));
  const grouped = segmentation.segment(mesh, { faceGroups, keepComponentsSeparate: true }).labels();
  const labelsOf = group => new Set(grouped.filter((_, face) => faceGroups[face] === group));
  assert.ok([...labelsOf(0)].every(label => !labelsOf(1).has(label)));
});

test("features decide with the shape", () => {
  const mesh = segmentation.read(elephant, "elephant.off");
  const plain = text(segmentation.segment(mesh).labels());
  const { numberOfFaces } = mesh;
  const { points, triangles } = mesh;
  const isHigh = Array.from({ length: numberOfFaces },
                            (_, face) => Number(points[3 * triangles[3 * face]] > 0));
  for (const features of [isHigh, Uint8Array.from(isHigh), Float32Array.from(isHigh),
                          isHigh.flatMap(value => [1e9 + value, 0.5])]) {
    const labels = segmentation.segment(mesh, { features, featureWeight: 1,
                                                numberOfSegments: 2 }).labels();
    const same = labels.filter((label, face) => label === isHigh[face]).length;
    assert.ok(Math.max(same, numberOfFaces - same) > 0.9 * numberOfFaces);
    assert.equal(text(segmentation.segment(mesh, { features, featureWeight: 0 }).labels()), plain);
  }
  for (const features of [isHigh.map(() => 3), isHigh.map(() => 0.5)])
    assert.equal(text(segmentation.segment(mesh, { features }).labels()), plain);
});

test("options for experts have an effect", () => {
  const mesh = segmentation.read(elephant, "elephant.off");
  const file = path.join(MESHES, "elephant.off");
  const labels = options => segmentation.segment(mesh, options).labels();
  const paper = labels({ method: "paper" });
  assert.deepEqual(paper, labels({ method: "paper", distanceWeights: [0.01, 1, 0.1],
                                   numberOfCoarseFaces: 0, numberOfReferenceFaces: 10 }));
  assert.notDeepEqual(paper, labels({ method: "paper", distanceWeights: [0.9, 1, 0.1] }));
  assert.equal(text(labels({ method: "paper", randomSeed: 7 })),
               labelsOfTool(file, "--method", "paper", "--seed", "7"));
  assert.deepEqual(paper, labels({ method: "paper", salienceWeights: [0.1, 0.6, 0.3] }));
  const bySize = segmentation.segment(mesh, { method: "paper", salienceWeights: [1, 0, 0] });
  const cuts = bySize.toJSON().nodes.filter(node => node.salience !== null);
  assert.ok(cuts.length > 0);
  for (const { salience, factors } of cuts)
    assert.ok(Math.abs(salience - factors.size) < 1e-9);
});

test("arrays and files give the same", () => {
  const mesh = segmentation.read(elephant, "elephant.off");
  assert.equal(mesh.numberOfFaces, mesh.triangles.length / 3);
  assert.deepEqual([...mesh.faceOfTriangle.slice(0, 3)], [0, 1, 2]);
  const expected = segmentation.segment(mesh).labels();
  for (const triangles of [mesh.triangles, Int32Array.from(mesh.triangles)])
    assert.deepEqual(segmentation.segment(segmentation.mesh(mesh.points, triangles)).labels(),
                     expected);
});

test("written files equal the files of the tool", t => {
  const folder = scratch(t);
  const run = segmentation.segment(segmentation.read(elephant, "elephant.off"));
  for (const format of ["ply", "glb", "off"]) {
    const file = path.join(folder, `out.${format}`);
    execFileSync(SEGMENT_MESH, [path.join(MESHES, "elephant.off"), "--quiet", "-o", file]);
    const bytes = run.write(`x.${format.toUpperCase()}`);
    assert.ok(Buffer.compare(readFileSync(file), bytes) === 0, format);
  }
  assert.throws(() => run.write("x.xyz"), /the name must end in .glb/);
});

test("errors name the cause", async () => {
  const mesh = tetrahedron();
  const other = await load();
  const freed = tetrahedron();
  const freedRun = segmentation.segment(freed);
  for (const object of [freed, freedRun, freed, freedRun])
    object.free();
  assert.throws(() => freed.warnings, /the mesh was freed/);
  const disposed = tetrahedron();
  disposed[Symbol.dispose]?.();
  if (Symbol.dispose)
    assert.throws(() => disposed.points, /the mesh was freed/);
  for (const [action, type, message] of [
    [() => segmentation.read("OFF", "a.off"), TypeError, /bytes must be a Uint8Array/],
    [() => segmentation.read(new Uint8Array(3), "a.xyz"), Error, /the format is unknown/],
    [() => segmentation.read(Buffer.from("OFF 1 x"), "a.off"), Error, /line 1: 'x' is not/],
    [() => segmentation.read(Buffer.from("OFF 0 0 0"), "a.off"), Error, /has no face/],
    [() => segmentation.mesh([0, 0, 0], new Uint32Array(3)), TypeError, /points must be a Float32/],
    [() => segmentation.mesh(new Float64Array(4), new Uint32Array(3)), TypeError, /three numbers/],
    [() => segmentation.mesh(new Float64Array(3), [0, 0, 0]), TypeError, /triangles must be a/],
    [() => segmentation.segment(segmentation.mesh(new Float64Array(3), new Uint32Array([0, 0, 7]))),
     Error, /triangle 0 has a corner that is no index of a point/],
    [() => segmentation.segment(segmentation.mesh(new Float64Array([NaN, 0, 0]),
                                                  new Int32Array([0, 0, -1]))),
     Error, /triangle 0/],
    [() => segmentation.mesh(new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, NaN]),
                             new Int32Array([0, 1, 2, 2, 1, 0])),
     Error, /^the mesh has no face with three corners; face 0 uses a point .* left out: 2$/],
    [() => segmentation.segment({}), TypeError, /mesh must be what read/],
    [() => segmentation.segment(mesh, { segments: 3 }), TypeError, /there is no option segments/],
    [() => segmentation.segment(mesh, { method: "zhang" }), TypeError,
     /method must be 'calibrated'/],
    [() => segmentation.segment(mesh, { numberOfSegments: 2.5 }), TypeError, /must be an integer/],
    [() => segmentation.segment(mesh, { numberOfSegments: 0 }), Error, /at least 1/],
    [() => segmentation.segment(mesh, { numberOfSegments: 5 }), Error,
     /^numberOfSegments is 5.* can have 1 to 4/],
    [() => segmentation.segment(mesh, null), TypeError, /options must be an object/],
    [() => segmentation.segment(mesh, 5), TypeError, /options must be an object/],
    [() => segmentation.segment(mesh, { toString: 5 }), TypeError, /no option toString/],
    [() => other.segment(mesh), TypeError, /same instance/],
    [() => segmentation.segment(freed), Error, /the mesh was freed/],
    [() => freed.points, Error, /the mesh was freed/],
    [() => freedRun.labels(), Error, /the segmentation was freed/],
    [() => segmentation.segment(mesh, { faceSeeds: [0, 1] }), TypeError, /must have 4 integers/],
    [() => segmentation.segment(mesh, { faceSeeds: [0, 1, 2, 0.5] }), TypeError, /array of int/],
    [() => segmentation.segment(mesh, { constrainedEdges: [0] }), TypeError, /two points/],
    [() => segmentation.segment(mesh, { constrainedEdges: [0, 1, 0, 9] }), Error,
     /^constrainedEdges has the edge \(0, 9\), which no triangle has/],
    [() => segmentation.segment(mesh, { constrainedEdges: [0, 1], uncuttableEdges: [1, 0] }), Error,
     /constrainedEdges and uncuttableEdges/],
    [() => segmentation.segment(mesh, { method: "paper", faceSeeds: [0, 1, 2, 3] }), Error,
     /^the method of the paper takes no constraints: use the calibrated method with them$/],
    [() => segmentation.segment(mesh, { method: "paper", keepComponentsSeparate: false }), Error,
     /^keepComponentsSeparate must be true with the method 'paper'/],
    [() => segmentation.segment(mesh, { distanceWeights: [1, 2] }), TypeError, /three numbers/],
    [() => segmentation.segment(mesh, { distanceWeights: [2, 1, 1] }), Error, /distanceWeights/],
    [() => segmentation.segment(mesh, { salienceWeights: [1, 1, 1] }), Error, /salienceWeights/],
    [() => segmentation.segment(mesh, { randomSeed: -1 }), TypeError, /randomSeed must be/],
    [() => segmentation.segment(mesh).labels({ method: "paper" }), TypeError, /no option method/],
    [() => segmentation.segment(mesh).labels({ salienceThreshold: NaN }), TypeError, /a number/],
    [() => segmentation.segment(mesh).labels({ salienceThreshold: 2 }), TypeError,
     /from 0 to 1, because it is a probability, not 2$/],
    [() => segmentation.read(new TextEncoder().encode("glTF\u0002"), "db.glb"), Error,
     /^it is binary glTF, which is not read here: save the mesh as PLY$/],
    [() => segmentation.read(new TextEncoder().encode("; FBX 7.4.0"), "db.fbx"), Error,
     /^it is FBX, which is not read here: save the mesh as PLY$/],
    [() => segmentation.segment(mesh, { numberOfSegments: 2, salienceThreshold: 1 }),
     TypeError, /neither/],
    [() => segmentation.segment(mesh, { salienceThreshold: NaN }), Error, /number/],
    [() => segmentation.segment(mesh, { salienceThreshold: 2 }), Error,
     /^salienceThreshold must be in \[0, 1\], because it is a probability, or infinite$/],
    [() => segmentation.segment(mesh, { salienceThreshold: -0.1 }), Error, /in \[0, 1\]/],
    [() => segmentation.segment(mesh, { features: [1, 2, 3] }), TypeError, /not 3 in all/],
    [() => segmentation.segment(mesh, { features: "color" }), TypeError, /array of numbers/],
    [() => segmentation.segment(mesh, { features: new Float32Array(mesh.numberOfFaces).fill(NaN) }),
     Error, /^features has a number that is not finite/],
    [() => segmentation.segment(mesh, { featureWeight: 2 }), Error, /^featureWeight must be/],
    [() => segmentation.segment(mesh, { minimumSegmentSize: 2 }), Error, /^minimumSegmentSize/],
    [() => segmentation.segment(mesh, { progress: 1 }), TypeError, /progress must be a function/],
    [() => segmentation.segment(mesh).labels(0), TypeError, /at least 1/]])
    assert.throws(action, error => error.constructor === type && message.test(error.message),
                  `${action}`);
});

test("damaged files give a mesh or a message", () => {
  const octahedron = bytesOf("octahedron.off");
  let seed = 1;
  const random = n => (seed = seed * 48271 % 2147483647) % n;
  for (let i = 0; i < 400; ++i) {
    const bytes = octahedron.slice(0, octahedron.length - random(3) * random(60));
    for (let k = random(5); k >= 0; --k)
      bytes[random(bytes.length)] = random(256);
    try {
      segmentation.read(bytes, `x.${["off", "obj", "ply", "stl"][i % 4]}`).free();
    }
    catch (error) {
      assert.equal(error.constructor, Error, error.stack);
      assert.match(error.message, /line|byte|face|format|polygon|point|file/i);
    }
  }
});

test("warnings and labels of a lenient reading equal those of the tool", async t => {
  const file = path.join(scratch(t), "x.off");
  const lines = Buffer.from(elephant).toString().split("\n");
  lines[38] = "0 nan 0"; // a point
  writeFileSync(file, lines.join("\n"));
  const bytes = new Uint8Array(readFileSync(file));
  const mesh = segmentation.read(bytes, file);
  const { warnings } = JSON.parse(execFileSync(SEGMENT_MESH, [file, "--quiet", "--json", "-"]));
  assert.match(warnings.join(), /^face \d+ uses a point that is not finite; corners left out: \d$/);
  assert.deepEqual(mesh.warnings, warnings);
  assert.equal(text(segmentation.segment(mesh).labels()), labelsOfTool(file));
  const worker = new SegmentationWorker();
  assert.deepEqual((await worker.segment({ bytes, name: file })).warnings, warnings);
  const { points, triangles } = tetrahedron();
  assert.deepEqual((await worker.segment({ points, triangles })).warnings, []);
  worker.close();

  const whole = segmentation.read(elephant, "x.off");
  const ofArrays = segmentation.mesh(mesh.points, whole.triangles);
  assert.deepEqual([ofArrays.numberOfFaces, ofArrays.warnings], [whole.numberOfFaces, warnings]);
  assert.deepEqual(ofArrays.triangles, mesh.triangles);
  const [run, runOfArrays] = [mesh, ofArrays].map(each => segmentation.segment(each));
  assert.equal(text(runOfArrays.labels()), text(run.labels()));
  assert.deepEqual(runOfArrays.pageData(), run.pageData());
  assert.deepEqual(segmentation.read(runOfArrays.write("x.ply"), "x.ply").triangles,
                   segmentation.read(run.write("x.ply"), "x.ply").triangles);

  const more = Buffer.from("v 0 0 0\nv 1 0 0\nv 0 1 0\nvw 0 0 1\n<b>\nf 1 2 3\n");
  assert.deepEqual(segmentation.read(more, "x.obj").warnings,
                   ["line 4: 'vw' is not a statement of OBJ",
                    "line 5: '<b>' is not a statement of OBJ"]);
  assert.deepEqual(segmentation.read(elephant, "x.off").warnings, []);
  const none = Buffer.from("v 0 0 0\nv 1 0 0\nv nan 0 0\nf 1 2 3\n");
  assert.throws(() => segmentation.read(none, "x.obj"),
                /^Error: it has no face .* corners; face 0 uses a point that is not finite/);
});

test("faces without a triangle need no features and no seeds", () => {
  const { points, triangles, numberOfFaces } = segmentation.read(elephant, "x.off");
  points[3 * triangles[0]] = -Infinity;
  const mesh = segmentation.mesh(points, triangles);
  const used = new Set(mesh.faceOfTriangle);
  assert.ok(!used.has(0) && used.size > numberOfFaces - 20);
  const height = face => points[3 * triangles[3 * face + 1] + 1];
  const labels = value => text(segmentation.segment(mesh, {
    features: Float64Array.from({ length: numberOfFaces }, (_, face) =>
      used.has(face) ? Number(height(face) > 0) : value),
    faceSeeds: Int32Array.from({ length: numberOfFaces }, (_, face) =>
      used.has(face) || value === 0 ? -1 : face),
    featureWeight: 1, numberOfSegments: 2 }).labels());
  for (const value of [NaN, Infinity])
    assert.equal(labels(value), labels(0));
});

test("progress ascends, ends a run, and may fail", () => {
  const mesh = segmentation.read(elephant, "elephant.off");
  const fractions = [];
  segmentation.segment(mesh, { progress: fraction => { fractions.push(fraction); } });
  assert.ok(fractions.length > 2);
  assert.ok(fractions.every((fraction, i) => i === 0 || fraction >= fractions[i - 1]));
  const run = segmentation.segment(mesh, { progress: () => false });
  assert.ok(run.maximumNumberOfSegments <= segmentation.segment(mesh).maximumNumberOfSegments);
  assert.throws(() => segmentation.segment(mesh, { progress: () => { throw new Error("mine"); } }),
                /^Error: mine$/);
});

// A torus of 2 n^2 triangles.
function torus(n) {
  const points = [], triangles = [];
  const corner = (i, j) => i % n * n + j % n;
  for (let i = 0; i < n; ++i)
    for (let j = 0; j < n; ++j) {
      const a = 2 * Math.PI * i / n, b = 2 * Math.PI * j / n, r = 3 + Math.cos(b);
      points.push(r * Math.cos(a), r * Math.sin(a), Math.sin(b));
      triangles.push(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                     corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
    }
  return [new Float64Array(points), new Uint32Array(triangles)];
}

// 1,000 meshes or runs need more memory than the module has at first, so that it would have to
// grow.
test("memory is given back", async () => {
  const own = await load();
  const arrays = torus(20);
  const run = () => {
    const mesh = own.mesh(...arrays);
    const result = own.segment(mesh, { method: "paper", salienceThreshold: 0.1 });
    result.write("x.ply");
    mesh.free();
    result.free();
    assert.throws(() => own.read(Buffer.from("OFF 9"), "x.off"));
  };
  const memory = () => process.memoryUsage().external; // with the memory of the module
  run();
  const before = memory();
  for (let i = 0; i < 1000; ++i)
    run();
  assert.ok(memory() - before < 4e6);
});

test("module.wasm may be elsewhere", async t => {
  const wasmUrl = pathToFileURL(path.join(scratch(t), "other.wasm"));
  await assert.rejects(load({ wasmUrl }), /no such file.*other.wasm/);
  copyFileSync(path.join(PACKAGE, "module.wasm"), wasmUrl);
  assert.equal((await load({ wasmUrl: wasmUrl.href })).version, segmentation.version);
  const worker = new SegmentationWorker({ wasmUrl });
  const points = new Float64Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), triangles = Uint16Array.of(0, 1, 2);
  assert.equal((await worker.segment({ points, triangles })).numberOfSegments, 1);
  worker.close();
  const unused = new SegmentationWorker();
  await assert.rejects(unused.labels(), /no segmentation yet/);
  unused.close();
});

test("a worker does the same, and ends at once", async () => {
  const worker = new SegmentationWorker();
  const fractions = [];
  const { model, numberOfSegments } = await worker.segment(
    { bytes: elephant, name: "elephant.off" }, {}, fraction => fractions.push(fraction));
  assert.ok(fractions.length > 0);
  const run = segmentation.segment(segmentation.read(elephant, "elephant.off"));
  assert.equal(numberOfSegments, run.numberOfSegments);
  const hierarchy = new Hierarchy(model.hierarchy);
  for (const n of [1, 2, 5, run.maximumNumberOfSegments]) {
    assert.deepEqual(faceLabels(hierarchy, n, model.pieceOfFace, model.exceptions), run.labels(n));
    assert.deepEqual(await worker.labels(n), run.labels(n));
  }
  const choice = { salienceThreshold: 0.7, maximumNumberOfSegments: 3 };
  assert.deepEqual(await worker.labels(choice), run.labels(choice));
  assert.deepEqual(await worker.write("x.glb", 5), run.write("x.glb", 5));
  assert.deepEqual(await worker.toJSON(), run.toJSON());
  await assert.rejects(worker.segment({ bytes: Buffer.from("OFF x"), name: "a.off" }),
                       /line 1: 'x' is not a number of points/);
  await assert.rejects(worker.segment({ bytes: elephant, name: "a.off" }, { progress() {} }),
                       /progress is the third argument/);
  for (const options of [null, 5])
    await assert.rejects(worker.segment({ bytes: elephant, name: "a.off" }, options),
                         { name: "TypeError", message: /options must be an object/ });
  await assert.rejects(worker.segment({ bytes: elephant, name: "a.off" },
                                      { salienceThreshold: NaN }),
                       /salienceThreshold must be a number/);
  assert.deepEqual(await worker.toJSON(), run.toJSON(), "the last good run stays");
  const large = worker.segment({ bytes: elephant, name: "elephant.off" },
                               { method: "paper" });
  const start = performance.now();
  worker.close();
  await assert.rejects(large, { name: "AbortError" });
  await assert.rejects(worker.labels(), { name: "AbortError" });
  assert.ok(performance.now() - start < 1000);
});

test("the package runs in an empty folder as its documents say", t => {
  const folder = scratch(t);
  const build = path.dirname(path.resolve(PACKAGE));
  const archive = readdirSync(build).find(name => /\.tgz$/.test(name));
  writeFileSync(path.join(folder, "package.json"), '{ "type": "module" }');
  execFileSync("npm", ["install", "--offline", "--no-audit", "--silent",
                       path.join(build, archive)], { cwd: folder });
  const blocksOf = (file, pattern) =>
    [...readFileSync(file, "utf8").matchAll(pattern)].map(match => match[1]);
  const readme = blocksOf(path.join(PACKAGE, "README.md"), /```js\n([^]*?)```/g);
  const chapter = blocksOf(new URL("../../../doc/JavaScript.txt", import.meta.url),
                           /\\code\{\.js\}\n([^]*?)\\endcode/g);
  assert.equal(readme.length, 2);
  assert.equal(chapter.length, 3);
  copyFileSync(path.join(MESHES, "elephant.off"), path.join(folder, "elephant.off"));
  const file = 'import { readFileSync } from "node:fs";\n' +
    'const file = Object.assign(new Blob([readFileSync("elephant.off")]),' +
    '                           { name: "elephant.off" });\n';
  [[readme[0], /segments 12$/m], [file + readme[1], /segments 5$/m],
   [chapter[0] + chapter[1], /^12 segments$/m], [file + chapter[2], /segments 5$/m]
  ].forEach(([program, output], i) => {
    writeFileSync(path.join(folder, `block${i}.js`), program);
    assert.match(execFileSync("node", [`block${i}.js`], { cwd: folder, encoding: "utf8" }), output);
  });
});
