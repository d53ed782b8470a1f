// Copyright (c) 2026  The Spectral_segmentation authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// A program may include the header in several files, and after others: this one of Boost declares
// functions that hide those that Boost's union-find needs for plain pointers.
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <CGAL/segment_spectral_recursive.h>
