// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh segmentation in this thread, for Node. index.d.ts documents it.

import { webcrypto } from "node:crypto";
import { readFile } from "node:fs/promises";

import { start } from "./api.js";

// The keys of hash tables are random; Node 18 has this only as a module.
globalThis.crypto ??= webcrypto;

export async function load({ wasmUrl = new URL("./module.wasm", import.meta.url) } = {}) {
  return start({ wasmBinary: await readFile(new URL(wasmUrl)) });
}
