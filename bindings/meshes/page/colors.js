// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Colors of the nodes of a hierarchy, as [red, green, blue] from 0 to 1. The larger child of a cut
// keeps the color of its parent. The smaller one gets the color that is most unlike those around it
// for all people: for those whose cones are complete, and those who lack one kind.

// The colors seen without one kind of cones, on linear RGB: Machado, Oliveira, Fernandes, "A
// Physiologically-based Model for Simulation of Color Vision Deficiency", 2009.
const visions = [
  [[1, 0, 0], [0, 1, 0], [0, 0, 1]],
  [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216],
   [-0.003882, -0.048116, 1.051998]],
  [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413],
   [-0.011820, 0.042940, 0.968881]],
  [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602],
   [0.004733, 0.691367, 0.303900]]];

const product = (matrix, v) => matrix.map(row => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);

// OKLab: distances are differences for the eye.
const toCones = [[0.4122214708, 0.5363325363, 0.0514459929],
                 [0.2119034982, 0.6806995451, 0.1073969566],
                 [0.0883024619, 0.2817188376, 0.6299787005]];
const toLab = [[0.2104542553, 0.7936177850, -0.0040720468],
               [1.9779984951, -2.4285922050, 0.4505937099],
               [0.0259040371, 0.7827717662, -0.8086757660]];
const fromLab = [[1, 0.3963377774, 0.2158037573],
                 [1, -0.1055613458, -0.0638541728],
                 [1, -0.0894841775, -1.2914855480]];
const fromCones = [[4.0767416621, -3.3077115913, 0.2309699292],
                   [-1.2684380046, 2.6097574011, -0.3413193965],
                   [-0.0041960863, -0.7034186147, 1.7076147010]];

const labOfLinear = rgb => product(toLab, product(toCones, rgb).map(Math.cbrt));
const linearOfLab = lab => product(fromCones, product(fromLab, lab).map(x => x ** 3));
const encoded = x => x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;
export const decoded = x => x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;

// A color with what each kind of people sees of it.
function seen(rgb) {
  const linear = rgb.map(decoded);
  const lab = visions.map(m => labOfLinear(product(m, linear).map(x => Math.max(x, 0))));
  return { rgb, lab };
}

const distance = (p, q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);

// The smallest difference of two colors among all people, and a quarter of that for most people.
function difference(a, b) {
  const distances = a.lab.map((p, i) => distance(p, b.lab[i]));
  return Math.min(...distances) + distances[0] / 4;
}

// Neither so dark that shading cannot be seen, nor as light as paper.
function candidates() {
  const result = [];
  for (const lightness of [0.46, 0.55, 0.64, 0.73, 0.82, 0.91])
    for (const chroma of [0.03, 0.09, 0.14, 0.19])
      for (let step = 0; step < 24; ++step) {
        const hue = 2 * Math.PI * step / 24;
        const linear = linearOfLab([lightness, chroma * Math.cos(hue), chroma * Math.sin(hue)]);
        if (linear.every(x => x >= 0 && x <= 1))
          result.push(seen(linear.map(x => Math.round(255 * encoded(x)) / 255)));
      }
  return result;
}

// neighbors: for each piece the set of those that it touches.
export function nodeColors(hierarchy, neighbors) {
  const choices = candidates();
  const nearest = new Float64Array(choices.length).fill(Infinity); // to all colors that are used
  const colors = new Array(hierarchy.size);
  const [blue] = seen([0.38, 0.62, 0.88]).lab;
  const first = choices.reduce((best, color, i) =>
    distance(color.lab[0], blue) < distance(choices[best].lab[0], blue) ? i : best, 0);

  function choose(touching) {
    if (nearest.every(distance => distance === 0)) // all are used: a second round
      nearest.fill(Infinity);
    let best = first, largest = -1;
    choices.forEach((color, i) => {
      let value = nearest[i];
      for (const other of touching)
        value = Math.min(value, 0.7 * difference(color, other)); // touching ones differ more
      if (value < Infinity && value > largest) {
        largest = value;
        best = i;
      }
    });
    choices.forEach((color, i) => {
      nearest[i] = Math.min(nearest[i], difference(color, choices[best]));
    });
    return choices[best];
  }

  for (let root = 0; root < hierarchy.roots; ++root)
    colors[root] = choose([]);
  hierarchy.cutNodes.forEach((node, i) => {
    const smaller = hierarchy.roots + 2 * i;
    colors[smaller + 1] = colors[node];
    const segments = hierarchy.segmentOfPiece(hierarchy.roots + i + 1);
    const touching = new Set();
    segments.forEach((segment, piece) => {
      if (segment === smaller)
        neighbors[piece].forEach(other => {
          if (segments[other] !== smaller)
            touching.add(colors[segments[other]]);
        });
    });
    colors[smaller] = choose([...touching]);
  });
  return colors.map(color => color.rgb);
}
