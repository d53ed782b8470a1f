# Copyright (c) 2026  The Spectral_segmentation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A server of a folder for tests in a browser."""

import functools
import http.server
import threading


class Handler(http.server.SimpleHTTPRequestHandler):
    """Remembers the requests."""

    requests = []
    extensions_map = {**http.server.SimpleHTTPRequestHandler.extensions_map,
                      ".js": "text/javascript", ".wasm": "application/wasm"}

    def log_message(self, *_):
        self.requests.append((self.command, self.path))


def start_server(folder, add_cleanup):
    """Serves a folder, on a port of the server's choice, until the test's clean-up."""
    server = http.server.ThreadingHTTPServer(
        ("127.0.0.1", 0), functools.partial(Handler, directory=folder))
    add_cleanup(server.server_close)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    add_cleanup(server.shutdown)
    return server
