// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

import { glbOf } from "./glb.js";
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
    <div><input type="text" data-id="partName" maxlength="80"><br>
      <span data-id="partText"></span></div>
    <button type="button" data-id="merge">Merge</button>
    <button type="button" data-id="cut">Cut</button>
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
    <p data-id="cutText"></p>
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
    <button type="button" data-id="undo">Undo</button>
    <button type="button" data-id="redo">Redo</button>
    <button type="button" data-id="saveLabels">Save labels</button>
    <button type="button" data-id="saveglb">Save GLB</button>
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
      <dt>Shift and click</dt><dd>merge it with the selected one</dd>
    </dl>
    <p>Keys while the picture has the focus:</p>
    <dl>
      <dt>arrows, + −</dt><dd>turn, zoom</dd>
      <dt>N, Shift+N</dt><dd>select the next, previous segment</dd>
      <dt>Page up, page down</dt><dd>more, fewer segments</dd>
      <dt>M</dt><dd>merge: once on each of two segments</dd>
      <dt>C, U, Y</dt><dd>cut, undo, redo</dd>
      <dt>I, H, A</dt><dd>isolate, hide, show all</dd>
      <dt>X</dt><dd>explode</dd>
      <dt>B, E, S</dt><dd>seams, edges, shading</dd>
      <dt>Z, R</dt><dd>z is up, reset view</dd>
      <dt>L, G, P</dt><dd>save labels, GLB, picture</dd>
      <dt>Esc</dt><dd>select nothing</dd>
    </dl>
  </details>
  <p>Spectral_segmentation is free software, under the
    <a href="https://www.gnu.org/licenses/gpl-3.0.html">GPL</a>, 3.0 or later.</p>
  <p class="said" data-id="said" role="status"></p>
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
// - mesh: {points, triangles, pieces}, see Scene; {corner, unit} place the points;
// - hierarchy: the arguments of Hierarchy;
// - pieceOfFace: the piece of each face of the input; and, if these do not determine all labels,
//   exceptions, see faceLabels();
// - segments: the number of segments to begin with;
// - salience: what the number of a cut is called, as "probability";
// - notes: messages to show, if any;
// - glb: a function that returns the file of a number of segments, if there is a better one than
//   that of the mesh shown.
export class Viewer {

