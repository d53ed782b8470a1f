// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { Hierarchy, faceLabels, labelOfSegment } from "./hierarchy.js";
import { nodeColors } from "./colors.js";
import { Scene } from "./scene.js";

const markup = `
<div class="stage" data-id="stage">
  <div class="hidden-note" data-id="hiddenNote" hidden>
    <span data-id="hiddenText"></span> <button type="button" data-id="showAll">Show all</button>
  </div>
  <div class="card" data-id="card" hidden>
    <span class="swatch" data-id="swatch"></span>
    <div><strong data-id="partName"></strong><br><span data-id="partText"></span></div>
    <button type="button" data-id="isolate">Isolate</button>
    <button type="button" data-id="hide">Hide</button>
    <button type="button" data-id="deselect" aria-label="Close">×</button>
  </div>
</div>
<form class="panel">
  <h1 data-id="name"></h1>
  <p class="counts" data-id="counts"></p>
  <div class="number">
    <label>Segments <output data-id="number"></output></label>
    <button type="button" data-id="fewer" aria-label="One segment fewer">−</button>
    <input type="range" data-id="slider" step="1" aria-label="Number of segments">
    <button type="button" data-id="more" aria-label="One segment more">+</button>
  </div>
  <div class="cuts">
    <svg class="strip" data-id="strip" preserveAspectRatio="none" role="img"></svg>
    <p data-id="cutText" aria-live="polite"></p>
  </div>
  <label class="row">Explosion
    <input type="range" data-id="explosion" min="0" max="1" step="0.01" value="0"></label>
  <label class="row">Shading
    <select data-id="shading">
      <option value="smooth">smooth</option><option value="flat">flat</option>
      <option value="none">none</option>
    </select></label>
  <div class="switches">
    <label><input type="checkbox" data-id="seams" checked> Seams</label>
    <label><input type="checkbox" data-id="edges"> Edges</label>
    <label><input type="checkbox" data-id="up"> z is up</label>
  </div>
  <div class="buttons">
    <button type="button" data-id="saveLabels">Save labels</button>
    <button type="button" data-id="savePicture">Save picture</button>
    <button type="button" data-id="reset">Reset view</button>
  </div>
  <details>
    <summary>Mouse, touch and keys</summary>
    <dl>
      <dt>drag</dt><dd>turn</dd>
      <dt>wheel, pinch</dt><dd>zoom</dd>
      <dt>right button, two fingers</dt><dd>pan</dd>
      <dt>click, tap</dt><dd>select a segment</dd>
      <dt>← →</dt><dd>fewer, more segments</dd>
      <dt>I, H, A</dt><dd>isolate, hide, show all</dd>
      <dt>X</dt><dd>explode</dd>
      <dt>B, E, S</dt><dd>seams, edges, shading</dd>
      <dt>Z, R</dt><dd>z is up, reset view</dd>
      <dt>L, P</dt><dd>save labels, picture</dd>
      <dt>Esc</dt><dd>select nothing</dd>
    </dl>
  </details>
</form>`;

export function save(blob, name) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

const count = (number, name) =>
  `${number.toLocaleString("en")} ${name}${number === 1 ? "" : "s"}`;

const percent = share => `${(100 * share).toPrecision(share < 0.1 ? 2 : 3)} %`;

// Shows a segmented mesh in an element.
//
// The model has
// - name: of the mesh;
// - mesh: {points, triangles, pieces}, see Scene;
// - hierarchy: the arguments of Hierarchy;
// - pieceOfFace: the piece of each face of the input; and, if these do not tell all labels,
//   exceptions, see faceLabels();
// - segments: the number of segments to begin with;
// - salience: what the number of a cut is called, as "probability";
// - notes: sentences to show, if any.
export class Viewer {

  constructor(element, model) {
    this.element = element;
    this.model = model;
    this.hierarchy = new Hierarchy(model.hierarchy);
    this.isHidden = new Uint8Array(this.hierarchy.leaves.length);
    this.selected = undefined; // a piece, which stands for its segment
    element.classList.add("segment-viewer");
    element.innerHTML = markup;
    this.ui = Object.fromEntries([...element.querySelectorAll("[data-id]")]
      .map(part => [part.dataset.id, part]));
    this.listeners = new AbortController();
    try {
      this.scene = new Scene(this.ui.stage, model.mesh, this.hierarchy.leaves.length);
    }
    catch (error) {
      this.ui.stage.textContent = "The picture needs WebGL, which this browser does not give: " +
                                  error.message;
      throw error;
    }
    this.colors = nodeColors(this.hierarchy, this.neighbors());
    this.fill();
    this.listen();
    this.setNumber(model.segments);
    this.ui.up.checked = this.scene.chooseView(this.segmentOfPiece);
  }

  // For each piece those that it touches.
  neighbors() {
    const result = this.hierarchy.leaves.map(() => new Set());
    for (const [, , piece, , , other] of this.scene.seams) {
      result[piece].add(other);
      result[other].add(piece);
    }
    return result;
  }

