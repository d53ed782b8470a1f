// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The worker behind worker_client.js.

import { load } from "./index.js";
import { answerer } from "./worker_actions.js";

const answer = answerer(load, self.postMessage.bind(self));
self.onmessage = event => answer(event.data);