  constructor(element, model) {
    this.element = element;
    this.model = model;
    this.hierarchy = new Hierarchy(model.hierarchy);
    this.isHidden = new Uint8Array(this.hierarchy.leaves.length);
    this.selected = undefined; // a piece, which stands for its segment
    this.merged = undefined;   // a piece whose segment waits for another one
    this.names = new Map();    // of segments
    this.past = [];            // states for undo, and those for redo
    this.future = [];
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
    this.apply(this.stateOf(model.segments));
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
    const { canvas } = this.scene;
    canvas.tabIndex = 0;
    canvas.setAttribute("role", "application"); // its keys are its own
    canvas.setAttribute("aria-label", `Picture of ${model.name}. Arrows turn it, N selects the ` +
                                      "next segment.");
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
    on(ui.partName, "change", () => this.rename(ui.partName.value));
    on(ui.merge, "click", () => this.startMerge());
    on(ui.cut, "click", () => this.cut());
    on(ui.undo, "click", () => this.undo());
    on(ui.redo, "click", () => this.redo());
    on(ui.isolate, "click", () => this.isolate());
    on(ui.hide, "click", () => this.hide());
    on(ui.showAll, "click", () => this.showAll());
    on(ui.deselect, "click", () => this.select(undefined));
    on(ui.saveLabels, "click", () => this.saveLabels());
    on(ui.saveglb, "click", () => this.saveGlb());
    on(ui.savePicture, "click", () => this.savePicture());
    on(ui.reset, "click", () => this.scene.resetCamera());
    on(this.element.querySelector("form"), "submit", event => event.preventDefault());
    this.listenToStrip(on);
    this.listenToStage(on);
    on(this.scene.canvas, "keydown", event => this.press(event));
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
        this.take(this.scene.pick(event.clientX, event.clientY), event.shiftKey);
      start = undefined;
    });
  }

  press(event) {
    if (event.ctrlKey || event.metaKey || event.altKey)
      return;
    const { ui } = this;
    const toggle = part => part.click();
    const turn = (sideways, upwards, factor = 1) =>
      this.scene.turn(sideways * Math.PI / 12, upwards * Math.PI / 12, factor);
    const actions = {
      ArrowLeft: () => turn(-1, 0),
      ArrowRight: () => turn(1, 0),
      ArrowUp: () => turn(0, 1),
      ArrowDown: () => turn(0, -1),
      "+": () => turn(0, 0, 0.8),
      "-": () => turn(0, 0, 1.25),
      PageDown: () => this.setNumber(this.number - 1),
      PageUp: () => this.setNumber(this.number + 1),
      n: () => this.selectNext(event.shiftKey ? -1 : 1),
      m: () => this.startMerge(),
      c: () => this.cut(),
      u: () => this.undo(),
      y: () => this.redo(),
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
      g: () => this.saveGlb(),
      p: () => this.savePicture(),
      Escape: () => this.select(undefined)
    };
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (!Object.hasOwn(actions, key))
      return;
    event.preventDefault();
    actions[key]();
  }

  // Shows a text to screen readers.
  say(text) { this.ui.said.textContent = text; }

  // The state with the first cuts of the hierarchy. A segment is a node; after edits the nodes only
  // are its numbers, which have names and colors.
  stateOf(number) {
    const { roots, most } = this.hierarchy;
    const n = Math.min(Math.max(number, roots), most);
    return { number: n, segmentOfPiece: this.hierarchy.segmentOfPiece(n), isEdited: false,
             names: this.names };
  }

  setNumber(number) {
    const state = this.stateOf(number);
    if (this.isEdited) // which can be undone
      this.change(state);
    else
      this.apply(state);
    this.say(`${count(this.number, "segment")}. ${this.ui.cutText.textContent}`);
  }

  change(state) {
    const { number, segmentOfPiece, isEdited, names } = this;
    this.past.push({ number, segmentOfPiece, isEdited, names });
    this.future = [];
    this.apply(state);
  }

  edit(segmentOfPiece, names = this.names) {
    this.change({ number: new Set(segmentOfPiece).size, segmentOfPiece, isEdited: true, names });
  }

  // Goes from a list of states to the last one of another list.
  travel(from, to, text) {
    const { number, segmentOfPiece, isEdited, names } = this;
    if (from.length === 0)
      return;
    to.push({ number, segmentOfPiece, isEdited, names });
    this.apply(from.pop());
    this.say(`${text}. ${count(this.number, "segment")}.`);
  }

  undo() { this.travel(this.past, this.future, "Undone"); }
  redo() { this.travel(this.future, this.past, "Redone"); }

  apply(state) {
    const { hierarchy, ui } = this;
    if (state.segmentOfPiece !== this.segmentOfPiece && !state.isEdited)
      this.isHidden.fill(0); // a segment is hidden as a whole or not at all
    Object.assign(this, state);
    this.merged = undefined;
    this.labels = this.isEdited
      ? new Map(hierarchy.order(this.segmentOfPiece).map((segment, label) => [segment, label]))
      : labelOfSegment(hierarchy, this.number, this.model.exceptions);
    ui.slider.value = ui.number.value = this.number;
    ui.fewer.disabled = this.number <= hierarchy.roots;
    ui.more.disabled = this.number >= hierarchy.most;
    ui.undo.disabled = this.past.length === 0;
    ui.redo.disabled = this.future.length === 0;
    const last = this.number - hierarchy.roots - 1;
    [...ui.strip.children].forEach((bar, i) => {
      bar.setAttribute("class", i < last ? "made" : i === last ? "made last" : "");
    });
    const suggestion = this.number === this.model.segments ? "" :
      ` ${this.model.segments} segments are suggested.`;
    ui.cutText.textContent = (this.isEdited ? "Edited by hand." : last < 0 ? "No cut." :
                              `Last cut: ${this.cutText(last)}.`) + suggestion;
    this.show();
  }

  // The pieces of the segment of a piece.
  piecesWith(piece) {
    return [...this.segmentOfPiece.keys()]
      .filter(other => this.segmentOfPiece[other] === this.segmentOfPiece[piece]);
  }

  nameOf(segment) { return this.names.get(segment) ?? `Segment ${this.labels.get(segment)}`; }

  area(pieces) {
    const { areas, leaves } = this.hierarchy;
    return pieces.reduce((sum, piece) => sum + areas[leaves[piece]], 0);
  }

  select(piece) {
    this.selected = piece;
    if (piece === undefined)
      this.merged = undefined;
    this.show();
    this.say(piece === undefined ? "No segment is selected." :
      `${this.nameOf(this.segmentOfPiece[piece])}, ${this.ui.partText.textContent}`);
  }

  // Selects the segment of a piece, or merges it with the one that waits for it.
  take(piece, isToMerge = false) {
    const other = this.merged ?? (isToMerge ? this.selected : undefined);
    if (other !== undefined && piece !== undefined)
      this.merge(other, piece);
    else
      this.select(piece);
  }

  // Selects the segment of the next label, or the previous one for the step -1.
  selectNext(step) {
    const segments = this.hierarchy.order(this.segmentOfPiece).filter(segment =>
      this.segmentOfPiece.some((other, piece) => other === segment && !this.isHidden[piece]));
    if (segments.length === 0) // all are hidden
      return;
    const i = segments.indexOf(this.segmentOfPiece[this.selected]);
    const next = segments.at(i < 0 ? (step > 0 ? 0 : -1) : (i + step) % segments.length);
    this.select(this.segmentOfPiece.indexOf(next));
  }

  // The first call takes the selected segment, the second one merges it with that selected then.
  startMerge() {
    if (this.selected === undefined)
      return;
    if (this.merged !== undefined) {
      this.merge(this.merged, this.selected);
      return;
    }
    this.merged = this.selected;
    this.show();
    this.say(this.ui.partText.textContent);
  }

  // Merges two segments. The larger one keeps its name and color.
  merge(a, b) {
    this.merged = undefined;
    const sides = [a, b].map(piece => this.piecesWith(piece));
    const [kept, other] = (this.area(sides[0]) < this.area(sides[1]) ? [b, a] : [a, b])
      .map(piece => this.segmentOfPiece[piece]);
    this.selected = b;
    if (kept === other) {
      this.select(b);
      return;
    }
    const names = new Map(this.names);
    if (!names.has(kept) && names.has(other))
      names.set(kept, names.get(other));
    names.delete(other);
    this.edit(this.segmentOfPiece.map(segment => segment === other ? kept : segment), names);
    this.say(`Merged. ${count(this.number, "segment")}.`);
  }

  // Cuts the selected segment where the hierarchy cuts it next.
  cut() {
    const sides = this.selected !== undefined &&
                  this.hierarchy.split(this.piecesWith(this.selected));
    if (!sides)
      return;
    const used = new Set(this.segmentOfPiece);
    const usedColors = new Set([...used].map(segment => this.colors[segment].join()));
    const free = [sides.node, ...this.colors.keys()].filter(node => !used.has(node));
    const segment = free.find(node => !usedColors.has(this.colors[node].join())) ?? free[0];
    const names = new Map(this.names);
    names.delete(segment);
    this.edit(this.segmentOfPiece.map((old, piece) =>
      sides.cut.includes(piece) ? segment : old), names);
    this.say(`Cut. ${count(this.number, "segment")}.`);
  }

  rename(text) {
    if (this.selected === undefined)
      return;
    const segment = this.segmentOfPiece[this.selected];
    const names = new Map(this.names);
    if (text.trim())
      names.set(segment, text.trim());
    else
      names.delete(segment);
    const { number, segmentOfPiece, isEdited } = this;
    this.change({ number, segmentOfPiece, isEdited, names });
    this.say(`The segment is named ${this.nameOf(segment)}.`);
  }

  isolate() {
    if (this.selected === undefined)
      return;
    this.isHidden.fill(1);
    for (const piece of this.piecesWith(this.selected))
      this.isHidden[piece] = 0;
    this.show();
    this.say(this.ui.hiddenText.textContent);
  }

  hide() {
    if (this.selected === undefined)
      return;
    for (const piece of this.piecesWith(this.selected))
      this.isHidden[piece] = 1;
    this.select(undefined);
    this.say(this.ui.hiddenText.textContent);
  }

  showAll() {
    this.isHidden.fill(0);
    this.show();
    this.say("All segments are shown.");
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
    const { ui, selected } = this;
    ui.card.hidden = selected === undefined;
    if (selected === undefined)
      return;
    const node = this.segmentOfPiece[selected];
    const pieces = this.piecesWith(selected);
    const isIn = new Uint8Array(this.isHidden.length);
    for (const piece of pieces)
      isIn[piece] = 1;
    const faces = this.model.pieceOfFace.reduce((sum, piece) => sum + isIn[piece], 0);
    const area = this.area([...this.segmentOfPiece.keys()]);
    ui.swatch.style.background = `rgb(${this.colors[node].map(x => Math.round(255 * x))})`;
    ui.partName.value = this.names.get(node) ?? "";
    ui.partName.placeholder = `Segment ${this.labels.get(node)}`;
    ui.partName.setAttribute("aria-label", `Name of segment ${this.labels.get(node)}`);
    ui.merge.setAttribute("aria-pressed", this.merged !== undefined);
    ui.cut.disabled = pieces.length === 1;
    ui.partText.textContent = this.merged === selected
      ? "Choose the segment to merge it with." : `${count(faces, "face")}, ` +
        `${percent(area > 0 ? this.area(pieces) / area : 0)} of the area`;
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
    const labelOfPiece = this.segmentOfPiece.map(segment => this.labels.get(segment));
    const labels = this.isEdited ? this.model.pieceOfFace.map(piece => labelOfPiece[piece]) :
      faceLabels(this.hierarchy, this.number, this.model.pieceOfFace, this.model.exceptions);
    return labels.join("\n") + "\n";
  }

  fileName(ending) {
    const stem = this.model.name.replace(/^.*[\\/]/, "").replace(/\.[^.]*$/, "");
    return `${stem || "mesh"}_${this.number}${ending}`;
  }

  saveLabels() {
    save(new Blob([this.labelText()], { type: "text/plain" }), this.fileName(".seg"));
    const names = [...this.labels].filter(([segment]) => this.names.has(segment))
      .map(([segment, label]) => [label, this.names.get(segment)]);
    if (names.length > 0)
      save(new Blob([JSON.stringify(Object.fromEntries(names), undefined, 2) + "\n"],
                    { type: "application/json" }), this.fileName("_names.json"));
  }

  // Edits and names are only in a file of the mesh shown.
  async saveGlb() {
    const { model, segmentOfPiece } = this;
    const segments = [...this.labels].sort(([, a], [, b]) => a - b).map(([segment]) =>
      ({ segment, name: this.nameOf(segment), color: this.colors[segment] }));
    const hasOwn = this.isEdited || segments.some(({ segment }) => this.names.has(segment));
    const blob = model.glb && !hasOwn ? await model.glb(this.number)
                                      : glbOf(model.mesh, segmentOfPiece, segments);
    if (blob)
      save(blob, this.fileName(".glb"));
  }

  savePicture() { this.scene.picture(blob => save(blob, this.fileName(".png"))); }

  dispose() {
    this.listeners.abort();
    this.scene.dispose();
    this.element.replaceChildren();
  }
}