  // Fills in the content that does not change.
  fill() {
    const { ui, model, hierarchy } = this;
    ui.name.textContent = model.name;
    ui.counts.textContent = [`${count(model.pieceOfFace.length, "face")}.`,
                             ...model.notes ?? []].join(" ");
    ui.slider.min = hierarchy.roots;
    ui.slider.max = hierarchy.most;
    ui.strip.setAttribute("aria-label", `The ${model.salience} of each cut`);
    const finite = hierarchy.saliences.filter(Number.isFinite);
    const top = Math.max(model.salience === "probability" ? 1 : 0, ...finite) || 1;
    ui.strip.setAttribute("viewBox", `0 0 ${Math.max(hierarchy.saliences.length, 1)} 1`);
    hierarchy.saliences.forEach((salience, i) => {
      const height = Math.max(0.02, Math.min(1, salience / top));
      const bar = document.createElementNS("http://www.w3.org/2000/svg", "rect");
      bar.setAttribute("x", i + 0.1);
      bar.setAttribute("y", 1 - height);
      bar.setAttribute("width", 0.8);
      bar.setAttribute("height", height);
      const title = document.createElementNS("http://www.w3.org/2000/svg", "title");
      title.textContent = `${hierarchy.roots + i + 1} segments: ${this.cutText(i)}`;
      bar.append(title);
      ui.strip.append(bar);
    });
  }

  cutText(i) {
    const salience = this.hierarchy.saliences[i];
    return Number.isFinite(salience) ? `${this.model.salience} ${salience.toFixed(2)}`
                                     : "between components";
  }

  listen() {
    const { ui } = this;
    const on = (target, event, action) =>
      target.addEventListener(event, action, { signal: this.listeners.signal });
    on(ui.slider, "input", () => this.setNumber(+ui.slider.value));
    on(ui.fewer, "click", () => this.setNumber(this.number - 1));
    on(ui.more, "click", () => this.setNumber(this.number + 1));
    on(ui.explosion, "input", () => this.show());
    on(ui.shading, "change", () => this.scene.setShading(ui.shading.value));
    on(ui.seams, "change", () => this.scene.setVisible("seamLines", ui.seams.checked));
    on(ui.edges, "change", () => this.scene.setVisible("edgeLines", ui.edges.checked));
    on(ui.up, "change", () => this.scene.setUp(ui.up.checked));
    on(ui.isolate, "click", () => this.isolate());
    on(ui.hide, "click", () => this.hide());
    on(ui.showAll, "click", () => this.showAll());
    on(ui.deselect, "click", () => this.select(undefined));
    on(ui.saveLabels, "click", () => this.saveLabels());
    on(ui.savePicture, "click", () => this.savePicture());
    on(ui.reset, "click", () => this.scene.resetCamera());
    on(this.element.querySelector("form"), "submit", event => event.preventDefault());
    this.listenToStrip(on);
    this.listenToStage(on);
    on(document, "keydown", event => this.press(event));
  }

  // A drag along the strip moves through the cuts.
  listenToStrip(on) {
    const { strip } = this.ui;
    const take = event => {
      const box = strip.getBoundingClientRect();
      const cut = Math.floor((event.clientX - box.left) / box.width *
                             this.hierarchy.saliences.length);
      this.setNumber(this.hierarchy.roots + cut + 1);
    };
    on(strip, "pointerdown", event => {
      strip.setPointerCapture(event.pointerId);
      take(event);
    });
    on(strip, "pointermove", event => {
      if (event.buttons)
        take(event);
    });
  }

  // A click is a press that does not move.
  listenToStage(on) {
    const { canvas } = this.scene;
    let start;
    on(canvas, "pointerdown", event => {
      start = event.isPrimary && event.button === 0 ? event : undefined;
    });
    on(canvas, "pointerup", event => {
      if (start && Math.hypot(event.clientX - start.clientX, event.clientY - start.clientY) < 6)
        this.select(this.scene.pick(event.clientX, event.clientY));
      start = undefined;
    });
  }

