// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef SEGMENT_MESH_IS_TERMINAL_H
#define SEGMENT_MESH_IS_TERMINAL_H

#include <cstdio>

#ifdef _WIN32
#include <io.h>
#else
#include <unistd.h>
#endif

namespace segment_mesh {

// Returns whether a person sees standard error, and no file receives it.
inline bool standard_error_is_terminal()
{
#ifdef _WIN32
  return _isatty(_fileno(stderr)) != 0;
#else
  return isatty(STDERR_FILENO) != 0;
#endif
}

} // namespace segment_mesh

#endif // SEGMENT_MESH_IS_TERMINAL_H
