// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_PREFETCH_H
#define CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_PREFETCH_H

namespace CGAL::Spectral_segmentation::internal {

// Requests memory that will be read soon, if the compiler has a way to. Otherwise, loops that visit
// faces in a special order wait for memory half of the time.
inline void prefetch(const void* address)
{
#ifdef __GNUC__
  __builtin_prefetch(address);
#else
  static_cast<void>(address);
#endif
}

} // namespace CGAL::Spectral_segmentation::internal

#endif // CGAL_SPECTRAL_SEGMENTATION_INTERNAL_BASE_PREFETCH_H
