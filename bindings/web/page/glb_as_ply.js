// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The triangles of a file of GLB or glTF as a file of PLY, whose reader joins repeated points.

function loadScript(name) {
  return new Promise((resolve, reject) => {
    const script = document.createElement("script");
    script.src = new URL(name, import.meta.url);
    script.onload = resolve;
    script.onerror = () => reject(new Error(`${name} cannot be loaded`));
    document.head.append(script);
  });
}

// All meshes, where their nodes put them.
function collect(scene) {
  const { THREE } = globalThis;
  const points = [], triangles = [];
  scene.updateMatrixWorld(true);
  scene.traverse(node => {
    const position = node.isMesh && node.geometry.attributes.position;
    if (!position)
      return;
    const first = points.length / 3;
    const point = new THREE.Vector3();
    for (let i = 0; i < position.count; ++i) {
      point.fromBufferAttribute(position, i).applyMatrix4(node.matrixWorld);
      points.push(point.x, point.y, point.z);
    }
    const { index } = node.geometry;
    const size = index ? index.count : position.count;
    for (let i = 0; i + 2 < size; i += 3)
      for (let k = i; k < i + 3; ++k)
        triangles.push(first + (index ? index.getX(k) : k));
  });
  return { points, triangles };
}

function plyOf({ points, triangles }) {
  const header = new TextEncoder().encode(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${points.length / 3}\n` +
    "property float x\nproperty float y\nproperty float z\n" +
    `element face ${triangles.length / 3}\nproperty list uchar uint vertex_indices\nend_header\n`);
  const result = new Uint8Array(header.length + 4 * points.length + 13 * triangles.length / 3);
  result.set(header);
  const view = new DataView(result.buffer);
  let at = header.length;
  for (const x of points) {
    view.setFloat32(at, x, true);
    at += 4;
  }
  for (let i = 0; i < triangles.length; i += 3) {
    view.setUint8(at, 3);
    for (let k = 0; k < 3; ++k)
      view.setUint32(at + 1 + 4 * k, triangles[i + k], true);
    at += 13;
  }
  return result;
}

export async function glbAsPly(bytes) {
  if (!globalThis.THREE.GLTFLoader)
    await loadScript("GLTFLoader.js");
  const { buffer } = bytes;
  const file = await new Promise((resolve, reject) =>
    new globalThis.THREE.GLTFLoader().parse(buffer, "", resolve, reject));
  return plyOf(collect(file.scene));
}
