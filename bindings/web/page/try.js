// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { SegmentationWorker } from "./worker_client.js";
import { Viewer } from "./viewer.js";
import { glbAsPly } from "./glb_as_ply.js";
import { samples } from "./samples.js";

const ui = Object.fromEntries([...document.querySelectorAll("[id]")].map(part => [part.id, part]));
let shown;   // { worker, viewer, name, bytes } of the mesh in the viewer
let running; // the worker of the run that goes on

function save(bytes, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes]));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

function fail(sentence) {
  ui.error.textContent = sentence;
  ui.error.hidden = false;
}

function tell(stage, share = undefined) {
  ui.progress.hidden = false;
  ui.stage.textContent = stage;
  if (share === undefined)
    ui.share.removeAttribute("value");
  else
    ui.share.value = share;
}

function cancel() {
  running?.close();
  running = undefined;
  ui.progress.hidden = true;
}

// The mesh that is shown stays until the next one is cut.
function show(next, model) {
  shown?.viewer.dispose();
  shown?.worker.close();
  document.body.classList.remove("empty");
  shown = { ...next, viewer: new Viewer(ui.viewer, model) };
  ui.saves.hidden = false;
  globalThis.viewer = shown.viewer; // for tests and the curious
}

async function segment(name, read) {
  cancel();
  ui.error.hidden = true;
  const worker = running = new SegmentationWorker();
  tell(`Reading ${name}`);
  try {
    const bytes = await read();
    const file = /\.(glb|gltf)$/i.test(name)
      ? { name: `${name}.ply`, bytes: await glbAsPly(bytes) } : { name, bytes };
    const { model } = await worker.segment(
      file, { method: ui.method.value },
      share => running === worker && tell(`Cutting ${name}`, share));
    if (running !== worker)
      return;
    running = undefined; // it stays open, for files to save
    ui.progress.hidden = true;
    show({ worker, name, read: async () => bytes }, { ...model, name });
  }
  catch (error) {
    if (running !== worker) // cancelled
      return;
    cancel();
    fail(`${name} cannot be cut: ${error.message || error}`);
  }
}

async function saveMesh(extension) {
  const { worker, viewer } = shown;
  try {
    save(await worker.write(`mesh${extension}`, viewer.number), viewer.fileName(extension));
  }
  catch (error) {
    fail(`The mesh cannot be saved: ${error.message}`);
  }
}

const take = file => segment(file.name, async () => new Uint8Array(await file.arrayBuffer()));

ui.file.addEventListener("change", () => {
  if (ui.file.files[0])
    take(ui.file.files[0]);
  ui.file.value = ""; // so that the same file can be chosen again
});
for (const name of samples)
  ui.sample.append(new Option(name.replace(/\..*$/, ""), name));
ui.sample.addEventListener("change", () => {
  const name = ui.sample.value;
  if (name)
    segment(name, async () => {
      const response = await fetch(`samples/${name}`);
      if (!response.ok)
        throw new Error(`the server answers ${response.status}`);
      return new Uint8Array(await response.arrayBuffer());
    });
});
ui.method.addEventListener("change", () => {
  if (shown)
    segment(shown.name, shown.read);
});
ui.cancel.addEventListener("click", cancel);
ui.savePly.addEventListener("click", () => saveMesh(".ply"));
ui.saveGlb.addEventListener("click", () => saveMesh(".glb"));

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
  if (event.dataTransfer.files[0])
    take(event.dataTransfer.files[0]);
});
document.documentElement.dataset.ready = "";
