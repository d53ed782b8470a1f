// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The worker behind worker_client_node.js.

import { parentPort } from "node:worker_threads";

import { load } from "./index_node.js";
import { answerer } from "./worker_actions.js";

parentPort.on("message", answerer(load, parentPort.postMessage.bind(parentPort)));
