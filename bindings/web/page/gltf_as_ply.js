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

const compressions = ["KHR_draco_mesh_compression", "EXT_meshopt_compression",
                      "KHR_mesh_quantization"];

function parsed(bytes) {
  try {
    return JSON.parse(new TextDecoder().decode(bytes));
  }
  catch {
    throw new Error("its text is no JSON, so it is damaged or no glTF");
  }
}

// Removes all but the shape, because the rest would only be fetched and decoded in vain. Returns
// whether there were textures.
function keepShape(json) {
  if (!json?.meshes?.length)
    throw new Error("it has no mesh");
  const compression = compressions.find(name => json.extensionsRequired?.includes(name));
  if (compression)
    throw new Error(`it is compressed by ${compression}, which is not read here`);
  if (json.nodes?.some(({ extensions }) => extensions?.EXT_mesh_gpu_instancing))
    throw new Error("its nodes have instances of EXT_mesh_gpu_instancing, which are not read here");
  const { uri } = json.buffers?.find(({ uri }) => uri && !uri.startsWith("data:")) ?? {};
  if (uri)
    throw new Error(`its points are in another file, ${uri}: save it as GLB, which is one file`);
  const hasTextures = json.images?.length > 0;
  for (const name of ["animations", "cameras", "extensions", "extensionsRequired",
                      "extensionsUsed", "images", "materials", "samplers", "skins", "textures"])
    delete json[name];
  json.meshes = json.meshes?.map(({ primitives }) => ({
    primitives: primitives.map(({ attributes, indices, mode }) =>
      ({ attributes: { POSITION: attributes.POSITION }, indices, mode })) }));
  json.nodes = json.nodes?.map(({ camera, extensions, skin, ...node }) => node);
  for (const { nodes, children } of [...json.scenes ?? [], ...json.nodes ?? []])
    (nodes ?? children)?.forEach((node, i) => { json.nodes[node].extras = { position: i }; });
  return hasTextures;
}

const isGlb = bytes => new TextDecoder().decode(bytes.subarray(0, 4)) === "glTF";

// Returns the same file, with nothing but the shape, and whether there were textures.
function shapeOf(bytes) {
  if (!isGlb(bytes)) {
    const json = parsed(bytes);
    const hasTextures = keepShape(json);
    return { shape: new TextEncoder().encode(JSON.stringify(json)).buffer, hasTextures };
  }
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (bytes.length < 20 || view.getUint32(8, true) > bytes.length ||
      20 + view.getUint32(12, true) > bytes.length)
    throw new Error(`it ends after ${bytes.length} bytes, within its data`);
  const end = 20 + view.getUint32(12, true); // of the JSON
  const json = parsed(bytes.subarray(20, end));
  const hasTextures = keepShape(json);
  const text = new TextEncoder().encode(JSON.stringify(json) + " ".repeat(3)); // room to align
  const size = text.length - text.length % 4;
  const result = new Uint8Array(20 + size + bytes.length - end);
  result.set(bytes.subarray(0, 20));
  result.set(text.subarray(0, size), 20);
  result.set(bytes.subarray(end), 20 + size);
  new DataView(result.buffer).setUint32(8, result.length, true);
  new DataView(result.buffer).setUint32(12, size, true);
  return { shape: result.buffer, hasTextures };
}

// The loader adds nodes in any order.
const position = node => node.userData.position ?? -1; // a mesh of this node is before its children

// The triangles of a node and of those below it, in the order of the file.
function collect(node, { points, triangles }) {
  const positions = node.isMesh && node.geometry.attributes.position;
  if (positions) {
    const first = points.length / 3;
    const point = new globalThis.THREE.Vector3();
    for (let i = 0; i < positions.count; ++i) {
      point.fromBufferAttribute(positions, i).applyMatrix4(node.matrixWorld);
      points.push(point.x, point.y, point.z);
    }
    const { index } = node.geometry;
    const size = index ? index.count : positions.count;
    const turns = node.matrixWorld.determinant() < 0 ? [0, 2, 1] : [0, 1, 2]; // if it is mirrored
    for (let i = 0; i + 2 < size; i += 3)
      for (const k of turns)
        triangles.push(first + (index ? index.getX(i + k) : i + k));
  }
  for (const child of [...node.children].sort((a, b) => position(a) - position(b)))
    collect(child, { points, triangles });
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

// Returns the bytes of a file of PLY, and whether there were textures.
export async function gltfAsPly(bytes) {
  if (!globalThis.THREE.GLTFLoader)
    await loadScript("GLTFLoader.js");
  const { shape, hasTextures } = shapeOf(bytes);
  const file = await new Promise((resolve, reject) =>
    new globalThis.THREE.GLTFLoader().parse(shape, "", resolve, reject)).catch(({ message }) => {
    throw new Error(`its data contradict each other: ${message}`);
  });
  file.scene.updateMatrixWorld(true);
  const mesh = { points: [], triangles: [] };
  collect(file.scene, mesh);
  return { bytes: plyOf(mesh), hasTextures };
}