  press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey)
      return;
    const { ui } = this;
    const isRange = event.target.type === "range"; // it has its own arrows
    const toggle = part => part.click();
    const actions = {
      ArrowLeft: () => this.setNumber(this.number - 1),
      ArrowRight: () => this.setNumber(this.number + 1),
      i: () => this.isolate(),
      h: () => this.hide(),
      a: () => this.showAll(),
      x: () => {
        ui.explosion.value = +ui.explosion.value > 0 ? 0 : 0.7;
        this.show();
      },
      b: () => toggle(ui.seams),
      e: () => toggle(ui.edges),
      s: () => {
        ui.shading.selectedIndex = (ui.shading.selectedIndex + 1) % ui.shading.length;
        this.scene.setShading(ui.shading.value);
      },
      z: () => toggle(ui.up),
      r: () => this.scene.resetCamera(),
      l: () => this.saveLabels(),
      p: () => this.savePicture(),
      Escape: () => this.select(undefined)
    };
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (!(key in actions) || (isRange && key.startsWith("Arrow")) ||
        event.target.matches?.("select, input[type=text]"))
      return;
    event.preventDefault();
    actions[key]();
  }

  setNumber(number) {
    const { hierarchy, ui } = this;
    this.number = Math.min(Math.max(number, hierarchy.roots), hierarchy.most);
    this.segmentOfPiece = hierarchy.segmentOfPiece(this.number);
    this.labels = labelOfSegment(hierarchy, this.number, this.model.exceptions);
    ui.slider.value = ui.number.value = this.number;
    ui.fewer.disabled = this.number === hierarchy.roots;
    ui.more.disabled = this.number === hierarchy.most;
    const last = this.number - hierarchy.roots - 1;
    [...ui.strip.children].forEach((bar, i) => {
      bar.setAttribute("class", i < last ? "made" : i === last ? "made last" : "");
    });
    const suggestion = this.number === this.model.segments ? "" :
      ` The tool chose ${this.model.segments}.`;
    ui.cutText.textContent = (last < 0 ? "No cut." : `Last cut: ${this.cutText(last)}.`) +
                             suggestion;
    this.show();
  }

  // The pieces of the segment of a piece.
  piecesWith(piece) {
    return [...this.segmentOfPiece.keys()]
      .filter(other => this.segmentOfPiece[other] === this.segmentOfPiece[piece]);
  }

  select(piece) {
    this.selected = piece;
    this.show();
  }

  isolate() {
    if (this.selected === undefined)
      return;
    this.isHidden.fill(1);
    for (const piece of this.piecesWith(this.selected))
      this.isHidden[piece] = 0;
    this.show();
  }

  hide() {
    if (this.selected === undefined)
      return;
    for (const piece of this.piecesWith(this.selected))
      this.isHidden[piece] = 1;
    this.select(undefined);
  }

  showAll() {
    this.isHidden.fill(0);
    this.show();
  }

  show() {
    const { segmentOfPiece, selected } = this;
    const isDimmed = segment => selected !== undefined && segment !== segmentOfPiece[selected];
    this.scene.show({
      segmentOfPiece,
      colorOfPiece: segmentOfPiece.map(segment => isDimmed(segment)
        ? this.colors[segment].map(x => 0.25 * x + 0.45) : this.colors[segment]),
      isShown: Array.from(this.isHidden, hidden => !hidden),
      explosion: 0.9 * this.ui.explosion.value
    });
    this.showSelection();
    this.showHidden();
  }

  showSelection() {
    const { ui, selected, hierarchy } = this;
    ui.card.hidden = selected === undefined;
    if (selected === undefined)
      return;
    const node = this.segmentOfPiece[selected];
    const isIn = new Uint8Array(this.isHidden.length);
    for (const piece of this.piecesWith(selected))
      isIn[piece] = 1;
    const faces = this.model.pieceOfFace.reduce((sum, piece) => sum + isIn[piece], 0);
    const area = hierarchy.areas.slice(0, hierarchy.roots).reduce((sum, a) => sum + a, 0);
    ui.swatch.style.background = `rgb(${this.colors[node].map(x => Math.round(255 * x))})`;
    ui.partName.textContent = `Segment ${this.labels.get(node)}`;
    ui.partText.textContent = `${count(faces, "face")}, ` +
      `${percent(area > 0 ? hierarchy.areas[node] / area : 0)} of the area` +
      this.copiesText(node);
  }

  // The segments shown that may be copies or mirror images of one.
  copiesText(node) {
    const { classes } = this.hierarchy;
    const copies = [...new Set(this.segmentOfPiece)]
      .filter(other => other !== node && classes[other] === classes[node])
      .map(other => this.labels.get(other)).sort((a, b) => a - b);
    return copies.length === 0 ? "" : `, like segment${copies.length > 1 ? "s" : ""} ` +
      copies.slice(0, 8).join(", ") + (copies.length > 8 ? " …" : "");
  }

  showHidden() {
    const shown = new Set(), all = new Set(this.segmentOfPiece);
    this.segmentOfPiece.forEach((segment, piece) => {
      if (!this.isHidden[piece])
        shown.add(segment);
    });
    const number = all.size - shown.size;
    this.ui.hiddenNote.hidden = !this.isHidden.includes(1);
    this.ui.hiddenText.textContent =
      `${count(number, "segment")} ${number === 1 ? "is" : "are"} hidden.`;
  }

  // The text of `segment_mesh --labels` for the number shown.
  labelText() {
    const labels = faceLabels(this.hierarchy, this.number, this.model.pieceOfFace,
                              this.model.exceptions);
    return labels.join("\n") + "\n";
  }

  fileName(ending) {
    const stem = this.model.name.replace(/^.*[\\/]/, "").replace(/\.[^.]*$/, "");
    return `${stem || "mesh"}_${this.number}${ending}`;
  }

  saveLabels() {
    save(new Blob([this.labelText()], { type: "text/plain" }), this.fileName(".seg"));
  }

  savePicture() { this.scene.picture(blob => save(blob, this.fileName(".png"))); }

  dispose() {
    this.listeners.abort();
    this.scene.dispose();
    this.element.replaceChildren();
  }
}
