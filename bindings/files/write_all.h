// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_WRITE_ALL_H
#define SEGMENT_MESH_WRITE_ALL_H

#include <cerrno>
#include <cstddef>
#include <cstdlib>

#include <sys/types.h>
#include <unistd.h>

namespace segment_mesh {

// Writes bytes to a pipe. Runs in a child process, which ends if nobody reads them.
inline void write_all(int descriptor, const void* data, std::size_t size)
{
  for (const char* bytes = static_cast<const char*>(data); size > 0;) {
    const ssize_t written = write(descriptor, bytes, size);
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0)
      _exit(EXIT_FAILURE);
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_WRITE_ALL_H
