// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { SegmentationWorker } from "./worker_client.js";
import { Viewer, save } from "./viewer.js";
import { gltfAsPly } from "./gltf_as_ply.js";
import { samples } from "./samples.js";

const ui = Object.fromEntries([...document.querySelectorAll("[id]")].map(part => [part.id, part]));

// A job is the cutting of one mesh: { name, method, read, worker }, where read() returns the bytes.
// The worker goes on to have the segmentation, for files to save.
let running, shown;
let viewer;

function fail(message) {
  ui.failure.hidden = false;
  ui.error.textContent = message;
}

function showProgress(stage, fraction = undefined) {
  ui.progress.hidden = false;
  ui.stage.textContent = stage;
  if (fraction === undefined)
    ui.fraction.removeAttribute("value");
  else
    ui.fraction.value = fraction;
}

// Nothing runs any more.
function stop() {
  running = undefined;
  ui.progress.hidden = true;
}

function cancel() {
  running?.worker.close();
  stop();
  ui.method.value = shown?.method ?? ui.method.value;
}

// Returns the file of a number of segments. If it cannot be made, shows the reason.
async function meshFile(extension, number) {
  try {
    return new Blob([await shown.worker.write(`mesh${extension}`, number)]);
  }
  catch (error) {
    fail(`The mesh cannot be saved: ${error.message}`);
  }
}

async function savePly() {
  if (viewer.isEdited) {
    fail("PLY is saved without edits: undo them, or save GLB or labels.");
    return;
  }
  const file = await meshFile(".ply", viewer.number);
  if (file)
    save(file, viewer.fileName(".ply"));
}

function addPlyButton() {
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = "Save PLY";
  button.dataset.id = "saveply";
  button.addEventListener("click", savePly);
  viewer.ui.saveglb.before(button);
}

function show(job, model) {
  viewer?.dispose();
  shown?.worker.close();
  viewer = undefined;
  document.body.classList.remove("empty");
  shown = job;
  globalThis.viewer = viewer = new Viewer(ui.viewer, model); // global for tests and the curious
  addPlyButton();
  ui.viewer.querySelector("form").append(ui.privacy);
  document.title = `${model.name}: its parts`;
}

// Returns the name and bytes of a file that the module reads, and messages to show.
async function readableFile({ name, read, notes }) {
  const given = await read();
  if (!/\.(glb|gltf)$/i.test(name))
    return { name, bytes: given, notes };
  const { bytes, hasTextures } = await gltfAsPly(given);
  return { name: `${name}.ply`, bytes,
           notes: hasTextures ? [...notes, "Its textures are not kept."] : notes };
}

// The mesh that is shown stays until the next one is cut.
async function segment(name, read, notes = []) {
  running?.worker.close();
  const job = running = { name, read, notes, method: ui.method.value,
                          worker: new SegmentationWorker() };
  ui.failure.hidden = true;
  showProgress(`Reading ${name}`);
  try {
    const file = await readableFile(job);
    if (running !== job)
      return;
    const { model, warnings } = await job.worker.segment(file, { method: job.method }, fraction => {
      if (running === job)
        showProgress(`Cutting ${name}`, fraction);
    });
    if (running !== job)
      return;
    stop();
    show(job, { ...model, name, glb: number => meshFile(".glb", number),
                notes: [...model.notes, ...file.notes,
                        ...warnings.map(each => `Warning: ${each}.`)] });
  }
  catch (error) {
    if (running !== job && shown !== job) // cancelled
      return;
    cancel();
    fail(`${name} cannot be cut: ${(error.message || String(error)).replace("THREE.", "")}`);
  }
}

// Takes the first mesh of some files, such as OBJ with MTL.
function take(files) {
  const isMesh = ({ name }) => /\.(off|obj|ply|stl|glb|gltf)$/i.test(name);
  const file = files.find(isMesh) ?? files[0];
  const others = files.filter(other => other !== file).map(({ name }) => name);
  segment(file.name, async () => new Uint8Array(await file.arrayBuffer()),
          others.length > 0 ? [`Not read: ${others.join(", ")}.`] : []);
}

async function fetched(address) {
  const response = await fetch(address);
  if (!response.ok)
    throw new Error(`the server answers ${response.status}`);
  return new Uint8Array(await response.arrayBuffer());
}

ui.file.addEventListener("change", () => {
  if (ui.file.files.length > 0)
    take([...ui.file.files]);
  ui.file.value = ""; // so that the same file can be chosen again
});

const segmentSample = (name, notes) => segment(name, () => fetched(`samples/${name}`), notes);

for (const name of samples)
  ui.sample.append(new Option(name.replace(/\..*$/, ""), name));
ui.sample.addEventListener("change", () => {
  if (ui.sample.value)
    segmentSample(ui.sample.value);
  ui.sample.value = "";
});
ui.method.addEventListener("change", () => {
  const job = running ?? shown;
  if (job)
    segment(job.name, job.read, job.notes);
});
ui.welcome.addEventListener("click", () => ui.file.click());
ui.closeError.addEventListener("click", () => { ui.failure.hidden = true; });
ui.cancel.addEventListener("click", cancel);

addEventListener("dragover", event => {
  event.preventDefault();
  document.body.classList.add("dragged");
});
addEventListener("dragleave", event => {
  if (!event.relatedTarget)
    document.body.classList.remove("dragged");
});
addEventListener("drop", event => {
  event.preventDefault();
  document.body.classList.remove("dragged");
  if (event.dataTransfer.files.length > 0)
    take([...event.dataTransfer.files]);
  else
    fail("This is no file. Drop a mesh in a file of OFF, OBJ, PLY, STL or GLB.");
});
document.documentElement.dataset.ready = "";
segmentSample(samples[0], ["A sample: drop a mesh of your own anywhere on this page."]);
