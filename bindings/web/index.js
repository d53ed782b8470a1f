// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Mesh segmentation in this thread, for browsers. index.d.ts documents it.

import { start } from "./api.js";

// Bundlers find the file by this expression.
const defaultUrl = () => new URL("./module.wasm", import.meta.url);

export async function load({ wasmUrl = defaultUrl() } = {}) {
  try {
    return await start({ locateFile: () => String(wasmUrl) });
  }
  catch (error) {
    throw new Error(`module.wasm cannot be loaded from ${wasmUrl}: ${error.message}`);
  }
}
